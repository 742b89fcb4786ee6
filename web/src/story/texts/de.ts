// The words of `en.ts` in German.

import german from '../../texts/de.json' with { type: 'json' };
import type { StoryTexts } from '../text';
import { SOURCES as ENGLISH_SOURCES } from './en';

const { classes } = german;

export const DECIMAL = ',';

export const LIBRARY: StoryTexts['LIBRARY'] = {
  restitution: 'Stoßzahl e',
  ...classes,
};

export const COMMON: StoryTexts['COMMON'] = {
  play: 'Abspielen',
  pause: 'Anhalten',
  time: 'Zeit',
  laboratory: 'Im Labor öffnen.',
  weight: 'Gewicht des Reifens: sein Anfang',
  theme: 'Hell oder dunkel',
  skip: 'Zur Frage',
  nav: 'Neben der Geschichte',
  links: { laboratory: 'Das Labor', sheet: 'Für den Unterricht' },
  defect: 'Die Bilder können hier nicht berechnet werden: {reason}',
};

export const STORY: StoryTexts['STORY'] = {
  title: 'Springt der Reifen?',
  lede: [
    'Befestige ein Gewicht am Rand eines Reifens, dreh ihn und lass ihn los. Springt er? Hier sind Tausende Arten, ihn loszulassen, alle zugleich. Berühre eine, und ihr Reifen wird daneben gezeigt.',
    { picture: 'release' },
    'Darüber streiten Mathematiker und Physiker seit 1953, und ein [Film von 2023](#source-film) hat den Streit bekannt gemacht. Diese Seite erzählt davon mit Bildern, an denen man ziehen kann. Jedes wird beim Ziehen berechnet, von [derselben Bibliothek](laboratory), die die Bewegungen des Labors berechnet, und ebenso jede Zahl im Text.',
  ],
  parts: [
    {
      id: 'question',
      heading: 'Die Frage',
      body: [
        'Rate zuerst. Dann wähle einen Stoß und spiel ihn ab, oder zieh am Gewicht und wirf es. Das Gewicht dieses Reifens hat {story.ratio}-mal die Masse des Randes.',
        { picture: 'question' },
        'Nach einem schwachen Stoß <rolling:rollt> er. Nach einem starken <flight:verlässt er den Boden> im ersten Augenblick, und das wundert niemanden: aus demselben Grund fliegt ein Auto über eine gewölbte Brücke. Dazwischen läuft er fast eine ganze Umdrehung am Boden entlang, und dann, von selbst, <flight:springt> er. Das ist das Rätsel. Nichts stößt ihn, nichts zieht ihn hoch, und der Boden kann nur drücken. Warum hebt er ab?',
      ],
    },
    {
      id: 'littlewood',
      heading: 'Was Littlewood sagte',
      body: [
        'J. E. Littlewood stellte das Rätsel 1953 in *A Mathematician’s Miscellany*. Sein Reifen wiegt nichts. Alle Masse ist im Gewicht.',
        {
          quote:
            'Ein Gewicht ist an einem Punkt eines rauen gewichtslosen Reifens befestigt, der dann in einer senkrechten Ebene rollt und nahe der labilen Gleichgewichtslage beginnt. Was geschieht, und ist es anschaulich? Der Reifen hebt vom Boden ab, wenn der Radius zum Gewicht waagerecht wird. Ich finde das Abheben nicht unmittelbar anschaulich; man kann aber „sehen“, dass die Bewegung der des Gewichts gleicht, das reibungsfrei unter der Schwerkraft auf der Zykloide gleitet, die es beschreibt, und es ist anschaulich, dass es *diese* früher oder später verlässt. […] In der Praxis rutscht der Reifen vorher.',
          source:
            'J. E. Littlewood, 1953, wie [Bronars und O’Reilly](#source-gliding) ihn anführen; hier übersetzt',
        },
        'Stimmt das? Lass seinen Reifen rollen und sieh auf den Boden. Zieh das Gewicht herum.',
        { picture: 'forces' },
        'Seine Rechnung stimmt. Solange der Reifen rollt, muss der Boden mit einer Kraft <normal_force:N> nach oben drücken. Zuerst trägt <normal_force:N> das ganze Gewicht. Es schrumpft, während der Reifen schneller wird, und wenn sich das Gewicht um {rolling.zero} gedreht hat, ist es null: der Radius ist waagerecht. Von da an bräuchte das Rollen einen Boden, der *zieht*. Das tut kein Boden. Also verlässt das Gewicht seine Zykloide, genau wie er sagte.',
        'Aber hier ist die Falle. Die Zykloide zu verlassen ist eines, den Boden zu verlassen ein anderes. In diesem Augenblick ist das Gewicht auf dem Weg nach *unten*. Es kann nicht langsamer fallen als ein Stein, wenn nichts es hält, und es kann den Rand nicht mit hochnehmen. Der Reifen hat einen anderen Ausweg. Er kann am Boden bleiben und <sliding:rutschen>.',
      ],
    },
    {
      id: 'cone',
      heading: 'Er rutscht vorher',
      body: [
        'Wie rau ist „rau“? Die Kraft des Bodens hat zwei Teile: <normal_force:N> nach oben, und die Reibung <friction_force:F> am Boden entlang. Der Boden hält, solange <friction_force:F> höchstens μ mal <normal_force:N> ist, wobei μ die Reibungszahl ist. Zeichne alle Kräfte, die der Boden geben kann, und du hast einen Keil, den *Reibungskegel*.',
        'Ein gewichtsloser Reifen hat hier keine Freiheit. Eine Kraft kann ihn nicht drehen, ohne dass er unendlich schnell wird, also muss sie vom Boden aus genau auf das Gewicht zeigen. Wenn das Gewicht aus dem Keil herauswandert, <sliding:rutscht> der Reifen.',
        { picture: 'cone' },
        'Mit μ = {cone.mu} rutscht er nach {cone.angle}. Um bis zu Littlewoods {rolling.zero} zu kommen, braucht er eine Reibungszahl von {rolling.friction} oder mehr. Gummi auf trockener Straße kann das; die meisten Paare von Dingen können es nicht. Littlewood wusste es: „in der Praxis rutscht der Reifen vorher“.',
        'Zwei Antworten folgten. Butler und Pritchett zeigten, dass Littlewoods Reifen nicht springt, [wie spätere Autoren berichten](#source-gliding). [Pritchett](#source-revisited) bewies mehr: auf ebenem Boden muss jeder beladene Reifen, der rollt, rutschen, bevor er abheben kann. Das gilt genau. Ein Reifen, der rollt, wird von <normal_force:N> und <friction_force:F> zusammen gehalten, und beide müssten zugleich verschwinden. Auf ebenem Boden tun sie das nur mit dem Gewicht ganz oben, und dort rutscht der Reifen schon.',
      ],
    },
    {
      id: 'skim',
      heading: 'Streifen, gleiten, oder Unsinn?',
      body: [
        'Was tut der gewichtslose Reifen, nachdem er gerutscht ist? T. F. Tokieda nahm das Rätsel [1997](#source-hopping) auf. Er merkte an, dass ein Hula-Hoop-Reifen mit einer Batterie darin den Sprung zeigt, und er sah als Erster, dass der Reifen sich am Boden entlang bewegen kann, ohne auf ihn zu drücken. (Wie Littlewood schloss er, dass der Reifen in der Waagerechten springt, [wie Theron und Maritz berichten](#source-variety).) [Theron und du Plessis](#source-massless) rechneten diese Bewegung 2001 aus und nannten sie *skimming*. [Bronars und O’Reilly](#source-gliding) nannten sie 2019 <gliding:Gleiten>. Das Gewicht fällt frei auf einer Parabel; der Rand dreht sich und gleitet unter ihm so, dass er den Boden gerade berührt; und weder <normal_force:N> noch <friction_force:F> wirkt.',
        '2024 wandten [Aglajew und Kowaldschi](#source-rough) ein: diese Phase sei „nicht hergeleitet, sondern zu Unrecht angenommen“. Da ist etwas dran. Ein Körper ohne Trägheit braucht kein Drehmoment, um gedreht zu werden, und so sagen die Gesetze der Bewegung kaum etwas über ihn. Warum sollte der Rand am Boden bleiben? Er könnte ebenso gut schweben.',
        'Ein Rechner kann das klären, denn ein Reifen, der *fast* nichts wiegt, gehorcht den Gesetzen der Bewegung wie alles andere. Gib dem Rand seine Trägheit zurück, sieh ihm zu, und nimm die Trägheit dann Schritt für Schritt weg.',
        { picture: 'inertia' },
        'Mit einem Tausendstel an Trägheit weicht das Gewicht von der Bahn ohne Trägheit um höchstens {light.thousandth} des Radius ab. Mit zehnmal weniger Trägheit weicht es {light.ratio}-mal weniger ab. Je leichter der Rand, desto näher kommt er dem <gliding:Gleiten>. Niemand muss es also annehmen: leichte Reifen tun es. (Die Studie *Where the massless hoop comes from* der Dokumentation beweist es, und sie sagt, wo ein leichter Reifen etwas anderes tut: wo er mit seinem Gewicht im Keil rutscht, hört er sofort auf zu rutschen.) Der Einwand war berechtigt; die Bewegung ist wirklich.',
        'Dieselben Autoren finden einen Widerspruch im Rollen eines Reifens auf „absolut rauem“ Boden. Auch den gibt es: bei manchen Geschwindigkeiten bräuchte das Rollen einen Zug, und der Reifen kann den Boden auch nicht verlassen. Die genaue Bewegung ist dort ein Rutschen, wie groß die Reibung auch ist.',
        'Littlewoods eigener Reifen springt also nie. Er <sliding:rutscht>, und dann <gliding:gleitet> er.',
      ],
    },
    {
      id: 'hop',
      heading: 'Ein wirklicher Reifen',
      body: [
        'Warum springen dann Hula-Hoop-Reifen mit Batterien? Weil ihr Rand träge ist, und was träge ist, kann gestoßen werden. Unser Reifen vom Anfang, mit einem Stoß von {hop.push} (in Einheiten von √(g/R)), <sliding:rutscht> zuerst nach {hop.slip}. Kurz hinter der tiefsten Stelle, nach {hop.stick}, greift er wieder und <rolling:rollt>; nach {hop.again} <sliding:rutscht> er noch einmal, und nun, da das Gewicht *hochgeschleudert* wird, schwindet die Kraft des Bodens. Er <flight:hebt ab>, {hop.before} bevor das Gewicht wieder oben ist. Der Rand steigt um {hop.height} seines Radius.',
        'Sieh dir diesen Augenblick in Zeitlupe an.',
        { picture: 'liftoff' },
        'Nichts ruckt. <normal_force:N> sinkt auf null, während der Reifen rutscht, und dann öffnet sich der Spalt wie die dritte Potenz der Zeit: eine Weile ist er zu klein, um ihn zu sehen. Im Augenblick des Abhebens kreist der Schwerpunkt gerade so schnell um die Mitte des Reifens, dass es der Schwerkraft die Waage hält. Die Reibung kommt darin nicht vor.',
        'Auf den Stoß kommt es an. Dieser Reifen springt, wenn er stärker als {push.least} gestoßen wird. Darunter verlässt er den Boden nie: die Bibliothek folgt ihm, bis seine Energie das beweist. Und ein sanfter Anstoß, wie in Littlewoods Rätsel, lässt einen wirklichen Reifen nie springen, außer er ist leichter und rauer als alles, was man bauen kann. Über {push.most} hebt er sofort ab.',
        { picture: 'map' },
        'Jeder Punkt dieser Karte ist eine Art, den Reifen loszulassen: wo das Gewicht ist, und wie schnell der Reifen sich dreht. Die Farbe sagt, was aus ihm wird. Setz deinen eigenen Anfang hinein und verfolge seine Bahn.',
      ],
    },
    {
      id: 'race',
      heading: 'Ein Rennen',
      body: [
        'Littlewoods Reifen, ein leichter und ein wirklicher, jeder auf seiner Bahn: derselbe Anfang, dieselbe Reibung. Der Rand des leichten hat ein Zwanzigstel der Masse seines Gewichts, der des wirklichen ein Viertel. Ein wirklicher Boden widersteht auch dem Rollen: er gibt ein wenig nach und drückt {race.resistance} des Radius vor der Mitte. Wer springt?',
        { picture: 'race' },
        'Zieh am Gewicht des ersten Reifens, um alle drei anderswo anfangen zu lassen.',
        {
          riddle: 'Was hat das erste Rennen gezeigt?',
          answer:
            'Der leichte springt zuerst und am höchsten, denn die meiste Energie steckt in seinem Gewicht. Littlewoods Reifen, der leichteste, bleibt am Boden. Und der Widerstand kostet den wirklichen die Hälfte seines Sprungs.',
        },
      ],
    },
    {
      id: 'angle',
      heading: 'Ein Winkel für alle Reifen',
      body: [
        'Wie weit dreht sich ein Reifen in der Luft? Man würde erwarten, dass das von allem abhängt: den Massen, der Reibung, der Geschwindigkeit, sogar der Schwerkraft. Es hängt von einem ab. Hier sind drei Reifen, so verschieden du willst, die mit dem Gewicht im selben Winkel vor dem höchsten Punkt abheben.',
        { picture: 'angle' },
        'Ein Reifen, der {angle.example} vor dem höchsten Punkt abhebt, dreht sich um {angle.turned}, auf der Erde und auf dem Mond. Bei kleinen Winkeln ist es {angle.small}-mal der Winkel des Abhebens. Schaffst du genau eine Umdrehung? Der Grund ist kurz: beim Abheben halten Schwerkraft und Kreisen sich die Waage, und das legt für jeden Reifen die Geschwindigkeit so fest, dass alles andere herausfällt.',
        {
          riddle: 'Bei welchem Winkel dreht er sich genau einmal?',
          answer: 'Bei {angle.whole}, für jeden Reifen: dort ist der Tangens des Winkels π.',
        },
        'Das kannst du zu Hause prüfen, denn es verbindet zwei Winkel, die ein Telefon ohne Lineal filmen kann.',
        { picture: 'film' },
      ],
    },
    {
      id: 'landing',
      heading: 'Er landet',
      body: [
        'Die Arbeit von 2019 endet, wo der Rand herunterkommt. Was folgt, hängt davon ab, wie Rand und Boden zurückprallen. Ihre *Stoßzahl* sagt, wie viel von der Geschwindigkeit ein Stoß zurückgibt: nichts bei null, alles bei eins.',
        { picture: 'bounce' },
        'Ein wirklicher Reifen verliert seine Hüpfer in einem Augenblick: mit {bounce.e} schlägt er so oft auf, jedes Mal früher, dass die Bibliothek die letzten Stöße als Reihe zusammenzählt. Dann rutscht er, rollt, und springt vielleicht wieder. Iwanow fand Bewegungen eines beladenen Zylinders, die ewig rollen, springen und landen, [wie Bronars und O’Reilly erinnern](#source-gliding).',
        'Und es gibt etwas Seltsameres als einen Sprung. Lass einen sehr leichten Reifen auf einem sehr rauen Boden rutschen, mit dem Gewicht hoch und zur Seite. Mehr Reibung heißt mehr Kraft, die den Reifen stärker in den Boden dreht, und das heißt mehr Reibung. Im Bild würde jenseits einer Reibungszahl von {jam.mu} keine endliche Kraft genügen. Das ist Painlevés Paradox, und selbst ein Reifen hat es.',
        { picture: 'jam' },
        'Der Rand bleibt schlagartig stehen, ohne einen Aufprall: er *verklemmt*. Die übliche Fortsetzung, der Grenzfall eines sehr steifen Kontakts, ist ein Kraftstoß, der das Rutschen in keiner Zeit beendet. Wenn ein Rutschen in ein solches Verklemmen läuft, wirft es den Reifen vom Boden.',
      ],
    },
    {
      id: 'ramp',
      heading: 'Die Rampe, und die Scheibe, die steigt',
      body: [
        'Filme von Scheiben auf Rampen scheinen all dem zu widersprechen. [Gómez, Hernández-Gómez und Marquina](#source-ramp) ließen eine Scheibe mit einem Stab hinunterrollen und sahen sie springen: sie rollt, dann springt sie. [Arroyo und Aparicio Alcalde](#source-cylinder) finden Sprünge ohne jedes Rutschen, in einem Teil der Parameter. Auf einer Rampe ist das möglich: <normal_force:N> und <friction_force:F> können mit dem Gewicht oben zusammen verschwinden.',
        { picture: 'ramp' },
        'Aber das geschieht bei jedem Reifen und jeder Rampe in höchstens einer Bewegung, außer der Boden ist so rau, dass Painlevés Paradox zurückkehrt. Alle anderen rutschen vorher. Eine Scheibe von {ramp.radius} Radius, bei {ramp.release} auf einer Neigung von {ramp.slope} losgelassen, rutscht um {ramp.slip}, kurz bevor sie springt. Kein Film des ganzen Sprungs zeigt das. (Eine Umdrehung früher rutscht sie um {ramp.earlier} und greift wieder.) Die Filme haben also recht, soweit eine Kamera sehen kann, und ebenso „er rutscht vorher“.',
        'Eine letzte Überraschung braucht gar keinen Stoß. Lass eine beladene Scheibe auf einem Hang mit dem Gewicht auf der Seite bergauf los, und sie rollt *hinauf*.',
        { picture: 'climb' },
        'Sie steigt, weil das Gewicht tiefer fällt, als die Scheibe sich hebt. Aus der Ruhe kann keine Scheibe ihre Mitte um mehr heben als den doppelten Abstand ihres Schwerpunkts von der Mitte.',
      ],
    },
    {
      id: 'answer',
      heading: 'Die Antwort',
      body: [
        'Jetzt kannst du für jeden Reifen antworten. Wie schwer ist das Gewicht, wie stark der Stoß, wie rau der Boden?',
        { picture: 'answer' },
        '*Ja: ein wirklicher Reifen <flight:springt>, wenn man ihn stark genug stößt, doch auf ebenem Boden muss er vorher <sliding:rutschen>; aber Littlewoods gewichtsloser Reifen springt nie: er <sliding:rutscht>, und dann <gliding:gleitet> er am Boden entlang, ohne auf ihn zu drücken.*',
        'Weiter geht es im [Labor](laboratory), wo jede Zahl geändert werden kann, oder nimm [das Blatt für den Unterricht](sheet) in deine Klasse mit.',
      ],
    },
  ],
};

