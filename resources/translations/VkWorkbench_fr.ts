<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognised from the toolpath</source>
        <translation>Stratégie d&apos;usinage reconnue à partir du parcours d&apos;outil</translation>
    </message>
    <message>
        <source>How sure the recognition is, 0 to 1</source>
        <translation>Fiabilité de la reconnaissance, de 0 à 1</translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation>Pourquoi cette stratégie</translation>
    </message>
    <message>
        <source>What is wrong with the operation or unknown about it</source>
        <translation>Ce qui ne va pas dans l&apos;opération ou reste inconnu</translation>
    </message>
    <message>
        <source>Number of straight moves, arcs chopped</source>
        <translation>Nombre de mouvements droits, arcs découpés</translation>
    </message>
    <message>
        <source>Cutting length in mm</source>
        <translation>Longueur de coupe en mm</translation>
    </message>
    <message>
        <source>Simulator whose time and memory are given</source>
        <translation>Simulateur dont le temps et la mémoire sont donnés</translation>
    </message>
    <message>
        <source>Estimated time of simulating it, in seconds</source>
        <translation>Temps estimé de sa simulation, en secondes</translation>
    </message>
    <message>
        <source>Estimated memory of simulating it, in bytes</source>
        <translation>Mémoire estimée de sa simulation, en octets</translation>
    </message>
    <message>
        <source>Of the path, tool and stock analysed</source>
        <translation>Du parcours, de l&apos;outil et du brut analysés</translation>
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
        <source>{trajectories} trajectories, {length} cutting</source>
        <translation>{trajectories} trajectoires, {length} en coupe</translation>
    </message>
    <message>
        <source>Simulating it takes {time} and {memory}</source>
        <translation>Sa simulation prend {time} et {memory}</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Périmé : le parcours, l&apos;outil ou le brut ont changé depuis. Analysez à nouveau.</translation>
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
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
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
        <source>Last calibrated on {date}: the legacy simulator makes {moves} cuts a second, its times are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation>Dernier étalonnage le {date} : l&apos;ancien simulateur fait {moves} coupes par seconde, ses temps sont justes à un facteur {factor} près. Mesuré avec FreeCAD {freecad} sur {processor}, affichage {renderer}.</translation>
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
        <source>The simulator whose time and memory the marks show. FreeCAD 0.20 has no OpenGL simulator.</source>
        <translation>Le simulateur dont les marques montrent le temps et la mémoire. FreeCAD 0.20 n&apos;a pas de simulateur OpenGL.</translation>
    </message>
    <message>
        <source>Extended z-buffer</source>
        <translation>Z-buffer étendu</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s legacy simulator</source>
        <translation>Ancien simulateur de FreeCAD</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s OpenGL simulator</source>
        <translation>Simulateur OpenGL de FreeCAD</translation>
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
        <source>From where the z-buffer looks at the part.</source>
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
        <source>Legacy simulator accuracy</source>
        <translation>Précision de l&apos;ancien simulateur</translation>
    </message>
    <message>
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation>Arête de ses cellules en pour cent du plus long côté du brut : 0,1 est la position la plus fine de son curseur, 1 la plus grossière.</translation>
    </message>
    <message>
        <source>OpenGL simulator quality</source>
        <translation>Qualité du simulateur OpenGL</translation>
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
        <source>{} operations analyzed</source>
        <translation>{} opérations analysées</translation>
    </message>
    <message>
        <source>{} with remarks</source>
        <translation>{} avec remarques</translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation>Les marques sont dans la colonne Description de l&apos;arborescence, désormais visible. Vous pouvez la masquer à nouveau par le menu contextuel de l&apos;arborescence : paramètres de l&apos;arborescence, afficher la description.</translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation>Analyse des parcours d&apos;outil</translation>
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
        <source>{} marks removed</source>
        <translation>{} marques enlevées</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation>Application de Gauss</translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge, the longest first.</source>
        <translation>Les zones que l&apos;outil usine sans déplacement rapide ni plongée, la plus longue d&apos;abord.</translation>
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
        <source>{}: no cutting move has a direction in the plane</source>
        <translation>{} : aucun mouvement de coupe n&apos;a de direction dans le plan</translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation>Zone {} : {} trajectoires, {}</translation>
    </message>
    <message>
        <source>{}: φ from {} to {}, level n from {} to {}, {} exact reversals</source>
        <translation>{} : φ de {} à {}, niveau n de {} à {}, {} demi-tours exacts</translation>
    </message>
    <message>
        <source>; closed, with its last turn φ = {}</source>
        <translation> ; fermé, avec le dernier virage φ = {}</translation>
    </message>
    <message>
        <source>Toolpath drawn with {} of {} points: the others fall on the same pixels.</source>
        <translation>Parcours dessiné avec {} points sur {} : les autres tombent sur les mêmes pixels.</translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation>Application de Gauss des {} dernières trajectoires jusqu&apos;à k.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. A zigzag goes to and fro on a part of the circle, a contour goes all around. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path leaves the dashed lines ±2π, a zigzag stays within.&lt;/p&gt;</source>
        <translation>&lt;p&gt;À gauche, le parcours d&apos;outil avec le vecteur V&lt;sub&gt;k&lt;/sub&gt; issu du premier point de la zone. Sur le cercle unité, les images de la trajectoire v&lt;sub&gt;k&lt;/sub&gt; et de V&lt;sub&gt;k&lt;/sub&gt; ; les arcs montrent leur mouvement. Un zigzag va et vient sur une partie du cercle, un contour en fait le tour. À droite, la fonction angulaire cumulée φ et l&apos;angle θ au niveau n : un parcours à contours parallèles sort des lignes tiretées ±2π, un zigzag reste entre elles.&lt;/p&gt;</translation>
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
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation>Résultats des parcours</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exporter en CSV…</translation>
    </message>
    <message>
        <source>Saves all numbers as a table for a spreadsheet.</source>
        <translation>Enregistre tous les nombres comme tableau pour un tableur.</translation>
    </message>
    <message>
        <source>Export JSON…</source>
        <translation>Exporter en JSON…</translation>
    </message>
    <message>
        <source>Saves all numbers for a program.</source>
        <translation>Enregistre tous les nombres pour un programme.</translation>
    </message>
    <message>
        <source>Copy to clipboard</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copies the table as it stands here.</source>
        <translation>Copie le tableau tel qu&apos;il est ici.</translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation>Rien n&apos;est encore analysé dans ce document : cliquez sur « Analyser les parcours d&apos;outil ».</translation>
    </message>
    <message>
        <source>Select an operation to read why it has its strategy.</source>
        <translation>Sélectionnez une opération pour lire pourquoi elle a sa stratégie.</translation>
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
        <source>Shows the analyzed operations as a table: strategy, lengths, what simulating them costs in each simulator, and what is wrong with them.</source>
        <translation>Montre les opérations analysées dans un tableau : stratégie, longueurs, coût de leur simulation dans chaque simulateur, et ce qui ne va pas.</translation>
    </message>
    <message>
        <source>a lower bound: the cost of some operations is not known</source>
        <translation>un minimum : le coût de certaines opérations n&apos;est pas connu</translation>
    </message>
    <message>
        <source>{job}: {count} operation</source>
        <translation>{job} : {count} opération</translation>
    </message>
    <message>
        <source>{job}: {count} operations</source>
        <translation>{job} : {count} opérations</translation>
    </message>
    <message>
        <source>outdated: toolpath, tool or stock have changed since</source>
        <translation>périmé : le parcours, l&apos;outil ou le brut ont changé depuis</translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy}</source>
        <translation>appelée {name}, mais son parcours est : {strategy}</translation>
    </message>
    <message>
        <source>not in the total: a dress-up stands for it, or it is switched off</source>
        <translation>hors du total : un complément la remplace, ou elle est désactivée</translation>
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
        <source>Trajectories</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Number of straight moves, arcs chopped</source>
        <translation>Nombre de mouvements droits, arcs découpés</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Longueur des mouvements de coupe</translation>
    </message>
    <message>
        <source>Z-buffer
time</source>
        <translation>Z-buffer
temps</translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer</source>
        <translation>Temps de sa simulation dans un z-buffer étendu</translation>
    </message>
    <message>
        <source>Z-buffer
memory</source>
        <translation>Z-buffer
mémoire</translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer</source>
        <translation>Mémoire de sa simulation dans un z-buffer étendu</translation>
    </message>
    <message>
        <source>Legacy
time</source>
        <translation>Ancien sim.
temps</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward at its finest accuracy</source>
        <translation>Temps de l&apos;ancien simulateur de FreeCAD en avance rapide, à sa précision la plus fine</translation>
    </message>
    <message>
        <source>Legacy
memory</source>
        <translation>Ancien sim.
mémoire</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator at its finest accuracy</source>
        <translation>Mémoire de l&apos;ancien simulateur de FreeCAD, à sa précision la plus fine</translation>
    </message>
    <message>
        <source>OpenGL
time</source>
        <translation>OpenGL
temps</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <translation>Temps du simulateur OpenGL de FreeCAD à sa plus grande vitesse</translation>
    </message>
    <message>
        <source>OpenGL
memory</source>
        <translation>OpenGL
mémoire</translation>
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
        <source>Remarks</source>
        <translation>Remarques</translation>
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
