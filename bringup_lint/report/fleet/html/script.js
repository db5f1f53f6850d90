const search = document.getElementById("search");
const all = [...document.querySelectorAll("[data-words]")];
search.addEventListener("input", () => {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const each of all) each.hidden = !words.every((word) => each.dataset.words.includes(word));
  document.getElementById("none").hidden = all.some((each) => !each.hidden);
});
document.addEventListener("keydown", (event) => {
  if (event.key === "/" && document.activeElement !== search) { event.preventDefault(); search.focus(); }
  if (event.key === "Escape") { search.value = ""; search.dispatchEvent(new Event("input")); }
});
const reveal = () => { const found = document.getElementById(location.hash.slice(1)); if (found) found.open = true; };
addEventListener("hashchange", reveal);
reveal();
document.getElementById("theme").addEventListener("click", () => {
  const scheme = getComputedStyle(document.documentElement).colorScheme;
  const dark = scheme === "dark" || (scheme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
  document.documentElement.dataset.theme = dark ? "light" : "dark";
});
document.body.classList.add("scripted");
