/* On paper nothing is folded and the theme is the light one; after printing all is as before. */
addEventListener("beforeprint", () => {
  for (const fold of document.querySelectorAll("article details:not([open], .mistakes, .topics)")) {
    fold.open = true;
    fold.dataset.printed = "";
  }
  const page = document.documentElement;
  page.dataset.screenTheme = page.dataset.theme;
  page.dataset.theme = "light";
});
addEventListener("afterprint", () => {
  for (const fold of document.querySelectorAll("details[data-printed]")) {
    fold.open = false;
    delete fold.dataset.printed;
  }
  document.documentElement.dataset.theme = document.documentElement.dataset.screenTheme;
});

/* A picture leads to its file, which a browser shows as large as wished. */
addEventListener("DOMContentLoaded", () => {
  for (const picture of document.querySelectorAll("article figure img")) {
    const link = document.createElement("a");
    link.href = picture.src;
    picture.replaceWith(link);
    link.append(picture);
  }
});

/* What the theme and the extensions tell screen readers, where it is not what stands on the page. */
addEventListener("DOMContentLoaded", () => {
  const each = (selector, act) => document.querySelectorAll(selector).forEach(act);
  // The words on a button are its name.
  each(".search-button-field, details.hide > summary", (button) => button.removeAttribute("aria-label"));
  // Font Awesome draws the icons, with titles, before this or after: what holds them is hidden, drawn or not.
  each(".theme-switch-button", (button) => {
    const icons = document.createElement("span");
    icons.ariaHidden = "true";
    icons.append(...button.childNodes);
    button.append(icons);
  });
  each("nav li > details > summary", (fold) => {
    fold.ariaLabel = `Pages of ${fold.closest("li").querySelector("a").textContent.trim()}`;
  });
  each(".navbar-brand.logo", (title) => { title.parentElement.role = "navigation"; title.parentElement.ariaLabel = "First page"; });
  // Entries of the bibliography are paragraphs: as list and items they would hold what no list may.
  each(".citation-list, .citation, .citation [role='doc-backlink']", (entry) => entry.removeAttribute("role"));
});

/* Marks with remarks on the printed book are hidden until a reader asks for them; the choice holds for all pages. */
document.documentElement.toggleAttribute("data-remarks", localStorage.getItem("remarks") === "shown");
addEventListener("DOMContentLoaded", () => {
  if (!document.querySelector("article .printed")) return;
  const page = document.documentElement, label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = page.hasAttribute("data-remarks");
  box.addEventListener("change", () => {
    page.toggleAttribute("data-remarks", box.checked);
    localStorage.setItem("remarks", box.checked ? "shown" : "hidden");
  });
  label.className = "printed-switch";
  label.append(box, "Show remarks on the printed book");
  document.querySelector("article").append(label);
});
