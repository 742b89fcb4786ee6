// Texts with numbers, emphasis and links in them.

import { make } from '../dom';
import { ARROWS } from '../generated/palette';
import { CLASSES, MODES } from '../generated/tables';

const TOKENS = /\*([^*]+)\*|\[([^\]]+)\]\(([^)]+)\)|\{([\w.]+)\}|<(\w+):([^>]+)>/g;

/** What words name has a colour by this attribute. */
const COLOURED: readonly (readonly [string, readonly string[]])[] = [
  ['data-mode', MODES],
  ['data-arrow', ARROWS],
  ['data-class', CLASSES],
];

/** Values for the places of a text. */
export type Filling = Readonly<Record<string, string>>;

/** A text with its places filled, as words alone. */
export function fill(text: string, filling: Filling): string {
  return text.replace(/\{([\w.]+)\}/g, (_, name: string) => valueIn(filling, name));
}

/** A text as nodes: `*emphasis*`, `[words](address)`, `{number}`, `<name:words>` in the colour of what is named. */
export function rich(text: string, filling: Filling, addressOf: (name: string) => string): Node[] {
  const nodes: Node[] = [];
  let last = 0;
  for (const match of text.matchAll(TOKENS)) {
    nodes.push(document.createTextNode(text.slice(last, match.index)));
    const [whole, emphasis, words, address, number, name, named] = match;
    if (emphasis !== undefined) nodes.push(make('em', {}, ...rich(emphasis, filling, addressOf)));
    else if (words !== undefined)
      nodes.push(make('a', { href: addressOf(address!) }, ...rich(words, filling, addressOf)));
    else if (name !== undefined) nodes.push(coloured(name, named!));
    else
      nodes.push(
        make('span', { class: 'number', 'data-number': number! }, valueIn(filling, number!)),
      );
    last = match.index + whole.length;
  }
  nodes.push(document.createTextNode(text.slice(last)));
  return nodes;
}

function coloured(name: string, words: string): HTMLElement {
  const found = COLOURED.find(([, names]) => names.includes(name));
  if (found === undefined) throw new Error(`nothing with a colour is named ${name}`);
  return make('span', { class: 'named', [found[0]]: name }, words);
}

function valueIn(filling: Filling, name: string): string {
  const value = filling[name];
  if (value === undefined) throw new Error(`the story has no number named ${name}`);
  return value;
}
