// All words of the story and of the sheet for teachers, for whoever translates them: copy this file
// and say the same in another language. Only titles and descriptions stand in the heads of
// story.html and sheet.html, too, for those who look for the pages.
//
// Controls that are not named here have the library's names.
//
// *emphasis*; <name:words> has the colour of a mode, an arrow or a class of outcomes;
// [words](address), an address being a name of `addresses.ts` or a place of the page; {name} is a number, which the library computes (`numbers.ts`, and each picture its own). No
// number is typed here but years and equations of the paper.

import type { Article } from '../text';

/** The mark between the whole and the parts of a number. */
export const DECIMAL = '.';

/** Names of the library that the language has words of its own for. */
export const LIBRARY: Readonly<Record<string, string>> = {};

export const COMMON = {
  play: 'Play',
  pause: 'Pause',
  time: 'time',
  laboratory: 'Open it in the laboratory.',
  weight: 'Weight of the hoop: its start',
  theme: 'Light or dark',
  skip: 'To the question',
  nav: 'Beside the story',
  links: { laboratory: 'The laboratory', sheet: 'For teachers' },
  defect: 'The pictures cannot be computed here: {reason}',
} as const;

export const STORY: Article = {
  title: 'Does the hoop hop?',
  lede: [
    'Fix a weight to the rim of a hoop, turn it, and let it go. Does it hop? Here are thousands of ways to let it go, all at once. Touch one, and its hoop is played beside.',
    { picture: 'release' },
    'Mathematicians and physicists have argued about this since 1953, and a [film of 2023](#source-film) made the argument known to many. This page tells it with pictures that you can drag. Each is computed while you drag it, by [the same library](laboratory) that computes the motions of the laboratory, and so is every number in the text.',
  ],
  parts: [
    {
      id: 'question',
      heading: 'The question',
      body: [
        'Guess first. Then choose a push and play, or drag the weight and fling it. The weight of this hoop has {story.ratio} times the mass of the rim.',
        { picture: 'question' },
        'With a weak push it <rolling:rolls>. With a strong one it <flight:leaves the ground> at the very first moment, which is no surprise: a car flies over a humpback bridge for the same reason. In between it goes almost a whole turn along the ground, and then, by itself, it <flight:jumps>. That is the puzzle. Nothing strikes it, nothing pulls it up, and the ground can only push. Why does it leave?',
      ],
    },
    {
      id: 'littlewood',
      heading: 'What Littlewood said',
      body: [
        'J. E. Littlewood put the puzzle into *A Mathematician’s Miscellany* in 1953. His hoop weighs nothing. All the mass is in the weight.',
        {
          quote:
            'A weight is attached to a point of a rough weightless hoop, which then rolls in a vertical plane, starting near the position of unstable equilibrium. What happens, and is it intuitive? The hoop lifts off the ground when the radius vector to the weight becomes horizontal. I don’t find the lift directly intuitive; one can, however, “see” that the motion is equivalent to the weight’s sliding smoothly under gravity on the cycloid that it describes, and it is intuitive that it will sooner or later leave *that*. […] In actual practice the hoop skids first.',
          source: 'J. E. Littlewood, 1953, as [Bronars and O’Reilly](#source-gliding) quote him',
        },
        'Is that right? Let his hoop roll, and look at the ground. Drag the weight around.',
        { picture: 'forces' },
        'His calculation is right. As long as the hoop rolls, the ground must push up with a force <normal_force:N>. At first <normal_force:N> carries the whole weight. It shrinks as the hoop gathers speed, and when the weight has turned by {rolling.zero} it is zero: the radius is horizontal. From there on rolling needs a ground that *pulls*. No ground does that. So the weight leaves its cycloid, just as he said.',
        'But here is the trap. Leaving the cycloid is one thing, leaving the ground is another. At that instant the weight is on its way *down*. It cannot fall more slowly than a stone unless something holds it up, and it cannot take the rim up with it. The hoop has another way out. It can stay on the ground and <sliding:slip>.',
      ],
    },
    {
      id: 'cone',
      heading: 'It skids first',
      body: [
        'How rough is “rough”? A force of the ground has two parts: <normal_force:N> upwards, and friction <friction_force:F> along the ground. The ground grips as long as <friction_force:F> is at most μ times <normal_force:N>, where μ is the coefficient of friction. Draw all the forces that the ground can give, and you have a wedge, the *friction cone*.',
        'A weightless hoop has no freedom here. It cannot be turned by a force without spinning infinitely fast, so the force must point from the ground straight at the weight. When the weight moves out of the wedge, the hoop <sliding:slips>.',
        { picture: 'cone' },
        'With μ = {cone.mu} it slips after {cone.angle}. To come as far as Littlewood’s {rolling.zero} it needs a coefficient of {rolling.friction} or more. Rubber on a dry road can do that; most pairs of things cannot. Littlewood knew: “in actual practice the hoop skids first”.',
        'Two answers followed. Butler and Pritchett showed that Littlewood’s hoop does not jump, [as later authors report](#source-gliding). [Pritchett](#source-revisited) proved more: on level ground any loaded hoop that rolls must slip before it can take off. That is exact. A hoop that rolls is held by <normal_force:N> and <friction_force:F> together, and both would have to vanish at once. On level ground they do so only with the weight at the very top, and there the hoop has already begun to slip.',
      ],
    },
    {
      id: 'skim',
      heading: 'Skimming, gliding, or nonsense?',
      body: [
        'What does the weightless hoop do after it slips? T. F. Tokieda took up the puzzle [in 1997](#source-hopping). He noted that a hula hoop with a battery in it shows the jump, and he was the first to see that the hoop can move along the ground without pressing on it. (Like Littlewood, he concluded that the hoop hops at the horizontal, [as Theron and Maritz report](#source-variety).) [Theron and du Plessis](#source-massless) worked that motion out in 2001 and called it *skimming*. [Bronars and O’Reilly](#source-gliding) called it <gliding:gliding> in 2019. The weight falls freely along a parabola; the rim turns and slides beneath it so that it just touches the ground; and neither <normal_force:N> nor <friction_force:F> acts at all.',
        'In 2024 [Aglaev and Kovaldzhi](#source-rough) objected: the skimming phase “is not derived, but wrongly postulated”. They have a point. A body without inertia needs no torque to be turned, so the laws of motion hardly speak about it. Why should the rim stay on the ground? It might as well hover.',
        'A computer can settle this, because a hoop that weighs *nearly* nothing obeys the laws of motion like everything else. Give the rim its inertia back, watch it, and then take the inertia away, step by step.',
        { picture: 'inertia' },
        'With an inertia of one thousandth the weight strays from the path without inertia by {light.thousandth} of the radius at most. With ten times less inertia it strays {light.ratio} times less. The lighter the rim, the nearer it comes to <gliding:gliding>. So nobody has to postulate it: light hoops do it. (The study *Where the massless hoop comes from* of the documentation proves it, and says where a light hoop does something else: where it slips with its weight inside the wedge, it stops slipping at once.) The objection was fair; the motion is real.',
        'The same authors find a contradiction in the rolling of a hoop on an “absolutely rough” ground. That is real, too: there are speeds at which rolling would need a pull, and at which the hoop cannot leave the ground either. The exact motion there is a slide, however large the friction.',
        'So Littlewood’s own hoop never hops. It <sliding:skids>, and then it <gliding:skims>.',
      ],
    },
    {
      id: 'hop',
      heading: 'A real hoop',
      body: [
        'Why, then, do hula hoops with batteries hop? Because their rims have inertia, and something with inertia can be pushed. Our hoop from the beginning, with a push of {hop.push} (in units of √(g/R)), first <sliding:slips> after {hop.slip}. Just beyond the bottom, after {hop.stick}, it grips again and <rolling:rolls>; after {hop.again} it <sliding:slips> once more, and now, as the weight is hurled *upwards*, the ground’s force fades away. It <flight:lifts off> {hop.before} before the weight is at the top again. The rim rises by {hop.height} of its radius.',
        'Look at that moment in slow motion.',
        { picture: 'liftoff' },
        'Nothing jerks. <normal_force:N> sinks to zero while the hoop slides, and then the gap opens like the third power of time: for a while it is too small to see. At the instant of lift-off the mass centre circles the middle of the hoop just fast enough to balance gravity. Friction does not enter that balance.',
        'The push matters. This hoop hops if it is pushed harder than {push.least}. Below, it never leaves the ground: the library follows it until its energy proves that. And a gentle nudge, as in Littlewood’s puzzle, never makes a real hoop hop, unless it is lighter and rougher than anything that you can build. Above {push.most} it leaves at once.',
        { picture: 'map' },
        'Every point of this map is a way to let the hoop go: where the weight is, and how fast the hoop turns. The colour says what becomes of it. Drop your own start into it, and follow its path.',
      ],
    },
    {
      id: 'race',
      heading: 'A race',
      body: [
        'Littlewood’s hoop, a light one, and a real one on one track each: the same start, the same friction. The rim of the light one has a twentieth of the mass of its weight, that of the real one a quarter. A real ground also resists rolling: it gives way a little, and pushes {race.resistance} of the radius in front of the middle. Who hops?',
        { picture: 'race' },
        'Drag the weight of the first hoop to let all three start elsewhere.',
        {
          riddle: 'What did the first race show?',
          answer:
            'The light one hops first and highest, because most of the energy is in its weight. Littlewood’s, which is the lightest, stays on the ground. And the resistance costs the real one half of its hop.',
        },
      ],
    },
    {
      id: 'angle',
      heading: 'One angle for all hoops',
      body: [
        'How far does a hoop turn in the air? One would expect that this depends on everything: the masses, the friction, the speed, even on gravity. It depends on one thing. Here are three hoops as different as you like, which lift off with the weight at the same angle before the top.',
        { picture: 'angle' },
        'A hoop that lifts off {angle.example} before the top turns through {angle.turned}, on Earth and on the Moon. For small angles it is {angle.small} times the angle of lift-off. Can you make it turn exactly once? The reason is short: at lift-off gravity and circling balance, and that balance fixes the speed for each hoop so that everything else cancels.',
        {
          riddle: 'At which angle does it turn exactly once?',
          answer: 'At {angle.whole}, for every hoop: where the tangent of the angle is π.',
        },
        'You can check this at home, because it relates two angles, which a telephone can film without a ruler.',
        { picture: 'film' },
      ],
    },
    {
      id: 'landing',
      heading: 'It lands',
      body: [
        'The paper of 2019 ends where the rim comes down. What follows depends on how rim and ground bounce. Their *coefficient of restitution* says how much of the speed a collision gives back: nothing at zero, everything at one.',
        { picture: 'bounce' },
        'A real hoop loses its bounces in a moment: with {bounce.e} it strikes the ground so often, each time sooner, that the library adds the last bounces up as a series. Then it slides, rolls, and may hop again. Ivanov found motions of a loaded cylinder that roll, jump and land for ever, [as Bronars and O’Reilly recall](#source-gliding).',
        'And there is something stranger than a hop. Let a very light hoop slip on a very rough ground, with the weight high and to the side. More friction means more force, which turns the hoop harder into the ground, which means more friction. In the picture, beyond a coefficient of {jam.mu}, no finite force would do. This is Painlevé’s paradox, and even a hoop has it.',
        { picture: 'jam' },
        'The rim stops dead, without a collision: it *jams*. The usual continuation, the limit of a very stiff contact, is an impulse that ends the slip in no time at all. If a slide runs into such a jam, it throws the hoop off the ground.',
      ],
    },
    {
      id: 'ramp',
      heading: 'The ramp, and the disc that climbs',
      body: [
        'Films of discs on ramps seem to contradict all this. [Gómez, Hernández-Gómez and Marquina](#source-ramp) let a disc with a rod roll down and saw it jump: it rolls, then jumps. [Arroyo and Aparicio Alcalde](#source-cylinder) find jumps without any slip, in a part of the parameters. On a ramp that is possible: <normal_force:N> and <friction_force:F> can vanish together with the weight at the top.',
        { picture: 'ramp' },
        'But it happens in at most one motion for each hoop and ramp, unless the ground is so rough that Painlevé’s paradox returns. All others slip first. A disc of {ramp.radius} radius, released at {ramp.release} on a slope of {ramp.slope}, slips by {ramp.slip} just before it jumps. No film of the whole jump shows that. (A turn earlier it slips by {ramp.earlier}, and grips again.) So the films are right, as far as a camera can see, and so is “it skids first”.',
        'A last surprise needs no push at all. Release a loaded disc on a slope with its weight on the uphill side, and it rolls *up*.',
        { picture: 'climb' },
        'It climbs because the weight falls further than the disc rises. From rest no disc can lift its centre by more than twice the distance of its mass centre from the middle.',
      ],
    },
    {
      id: 'answer',
      heading: 'The answer',
      body: [
        'Now you can answer for any hoop. How heavy is the weight, how hard is the push, how rough is the ground?',
        { picture: 'answer' },
        '*Yes: a real hoop <flight:hops> if you push it hard enough, though on level ground it must <sliding:slip> first; but Littlewood’s weightless hoop never hops: it <sliding:skids>, and then it <gliding:glides> along the ground without pressing on it.*',
        'Go on in [the laboratory](laboratory), where every number can be changed, or take [the sheet for teachers](sheet) to your class.',
      ],
    },
  ],
};

