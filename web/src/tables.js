/** Tables that are wider, or higher, than their room scroll: the keyboard must be able to do that, too. */

export function watchTables(root = document) {
  const watch = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth || target.scrollHeight > target.clientHeight) target.tabIndex = 0;
      else target.removeAttribute("tabindex");
    }
  });
  for (const table of root.querySelectorAll(".table")) watch.observe(table);
}
