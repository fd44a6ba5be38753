/** Tables that are wider than the page scroll sideways: the keyboard must be able to do that, too. */

export function watchTables(root = document) {
  const watch = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
      else target.removeAttribute("tabindex");
    }
  });
  for (const table of root.querySelectorAll(".table")) watch.observe(table);
}
