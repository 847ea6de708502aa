(() => {
  "use strict";
  const panels = JSON.parse(document.getElementById("data").textContent);
  const svg = document.querySelector(".paper svg");
  const readout = document.getElementById("readout");
  const ring = document.createElementNS("http://www.w3.org/2000/svg", "circle");
  ring.setAttribute("r", "6");
  ring.setAttribute("fill", "none");
  ring.setAttribute("stroke-width", "1.6");
  ring.setAttribute("visibility", "hidden");
  ring.setAttribute("pointer-events", "none");
  svg.appendChild(ring);

  const place = (panel, [x, y]) => {
    const [px, py, pw, ph] = panel.plot;
    const part = (v, [low, high]) => (v - low) / (high - low);
    return [px + part(x, panel.x) * pw, py + ph - part(y, panel.y) * ph];
  };
  const inside = (panel, [x, y], by) => {
    const [px, py, pw, ph] = panel.plot;
    return x >= px - by && x <= px + pw + by && y >= py - by && y <= py + ph + by;
  };
  const nearest = (panel, at) => {
    let best = null;
    for (const series of panel.series) {
      for (const point of series.points) {
        const spot = place(panel, point);
        if (!inside(panel, spot, 0.5)) continue;
        const distance = Math.hypot(spot[0] - at[0], spot[1] - at[1]);
        if (!best || distance <= best.distance) best = { series, point, spot, distance };
      }
    }
    return best;
  };
  const show = (event) => {
    const matrix = svg.getScreenCTM();
    if (!matrix) return;
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    const at = [p.x, p.y];
    const panel = panels.find((candidate) => inside(candidate, at, 8));
    const found = panel && nearest(panel, at);
    if (!found) {
      ring.setAttribute("visibility", "hidden");
      return;
    }
    ring.setAttribute("cx", found.spot[0]);
    ring.setAttribute("cy", found.spot[1]);
    ring.setAttribute("stroke", found.series.colour);
    ring.setAttribute("visibility", "visible");
    const dot = document.createElement("i");
    dot.style.background = found.series.colour;
    const name = document.createElement("b");
    name.textContent = found.series.name;
    const values = `: ${panel.xl || "x"} = ${found.point[0]}, ${panel.yl || "y"} = ${found.point[1]}`;
    readout.replaceChildren(dot, name, values);
  };
  svg.addEventListener("pointermove", show);
  svg.addEventListener("pointerdown", show);
  svg.addEventListener("pointerleave", () => ring.setAttribute("visibility", "hidden"));
})();
