// Search and filter of the cases; a link to a case opens it. Nothing else on the page needs this script.
(function () {
  const search = document.getElementById("search"), family = document.getElementById("family"), status = document.getElementById("status");
  const cases = Array.from(document.querySelectorAll("details.case")), count = document.getElementById("found");
  function filter() {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const one of cases) {
      const text = one.dataset.text;
      const fits = words.every((w) => text.includes(w)) && (!family.value || one.dataset.family === family.value)
        && (!status.value || one.dataset.status === status.value);
      one.hidden = !fits;
      shown += fits;
    }
    count.textContent = shown + " of " + cases.length;
    document.getElementById("none-found").style.display = shown ? "none" : "block";
  }
  function follow() {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.matches("details.case")) {
      if (target.hidden) { search.value = ""; family.value = ""; status.value = ""; filter(); }
      target.open = true;
      target.scrollIntoView();
    }
  }
  search.addEventListener("input", filter);
  family.addEventListener("change", filter);
  status.addEventListener("change", filter);
  document.getElementById("open-all").addEventListener("click", function () {
    const open = cases.some((c) => !c.hidden && !c.open);
    for (const one of cases) if (!one.hidden) one.open = open;
    this.textContent = open ? "Close all" : "Open all";
  });
  window.addEventListener("hashchange", follow);
  filter();
  follow();
})();
