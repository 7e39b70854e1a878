/* On paper nothing is folded: folds open before printing, and close again after it those that were closed. */
addEventListener("beforeprint", () => {
  for (const fold of document.querySelectorAll("article details:not([open])")) {
    fold.open = true;
    fold.dataset.printed = "";
  }
});
addEventListener("afterprint", () => {
  for (const fold of document.querySelectorAll("details[data-printed]")) {
    fold.open = false;
    delete fold.dataset.printed;
  }
});

/* A picture leads to its file, which a browser shows as large as wished. */
addEventListener("DOMContentLoaded", () => {
  for (const picture of document.querySelectorAll("article figure > img")) {
    const link = document.createElement("a");
    link.href = picture.src;
    picture.replaceWith(link);
    link.append(picture);
  }
});
