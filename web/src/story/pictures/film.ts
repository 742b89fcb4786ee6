// What a telephone films of a hop, and a film of one's own beside it.

import { HULA_SECOND } from '../../core/fields';
import { make } from '../../dom';
import { ground, ring } from '../draw';
import { linkTo, most, motionOf, storyHoop } from '../hoops';
import type { Picture } from '../kit';
import { degrees, FILM_RATE, jumpOf, PUSH, plain } from '../numbers';
import { fill } from '../rich';
import { PICTURES } from '../text';

/** Pictures a second that telephones have. */
const RATES = [30, 60, 120, FILM_RATE] as const;

/** Rims that are drawn; the weights are drawn in every picture. */
const RIMS = 14;

export function film(picture: Picture): void {
  const hoop = storyHoop(PUSH);
  const { motion } = motionOf(hoop);
  const unit = HULA_SECOND;
  const jump = jumpOf(motion)!;
  const slide = motion.phases.findLast(
    ({ mode, end }) => mode === 'sliding' && end <= jump.from + 1e-9,
  )!;
  const rate = picture.slider('rate', {
    min: 0,
    max: RATES.length - 1,
    step: 1,
    first: 1,
    text: (value) => plain(RATES[value]!),
  });
  const player = picture.player(
    () => ({ from: slide.start, to: motion.end, stops: [jump.from], speed: 0.5 / unit / 2 }),
    (time) => `${plain((time - jump.from) * unit, 2)} s`,
    motion.end,
  );
  /** The instants of the film, one of them nearly at the lift-off, as chance has it. */
  const frames = (): number[] => {
    const step = 1 / RATES[rate.value]! / unit;
    const first = slide.start + 0.37 * step;
    return Array.from(
      { length: Math.max(0, Math.floor((motion.end - first) / step) + 1) },
      (_, i) => first + i * step,
    );
  };
  const own = ownFilm(picture, () => (player.time - jump.from) * unit);
  picture.live(
    (c, { width, height }, palette) => {
      own.show();
      const floor = height - 26;
      const [from, to] = [motion.at(slide.start)!, motion.at(motion.end)!];
      const radius = Math.min(
        width / (to.x - from.x + 2.4),
        (floor - 16) / (2 + most(motion, 'gap')),
      );
      const left = (width - radius * (to.x - from.x)) / 2;
      ground(c, { left: 0, top: 0, width, height }, floor, radius, 0, palette);
      const seen = frames().filter((time) => time <= player.time + 1e-9);
      const every = Math.max(1, Math.ceil(seen.length / RIMS));
      const draw = (time: number, isFaint: boolean, isWhole: boolean): void => {
        const it = motion.at(time);
        if (!it) return;
        const [x, y] = [left + radius * (it.x - from.x), floor - radius * it.centre_y];
        const inAir = time > jump.from;
        const colour = palette.mode[inAir ? 'flight' : 'sliding'];
        if (isWhole)
          ring(
            c,
            {
              x,
              y,
              radius,
              theta: it.theta,
              colour,
              width: isFaint ? 1 : 4,
              isFaint,
              dash: inAir || isFaint ? [] : [4, 2],
            },
            palette,
          );
        else {
          c.fillStyle = colour;
          c.beginPath();
          c.arc(
            x - radius * Math.sin(it.theta),
            y - radius * Math.cos(it.theta),
            2.5,
            0,
            2 * Math.PI,
          );
          c.fill();
        }
      };
      seen.forEach((time, i) => {
        draw(time, true, i % every === 0);
      });
      draw(player.time, false, true);
    },
    () => {
      const air = frames().filter((time) => time > jump.from && time <= jump.to);
      const angle = (time: number): number => motion.at(time)?.theta ?? NaN;
      const step = 1 / RATES[rate.value]! / unit;
      return fill(PICTURES.film.says.seen, {
        rate: plain(RATES[rate.value]!),
        count: plain(air.length),
        time: plain((jump.to - jump.from) * unit, 2),
        turned: degrees(Math.abs(angle(air.at(-1) ?? NaN) - angle(air[0] ?? NaN))),
        exact: degrees(jump.turned),
        slip: plain(Math.round((slide.end - slide.start) / step)),
      });
    },
    () => linkTo(hoop, {}, { time: player.time }),
  );
}

/** A film from the device of the reader, which follows the time of the picture. It is sent nowhere. */
function ownFilm(picture: Picture, seconds: () => number): { show: () => void } {
  const input = make('input', { type: 'file', accept: 'video/*' });
  const video = make('video', {
    muted: '',
    playsinline: '',
    controls: '',
    'aria-label': picture.word('film'),
  });
  const mark = make('button', { type: 'button' }, picture.word('mark'));
  video.hidden = true;
  mark.hidden = true;
  let address = '';
  let lift: number | null = null;
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    if (file === undefined) return;
    if (address !== '') URL.revokeObjectURL(address);
    address = URL.createObjectURL(file);
    video.src = address;
    video.hidden = false;
    mark.hidden = false;
    lift = null;
  });
  mark.addEventListener('click', () => {
    lift = video.currentTime - seconds();
    video.pause();
  });
  picture.controls.append(
    make('label', { class: 'own' }, make('span', {}, picture.word('own')), input),
    video,
    mark,
  );
  return {
    show: () => {
      if (lift === null || !video.paused) return;
      const wanted = Math.min(Math.max(lift + seconds(), 0), video.duration || 0);
      if (Math.abs(video.currentTime - wanted) > 1e-3) video.currentTime = wanted;
    },
  };
}