export const PICTURES = {
  release: {
    title:
      'Each square is a hoop. Across: where its weight starts, from the bottom over the top, in the middle, round to the bottom. Upwards: how fast it turns, to the left above the middle and to the right below. Its rim has a quarter of the mass of its weight.',
    shows:
      'A plane of squares, one for each start, coloured by what its hoop does; beside it the hoop of the square that is chosen.',
    controls: {
      angle: 'angle of the weight',
      rate: 'rate of turning, √(g/R)',
      across: 'where the weight starts',
      upwards: 'how fast it turns',
      rolls: 'has only rolled',
      has_slipped: 'has slipped',
      flies: 'flies',
      lifts_off_later: 'has hopped',
      leaves_at_once: 'left at once, and has landed',
      in_contact: 'never leaves the ground',
    },
    says: {
      follows: 'Following the motions: {count} of {of}.',
      now: '{count} hoops, {time} √(R/g) after they were let go: {counts}.',
      counts:
        '{flies} are in the air, {landed} have landed, and {stays} will never leave the ground',
    },
  },
  question: {
    title: 'A hoop with a weight, pushed with the weight at the top.',
    shows:
      'A hoop with a weight on its rim rolls to the right along the ground; arrows show the force of the ground and the slip.',
    controls: {
      push: 'push, √(g/R)',
      where: '{angle} to the right of the top, turning at {rate} √(g/R)',
      guess: 'Your guess',
      hops: 'It hops',
      stays: 'It stays down',
    },
    says: {
      ask: 'Does it hop? Guess, and play.',
      right: 'You were right.',
      wrong: 'You guessed otherwise.',
      hops: 'It hops. It turns by {turned} along the ground, lifts off, rises by {height} of its radius, and turns by {air} in the air.',
      atOnce: 'It leaves the ground at once: its weight is too fast to be held down.',
      rolls: 'It never hops. It rolls for ever and never slips.',
      slips: 'It never hops. It rolls and slips in turn, and leaves the ground nowhere.',
    },
  },
  forces: {
    title:
      'Littlewood’s hoop, rolling from rest at the top, with the forces that this needs, and the cycloid of its weight.',
    shows:
      'A weightless hoop on the ground with arrows for the normal force and friction, and a curve of the normal force over the angle.',
    controls: {
      angle: 'angle of the weight from the top',
      pull: 'pull',
      needed: 'N that rolling needs',
      of: 'angle',
    },
    says: {
      pushes:
        'At {angle} the ground pushes with {normal} of the weight, and holds the rim with a friction of {friction}.',
      nothing: 'At {angle} the ground does not push at all.',
      pulls:
        'At {angle} the ground would have to pull with {normal} of the weight. It cannot: here the hoop no longer rolls.',
    },
  },
  cone: {
    title:
      'The force of the ground on a weightless hoop points at the weight. The ground can give it inside the wedge.',
    shows:
      'A weightless hoop on the ground, a wedge of possible forces at the point of contact, and the force that rolling needs.',
    controls: {
      angle: 'angle of the weight from the top',
      mu: 'coefficient of friction μ',
      grips: 'grips',
      slips: 'slips',
    },
    says: {
      grips:
        'At {angle} rolling needs a friction of {ratio} times N. The ground has {mu}: it grips. It slips at {limit}.',
      slips:
        'At {angle} rolling needs a friction of {ratio} times N. The ground has only {mu}: it has slipped at {limit}.',
      pulls:
        'At {angle} rolling needs a ground that pulls. With this friction it comes as far as {limit}, where N is zero.',
    },
  },
  inertia: {
    title:
      'The path of the weight, for a rim with inertia and for a rim with none (dashed). The start is that of Figure 7 of the paper.',
    shows:
      'A hoop rolls and slips; beside its weight’s path the dashed path of the weight of a hoop without inertia.',
    controls: { inertia: 'inertia of the rim, over that of the weight', none: 'none' },
    says: {
      light:
        'With an inertia of {inertia} the weight strays from the path without inertia by {distance} of the radius at most. Now it {mode}, and the ground pushes with {normal} of the weight.',
      none: 'Without inertia. Now it {mode}, and the ground pushes with {normal} of the weight.',
    },
  },
  liftoff: {
    title:
      'The moment of lift-off: the normal force N, and the gap under the rim, drawn larger than life.',
    shows:
      'A hoop at the moment of lift-off, and curves of the normal force and of the gap over time.',
    controls: {
      push: 'push, √(g/R)',
      normal: 'N',
      gap: 'gap',
      instant: 'lift-off',
      of: 'time',
      force: 'N, and the gap × {times}',
    },
    says: {
      before:
        'Before the lift-off: the rim slips, and the ground pushes with {normal} of the weight.',
      after: 'After the lift-off: nothing touches the rim. The gap is {gap} of the radius.',
    },
  },
  map: {
    title:
      'What becomes of every start of this hoop: weight’s angle across, rate of turning upwards.',
    shows: 'A map of starts, coloured by what becomes of them, and the path of one motion over it.',
    controls: {
      angle: 'angle of the weight',
      rate: 'rate of turning, √(g/R)',
      lifts_off_later: 'hops later',
      in_contact: 'never leaves the ground',
    },
    says: {
      leaves_at_once: 'From here it leaves the ground at once.',
      lifts_off_later: 'From here it stays on the ground for a while, and then hops.',
      rolls_forever: 'From here it rolls for ever.',
      stays: 'From here it never leaves the ground.',
    },
  },
  race: {
    title: 'Three hoops from one start, on a track each. The bar on the ground is the hop.',
    shows:
      'Three tracks, one under the other, with a hoop on each; the ground under a hop is marked.',
    controls: {
      angle: 'weight from the top, at the start',
      push: 'push, √(g/R)',
      massless: 'Littlewood’s hoop',
      light: 'the light hoop',
      real: 'the real hoop',
    },
    says: {
      ask: 'Who hops, and who first? Guess, and play.',
      now: '{name} {mode}',
      over: 'has its weight on the ground',
      landed: 'has landed',
      hopped:
        '{name} hops after {time} √(R/g), {place} radii from the start, turned by {angle}, and rises by {height} of its radius',
      atOnce: '{name} leaves the ground at once, and rises by {height} of its radius',
      stayed: '{names} never hops',
      late: '{names} hops only after the race',
      and: 'nor does',
    },
  },
  angle: {
    title:
      'Three hoops that lift off at one angle: a hula hoop with a battery, a disc with a bead, and a light hoop with a heavy weight.',
    shows: 'Three hoops side by side in the air, each with the angle turned since its lift-off.',
    controls: {
      angle: 'lift-off before the top',
      first: 'hula hoop',
      second: 'disc',
      third: 'light hoop',
      progress: 'flight',
    },
    says: {
      turned:
        'They lift off {angle} before the top. In the air the first turns by {first}, the second by {second}, the third by {third}.',
      task: 'Make them turn once, by {whole}, to within {close}.',
      more: 'It is {by} too little.',
      less: 'It is {by} too much.',
      done: 'Once round, in the air! Moves of the slider: {tries}.',
    },
  },
  film: {
    title:
      'What a telephone sees of the hop, if our hoop is as large as a hula hoop: one picture after the other. A film of your own stays on your device.',
    shows:
      'The hoop and its weight as a camera catches them at equal times, from the last slide to the landing.',
    controls: {
      rate: 'pictures a second',
      own: 'Compare with a film of your own',
      mark: 'The film shows the lift-off now',
      film: 'Your film',
    },
    says: {
      seen: 'At {rate} pictures a second {count} show it in the air, for {time} s. From the first to the last of them it turns by {turned}; the exact angle is {exact}. The slip before takes {slip} pictures.',
    },
  },
  bounce: {
    title: 'The motion of Figure 3 of the paper, which lands and goes on.',
    shows:
      'A hoop that has landed bounces along the ground; a curve of the gap under the rim over time.',
    controls: { gap: 'gap', of: 'time' },
    says: {
      bounces:
        'The rim strikes the ground {count} times, and the last bounces are too many to count. Then it {mode}.',
      counted: 'The rim strikes the ground {count} times in the time that is shown.',
      never: 'The rim comes down once and stays. Then it {mode}.',
    },
  },
  jam: {
    title: 'A light hoop slips to the right, with the weight high. The curve is its slip.',
    shows: 'A hoop that slips, with the force of the ground, and a curve of the slip over time.',
    controls: { mu: 'coefficient of friction μ', slip: 'slip', of: 'time' },
    says: {
      jams: 'It jams: the slip ends at once, before any time has passed.',
      slides: 'It slips for {time} √(R/g), pressed down by up to {normal} of the weight.',
    },
  },
  ramp: {
    title: 'A disc with a rod in it, released from rest on a ramp.',
    shows: 'A disc with a weight inside rolls down a slope, and jumps.',
    controls: { slope: 'slope', release: 'weight from the top, at the release' },
    says: {
      jumps:
        'It rolls, slips, and jumps. With a radius of {radius} its last slip before the jump is {slip}.',
      stays: 'It never leaves this slope.',
    },
  },
  climb: {
    title: 'A loaded disc, released from rest on a slope that rises to the right.',
    shows: 'A disc with a weight inside rolls up a slope.',
    controls: { slope: 'slope', release: 'weight uphill of the top, at the release' },
    says: {
      climbs: 'It climbs: its centre rises by {height} of its radius.',
      falls: 'It does not climb: it rolls downhill at once.',
    },
  },
  answer: {
    title:
      'Each point is a hoop that starts with its weight at the top. Further to the right it is pushed harder; further up its weight is heavier, and its rim lighter. Put the ring on yours.',
    shows:
      'A map of hoops, from light to heavy weights, and of pushes: which hop, which stay, and which leave the ground at once.',
    controls: {
      share: 'the weight, as a part of all the mass',
      push: 'how hard it is pushed, √(g/R)',
      mu: 'coefficient of friction μ',
      lifts_off_later: 'hops',
      rolls_forever: 'stays on the ground',
    },
    says: {
      hops: 'It hops: it rises by {height} of its radius.',
      atOnce: 'It leaves at once, without having rolled.',
      stays: 'It does not hop.',
    },
  },
} as const;

