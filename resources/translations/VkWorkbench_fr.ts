<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The machining strategy recognized from the toolpath.</source>
        <translation>Stratégie d&apos;usinage reconnue à partir du parcours d&apos;outil.</translation>
    </message>
    <message>
        <source>The reason for this strategy.</source>
        <translation>La raison de cette stratégie.</translation>
    </message>
    <message>
        <source>The text of the mark in the description.</source>
        <extracomment>The results of this session.</extracomment>
        <translation>Le texte de la marque dans la description.</translation>
    </message>
    <message>
        <source>The confidence of the recognition, in percent.</source>
        <translation>La confiance de la reconnaissance, en pour cent.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what to know before simulating it.</source>
        <translation>Les problèmes de l&apos;opération, et ce qu&apos;il faut savoir avant de la simuler.</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Longueur des mouvements d&apos;usinage.</translation>
    </message>
    <message>
        <source>Time on the machine.</source>
        <translation>Temps sur la machine.</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows.</source>
        <translation>Temps estimé de la simulation que montre la marque.</translation>
    </message>
</context>
<context>
    <name>Pills</name>
    <message>
        <source>outdated</source>
        <translation>périmé</translation>
    </message>
    <message>
        <source>{} operation</source>
        <translation>{} opération</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} opérations</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Ce résultat est périmé, car le parcours, l&apos;outil ou le brut a changé. Analysez l&apos;opération à nouveau.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known. Analyze the operation again.</source>
        <translation>Le temps dans « {simulator} » n&apos;est pas connu. Analysez l&apos;opération à nouveau.</translation>
    </message>
    <message>
        <source>{strategy}, confidence {share}</source>
        <translation>{strategy}, confiance {share}</translation>
    </message>
    <message>
        <source>Cutting length: {length}.</source>
        <translation>Longueur de coupe : {length}.</translation>
    </message>
    <message>
        <source>Machining time: {time}. Cutting length: {length}.</source>
        <translation>Durée d&apos;usinage : {time}. Longueur de coupe : {length}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Temps de simulation dans « {simulator} » : {time}. Mémoire : {memory}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: at least {time}. Memory: {memory}.</source>
        <translation>Temps de simulation dans « {simulator} » : au moins {time}. Mémoire : {memory}.</translation>
    </message>
    <message>
        <source>Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Temps de simulation de cette seule opération dans « {simulator} » : {time}. Mémoire : {memory}.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivée</translation>
    </message>
    <message>
        <source>sim {time}</source>
        <translation>sim. {time}</translation>
    </message>
    <message>
        <source>at least {time}</source>
        <translation>au moins {time}</translation>
    </message>
    <message>
        <source>Machining time at constant feed: {time}. Cutting length: {length}.</source>
        <translation>Durée d&apos;usinage à avance constante : {time}. Longueur de coupe : {length}.</translation>
    </message>
    <message>
        <source>Tool changes and starts of the spindle: {time}.</source>
        <translation>Changements d&apos;outil et démarrages de la broche : {time}.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>No move cuts, because there are only rapid moves.</source>
        <translation>Aucun mouvement ne coupe, car il n&apos;y a que des déplacements rapides.</translation>
    </message>
    <message>
        <source>No move cuts, because there are no moves.</source>
        <translation>Aucun mouvement ne coupe, car il n&apos;y a aucun mouvement.</translation>
    </message>
    <message>
        <source>, counter-clockwise</source>
        <translation>, sens antihoraire</translation>
    </message>
    <message>
        <source>, clockwise</source>
        <translation>, sens horaire</translation>
    </message>
    <message>
        <source>descending at a constant radius</source>
        <translation>descendant à rayon constant</translation>
    </message>
    <message>
        <source>the direction of nested loops alternates</source>
        <translation>le sens des boucles emboîtées alterne</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>régulièrement espacées dans le plan, pas en profondeur</translation>
    </message>
    <message>
        <source>with a shape that changes with the depth</source>
        <translation>avec une forme qui change avec la profondeur</translation>
    </message>
    <message>
        <source>a winding with a helical entry or with extra cuts in the corners</source>
        <translation>un enroulement avec entrée hélicoïdale ou coupes supplémentaires dans les coins</translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation>un enroulement qui ne se ferme jamais</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>emboîtées</translation>
    </message>
    <message>
        <source>small loops that advance along the path</source>
        <translation>de petites boucles qui avancent le long du parcours</translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation>une passe ouverte se trouve dans un contour</translation>
    </message>
    <message>
        <source>no nested offsets</source>
        <translation>aucun contour imbriqué</translation>
    </message>
    <message>
        <source>half-turns alternate in sign</source>
        <translation>les demi-tours alternent de signe</translation>
    </message>
    <message>
        <source>all rows run the same way</source>
        <translation>toutes les lignes vont dans le même sens</translation>
    </message>
    <message>
        <source>open contours change with the depth</source>
        <translation>des contours ouverts changent avec la profondeur</translation>
    </message>
    <message>
        <source>one open contour</source>
        <translation>un seul contour ouvert</translation>
    </message>
    <message>
        <source>an open contour is repeated</source>
        <translation>un contour ouvert est répété</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>des traits ouverts aussi longs que la pièce</translation>
    </message>
    <message>
        <source>short strokes that do not fill an area</source>
        <translation>des traits courts qui ne remplissent pas de surface</translation>
    </message>
    <message>
        <source>The toolpath has no cutting move.</source>
        <translation>Le parcours n&apos;a aucun mouvement de coupe.</translation>
    </message>
    <message>
        <source>The operation has no toolpath. Recompute it and read FreeCAD&apos;s report view.</source>
        <translation>L&apos;opération n&apos;a pas de parcours. Recalculez-la et lisez la vue rapport de FreeCAD.</translation>
    </message>
    <message>
        <source>The operation has no tool. Give it a tool controller.</source>
        <translation>L&apos;opération n&apos;a pas d&apos;outil. Donnez-lui un contrôleur d&apos;outil.</translation>
    </message>
    <message>
        <source>{label} has no tool. Choose a tool bit for it.</source>
        <translation>{label} n&apos;a pas d&apos;outil. Choisissez-lui-en un.</translation>
    </message>
    <message>
        <source>The tool in {label} has no diameter. Enter one in its tool bit.</source>
        <translation>L&apos;outil dans {label} n&apos;a pas de diamètre. Donnez-lui-en un.</translation>
    </message>
    <message>
        <source>The toolpath has no stock. Put it into a job.</source>
        <translation>Le parcours n&apos;a pas de brut. Mettez-le dans une tâche.</translation>
    </message>
    <message>
        <source>{label} has no stock. Give it one in the job&apos;s settings.</source>
        <translation>{label} n&apos;a pas de brut. Donnez-lui-en un dans les réglages de la tâche.</translation>
    </message>
    <message>
        <source>The simulation cost of {labels} is unknown.</source>
        <translation>Le coût de simulation est inconnu pour {labels}.</translation>
    </message>
    <message>
        <source>Words without a motion before them are ignored.</source>
        <translation>Les mots sans mouvement avant eux sont ignorés.</translation>
    </message>
    <message>
        <source>A feed rate that is not a usable number is ignored.</source>
        <translation>Une avance qui n&apos;est pas un nombre utilisable est ignorée.</translation>
    </message>
    <message>
        <source>Center words (I, J, K) that are not usable numbers are ignored.</source>
        <translation>Les mots de centre (I, J, K) qui ne sont pas des nombres utilisables sont ignorés.</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored.</source>
        <translation>Les mots {letter} qui ne sont pas des nombres utilisables sont ignorés.</translation>
    </message>
    <message>
        <source>Positions farther than a kilometer from the origin are limited to a kilometer.</source>
        <translation>Les positions à plus d&apos;un kilomètre de l&apos;origine sont limitées à un kilomètre.</translation>
    </message>
    <message>
        <source>A drilling cycle without a depth (Z) drills no hole.</source>
        <translation>Un cycle de perçage sans profondeur (Z) ne perce pas de trou.</translation>
    </message>
    <message>
        <source>A drilling cycle without R starts at the current height.</source>
        <translation>Un cycle de perçage sans R commence à la hauteur actuelle.</translation>
    </message>
    <message>
        <source>An arc with an unknown start is ignored.</source>
        <translation>Un arc dont le début est inconnu est ignoré.</translation>
    </message>
    <message>
        <source>An arc without a usable center or radius is read as a line.</source>
        <translation>Un arc sans centre ni rayon utilisables est lu comme une droite.</translation>
    </message>
    <message>
        <source>An arc that does not end on its circle is read with a changing radius.</source>
        <translation>Un arc qui ne finit pas sur son cercle est lu avec un rayon variable.</translation>
    </message>
    <message>
        <source>without an X or Y word</source>
        <translation>sans mot X ou Y</translation>
    </message>
    <message>
        <source>without a Z word</source>
        <translation>sans mot Z</translation>
    </message>
    <message>
        <source>without a center</source>
        <translation>sans centre</translation>
    </message>
    <message>
        <source>that is a full circle</source>
        <translation>qui est un cercle complet</translation>
    </message>
    <message>
        <source>Leave this operation out of the simulation.</source>
        <translation>Laissez cette opération hors de la simulation.</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>trop bas</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>trop haut</translation>
    </message>
    <message>
        <source>Move its accuracy slider to the left.</source>
        <translation>Déplacez son curseur de précision vers la gauche.</translation>
    </message>
    <message>
        <source>Simulate fewer operations at a time.</source>
        <translation>Simulez moins d&apos;opérations à la fois.</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>la mémoire</translation>
    </message>
    <message>
        <source>time</source>
        <translation>le temps</translation>
    </message>
    <message>
        <source>None, because not even a single pixel fits into the memory.</source>
        <translation>Aucune, car même un seul pixel ne tient pas en mémoire.</translation>
    </message>
    <message>
        <source>The cost is estimated for a stock that is a box around the cuts.</source>
        <translation>Le coût est estimé pour un brut qui est un bloc autour des coupes.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock. Check its depths, its placement and the stock.</source>
        <translation>L&apos;opération ne touche pas le brut. Vérifiez ses profondeurs, son placement et le brut.</translation>
    </message>
    <message>
        <source>The tool is wider than the stock. Check the tool&apos;s diameter and the stock.</source>
        <translation>L&apos;outil est plus large que le brut. Vérifiez le diamètre de l&apos;outil et le brut.</translation>
    </message>
    <message>
        <source>Choose a smaller image in the preferences.</source>
        <translation>Choisissez une image plus petite dans les préférences.</translation>
    </message>
    <message>
        <source>that sweeps no angle</source>
        <translation>qui ne balaie aucun angle</translation>
    </message>
    <message>
        <source>about {number}</source>
        <translation>environ {number}</translation>
    </message>
    <message>
        <source>{number}%</source>
        <translation>{number} %</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>The corner radius must be between 0 and {radius:mm}, not {corner:mm}.</source>
        <translation>Le rayon de coin doit être entre 0 et {radius:mm}, pas {corner:mm}.</translation>
    </message>
    <message>
        <source>The tip angle must be between 0 and pi, not {angle:g}.</source>
        <translation>L&apos;angle de pointe doit être entre 0 et π, pas {angle:g}.</translation>
    </message>
    <message>
        <source>The stock has no volume. Its upper corner must exceed its lower corner in x, y and z.</source>
        <translation>Le brut n&apos;a pas de volume. Son coin supérieur doit dépasser l&apos;inférieur en x, y et z.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de coupe dans {count:n} mouvement sans avance.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de coupe dans {count:n} mouvements sans avance.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} is 0.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de déplacements rapides, car {name} du contrôleur d&apos;outil vaut 0.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} and {other} are 0.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de déplacements rapides, car {name} et {other} du contrôleur d&apos;outil valent 0.</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> et {count:n} autres</translation>
    </message>
    <message>
        <source> Passes {step:mm3} apart need {cell:mm2}.</source>
        <translation> Des passes espacées de {step:mm3} demandent {cell:mm2}.</translation>
    </message>
    <message>
        <source> For passes {step:mm3} apart, {cell:mm2} is fine enough.</source>
        <translation> Pour des passes espacées de {step:mm3}, {cell:mm2} suffisent.</translation>
    </message>
    <message>
        <source>None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}</source>
        <translation>Aucune, car les mouvements seuls prennent {time:s}. Simulez moins d&apos;opérations.{heaviest}</translation>
    </message>
    <message>
        <source> The slowest is {label} with {time:s}.</source>
        <translation> La plus lente est {label} avec {time:s}.</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> et 1 autre</translation>
    </message>
    <message>
        <source>Command {command:#}: {sentence}</source>
        <translation>Commande {command:#} : {sentence}</translation>
    </message>
    <message>
        <source>Command {command:#} (first of {count:n}): {sentence}</source>
        <translation>Commande {command:#} (la première de {count:n}) : {sentence}</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored.</source>
        <translation>Le code inconnu {name} est ignoré.</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored.</source>
        <translation>1 autre code inconnu est ignoré.</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored.</source>
        <translation>{count:n} autres codes inconnus sont ignorés.</translation>
    </message>
    <message>
        <source>The arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}. Choose a larger tolerance in the preferences.</source>
        <translation>Les arcs et cycles demanderaient {moves:n} mouvements à une tolérance de {tolerance:mm}. Choisissez une tolérance plus grande dans les préférences.</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label} : {sentence}</translation>
    </message>
    <message>
        <source>The analysis failed. Please report the error together with the file: {error}</source>
        <translation>L&apos;analyse a échoué. Merci de signaler l&apos;erreur avec le fichier : {error}</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur {count:n} lignes{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste à 0 sur {count:n} lignes{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur un trait ouvert{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur {count:n} traits ouverts{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste à 0 sur un trait ouvert{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste à 0 sur {count:n} traits ouverts{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ atteint {reached:turns} tours sur une boucle{spread}, {seen} : {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ atteint {reached:turns} tours sur {count:n} boucles{spread}, {seen} : {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}.</source>
        <translation>φ est entre {low:turns} et {high:turns} tours, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at one point: {strategy:strategy}.</source>
        <translation>φ n&apos;est pas défini, car les mouvements sont verticaux en un point : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}.</source>
        <translation>φ n&apos;est pas défini, car les mouvements sont verticaux en {count:n} points : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at some points: {strategy:strategy}.</source>
        <translation>φ n&apos;est pas défini, car les mouvements sont verticaux en quelques points : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling, show {strategies:strategy}: {strategy:strategy}.</source>
        <translation>{count:n} sections séparées par des changements d&apos;outil, des titres, des retraits ou des perçages montrent {strategies:strategy} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation> espacées de {step:mm3} à {depths:n} profondeurs</translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation> espacées de {step:mm3}</translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation> à {depths:n} profondeurs</translation>
    </message>
    <message>
        <source>{count:n} engagements in the same direction overlap</source>
        <translation>{count:n} engagements de même sens se recouvrent</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) fill the same area</source>
        <translation>des lignes ({rows:%} de la longueur) et des boucles ({loops:%}) remplissent la même surface</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} à {high}</translation>
    </message>
    <message>
        <source>Line {line:#}: {what}</source>
        <translation>Ligne {line:#} : {what}</translation>
    </message>
    <message>
        <source>Line {line:#} (first of {count:n}): {what}</source>
        <translation>Ligne {line:#} (la première de {count:n}) : {what}</translation>
    </message>
    <message>
        <source>Lines with a block delete (/) are read like all others.</source>
        <translation>Les lignes avec saut de bloc (/) sont lues comme les autres.</translation>
    </message>
    <message>
        <source>A subprogram or macro call is ignored.</source>
        <translation>Un appel de sous-programme ou de macro est ignoré.</translation>
    </message>
    <message>
        <source>Jumps, loops and calls are ignored.</source>
        <translation>Les sauts, boucles et appels sont ignorés.</translation>
    </message>
    <message>
        <source>Words with variables or expressions are ignored.</source>
        <translation>Les mots avec des variables ou des expressions sont ignorés.</translation>
    </message>
    <message>
        <source>Lines that do not consist of words like G1 X10 are ignored.</source>
        <translation>Les lignes qui ne sont pas faites de mots comme G1 X10 sont ignorées.</translation>
    </message>
    <message>
        <source>{name} is ignored. The coordinates after it are read as if it were not there.</source>
        <translation>{name} est ignoré. Les coordonnées qui suivent sont lues comme s&apos;il n&apos;était pas là.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as a line.</source>
        <translation>Une spline ({name}) est lue comme une droite.</translation>
    </message>
    <message>
        <source>Lines after the end of the program are ignored.</source>
        <translation>Les lignes après la fin du programme sont ignorées.</translation>
    </message>
    <message>
        <source>Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.</source>
        <translation>Ligne {line:#} : Le programme est écrit pour des commandes {name}. Postez-le en code G (ISO) pour l&apos;analyser.</translation>
    </message>
    <message>
        <source>This is not an NC program. {part:n} of its {lines:n} lines do not consist of words like G1 X10. The first of them is line {line:#}.</source>
        <translation>Ce n&apos;est pas un programme CN. {part:n} de ses {lines:n} lignes ne sont pas faites de mots comme G1 X10. La première est la ligne {line:#}.</translation>
    </message>
    <message>
        <source>This is not an NC program. None of its lines moves a tool.</source>
        <translation>Ce n&apos;est pas un programme CN. Aucune de ses lignes ne déplace un outil.</translation>
    </message>
    <message>
        <source>None of the moves can be read. {problems}</source>
        <translation>Aucun des mouvements ne peut être lu. {problems}</translation>
    </message>
    <message>
        <source>This is not an NC program, because it is not text.</source>
        <translation>Ce n&apos;est pas un programme CN, car ce n&apos;est pas un texte.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it.</source>
        <translation>Ligne {line:#} : {name} indique un programme pour un tour. Les stratégies de fraisage ne s&apos;y appliquent pas.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it.</source>
        <translation>Ligne {line:#} : {name} indique un programme pour une imprimante 3D. Les stratégies de fraisage ne s&apos;y appliquent pas.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it.</source>
        <translation>Ligne {line:#} : {name} indique un programme pour une découpe au fil. Les stratégies de fraisage ne s&apos;y appliquent pas.</translation>
    </message>
    <message>
        <source>Line {line:#}: A rotary axis turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Ligne {line:#} : Un axe rotatif tourne pendant la coupe. Le trajet de l&apos;outil est inconnu ici.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de déplacements rapides, car un programme n&apos;en contient pas la vitesse.</translation>
    </message>
    <message>
        <source>The program does not contain the tool&apos;s diameter, so the cost is unknown.</source>
        <translation>Le programme ne contient pas le diamètre de l&apos;outil, donc le coût est inconnu.</translation>
    </message>
    <message>
        <source>The file cannot be read: {name}.</source>
        <translation>Le fichier ne peut pas être lu : {name}.</translation>
    </message>
    <message>
        <source>The file is larger than {size:bytes}.</source>
        <translation>Le fichier dépasse {size:bytes}.</translation>
    </message>
    <message>
        <source>The analysis was stopped after {time:s}.</source>
        <translation>L&apos;analyse a été arrêtée après {time:s}.</translation>
    </message>
    <message>
        <source>The process that read the file ended unexpectedly, perhaps for lack of memory.</source>
        <translation>Le processus qui lisait le fichier s&apos;est arrêté de façon inattendue, peut-être faute de mémoire.</translation>
    </message>
    <message>
        <source>The toolpath looks 25.4 times too small. Inches are probably read as millimeters.</source>
        <translation>Le parcours semble 25,4 fois trop petit. Des pouces sont probablement lus comme des millimètres.</translation>
    </message>
    <message>
        <source>There is nothing to simulate. Choose a job, or operations with a toolpath.</source>
        <translation>Il n&apos;y a rien à simuler. Choisissez une tâche, ou des opérations avec un parcours d&apos;outil.</translation>
    </message>
    <message>
        <source>These operations belong to several jobs. Choose operations of one job only: {labels}.</source>
        <translation>Ces opérations appartiennent à plusieurs tâches. Choisissez les opérations d&apos;une seule tâche : {labels}.</translation>
    </message>
    <message>
        <source>legacy simulator</source>
        <translation>ancien simulateur</translation>
    </message>
    <message>
        <source>OpenGL simulator</source>
        <translation>simulateur OpenGL</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}</source>
        <translation>« {simulator:simulator} » se bloque sur un arc {reason} (commande {command:#}{others}). {instead}</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>« {simulator:simulator} » usine {count:n} rampe à une profondeur fausse, jusqu&apos;à {error:mm2} {way} (commande {command:#}). Ne jugez pas les profondeurs d&apos;après lui.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>« {simulator:simulator} » usine {count:n} rampes à une profondeur fausse, jusqu&apos;à {error:mm2} {way} (commande {command:#}). Ne jugez pas les profondeurs d&apos;après lui.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.</source>
        <translation>La lecture prend environ {longer:estimate} dans « {simulator:simulator} ». Utilisez l&apos;avance rapide, qui prend environ {time:estimate}.</translation>
    </message>
    <message>
        <source>Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. Simulate fewer operations at a time.</source>
        <translation>La lecture prend environ {time:estimate} dans « {simulator:simulator} » à la plus grande vitesse. Simulez moins d&apos;opérations à la fois.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>{count:n} mouvements sont plus courts qu&apos;une cellule de « {simulator:simulator} » ({cell:mm2}). Ils prennent du temps, mais ne se voient pas. Choisissez une tolérance plus grossière pour l&apos;opération.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>« {simulator:simulator} » prend environ {memory:bytes} pour cette opération, plus que votre limite de {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Use the {simulator:simulator} for this operation.</source>
        <translation>Utilisez « {simulator:simulator} » pour cette opération.</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}.</source>
        <translation>Le diamètre de l&apos;outil doit être positif et d&apos;un kilomètre au plus, pas {diameter:mm}.</translation>
    </message>
    <message>
        <source>The corners of the stock must be numbers within a kilometer of the origin.</source>
        <translation>Les coins du brut doivent être des nombres à moins d&apos;un kilomètre de l&apos;origine.</translation>
    </message>
    <message>
        <source>Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD&apos;s G-code import does not convert them.</source>
        <translation>Les avances jusqu&apos;à {feed:g} mm/s sont lues en mm/min, car l&apos;importation de code G de FreeCAD ne les convertit pas.</translation>
    </message>
    <message>
        <source>The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}.</source>
        <translation>Le diamètre de la pointe doit être compris entre 0 et {diameter:mm}, et non {tip:mm}.</translation>
    </message>
    <message>
        <source>The surface of the solid is not closed.</source>
        <translation>La surface du solide n&apos;est pas fermée.</translation>
    </message>
    <message>
        <source>The stock of {label} is simulated as the box around it. {sentence}</source>
        <translation>Le brut de {label} est simulé comme la boîte qui l&apos;entoure. {sentence}</translation>
    </message>
    <message>
        <source>{label} is simulated only approximately, {instead}.</source>
        <translation>{label} n&apos;est simulé qu&apos;approximativement, {instead}.</translation>
    </message>
    <message>
        <source>as an end mill with its largest diameter</source>
        <translation>comme une fraise droite de son plus grand diamètre</translation>
    </message>
    <message>
        <source>as a ball end mill with the diameter of its tip</source>
        <translation>comme une fraise hémisphérique du diamètre de sa pointe</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>comme un foret</translation>
    </message>
    <message>
        <source>A rotary axis ({letter}) turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Un axe rotatif ({letter}) tourne pendant la coupe. Le trajet de l&apos;outil est inconnu ici.</translation>
    </message>
    <message>
        <source>Moves of a rotary axis ({letter}) are ignored.</source>
        <translation>Les mouvements d&apos;un axe rotatif ({letter}) sont ignorés.</translation>
    </message>
    <message>
        <source>{letter} words are ignored.</source>
        <translation>Les mots {letter} sont ignorés.</translation>
    </message>
    <message>
        <source>The repeats of a cycle ({letter}) are ignored.</source>
        <translation>Les répétitions d&apos;un cycle ({letter}) sont ignorées.</translation>
    </message>
    <message>
        <source>Inches (G20) are ignored. Lengths are read in mm.</source>
        <translation>Les pouces (G20) sont ignorés. Les longueurs sont lues en mm.</translation>
    </message>
    <message>
        <source>Cutter compensation ({name}) is ignored. The programmed path is used.</source>
        <translation>La compensation de rayon ({name}) est ignorée. Le trajet programmé est utilisé.</translation>
    </message>
    <message>
        <source>Feeds after {name} are ignored.</source>
        <translation>Les avances après {name} sont ignorées.</translation>
    </message>
    <message>
        <source>Dwell times are not included in the machining time.</source>
        <translation>Les temporisations ne sont pas comprises dans la durée d&apos;usinage.</translation>
    </message>
    <message>
        <source>open strokes side by side at an even distance</source>
        <translation>traits ouverts côte à côte à distance égale</translation>
    </message>
    <message>
        <source>open strokes side by side, from one wall to the other</source>
        <translation>traits ouverts côte à côte, d&apos;une paroi à l&apos;autre</translation>
    </message>
    <message>
        <source>many small contours of different shapes</source>
        <translation>beaucoup de petits contours de formes différentes</translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}.</source>
        <translation>{count:n} rangée{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}.</source>
        <translation>{count:n} rangées{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One open cut{spread}, {seen}.</source>
        <translation>Une coupe ouverte{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}.</source>
        <translation>{count:n} coupes ouvertes{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One loop{spread}{turning}, {seen}.</source>
        <translation>Une boucle{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}.</source>
        <translation>{count:n} boucles{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>Straight down at one point.</source>
        <translation>Tout droit vers le bas en un point.</translation>
    </message>
    <message>
        <source>Straight down at {count:n} points.</source>
        <translation>Tout droit vers le bas en {count:n} points.</translation>
    </message>
    <message>
        <source>Straight down at some points.</source>
        <translation>Tout droit vers le bas en quelques points.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.</source>
        <translation>{count:n} sections, séparées par des changements d&apos;outil, des titres, des retraits ou du perçage : {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} overlapping engagements</source>
        <translation>{count:n} engagements qui se recouvrent</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>l&apos;une horaire, la suivante antihoraire</translation>
    </message>
    <message>
        <source>all in one continuous cut that never closes</source>
        <translation>tout en une coupe continue qui ne se ferme jamais</translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation>l&apos;une dans l&apos;autre</translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation>aucune dans une autre</translation>
    </message>
    <message>
        <source>cut back and forth</source>
        <translation>coupées en aller et retour</translation>
    </message>
    <message>
        <source>all cut in the same direction</source>
        <translation>toutes coupées dans le même sens</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur une rangée{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ reste à 0 sur une rangée{spread}, {seen} : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It takes time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>Un mouvement est plus court qu&apos;une cellule de « {simulator:simulator} » ({cell:mm2}). Il prend du temps, mais ne se voit pas. Choisissez une tolérance plus grossière pour l&apos;opération.</translation>
    </message>
    <message>
        <source>arranged as in known toolpaths ({share:%} of the votes)</source>
        <translation>disposés comme dans des parcours connus ({share:%} des votes)</translation>
    </message>
    <message>
        <source>unlike any known machining ({share:%} of the votes)</source>
        <translation>différent de tout usinage connu ({share:%} des votes)</translation>
    </message>
    <message>
        <source> The tool enters on a ramp.</source>
        <translation> L&apos;outil entre en rampe.</translation>
    </message>
    <message>
        <source> The tool enters on a ramp that goes back and forth.</source>
        <translation> L&apos;outil entre sur une rampe en aller et retour.</translation>
    </message>
    <message>
        <source> The tool enters on a helix.</source>
        <translation> L&apos;outil entre en hélice.</translation>
    </message>
    <message>
        <source> A contour around the rows finishes the area.</source>
        <translation> Un contour autour des lignes finit la surface.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this simulation: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator} se bloque dans cette simulation : la commande {command:#} de {label}{others} est un arc {reason}.</translation>
    </message>
    <message>
        <source> (also in another operation)</source>
        <translation> (et une autre opération)</translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
        <translation> (et {count:n} autres opérations)</translation>
    </message>
    <message>
        <source>Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}.</source>
        <translation>Lire cette simulation prend {bound} {time:estimate} dans « {simulator:simulator} ».</translation>
    </message>
    <message>
        <source>about</source>
        <translation>environ</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>au moins</translation>
    </message>
    <message>
        <source>Simulate Toolpaths shows the finished part at once, coarse at first.</source>
        <translation>« Simuler l&apos;usinage » montre tout de suite la pièce finie, d&apos;abord grossièrement.</translation>
    </message>
    <message>
        <source>A rapid move removes {volume:mm³2}.</source>
        <translation>Un déplacement rapide enlève {volume:mm³2}.</translation>
    </message>
    <message>
        <source>The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}.</source>
        <translation>L&apos;outil plonge en pleine matière à {feed:mm/min3}. Sa limite est de {allowed:mm/min3}.</translation>
    </message>
    <message>
        <source>{depth:mm2} of stock is left on the model.</source>
        <translation>Il reste {depth:mm2} de brut sur le modèle.</translation>
    </message>
    <message>
        <source>A finer picture would take longer than the {allowed:s} limit in the preferences.</source>
        <translation>Une image plus fine prendrait plus que la limite de {allowed:s} des préférences.</translation>
    </message>
    <message>
        <source>The simulation shows a fault at command {command:#}: {fault}</source>
        <translation>La simulation montre un défaut à la commande {command:#} : {fault}</translation>
    </message>
    <message>
        <source>All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}.</source>
        <translation>Tous les mouvements sont en X et Z, avec des passes le long de Z à de nombreux X, comme sur un tour : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>The placement of the operation must be numbers within a kilometer of the origin.</source>
        <translation>Le placement de l&apos;opération doit être fait de nombres à moins d&apos;un kilomètre de l&apos;origine.</translation>
    </message>
    <message>
        <source>Of two {letter} words in a line, the last one is read.</source>
        <translation>De deux mots {letter} sur une ligne, le dernier est lu.</translation>
    </message>
    <message>
        <source>{told} A small part is {strategies:strategy}.</source>
        <translation>{told} Une petite partie est : {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}</source>
        <translation>{width:n} × {height:n} pixels de {pixel:mm2}, limités par {limit}.{passes}</translation>
    </message>
    <message>
        <source>Lines with variables or expressions are ignored.</source>
        <translation>Les lignes avec des variables ou des expressions sont ignorées.</translation>
    </message>
    <message>
        <source>Moves to machine positions ({name}) are ignored, because the program does not contain these positions.</source>
        <translation>Les déplacements vers des positions de la machine ({name}) sont ignorés, car le programme ne contient pas ces positions.</translation>
    </message>
    <message>
        <source>The holes of a pattern ({name}) are ignored.</source>
        <translation>Les trous d&apos;un motif ({name}) sont ignorés.</translation>
    </message>
    <message>
        <source>The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units.</source>
        <translation>Le parcours s&apos;étend sur des mètres en nombres entiers. Des millièmes sans point décimal sont probablement lus comme des unités entières.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}</source>
        <translation>« {simulator:simulator} » prend {bound} {time:estimate}, plus que votre limite de {allowed:s}. {better}</translation>
    </message>
    <message>
        <source>The centers of arcs are read as positions (as with G90.1). The arcs only close this way.</source>
        <translation>Les centres des arcs sont lus comme des positions (comme avec G90.1). Les arcs ne se ferment qu&apos;ainsi.</translation>
    </message>
    <message>
        <source>strokes that rise toward their ends, as in V-carving</source>
        <translation>des traits qui remontent vers leurs extrémités, comme en gravure en V</translation>
    </message>
    <message>
        <source>cut in strokes, as between holding tags</source>
        <translation>usinées en traits, comme entre des attaches</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored, and the {letters} words of its line with it.</source>
        <translation>Le code inconnu {name} est ignoré, et avec lui les mots {letters} de sa ligne.</translation>
    </message>
    <message>
        <source>Probing moves are not included in the machining time.</source>
        <translation>Les mouvements de palpage ne sont pas compris dans la durée d&apos;usinage.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} into the model.</source>
        <translation>L&apos;outil coupe de {depth:mm2} dans le modèle.</translation>
    </message>
    <message>
        <source>The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}</source>
        <translation>La simulation montre des défauts à {count:n} commandes, par exemple à la commande {command:#} : {fault}</translation>
    </message>
    <message>
        <source>The operation is called {name}, but its toolpath is {strategy:strategy}.</source>
        <translation>L&apos;opération s&apos;appelle {name}, mais son parcours est : {strategy:strategy}.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a zip archive. Unpack it first.</source>
        <translation>Ce n&apos;est pas un programme CN, mais une archive zip. Décompressez-la d&apos;abord.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a folder of documents, use the macro examples/macros/folder_to_csv.py.</source>
        <translation>Ce n&apos;est pas un programme CN, mais un document FreeCAD. Analysez-le dans FreeCAD. Pour un dossier de documents, utilisez la macro examples/macros/folder_to_csv.py.</translation>
    </message>
    <message>
        <source>The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.</source>
        <translation>Le brut est trop petit de {depth:mm2} pour le modèle. Choisissez un brut plus grand ou déplacez le modèle dans le brut.</translation>
    </message>
    <message>
        <source>The operation is switched off. It has no toolpath until you switch it on and recompute it.</source>
        <translation>L&apos;opération est désactivée. Elle n&apos;a pas de parcours tant que vous ne l&apos;activez et ne la recalculez pas.</translation>
    </message>
    <message>
        <source>This is not a file, but a pipe or a device.</source>
        <translation>Ce n&apos;est pas un fichier, mais un tube ou un périphérique.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.</source>
        <translation>L&apos;opération ne touche pas le brut, qui est déjà la pièce finie. Choisissez comme brut un bloc qui l&apos;entoure.</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>La simulation prend environ {memory:bytes} au plus fort, pour {dexels:n} dexels et {traces:n} éléments de trace, plus que votre limite de {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the preferences, or simulate fewer operations.</source>
        <translation>Choisissez dans les préférences une image de {width:n} × {height:n} pixels de {pixel:mm2}, ou simulez moins d&apos;opérations.</translation>
    </message>
    <message>
        <source>A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once.</source>
        <translation>Une profondeur de passe (Q) qui demande plus de {most:n} débourrages est ignorée. Le trou est percé en une fois.</translation>
    </message>
    <message>
        <source>The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). They are read as offsets.</source>
        <translation>Le programme ne montre pas si les centres de ses cercles sont des décalages (G91.1) ou des positions (G90.1). Ils sont lus comme des décalages.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long.</source>
        <translation>L&apos;outil coupe {depth:mm2} plus profond que ses arêtes, longues de {length:mm3}.</translation>
    </message>
    <message>
        <source>The shank collides with material {depth:mm2} high.</source>
        <translation>La queue heurte de la matière haute de {depth:mm2}.</translation>
    </message>
    <message>
        <source>The holder collides with material {depth:mm2} high.</source>
        <translation>Le porte-outil heurte de la matière haute de {depth:mm2}.</translation>
    </message>
    <message>
        <source>The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.</source>
        <translation>L&apos;outil est trop court : il mesure {length:mm3}, et la matière à côté dépasse son extrémité supérieure de {depth:mm2}.</translation>
    </message>
    <message>
        <source>{part} collides with the clamp {clamp}.</source>
        <translation>{part} heurte la bride {clamp}.</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>L&apos;outil</translation>
    </message>
    <message>
        <source>The shank</source>
        <translation>La queue de l&apos;outil</translation>
    </message>
    <message>
        <source>The holder</source>
        <translation>Le porte-outil</translation>
    </message>
    <message>
        <source>{sentences}</source>
        <translation>{sentences}</translation>
    </message>
    <message>
        <source>Shanks were checked.</source>
        <translation>Les queues ont été vérifiées.</translation>
    </message>
    <message>
        <source>Shanks were not checked, because no tool has a cutting edge height and a shank diameter.</source>
        <translation>Les queues n&apos;ont pas été vérifiées, car aucun outil n&apos;a de hauteur de coupe et de diamètre de queue.</translation>
    </message>
    <message>
        <source>The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.</source>
        <translation>Les queues de {labels} n&apos;ont pas été vérifiées, car les outils n&apos;ont pas de hauteur de coupe ou pas de diamètre de queue.</translation>
    </message>
    <message>
        <source>Holders were checked.</source>
        <translation>Les porte-outils ont été vérifiés.</translation>
    </message>
    <message>
        <source>No holder is given.</source>
        <translation>Aucun porte-outil n&apos;est indiqué.</translation>
    </message>
    <message>
        <source>No holder is given for {labels}.</source>
        <translation>Aucun porte-outil n&apos;est indiqué pour {labels}.</translation>
    </message>
    <message>
        <source>1 clamp was checked.</source>
        <translation>1 bride a été vérifiée.</translation>
    </message>
    <message>
        <source>{count:n} clamps were checked.</source>
        <translation>{count:n} brides ont été vérifiées.</translation>
    </message>
    <message>
        <source>No clamps are given.</source>
        <translation>Aucune bride n&apos;est indiquée.</translation>
    </message>
    <message>
        <source>Nothing is checked yet.</source>
        <translation>Rien n&apos;est encore vérifié.</translation>
    </message>
    <message>
        <source>No {what}, checked to {pixel:mm2}.</source>
        <translation>Aucun problème ({what}), vérifié à {pixel:mm2} près.</translation>
    </message>
    <message>
        <source>Checked to {pixel:mm2}.</source>
        <translation>Vérifié à {pixel:mm2} près.</translation>
    </message>
    <message>
        <source>collision, gouge or fast plunge</source>
        <translation>collision, coupe dans le modèle ou plongée trop rapide</translation>
    </message>
    <message>
        <source>collision or fast plunge</source>
        <translation>collision ou plongée trop rapide</translation>
    </message>
    <message>
        <source>1 rapid cuts into material.</source>
        <translation>1 déplacement rapide coupe la matière.</translation>
    </message>
    <message>
        <source>{count:n} rapids cut into material.</source>
        <translation>{count:n} déplacements rapides coupent la matière.</translation>
    </message>
    <message>
        <source>1 gouge is {depth:mm2} deep in the model.</source>
        <translation>1 coupe entre de {depth:mm2} dans le modèle.</translation>
    </message>
    <message>
        <source>{count:n} gouges are up to {depth:mm2} deep in the model.</source>
        <translation>{count:n} coupes entrent jusqu&apos;à {depth:mm2} dans le modèle.</translation>
    </message>
    <message>
        <source>1 plunge is too fast.</source>
        <translation>1 plongée est trop rapide.</translation>
    </message>
    <message>
        <source>{count:n} plunges are too fast.</source>
        <translation>{count:n} plongées sont trop rapides.</translation>
    </message>
    <message>
        <source>The file has more than {lines:n} lines.</source>
        <translation>Le fichier a plus de {lines:n} lignes.</translation>
    </message>
    <message>
        <source>This is not an NC program. It has a line of more than {characters:n} characters.</source>
        <translation>Ce n&apos;est pas un programme CN. Il contient une ligne de plus de {characters:n} caractères.</translation>
    </message>
    <message>
        <source>The memory is not sufficient for this program. Divide it into smaller programs.</source>
        <translation>La mémoire ne suffit pas pour ce programme. Divisez-le en programmes plus petits.</translation>
    </message>
    <message>
        <source>Shank checked; no holder and no clamps given.</source>
        <translation>Queue vérifiée ; ni porte-outil ni brides indiqués.</translation>
    </message>
    <message>
        <source>FreeCAD is still reading {document}. Try again when the document is open.</source>
        <translation>FreeCAD lit encore {document}. Réessayez quand le document est ouvert.</translation>
    </message>
    <message>
        <source>A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized.</source>
        <translation>Un cycle de perçage hors du plan XY perce le long de {letter}. De tels trous ne sont pas reconnus.</translation>
    </message>
    <message>
        <source>A cycle with more than {most:n} repeats is read with {most:n} repeats.</source>
        <translation>Un cycle de plus de {most:n} répétitions est lu avec {most:n} répétitions.</translation>
    </message>
    <message>
        <source>A number of turns of an arc (P) that is not usable is ignored.</source>
        <translation>Un nombre de tours d&apos;arc (P) inutilisable est ignoré.</translation>
    </message>
    <message>
        <source>A probing move is read as a rapid to its end. Where the probe touches is not in the program.</source>
        <translation>Un déplacement de palpage est lu comme un déplacement rapide jusqu&apos;à sa fin. Le point de contact du palpeur n&apos;est pas dans le programme.</translation>
    </message>
    <message>
        <source>The feed rate of a thread ({name}) is its pitch times the spindle speed.</source>
        <translation>L&apos;avance d&apos;un filetage ({name}) est son pas multiplié par la vitesse de broche.</translation>
    </message>
    <message>
        <source>Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor.</source>
        <translation>Les avances sont lues en mm/s, car le texte est une trajectoire de FreeCAD sans post-processeur.</translation>
    </message>
    <message>
        <source>Commas in numbers are read as decimal points.</source>
        <translation>Les virgules dans les nombres sont lues comme des points décimaux.</translation>
    </message>
    <message>
        <source>Text that does not consist of words like G1 X10 is ignored. The words beside it are read.</source>
        <translation>Le texte qui n&apos;est pas fait de mots comme G1 X10 est ignoré. Les mots à côté sont lus.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as short lines.</source>
        <translation>Une spline ({name}) est lue comme de courtes droites.</translation>
    </message>
    <message>
        <source> A closed contour finishes the walls.</source>
        <translation> Un contour fermé finit les parois.</translation>
    </message>
    <message>
        <source>climbing at a constant radius</source>
        <translation>montant à rayon constant</translation>
    </message>
    <message>
        <source>only {share:%} of their length nested</source>
        <translation>seulement {share:%} de leur longueur imbriqués</translation>
    </message>
    <message>
        <source>The stock is where the other job leaves it, because the jobs have different models.</source>
        <translation>Le brut reste où l&apos;autre tâche le laisse, car les tâches ont des modèles différents.</translation>
    </message>
    <message>
        <source>1 move was not checked for lack of time: command {command:#} of {label}.</source>
        <translation>Faute de temps, 1 déplacement n&apos;a pas été vérifié : commande {command:#} de {label}.</translation>
    </message>
    <message>
        <source>{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.</source>
        <translation>Faute de temps, {count:n} déplacements n&apos;ont pas été vérifiés, le premier est la commande {command:#} de {label}.</translation>
    </message>
    <message>
        <source>The program is read up to this line. {why}</source>
        <translation>Le programme est lu jusqu’à cette ligne. {why}</translation>
    </message>
    <message>
        <source>The value of {name} comes from the machine.</source>
        <translation>La valeur de {name} vient de la machine.</translation>
    </message>
    <message>
        <source>The value of {name} is assigned in a line that cannot be read.</source>
        <translation>La valeur de {name} est affectée dans une ligne illisible.</translation>
    </message>
    <message>
        <source>A control stops here, because {name} has no value.</source>
        <translation>Une commande s’arrête ici, car {name} n’a pas de valeur.</translation>
    </message>
    <message>
        <source>A control stops here, because it has no variable {name}.</source>
        <translation>Une commande s’arrête ici, car elle n’a pas de variable {name}.</translation>
    </message>
    <message>
        <source>A control stops here, because an expression has no result, such as a division by zero.</source>
        <translation>Une commande s’arrête ici, car une expression n’a pas de résultat, par exemple une division par zéro.</translation>
    </message>
    <message>
        <source>The program stops here with an alarm (#3000).</source>
        <translation>Le programme s’arrête ici avec une alarme (#3000).</translation>
    </message>
    <message>
        <source>This jump, loop or call cannot be read.</source>
        <translation>Ce saut, cette boucle ou cet appel est illisible.</translation>
    </message>
    <message>
        <source>The end of this loop, condition or subprogram is missing.</source>
        <translation>La fin de cette boucle, de cette condition ou de ce sous-programme manque.</translation>
    </message>
    <message>
        <source>The program jumps to the block N{number}, which does not exist.</source>
        <translation>Le programme saute au bloc N{number}, qui n’existe pas.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would run more than {count:n} lines, which is the limit.</source>
        <translation>Les boucles, les sauts et les appels exécuteraient plus de {count:n} lignes, ce qui est la limite.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would make more than {count:n} moves, which is the limit.</source>
        <translation>Les boucles, les sauts et les appels produiraient plus de {count:n} mouvements, ce qui est la limite.</translation>
    </message>
    <message>
        <source>A loop runs more than {count:n} lines without a move, which is the limit.</source>
        <translation>Une boucle exécute plus de {count:n} lignes sans mouvement, ce qui est la limite.</translation>
    </message>
    <message>
        <source>The program jumps back from here without end.</source>
        <translation>Le programme revient d’ici en arrière sans fin.</translation>
    </message>
    <message>
        <source>The expressions take more than {count:n} steps to calculate, which is the limit.</source>
        <translation>Les expressions demandent plus de {count:n} étapes de calcul, ce qui est la limite.</translation>
    </message>
    <message>
        <source>Calls are nested deeper than {count:n} levels, which is the limit.</source>
        <translation>Les appels sont imbriqués sur plus de {count:n} niveaux, ce qui est la limite.</translation>
    </message>
    <message>
        <source>A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty.</source>
        <translation>Une variable que le programme n’a pas définie est lue. Elle vaut 0, ou est vide sur une commande Fanuc.</translation>
    </message>
    <message>
        <source>A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.</source>
        <translation>Une commande à deux codes, comme G90 et G1, est lue avec les deux. Certains post-processeurs n&apos;écrivent que le premier.</translation>
    </message>
    <message>
        <source>The program has no unit and looks like inches. It is simulated in inches.</source>
        <translation>Le programme n&apos;indique pas d&apos;unité et semble être en pouces. Il est simulé en pouces.</translation>
    </message>
    <message>
        <source>No stock is given. The simulation uses a box around the cuts.</source>
        <translation>Aucun brut n&apos;est indiqué. La simulation utilise un parallélépipède autour des coupes.</translation>
    </message>
    <message>
        <source>The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}.</source>
        <translation>La tâche se déplace de {needed:mm4} selon {axis}, mais la course de la machine est de {travel:mm4}.</translation>
    </message>
    <message>
        <source>The time did not suffice to check all walls for gouges narrower than {pixel:mm2}.</source>
        <translation>Le temps n&apos;a pas suffi pour chercher sur toutes les parois des coupes dans le modèle plus étroites que {pixel:mm2}.</translation>
    </message>
    <message>
        <source>The height of a move to a machine position ({name}) is not in the program. The greatest height is used.</source>
        <translation>La hauteur d&apos;un déplacement vers une position de la machine ({name}) n&apos;est pas dans le programme. La plus grande hauteur est utilisée.</translation>
    </message>
    <message>
        <source>The tool length offset changes before a move without a Z word. The height of the move is unknown.</source>
        <translation>La correction de longueur d&apos;outil change avant un déplacement sans mot Z. La hauteur du déplacement est inconnue.</translation>
    </message>
    <message>
        <source>A clamp was not checked. {sentence}</source>
        <translation>Une bride n&apos;a pas été vérifiée. {sentence}</translation>
    </message>
    <message>
        <source>This is a toolpath for a lathe. It is simulated like a mill&apos;s, so that the part is wrong.</source>
        <translation>Ce parcours est destiné à un tour. Il est simulé comme sur une fraiseuse, la pièce est donc fausse.</translation>
    </message>
    <message>
        <source>The verdict of the simulation is outdated, because the job has changed. Simulate the job again.</source>
        <translation>Le verdict de la simulation est périmé, car la tâche a changé. Simulez-la de nouveau.</translation>
    </message>
    <message>
        <source>No {what} was found, checked to {pixel:mm2}.</source>
        <translation>Aucun problème trouvé ({what}), vérifié à {pixel:mm2} près.</translation>
    </message>
    <message>
        <source>Not everything could be checked: {first}</source>
        <translation>Tout n&apos;a pas pu être vérifié : {first}</translation>
    </message>
    <message>
        <source>Not everything could be checked, for {count:n} reasons. The first reason: {first}</source>
        <translation>Tout n&apos;a pas pu être vérifié, pour {count:n} raisons. La première raison : {first}</translation>
    </message>
    <message>
        <source>{label} already begins with what this job leaves. Choose another job.</source>
        <translation>{label} commence déjà par ce que cette tâche laisse. Choisissez une autre tâche.</translation>
    </message>
    <message>
        <source>The cuts of a pocket or circle ({name}) are ignored.</source>
        <translation>Les coupes d&apos;une poche ou d&apos;un cercle ({name}) sont ignorées.</translation>
    </message>
    <message>
        <source>{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.</source>
        <translation>{label} à partir de la ligne {line:#} n&apos;est pas simulé, car son outil est inconnu. Nommez l&apos;outil dans un commentaire qui précède, par exemple (T1 D=6 end mill), ou donnez-le à vkworkbench.simulate.</translation>
    </message>
    <message>
        <source>Nothing was checked, because no tool meets the stock. Check the stock and its position.</source>
        <translation>Rien n&apos;a été vérifié, car aucun outil ne touche le brut. Vérifiez le brut et sa position.</translation>
    </message>
    <message>
        <source>{name} moves the coordinates. The origin before it is not in the program, and is read as 0.</source>
        <translation>{name} déplace les coordonnées. L&apos;origine précédente n&apos;est pas dans le programme et est lue comme 0.</translation>
    </message>
    <message>
        <source>An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.</source>
        <translation>Un mot F dans la ligne de {name} est lu dans l&apos;unité précédente, comme dans LinuxCNC. Certaines commandes utilisent la nouvelle unité.</translation>
    </message>
    <message>
        <source>The program has no unit (G20, G21) and is read in millimeters. It can also be in inches.</source>
        <translation>Le programme n&apos;indique pas d&apos;unité (G20, G21) et est lu en millimètres. Il peut aussi être en pouces.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths simulator</source>
        <translation>Simuler l&apos;usinage</translation>
    </message>
    <message>
        <source>This toolpath has no tool. Import its program into a job.</source>
        <translation>Ce parcours ne peut pas avoir d&apos;outil. Importez son programme dans une tâche.</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.</source>
        <translation>Le CycleTime de FreeCAD pour cette tâche est {seconds:clock}. FreeCAD mesure mal les arcs et ne compte ni les accélérations ni les temporisations.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.</source>
        <translation>La durée d&apos;usinage ne comprend pas {length:mm4} de déplacements rapides, car l&apos;opération n&apos;a pas de contrôleur d&apos;outil. Choisissez votre machine dans les préférences, page Machine.</translation>
    </message>
    <message>
        <source>More than the sum: the {simulator:simulator} slows down with every cut.</source>
        <translation>Plus que la somme : {simulator:simulator} ralentit à chaque coupe.</translation>
    </message>
    <message>
        <source>Less than the sum: the {simulator:simulator} simulates all operations in one run.</source>
        <translation>Moins que la somme : {simulator:simulator} simule toutes les opérations en une seule fois.</translation>
    </message>
    <message>
        <source>More than the sum: tool changes and starts of the spindle take {time:clock}.</source>
        <translation>Plus que la somme : les changements d&apos;outil et les démarrages de la broche prennent {time:clock}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} slows to about {frames:g1} frames per second at the end of this job, mostly because of arcs. Simulate fewer operations at a time.</source>
        <translation>« {simulator:simulator} » ralentit à environ {frames:g1} images par seconde à la fin de cette tâche, surtout à cause des arcs. Simulez moins d&apos;opérations à la fois.</translation>
    </message>
    <message>
        <source>Gouges were not checked, because the job has no model with a volume.</source>
        <translation>Les coupes dans le modèle n&apos;ont pas été vérifiées, car la tâche n&apos;a pas de modèle avec un volume.</translation>
    </message>
    <message>
        <source>Gouges of {labels} were not checked, because the tool is simulated by a simpler shape.</source>
        <translation>Les coupes dans le modèle de {labels} n&apos;ont pas été vérifiées, car l&apos;outil est simulé par une forme plus simple.</translation>
    </message>
    <message>
        <source>Shank, holder and clamps were not checked.</source>
        <translation>La queue, le porte-outil et les brides n&apos;ont pas été vérifiés.</translation>
    </message>
    <message>
        <source>Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read.</source>
        <translation>De deux codes du même type dans une ligne, comme G0 et G1 ou G90 et G91, le dernier est lu.</translation>
    </message>
    <message>
        <source>After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate.</source>
        <translation>Après G80, un déplacement sans G0 ni G1 est lu comme un déplacement rapide. Certaines commandes se déplacent à la vitesse d&apos;avance.</translation>
    </message>
    <message>
        <source>Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. On Fanuc controls, they can differ by up to the diameter of the tool.</source>
        <translation>Avec la compensation de rayon ({name}), le premier mouvement et les angles extérieurs sont lus comme dans LinuxCNC. Sur les commandes Fanuc, ils peuvent différer jusqu&apos;au diamètre de l&apos;outil.</translation>
    </message>
    <message>
        <source>Lines after M2, M17 or M30 are read as part of the same program.</source>
        <translation>Les lignes après M2, M17 ou M30 sont lues comme partie du même programme.</translation>
    </message>
    <message>
        <source>{seen}{spread}.</source>
        <translation>{seen}{spread}.</translation>
    </message>
    <message>
        <source>{seen}.</source>
        <translation>{seen}.</translation>
    </message>
    <message>
        <source>The pecks of {name} are ignored. Each hole is drilled in one move.</source>
        <translation>Les débourrages de {name} sont ignorés. Chaque trou est percé en un seul mouvement.</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>The operation has no strategy, or several strategies.</extracomment>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>one-way</source>
        <translation>sens unique</translation>
    </message>
    <message>
        <source>contour-parallel</source>
        <translation>contours parallèles</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>profil</translation>
    </message>
    <message>
        <source>waterline</source>
        <translation>lignes de niveau</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>spirale</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>hélice</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptatif</translation>
    </message>
    <message>
        <source>drilling</source>
        <translation>perçage</translation>
    </message>
    <message>
        <source>engraving</source>
        <translation>gravure</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vide</translation>
    </message>
</context>
<context>
    <name>VkMachine</name>
    <message>
        <source>grbl Settings</source>
        <translation>Réglages de grbl</translation>
    </message>
    <message>
        <source>The lines that grbl answers to the command $$:</source>
        <translation>Les lignes que grbl répond à la commande $$ :</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Machining Times</source>
        <translation>Temps d&apos;usinage</translation>
    </message>
    <message>
        <source>The machine that machining times are planned for. The next analysis uses it.</source>
        <translation>La machine pour laquelle les temps d&apos;usinage sont planifiés. La prochaine analyse l&apos;utilise.</translation>
    </message>
    <message>
        <source>None: constant feed, no acceleration</source>
        <translation>Aucune : avance constante, sans accélération</translation>
    </message>
    <message>
        <source>Hobby router with grbl</source>
        <translation>Fraiseuse de loisir avec grbl</translation>
    </message>
    <message>
        <source>Small milling machine</source>
        <translation>Petite fraiseuse</translation>
    </message>
    <message>
        <source>Machining center</source>
        <translation>Centre d&apos;usinage</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Valeurs personnelles</translation>
    </message>
    <message>
        <source>Speed X</source>
        <translation>Vitesse X</translation>
    </message>
    <message>
        <source>Largest speed of the X axis. Rapids use it.</source>
        <translation>Vitesse maximale de l&apos;axe X. Les déplacements rapides l&apos;utilisent.</translation>
    </message>
    <message>
        <source>Speed Y</source>
        <translation>Vitesse Y</translation>
    </message>
    <message>
        <source>Largest speed of the Y axis. Rapids use it.</source>
        <translation>Vitesse maximale de l&apos;axe Y. Les déplacements rapides l&apos;utilisent.</translation>
    </message>
    <message>
        <source>Speed Z</source>
        <translation>Vitesse Z</translation>
    </message>
    <message>
        <source>Largest speed of the Z axis. Rapids use it.</source>
        <translation>Vitesse maximale de l&apos;axe Z. Les déplacements rapides l&apos;utilisent.</translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation>Accélération X</translation>
    </message>
    <message>
        <source>Acceleration of the X axis.</source>
        <translation>Accélération de l&apos;axe X.</translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation>Accélération Y</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis.</source>
        <translation>Accélération de l&apos;axe Y.</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>Accélération Z</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis.</source>
        <translation>Accélération de l&apos;axe Z.</translation>
    </message>
    <message>
        <source>Corner deviation</source>
        <translation>Écart aux angles</translation>
    </message>
    <message>
        <source>Distance from a corner at which the controller may round it: grbl&apos;s junction deviation ($11), LinuxCNC&apos;s path tolerance (G64 P). With 0, the tool stops at each corner.</source>
        <translation>Distance d&apos;un angle à laquelle la commande peut l&apos;arrondir : junction deviation de grbl ($11), tolérance de trajectoire de LinuxCNC (G64 P). Avec 0, l&apos;outil s&apos;arrête à chaque angle.</translation>
    </message>
    <message>
        <source>Moves planned ahead</source>
        <translation>Déplacements planifiés d&apos;avance</translation>
    </message>
    <message>
        <source>Number of moves that the controller plans ahead. grbl on an Arduino plans 15.</source>
        <translation>Nombre de déplacements que la commande planifie d&apos;avance. grbl sur un Arduino en planifie 15.</translation>
    </message>
    <message>
        <source>Measured / planned time</source>
        <translation>Temps mesuré / planifié</translation>
    </message>
    <message>
        <source>Measured time of a job divided by the time planned here. Multiplies all times.</source>
        <translation>Temps mesuré d&apos;une tâche divisé par le temps planifié ici. Multiplie tous les temps.</translation>
    </message>
    <message>
        <source>Fills the values from the answer of grbl to the command $$.</source>
        <translation>Remplit les valeurs à partir de la réponse de grbl à la commande $$.</translation>
    </message>
    <message>
        <source>Paste grbl Settings…</source>
        <translation>Coller les réglages de grbl…</translation>
    </message>
    <message>
        <source>Travel and Tool Holder</source>
        <translation>Course et porte-outil</translation>
    </message>
    <message>
        <source>Travel in X</source>
        <translation>Course en X</translation>
    </message>
    <message>
        <source>Travel of the machine along X. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Course de la machine selon X. L&apos;analyse signale les tâches et programmes qui demandent plus. 0 : inconnue.</translation>
    </message>
    <message>
        <source>Travel in Y</source>
        <translation>Course en Y</translation>
    </message>
    <message>
        <source>Travel of the machine along Y. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Course de la machine selon Y. L&apos;analyse signale les tâches et programmes qui demandent plus. 0 : inconnue.</translation>
    </message>
    <message>
        <source>Travel in Z</source>
        <translation>Course en Z</translation>
    </message>
    <message>
        <source>Travel of the machine along Z. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Course de la machine selon Z. L&apos;analyse signale les tâches et programmes qui demandent plus. 0 : inconnue.</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>Diamètre du porte-outil</translation>
    </message>
    <message>
        <source>Diameter of the tool holder. The simulation warns of collisions. A property HolderDiameter of a tool bit takes precedence. 0: unknown.</source>
        <translation>Diamètre du porte-outil. La simulation signale les collisions. Une propriété HolderDiameter de l&apos;outil est prioritaire. 0 : inconnu.</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>Longueur du porte-outil</translation>
    </message>
    <message>
        <source>Length of the tool holder. A property HolderLength of a tool bit takes precedence. 0: the holder has no upper end.</source>
        <translation>Longueur du porte-outil. Une propriété HolderLength de l&apos;outil est prioritaire. 0 : le porte-outil n&apos;a pas d&apos;extrémité supérieure.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Changement d&apos;outil</translation>
    </message>
    <message>
        <source>Time from the end of an operation to the next operation with another tool. The time of the job includes it.</source>
        <translation>Temps entre la fin d&apos;une opération et l&apos;opération suivante avec un autre outil. La durée de la tâche le comprend.</translation>
    </message>
    <message>
        <source>Start of the spindle</source>
        <translation>Démarrage de la broche</translation>
    </message>
    <message>
        <source>Time until the spindle turns at its speed. The time of the job includes it for each tool.</source>
        <translation>Temps jusqu&apos;à ce que la broche atteigne sa vitesse. La durée de la tâche le comprend pour chaque outil.</translation>
    </message>
    <message>
        <source>There is no line such as $110=3000. Paste the lines that grbl answers to the command $$.</source>
        <translation>Il manque une ligne comme $110=3000. Collez les lignes que grbl répond à la commande $$.</translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>Never calibrated on this computer. The times of FreeCAD&apos;s simulators are right to within a factor of 2.</source>
        <translation>Jamais étalonné sur cet ordinateur. Les temps des simulateurs de FreeCAD sont justes à un facteur 2 près.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation>Marques dans l&apos;arborescence</translation>
    </message>
    <message>
        <source>Show times for</source>
        <translation>Montrer les temps de</translation>
    </message>
    <message>
        <source>Shows the marks in the tree as colored pills. If switched off, shows them as plain text.</source>
        <translation>Montre les marques dans l&apos;arborescence comme des pastilles colorées. Sinon, les montre comme du texte simple.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Montrer les marques en pastilles</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. With large toolpaths, each recompute takes longer.</source>
        <translation>Analyse à nouveau les opérations marquées après chaque recalcul qui les a modifiées. De longs parcours allongent chaque recalcul.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Analyser à nouveau après un recalcul</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Longest time that a simulation may take. The analysis warns of longer simulations and recommends an accuracy within this limit.</source>
        <translation>Durée la plus longue permise pour une simulation. L&apos;analyse avertit si une simulation dure plus et recommande une précision dans cette limite.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Mémoire</translation>
    </message>
    <message>
        <source>Largest memory that a simulation may take. The analysis warns of larger simulations and recommends an accuracy within this limit.</source>
        <translation>Mémoire la plus grande permise pour une simulation. L&apos;analyse avertit si une simulation prend plus et recommande une précision dans cette limite.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Direction from which the part is viewed.</source>
        <translation>Direction d&apos;où la pièce est vue.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Edge length of the cells, in percent of the stock&apos;s longer side. 0.1 is the finest position of the accuracy slider, 1 the coarsest.</source>
        <translation>Arête des cellules, en pour cent du plus long côté du brut. 0,1 est la position la plus fine du curseur de précision, 1 la plus grossière.</translation>
    </message>
    <message>
        <source>Position of the quality slider. 10 is the best quality.</source>
        <translation>Position du curseur de qualité. 10 est la meilleure qualité.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolérance des arcs</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves that replace it.</source>
        <translation>Plus grande distance entre un arc et les mouvements droits qui le remplacent.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s default ({simulator})</source>
        <translation>Celui du bouton de FreeCAD ({simulator})</translation>
    </message>
    <message>
        <source>{simulator}: accuracy</source>
        <translation>{simulator} : précision</translation>
    </message>
    <message>
        <source>{simulator}: quality</source>
        <translation>{simulator} : qualité</translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. The marks change at once.</source>
        <translation>Le simulateur dont les marques montrent le temps. Les marques changent aussitôt.</translation>
    </message>
    <message>
        <source>Shows a bar above the 3D view when a simulation in one of FreeCAD&apos;s simulators would hang or take too long, and suggests a faster way.</source>
        <translation>Montre une barre au-dessus de la vue 3D quand une simulation dans un simulateur de FreeCAD se bloquerait ou durerait trop longtemps, et propose une solution plus rapide.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Avertir avant une simulation qui se bloquerait ou durerait trop longtemps</translation>
    </message>
    <message>
        <source>Last calibrated on {date}. The times of the {simulator} are right to within a factor of {factor}. Measured on {processor}, display {renderer}.</source>
        <translation>Dernier étalonnage le {date}. Les temps de « {simulator} » sont justes à un facteur {factor} près. Mesuré sur {processor}, affichage {renderer}.</translation>
    </message>
    <message>
        <source>Measures how fast this computer simulates, and saves the result. This takes some seconds.</source>
        <translation>Mesure la vitesse de simulation de cet ordinateur et enregistre le résultat. Cela prend quelques secondes.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image width</source>
        <translation>Simuler l&apos;usinage : largeur d&apos;image</translation>
    </message>
    <message>
        <source>Width of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Largeur de l&apos;image pour laquelle la durée et la mémoire de « Simuler l&apos;usinage » sont estimées.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image height</source>
        <translation>Simuler l&apos;usinage : hauteur d&apos;image</translation>
    </message>
    <message>
        <source>Height of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Hauteur de l&apos;image pour laquelle la durée et la mémoire de « Simuler l&apos;usinage » sont estimées.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: view</source>
        <translation>Simuler l&apos;usinage : vue</translation>
    </message>
</context>
<context>
    <name>Vk_AddMesh</name>
    <message>
        <source>Add Simulated Part as Mesh</source>
        <translation>Ajouter la pièce simulée comme maillage</translation>
    </message>
    <message>
        <source>Simulates the job, and adds the part that it leaves to the document as a mesh.</source>
        <translation>Simule la tâche et ajoute au document la pièce qu&apos;elle laisse, comme maillage.</translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation>{} a été ajouté au document.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document. Estimates what simulating each operation costs, and marks it in the tree.</source>
        <translation>Reconnaît la stratégie d&apos;usinage de chaque opération sélectionnée, ou de toutes celles du document actif. Estime le coût de la simulation de chaque opération et la marque dans l&apos;arborescence.</translation>
    </message>
    <message>
        <source>Analyze Toolpaths</source>
        <translation>Analyser les parcours d&apos;outil</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>Aucun document n&apos;est ouvert. Ouvrez-en d&apos;abord un qui contient une tâche ou un parcours d&apos;outil.</translation>
    </message>
    <message>
        <source>The analysis was cancelled. Nothing has changed.</source>
        <translation>L&apos;analyse a été annulée. Rien n&apos;a été modifié.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>Ce document ne contient aucune opération à analyser. Créez une tâche avec des opérations, ou importez du G-code.</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>{count} operation was analyzed.</source>
        <translation>{count} opération a été analysée.</translation>
    </message>
    <message>
        <source>{count} operations were analyzed.</source>
        <translation>{count} opérations ont été analysées.</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Mesure de la vitesse de simulation de cet ordinateur…</translation>
    </message>
    <message>
        <source>Reading the operations…</source>
        <translation>Lecture des opérations…</translation>
    </message>
    <message>
        <source>{count} mark has a warning: see Toolpath Results (V, R).</source>
        <translation>{count} marque a un avertissement : voir Résultats des parcours (V, R).</translation>
    </message>
    <message>
        <source>{count} marks have warnings: see Toolpath Results (V, R).</source>
        <translation>{count} marques ont des avertissements : voir Résultats des parcours (V, R).</translation>
    </message>
</context>
<context>
    <name>Vk_Clamps</name>
    <message>
        <source>Set Clamps from Selection</source>
        <translation>Définir les brides depuis la sélection</translation>
    </message>
    <message>
        <source>{} has no clamps.</source>
        <translation>{} n&apos;a pas de brides.</translation>
    </message>
    <message>
        <source>Remove Clamps</source>
        <translation>Retirer les brides</translation>
    </message>
    <message>
        <source>Clamps of {}: {}.</source>
        <translation>Brides de {} : {}.</translation>
    </message>
    <message>
        <source>Makes the selected solids, such as clamps and vices, the clamps of the job. The simulation warns if a tool, shank or holder collides with them. If no solid is selected, the command shows the present clamps and can remove them.</source>
        <translation>Fait des solides sélectionnés, par exemple des brides et des étaux, les brides de la tâche. La simulation avertit si un outil, une queue ou un porte-outil les heurte. Sans solide sélectionné, la commande montre les brides actuelles et peut les retirer.</translation>
    </message>
    <message>
        <source>To set clamps, select their solids and start this command again. If the document has several jobs, select the job, too.</source>
        <translation>Pour définir des brides, sélectionnez leurs solides et relancez cette commande. Si le document a plusieurs tâches, sélectionnez aussi la tâche.</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document. Your own descriptions stay.</source>
        <translation>Enlève les marques des opérations sélectionnées, ou toutes celles du document actif. Vos propres descriptions restent.</translation>
    </message>
    <message>
        <source>Clear Analysis</source>
        <translation>Effacer l&apos;analyse</translation>
    </message>
    <message>
        <source>The marks were removed.</source>
        <translation>Les marques ont été supprimées.</translation>
    </message>
    <message>
        <source>There are no marks to remove.</source>
        <translation>Il n&apos;y a aucune marque à supprimer.</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss Map</source>
        <translation>Application de Gauss</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Saves the three plots as PNG or SVG.</source>
        <translation>Enregistre les trois graphiques en PNG ou SVG.</translation>
    </message>
    <message>
        <source>Steps through the trajectories k of the area.</source>
        <translation>Parcourt pas à pas les trajectoires k de la zone.</translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation>Zone {} : {} trajectoires, {}</translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation>Application de Gauss des {} dernières trajectoires jusqu&apos;à k.</translation>
    </message>
    <message>
        <source>Select an operation in the tree.</source>
        <translation>Sélectionnez une opération dans l&apos;arborescence.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>sens antihoraire</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>sens horaire</translation>
    </message>
    <message>
        <source>exact reversal</source>
        <translation>demi-tour exact</translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy. Shows the toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Montre pourquoi l&apos;opération sélectionnée a sa stratégie. Montre le parcours d&apos;outil, l&apos;application de Gauss de ses directions et du vecteur V_k, et la fonction angulaire cumulée.</translation>
    </message>
    <message>
        <source>This area: {}</source>
        <translation>Cette zone : {}</translation>
    </message>
    <message>
        <source>φ between {} and {} turns, level n = {}, exact reversals: {}</source>
        <translation>φ entre {} et {} tours, niveau n = {}, demi-tours exacts : {}</translation>
    </message>
    <message>
        <source>Reading {}…</source>
        <translation>Lecture de {}…</translation>
    </message>
    <message>
        <source>Areas that the tool cuts without a rapid move or a plunge. The area that shows the strategy best comes first, then the longest areas.</source>
        <translation>Zones que l&apos;outil usine sans déplacement rapide ni plongée. La zone qui montre le mieux la stratégie vient d&apos;abord, puis les plus longues.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Use the wheel to zoom, drag to move, and double-click to show everything again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Utilisez la molette pour agrandir, glissez pour déplacer, double-cliquez pour montrer de nouveau tout.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: No move cuts sideways, so there is no direction to show.</source>
        <translation>{} : Aucun déplacement ne coupe latéralement, il n&apos;y a donc pas de direction à montrer.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The left plot shows the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the first point of the area. The unit circle shows the directions of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;. Its arcs show how these directions have moved. In a zigzag, the direction of v&lt;sub&gt;k&lt;/sub&gt; moves back and forth on a part of the circle. In a contour, it moves all around the circle. The direction of V&lt;sub&gt;k&lt;/sub&gt; moves all around only if the path begins inside the contour. The right plot shows the cumulative angular function φ and the angle θ on level n, in turns. A contour-parallel path reaches the dashed lines, one turn from its start. A zigzag stays between the dashed lines, one turn from its middle.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Le graphique de gauche montre le parcours d&apos;outil avec le vecteur V&lt;sub&gt;k&lt;/sub&gt; issu du premier point de la zone. Le cercle unité montre les directions de la trajectoire v&lt;sub&gt;k&lt;/sub&gt; et de V&lt;sub&gt;k&lt;/sub&gt;. Ses arcs montrent comment ces directions ont bougé. Pour un zigzag, la direction de v&lt;sub&gt;k&lt;/sub&gt; va et vient sur une partie du cercle. Pour un contour, elle en fait le tour. La direction de V&lt;sub&gt;k&lt;/sub&gt; n&apos;en fait le tour que si le parcours commence à l&apos;intérieur du contour. Le graphique de droite montre la fonction angulaire cumulée φ et l&apos;angle θ au niveau n, en tours. Un parcours à contours parallèles atteint les lignes tiretées, à un tour de son départ. Un zigzag reste entre les lignes tiretées, à un tour de son milieu.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>with the closing turn {}, n = {}</source>
        <translation>avec la rotation de fermeture {}, n = {}</translation>
    </message>
    <message>
        <source>φ = {} turns</source>
        <translation>φ = {} tours</translation>
    </message>
</context>
<context>
    <name>Vk_Jobs</name>
    <message>
        <source>The document has no job.</source>
        <translation>Le document n&apos;a pas de tâche.</translation>
    </message>
    <message>
        <source>Choose the job:</source>
        <translation>Choisissez la tâche :</translation>
    </message>
    <message>
        <source>Simulating {}…</source>
        <translation>Simulation de {}…</translation>
    </message>
    <message>
        <source>The simulation was cancelled. Nothing has changed.</source>
        <translation>La simulation a été annulée. Rien n&apos;a changé.</translation>
    </message>
</context>
<context>
    <name>Vk_PreviousJob</name>
    <message>
        <source>Begin with the Part of Another Job</source>
        <translation>Commencer par la pièce d&apos;une autre tâche</translation>
    </message>
    <message>
        <source>Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. The part is moved and turned with the model.</source>
        <translation>Fait commencer la simulation de la tâche par la pièce qu&apos;une autre tâche laisse, comme pour la seconde face d&apos;une pièce. La pièce est déplacée et tournée avec le modèle.</translation>
    </message>
    <message>
        <source>No other job of this document machines the part of {}.</source>
        <translation>Aucune autre tâche de ce document n&apos;usine la pièce de {}.</translation>
    </message>
    <message>
        <source>The simulation of {} begins with:</source>
        <translation>La simulation de {} commence par :</translation>
    </message>
    <message>
        <source>The stock of {}</source>
        <translation>Le brut de {}</translation>
    </message>
    <message>
        <source>{} begins with its own stock.</source>
        <translation>{} commence par son propre brut.</translation>
    </message>
    <message>
        <source>{} begins with the part that {} leaves.</source>
        <translation>{} commence par la pièce que {} laisse.</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath Results</source>
        <translation>Résultats des parcours</translation>
    </message>
    <message>
        <source>Nothing is analyzed in this document yet. Click Analyze Toolpaths.</source>
        <translation>Rien n&apos;est encore analysé dans ce document. Cliquez sur « Analyser les parcours d&apos;outil ».</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exporter en CSV</translation>
    </message>
    <message>
        <source>Export JSON</source>
        <translation>Exporter en JSON</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>The machining strategy, recognized from the toolpath alone.</source>
        <translation>La stratégie d&apos;usinage, reconnue d&apos;après le seul parcours d&apos;outil.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confiance</translation>
    </message>
    <message>
        <source>The confidence of the recognition.</source>
        <translation>La confiance de la reconnaissance.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Longueur des mouvements d&apos;usinage.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s OpenGL simulator at its highest speed.</source>
        <extracomment>FreeCAD&apos;s newer simulator, which draws the cuts of all earlier operations with every operation.</extracomment>
        <translation>Temps du simulateur OpenGL de FreeCAD à sa plus grande vitesse.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator.</source>
        <translation>Mémoire du simulateur OpenGL de FreeCAD.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what goes wrong when you simulate it.</source>
        <translation>Les problèmes de l&apos;opération, et ce qui ne va pas quand vous la simulez.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences.</source>
        <extracomment>FreeCAD&apos;s older simulator.</extracomment>
        <translation>Temps de l&apos;ancien simulateur de FreeCAD en avance rapide, à la précision des préférences.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences.</source>
        <translation>Mémoire de l&apos;ancien simulateur de FreeCAD, à la précision des préférences.</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Image recommandée : {}</translation>
    </message>
    <message>
        <source>Recommended
Image</source>
        <translation>Image
recommandée</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Machining
Time</source>
        <translation>Durée
d&apos;usinage</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>Exporter en &amp;CSV…</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>Exporter en &amp;JSON…</translation>
    </message>
    <message>
        <source>C&amp;opy to Clipboard</source>
        <translation>C&amp;opier</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xporter</translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
        <translation>Col&amp;onnes</translation>
    </message>
    <message>
        <source>Sort as &amp;Posted</source>
        <translation>Trier comme &amp;posté</translation>
    </message>
    <message>
        <source>Select an operation to read what it does and why.</source>
        <translation>Sélectionnez une opération pour lire ce qu&apos;elle fait et pourquoi.</translation>
    </message>
    <message>
        <source>Selection in {job}</source>
        <translation>Sélection dans {job}</translation>
    </message>
    <message>
        <source>Simulation
Time</source>
        <translation>Temps de
simulation</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>A result is outdated if the toolpath, the tool or the stock has changed since. Analyze the operation again.</source>
        <translation>Un résultat est périmé si le parcours, l&apos;outil ou le brut a changé depuis. Analysez l&apos;opération à nouveau.</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>périmé</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Déplacements</translation>
    </message>
    <message>
        <source>Number of straight moves. An arc counts as several.</source>
        <translation>Nombre de déplacements droits. Un arc compte pour plusieurs.</translation>
    </message>
    <message>
        <source>{simulator}
Time</source>
        <translation>{simulator} :
temps</translation>
    </message>
    <message>
        <source>{simulator}
Memory</source>
        <translation>{simulator} :
mémoire</translation>
    </message>
    <message>
        <source>Shows the analyzed operations with their strategies, machining times, simulation times and warnings.</source>
        <translation>Montre les opérations analysées avec leurs stratégies, durées d&apos;usinage, temps de simulation et avertissements.</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Ce résultat est périmé, car le parcours, l&apos;outil ou le brut a changé. Analysez l&apos;opération à nouveau.</translation>
    </message>
    <message>
        <source>All Numbers</source>
        <translation>Tous les nombres</translation>
    </message>
    <message>
        <source>Fewer Numbers</source>
        <translation>Moins de nombres</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi ?</translation>
    </message>
    <message>
        <source>Confidence: {share}</source>
        <translation>Confiance : {share}</translation>
    </message>
    <message>
        <source>Show in the Gauss Map</source>
        <translation>Montrer dans l&apos;application de Gauss</translation>
    </message>
    <message>
        <source>Cutting Length</source>
        <translation>Longueur de coupe</translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation>Longueur en rapide</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrer</translation>
    </message>
    <message>
        <source>Shows operations that contain this text in their name, strategy or warnings.</source>
        <translation>Montre les opérations qui contiennent ce texte dans leur nom, leur stratégie ou leurs avertissements.</translation>
    </message>
    <message>
        <source>Shows operations with this strategy.</source>
        <translation>Montre les opérations avec cette stratégie.</translation>
    </message>
    <message>
        <source>&amp;Warnings Only</source>
        <translation>A&amp;vertissements seuls</translation>
    </message>
    <message>
        <source>Shows operations that have warnings or are outdated.</source>
        <translation>Montre les opérations qui ont des avertissements ou sont périmées.</translation>
    </message>
    <message>
        <source>All Strategies</source>
        <translation>Toutes les stratégies</translation>
    </message>
    <message>
        <source>{count} of {all} operations</source>
        <translation>{count} opérations sur {all}</translation>
    </message>
    <message>
        <source>{count} operation</source>
        <translation>{count} opération</translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation>{count} opérations</translation>
    </message>
    <message>
        <source>This total covers the analyzed operations only.</source>
        <translation>Ce total comprend seulement les opérations analysées.</translation>
    </message>
    <message>
        <source>Time in the {simulator}, as the marks show it.</source>
        <translation>Temps dans « {simulator} », comme le montrent les marques.</translation>
    </message>
    <message>
        <source>Longest time that the {simulator} is expected to take. It is the estimate, multiplied by the factor to within which estimates are right.</source>
        <translation>Temps le plus long attendu dans « {simulator} ». C&apos;est l&apos;estimation, multipliée par le facteur près duquel les estimations sont justes.</translation>
    </message>
    <message>
        <source>Simulation Time
at Most</source>
        <translation>Temps de simulation
au plus</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because its dress-up is.</source>
        <translation>Cette opération n&apos;est pas comprise dans le total, car son complément l&apos;est.</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because it is switched off.</source>
        <translation>Cette opération n&apos;est pas comprise dans le total, car elle est désactivée.</translation>
    </message>
    <message>
        <source>Shortest Move at Feed</source>
        <translation>Déplacement le plus court en avance de travail</translation>
    </message>
    <message>
        <source>Median Move at Feed</source>
        <translation>Déplacement médian en avance de travail</translation>
    </message>
    <message>
        <source>No operation matches the filter.</source>
        <translation>Aucune opération ne correspond au filtre.</translation>
    </message>
    <message>
        <source>Time on the machine of the preferences. Without a machine: at constant feeds, and with rapids if the tool controller has rapid speeds.</source>
        <translation>Temps sur la machine des préférences. Sans machine : à avance constante, avec les déplacements rapides si le contrôleur d&apos;outil a des vitesses rapides.</translation>
    </message>
    <message>
        <source>In Plain Words</source>
        <translation>En clair</translation>
    </message>
    <message>
        <source>The toolpath in one sentence: the reason for the strategy.</source>
        <translation>Le parcours d&apos;outil en une phrase : la raison de la stratégie.</translation>
    </message>
    <message>
        <source>At constant feed. Choose your machine in the preferences, page Machine.</source>
        <translation>À avance constante. Choisissez votre machine dans les préférences, page Machine.</translation>
    </message>
    <message>
        <source>Enter the Measured Time…</source>
        <translation>Entrer le temps mesuré…</translation>
    </message>
    <message>
        <source>Measured Time</source>
        <translation>Temps mesuré</translation>
    </message>
    <message>
        <source>Time that {label} took on the machine, in minutes and seconds, such as 17:30:</source>
        <translation>Temps que {label} a pris sur la machine, en minutes et secondes, par exemple 17:30 :</translation>
    </message>
    <message>
        <source>This is not a possible time. Enter it like 17:30 or 1:02:30.</source>
        <translation>Ce temps n&apos;est pas possible. Entrez-le sous la forme 17:30 ou 1:02:30.</translation>
    </message>
    <message>
        <source>Time that Simulate Toolpaths takes. An operation is simulated alone, on the whole stock. In a job, each operation cuts the stock that is left.</source>
        <extracomment>Attributes of `Rings` whose shares of the section&apos;s length are measures.</extracomment>
        <translation>Durée de « Simuler l&apos;usinage ». Une opération est simulée seule, sur le brut entier. Dans une tâche, chaque opération coupe le brut restant.</translation>
    </message>
    <message>
        <source>Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.</source>
        <translation>Mémoire de « Simuler l&apos;usinage ». Une opération comprend le brut entier. Une tâche comprend le brut une seule fois.</translation>
    </message>
    <message>
        <source>The finest image of Simulate Toolpaths within your limits of time and memory.</source>
        <translation>L&apos;image la plus fine de « Simuler l&apos;usinage » dans vos limites de temps et de mémoire.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Remarks that need no action, such as problems of a simulator that the marks do not show.</source>
        <translation>Remarques qui ne demandent rien, par exemple les problèmes d&apos;un simulateur que les marques ne montrent pas.</translation>
    </message>
    <message>
        <source>Jobs and Operations</source>
        <translation>Tâches et opérations</translation>
    </message>
    <message>
        <source>Details of the Selected Operation</source>
        <translation>Détails de l&apos;opération sélectionnée</translation>
    </message>
</context>
<context>
    <name>Vk_SaveStl</name>
    <message>
        <source>Save Simulated Part as STL</source>
        <translation>Enregistrer la pièce simulée en STL</translation>
    </message>
    <message>
        <source>Simulates the job, and saves the part that it leaves as an STL file.</source>
        <translation>Simule la tâche et enregistre la pièce qu&apos;elle laisse dans un fichier STL.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>{} ne peut pas être écrit : {}</translation>
    </message>
    <message>
        <source>The part is saved in {}.</source>
        <translation>La pièce est enregistrée dans {}.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>Raw Stock</source>
        <translation>Brut</translation>
    </message>
    <message>
        <source>Machined</source>
        <translation>Usiné</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matière</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation>Débit de copeaux</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document. Shows the part at any moment, the operation that made each surface, and rapid moves that cut.</source>
        <translation>Simule la tâche ou les opérations sélectionnées, sinon la tâche du document actif. Montre la pièce à tout moment, l&apos;opération qui a fait chaque surface et les déplacements rapides qui coupent.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths</source>
        <translation>Simuler l&apos;usinage</translation>
    </message>
    <message>
        <source>Simulation: {}</source>
        <translation>Simulation : {}</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Enregistrer l&apos;image</translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation>Dossier pour les images</translation>
    </message>
    <message>
        <source>Save Removal Rates</source>
        <translation>Enregistrer les débits de copeaux</translation>
    </message>
    <message>
        <source>{} cannot be written.</source>
        <translation>Impossible d&apos;écrire {}.</translation>
    </message>
    <message>
        <source>Simulated Part</source>
        <translation>Pièce simulée</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>As in the 3D View</source>
        <translation>Comme la vue 3D</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Property that colors the surfaces.</source>
        <translation>Propriété selon laquelle les surfaces sont colorées.</translation>
    </message>
    <message>
        <source>Shows the part, the material that the current operation removes, or both.</source>
        <translation>Montre la pièce, la matière que l&apos;opération en cours enlève, ou les deux.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Copeaux</translation>
    </message>
    <message>
        <source>Part and Chips</source>
        <translation>Pièce et copeaux</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Pictures of the Whole Job…</source>
        <translation>Images de toute la tâche…</translation>
    </message>
    <message>
        <source>Removal Rates…</source>
        <translation>Débits de copeaux…</translation>
    </message>
    <message>
        <source>Plays or pauses the simulation (Space).</source>
        <translation>Lit ou suspend la simulation (Espace).</translation>
    </message>
    <message>
        <source>Speed of the playback, compared with the machine.</source>
        <translation>Vitesse de la lecture, par rapport à la machine.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Tâche en {}</translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>Go to the beginning of the operation.</source>
        <translation>Aller au début de l&apos;opération.</translation>
    </message>
    <message>
        <source>Go back by one command of the program.</source>
        <translation>Reculer d&apos;une commande du programme.</translation>
    </message>
    <message>
        <source>Go back by one trajectory.</source>
        <translation>Reculer d&apos;un mouvement.</translation>
    </message>
    <message>
        <source>Go forward by one trajectory.</source>
        <translation>Avancer d&apos;un mouvement.</translation>
    </message>
    <message>
        <source>Go forward by one command of the program.</source>
        <translation>Avancer d&apos;une commande du programme.</translation>
    </message>
    <message>
        <source>Go to the end of the operation.</source>
        <translation>Aller à la fin de l&apos;opération.</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>environ {}</translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation>Simulation… {}</translation>
    </message>
    <message>
        <source>The finest picture takes about {} and {}.</source>
        <translation>L&apos;image la plus fine prend environ {} et {}.</translation>
    </message>
    <message>
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation>{} × {} pixels de {}, {} traces, {}, simulé en {}</translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation>{} sur {}   {}, commande {} : {}</translation>
    </message>
    <message>
        <source>This is uncut stock.</source>
        <translation>C&apos;est du brut non usiné.</translation>
    </message>
    <message>
        <source>Time Line</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>Lecture de {} ({} sur {})…</translation>
    </message>
    <message>
        <source>There is no closed model.</source>
        <translation>Il n’y a pas de modèle fermé.</translation>
    </message>
    <message>
        <source>Gouged, {} to {}</source>
        <translation>Trop profond, {} à {}</translation>
    </message>
    <message>
        <source>Stock Left, {} to {}</source>
        <translation>Brut restant, {} à {}</translation>
    </message>
    <message>
        <source>As the Model</source>
        <translation>Comme le modèle</translation>
    </message>
    <message>
        <source>No Model</source>
        <translation>Pas de modèle</translation>
    </message>
    <message>
        <source>Difference to the Model</source>
        <translation>Écart au modèle</translation>
    </message>
    <message>
        <source>Differences from the model below this value are ignored.</source>
        <translation>Les écarts au modèle en dessous de cette valeur sont ignorés.</translation>
    </message>
    <message>
        <source>Worst Places</source>
        <translation>Pires endroits</translation>
    </message>
    <message>
        <source>Places where the part differs most from the model. Choose a place to see it.</source>
        <translation>Endroits où la pièce s&apos;écarte le plus du modèle. Choisissez un endroit pour le voir.</translation>
    </message>
    <message>
        <source>Collisions, gouges and fast plunges in the simulation. Choose one to see it.</source>
        <translation>Collisions, coupes trop profondes et plongées trop rapides de la simulation. Choisissez-en une pour la voir.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Avertissements : {}</translation>
    </message>
    <message>
        <source>Stock: {}</source>
        <translation>Brut : {}</translation>
    </message>
    <message>
        <source>{}, command {} ({}): {}</source>
        <translation>{}, commande {} ({}) : {}</translation>
    </message>
    <message>
        <source>Removed: {}</source>
        <translation>Enlevé : {}</translation>
    </message>
    <message>
        <source>Nothing removed</source>
        <translation>Rien enlevé</translation>
    </message>
    <message>
        <source>The model is shown with the finest picture.</source>
        <translation>Le modèle est montré avec l&apos;image la plus fine.</translation>
    </message>
    <message>
        <source>The pictures are saved when the finest picture is ready…</source>
        <translation>Les images sont enregistrées quand l&apos;image la plus fine est prête…</translation>
    </message>
    <message>
        <source>{} of {} pictures are saved in {}.</source>
        <translation>{} images sur {} sont enregistrées dans {}.</translation>
    </message>
    <message>
        <source>{} pictures</source>
        <translation>{} images</translation>
    </message>
    <message>
        <source>{} (X {} Y {} Z {} {})</source>
        <translation>{} (X {} Y {} Z {} {})</translation>
    </message>
    <message>
        <source>The simulated job has changed. Simulate it again.</source>
        <translation>La tâche simulée a changé. Simulez-la à nouveau.</translation>
    </message>
    <message>
        <source>Choose the job to simulate:</source>
        <translation>Choisissez la tâche à simuler :</translation>
    </message>
    <message>
        <source>Checking… {}</source>
        <translation>Vérification… {}</translation>
    </message>
    <message>
        <source>Gray: removal rate. Orange: cuts air. Triangles: warnings.</source>
        <translation>Gris : débit de matière. Orange : coupe dans l&apos;air. Triangles : avertissements.</translation>
    </message>
    <message>
        <source>Direction of the view, path of the tool, section, and measuring.</source>
        <translation>Direction de la vue, trajectoire de l’outil, coupe et mesure.</translation>
    </message>
    <message>
        <source>Path of the Tool</source>
        <translation>Trajectoire de l’outil</translation>
    </message>
    <message>
        <source>Shows the path of the operation: blue is done, pink to come.</source>
        <translation>Affiche la trajectoire de l’opération : le bleu est fait, le rose est à venir.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Two clicks on the part show their distance. Esc ends it.</source>
        <translation>Deux clics sur la pièce affichent leur distance. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Section in {}</source>
        <translation>Coupe en {}</translation>
    </message>
    <message>
        <source>No Section</source>
        <translation>Pas de coupe</translation>
    </message>
    <message>
        <source>Moves the section through the stock.</source>
        <translation>Déplace la coupe dans le brut.</translation>
    </message>
    <message>
        <source>Depth below the stock&apos;s top: {}</source>
        <translation>Profondeur sous le dessus du brut : {}</translation>
    </message>
    <message>
        <source>Measuring: click on the first point.</source>
        <translation>Mesure : cliquez sur le premier point.</translation>
    </message>
    <message>
        <source>Click on the second point.</source>
        <translation>Cliquez sur le second point.</translation>
    </message>
    <message>
        <source>Distance: {}   ΔX {}   ΔY {}   ΔZ {}</source>
        <translation>Distance : {}   ΔX {}   ΔY {}   ΔZ {}</translation>
    </message>
    <message>
        <source>This is the section.</source>
        <translation>C’est la surface de coupe.</translation>
    </message>
    <message>
        <source>Saves pictures, the shown part as a solid, or removal rates.</source>
        <translation>Enregistre des images, la pièce affichée comme solide ou les débits de copeaux.</translation>
    </message>
    <message>
        <source>Shown Part as STL…</source>
        <translation>Pièce affichée en STL…</translation>
    </message>
    <message>
        <source>Shown Part as Mesh in the Document</source>
        <translation>Pièce affichée comme maillage dans le document</translation>
    </message>
    <message>
        <source>This is available when the finest picture is ready.</source>
        <translation>Disponible lorsque l&apos;image la plus fine est prête.</translation>
    </message>
    <message>
        <source>Save Part as STL</source>
        <translation>Enregistrer la pièce en STL</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, and rapid moves gray. The document is not changed.</source>
        <translation>Colore les parcours d&apos;outil dans la vue 3D selon leur stratégie d&apos;usinage, les déplacements rapides en gris. Le document n&apos;est pas modifié.</translation>
    </message>
    <message>
        <source>Show Strategies</source>
        <translation>Montrer les stratégies</translation>
    </message>
    <message>
        <source>Rapid Moves</source>
        <translation>Déplacements rapides</translation>
    </message>
    <message>
        <source>Drawing strategies, operations left: {}</source>
        <translation>Dessin des stratégies, opérations restantes : {}</translation>
    </message>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation>Ce document ne contient aucun parcours à colorer. Créez une tâche avec des opérations, ou importez du G-code.</translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates the cost of their simulation.</source>
        <translation>Reconnaît les stratégies d&apos;usinage des parcours d&apos;outil et estime le coût de leur simulation.</translation>
    </message>
</context>
</TS>
