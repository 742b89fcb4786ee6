// The pictures of the story, by their names.

import type { Palette } from '../../generated/palette';
import { type Common, Picture } from '../kit';
import { PICTURES, type PictureName } from '../text';
import { angle } from './angle';
import { answer } from './answer';
import { bounce, jam } from './contact';
import { film } from './film';
import { cone, forces } from './ground';
import { inertia } from './inertia';
import { liftoff } from './liftoff';
import { map } from './map';
import { question } from './question';
import { race } from './race';
import { climb, ramp } from './ramp';
import { release } from './release';

/** Fills a picture with controls and what it draws. */
export type Fill = (picture: Picture) => void;

const FILLS: Readonly<Record<PictureName, Fill>> = {
  release,
  question,
  forces,
  cone,
  inertia,
  liftoff,
  map,
  race,
  angle,
  film,
  bounce,
  jam,
  ramp,
  climb,
  answer,
};

export function pictureOf(name: PictureName, common: Common, palette: Palette): Picture {
  const picture = new Picture(`picture-${name}`, PICTURES[name], common, palette);
  FILLS[name](picture);
  return picture;
}
