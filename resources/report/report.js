(function () {
  "use strict";
  var root = document.documentElement;
  function stored() {
    try { return localStorage.getItem("hunavsim-theme"); } catch (e) { return null; }
  }
  function setTheme(dark) {
    root.classList.toggle("dark", dark);
    document.dispatchEvent(new Event("themechange"));
  }
  var system = window.matchMedia("(prefers-color-scheme: dark)");
  var chosen = stored();
  setTheme(chosen ? chosen === "dark" : system.matches);
  if (system.addEventListener) {
    system.addEventListener("change", function () {
      if (!stored()) { setTheme(system.matches); }
    });
  }
  var wasDark = false;
  window.addEventListener("beforeprint", function () {
    wasDark = root.classList.contains("dark");
    setTheme(false);
  });
  window.addEventListener("afterprint", function () { setTheme(wasDark); });
  document.getElementById("theme").addEventListener("click", function () {
    var dark = !root.classList.contains("dark");
    try { localStorage.setItem("hunavsim-theme", dark ? "dark" : "light"); } catch (e) { /* none */ }
    setTheme(dark);
  });

  function keyOf(row, column) {
    var cell = row.cells[column];
    var text = cell.getAttribute("data-sort");
    if (text === null) { text = cell.textContent.trim(); }
    var number = parseFloat(text.replace("−", "-"));
    return isNaN(number) ? text : number;
  }
  function compare(a, b) {
    var isA = typeof a === "number", isB = typeof b === "number";
    if (isA && isB) { return a - b; }
    if (isA !== isB) { return isA ? -1 : 1; }
    return a < b ? -1 : a > b ? 1 : 0;
  }
  document.querySelectorAll("table.sortable th").forEach(function (head) {
    head.tabIndex = 0;
    function sort() {
      var down = head.getAttribute("aria-sort") === "ascending";
      var body = head.closest("table").tBodies[0];
      var rows = Array.prototype.slice.call(body.rows);
      rows.forEach(function (row, place) { row.place = place; });
      rows.sort(function (a, b) {
        var order = compare(keyOf(a, head.cellIndex), keyOf(b, head.cellIndex));
        return (down ? -order : order) || a.place - b.place;
      });
      rows.forEach(function (row) { body.appendChild(row); });
      head.closest("tr").querySelectorAll("th").forEach(function (other) {
        other.removeAttribute("aria-sort");
      });
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
    }
    head.addEventListener("click", sort);
    head.addEventListener("keydown", function (event) {
      if (event.key === "Enter" || event.key === " ") { event.preventDefault(); sort(); }
    });
  });
}());
