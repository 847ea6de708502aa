"""The muscle in a notebook: linked with Python both ways, in plain Python and in a browser."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

import pytest

import mckibben as mk

pytest.importorskip("anywidget")
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def test_sliders_are_linked_with_python_both_ways(thin: mk.Muscle) -> None:
    shown = mk.widget(thin, "2 bar", 0.05, measures=["wall_mm"])
    heard: list[float] = []
    shown.observe(lambda change: heard.append(change["new"]), "force_n")
    assert shown.force_n == thin.force(0.2, 0.05) and shown.muscle == thin and [s["name"] for s in shown._sliders] == ["pressure_mpa", "contraction", "wall_mm"]
    shown.pressure_mpa = 0.25
    assert heard == [thin.force(0.25, 0.05)] and shown._shown["words"].startswith(f"{heard[0]:.4g}")
    # What a browser sends.
    shown.set_state({"wall_mm": 2.0})
    assert shown.muscle == thin.replace(wall_mm=2) and heard[1:] == [thin.replace(wall_mm=2).force(0.25, 0.05)]
    assert set(shown.keys) >= {"pressure_mpa", "contraction", "wall_mm", "_shown", "_esm"} and "force_n" not in shown.keys
    assert len(json.dumps(shown._shown)) < 100_000 and shown.shape.pressure_mpa == 0.25


def test_what_cannot_be_is_said_and_the_last_picture_stays(thin: mk.Muscle) -> None:
    shown = mk.widget(thin)
    pull, picture = shown.force_n, shown._shown["shape"]
    shown.wall_mm = 40.0
    assert "wall" in shown.problem and "wall" in shown._shown["words"] and shown.force_n == pull and shown._shown["shape"] == picture
    shown.wall_mm = 1.0
    assert not shown.problem and shown._shown["shape"] == picture
    shown.contraction = 0.5
    assert shown.force_n == 0 and "slack" in shown._shown["words"] and shown._shown["contraction"] < 0.5
    wrongs: list[dict[str, Any]] = [{"measures": ["wal_mm"]}, {"measures": ["grip_mm"]}, {"pressure_mpa": -0.1}]
    for wrong in wrongs:
        with pytest.raises(mk.MckibbenError):
            mk.widget(thin, **wrong)
    assert mk.widget(thin, measures={"wall_mm": (0.5, 4.0)})._sliders[2]["high"] == 4.0


def test_there_is_a_picture_where_no_widget_is_shown(thin: mk.Muscle) -> None:
    """The length between the terminals is L0 (1 − ε)."""
    picture = mk.widget(thin, 0.2, 0.1)._repr_mimebundle_()[0]["image/svg+xml"]
    xs = [float(x) for x in re.findall(r"([-\d.]+),[-\d.]+", picture)]
    assert max(xs) - min(xs) == pytest.approx(285 * 0.9, rel=0.01) and picture == thin.shape(0.2, 0.1).to_svg()


# A front end as anywidget describes it: a model with get, set, save_changes, on and off; `render` gets it with an element.
PAGE = """<!DOCTYPE html><div id="w"></div><pre id="out"></pre><script type="module">
import widget from "/widget.js";
const listeners = {}, changed = {};
let state = await (await fetch("/state")).json(), flying = Promise.resolve();
const set = (name, value) => {
  if (JSON.stringify(state[name]) === JSON.stringify(value)) return;
  state[name] = value;
  (listeners[`change:${name}`] ?? []).forEach((act) => act());
};
const send = (body) => flying = flying.then(async () => {
  const now = await (await fetch("/state", { method: "POST", body: JSON.stringify(body) })).json();
  Object.entries(now).forEach(([name, value]) => set(name, value));
});
const model = {
  get: (name) => state[name], set(name, value) { changed[name] = value; set(name, value); },
  save_changes() { send({ browser: { ...changed } }); Object.keys(changed).forEach((name) => delete changed[name]); },
  on: (event, act) => (listeners[event] ??= []).push(act),
  off: (event, act) => { listeners[event] = listeners[event].filter((other) => other !== act); },
};
const root = document.querySelector("#w"), out = [];
const end = await widget.render({ model, el: root });
const slider = (name) => root.querySelector(`input[name=${name}]`);
const look = async () => {
  await flying;
  await new Promise((done) => setTimeout(done, 300));
  const picture = root.querySelector("canvas, svg.section");
  listeners["change:_shown"].forEach((act) => act());
  out.push({ says: root.querySelector(".say").textContent, sliders: Object.fromEntries([...root.querySelectorAll("input")].map((s) => [s.name, Number(s.value)])),
    kind: picture?.tagName, picture: picture?.toDataURL ? picture.toDataURL() : root.querySelector("svg.section")?.outerHTML });
};
await look();
slider("pressure_mpa").value = 0.3;
slider("pressure_mpa").dispatchEvent(new Event("input"));
await look();
await send({ python: { wall_mm: 2, contraction: 0.1 } });
await look();
end();
out.push(Object.values(listeners).flat().length);
document.querySelector("#out").textContent = JSON.stringify(out);
</script>"""


@pytest.fixture
def page(thin: mk.Muscle) -> Iterator[tuple[Any, str]]:
    """A widget behind the page above, and its address."""
    shown = mk.widget(thin, measures=["wall_mm"])

    class Handler(BaseHTTPRequestHandler):
        def answer(self, text: str, kind: str) -> None:
            self.send_response(200)
            self.send_header("content-type", kind)
            self.end_headers()
            self.wfile.write(text.encode())

        def state(self) -> None:
            self.answer(json.dumps({name: value for name, value in shown.get_state().items() if name in ("pressure_mpa", "contraction", "wall_mm", "_sliders", "_shown")}), "application/json")

        def do_GET(self) -> None:
            pages = {"/": (PAGE, "text/html; charset=utf-8"), "/widget.js": (str(shown._esm), "text/javascript; charset=utf-8")}
            self.answer(*pages[self.path]) if self.path in pages else self.state()

        def do_POST(self) -> None:
            asked = json.loads(self.rfile.read(int(self.headers["content-length"])))
            shown.set_state(asked.get("browser", {}))
            for name, value in asked.get("python", {}).items():
                setattr(shown, name, value)
            self.state()

        def log_message(self, *_: Any) -> None:
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield shown, f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium")
@pytest.mark.parametrize("flags, kind", [(["--enable-unsafe-swiftshader"], "CANVAS"), (["--disable-3d-apis"], "svg")])
def test_a_browser_shows_it_and_moves_it(flags: list[str], kind: str, page: tuple[Any, str], thin: mk.Muscle) -> None:
    shown, address = page
    # The page waits for a second of virtual time, and every frame of it is drawn.
    done = subprocess.run([str(CHROMIUM), "--headless=new", "--no-sandbox", "--disable-gpu", *flags, "--virtual-time-budget=3000", "--window-size=500,400", "--dump-dom", address], capture_output=True, text=True, timeout=120)
    found = re.search(r'<pre id="out">(\[.*?\])</pre>', done.stdout, flags=re.DOTALL)
    assert found, done.stdout[-2000:] + done.stderr[-2000:]
    first, pressed, thicker, left = json.loads(found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
    thick = thin.replace(wall_mm=2)
    for look, pull, sliders in ((first, thin.force(0.2, 0), (0.2, 0, 1)), (pressed, thin.force(0.3, 0), (0.3, 0, 1)), (thicker, thick.force(0.3, 0.1), (0.3, 0.1, 2))):
        assert look["says"].startswith(f"{pull:.4g}") and tuple(look["sliders"].values()) == sliders and look["kind"] == kind, look["says"]
    assert len({look["picture"] for look in (first, pressed, thicker)}) == 3 and left == 0
    assert shown.pressure_mpa == 0.3 and shown.muscle == thick
