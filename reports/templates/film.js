// The film of a Koyna run: draws the picture that the slider asks for. The page shows its first picture without this script.
(function () {
  const film = document.querySelector(".film");
  if (!film) return;
  const data = JSON.parse(film.querySelector(".film-data").textContent);
  function numbers(text, Kind) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const view = new DataView(bytes.buffer), signed = Kind === Int16Array;
    return Kind.from({ length: bytes.length / 2 }, (_, i) => signed ? view.getInt16(2 * i, true) : view.getUint16(2 * i, true));
  }
  const meshes = data.meshes.map((m) => ({ points: numbers(m.points, Int16Array), outer: numbers(m.outer, Uint16Array), inner: numbers(m.inner, Uint16Array) }));
  const slider = film.querySelector("input"), output = film.querySelector("output"), play = film.querySelector(".play");
  const longest = Math.max(1, ...data.water.flat().map((p) => p[0])), highest = Math.max(1, ...data.water.flat().map((p) => p[1]));

  function path(at, edges) {
    let text = "";
    for (let i = 0; i < edges.length; i += 2) text += "M" + at(edges[i]) + "L" + at(edges[i + 1]);
    return text;
  }
  function pressure(line) {
    if (!line.length) return "";
    const places = line.map((p) => [300 * p[0] / longest, 120 - 120 * p[1] / highest].map((v) => v.toFixed(1)));
    return "M" + places[0][0] + " 120" + places.map((p) => "L" + p.join(" ")).join("") + "L" + places[places.length - 1][0] + " 120Z";
  }
  function show(i) {
    const mesh = meshes[data.mesh[i]], moved = numbers(data.moved[i], Int16Array), scale = data.displacement * data.exaggeration;
    const at = (p) => (mesh.points[2 * p] * data.length + moved[2 * p] * scale).toFixed(2) + " "
      + (-mesh.points[2 * p + 1] * data.length - moved[2 * p + 1] * scale).toFixed(2);
    for (const part of ["inner", "outer"]) {
      const drawn = path(at, mesh[part]);
      for (const line of film.querySelectorAll("." + part)) line.setAttribute("d", drawn);
    }
    film.querySelector(".water").setAttribute("d", pressure(data.water[i]));
    output.textContent = data.times[i].toFixed(2) + " s · crack " + data.lengths[i].toFixed(1) + " m";
    slider.setAttribute("aria-valuetext", output.textContent);
  }
  let timer = 0;
  function stop() {
    clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
    play.setAttribute("aria-pressed", "false");
  }
  play.addEventListener("click", function () {
    if (timer) { stop(); return; }
    if (+slider.value === +slider.max) slider.value = 0;
    play.textContent = "Pause";
    play.setAttribute("aria-pressed", "true");
    timer = setInterval(function () {
      slider.value = +slider.value + 1;
      show(+slider.value);
      if (+slider.value === +slider.max) stop();
    }, 150);
  });
  slider.addEventListener("input", function () { stop(); show(+slider.value); });
})();
