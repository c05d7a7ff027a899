<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognized from the toolpath</source>
        <translation>Stratégie d&apos;usinage reconnue à partir du parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation>Pourquoi cette stratégie</translation>
    </message>
    <message>
        <source>What the mark in the description says</source>
        <extracomment>The results of this session.</extracomment>
        <translation>Ce que dit la marque dans la description</translation>
    </message>
    <message>
        <source>How sure the recognition is, in percent</source>
        <translation>Certitude de la reconnaissance, en pour cent</translation>
    </message>
    <message>
        <source>What is wrong with the operation, unknown about it, or to be known before simulating it</source>
        <translation>Ce qui est faux ou inconnu dans l&apos;opération, ou à savoir avant de la simuler</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Longueur des mouvements d&apos;usinage</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>Temps sur la machine</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows</source>
        <translation>Temps estimé de la simulation que montre la marque</translation>
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
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Périmé : le parcours, l&apos;outil ou le brut ont changé depuis. Analysez à nouveau.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known: analyze it again.</source>
        <translation>Le temps dans « {simulator} » n&apos;est pas connu : analysez-le à nouveau.</translation>
    </message>
    <message>
        <source>{strategy}, {share} sure</source>
        <translation>{strategy}, sûr à {share}</translation>
    </message>
    <message>
        <source>On the machine: {length} of cutting</source>
        <translation>Sur la machine : {length} d&apos;usinage</translation>
    </message>
    <message>
        <source>On the machine: {time}, {length} of cutting</source>
        <translation>Sur la machine : {time}, {length} d&apos;usinage</translation>
    </message>
    <message>
        <source>On the machine: at least {time}, {length} of cutting</source>
        <translation>Sur la machine : au moins {time}, {length} d&apos;usinage</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: {time}, {memory}</source>
        <translation>Simulation dans « {simulator} » : {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: at least {time}, {memory}</source>
        <translation>Simulation dans « {simulator} » : au moins {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it alone in the {simulator}: {time}, {memory}</source>
        <translation>Simulation de l&apos;opération seule dans « {simulator} » : {time}, {memory}</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivée</translation>
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
        <source>nothing cuts: there are only rapid moves</source>
        <translation>rien ne coupe : il n&apos;y a que des déplacements rapides</translation>
    </message>
    <message>
        <source>nothing cuts: there are no moves</source>
        <translation>rien ne coupe : il n&apos;y a aucun mouvement</translation>
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
        <source>the sense of nested loops alternates</source>
        <translation>le sens des boucles emboîtées alterne</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>régulièrement espacées dans le plan, pas en profondeur</translation>
    </message>
    <message>
        <source>whose shape changes with the depth</source>
        <translation>dont la forme change avec la profondeur</translation>
    </message>
    <message>
        <source>a winding with a helical entry or bites out of the corners</source>
        <translation>un enroulement avec entrée hélicoïdale ou morsures dans les coins</translation>
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
        <source>small loops move along</source>
        <translation>de petites boucles avancent</translation>
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
        <source>an open contour comes again</source>
        <translation>un contour ouvert revient</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>des traits ouverts aussi longs que la pièce</translation>
    </message>
    <message>
        <source>short strokes that fill nothing</source>
        <translation>des traits courts qui ne remplissent rien</translation>
    </message>
    <message>
        <source>no cutting move in its toolpath</source>
        <translation>aucun mouvement de coupe dans son parcours</translation>
    </message>
    <message>
        <source>no toolpath: recompute the operation and see FreeCAD&apos;s report view</source>
        <translation>pas de parcours : recalculez l&apos;opération et consultez la vue rapport de FreeCAD</translation>
    </message>
    <message>
        <source>no tool: give the operation a tool controller</source>
        <translation>pas d&apos;outil : donnez à l&apos;opération un contrôleur d&apos;outil</translation>
    </message>
    <message>
        <source>no tool in {label}: choose a tool bit for it</source>
        <translation>pas d&apos;outil dans {label} : choisissez-lui un outil</translation>
    </message>
    <message>
        <source>the tool in {label} has no diameter</source>
        <translation>l&apos;outil dans {label} n&apos;a pas de diamètre</translation>
    </message>
    <message>
        <source>no stock: put the toolpath into a job</source>
        <translation>pas de brut : mettez le parcours dans une tâche</translation>
    </message>
    <message>
        <source>no stock: give {label} a stock</source>
        <translation>pas de brut : donnez un brut à {label}</translation>
    </message>
    <message>
        <source>cost unknown for {labels}</source>
        <translation>coût inconnu pour {labels}</translation>
    </message>
    <message>
        <source>words without a motion before them are ignored</source>
        <translation>mots sans mouvement avant eux ignorés</translation>
    </message>
    <message>
        <source>a feed rate that is not a usable number is ignored</source>
        <translation>avance qui n&apos;est pas un nombre utilisable ignorée</translation>
    </message>
    <message>
        <source>center words (I, J, K) that are not usable numbers are ignored</source>
        <translation>mot de centre (I, J, K) qui n&apos;est pas un nombre utilisable ignoré</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored</source>
        <translation>mot {letter} qui n&apos;est pas un nombre utilisable ignoré</translation>
    </message>
    <message>
        <source>positions beyond a kilometer are cut off there</source>
        <translation>position au-delà d&apos;un kilomètre tronquée</translation>
    </message>
    <message>
        <source>a drilling cycle without a depth (Z) drills nothing</source>
        <translation>cycle de perçage sans profondeur (Z) : pas de trou</translation>
    </message>
    <message>
        <source>a drilling cycle without R starts at the current height</source>
        <translation>cycle de perçage sans R : il commence là où il est</translation>
    </message>
    <message>
        <source>a drilling cycle outside the XY plane is read as one in XY</source>
        <translation>cycle de perçage hors du plan XY lu comme dans XY</translation>
    </message>
    <message>
        <source>an arc whose start is not known is ignored</source>
        <translation>arc dont le début n&apos;est pas encore connu ignoré</translation>
    </message>
    <message>
        <source>an arc without a usable center or radius is read as a line</source>
        <translation>arc sans centre ni rayon utilisables lu comme une droite</translation>
    </message>
    <message>
        <source>an arc whose end is not on its circle is read with a changing radius</source>
        <translation>arc dont la fin n&apos;est pas sur son cercle lu avec un rayon variable</translation>
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
        <source>leave this operation out of the simulation</source>
        <translation>laissez cette opération hors de la simulation</translation>
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
        <source>move its accuracy slider to the left</source>
        <translation>déplacez son curseur de précision vers la gauche</translation>
    </message>
    <message>
        <source>simulate fewer operations at a time</source>
        <translation>simulez moins d&apos;opérations à la fois</translation>
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
        <source>no resolution helps, not even a single pixel fits</source>
        <translation>aucune résolution n&apos;aide, pas même un seul pixel ne tient</translation>
    </message>
    <message>
        <source>the cost is that of a box around its cuts</source>
        <translation>le coût est celui d&apos;un bloc autour de ses coupes</translation>
    </message>
    <message>
        <source>it does not touch the stock: check its depths, its placement and the stock</source>
        <translation>elle ne touche pas le brut : vérifier ses profondeurs, son placement et le brut</translation>
    </message>
    <message>
        <source>its tool is wider than the stock: check the tool&apos;s diameter and the stock</source>
        <translation>son outil est plus large que le brut : vérifier le diamètre de l&apos;outil et le brut</translation>
    </message>
    <message>
        <source>choose a smaller image in the preferences</source>
        <translation>choisir une image plus petite dans les préférences</translation>
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
        <source>the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}</source>
        <translation>le rayon de coin doit être entre 0 et {radius:mm}, pas {corner:mm}</translation>
    </message>
    <message>
        <source>the tip angle must lie between 0 and pi, not be {angle:g}</source>
        <translation>l&apos;angle de pointe doit être entre 0 et π, pas {angle:g}</translation>
    </message>
    <message>
        <source>the stock has no volume: its upper corner must exceed its lower corner in x, y and z</source>
        <translation>le brut n&apos;a pas de volume : son coin supérieur doit dépasser l&apos;inférieur en x, y et z</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} move without a feed rate are not in the time</source>
        <translation>{length:mm4} de coupe dans {count:n} mouvement sans avance ne sont pas dans la durée</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time</source>
        <translation>{length:mm4} de coupe dans {count:n} mouvements sans avance ne sont pas dans la durée</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} is 0</source>
        <translation>{length:mm4} de déplacements rapides ne sont pas dans la durée, car {name} du contrôleur d&apos;outil vaut 0</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} and {other} are 0</source>
        <translation>{length:mm4} de déplacements rapides ne sont pas dans la durée, car {name} et {other} du contrôleur d&apos;outil valent 0</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> et {count:n} autres</translation>
    </message>
    <message>
        <source>; passes {step:mm3} apart ask for {cell:mm2}</source>
        <translation> ; des passes espacées de {step:mm3} demandent {cell:mm2}</translation>
    </message>
    <message>
        <source>; {cell:mm2} would do for passes {step:mm3} apart</source>
        <translation> ; {cell:mm2} suffiraient pour des passes espacées de {step:mm3}</translation>
    </message>
    <message>
        <source>no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}</source>
        <translation>aucune résolution ne suffit, les trajectoires seules prennent {time:s} : simuler moins d&apos;opérations{heaviest}</translation>
    </message>
    <message>
        <source>; the heaviest is {label} with {time:s}</source>
        <translation> ; la plus lourde est {label} avec {time:s}</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> et 1 autre</translation>
    </message>
    <message>
        <source>{sentence} (command {command:#})</source>
        <translation>{sentence} (commande {command:#})</translation>
    </message>
    <message>
        <source>{sentence} ({count:n} times, first at command {command:#})</source>
        <translation>{sentence} ({count:n} fois, d&apos;abord à la commande {command:#})</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored</source>
        <translation>code inconnu {name} ignoré</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored</source>
        <translation>1 autre code inconnu ignoré</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored</source>
        <translation>{count:n} autres codes inconnus ignorés</translation>
    </message>
    <message>
        <source>the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance</source>
        <translation>les arcs et cycles demanderaient {moves:n} mouvements à une tolérance de {tolerance:mm} ; choisissez une tolérance plus grande</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label} : {sentence}</translation>
    </message>
    <message>
        <source>could not be analyzed, please report it with the file: {error}</source>
        <translation>n&apos;a pas pu être analysée, merci de le signaler avec le fichier : {error}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur {count:n} lignes{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste à 0 sur {count:n} lignes{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur un trait ouvert{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur {count:n} traits ouverts{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste à 0 sur un trait ouvert{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste à 0 sur {count:n} traits ouverts{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ atteint {reached:turns} tours sur une boucle{spread}, {seen} : {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ atteint {reached:turns} tours sur {count:n} boucles{spread}, {seen} : {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}</source>
        <translation>φ est entre {low:turns} et {high:turns} tours, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}</source>
        <translation>φ n&apos;a pas de direction, les mouvements sont verticaux en un point : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}</source>
        <translation>φ n&apos;a pas de direction, les mouvements sont verticaux en {count:n} points : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}</source>
        <translation>φ n&apos;a pas de direction, les mouvements sont verticaux en quelques points : {strategy:strategy}</translation>
    </message>
    <message>
        <source>{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: {strategy:strategy}</source>
        <translation>{count:n} sections séparées par des changements d&apos;outil, des titres, des retraits ou des perçages montrent {strategies:strategy} : {strategy:strategy}</translation>
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
        <source>{count:n} bites of one sense overlap</source>
        <translation>{count:n} morsures de même sens se recouvrent</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) share the area</source>
        <translation>des lignes ({rows:%} de la longueur) et des boucles ({loops:%}) se partagent la surface</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} à {high}</translation>
    </message>
    <message>
        <source>{what} (line {line:#})</source>
        <translation>{what} (ligne {line:#})</translation>
    </message>
    <message>
        <source>{what} ({count:n} times, first in line {line:#})</source>
        <translation>{what} ({count:n} fois, d’abord à la ligne {line:#})</translation>
    </message>
    <message>
        <source>lines with a block delete (/) are read like the others</source>
        <translation>les lignes avec saut de bloc (/) sont lues comme les autres</translation>
    </message>
    <message>
        <source>a subprogram or macro call is not read</source>
        <translation>un sous-programme ou appel de macro n’est pas lu</translation>
    </message>
    <message>
        <source>jumps, loops and calls are not followed</source>
        <translation>les sauts, boucles et appels ne sont pas suivis</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the words with them are left out</source>
        <translation>les variables et expressions ne sont pas lues : leurs mots sont omis</translation>
    </message>
    <message>
        <source>lines that are not made of words like G1 X10 are left out</source>
        <translation>les lignes qui ne sont pas faites de mots comme G1 X10 sont omises</translation>
    </message>
    <message>
        <source>coordinates that {name} changes are read as if it were not there</source>
        <translation>les coordonnées que {name} modifie sont lues comme s’il n’était pas là</translation>
    </message>
    <message>
        <source>a spline ({name}) is read as a line</source>
        <translation>une spline ({name}) est lue comme une droite</translation>
    </message>
    <message>
        <source>what follows M2 or M30 is read as the same program</source>
        <translation>ce qui suit M2 ou M30 est lu comme le même programme</translation>
    </message>
    <message>
        <source>what follows the program&apos;s end is not read</source>
        <translation>ce qui suit la fin du programme n’est pas lu</translation>
    </message>
    <message>
        <source>a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read</source>
        <translation>un programme dans le langage des commandes {name} (ligne {line:#}) : sorti en code G (ISO), il sera lu</translation>
    </message>
    <message>
        <source>not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}</source>
        <translation>pas un programme CN : {part:n} de ses {lines:n} lignes ne sont pas faites de mots comme G1 X10, la première est la ligne {line:#}</translation>
    </message>
    <message>
        <source>not an NC program: no line of it moves a tool</source>
        <translation>pas un programme CN : aucune ligne ne déplace un outil</translation>
    </message>
    <message>
        <source>none of its moves can be read: {problems}</source>
        <translation>aucun de ses mouvements ne peut être lu : {problems}</translation>
    </message>
    <message>
        <source>not an NC program: it is not text</source>
        <translation>pas un programme CN : ce n’est pas un texte</translation>
    </message>
    <message>
        <source>a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programme pour un tour ({name}, ligne {line:#}) : les stratégies de fraisage n’en disent rien</translation>
    </message>
    <message>
        <source>a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programme pour une imprimante 3D ({name}, ligne {line:#}) : les stratégies de fraisage n’en disent rien</translation>
    </message>
    <message>
        <source>a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programme pour une découpe au fil ({name}, ligne {line:#}) : les stratégies de fraisage n’en disent rien</translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told</source>
        <translation>un axe rotatif tourne pendant la coupe (ligne {line:#}) : le chemin de l’outil n’est pas connu</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time: a program does not say how fast they are</source>
        <translation>{length:mm4} de rapides ne sont pas dans le temps : un programme n’en dit pas la vitesse</translation>
    </message>
    <message>
        <source>no tool: the program does not say its diameter, so the cost is not known</source>
        <translation>pas d’outil : le programme n’en dit pas le diamètre, donc le coût est inconnu</translation>
    </message>
    <message>
        <source>the file cannot be read: {name}</source>
        <translation>le fichier ne peut pas être lu : {name}</translation>
    </message>
    <message>
        <source>the file is larger than {size:bytes}</source>
        <translation>le fichier dépasse {size:bytes}</translation>
    </message>
    <message>
        <source>given up after {time:s}</source>
        <translation>abandonné après {time:s}</translation>
    </message>
    <message>
        <source>the process that read it died, perhaps for lack of memory</source>
        <translation>le processus qui le lisait est mort, faute de mémoire peut-être</translation>
    </message>
    <message>
        <source>it looks 25.4 times too small: inches read as millimeters?</source>
        <translation>cela semble 25,4 fois trop petit : des pouces lus comme des millimètres ?</translation>
    </message>
    <message>
        <source>there is nothing to simulate: choose a job, or operations with a toolpath</source>
        <translation>il n&apos;y a rien à simuler : choisissez une tâche, ou des opérations avec un parcours d&apos;outil</translation>
    </message>
    <message>
        <source>these operations belong to several jobs, choose one of them: {labels}</source>
        <translation>ces opérations appartiennent à plusieurs tâches, choisissez-en une : {labels}</translation>
    </message>
    <message>
        <source>extended z-buffer</source>
        <translation>z-buffer étendu</translation>
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
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}.</source>
        <translation>« {simulator:simulator} » se bloque sur un arc {reason} (commande {command:#}{others}) : {instead}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>« {simulator:simulator} » usine {count:n} rampe à une profondeur fausse, jusqu&apos;à {error:mm2} {way} (commande {command:#}) : ne jugez pas les profondeurs d&apos;après lui.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>« {simulator:simulator} » usine {count:n} rampes à une profondeur fausse, jusqu&apos;à {error:mm2} {way} (commande {command:#}) : ne jugez pas les profondeurs d&apos;après lui.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.</source>
        <translation>La lecture prend environ {longer:s} dans « {simulator:simulator} » : l&apos;avance rapide prend environ {time:s}.</translation>
    </message>
    <message>
        <source>Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.</source>
        <translation>La lecture prend environ {time:s} dans « {simulator:simulator} » au plus vite : simulez moins d&apos;opérations à la fois.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time and none is seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>{count:n} mouvements sont plus courts qu&apos;une cellule de « {simulator:simulator} » ({cell:mm2}), chacun prend du temps et aucun ne se voit seul : une tolérance plus grossière de l&apos;opération n&apos;y perd rien.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>« {simulator:simulator} » prend environ {memory:bytes} pour cette opération, plus que les {allowed:bytes} permis : {instead}.</translation>
    </message>
    <message>
        <source>use the {simulator:simulator} for this operation</source>
        <translation>utilisez « {simulator:simulator} » pour cette opération</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}</source>
        <translation>le diamètre de l&apos;outil doit être positif et d&apos;un kilomètre au plus, pas {diameter:mm}</translation>
    </message>
    <message>
        <source>the stock&apos;s corners must be numbers within a kilometer of the origin</source>
        <translation>les coins du brut doivent être des nombres à moins d&apos;un kilomètre de l&apos;origine</translation>
    </message>
    <message>
        <source>its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD&apos;s importer keeps them as mm/s</source>
        <translation>ses avances, jusqu&apos;à {feed:g} mm/s, sont lues en mm/min : l&apos;importation de FreeCAD les garde en mm/s</translation>
    </message>
    <message>
        <source>the tip&apos;s diameter must lie between 0 and {diameter:mm}, not be {tip:mm}</source>
        <translation>le diamètre de la pointe doit être compris entre 0 et {diameter:mm}, et non {tip:mm}</translation>
    </message>
    <message>
        <source>the solid&apos;s surface is not closed</source>
        <translation>la surface du solide n&apos;est pas fermée</translation>
    </message>
    <message>
        <source>the box around the stock of {label} is taken for it: {sentence}</source>
        <translation>le brut de {label} est remplacé par la boîte qui l&apos;entoure : {sentence}</translation>
    </message>
    <message>
        <source>{label} is not simulated exactly, but {instead}</source>
        <translation>{label} n&apos;est pas simulé exactement, mais {instead}</translation>
    </message>
    <message>
        <source>as an end mill of its largest diameter</source>
        <translation>comme une fraise droite de son plus grand diamètre</translation>
    </message>
    <message>
        <source>as a ball end of its tip&apos;s diameter</source>
        <translation>comme une fraise hémisphérique du diamètre de sa pointe</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>comme un foret</translation>
    </message>
    <message>
        <source>a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told</source>
        <translation>un axe rotatif ({letter}) tourne pendant la coupe : le trajet de l&apos;outil ne peut pas être déterminé</translation>
    </message>
    <message>
        <source>turns of a rotary axis ({letter}) are not followed</source>
        <translation>les rotations d&apos;un axe rotatif ({letter}) ne sont pas suivies</translation>
    </message>
    <message>
        <source>{letter} words are not read</source>
        <translation>les mots {letter} ne sont pas lus</translation>
    </message>
    <message>
        <source>a cycle&apos;s repeats ({letter}) are not made</source>
        <translation>les répétitions d&apos;un cycle ({letter}) ne sont pas faites</translation>
    </message>
    <message>
        <source>further turns of an arc (P) are not made</source>
        <translation>les tours supplémentaires d&apos;un arc (P) ne sont pas faits</translation>
    </message>
    <message>
        <source>inches (G20) are not followed: lengths are read in mm</source>
        <translation>les pouces (G20) ne sont pas suivis : les longueurs sont lues en mm</translation>
    </message>
    <message>
        <source>cutter compensation ({name}) is not followed: the path is the programmed one</source>
        <translation>la compensation de rayon ({name}) n&apos;est pas suivie : le trajet est celui du programme</translation>
    </message>
    <message>
        <source>feeds after {name} are not read</source>
        <translation>les avances après {name} ne sont pas lues</translation>
    </message>
    <message>
        <source>dwells are not in the time</source>
        <translation>les temporisations ne sont pas comptées dans le temps</translation>
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
        <source>{count:n} row{spread}, {seen}</source>
        <translation>{count:n} rangée{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}</source>
        <translation>{count:n} rangées{spread}, {seen}</translation>
    </message>
    <message>
        <source>one open cut{spread}, {seen}</source>
        <translation>une coupe ouverte{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}</source>
        <translation>{count:n} coupes ouvertes{spread}, {seen}</translation>
    </message>
    <message>
        <source>one loop{spread}{turning}, {seen}</source>
        <translation>une boucle{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}</source>
        <translation>{count:n} boucles{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>straight down at one point</source>
        <translation>tout droit vers le bas en un point</translation>
    </message>
    <message>
        <source>straight down at {count:n} points</source>
        <translation>tout droit vers le bas en {count:n} points</translation>
    </message>
    <message>
        <source>straight down at some points</source>
        <translation>tout droit vers le bas en quelques points</translation>
    </message>
    <message>
        <source>{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}</source>
        <translation>{count:n} sections, séparées par des changements d&apos;outil, des titres, des retraits ou du perçage : {strategies:strategy}</translation>
    </message>
    <message>
        <source>{count:n} overlapping bites</source>
        <translation>{count:n} morsures qui se recouvrent</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>l&apos;une horaire, la suivante antihoraire</translation>
    </message>
    <message>
        <source>all in one cut that winds on and never closes</source>
        <translation>tout en une coupe qui s&apos;enroule sans jamais se fermer</translation>
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
        <source>cut to and fro</source>
        <translation>coupées en aller et retour</translation>
    </message>
    <message>
        <source>all cut the same way</source>
        <translation>toutes coupées dans le même sens</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste entre {low:turns} et {high:turns} tours sur une rangée{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ reste à 0 sur une rangée{spread}, {seen} : {strategy:strategy}</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>Un déplacement est plus court qu&apos;une cellule de « {simulator:simulator} » ({cell:mm2}), prend son temps et ne se voit pas : une tolérance plus grossière de l&apos;opération n&apos;y perd rien.</translation>
    </message>
    <message>
        <source>which lie like those of known toolpaths ({share:%} of the votes)</source>
        <translation>disposés comme ceux de trajectoires connues ({share:%} des votes)</translation>
    </message>
    <message>
        <source>unlike anything that machines ({share:%} of the votes)</source>
        <translation>comme rien de ce qui usine ({share:%} des votes)</translation>
    </message>
    <message>
        <source>, entered by a ramp</source>
        <translation>, avec entrée en rampe</translation>
    </message>
    <message>
        <source>, entered by a ramp to and fro</source>
        <translation>, avec entrée en rampe aller-retour</translation>
    </message>
    <message>
        <source>, entered by a helix</source>
        <translation>, avec entrée en hélice</translation>
    </message>
    <message>
        <source>, finished by a contour around the rows</source>
        <translation>, avec une finition en contour autour des lignes</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator} se bloque ici : la commande {command:#} de {label}{others} est un arc {reason}.</translation>
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
        <source>Playing this takes {bound} {time:s} in the {simulator:simulator}.</source>
        <translation>{simulator:simulator} : la lecture dure {bound} {time:s}.</translation>
    </message>
    <message>
        <source>Fast-forward takes {bound} {time:s}.</source>
        <translation>L&apos;avance rapide dure {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} in fast-forward: {bound} {time:s}.</source>
        <translation>{simulator:simulator} en avance rapide : {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator}: {bound} {time:s}.</source>
        <translation>{simulator:simulator} : {bound} {time:s}.</translation>
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
        <source>Simulate toolpaths shows the finished part at once, coarse at first.</source>
        <translation>« Simuler l&apos;usinage » montre tout de suite la pièce finie, d&apos;abord grossièrement.</translation>
    </message>
    <message>
        <source>a rapid move removes {volume:mm³2}</source>
        <translation>un déplacement rapide enlève {volume:mm³2}</translation>
    </message>
    <message>
        <source>plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}</source>
        <translation>plonge en pleine matière à {feed:mm/min3}, son outil ne peut plonger qu’à {allowed:mm/min3}</translation>
    </message>
    <message>
        <source>{depth:mm2} are left on the model</source>
        <translation>{depth:mm2} restent sur le modèle</translation>
    </message>
    <message>
        <source>a finer picture would take longer than the {allowed:s} that the preferences allow</source>
        <translation>une image plus fine prendrait plus que les {allowed:s} permis par les préférences</translation>
    </message>
    <message>
        <source>as simulated, command {command:#} is wrong: {fault}</source>
        <translation>d’après la simulation, la commande {command:#} est fausse : {fault}</translation>
    </message>
    <message>
        <source>moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}</source>
        <translation>déplacements en X et Z seulement, avec des passes le long de Z à de nombreux X, comme en fait un tour : {strategy:strategy}</translation>
    </message>
    <message>
        <source>the operation&apos;s placement must be numbers within a kilometer of the origin</source>
        <translation>le placement de l&apos;opération doit être fait de nombres à moins d&apos;un kilomètre de l&apos;origine</translation>
    </message>
    <message>
        <source>a line with two {letter} words: the last one is read</source>
        <translation>une ligne avec deux mots {letter} : le dernier est lu</translation>
    </message>
    <message>
        <source>a line with two motions, such as G0 and G1: the last one is read</source>
        <translation>une ligne avec deux mouvements, comme G0 et G1 : le dernier est lu</translation>
    </message>
    <message>
        <source>{told}, with a little {strategies:strategy} beside it</source>
        <translation>{told}, avec un peu de {strategies:strategy} à côté</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}</source>
        <translation>{width:n} × {height:n} pixels de {pixel:mm2}, limités par {limit}{passes}</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds</source>
        <translation>{length:mm4} de déplacements rapides ne sont pas dans la durée, car l&apos;opération n&apos;a pas de contrôleur d&apos;outil : donnez-lui-en un avec des vitesses rapides</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the lines with them are left out</source>
        <translation>les variables et expressions ne sont pas lues : leurs lignes sont omises</translation>
    </message>
    <message>
        <source>moves to positions of the machine ({name}) are left out: a program does not say where they are</source>
        <translation>les déplacements vers des positions de la machine ({name}) sont omis : un programme ne dit pas où elles sont</translation>
    </message>
    <message>
        <source>the holes of a pattern ({name}) are not made</source>
        <translation>les trous d&apos;un motif ({name}) ne sont pas faits</translation>
    </message>
    <message>
        <source>it spans meters in whole numbers: thousandths without a decimal point read as whole units?</source>
        <translation>cela s’étend sur des mètres en nombres entiers : des millièmes sans point décimal lus comme des unités entières ?</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: simulate this operation alone.</source>
        <translation>« {simulator:simulator} » prend à la fin environ {time:s} par image, dont {percent:n} % pour les arcs : simulez cette opération seule.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}</source>
        <translation>« {simulator:simulator} » prend {bound} {time:s}, plus que les {allowed:s} permis. {better}</translation>
    </message>
    <message>
        <source>the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles</source>
        <translation>les centres des arcs sont lus comme des positions (comme avec G90.1) : ce n&apos;est qu&apos;ainsi que les arcs finissent sur leurs cercles</translation>
    </message>
    <message>
        <source>strokes that rise to their ends, as V-carving does</source>
        <translation>des traits qui remontent vers leurs extrémités, comme en gravure en V</translation>
    </message>
    <message>
        <source>cut in strokes, as between tags</source>
        <translation>usinées en traits, comme entre des attaches</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored, and with it the {letters} words of its line</source>
        <translation>code inconnu {name} ignoré, et avec lui les mots {letters} de sa ligne</translation>
    </message>
    <message>
        <source>probing moves are not in the time</source>
        <translation>les mouvements de palpage ne sont pas comptés dans le temps</translation>
    </message>
    <message>
        <source>cuts {depth:mm2} into the model</source>
        <translation>coupe de {depth:mm2} dans le modèle</translation>
    </message>
    <message>
        <source>as simulated, {count:n} commands are wrong, among them {command:#}: {fault}</source>
        <translation>d’après la simulation, {count:n} commandes sont fausses, dont la {command:#} : {fault}</translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy:strategy}</source>
        <translation>appelée {name}, mais son parcours est : {strategy:strategy}</translation>
    </message>
    <message>
        <source>not an NC program, but a zip archive: unpack it first</source>
        <translation>pas un programme CN, mais une archive zip : la décompresser d’abord</translation>
    </message>
    <message>
        <source>not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro examples/macros/folder_to_csv.py</source>
        <translation>pas un programme CN, mais un document FreeCAD : l’analyser dans FreeCAD, un dossier entier avec la macro examples/macros/folder_to_csv.py</translation>
    </message>
    <message>
        <source>lacks {depth:mm2} of the model: choose a larger stock, or move the model within it</source>
        <translation>il manque {depth:mm2} du modèle : choisissez un brut plus grand ou déplacez le modèle dans le brut</translation>
    </message>
    <message>
        <source>switched off: it has no toolpath until you switch it on and recompute it</source>
        <translation>désactivée : elle n&apos;a pas de parcours tant que vous ne l’activez et ne la recalculez pas</translation>
    </message>
    <message>
        <source>this is no file, but a pipe or a device</source>
        <translation>ce n&apos;est pas un fichier, mais un tube ou un périphérique</translation>
    </message>
    <message>
        <source>it does not touch the stock, which is the finished part: choose a block around it as the stock</source>
        <translation>elle ne touche pas le brut, qui est déjà la pièce finie : choisir comme brut un bloc qui l&apos;entoure</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>La simulation prend environ {memory:bytes} au plus fort, pour {dexels:n} dexels et {traces:n} éléments de trace, plus que les {allowed:bytes} permis : {instead}.</translation>
    </message>
    <message>
        <source>choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations</source>
        <translation>choisissez une image de {width:n} × {height:n} pixels de {pixel:mm2}, ou simulez moins d’opérations</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>No strategy, or several.</extracomment>
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
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>Never calibrated on this computer: times of FreeCAD&apos;s simulators are right within a factor of two.</source>
        <translation>Jamais étalonné sur cet ordinateur : les temps des simulateurs de FreeCAD sont justes à un facteur deux près.</translation>
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
        <source>Time and memory of</source>
        <translation>Temps et mémoire de</translation>
    </message>
    <message>
        <source>Shows the marks as colored pills in the tree; as plain text if switched off.</source>
        <translation>Montre les marques comme des pastilles colorées dans l&apos;arborescence ; sinon comme du texte simple.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Montrer les marques en pastilles</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. Large toolpaths make each recompute longer.</source>
        <translation>Analyse à nouveau les opérations marquées après chaque recalcul qui les a modifiées. De longs parcours allongent chaque recalcul.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Analyser à nouveau après un recalcul</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Budget</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>How long a simulation may take. The analysis warns of more, and recommends an accuracy that takes no longer.</source>
        <translation>Durée permise pour une simulation. L&apos;analyse avertit en cas de dépassement et recommande une précision qui la respecte.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Mémoire</translation>
    </message>
    <message>
        <source>How much memory a simulation may take. The analysis warns of more, and recommends an accuracy that takes no more.</source>
        <translation>Mémoire permise pour une simulation. L&apos;analyse avertit en cas de dépassement et recommande une précision qui la respecte.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Z-buffer image width</source>
        <translation>Largeur d&apos;image du z-buffer</translation>
    </message>
    <message>
        <source>Width of the image whose pixels the extended z-buffer computes.</source>
        <translation>Largeur de l&apos;image dont le z-buffer étendu calcule les pixels.</translation>
    </message>
    <message>
        <source>Z-buffer image height</source>
        <translation>Hauteur d&apos;image du z-buffer</translation>
    </message>
    <message>
        <source>Height of the image whose pixels the extended z-buffer computes.</source>
        <translation>Hauteur de l&apos;image dont le z-buffer étendu calcule les pixels.</translation>
    </message>
    <message>
        <source>Z-buffer view</source>
        <translation>Vue du z-buffer</translation>
    </message>
    <message>
        <source>Where the z-buffer looks at the part from.</source>
        <translation>D&apos;où le z-buffer regarde la pièce.</translation>
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
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation>Arête de ses cellules en pour cent du plus long côté du brut : 0,1 est la position la plus fine de son curseur, 1 la plus grossière.</translation>
    </message>
    <message>
        <source>Position of its quality slider; 10 is the best.</source>
        <translation>Position de son curseur de qualité ; 10 est la meilleure.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolérance des arcs</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves it is chopped into.</source>
        <translation>Plus grande distance entre un arc et les mouvements droits qui le remplacent.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Measures how fast FreeCAD&apos;s simulators are on this computer, which takes about a second, and remembers it.</source>
        <translation>Mesure en une seconde environ la vitesse des simulateurs de FreeCAD sur cet ordinateur, et la retient.</translation>
    </message>
    <message>
        <source>That of FreeCAD&apos;s button: {simulator}</source>
        <translation>Celui du bouton de FreeCAD : {simulator}</translation>
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
        <source>The simulator whose time the marks show. They follow at once.</source>
        <translation>Le simulateur dont les marques montrent le temps. Elles suivent aussitôt.</translation>
    </message>
    <message>
        <source>Says over the view, when one of FreeCAD&apos;s simulators is started, that it would hang or take longer than the budget, and offers the better way.</source>
        <translation>Signale au-dessus de la vue, au lancement d&apos;un simulateur de FreeCAD, qu&apos;il se bloquerait ou dépasserait le budget, et propose une meilleure solution.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Avertir des simulateurs bloqués ou trop longs</translation>
    </message>
    <message>
        <source>Last calibrated on {date}: times of the {simulator} are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation>Dernier étalonnage le {date} : les temps de « {simulator} » sont justes à un facteur {factor} près. Mesuré avec FreeCAD {freecad} sur {processor}, affichage {renderer}.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document, estimates what simulating it costs, and marks it in the tree.</source>
        <translation>Reconnaît la stratégie d&apos;usinage de chaque opération sélectionnée, ou de toutes celles du document actif, estime le coût de sa simulation et la marque dans l&apos;arborescence.</translation>
    </message>
    <message>
        <source>Analyze toolpaths</source>
        <translation>Analyser les parcours d&apos;outil</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>Aucun document n&apos;est ouvert. Ouvrez-en d&apos;abord un qui contient une tâche ou un parcours d&apos;outil.</translation>
    </message>
    <message>
        <source>Analysis cancelled, nothing changed.</source>
        <translation>Analyse annulée, rien n&apos;a été modifié.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>Ce document ne contient aucune opération à analyser. Créez une tâche avec des opérations, ou importez du G-code.</translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation>Les marques sont dans la colonne Description de l&apos;arborescence, désormais visible. Vous pouvez la masquer à nouveau par le menu contextuel de l&apos;arborescence : paramètres de l&apos;arborescence, afficher la description.</translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>{count} operation analyzed</source>
        <translation>{count} opération analysée</translation>
    </message>
    <message>
        <source>{count} operations analyzed</source>
        <translation>{count} opérations analysées</translation>
    </message>
    <message>
        <source>{count} has a warning</source>
        <translation>{count} avec un avertissement</translation>
    </message>
    <message>
        <source>{count} have warnings</source>
        <translation>{count} avec des avertissements</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Mesure de la vitesse de simulation de cet ordinateur…</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document; your own descriptions stay.</source>
        <translation>Enlève les marques des opérations sélectionnées, ou toutes celles du document actif ; vos propres descriptions restent.</translation>
    </message>
    <message>
        <source>Clear analysis</source>
        <translation>Effacer l&apos;analyse</translation>
    </message>
    <message>
        <source>{count} mark removed</source>
        <translation>{count} marque supprimée</translation>
    </message>
    <message>
        <source>{count} marks removed</source>
        <translation>{count} marques supprimées</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation>Application de Gauss</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Saves the three plots as they stand, as PNG or SVG.</source>
        <translation>Enregistre les trois graphiques tels quels, en PNG ou SVG.</translation>
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
        <source>Save picture</source>
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
        <source>Shows why the selected operation has its strategy: its toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Montre pourquoi l&apos;opération sélectionnée a sa stratégie : son parcours d&apos;outil, l&apos;application de Gauss de ses directions et du vecteur V_k, et la fonction angulaire cumulée.</translation>
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
        <source>with the closing turn φ = {}, n = {}</source>
        <translation>avec la rotation de fermeture φ = {}, n = {}</translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge: first the one that shows the strategy best, then the longest.</source>
        <translation>Les zones que l’outil usine sans déplacement rapide ni plongée : d’abord celle qui montre le mieux la stratégie, puis les plus longues.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The wheel zooms, dragging moves, a double click shows all again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La molette agrandit, glisser déplace, un double-clic montre de nouveau tout.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: no move cuts sideways, so there is no direction to show</source>
        <translation>{} : aucun déplacement ne coupe latéralement, il n&apos;y a donc pas de direction à montrer</translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. That of v&lt;sub&gt;k&lt;/sub&gt; goes to and fro on a part of the circle in a zigzag, and all around in a contour; that of V&lt;sub&gt;k&lt;/sub&gt; goes all around only where the path begins inside the contour. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path reaches the dashed lines ±2π, a zigzag stays between them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;À gauche, le parcours d&apos;outil avec le vecteur V&lt;sub&gt;k&lt;/sub&gt; issu du premier point de la zone. Sur le cercle unité, les images de la trajectoire v&lt;sub&gt;k&lt;/sub&gt; et de V&lt;sub&gt;k&lt;/sub&gt; ; les arcs montrent leur mouvement. Celle de v&lt;sub&gt;k&lt;/sub&gt; va et vient sur une partie du cercle pour un zigzag et en fait le tour pour un contour ; celle de V&lt;sub&gt;k&lt;/sub&gt; n&apos;en fait le tour que si le parcours commence à l&apos;intérieur du contour. À droite, la fonction angulaire cumulée φ et l&apos;angle θ au niveau n : un parcours à contours parallèles atteint les lignes tiretées ±2π, un zigzag reste entre elles.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation>Résultats des parcours</translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation>Rien n&apos;est encore analysé dans ce document : cliquez sur « Analyser les parcours d&apos;outil ».</translation>
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
        <source>The machining strategy recognized from the toolpath alone</source>
        <translation>La stratégie d&apos;usinage reconnue d&apos;après le seul parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>Fiabilité</translation>
    </message>
    <message>
        <source>How sure the recognition is</source>
        <translation>Fiabilité de la reconnaissance</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Longueur des mouvements d&apos;usinage</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <extracomment>FreeCAD&apos;s newer one, which draws the cuts of all operations before with every operation.</extracomment>
        <translation>Temps du simulateur OpenGL de FreeCAD à sa plus grande vitesse</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator</source>
        <translation>Mémoire du simulateur OpenGL de FreeCAD</translation>
    </message>
    <message>
        <source>What is wrong with the operation, or will be with its simulation</source>
        <translation>Ce qui ne va pas dans l&apos;opération, ou n&apos;ira pas dans sa simulation</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences</source>
        <extracomment>FreeCAD&apos;s older one.</extracomment>
        <translation>Temps de l&apos;ancien simulateur de FreeCAD en avance rapide, à la précision des préférences</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences</source>
        <translation>Mémoire de l&apos;ancien simulateur de FreeCAD, à la précision des préférences</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Image recommandée : {}</translation>
    </message>
    <message>
        <source>Recommended
image</source>
        <translation>Image
recommandée</translation>
    </message>
    <message>
        <source>The finest image of the z-buffer within the budgets of the preferences</source>
        <translation>L&apos;image la plus fine du z-buffer dans les budgets des préférences</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Machining
time</source>
        <translation>Durée
d&apos;usinage</translation>
    </message>
    <message>
        <source>Time on the machine at the programmed feeds; rapids where the tool controller gives their speed</source>
        <translation>Durée sur la machine aux avances programmées ; déplacements rapides si le contrôleur d&apos;outil donne leur vitesse</translation>
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
        <source>C&amp;opy to clipboard</source>
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
        <source>Sort as &amp;posted</source>
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
time</source>
        <translation>Temps de
simulation</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since; analyze it again</source>
        <translation>Périmé : le parcours, l&apos;outil ou le brut ont changé depuis ; analysez-la de nouveau</translation>
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
        <source>Number of straight moves; an arc counts as several</source>
        <translation>Nombre de déplacements droits ; un arc compte pour plusieurs</translation>
    </message>
    <message>
        <source>{simulator}
time</source>
        <translation>{simulator} :
temps</translation>
    </message>
    <message>
        <source>{simulator}
memory</source>
        <translation>{simulator} :
mémoire</translation>
    </message>
    <message>
        <source>Shows the analyzed operations: strategy, machining and simulation time, and what is wrong with them.</source>
        <translation>Montre les opérations analysées : stratégie, temps d&apos;usinage et de simulation, et ce qui ne va pas.</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Périmé : le parcours, l&apos;outil ou le brut ont changé depuis. Analysez-la de nouveau.</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Tous les nombres</translation>
    </message>
    <message>
        <source>Fewer numbers</source>
        <translation>Moins de nombres</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi ?</translation>
    </message>
    <message>
        <source>Sure: {share}</source>
        <translation>Sûr : {share}</translation>
    </message>
    <message>
        <source>Show it in the Gauss map</source>
        <translation>Le montrer dans l&apos;application de Gauss</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Avance rapide</translation>
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
        <source>Shows operations with this text in name, strategy or warnings</source>
        <translation>Montre les opérations avec ce texte dans le nom, la stratégie ou les avertissements</translation>
    </message>
    <message>
        <source>Shows operations of this strategy</source>
        <translation>Montre les opérations de cette stratégie</translation>
    </message>
    <message>
        <source>&amp;Warnings only</source>
        <translation>A&amp;vertissements seuls</translation>
    </message>
    <message>
        <source>Shows operations with warnings, and outdated ones</source>
        <translation>Montre les opérations avec avertissements et les périmées</translation>
    </message>
    <message>
        <source>All strategies</source>
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
        <source>the total of what was analyzed, not of the whole job</source>
        <translation>le total de ce qui a été analysé, pas de toute la tâche</translation>
    </message>
    <message>
        <source>How long the {simulator} takes, as the marks show it</source>
        <translation>Durée : {simulator}, comme dans les marques</translation>
    </message>
    <message>
        <source>The longest that the {simulator} should take: its estimate times the factor by which estimates are off</source>
        <translation>Le plus long que cela devrait durer : {simulator} ; l’estimation multipliée par l’écart habituel des estimations</translation>
    </message>
    <message>
        <source>Simulation time
at most</source>
        <translation>Temps de simulation
au plus</translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer: an operation alone, on the whole stock; a job one operation after another, each on what is left</source>
        <extracomment>The paper&apos;s; its columns in CSV and JSON have no prefix.</extracomment>
        <translation>Temps de simulation dans un z-buffer étendu : une opération seule, sur le brut entier ; une tâche opération après opération, chacune sur ce qui reste</translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer: of an operation alone, with the whole stock; of a job with the stock once</source>
        <translation>Mémoire de simulation dans un z-buffer étendu : d&apos;une opération seule, avec le brut entier ; d&apos;une tâche avec le brut une seule fois</translation>
    </message>
    <message>
        <source>not in the total: its dress-up is counted instead</source>
        <translation>hors du total : son complément est compté à sa place</translation>
    </message>
    <message>
        <source>not in the total: it is switched off</source>
        <translation>hors du total : elle est désactivée</translation>
    </message>
    <message>
        <source>Shortest move at feed</source>
        <translation>Déplacement le plus court en avance de travail</translation>
    </message>
    <message>
        <source>Median move at feed</source>
        <translation>Déplacement médian en avance de travail</translation>
    </message>
    <message>
        <source>The filter lets no operation through.</source>
        <translation>Le filtre ne laisse passer aucune opération.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>raw</source>
        <translation>brut</translation>
    </message>
    <message>
        <source>machined</source>
        <translation>usiné</translation>
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
        <source>Removal rate</source>
        <translation>Débit de copeaux</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document, and shows the part at any moment, what made each of its surfaces, and rapid moves that cut.</source>
        <translation>Simule la tâche ou les opérations sélectionnées, sinon la tâche du document actif, et montre la pièce à tout moment, ce qui a fait chacune de ses surfaces et les déplacements rapides qui coupent.</translation>
    </message>
    <message>
        <source>Simulate toolpaths</source>
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
        <source>Folder of the Pictures</source>
        <translation>Dossier des images</translation>
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
        <source>Simulated part</source>
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
        <source>As the 3D view</source>
        <translation>Comme la vue 3D</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Where the part is seen from.</source>
        <translation>D&apos;où la pièce est vue.</translation>
    </message>
    <message>
        <source>What the surfaces are colored by.</source>
        <translation>Selon quoi les surfaces sont colorées.</translation>
    </message>
    <message>
        <source>What the operation of this moment removes, alone or on the part.</source>
        <translation>Ce que l&apos;opération de ce moment enlève, seul ou sur la pièce.</translation>
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
        <source>Part and chips</source>
        <translation>Pièce et copeaux</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save what is shown.</source>
        <translation>Enregistrer ce qui est affiché.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Image…</translation>
    </message>
    <message>
        <source>Pictures of the whole job…</source>
        <translation>Images de toute la tâche…</translation>
    </message>
    <message>
        <source>Removal rates…</source>
        <translation>Débits de copeaux…</translation>
    </message>
    <message>
        <source>Play or pause (Space).</source>
        <translation>Lire ou suspendre (Espace).</translation>
    </message>
    <message>
        <source>How many times as fast as the machine.</source>
        <translation>Combien de fois plus vite que la machine.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Tâche en {}</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>To the beginning of the operation.</source>
        <translation>Au début de l&apos;opération.</translation>
    </message>
    <message>
        <source>Back by one command of the program.</source>
        <translation>Reculer d&apos;une commande du programme.</translation>
    </message>
    <message>
        <source>Back by one trajectory.</source>
        <translation>Reculer d&apos;un mouvement.</translation>
    </message>
    <message>
        <source>Forward by one trajectory.</source>
        <translation>Avancer d&apos;un mouvement.</translation>
    </message>
    <message>
        <source>Forward by one command of the program.</source>
        <translation>Avancer d&apos;une commande du programme.</translation>
    </message>
    <message>
        <source>To the end of the operation.</source>
        <translation>À la fin de l&apos;opération.</translation>
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
        <source>finest picture in about {}, {}</source>
        <translation>image la plus fine dans environ {}, {}</translation>
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
        <source>This surface is the raw stock&apos;s.</source>
        <translation>Cette surface est celle du brut.</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>Lecture de {} ({} sur {})…</translation>
    </message>
    <message>
        <source>there is no closed model</source>
        <translation>il n’y a pas de modèle fermé</translation>
    </message>
    <message>
        <source>gouged by {} to {}</source>
        <translation>trop profond, {} à {}</translation>
    </message>
    <message>
        <source>left, {} to {}</source>
        <translation>reste, {} à {}</translation>
    </message>
    <message>
        <source>as the model</source>
        <translation>comme le modèle</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>pas de modèle</translation>
    </message>
    <message>
        <source>Difference to the model</source>
        <translation>Écart au modèle</translation>
    </message>
    <message>
        <source>Smaller differences to the model do not count.</source>
        <translation>Les écarts au modèle jusqu’à cette valeur n’en sont pas.</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Pires endroits</translation>
    </message>
    <message>
        <source>Where the part differs most from the model. Choose a place to see it.</source>
        <translation>Où la pièce s’écarte le plus du modèle. Choisissez un endroit pour le voir.</translation>
    </message>
    <message>
        <source>Crashes, gouges and fast plunges of the simulation. Choose one to see it.</source>
        <translation>Collisions, coupes trop profondes et plongées trop rapides de la simulation. Choisissez-en une pour la voir.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Avertissements : {}</translation>
    </message>
    <message>
        <source>… and {} more</source>
        <translation>… et {} de plus</translation>
    </message>
    <message>
        <source>raw stock: {}</source>
        <translation>brut : {}</translation>
    </message>
    <message>
        <source>{}, command {}: {} ({})</source>
        <translation>{}, commande {} : {} ({})</translation>
    </message>
    <message>
        <source>removes {}</source>
        <translation>enlève {}</translation>
    </message>
    <message>
        <source>removes nothing</source>
        <translation>n’enlève rien</translation>
    </message>
    <message>
        <source>the model comes with the finest picture</source>
        <translation>le modèle vient avec l’image la plus fine</translation>
    </message>
    <message>
        <source>They are known when the finest picture is there.</source>
        <translation>Ils sont connus quand l&apos;image la plus fine est là.</translation>
    </message>
    <message>
        <source>Saving the pictures when the finest is there…</source>
        <translation>Les images sont enregistrées quand la plus fine est là…</translation>
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
        <source>{}, at X {} Y {} Z {} {}</source>
        <translation>{}, en X {} Y {} Z {} {}</translation>
    </message>
    <message>
        <source>What is simulated has changed. Simulate again</source>
        <translation>Ce qui est simulé a changé. Simuler à nouveau</translation>
    </message>
    <message>
        <source>Which job?</source>
        <translation>Quelle tâche ?</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, rapid moves grey. The document is not changed.</source>
        <translation>Colore les parcours d&apos;outil dans la vue 3D selon leur stratégie d&apos;usinage, les déplacements rapides en gris. Le document n&apos;est pas modifié.</translation>
    </message>
    <message>
        <source>Show strategies</source>
        <translation>Montrer les stratégies</translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation>déplacements rapides</translation>
    </message>
    <message>
        <source>Drawing strategies, operations to go: {}</source>
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
    <message>
        <source>Fast-forward</source>
        <translation>Avance rapide</translation>
    </message>
    <message>
        <source>Use the {simulator}</source>
        <translation>Utiliser {simulator}</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates what simulating them costs.</source>
        <translation>Reconnaît les stratégies d&apos;usinage des parcours d&apos;outil et estime le coût de leur simulation.</translation>
    </message>
</context>
</TS>