/** The modes of motion in a sentence. */
export const MODES = {
  rolling: '<rolling:rolls>',
  sliding: '<sliding:slides>',
  gliding: '<gliding:glides>',
  flight: '<flight:flies>',
  rest: '<rest:rests>',
  skidding: '<skidding:skids>',
} as const;

/** What the story cites. Only here stand volumes and pages. */
export const SOURCES = {
  heading: 'Sources',
  list: {
    miscellany: 'J. E. Littlewood, *A Mathematician’s Miscellany*, Methuen, 1953.',
    hopping: 'T. F. Tokieda, *The hopping hoop*, Amer. Math. Monthly 104 (1997), 152–154.',
    revisited:
      'T. J. Pritchett, *The hopping hoop revisited*, Amer. Math. Monthly 106, no. 7 (1999).',
    massless:
      'W. F. D. Theron and N. M. du Plessis, *The dynamics of a massless hoop*, Am. J. Phys. 69 (2001), 354–359.',
    variety:
      'W. F. D. Theron and M. F. Maritz, *The amazing variety of motions of a loaded hoop*, Math. Comput. Modelling 47 (2008), 1077–1088.',
    gliding:
      'A. Bronars and O. M. O’Reilly, *Gliding motions of a rigid body: the curious dynamics of Littlewood’s rolling hoop*, Proc. R. Soc. A 475 (2019). Littlewood’s paragraph and what Tokieda, Butler and Ivanov did are told as this paper tells it.',
    film: 'Stand-up Maths, *The 56-year argument about a hopping hoop*, a film on YouTube, 2023.',
    rough:
      'A. A. Aglaev and A. K. Kovaldzhi, *Dynamics of a hopping hoop with a massive point on an absolutely rough plane*, Memoirs of the Faculty of Physics, Moscow State University (2024), no. 6, 2460102. Quoted from its abstract.',
    ramp: 'R. W. Gómez, J. J. Hernández-Gómez and V. Marquina, *A jumping cylinder on an inclined plane*, Eur. J. Phys. 33 (2012), 1359.',
    cylinder:
      'E. A. Arroyo and M. Aparicio Alcalde, *The jump effect of a general eccentric cylinder rolling on a ramp*, arXiv:2303.09420. As its abstract says.',
  },
} as const;

