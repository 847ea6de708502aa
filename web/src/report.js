for (const box of document.querySelectorAll(".body")) {
  const shape = JSON.parse(box.querySelector("script").textContent);
  box.classList.add("live");
  const view = new View(box);
  if (!view.gl) { box.classList.remove("live"); continue; }
  const [low, high] = reach(shape.arrays.max_stretch);
  view.set(shape, { field: "max_stretch", low, high, restLength: shape.muscle.length_mm, restRadius: shape.muscle.outer_diameter_mm / 2 });
  const hint = document.createElement("p");
  hint.className = "hint";
  hint.textContent = "Drag to turn. Coloured by the largest stretch of the rubber.";
  box.append(hint);
}
