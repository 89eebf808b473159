// Elements of a page, made from data. Data becomes text or the value of an attribute, never markup.
"use strict";

const theData = () => JSON.parse(document.getElementById("data").textContent);

// Fills an element. An attribute that is false is left out; one that is true has no value. A child is
// an element or a string.
function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes))
    if (value !== false) element.setAttribute(name, value === true ? "" : value);
  element.append(...children);
  return element;
}

const make = (name, attributes = {}, ...children) =>
  filled(document.createElement(name), attributes, children);

const draw = (name, attributes = {}, ...children) =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);

// Four digits; a dash where there is no number.
function number(value) {
  return value === null ? "–" : String(Number(value.toPrecision(4))).replace("-", "−");
}

// True if the clipboard took the text. The older command is for browsers that give a file no clipboard.
async function copyToClipboard(text, shown) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    getSelection().selectAllChildren(shown);
    return document.execCommand("copy");
  }
}

// A command that can be copied.
function commandLine(label, command) {
  const code = make("code", {}, command);
  const name = `Copy the command: ${label}`;
  const button = make("button", { type: "button", "aria-label": name }, "Copy");
  button.addEventListener("click", async () => {
    button.textContent = (await copyToClipboard(command, code)) ? "Copied" : "Selected";
    setTimeout(() => { button.textContent = "Copy"; }, 1500);
  });
  return make("div", { class: "command" }, make("span", {}, label), code, button);
}

const verdictBadge = (verdict) => make("span", { class: `badge ${verdict}` }, verdict);
