/** Tables that are wider, or higher, than their place scroll: the keyboard must be able to do that, too, and hear of what. */

let named = 0;

/** Of tables that fit no one needs to know that they could scroll. */
export function watchTables(root = document) {
  const watch = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth || target.scrollHeight > target.clientHeight) makeStop(target);
      else for (const name of ["tabindex", "role", "aria-label", "aria-labelledby"]) target.removeAttribute(name);
    }
  });
  for (const table of root.querySelectorAll(".table")) watch.observe(table);
}

/** A stop of the tabulator with the name that the table has now and later. */
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