export const PICTURES: StoryTexts['PICTURES'] = {
  release: {
    title:
      'Jedes Quadrat ist ein Reifen. Quer: wo sein Gewicht beginnt, von unten über oben, in der Mitte, herum nach unten. Hoch: wie schnell er sich dreht, über der Mitte nach links und darunter nach rechts. Sein Rand hat ein Viertel der Masse seines Gewichts.',
    shows:
      'Eine Ebene von Quadraten, eines für jeden Anfang, mit der Farbe dessen, was sein Reifen tut; daneben der Reifen des gewählten Quadrats.',
    controls: {
      angle: 'Winkel des Gewichts',
      rate: 'Drehung, √(g/R)',
      across: 'wo das Gewicht beginnt',
      upwards: 'wie schnell er sich dreht',
      rolls: 'ist nur gerollt',
      has_slipped: 'ist gerutscht',
      flies: 'fliegt',
      lifts_off_later: 'ist gesprungen',
      leaves_at_once: 'hob sofort ab und ist gelandet',
      in_contact: 'verlässt den Boden nie',
    },
    says: {
      follows: 'Die Bewegungen werden verfolgt: {count} von {of}.',
      now: '{count} Reifen, {time} √(R/g) nach dem Loslassen: {counts}.',
      counts:
        '{flies} sind in der Luft, {landed} sind gelandet, und {stays} werden den Boden nie verlassen',
    },
  },
  question: {
    title: 'Ein Reifen mit einem Gewicht, gestoßen mit dem Gewicht oben.',
    shows:
      'Ein Reifen mit einem Gewicht am Rand rollt nach rechts am Boden entlang; Pfeile zeigen die Kraft des Bodens und das Rutschen.',
    controls: {
      push: 'Stoß, √(g/R)',
      where: '{angle} rechts von oben, dreht sich mit {rate} √(g/R)',
      guess: 'Deine Vermutung',
      hops: 'Er springt',
      stays: 'Er bleibt am Boden',
    },
    says: {
      ask: 'Springt er? Rate, und spiel es ab.',
      right: 'Du hattest recht.',
      wrong: 'Du hattest etwas anderes vermutet.',
      hops: 'Er springt. Er dreht sich am Boden um {turned}, hebt ab, steigt um {height} seines Radius und dreht sich in der Luft um {air}.',
      atOnce:
        'Er verlässt den Boden sofort: sein Gewicht ist zu schnell, um unten gehalten zu werden.',
      rolls: 'Er springt nie. Er rollt ewig und rutscht nie.',
      slips: 'Er springt nie. Er rollt und rutscht im Wechsel und verlässt den Boden nirgends.',
    },
  },
  forces: {
    title:
      'Littlewoods Reifen, wie er aus der Ruhe von oben rollt, mit den Kräften, die das braucht, und der Zykloide seines Gewichts.',
    shows:
      'Ein gewichtsloser Reifen am Boden mit Pfeilen für Normalkraft und Reibung, und eine Kurve der Normalkraft über dem Winkel.',
    controls: {
      angle: 'Winkel des Gewichts von oben',
      pull: 'Zug',
      needed: 'N, das Rollen braucht',
      of: 'Winkel',
    },
    says: {
      pushes:
        'Bei {angle} drückt der Boden mit {normal} des Gewichts und hält den Rand mit einer Reibung von {friction}.',
      nothing: 'Bei {angle} drückt der Boden gar nicht.',
      pulls:
        'Bei {angle} müsste der Boden mit {normal} des Gewichts ziehen. Das kann er nicht: hier rollt der Reifen nicht mehr.',
    },
  },
  cone: {
    title:
      'Die Kraft des Bodens auf einen gewichtslosen Reifen zeigt auf das Gewicht. Im Keil kann der Boden sie geben.',
    shows:
      'Ein gewichtsloser Reifen am Boden, ein Keil der möglichen Kräfte am Berührpunkt, und die Kraft, die Rollen braucht.',
    controls: {
      angle: 'Winkel des Gewichts von oben',
      mu: 'Reibungszahl μ',
      grips: 'hält',
      slips: 'rutscht',
    },
    says: {
      grips:
        'Bei {angle} braucht Rollen eine Reibung von {ratio} mal N. Der Boden hat {mu}: er hält. Bei {limit} rutscht der Reifen.',
      slips:
        'Bei {angle} braucht Rollen eine Reibung von {ratio} mal N. Der Boden hat nur {mu}: bei {limit} ist der Reifen gerutscht.',
      pulls:
        'Bei {angle} braucht Rollen einen Boden, der zieht. Mit dieser Reibung kommt er bis {limit}, wo N null ist.',
    },
  },
  inertia: {
    title:
      'Die Bahn des Gewichts, für einen Rand mit Trägheit und für einen ohne (gestrichelt). Der Anfang ist der von Figure 7 der Arbeit.',
    shows:
      'Ein Reifen rollt und rutscht; neben der Bahn seines Gewichts die gestrichelte eines Reifens ohne Trägheit.',
    controls: { inertia: 'Trägheit des Randes, über der des Gewichts', none: 'keine' },
    says: {
      light:
        'Mit einer Trägheit von {inertia} weicht das Gewicht von der Bahn ohne Trägheit um höchstens {distance} des Radius ab. Jetzt {mode} er, und der Boden drückt mit {normal} des Gewichts.',
      none: 'Ohne Trägheit. Jetzt {mode} er, und der Boden drückt mit {normal} des Gewichts.',
    },
  },
  liftoff: {
    title:
      'Der Augenblick des Abhebens: die Normalkraft N und der Spalt unter dem Rand, größer gezeichnet, als er ist.',
    shows:
      'Ein Reifen im Augenblick des Abhebens, und Kurven der Normalkraft und des Spalts über der Zeit.',
    controls: {
      push: 'Stoß, √(g/R)',
      normal: 'N',
      gap: 'Spalt',
      instant: 'Abheben',
      of: 'Zeit',
      force: 'N, und der Spalt × {times}',
    },
    says: {
      before: 'Vor dem Abheben: der Rand rutscht, und der Boden drückt mit {normal} des Gewichts.',
      after: 'Nach dem Abheben: nichts berührt den Rand. Der Spalt ist {gap} des Radius.',
    },
  },
  map: {
    title:
      'Was aus jedem Anfang dieses Reifens wird: quer der Winkel des Gewichts, hoch die Drehung.',
    shows:
      'Eine Karte der Anfänge, mit der Farbe dessen, was aus ihnen wird, und die Bahn einer Bewegung darauf.',
    controls: {
      angle: 'Winkel des Gewichts',
      rate: 'Drehung, √(g/R)',
      lifts_off_later: 'springt später',
      in_contact: 'verlässt den Boden nie',
    },
    says: {
      leaves_at_once: 'Von hier verlässt er den Boden sofort.',
      lifts_off_later: 'Von hier bleibt er eine Weile am Boden, und dann springt er.',
      rolls_forever: 'Von hier rollt er ewig.',
      stays: 'Von hier verlässt er den Boden nie.',
    },
  },
  race: {
    title:
      'Drei Reifen von einem Anfang, jeder auf seiner Bahn. Der Balken am Boden ist der Sprung.',
    shows:
      'Drei Bahnen untereinander, auf jeder ein Reifen; der Boden unter einem Sprung ist markiert.',
    controls: {
      angle: 'Gewicht von oben, am Anfang',
      push: 'Stoß, √(g/R)',
      massless: 'Littlewoods Reifen',
      light: 'der leichte Reifen',
      real: 'der wirkliche Reifen',
    },
    says: {
      ask: 'Wer springt, und wer zuerst? Rate, und spiel es ab.',
      now: '{name} {mode}',
      over: 'hat sein Gewicht am Boden',
      landed: 'ist gelandet',
      hopped:
        '{name} springt nach {time} √(R/g), {place} Radien vom Anfang, um {angle} gedreht, und steigt um {height} seines Radius',
      atOnce: '{name} verlässt den Boden sofort und steigt um {height} seines Radius',
      stayed: '{names} springt nie',
      late: '{names} springt erst nach dem Rennen',
      and: 'und auch',
    },
  },
  angle: {
    title:
      'Drei Reifen, die in einem Winkel abheben: ein Hula-Hoop-Reifen mit einer Batterie, eine Scheibe mit einer Perle, und ein leichter Reifen mit einem schweren Gewicht.',
    shows:
      'Drei Reifen nebeneinander in der Luft, jeder mit dem Winkel, um den er sich seit dem Abheben gedreht hat.',
    controls: {
      angle: 'Abheben vor dem höchsten Punkt',
      first: 'Hula-Hoop-Reifen',
      second: 'Scheibe',
      third: 'leichter Reifen',
      progress: 'Flug',
    },
    says: {
      turned:
        'Sie heben {angle} vor dem höchsten Punkt ab. In der Luft dreht sich der erste um {first}, der zweite um {second}, der dritte um {third}.',
      task: 'Schaffst du eine Umdrehung, {whole}, bis auf {close}?',
      more: 'Es fehlen {by}.',
      less: 'Es sind {by} zu viel.',
      done: 'Einmal herum, in der Luft! Bewegungen des Reglers: {tries}.',
    },
  },
  film: {
    title:
      'Was ein Telefon von dem Sprung sieht, wenn unser Reifen so groß wie ein Hula-Hoop-Reifen ist: ein Bild nach dem anderen. Ein eigener Film bleibt auf deinem Gerät.',
    shows:
      'Der Reifen und sein Gewicht, wie eine Kamera sie in gleichen Abständen sieht, vom letzten Rutschen bis zur Landung.',
    controls: {
      rate: 'Bilder in der Sekunde',
      own: 'Mit einem eigenen Film vergleichen',
      mark: 'Der Film zeigt jetzt das Abheben',
      film: 'Dein Film',
    },
    says: {
      seen: 'Bei {rate} Bildern in der Sekunde zeigen {count} ihn in der Luft, {time} s lang. Vom ersten bis zum letzten dreht er sich um {turned}; der genaue Winkel ist {exact}. Das Rutschen vorher dauert {slip} Bilder.',
    },
  },
  bounce: {
    title: 'Die Bewegung von Figure 3 der Arbeit, die landet und weitergeht.',
    shows:
      'Ein gelandeter Reifen hüpft am Boden entlang; eine Kurve des Spalts unter dem Rand über der Zeit.',
    controls: { gap: 'Spalt', of: 'Zeit' },
    says: {
      bounces:
        'Der Rand schlägt {count}-mal auf, und die letzten Stöße sind nicht zu zählen. Dann {mode} er.',
      counted: 'Der Rand schlägt in der gezeigten Zeit {count}-mal auf.',
      never: 'Der Rand kommt einmal herunter und bleibt. Dann {mode} er.',
    },
  },
  jam: {
    title:
      'Ein leichter Reifen rutscht nach rechts, mit dem Gewicht hoch. Die Kurve ist sein Rutschen.',
    shows:
      'Ein Reifen, der rutscht, mit der Kraft des Bodens, und eine Kurve des Rutschens über der Zeit.',
    controls: { mu: 'Reibungszahl μ', slip: 'Rutschen', of: 'Zeit' },
    says: {
      jams: 'Er verklemmt: das Rutschen endet sofort, bevor Zeit vergangen ist.',
      slides: 'Er rutscht {time} √(R/g) lang, mit bis zu {normal} des Gewichts angedrückt.',
    },
  },
  ramp: {
    title: 'Eine Scheibe mit einem Stab darin, auf einer Rampe aus der Ruhe losgelassen.',
    shows: 'Eine Scheibe mit einem Gewicht im Innern rollt einen Hang hinunter und springt.',
    controls: { slope: 'Neigung', release: 'Gewicht von oben, beim Loslassen' },
    says: {
      jumps:
        'Sie rollt, rutscht und springt. Mit einem Radius von {radius} ist ihr letztes Rutschen vor dem Sprung {slip}.',
      stays: 'Sie verlässt diesen Hang nie.',
    },
  },
  climb: {
    title:
      'Eine beladene Scheibe, aus der Ruhe losgelassen auf einem Hang, der nach rechts steigt.',
    shows: 'Eine Scheibe mit einem Gewicht im Innern rollt einen Hang hinauf.',
    controls: { slope: 'Neigung', release: 'Gewicht bergauf von oben, beim Loslassen' },
    says: {
      climbs: 'Sie steigt: ihre Mitte hebt sich um {height} ihres Radius.',
      falls: 'Sie steigt nicht: sie rollt sofort bergab.',
    },
  },
  answer: {
    title:
      'Jeder Punkt ist ein Reifen, der mit dem Gewicht oben beginnt. Weiter rechts wird er stärker gestoßen; weiter oben ist sein Gewicht schwerer und sein Rand leichter. Leg den Ring auf deinen.',
    shows:
      'Eine Karte von Reifen, von leichten zu schweren Gewichten, und von Stößen: welche springen, welche bleiben, und welche den Boden sofort verlassen.',
    controls: {
      share: 'das Gewicht, als Teil der ganzen Masse',
      push: 'wie stark er gestoßen wird, √(g/R)',
      mu: 'Reibungszahl μ',
      lifts_off_later: 'springt',
      rolls_forever: 'bleibt am Boden',
    },
    says: {
      hops: 'Er springt: er steigt um {height} seines Radius.',
      atOnce: 'Er hebt sofort ab, ohne gerollt zu sein.',
      stays: 'Er springt nicht.',
    },
  },
};

