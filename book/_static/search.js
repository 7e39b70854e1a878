/* The search of the site. The entries (search-entries.js, written by the build) and MiniSearch are loaded when the reader
   opens the dialog; as scripts, so that it works from file:// too. */
(() => {
  /* The weight of each kind: what states a thing, then the problems about it, then what mentions it. */
  const WEIGHTS = {
    Chapter: 3, Section: 3, Theorem: 2, Lemma: 2, Definition: 2, Problem: 1.5, Example: 1.2, Term: .6, Topic: .4, Function: .8,
    Lecture: .8, Equation: .6, Guide: .6, Library: .6, Errata: .4, Check: .2, Absent: 3,
  };
  /* What readers write before the number of a place, in English and Russian: "Theorem 1.2", "eq. (3.7)", "§3.2", "задача 5.26".
     A number alone is that of a problem, one in parentheses that of an equation. */
  const REFERENCES = {
    Problem: /^(?:problem|exercise|задача)?$/, Equation: /^(?:equation|eq|formula|уравнение|формула|\()$/, Theorem: /^(?:theorem|thm|теорема)$/,
    Definition: /^(?:definition|def|определение)$/, Lemma: /^(?:lemma|лемма)$/, Example: /^(?:example|пример)$/,
    Section: /^(?:section|sec|раздел|параграф|§)$/, Chapter: /^(?:chapter|ch|глава)$/,
  };
  const REFERENCE = /^(\p{L}*|§)\.?\s*(\(?)(\p{N}+(?:\.\p{N}+)*[a-z]?)\)?$/u;
  /* Words that say nothing about a place. */
  const STOP = new Set(["a", "an", "and", "by", "for", "how", "in", "is", "of", "on", "the", "to", "what", "with"]);
  const NAMES = { Term: "Glossary", Library: "Module", Absent: "Not in the course" };
  const SHOWN = 30;
  const FORMULA = /\\\(.*?\\\)/g;
  const RUSSIAN_ENDING = /(?:иями|ями|ами|ого|его|ому|ему|ыми|ими|иях|ией|ия|ий|ие|ии|ию|ая|яя|ое|ее|ые|ый|ой|ую|юю|ей|ов|ев|ам|ям|ах|ях|ом|ем|ых|их|ы|и|а|я|о|е|у|ю|ь|й)$/;

  /* Words, and numbers such as 1.15 and 1.15a, which are one word. */
  const tokenize = (text) => (text.replace(/['’]s\b/g, "").match(/\p{N}+(?:\.\p{N}+)*[a-z]?(?!\p{L})|\p{L}[\p{L}\p{M}\p{N}]*/gu) || [])
    .filter((word) => !STOP.has(word.toLowerCase()));
  const fold = (text) => text.toLowerCase().normalize("NFD").replace(/(?<!и)\p{M}/gu, "").normalize("NFC");
  const stem = (word) => {
    const folded = fold(word);
    if (folded.length < 4) return folded;
    if (/^\p{Script=Cyrillic}/u.test(folded)) return folded.replace(RUSSIAN_ENDING, "");
    return folded.replace(/iz(?=(?:e|ed|er|es|ing|ation|ations|able|ability)$)/, "is").replace(/(?<=..[^s])ies$/, "y")
      .replace(/(?<=x|ch|sh|ss)es$|(?<=[^s])s$/, "");
  };
  const stems = (text) => tokenize(text).map(stem).join(" ");
  const has = (words, phrase) => ` ${words} `.includes(` ${phrase} `);

  /* The author's label of a place has its keywords: sec-5-lqr. */
  const anchorOf = (entry) => entry.url.split("#")[1].replace(/[-_]/g, " ");

  /* Return the index of the entries as a function: query -> entries, best first; `isComplete` says whether they have all words. */
  const indexOf = async (entries) => {
    const index = new MiniSearch({
      fields: ["number", "title", "terms", "names", "anchor", "text"],
      extractField: (entry, field) => field === "id" ? entry.id
        : field === "terms" || field === "names" ? (entry[field] || []).join(" ")
        : field === "anchor" ? anchorOf(entry)
        : (entry[field] || "").replace(FORMULA, " "),
      tokenize,
      processTerm: stem,
      searchOptions: {
        boost: { number: 8, title: 5, terms: 4, names: 4, anchor: 3 },
        bm25: { k: 1.2, b: .3, d: .5 },
        prefix: (term, k, terms) => k === terms.length - 1 && /^\p{L}{2}/u.test(term),
        fuzzy: (term) => /^\p{L}{6}/u.test(term) ? .2 : false,
        weights: { prefix: .5, fuzzy: .2 },
      },
    });
    entries.forEach((entry, id) => { entry.id = id; });
    await index.addAllAsync(entries, { chunkSize: 100 });

    /* An entry whose title or one of whose terms is the query, or contains it as a phrase, comes before one that has its
       words here and there. */
    const closeness = (entry, phrase) => {
      const names = [entry.title, `${entry.kind} ${entry.number || ""}`, anchorOf(entry), ...(entry.terms || []), ...(entry.names || [])].map(stems);
      return names.includes(phrase) ? 4 : names.some((name) => has(name, phrase)) ? 3 : 1;
    };
    /* Return the entries with all words of the query; else with words one or two letters away. */
    const fuzzy = (term) => term.length > 5 && .35;
    const withAll = (query) => [{}, { fuzzy, maxFuzzy: 2 }].map((options) => index.search(query, { combineWith: "AND", ...options })).find((hits) => hits.length);
    return (query) => {
      const [, word, bracket, number] = query.toLowerCase().match(REFERENCE) || [];
      const kind = number && Object.keys(REFERENCES).find((name) => REFERENCES[name].test(word || bracket));
      const named = kind ? entries.filter((entry) => entry.kind === kind && (entry.number || "").split(" ").includes(number)) : [];
      const phrase = stems(query);
      const complete = withAll(kind ? number : query);
      const others = (complete || index.search(query))
        .map(({ id, score }) => ({ entry: entries[id], score: score * WEIGHTS[entries[id].kind] * closeness(entries[id], phrase) }))
        .sort((a, b) => b.score - a.score || a.entry.id - b.entry.id)
        .map(({ entry }) => entry);
      return Object.assign([...new Set([...named, ...others])], { isComplete: Boolean(complete) });
    };
  };

  /* Return the sentence of a text that has most words of the query, the first of them if several have. */
  const context = (text, query) => {
    const wanted = new Set(tokenize(query).map(stem));
    const sentences = text.match(/(?:\\\(.*?\\\)|(?<!\p{L})\p{Lu}\.|[^.?!]|[.?!](?!\s+[\p{Lu}\\«“(]))+[.?!]*/gsu) || [];
    const shared = (sentence) => new Set(tokenize(sentence).map(stem).filter((word) => wanted.has(word))).size;
    const first = sentences.find((sentence) => sentence.length > 30) || sentences[0] || "";
    return sentences.reduce((best, sentence) => shared(sentence) > shared(best) ? sentence : best, first).trim();
  };

  const bookSearch = globalThis.bookSearch = { indexOf };

  addEventListener("DOMContentLoaded", () => {
    const dialog = document.querySelector("#pst-search-dialog");
    const [field, list, status] = ["input", "#search-hits", "#search-status"].map((selector) => dialog.querySelector(selector));
    const root = document.documentElement.dataset.content_root;
    let typesetting = Promise.resolve();

    const load = (path) => new Promise((resolve, reject) => {
      document.head.append(Object.assign(document.createElement("script"), { src: root + path, onload: resolve, onerror: reject }));
    });
    const prepare = async () => {
      await Promise.all([load("_static/minisearch/minisearch.js"), load("search-entries.js")]);
      bookSearch.search = await indexOf(globalThis.searchEntries);
      show();
    };

    const element = (name, className, text) => Object.assign(document.createElement(name), { className, textContent: text });

    /* Marks the words of the query and leaves formulas to MathJax. */
    const quote = (text, query) => {
      const wanted = tokenize(query).map(stem);
      const paragraph = element("span", "search-context", "");
      for (const part of text.split(/(\\\(.*?\\\))/)) {
        if (part.startsWith("\\(")) paragraph.append(element("span", "math", part));
        else for (const piece of part.split(/([\p{L}\p{M}\p{N}.]+)/u)) {
          paragraph.append(wanted.some((word) => piece && stem(piece.replace(/\.$/, "")) === word) ? element("mark", "", piece) : piece);
        }
      }
      return paragraph;
    };

    const row = (entry, query) => {
      const link = element("a", "", "");
      link.href = root + entry.url;
      const title = quote(entry.title, query);
      title.className = "search-title";
      const about = element("span", "search-place", NAMES[entry.kind] || entry.kind);
      if (entry.place && entry.place !== NAMES[entry.kind]) about.append(` · ${entry.place.replace(FORMULA, (formula) => formula.slice(2, -2))}`);
      link.append(about, title, quote(context(entry.text || "", query), query));
      const item = document.createElement("li");
      item.append(link);
      return item;
    };

    const show = () => {
      const query = field.value.trim();
      if (!query || !bookSearch.search) {
        list.replaceChildren();
        status.textContent = query ? "Loading the index …" : "";
        return;
      }
      const hits = bookSearch.search(query);
      list.replaceChildren(...hits.slice(0, SHOWN).map((entry) => row(entry, query)));
      dialog.scrollTop = list.scrollTop = 0;
      const count = hits.length > SHOWN ? `the best ${SHOWN} of ${hits.length} places` : `${hits.length || "no"} ${hits.length === 1 ? "place" : "places"}`;
      status.textContent = !hits.length || hits.isComplete ? count[0].toUpperCase() + count.slice(1) : `No place has all these words; ${count} with some of them`;
      // one after the other: MathJax must not be called while it works
      if (window.MathJax?.typesetPromise) typesetting = typesetting.then(() => MathJax.typesetPromise([list])).catch(() => {});
    };

    let pause;
    field.addEventListener("input", () => { clearTimeout(pause); pause = setTimeout(show, 80); });
    field.addEventListener("focus", () => prepare().catch(() => { status.textContent = "The index of the search could not be loaded."; }), { once: true });
    dialog.querySelector("form").addEventListener("submit", (event) => {
      event.preventDefault();
      clearTimeout(pause);
      show();
      list.querySelector("a")?.click();
    });
    dialog.querySelector(".search-close").addEventListener("click", () => dialog.close());
    // A hit on this page changes no page: the dialog would stay.
    list.addEventListener("click", (event) => { if (event.target.closest("a")) dialog.close(); });

    dialog.addEventListener("keydown", (event) => {
      const links = [...list.querySelectorAll("a")];
      const at = links.indexOf(document.activeElement);
      if (event.key === "Escape") dialog.close();
      else if (event.key === "ArrowDown") links[Math.min(at + 1, links.length - 1)]?.focus();
      else if (event.key === "ArrowUp") (at > 0 ? links[at - 1] : field).focus();
      else return;
      event.preventDefault();
    });
  });
})();
