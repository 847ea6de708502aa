"""Two hundred people who drag a slider: each asks for pull, shape and curve at a pressure that changes, one answer after the other.

    python3 checks/server_load.py [PROGRAM] [--sessions 200] [--seconds 30]

Prints requests a second, the time to an answer, answers by status, and the memory of the server. Any 5xx but 503 (full: ask again) is a failure.
"""

import argparse
import asyncio
import json
import random
import subprocess
import sys
import time
from collections import Counter

arguments = argparse.ArgumentParser()
arguments.add_argument("program", nargs="?", default="target/release/mckibben")
arguments.add_argument("--sessions", type=int, default=200)
arguments.add_argument("--seconds", type=float, default=30)
asked = arguments.parse_args()


def memory_mb(process):
    with open(f"/proc/{process.pid}/status") as status:
        return next(
            int(line.split()[1]) / 1000 for line in status if line.startswith("VmRSS")
        )


async def answer(reader):
    """Status of the next answer; its body is read and left."""
    status = int((await reader.readline()).split()[1])
    length = 0
    while (line := await reader.readline()) != b"\r\n":
        name, value = line.decode().split(":", 1)
        length = int(value) if name == "content-length" else length
    await reader.readexactly(length)
    return status


async def session(port, end, times, counts):
    """One person, who asks again after 50 ms where the server is full."""
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    while time.monotonic() < end:
        pressure = round(random.uniform(0.05, 0.25), 4)
        at = {"pressure_mpa": pressure, "contraction": 0.1}
        for command, request in [
            ("force", at),
            ("shape", at),
            ("curve", {"test": "isobaric", "pressures_mpa": [pressure]}),
        ]:
            body = json.dumps(request).encode()
            head = f"POST /api/{command} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
            start = time.monotonic()
            writer.write(f"{head}Content-Length: {len(body)}\r\n\r\n".encode() + body)
            status = await answer(reader)
            counts[status] += 1
            if status == 503:
                await asyncio.sleep(0.05)
            else:
                times.append(time.monotonic() - start)
    writer.close()


async def all_sessions(port):
    times, counts = [], Counter()
    end = time.monotonic() + asked.seconds
    await asyncio.gather(
        *(session(port, end, times, counts) for _ in range(asked.sessions))
    )
    return sorted(times), counts


server = subprocess.Popen(
    [asked.program, "serve", "--port", "0"], stdout=subprocess.PIPE, text=True
)
try:
    port = int(server.stdout.readline().rsplit(":", 1)[1])
    before = memory_mb(server)
    times, counts = asyncio.run(all_sessions(port))
    after = memory_mb(server)
finally:
    server.terminate()
    code = server.wait(timeout=5)
part = lambda share: 1e3 * times[int(share * (len(times) - 1))]
print(
    f"{asked.sessions} sessions: {len(times) / asked.seconds:.0f} answers a second",
    end=", ",
)
print(f"p50 {part(0.5):.0f} ms, p95 {part(0.95):.0f} ms, worst {part(1):.0f} ms")
print("by status:", dict(sorted(counts.items())))
print(f"memory {before:.0f} MB before, {after:.0f} MB after; ended with {code}")
sys.exit(code != 0 or any(status >= 500 and status != 503 for status in counts))
