/* All that the page says, in one place: a translation is one more table of the same names. {x} stands for a value. */
const ENGLISH = {
  skip: "Skip to the drawing",
  /* bar on top */
  home: "sketch2shape: start page", fresh: "New", freshTip: "A new sheet", openFile: "Open", openTip: "Open a picture, a PDF page or a corrections file",
  openFolder: "Folder", openFolderTip: "A folder of pictures, as a filmstrip", photo: "Photo", photoTip: "Take a photo of a drawing",
  undo: "Undo", undoTip: "Ctrl+Z", redo: "Redo", redoTip: "Ctrl+Shift+Z", share: "Link", shareTip: "A link that holds this drawing",
  take: "Download", takeTip: "The solid as a file", saveCorrections: "Save corrections", chooseFile: "Open a picture, or a corrections file", chooseFolder: "Open a folder of pictures",
  choosePhoto: "Take a photo",
  /* first screen */
  claim: "Draw it. Turn it. Print it.", claimMore: "Sketch a box, a house, a cylinder, a bracket: it stands up in three dimensions while you draw.",
  startDraw: "Draw", startOpen: "Open a picture", startPhoto: "Take a photo", startExample: "Or try one of these", dropHere: "Drop a picture anywhere, or paste one.",
  heroSketch: "A drawing of a bracket", heroSolid: "The bracket as a turning solid",
  goOn: "Go on with your drawing", goOnTip: "It was kept in this browser",
  /* paper */
  paper: "Drawing", pen: "Pen", penTip: "Draw: straight lines become straight, curves stay round (P)", hiddenPen: "Hidden", hiddenTip: "Draw a hidden edge, dashed (D)",
  erase: "Erase", eraseTip: "Rub lines out (E)", select: "Select", selectTip: "Select and move lines or corners (S)", hand: "Move", handTip: "Move the sheet (space, or two fingers)",
  grid: "Grid", gridNone: "No grid", gridSquare: "Squares", gridIsometric: "Isometric", clear: "Clear", clearTip: "Rub everything out; Undo brings it back",
  byNumbers: "Numbers", byNumbersTip: "A line by the numbers of its ends", adjust: "Corners", adjustTip: "Move corners, say which face is the front", backToPen: "Draw on", tools: "Tools",
  zoomIn: "Zoom in", zoomOut: "Zoom out", zoomFit: "Fit", zoomFitTip: "Fit the drawing",
  padLabel: "Drawing sheet. Arrow keys move the pen by ten, with Shift by one; Enter puts it down and lifts it; Escape cancels; or use Numbers. N and B go from line to line; the arrow keys move that one, Delete removes it.",
  lineChosen: "Line {n} of {of}, from {x1}, {y1} to {x2}, {y2}.", penAt: "Pen at {x}, {y}.", penDown: "Pen down at {x}, {y}.", lineDrawn: "Line to {x}, {y}.",
  hintPad: "Draw all edges; hidden ones if you like.", hintDone: "Type its sizes on it, turn it, download it; or draw on.",
  hintErase: "Drag over lines to rub them out.", hintSelect: "Tap a line to select it, drag a corner to move it; Delete removes what is selected.",
  hintHand: "Drag the sheet; two fingers zoom, so does Ctrl with the wheel.",
  dontMeet: "These two lines do not meet", missingEdge: "An edge is missing here", looseEnd: "This end meets no line", unsure: "Only a guess",
  dontMeetCount: "{n} places where two lines do not meet", looseCount: "{n} loose ends", missingCount: "{n} edges are missing", leftCount: "{n} red lines fit no solid", leftOne: "the red line fits no solid",
  dontMeetOne: "1 place where two lines do not meet", looseOne: "1 loose end", missingOne: "1 edge is missing", joinThem: "Join them",
  /* numbers dialogue */
  numbersTitle: "A line by numbers", numbersHelp: "Places on the sheet, from its top left corner, to the right and down.", fromX: "From x", fromY: "From y", toX: "To x", toY: "To y", addLine: "Add the line",
  /* vertices */
  move: "Move", moveTip: "Drag vertices (M)", add: "Add", addTip: "Click near an edge (A)", remove: "Delete", removeTip: "Click a vertex (X)", exchange: "Exchange", exchangeTip: "A vertex changes places with its partner (F)",
  trace: "Trace", traceTip: "Click around the front face (T)", front: "Front", frontTip: "This is the front: click the face that looks at you (R)",
  object: "Object", together: "Move both faces together", swap: "Swap front and back", keyFront: "front", keyBack: "back", keyJoin: "between",
  editorLabel: "The drawing with its vertices. Arrow keys move a cross by ten, with Shift by one; Enter does there what a click does. Tab goes from vertex to vertex, arrow keys move it, Delete removes it, F exchanges it with its partner.",
  pointAt: "At {x}, {y}.",
  hintMove: "Drag a vertex; drag beside it to move the drawing.",
  hintAdd: "Click near an edge to put a vertex into it; its partner on the other face comes with it.",
  hintRemove: "Click a vertex to delete it with its partner.",
  hintExchange: "Click a vertex to give it to the other face. Loose vertices go from none to front to back.",
  hintTrace: "Click around the front face, corner by corner; click the first one again to close it. A ring inside a face is a hole.",
  hintTraceBack: "Now click where the marked corner lies on the back face.", hintFront: "Click inside the face that looks at you.",
  vertexFront: "Front vertex {n}", vertexBack: "Back vertex {n}", vertexLoose: "Loose vertex {n}", ofHole: "of hole {n}", at: "at {x}, {y}",
  /* solid */
  solid: "Solid", solidLabel: "The solid in three dimensions. Arrow keys turn it, plus and minus zoom, 0 resets, H hides hidden edges, W shows lines only.",
  solidEmpty: "The solid stands up here while you draw.", sureYes: "sure", sureNo: "please check", byHand: "changed by hand", guess: "only a guess",
  viewFront: "Front", viewTop: "Top", viewSide: "Side", viewHome: "3-D", views: "Views", wireframe: "Lines", wireframeTip: "Lines only (W)", hiddenEdges: "Hidden", hiddenEdgesTip: "Show hidden edges (H)",
  section: "Cut", sectionTip: "Cut the solid open", sectionLabel: "Where the cut is", measure: "Measure", measureTip: "Click two corners of the solid", measured: "{d} between the two corners", measureFirst: "Click two corners of the solid; or N for the next one, Enter to take it.",
  full: "Full", bed: "Bed", bedTip: "A print bed of 220 by 220 mm, once a real size is given", fold: "Fold", foldTip: "See the drawing fold into the solid", cube: "View cube: click a face to look at it",
  sizes: "Sizes", width: "Width", height: "Height", depth: "Depth", unit: "Unit", free: "assumed", freeTip: "The drawing does not tell this size: type it in", projection: "Drawn as",
  auto: "tell from the drawing", oblique: "front face as it is (oblique)", axonometric: "seen at an angle (isometric and the like)", perspective: "in perspective",
  badNumber: "Not a length. Try 40, 40.5 or 40,5.", editSize: "{name}: {value} {unit}. Click to change.",
  which: "Which did you mean?", whichOne: "Reading {n}: {name}, {size}",
  volume: "Volume", facts: "{w} wide, {h} high, {d} deep{unit}.", noSize: "No real size yet: type one in.", takeAnyway: "Take it anyway",
  steps: "How it was found", again: "Draw again with my changes",
  /* messages */
  welcome: "Draw a solid, open a picture of one, or pick an example.", looking: "Looking at {name}…", queue: "{n} before you in the queue…",
  found: "Found the object in {name}. If a corner is wrong, drag it to its place.", foundMany: "Found {n} objects in {name}.", foundLive: "That is a solid: {what}.",
  foundNot: "No object was found: {why}. Trace it by hand: click around its front face.", guessedLive: "Only a guess yet: some lines fit no solid.", begun: "A solid begins to stand up: go on, or take it as it is.", guessed: "Only a guess, shown pale: {why}. Put it right, or take it anyway.", leftOver: "the lines marked red fit no solid", follows: "The solid follows your changes.",
  kept: "Your work is kept in this browser.", needMore: "Go on drawing: no solid can be seen yet.",
  downloaded: "{name} is in your downloads.", copied: "The link is in the clipboard.", linkLong: "The drawing is too large for a link: send the file of Save corrections.",
  linkBad: "The link does not hold a whole drawing.", pictureFirst: "Open the picture first, then its corrections.", notCorrections: "{name} is not a corrections file: {why}",
  tooLarge: "{name} is larger than {most} MB. Try: a smaller picture.", cannotRead: "{kind} cannot be read here. Try: save it as PNG or JPEG, or install sketch2shape[formats].",
  noAnswer: "The program does not answer. Try: is it still running?", answered: "it answered {status}", tryThis: "Try: {advice}.",
  loose: "{front} front and {back} back vertices; {none} still without a face: click them with Exchange.", looseUneven: "The front face has {front} vertices and the back face {back}: they need as many as each other, at least three.",
  page: "Page", pages: "Page {n} of {of}", strip: "Pictures of the folder", stripWait: "waiting", stripBad: "look at this", stripGood: "fine", noPictures: "There is no picture in this folder.",
  cameraTitle: "Take a photo", shoot: "Take it", cameraNone: "No camera can be used here: {why}", working: "Working",
  /* question, download, link */
  ask: "Drop this drawing?", askMore: "Undo cannot bring it back from another drawing. Save it first if you need it.", drop: "Drop it", keepIt: "Keep it", cancel: "Cancel", close: "Close",
  takeTitle: "Take the solid away", takeFormat: "Format", forPrint: "For printing and CAD", asProgram: "As a program", asPlan: "On paper", asDrawing: "As a drawing", asPicture: "To show", asReport: "For programs", takeSize: "No size was given. Make the longest side", takeStands: "It stands upright on the print bed.",
  takeIt: "Download", linkTitle: "A link with the whole drawing", linkHelp: "The drawing is in the part after #, which a browser never sends to a server.", copy: "Copy",
};

let table = ENGLISH;

/* the words of this name, with the values in their places */
export function say(name, values = {}) {
  return (table[name] ?? name).replace(/\{(\w+)\}/g, (_, key) => values[key] ?? "");
}

/* one or many of something: "looseOne" or "looseCount" */
export const count = (name, n) => say(n === 1 ? `${name}One` : `${name}Count`, { n });

/* put the words into a part of the page: data-say is the text, data-label the name, data-tip the tooltip */
export function fill(root) {
  for (const e of root.querySelectorAll("[data-say]")) e.textContent = say(e.dataset.say);
  for (const e of root.querySelectorAll("[data-label]")) e.setAttribute("aria-label", say(e.dataset.label));
  for (const e of root.querySelectorAll("[data-tip]")) e.title = say(e.dataset.tip);
}

/* another language: a table that may lack names */
export function speak(other) { table = { ...ENGLISH, ...other }; }
