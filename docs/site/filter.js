// Shows the rows of the tables of a page that hold all words of the filter.
document.addEventListener("input", (event) => {
  if (!event.target.classList.contains("filter")) return;
  const words = event.target.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const row of document.querySelectorAll(".md-content tbody tr")) {
    const text = row.textContent.toLowerCase();
    row.hidden = !words.every((word) => text.includes(word));
  }
});
