// Shows the rows of the tables of a page that hold all words of the filter, and how many.
const rowsOf = (input) => input.closest(".md-content").querySelectorAll("tbody tr");

document.addEventListener("input", (event) => {
  if (!event.target.classList.contains("filter")) return;
  const words = event.target.value.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = [...rowsOf(event.target)];
  for (const row of rows) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every((word) => text.includes(word));
  }
  const shown = rows.filter((row) => !row.hidden).length;
  event.target.nextElementSibling.textContent = words.length ? `${shown} of ${rows.length} rows` : "";
});

// The search of the theme listens to keys alone: a line that is pasted with the mouse would leave the last results there.
document.addEventListener("input", (event) => {
  if (event.target.classList.contains("md-search__input")) event.target.dispatchEvent(new Event("keyup"));
});
