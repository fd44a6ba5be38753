/** Views selected by tabs, accessible by keyboard and screen reader. */

import { make } from "./elements.js";

/** views: [{name, title, element, seen}]; `seen` is called whenever a view becomes visible. */
export function makeTabs(views, label) {
  const tabs = views.map(({ name, title, element }, place) => {
    element.id = `view-${name}`;
    element.setAttribute("role", "tabpanel");
    element.setAttribute("aria-labelledby", `tab-${name}`);
    const tab = make("button", { type: "button", id: `tab-${name}`, role: "tab", "aria-controls": element.id }, title);
    tab.addEventListener("click", () => choose(place));
    return tab;
  });
  const list = make("div", { className: "tabs", role: "tablist", "aria-label": label }, ...tabs);
  let chosen = 0;

  function choose(place) {
    chosen = place;
    for (const [number, tab] of tabs.entries()) {
      tab.setAttribute("aria-selected", String(number === place));
      tab.tabIndex = number === place ? 0 : -1;
      views[number].element.hidden = number !== place;
    }
    views[place].seen?.();
  }

  list.addEventListener("keydown", ({ key }) => {
    const steps = { ArrowRight: chosen + 1, ArrowLeft: chosen - 1, Home: 0, End: tabs.length - 1 };
    if (!(key in steps)) return;
    choose((steps[key] + tabs.length) % tabs.length);
    tabs[chosen].focus();
  });

  return {
    element: make("div", { className: "views-of-bench" }, list, ...views.map(({ element }) => element)),
    choose: (name) => choose(views.findIndex((view) => view.name === name)),
    name: (name, title) => (tabs[views.findIndex((view) => view.name === name)].textContent = title),
    seen: () => views[chosen].seen?.(),
  };
}
