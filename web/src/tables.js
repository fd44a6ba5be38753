/** Tables that do not fit scroll: then they are focusable, for the keyboard, and have a name for screen readers. */

let named = 0;

/** Tables that fit are not focusable. */
export function watchTables(root = document) {
  const watch = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      showMore(target);
      if (target.scrollWidth > target.clientWidth || target.scrollHeight > target.clientHeight) makeStop(target);
      else for (const name of ["tabindex", "role", "aria-label", "aria-labelledby"]) target.removeAttribute(name);
    }
  });
  for (const table of root.querySelectorAll(".table")) {
    watch.observe(table);
    table.addEventListener("scroll", () => showMore(table), { passive: true });
  }
}

/** Mark the sides on which a table continues. */
function showMore(place) {
  const left = Math.abs(place.scrollLeft);
  place.classList.toggle("more-left", left > 1);
  place.classList.toggle("more-right", left + place.clientWidth < place.scrollWidth - 1);
}

/** A tab stop with the present and future name of the table. */
function makeStop(place) {
  const { caption } = place.querySelector("table");
  place.tabIndex = 0;
  place.setAttribute("role", "group");
  if (!caption) {
    const headings = [...place.querySelectorAll("thead th")].map((each) => each.textContent);
    return place.setAttribute("aria-label", headings.join(", ") || "table");
  }
  caption.id ||= `caption-${++named}`;
  return place.setAttribute("aria-labelledby", caption.id);
}