export const SHEET = {
  title: 'Does the hoop hop? A sheet for teachers',
  lede: 'Three lessons around one toy: a hoop with a weight on its rim. You need a hula hoop (or an embroidery ring, or a disc of foam), a battery or a bolt, tape, and a telephone. The pictures are in the story, the numbers can be changed in the laboratory.',
  print: 'Print, or save as PDF',
  story: 'The story',
  lessons: [
    {
      heading: 'Lesson one: what the ground can do',
      text: 'Play the question of the story; let everybody guess. Drag the weight of Littlewood’s hoop and find where *N* is zero ({rolling.zero}). Then the friction cone: with μ = {cone.mu} it slips at {cone.angle}. Why does the force of a weightless hoop point at the weight?',
    },
    {
      heading: 'Lesson two: when it leaves',
      text: 'Weak pushes roll, strong ones fly at once, and in between the hoop hops: with a weight of {story.ratio} times the rim’s mass between {push.least} and {push.most} √(g/R). Try it on a table. At lift-off the mass centre’s circling balances gravity. Watch the gap: why can nobody see the moment?',
    },
    {
      heading: 'Lesson three: one angle',
      text: 'Film a hop from the side, and measure two angles: of the weight before the top at lift-off, and turned in the air until the landing. Compare with the story’s three hoops: {angle.example} gives {angle.turned}, whatever the hoop.',
    },
  ],
  measure: {
    heading: 'What to measure with a telephone',
    items: [
      'Stand the telephone still, at the height of the hoop, and film along its axis with {film.rate} pictures a second or more. In good light the pictures are sharp.',
      'Put a bright spot on the weight, another one opposite. The angle of the line between them needs no ruler.',
      'The last picture in which the rim touches the ground is a little too late: the gap opens with the third power of time. Fit the angle’s straight line in the air and go back along it.',
      'The hoop of the story’s film, as large as a hula hoop, is in the air for {film.time} s: {film.count} pictures.',
    ],
  },
  questions: {
    heading: 'Questions, and answers',
    list: [
      [
        'Does *N* = 0 mean that a hoop jumps?',
        'No. Where the weight is falling, the hoop slips instead.',
      ],
      [
        'Why can Littlewood’s hoop not hop?',
        'Its rim has no inertia, so that the ground can give it no push: it glides.',
      ],
      [
        'A weight of {angle.example} before the top at lift-off: how far does the hoop turn on the Moon?',
        'Through {angle.turned}, too: gravity cancels.',
      ],
      [
        'At which angle of lift-off does it turn exactly once?',
        'At {angle.whole}, where the tangent of the angle is π.',
      ],
      [
        'Can a hoop hop without slipping first?',
        'Out of rolling on level ground never; on a ramp in one motion out of all.',
      ],
      [
        'Why does a loaded disc climb a slope?',
        'Its weight falls further than the disc rises. In the story’s picture the disc climbs by {climb.height} of its radius.',
      ],
    ],
  },
  foot: 'Model: A. Bronars and O. M. O’Reilly, Proc. R. Soc. A, 2019. All numbers are computed by the library littlewood.',
} as const;
