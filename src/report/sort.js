// Sorts the table of cases by the column whose heading is clicked; a second click turns the order round.
for (const table of document.querySelectorAll("table.sortable")) {
  const key = (row, k) => row.cells[k].dataset.sort ?? row.cells[k].textContent;
  table.tHead.rows[0].querySelectorAll("th").forEach((head, k) => {
    head.addEventListener("click", () => {
      const down = head.getAttribute("aria-sort") === "ascending";
      table.tHead.querySelectorAll("th").forEach((th) => th.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", down ? "descending" : "ascending");
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => key(a, k).localeCompare(key(b, k), undefined, { numeric: true }));
      if (k > 2) rows.sort((a, b) => Number(key(a, k)) - Number(key(b, k)));
      if (down) rows.reverse();
      table.tBodies[0].append(...rows);
    });
  });
}
