// Where the links of the text lead.

import { linkTo, storyHoop } from './hoops';
import { PUSH } from './numbers';

/** The address of a name of the text; a place of the page is its own. */
export function addressOf(name: string): string {
  if (name.startsWith('#')) return name;
  const found = {
    laboratory: linkTo(storyHoop(PUSH)),
    sheet: './sheet.html',
    story: './story.html',
  }[name];
  if (found === undefined) throw new Error(`the story has no address named ${name}`);
  return found;
}
