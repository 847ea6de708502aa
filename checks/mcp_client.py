#!/usr/bin/env python3
"""`mckibben mcp` with the official Python client (PyPI `mcp`): every tool, figures, resources, problems, cancellation, the folder.

    python3 checks/mcp_client.py PROGRAM
"""

import asyncio
import base64
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from mcp.client import Client
from mcp.client.stdio import StdioServerParameters

PROGRAM = str(Path(sys.argv[1]).resolve())
ROOT = Path(__file__).resolve().parent.parent
MUSCLE = {"muscle": {"name": "prototype.toml", "text": (ROOT / "examples/prototype.toml").read_text("utf-8")}}


def command_line(*words):
    return json.loads(subprocess.run([PROGRAM, *words, "--format", "json"], check=True, capture_output=True, text=True, cwd=ROOT).stdout)


async def main(folder: Path) -> None:
    server = StdioServerParameters(command=PROGRAM, args=["mcp", "--folder", str(folder)])
    async with Client(server) as client:
        tools = {tool.name: tool for tool in (await client.list_tools()).tools}
        assert sorted(tools) == sorted(["design", "state", "curve", "identify", "compare", "parts", "joint", "export"]), tools

        async def ask(name, **arguments):
            # The client itself checks the answer against the schema of the tool.
            result = await client.call_tool(name, arguments)
            assert not result.is_error, result.content
            return result

        state = (await ask("state", **MUSCLE, pressure_mpa=0.2, contraction=0.1)).structured_content
        same = command_line("force", "examples/prototype.toml", "-p", "0.2", "-e", "0.1")
        assert state["force_n"] == same["force_n"] and state["uncertainty_n"] == same["uncertainty_n"], (state, same)
        found = await ask("design", force_n=700, contraction=0.15, max_pressure_mpa=0.25, figure="bar")
        assert found.structured_content["candidates"][0]["tube"]
        pictures = [part for part in found.content if part.type == "image"]
        assert base64.b64decode(pictures[0].data).startswith(b"\x89PNG") and "figure" not in found.structured_content
        curve = (await ask("curve", **MUSCLE, test="isobaric", pressures_mpa=[0.1, 0.2], contractions=[0.0, 0.1])).structured_content
        assert len(curve["points"]) == 4 or curve["points"], curve
        bench = {"name": "bench.csv", "text": (ROOT / "examples/bench.csv").read_text("utf-8")}
        muscle = {"muscle": {"name": "bench.toml", "text": (ROOT / "examples/bench.toml").read_text("utf-8")}}
        assert (await ask("identify", **muscle, data=[bench])).structured_content["parameters"]
        assert (await ask("compare", **MUSCLE, models=["fe", "ideal"])).structured_content["models"]
        assert (await ask("parts")).structured_content
        files = {name: (ROOT / "examples" / name).read_text("utf-8") for name in ("elbow.toml", "biceps.toml")}
        joint = {"name": "elbow.toml", "text": files["elbow.toml"]}
        asked = {"joint": joint, "muscles": [{"name": "biceps.toml", "text": files["biceps.toml"]}], "pressures_mpa": [[0.2, 0.1]], "angles_deg": [0.0]}
        assert (await ask("joint", **asked)).structured_content["points"]
        export = await ask("export", **MUSCLE, target="c", pressure_mpa=0.25, model="universal")
        written = [path for path in folder.rglob("*") if path.is_file()]
        assert sorted(path.name for path in written) == sorted(file["name"] for file in export.structured_content["files"]), written
        for path in written:
            of = next(file for file in export.structured_content["files"] if file["name"] == path.name)
            assert path.read_text("utf-8") == of["text"], path

        wrong = await client.call_tool("state", {"presure_mpa": 0.2})
        assert wrong.is_error and "pressure_mpa" in str(wrong.content), wrong
        outside = await client.call_tool("state", {**MUSCLE, "pressure_mpa": 0.2, "contraction": 0.1, "campaign": "x"})
        assert outside.is_error, outside

        resources = (await client.list_resources()).resources
        kinds = {str(resource.uri).split("/")[2] for resource in resources}
        assert kinds == {"help", "examples", "schema"}, kinds
        for resource in resources:
            text = (await client.read_resource(str(resource.uri))).contents[0].text
            assert text.strip(), resource.uri
        example = (await client.read_resource("mckibben://examples/prototype.toml")).contents[0].text
        assert example == MUSCLE["muscle"]["text"]
    print(f"mcp: {len(tools)} tools and {len(resources)} resources, as the command line answers")


def raw() -> None:
    """What no client sends: lines that are no messages are refused, and a cancelled question ends."""
    started = subprocess.Popen([PROGRAM, "mcp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8")
    long = {"name": "curve", "arguments": {"test": "isobaric", "pressures_mpa": [0.01 * i for i in range(1, 26)], "contractions": [0.001 * i for i in range(200)], "model": "fe3d"}}
    lines = ["not json", json.dumps({"id": 1}), json.dumps({"jsonrpc": "2.0", "id": 2, "method": "nothing"}), "[" * 100,
             json.dumps({"jsonrpc": "2.0", "id": 3, "method": "tools/call", "params": long}),
             json.dumps({"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 3}}),
             json.dumps({"jsonrpc": "2.0", "id": 4, "method": "ping"})]
    assert started.stdin and started.stdout
    for line in lines:
        started.stdin.write(f"{line}\n")
    started.stdin.flush()
    answers = [json.loads(started.stdout.readline()) for _ in range(6)]
    codes = [answer["error"]["code"] for answer in answers if "error" in answer]
    assert codes[:3] == [-32700, -32600, -32601], answers
    cancelled = next(answer for answer in answers if answer["id"] == 3)
    assert cancelled["result"]["isError"], cancelled
    assert next(answer for answer in answers if answer["id"] == 4)["result"] == {}
    started.stdin.close()
    assert started.wait(10) == 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        asyncio.run(main(Path(folder)))
    raw()
