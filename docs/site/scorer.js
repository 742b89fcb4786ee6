// How the search ranks pages: as Sphinx does by itself, but what names everything, as a list of changes does, comes last.

// The search declares the same name if it is not there.
var Scorer = {
  score: ([docname, , , , score]) => (/^(CHANGELOG|CONTRIBUTING|DESIGN)$/.test(docname) ? score / 100 : score),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