export const MODES: StoryTexts['MODES'] = {
  rolling: '<rolling:rollt>',
  sliding: '<sliding:rutscht>',
  gliding: '<gliding:gleitet>',
  flight: '<flight:fliegt>',
  rest: '<rest:ruht>',
  skidding: '<skidding:rutscht ohne Drehung>',
};

export const SOURCES: StoryTexts['SOURCES'] = {
  heading: 'Quellen',
  list: {
    ...ENGLISH_SOURCES.list,
    gliding:
      'A. Bronars und O. M. O’Reilly, *Gliding motions of a rigid body: the curious dynamics of Littlewood’s rolling hoop*, Proc. R. Soc. A 475 (2019). Littlewoods Absatz und was Tokieda, Butler und Ivanov taten, ist so erzählt wie in dieser Arbeit.',
    film: 'Stand-up Maths, *The 56-year argument about a hopping hoop*, ein Film auf YouTube, 2023.',
    rough:
      'A. A. Aglaev und A. K. Kovaldzhi, *Dynamics of a hopping hoop with a massive point on an absolutely rough plane*, Memoirs of the Faculty of Physics, Moscow State University (2024), no. 6, 2460102. Nach der Zusammenfassung; hier übersetzt.',
    cylinder:
      'E. A. Arroyo und M. Aparicio Alcalde, *The jump effect of a general eccentric cylinder rolling on a ramp*, arXiv:2303.09420. Nach der Zusammenfassung.',
  },
};

