// Elements without a framework.
//
//     h('p', { class: 'note' }, 'b = ', h('strong', {}, '29'))
//
// Text is always text: nothing here parses HTML.

type Attribute = string | number | boolean | null | undefined;
type Listener = (event: Event) => void;
export type Child = Node | string | number | null | undefined | false;

/**
 * An element with attributes, listeners (`onclick: f`) and children. `true` is an attribute without
 * a value, `false`, null and undefined leave it out.
 */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Attribute | Listener> = {},
  ...children: (Child | Child[])[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') {
      element.addEventListener(name.slice(2), value);
    } else if (value !== null && value !== undefined && value !== false) {
      element.setAttribute(name, value === true ? '' : String(value));
    }
  }
  append(element, ...children);
  return element;
}

export function append(parent: Node, ...children: (Child | Child[])[]): void {
  for (const child of children.flat()) {
    if (child !== null && child !== undefined && child !== false) {
      parent.appendChild(
        typeof child === 'object' ? child : document.createTextNode(String(child)),
      );
    }
  }
}

/** Puts children in the place of what was there. */
export function fill(parent: Element, ...children: (Child | Child[])[]): void {
  parent.replaceChildren();
  append(parent, ...children);
}

/**
 * A picture of the server as nodes of this page. It comes from our own origin; scripts and handlers
 * are taken out all the same.
 */
export function picture(svg: string): SVGSVGElement {
  const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  if (parsed.nodeName !== 'svg') {
    throw new Error('the server sent a picture that is not SVG');
  }
  for (const element of [parsed, ...parsed.querySelectorAll('*')]) {
    if (['script', 'foreignObject', 'style', 'use', 'image'].includes(element.nodeName)) {
      element.remove();
      continue;
    }
    for (const attribute of [...element.attributes]) {
      if (/^on|^style$|href$/i.test(attribute.name)) {
        element.removeAttribute(attribute.name);
      }
    }
  }
  return document.importNode(parsed, true) as unknown as SVGSVGElement;
}

/** Says something to screen readers without moving the focus. */
export function announce(text: string): void {
  const live = document.getElementById('live');
  if (live) {
    live.textContent = text;
  }
}

/** A frame in which something wide scrolls sideways, for the keyboard too. */
export function scroll(label: string, ...children: Child[]): HTMLElement {
  return h('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': label }, children);
}

/** A labelled field: the label first, an explanation after it if there is one. */
export function field(label: string, control: HTMLElement, hint?: string): HTMLElement {
  control.id ||= `f${++fields}`;
  const note = hint ? h('small', { id: `${control.id}-hint`, class: 'hint' }, hint) : null;
  if (note) {
    control.setAttribute('aria-describedby', note.id);
  }
  return h('div', { class: 'field' }, h('label', { for: control.id }, label), control, note);
}
let fields = 0;

/** A choice of a few words. */
export function select(
  value: string,
  options: readonly (readonly [value: string, text: string])[],
  changed: (value: string) => void,
): HTMLSelectElement {
  const control = h(
    'select',
    { onchange: () => changed(control.value) },
    options.map(([each, text]) => h('option', { value: each, selected: each === value }, text)),
  );
  return control;
}

/** An element of a picture. */
export function svg(
  tag: string,
  attributes: Record<string, string | number>,
  ...children: (SVGElement | string)[]
): SVGElement {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}
