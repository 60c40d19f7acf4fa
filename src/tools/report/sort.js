// Sorts a table by the column whose heading is clicked; a second click turns the order round.
for (const table of document.querySelectorAll("table.sortable")) {
  const key = (row, k) => row.cells[k].dataset.sort ?? row.cells[k].textContent;
  table.tHead.rows[0].querySelectorAll("th").forEach((head, k) => {
    head.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      table.tHead.querySelectorAll("th").forEach((th) => th.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => {
        const [x, y] = [key(a, k), key(b, k)];
        const difference = Number(x) - Number(y);
        return Number.isNaN(difference) ? x.localeCompare(y, undefined, { numeric: true }) : difference;
      });
      if (down) rows.reverse();
      table.tBodies[0].append(...rows);
    });
  });
}
