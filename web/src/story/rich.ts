// Texts with numbers, emphasis and links in them.

import { make } from '../dom';

const TOKENS = /\*([^*]+)\*|\[([^\]]+)\]\(([^)]+)\)|\{([\w.]+)\}/g;

/** Values for the places of a text. */
export type Filling = Readonly<Record<string, string>>;

/** A text with its places filled, as words alone. */
export function fill(text: string, filling: Filling): string {
  return text.replace(/\{([\w.]+)\}/g, (_, name: string) => valueIn(filling, name));
}

/** A text as nodes: `*emphasis*`, `[words](address)`, `{number}`. */
export function rich(text: string, filling: Filling, addressOf: (name: string) => string): Node[] {
  const nodes: Node[] = [];
  let last = 0;
  for (const match of text.matchAll(TOKENS)) {
    nodes.push(document.createTextNode(text.slice(last, match.index)));
    const [whole, emphasis, words, address, number] = match;
    if (emphasis !== undefined) nodes.push(make('em', {}, ...rich(emphasis, filling, addressOf)));
    else if (words !== undefined)
      nodes.push(make('a', { href: addressOf(address!) }, ...rich(words, filling, addressOf)));
    else
      nodes.push(
        make('span', { class: 'number', 'data-number': number! }, valueIn(filling, number!)),
      );
    last = match.index + whole.length;
  }
  nodes.push(document.createTextNode(text.slice(last)));
  return nodes;
}

function valueIn(filling: Filling, name: string): string {
  const value = filling[name];
  if (value === undefined) throw new Error(`the story has no number named ${name}`);
  return value;
}