export const SHEET: StoryTexts['SHEET'] = {
  title: 'Springt der Reifen? Ein Blatt für den Unterricht',
  lede: 'Drei Stunden um ein Spielzeug: einen Reifen mit einem Gewicht am Rand. Du brauchst einen Hula-Hoop-Reifen (oder einen Stickrahmen, oder eine Scheibe aus Schaum), eine Batterie oder eine Schraube, Klebeband und ein Telefon. Die Bilder sind in der Geschichte, die Zahlen lassen sich im Labor ändern.',
  print: 'Drucken, oder als PDF speichern',
  story: 'Die Geschichte',
  lessons: [
    {
      heading: 'Erste Stunde: was der Boden kann',
      text: 'Spiel die Frage der Geschichte ab; lass alle raten. Zieh am Gewicht von Littlewoods Reifen und finde, wo *N* null ist ({rolling.zero}). Dann der Reibungskegel: mit μ = {cone.mu} rutscht er bei {cone.angle}. Warum zeigt die Kraft eines gewichtslosen Reifens auf das Gewicht?',
    },
    {
      heading: 'Zweite Stunde: wann er abhebt',
      text: 'Schwache Stöße rollen, starke fliegen sofort, und dazwischen springt der Reifen: mit einem Gewicht von {story.ratio}-mal der Masse des Randes zwischen {push.least} und {push.most} √(g/R). Probier es auf einem Tisch. Beim Abheben hält das Kreisen des Schwerpunkts der Schwerkraft die Waage. Achte auf den Spalt: warum kann niemand den Augenblick sehen?',
    },
    {
      heading: 'Dritte Stunde: ein Winkel',
      text: 'Filme einen Sprung von der Seite und miss zwei Winkel: den des Gewichts vor dem höchsten Punkt beim Abheben, und den, um den es sich bis zur Landung in der Luft dreht. Vergleiche mit den drei Reifen der Geschichte: {angle.example} gibt {angle.turned}, bei jedem Reifen.',
    },
  ],
  measure: {
    heading: 'Was man mit einem Telefon misst',
    items: [
      'Stell das Telefon fest hin, in der Höhe des Reifens, und filme längs seiner Achse mit {film.rate} Bildern in der Sekunde oder mehr. In gutem Licht sind die Bilder scharf.',
      'Kleb einen hellen Punkt auf das Gewicht, einen zweiten gegenüber. Der Winkel der Linie zwischen ihnen braucht kein Lineal.',
      'Das letzte Bild, in dem der Rand den Boden berührt, ist ein wenig zu spät: der Spalt öffnet sich mit der dritten Potenz der Zeit. Leg in der Luft eine Gerade durch den Winkel und geh auf ihr zurück.',
      'Der Reifen des Films der Geschichte, so groß wie ein Hula-Hoop-Reifen, ist {film.time} s in der Luft: {film.count} Bilder.',
    ],
  },
  questions: {
    heading: 'Fragen und Antworten',
    list: [
      [
        'Heißt *N* = 0, dass ein Reifen springt?',
        'Nein. Wo das Gewicht fällt, rutscht der Reifen stattdessen.',
      ],
      [
        'Warum kann Littlewoods Reifen nicht springen?',
        'Sein Rand hat keine Trägheit, also kann der Boden ihm keinen Stoß geben: er gleitet.',
      ],
      [
        'Ein Gewicht ist beim Abheben {angle.example} vor dem höchsten Punkt: wie weit dreht sich der Reifen auf dem Mond?',
        'Auch um {angle.turned}: die Schwerkraft fällt heraus.',
      ],
      [
        'Bei welchem Winkel des Abhebens dreht er sich genau einmal?',
        'Bei {angle.whole}, wo der Tangens des Winkels π ist.',
      ],
      [
        'Kann ein Reifen springen, ohne vorher zu rutschen?',
        'Aus dem Rollen auf ebenem Boden nie; auf einer Rampe in einer Bewegung von allen.',
      ],
      [
        'Warum steigt eine beladene Scheibe einen Hang hinauf?',
        'Ihr Gewicht fällt tiefer, als die Scheibe sich hebt. Im Bild der Geschichte steigt die Scheibe um {climb.height} ihres Radius.',
      ],
    ],
  },
  foot: 'Modell: A. Bronars und O. M. O’Reilly, Proc. R. Soc. A, 2019. Alle Zahlen berechnet die Bibliothek littlewood.',
};
