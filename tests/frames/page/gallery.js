// The gallery: each step with its film, and compared with the step before it.
"use strict";

function comparison(step) {
  const { name, verdict, summary, report } = step.before;
  return make("div", { class: "before" },
    make("p", {}, "Compared with ", name, ": ", verdictBadge(verdict)),
    make("p", { class: "quiet" }, summary),
    make("p", {}, make("a", { href: report }, "Both films in step, and curves")));
}

function stepArticle(step) {
  const heading = make("h2", {}, make("a", { href: step.lesson }, step.title));
  const film = make("img", { src: step.film, alt: `The film of ${step.name}` });
  return make("article", {},
    make("figure", {}, film, make("figcaption", {}, commandLine("made by", step.command))),
    make("div", { class: "words" }, heading, make("p", {}, step.text),
      make("p", {}, make("a", { href: step.lesson }, "The lesson")),
      ...(step.before ? [comparison(step)] : [])));
}

document.getElementById("steps").append(...theData().steps.map(stepArticle));
for (const code of document.querySelectorAll(".made-by"))
  code.replaceWith(commandLine("made by", code.textContent));
