<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognized from the toolpath</source>
        <translation>Aus dem Werkzeugweg erkannte Bearbeitungsstrategie</translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation>Warum diese Strategie</translation>
    </message>
    <message>
        <source>What the mark in the description says</source>
        <extracomment>The results of this session.</extracomment>
        <translation>Was die Markierung in der Beschreibung sagt</translation>
    </message>
    <message>
        <source>How sure the recognition is, in percent</source>
        <translation>Wie sicher die Erkennung ist, in Prozent</translation>
    </message>
    <message>
        <source>What is wrong with the operation, unknown about it, or to be known before simulating it</source>
        <translation>Was an der Operation falsch oder unbekannt ist, oder was vor dem Simulieren zu wissen ist</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Länge der schneidenden Bewegungen</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>Zeit auf der Maschine</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows</source>
        <translation>Geschätzte Zeit der Simulation, die die Markierung zeigt</translation>
    </message>
</context>
<context>
    <name>Pills</name>
    <message>
        <source>outdated</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>{} operation</source>
        <translation>{} Operation</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} Operationen</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Veraltet: Werkzeugweg, Werkzeug oder Rohteil wurden seither geändert. Bitte neu analysieren.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known: analyze it again.</source>
        <translation>Die Zeit mit „{simulator}“ ist nicht bekannt: Noch einmal analysieren.</translation>
    </message>
    <message>
        <source>{strategy}, {share} sure</source>
        <translation>{strategy}, zu {share} sicher</translation>
    </message>
    <message>
        <source>On the machine: {length} of cutting</source>
        <translation>Auf der Maschine: {length} Schnittweg</translation>
    </message>
    <message>
        <source>On the machine: {time}, {length} of cutting</source>
        <translation>Auf der Maschine: {time}, {length} Schnittweg</translation>
    </message>
    <message>
        <source>On the machine: at least {time}, {length} of cutting</source>
        <translation>Auf der Maschine: mindestens {time}, {length} Schnittweg</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: {time}, {memory}</source>
        <translation>Simulieren mit „{simulator}“: {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: at least {time}, {memory}</source>
        <translation>Simulieren mit „{simulator}“: mindestens {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it alone in the {simulator}: {time}, {memory}</source>
        <translation>Allein simulieren mit „{simulator}“: {time}, {memory}</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>nothing cuts: there are only rapid moves</source>
        <translation>nichts schneidet: Es gibt nur Eilgänge</translation>
    </message>
    <message>
        <source>nothing cuts: there are no moves</source>
        <translation>nichts schneidet: Es gibt keine Bewegungen</translation>
    </message>
    <message>
        <source>, counter-clockwise</source>
        <translation>, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>, clockwise</source>
        <translation>, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>descending at a constant radius</source>
        <translation>mit gleichbleibendem Radius absteigend</translation>
    </message>
    <message>
        <source>the sense of nested loops alternates</source>
        <translation>der Drehsinn der geschachtelten Schleifen wechselt</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>in der Ebene gleichmäßig verteilt, nicht in der Tiefe</translation>
    </message>
    <message>
        <source>whose shape changes with the depth</source>
        <translation>deren Form sich mit der Tiefe ändert</translation>
    </message>
    <message>
        <source>a winding with a helical entry or bites out of the corners</source>
        <translation>eine Windung mit Helix-Eintritt oder Bissen in den Ecken</translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation>eine Windung, die sich nie schließt</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>geschachtelt</translation>
    </message>
    <message>
        <source>small loops move along</source>
        <translation>kleine Schleifen wandern voran</translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation>eine offene Bahn liegt in einer Kontur</translation>
    </message>
    <message>
        <source>no nested offsets</source>
        <translation>keine ineinander liegenden Bahnen</translation>
    </message>
    <message>
        <source>half-turns alternate in sign</source>
        <translation>die halben Drehungen wechseln das Vorzeichen</translation>
    </message>
    <message>
        <source>all rows run the same way</source>
        <translation>alle Zeilen laufen in die gleiche Richtung</translation>
    </message>
    <message>
        <source>open contours change with the depth</source>
        <translation>offene Konturen ändern sich mit der Tiefe</translation>
    </message>
    <message>
        <source>one open contour</source>
        <translation>eine offene Kontur</translation>
    </message>
    <message>
        <source>an open contour comes again</source>
        <translation>eine offene Kontur kehrt wieder</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>offene Züge so lang wie das Werkstück</translation>
    </message>
    <message>
        <source>short strokes that fill nothing</source>
        <translation>kurze Züge, die nichts ausfüllen</translation>
    </message>
    <message>
        <source>no cutting move in its toolpath</source>
        <translation>keine Schnittbewegung in ihrem Werkzeugweg</translation>
    </message>
    <message>
        <source>no toolpath: recompute the operation and see FreeCAD&apos;s report view</source>
        <translation>kein Werkzeugweg: Operation neu berechnen und das Ausgabefenster von FreeCAD ansehen</translation>
    </message>
    <message>
        <source>no tool: give the operation a tool controller</source>
        <translation>kein Werkzeug: Der Operation einen Werkzeugcontroller geben</translation>
    </message>
    <message>
        <source>no tool in {label}: choose a tool bit for it</source>
        <translation>kein Werkzeug in {label}: Dafür ein Werkzeug wählen</translation>
    </message>
    <message>
        <source>the tool in {label} has no diameter</source>
        <translation>das Werkzeug in {label} hat keinen Durchmesser</translation>
    </message>
    <message>
        <source>no stock: put the toolpath into a job</source>
        <translation>kein Rohteil: Den Werkzeugweg in einen Auftrag legen</translation>
    </message>
    <message>
        <source>no stock: give {label} a stock</source>
        <translation>kein Rohteil: {label} ein Rohteil geben</translation>
    </message>
    <message>
        <source>cost unknown for {labels}</source>
        <translation>Aufwand unbekannt für {labels}</translation>
    </message>
    <message>
        <source>words without a motion before them are ignored</source>
        <translation>Wörter ohne Bewegung davor übergangen</translation>
    </message>
    <message>
        <source>a feed rate that is not a usable number is ignored</source>
        <translation>Vorschub, der keine brauchbare Zahl ist, übergangen</translation>
    </message>
    <message>
        <source>center words (I, J, K) that are not usable numbers are ignored</source>
        <translation>Mittelpunktswort (I, J, K), das keine brauchbare Zahl ist, übergangen</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored</source>
        <translation>{letter}-Wort, das keine brauchbare Zahl ist, übergangen</translation>
    </message>
    <message>
        <source>positions beyond a kilometer are cut off there</source>
        <translation>Position jenseits eines Kilometers dort abgeschnitten</translation>
    </message>
    <message>
        <source>a drilling cycle without a depth (Z) drills nothing</source>
        <translation>Bohrzyklus ohne Tiefe (Z): kein Loch</translation>
    </message>
    <message>
        <source>a drilling cycle without R starts at the current height</source>
        <translation>Bohrzyklus ohne R: Er beginnt, wo er steht</translation>
    </message>
    <message>
        <source>a drilling cycle outside the XY plane is read as one in XY</source>
        <translation>Bohrzyklus außerhalb der XY-Ebene wie in XY gelesen</translation>
    </message>
    <message>
        <source>an arc whose start is not known is ignored</source>
        <translation>Bogen mit noch unbekanntem Anfang übergangen</translation>
    </message>
    <message>
        <source>an arc without a usable center or radius is read as a line</source>
        <translation>Bogen ohne brauchbaren Mittelpunkt oder Radius als Linie gelesen</translation>
    </message>
    <message>
        <source>an arc whose end is not on its circle is read with a changing radius</source>
        <translation>Bogen, dessen Ende nicht auf seinem Kreis liegt, mit veränderlichem Radius gelesen</translation>
    </message>
    <message>
        <source>without an X or Y word</source>
        <translation>dem ein X- oder Y-Wort fehlt</translation>
    </message>
    <message>
        <source>without a Z word</source>
        <translation>dem ein Z-Wort fehlt</translation>
    </message>
    <message>
        <source>without a center</source>
        <translation>dem der Mittelpunkt fehlt</translation>
    </message>
    <message>
        <source>that is a full circle</source>
        <translation>der ein Vollkreis ist</translation>
    </message>
    <message>
        <source>leave this operation out of the simulation</source>
        <translation>diese Operation bei der Simulation auslassen</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>zu tief</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>zu hoch</translation>
    </message>
    <message>
        <source>move its accuracy slider to the left</source>
        <translation>seinen Genauigkeitsregler nach links schieben</translation>
    </message>
    <message>
        <source>simulate fewer operations at a time</source>
        <translation>weniger Operationen auf einmal simulieren</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>den Speicher</translation>
    </message>
    <message>
        <source>time</source>
        <translation>die Zeit</translation>
    </message>
    <message>
        <source>no resolution helps, not even a single pixel fits</source>
        <translation>keine Auflösung hilft, nicht einmal ein Pixel passt</translation>
    </message>
    <message>
        <source>the cost is that of a box around its cuts</source>
        <translation>der Aufwand ist der eines Quaders um ihre Schnitte</translation>
    </message>
    <message>
        <source>it does not touch the stock: check its depths, its placement and the stock</source>
        <translation>sie berührt das Rohteil nicht: Tiefen, Platzierung und Rohteil prüfen</translation>
    </message>
    <message>
        <source>its tool is wider than the stock: check the tool&apos;s diameter and the stock</source>
        <translation>ihr Werkzeug ist breiter als das Rohteil: Durchmesser und Rohteil prüfen</translation>
    </message>
    <message>
        <source>choose a smaller image in the preferences</source>
        <translation>in den Einstellungen ein kleineres Bild wählen</translation>
    </message>
    <message>
        <source>that sweeps no angle</source>
        <translation>der keinen Winkel überstreicht</translation>
    </message>
    <message>
        <source>about {number}</source>
        <translation>etwa {number}</translation>
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
        <translation>Der Eckenradius muss zwischen 0 und {radius:mm} liegen, nicht {corner:mm} sein</translation>
    </message>
    <message>
        <source>the tip angle must lie between 0 and pi, not be {angle:g}</source>
        <translation>Der Spitzenwinkel muss zwischen 0 und π liegen, nicht {angle:g} sein</translation>
    </message>
    <message>
        <source>the stock has no volume: its upper corner must exceed its lower corner in x, y and z</source>
        <translation>Das Rohteil hat kein Volumen: Seine obere Ecke muss in x, y und z über der unteren liegen</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} move without a feed rate are not in the time</source>
        <translation>{length:mm4} Schnitt in {count:n} Bewegung ohne Vorschub fehlen in der Zeit</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time</source>
        <translation>{length:mm4} Schnitt in {count:n} Bewegungen ohne Vorschub fehlen in der Zeit</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} is 0</source>
        <translation>{length:mm4} Eilgänge fehlen in der Zeit, weil {name} des Werkzeugcontrollers 0 ist</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} and {other} are 0</source>
        <translation>{length:mm4} Eilgänge fehlen in der Zeit, weil {name} und {other} des Werkzeugcontrollers 0 sind</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> und {count:n} weitere</translation>
    </message>
    <message>
        <source>; passes {step:mm3} apart ask for {cell:mm2}</source>
        <translation>; Bahnen im Abstand von {step:mm3} verlangen {cell:mm2}</translation>
    </message>
    <message>
        <source>; {cell:mm2} would do for passes {step:mm3} apart</source>
        <translation>; {cell:mm2} würden für Bahnen im Abstand von {step:mm3} genügen</translation>
    </message>
    <message>
        <source>no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}</source>
        <translation>keine Auflösung hilft, allein die Bewegungen brauchen {time:s}: weniger Operationen simulieren{heaviest}</translation>
    </message>
    <message>
        <source>; the heaviest is {label} with {time:s}</source>
        <translation>; am schwersten wiegt {label} mit {time:s}</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> und 1 weiterer</translation>
    </message>
    <message>
        <source>{sentence} (command {command:#})</source>
        <translation>{sentence} (Befehl {command:#})</translation>
    </message>
    <message>
        <source>{sentence} ({count:n} times, first at command {command:#})</source>
        <translation>{sentence} ({count:n}-mal, zuerst bei Befehl {command:#})</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored</source>
        <translation>unbekannter Code {name} übergangen</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored</source>
        <translation>1 weiterer unbekannter Code übergangen</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored</source>
        <translation>{count:n} weitere unbekannte Codes übergangen</translation>
    </message>
    <message>
        <source>the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance</source>
        <translation>die Bögen und Zyklen bräuchten bei einer Toleranz von {tolerance:mm} {moves:n} Bewegungen; eine größere Toleranz wählen</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}: {sentence}</translation>
    </message>
    <message>
        <source>could not be analyzed, please report it with the file: {error}</source>
        <translation>konnte nicht analysiert werden, bitte mit der Datei melden: {error}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über {count:n} Zeilen{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über {count:n} Zeilen{spread} bei 0, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über einen offenen Zug{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über {count:n} offene Züge{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über einen offenen Zug{spread} bei 0, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über {count:n} offene Züge{spread} bei 0, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ erreicht über eine Schleife{spread} {reached:turns} Umdrehungen, {seen}: {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ erreicht über {count:n} Schleifen{spread} {reached:turns} Umdrehungen, {seen}: {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}</source>
        <translation>φ liegt zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}</source>
        <translation>φ hat keine Richtung, die Bewegungen sind an einem Punkt senkrecht: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}</source>
        <translation>φ hat keine Richtung, die Bewegungen sind an {count:n} Punkten senkrecht: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}</source>
        <translation>φ hat keine Richtung, die Bewegungen sind an einigen Punkten senkrecht: {strategy:strategy}</translation>
    </message>
    <message>
        <source>{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: {strategy:strategy}</source>
        <translation>{count:n} Abschnitte, getrennt durch Werkzeugwechsel, Titel, Rückzüge oder Bohren, zeigen {strategies:strategy}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation> im Abstand von {step:mm3} auf {depths:n} Tiefen</translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation> im Abstand von {step:mm3}</translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation> auf {depths:n} Tiefen</translation>
    </message>
    <message>
        <source>{count:n} bites of one sense overlap</source>
        <translation>{count:n} Bisse mit gleichem Drehsinn überlappen sich</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) share the area</source>
        <translation>Zeilen ({rows:%} der Länge) und Schleifen ({loops:%}) teilen sich die Fläche</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} bis {high}</translation>
    </message>
    <message>
        <source>{what} (line {line:#})</source>
        <translation>{what} (Zeile {line:#})</translation>
    </message>
    <message>
        <source>{what} ({count:n} times, first in line {line:#})</source>
        <translation>{what} ({count:n}-mal, zuerst in Zeile {line:#})</translation>
    </message>
    <message>
        <source>lines with a block delete (/) are read like the others</source>
        <translation>Zeilen mit Ausblendzeichen (/) werden wie die anderen gelesen</translation>
    </message>
    <message>
        <source>a subprogram or macro call is not read</source>
        <translation>ein Unterprogramm oder Makroaufruf wird nicht gelesen</translation>
    </message>
    <message>
        <source>jumps, loops and calls are not followed</source>
        <translation>Sprüngen, Schleifen und Aufrufen wird nicht gefolgt</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the words with them are left out</source>
        <translation>Variablen und Ausdrücke werden nicht gelesen: die Wörter damit bleiben weg</translation>
    </message>
    <message>
        <source>lines that are not made of words like G1 X10 are left out</source>
        <translation>Zeilen, die nicht aus Wörtern wie G1 X10 bestehen, bleiben weg</translation>
    </message>
    <message>
        <source>coordinates that {name} changes are read as if it were not there</source>
        <translation>Koordinaten, die {name} ändert, werden gelesen, als stünde es nicht da</translation>
    </message>
    <message>
        <source>a spline ({name}) is read as a line</source>
        <translation>ein Spline ({name}) wird als Gerade gelesen</translation>
    </message>
    <message>
        <source>what follows M2 or M30 is read as the same program</source>
        <translation>was auf M2 oder M30 folgt, wird als dasselbe Programm gelesen</translation>
    </message>
    <message>
        <source>what follows the program&apos;s end is not read</source>
        <translation>was auf das Programmende folgt, wird nicht gelesen</translation>
    </message>
    <message>
        <source>a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read</source>
        <translation>ein Programm in der Sprache von {name}-Steuerungen (Zeile {line:#}): als G-Code (ISO) ausgegeben wird es gelesen</translation>
    </message>
    <message>
        <source>not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}</source>
        <translation>kein NC-Programm: {part:n} seiner {lines:n} Zeilen bestehen nicht aus Wörtern wie G1 X10, die erste ist Zeile {line:#}</translation>
    </message>
    <message>
        <source>not an NC program: no line of it moves a tool</source>
        <translation>kein NC-Programm: keine seiner Zeilen bewegt ein Werkzeug</translation>
    </message>
    <message>
        <source>none of its moves can be read: {problems}</source>
        <translation>keine seiner Bewegungen kann gelesen werden: {problems}</translation>
    </message>
    <message>
        <source>not an NC program: it is not text</source>
        <translation>kein NC-Programm: es ist kein Text</translation>
    </message>
    <message>
        <source>a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>ein Programm für eine Drehmaschine ({name}, Zeile {line:#}): Frässtrategien sagen darüber nichts</translation>
    </message>
    <message>
        <source>a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>ein Programm für einen 3D-Drucker ({name}, Zeile {line:#}): Frässtrategien sagen darüber nichts</translation>
    </message>
    <message>
        <source>a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>ein Programm für eine Drahtschneidemaschine ({name}, Zeile {line:#}): Frässtrategien sagen darüber nichts</translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told</source>
        <translation>eine Drehachse dreht, während das Werkzeug schneidet (Zeile {line:#}): der Weg des Werkzeugs ist nicht bekannt</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time: a program does not say how fast they are</source>
        <translation>{length:mm4} Eilgang sind nicht in der Zeit: ein Programm sagt nicht, wie schnell er ist</translation>
    </message>
    <message>
        <source>no tool: the program does not say its diameter, so the cost is not known</source>
        <translation>kein Werkzeug: das Programm nennt seinen Durchmesser nicht, daher ist der Aufwand unbekannt</translation>
    </message>
    <message>
        <source>the file cannot be read: {name}</source>
        <translation>die Datei kann nicht gelesen werden: {name}</translation>
    </message>
    <message>
        <source>the file is larger than {size:bytes}</source>
        <translation>die Datei ist größer als {size:bytes}</translation>
    </message>
    <message>
        <source>given up after {time:s}</source>
        <translation>nach {time:s} aufgegeben</translation>
    </message>
    <message>
        <source>the process that read it died, perhaps for lack of memory</source>
        <translation>der Prozess, der es las, ist gestorben, vielleicht aus Speichermangel</translation>
    </message>
    <message>
        <source>it looks 25.4 times too small: inches read as millimeters?</source>
        <translation>es sieht 25,4-mal zu klein aus: Zoll als Millimeter gelesen?</translation>
    </message>
    <message>
        <source>there is nothing to simulate: choose a job, or operations with a toolpath</source>
        <translation>es gibt nichts zu simulieren: Wählen Sie einen Auftrag oder Operationen mit einem Werkzeugweg</translation>
    </message>
    <message>
        <source>these operations belong to several jobs, choose one of them: {labels}</source>
        <translation>diese Operationen gehören zu mehreren Aufträgen, wählen Sie einen davon: {labels}</translation>
    </message>
    <message>
        <source>extended z-buffer</source>
        <translation>erweiterter Z-Buffer</translation>
    </message>
    <message>
        <source>legacy simulator</source>
        <translation>alter Simulator</translation>
    </message>
    <message>
        <source>OpenGL simulator</source>
        <translation>OpenGL-Simulator</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}.</source>
        <translation>„{simulator:simulator}“ hängt bei einem Bogen, {reason} (Befehl {command:#}{others}): {instead}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>„{simulator:simulator}“ schneidet {count:n} Rampe in falscher Tiefe, bis zu {error:mm2} {way} (Befehl {command:#}): Tiefen nicht danach beurteilen.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>„{simulator:simulator}“ schneidet {count:n} Rampen in falscher Tiefe, bis zu {error:mm2} {way} (Befehl {command:#}): Tiefen nicht danach beurteilen.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.</source>
        <translation>Das Abspielen dauert mit „{simulator:simulator}“ etwa {longer:s}: Der schnelle Vorlauf dauert etwa {time:s}.</translation>
    </message>
    <message>
        <source>Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.</source>
        <translation>Das Abspielen dauert mit „{simulator:simulator}“ auch am schnellsten etwa {time:s}: Weniger Operationen auf einmal simulieren.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time and none is seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>{count:n} Bewegungen sind kürzer als eine Zelle von „{simulator:simulator}“ ({cell:mm2}), jede kostet Zeit und keine ist einzeln zu sehen: Eine gröbere Toleranz der Operation verliert dort nichts.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>„{simulator:simulator}“ braucht für diese Operation etwa {memory:bytes}, mehr als die erlaubten {allowed:bytes}: {instead}.</translation>
    </message>
    <message>
        <source>use the {simulator:simulator} for this operation</source>
        <translation>für diese Operation „{simulator:simulator}“ benutzen</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}</source>
        <translation>Der Werkzeugdurchmesser muss positiv und höchstens ein Kilometer sein, nicht {diameter:mm}</translation>
    </message>
    <message>
        <source>the stock&apos;s corners must be numbers within a kilometer of the origin</source>
        <translation>Die Ecken des Rohteils müssen Zahlen innerhalb eines Kilometers vom Ursprung sein</translation>
    </message>
    <message>
        <source>its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD&apos;s importer keeps them as mm/s</source>
        <translation>Seine Vorschübe, bis zu {feed:g} mm/s, werden als mm/min gelesen: FreeCADs Import behält sie als mm/s</translation>
    </message>
    <message>
        <source>the tip&apos;s diameter must lie between 0 and {diameter:mm}, not be {tip:mm}</source>
        <translation>der Durchmesser der Spitze muss zwischen 0 und {diameter:mm} liegen, nicht {tip:mm} sein</translation>
    </message>
    <message>
        <source>the solid&apos;s surface is not closed</source>
        <translation>die Oberfläche des Körpers ist nicht geschlossen</translation>
    </message>
    <message>
        <source>the box around the stock of {label} is taken for it: {sentence}</source>
        <translation>als Rohteil von {label} gilt der Quader darum herum: {sentence}</translation>
    </message>
    <message>
        <source>{label} is not simulated exactly, but {instead}</source>
        <translation>{label} wird nicht genau simuliert, sondern {instead}</translation>
    </message>
    <message>
        <source>as an end mill of its largest diameter</source>
        <translation>als Schaftfräser mit dem größten Durchmesser</translation>
    </message>
    <message>
        <source>as a ball end of its tip&apos;s diameter</source>
        <translation>als Kugelfräser mit dem Durchmesser der Spitze</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>als Bohrer</translation>
    </message>
    <message>
        <source>a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told</source>
        <translation>Eine Drehachse ({letter}) dreht, während das Werkzeug schneidet: Der Weg des Werkzeugs ist nicht bestimmbar</translation>
    </message>
    <message>
        <source>turns of a rotary axis ({letter}) are not followed</source>
        <translation>Drehungen einer Drehachse ({letter}) werden nicht berücksichtigt</translation>
    </message>
    <message>
        <source>{letter} words are not read</source>
        <translation>{letter}-Wörter werden nicht gelesen</translation>
    </message>
    <message>
        <source>a cycle&apos;s repeats ({letter}) are not made</source>
        <translation>Wiederholungen eines Zyklus ({letter}) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>further turns of an arc (P) are not made</source>
        <translation>Weitere Umdrehungen eines Bogens (P) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>inches (G20) are not followed: lengths are read in mm</source>
        <translation>Zoll (G20) werden nicht berücksichtigt: Längen werden in mm gelesen</translation>
    </message>
    <message>
        <source>cutter compensation ({name}) is not followed: the path is the programmed one</source>
        <translation>Die Radiuskorrektur ({name}) wird nicht berücksichtigt: Der Weg ist der des Programms</translation>
    </message>
    <message>
        <source>feeds after {name} are not read</source>
        <translation>Vorschübe nach {name} werden nicht gelesen</translation>
    </message>
    <message>
        <source>dwells are not in the time</source>
        <translation>Verweilzeiten sind nicht in der Zeit enthalten</translation>
    </message>
    <message>
        <source>open strokes side by side at an even distance</source>
        <translation>offene Züge nebeneinander in gleichem Abstand</translation>
    </message>
    <message>
        <source>open strokes side by side, from one wall to the other</source>
        <translation>offene Züge nebeneinander, von einer Wand zur anderen</translation>
    </message>
    <message>
        <source>many small contours of different shapes</source>
        <translation>viele kleine Konturen verschiedener Form</translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}</source>
        <translation>{count:n} Zeile{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}</source>
        <translation>{count:n} Zeilen{spread}, {seen}</translation>
    </message>
    <message>
        <source>one open cut{spread}, {seen}</source>
        <translation>ein offener Schnitt{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}</source>
        <translation>{count:n} offene Schnitte{spread}, {seen}</translation>
    </message>
    <message>
        <source>one loop{spread}{turning}, {seen}</source>
        <translation>ein Umlauf{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}</source>
        <translation>{count:n} Umläufe{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>straight down at one point</source>
        <translation>an einer Stelle gerade nach unten</translation>
    </message>
    <message>
        <source>straight down at {count:n} points</source>
        <translation>an {count:n} Stellen gerade nach unten</translation>
    </message>
    <message>
        <source>straight down at some points</source>
        <translation>an einigen Stellen gerade nach unten</translation>
    </message>
    <message>
        <source>{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}</source>
        <translation>{count:n} Abschnitte, getrennt durch Werkzeugwechsel, Überschriften, Rückzüge oder Bohren: {strategies:strategy}</translation>
    </message>
    <message>
        <source>{count:n} overlapping bites</source>
        <translation>{count:n} überlappende Bisse</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>einer im Uhrzeigersinn, der nächste dagegen</translation>
    </message>
    <message>
        <source>all in one cut that winds on and never closes</source>
        <translation>alles in einem Schnitt, der sich weiterwindet und nie schließt</translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation>einer im anderen</translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation>keiner im anderen</translation>
    </message>
    <message>
        <source>cut to and fro</source>
        <translation>hin und her geschnitten</translation>
    </message>
    <message>
        <source>all cut the same way</source>
        <translation>alle in derselben Richtung geschnitten</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über eine Zeile{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ bleibt über eine Zeile{spread} bei 0, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>Eine Bewegung ist kürzer als eine Zelle von „{simulator:simulator}“ ({cell:mm2}), braucht ihre Zeit und ist für sich nicht zu sehen: eine gröbere Toleranz der Operation verliert dort nichts.</translation>
    </message>
    <message>
        <source>which lie like those of known toolpaths ({share:%} of the votes)</source>
        <translation>die wie die bekannter Werkzeugwege liegen ({share:%} der Stimmen)</translation>
    </message>
    <message>
        <source>unlike anything that machines ({share:%} of the votes)</source>
        <translation>wie nichts, was etwas fräst ({share:%} der Stimmen)</translation>
    </message>
    <message>
        <source>, entered by a ramp</source>
        <translation>, eingetaucht auf einer Rampe</translation>
    </message>
    <message>
        <source>, entered by a ramp to and fro</source>
        <translation>, eingetaucht auf einer Rampe hin und her</translation>
    </message>
    <message>
        <source>, entered by a helix</source>
        <translation>, eingetaucht auf einer Helix</translation>
    </message>
    <message>
        <source>, finished by a contour around the rows</source>
        <translation>, geschlichtet mit einer Kontur um die Zeilen</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>„{simulator:simulator}“ bleibt daran hängen: Befehl {command:#} von {label}{others} ist ein Bogen, {reason}.</translation>
    </message>
    <message>
        <source> (also in another operation)</source>
        <translation> (und eine weitere Operation)</translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
        <translation> (und {count:n} weitere Operationen)</translation>
    </message>
    <message>
        <source>Playing this takes {bound} {time:s} in the {simulator:simulator}.</source>
        <translation>{simulator:simulator}: Das Abspielen dauert {bound} {time:s}.</translation>
    </message>
    <message>
        <source>Fast-forward takes {bound} {time:s}.</source>
        <translation>Der schnelle Vorlauf dauert {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} in fast-forward: {bound} {time:s}.</source>
        <translation>{simulator:simulator} im schnellen Vorlauf: {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator}: {bound} {time:s}.</source>
        <translation>{simulator:simulator}: {bound} {time:s}.</translation>
    </message>
    <message>
        <source>about</source>
        <translation>etwa</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>mindestens</translation>
    </message>
    <message>
        <source>Simulate toolpaths shows the finished part at once, coarse at first.</source>
        <translation>„Werkzeugwege simulieren“ zeigt sofort das fertige Teil, zuerst grob.</translation>
    </message>
    <message>
        <source>a rapid move removes {volume:mm³2}</source>
        <translation>ein Eilgang trägt {volume:mm³2} ab</translation>
    </message>
    <message>
        <source>plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}</source>
        <translation>taucht mit {feed:mm/min3} ins volle Material ein, ihr Werkzeug darf {allowed:mm/min3}</translation>
    </message>
    <message>
        <source>{depth:mm2} are left on the model</source>
        <translation>{depth:mm2} bleiben auf dem Modell stehen</translation>
    </message>
    <message>
        <source>a finer picture would take longer than the {allowed:s} that the preferences allow</source>
        <translation>ein feineres Bild würde länger als die {allowed:s} dauern, die die Einstellungen erlauben</translation>
    </message>
    <message>
        <source>as simulated, command {command:#} is wrong: {fault}</source>
        <translation>laut Simulation ist Befehl {command:#} falsch: {fault}</translation>
    </message>
    <message>
        <source>moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}</source>
        <translation>Bewegungen nur in X und Z, mit Schnitten längs Z bei vielen X, wie eine Drehmaschine sie macht: {strategy:strategy}</translation>
    </message>
    <message>
        <source>the operation&apos;s placement must be numbers within a kilometer of the origin</source>
        <translation>die Platzierung der Operation muss aus Zahlen innerhalb eines Kilometers vom Ursprung bestehen</translation>
    </message>
    <message>
        <source>a line with two {letter} words: the last one is read</source>
        <translation>eine Zeile mit zwei {letter}-Wörtern: das letzte wird gelesen</translation>
    </message>
    <message>
        <source>a line with two motions, such as G0 and G1: the last one is read</source>
        <translation>eine Zeile mit zwei Bewegungen, etwa G0 und G1: die letzte wird gelesen</translation>
    </message>
    <message>
        <source>{told}, with a little {strategies:strategy} beside it</source>
        <translation>{told}, daneben ein wenig {strategies:strategy}</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}</source>
        <translation>{width:n} × {height:n} Pixel von {pixel:mm2}, begrenzt durch {limit}{passes}</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds</source>
        <translation>{length:mm4} Eilgänge fehlen in der Zeit, weil die Operation keinen Werkzeugcontroller hat: ihr einen mit Eilganggeschwindigkeiten geben</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the lines with them are left out</source>
        <translation>Variablen und Ausdrücke werden nicht gelesen: die Zeilen damit bleiben weg</translation>
    </message>
    <message>
        <source>moves to positions of the machine ({name}) are left out: a program does not say where they are</source>
        <translation>Bewegungen zu Maschinenpositionen ({name}) bleiben weg: ein Programm sagt nicht, wo sie sind</translation>
    </message>
    <message>
        <source>the holes of a pattern ({name}) are not made</source>
        <translation>die Löcher eines Lochbilds ({name}) werden nicht ausgeführt</translation>
    </message>
    <message>
        <source>it spans meters in whole numbers: thousandths without a decimal point read as whole units?</source>
        <translation>es ist meterlang, und das in ganzen Zahlen: Tausendstel ohne Dezimalpunkt als ganze Einheiten gelesen?</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: simulate this operation alone.</source>
        <translation>„{simulator:simulator}“ braucht am Ende etwa {time:s} für jedes Bild, {percent:n} % davon für Bögen: Diese Operation allein simulieren.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}</source>
        <translation>„{simulator:simulator}“ braucht {bound} {time:s}, länger als die erlaubten {allowed:s}. {better}</translation>
    </message>
    <message>
        <source>the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles</source>
        <translation>die Mittelpunkte von Kreisbögen werden als Positionen gelesen (wie bei G90.1): nur so enden die Bögen auf ihren Kreisen</translation>
    </message>
    <message>
        <source>strokes that rise to their ends, as V-carving does</source>
        <translation>Züge, die zu ihren Enden hin ansteigen, wie beim V-Carving</translation>
    </message>
    <message>
        <source>cut in strokes, as between tags</source>
        <translation>in Zügen geschnitten, wie zwischen Haltestegen</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored, and with it the {letters} words of its line</source>
        <translation>unbekannter Code {name} übergangen, und mit ihm die Wörter {letters} seiner Zeile</translation>
    </message>
    <message>
        <source>probing moves are not in the time</source>
        <translation>Antastbewegungen sind nicht in der Zeit enthalten</translation>
    </message>
    <message>
        <source>cuts {depth:mm2} into the model</source>
        <translation>schneidet {depth:mm2} tief in das Modell</translation>
    </message>
    <message>
        <source>as simulated, {count:n} commands are wrong, among them {command:#}: {fault}</source>
        <translation>laut Simulation sind {count:n} Befehle falsch, darunter {command:#}: {fault}</translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy:strategy}</source>
        <translation>heißt {name}, doch ihr Werkzeugweg ist: {strategy:strategy}</translation>
    </message>
    <message>
        <source>not an NC program, but a zip archive: unpack it first</source>
        <translation>kein NC-Programm, sondern ein ZIP-Archiv: zuerst entpacken</translation>
    </message>
    <message>
        <source>not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro examples/macros/folder_to_csv.py</source>
        <translation>kein NC-Programm, sondern ein FreeCAD-Dokument: in FreeCAD analysieren, einen ganzen Ordner mit dem Makro examples/macros/folder_to_csv.py</translation>
    </message>
    <message>
        <source>lacks {depth:mm2} of the model: choose a larger stock, or move the model within it</source>
        <translation>ihm fehlen {depth:mm2} des Modells: ein größeres Rohteil wählen oder das Modell darin verschieben</translation>
    </message>
    <message>
        <source>switched off: it has no toolpath until you switch it on and recompute it</source>
        <translation>ausgeschaltet: Sie hat keinen Werkzeugweg, bis sie eingeschaltet und neu berechnet wird</translation>
    </message>
    <message>
        <source>this is no file, but a pipe or a device</source>
        <translation>das ist keine Datei, sondern eine Pipe oder ein Gerät</translation>
    </message>
    <message>
        <source>it does not touch the stock, which is the finished part: choose a block around it as the stock</source>
        <translation>sie berührt das Rohteil nicht, das schon das fertige Teil ist: als Rohteil einen Block darum wählen</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>Die Simulation braucht in der Spitze etwa {memory:bytes}, für {dexels:n} Dexel und {traces:n} Spurelemente, mehr als die erlaubten {allowed:bytes}: {instead}.</translation>
    </message>
    <message>
        <source>choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations</source>
        <translation>ein Bild von {width:n} × {height:n} Pixel zu {pixel:mm2} wählen oder weniger Operationen simulieren</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>No strategy, or several.</extracomment>
        <translation>Zickzack</translation>
    </message>
    <message>
        <source>one-way</source>
        <translation>eine Richtung</translation>
    </message>
    <message>
        <source>contour-parallel</source>
        <translation>konturparallel</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Kontur</translation>
    </message>
    <message>
        <source>waterline</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>Helix</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>engraving</source>
        <translation>Gravieren</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Never calibrated on this computer: times of FreeCAD&apos;s simulators are right within a factor of two.</source>
        <translation>Auf diesem Computer noch nie kalibriert: Die Zeiten der FreeCAD-Simulatoren stimmen auf einen Faktor zwei genau.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation>Markierungen im Baum</translation>
    </message>
    <message>
        <source>Time and memory of</source>
        <translation>Zeit und Speicher von</translation>
    </message>
    <message>
        <source>Shows the marks as colored pills in the tree; as plain text if switched off.</source>
        <translation>Zeigt die Markierungen im Baum als farbige Schildchen; ausgeschaltet als einfachen Text.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Markierungen als Schildchen zeigen</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. Large toolpaths make each recompute longer.</source>
        <translation>Analysiert markierte Operationen nach jeder Neuberechnung, die sie geändert hat, erneut. Bei großen Werkzeugwegen dauert jede Neuberechnung länger.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Nach einer Neuberechnung erneut analysieren</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>How long a simulation may take. The analysis warns of more, and recommends an accuracy that takes no longer.</source>
        <translation>Wie lange eine Simulation dauern darf. Die Analyse warnt, wenn es länger dauert, und empfiehlt eine Genauigkeit, die ausreicht.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>How much memory a simulation may take. The analysis warns of more, and recommends an accuracy that takes no more.</source>
        <translation>Wie viel Speicher eine Simulation brauchen darf. Die Analyse warnt, wenn es mehr ist, und empfiehlt eine Genauigkeit, die ausreicht.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Z-buffer image width</source>
        <translation>Bildbreite des Z-Buffers</translation>
    </message>
    <message>
        <source>Width of the image whose pixels the extended z-buffer computes.</source>
        <translation>Breite des Bildes, dessen Pixel der erweiterte Z-Buffer berechnet.</translation>
    </message>
    <message>
        <source>Z-buffer image height</source>
        <translation>Bildhöhe des Z-Buffers</translation>
    </message>
    <message>
        <source>Height of the image whose pixels the extended z-buffer computes.</source>
        <translation>Höhe des Bildes, dessen Pixel der erweiterte Z-Buffer berechnet.</translation>
    </message>
    <message>
        <source>Z-buffer view</source>
        <translation>Ansicht des Z-Buffers</translation>
    </message>
    <message>
        <source>Where the z-buffer looks at the part from.</source>
        <translation>Von wo der Z-Buffer auf das Werkstück blickt.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorne</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation>Kantenlänge seiner Zellen in Prozent der längeren Seite des Rohteils: 0,1 ist die feinste Stellung seines Reglers, 1 die gröbste.</translation>
    </message>
    <message>
        <source>Position of its quality slider; 10 is the best.</source>
        <translation>Stellung seines Qualitätsreglers; 10 ist die beste.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Bogentoleranz</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves it is chopped into.</source>
        <translation>Größter Abstand zwischen einem Bogen und den geraden Bewegungen, in die er zerlegt wird.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Measures how fast FreeCAD&apos;s simulators are on this computer, which takes about a second, and remembers it.</source>
        <translation>Misst in etwa einer Sekunde, wie schnell die FreeCAD-Simulatoren auf diesem Computer sind, und merkt es sich.</translation>
    </message>
    <message>
        <source>That of FreeCAD&apos;s button: {simulator}</source>
        <translation>Der von FreeCADs Knopf: {simulator}</translation>
    </message>
    <message>
        <source>{simulator}: accuracy</source>
        <translation>{simulator}: Genauigkeit</translation>
    </message>
    <message>
        <source>{simulator}: quality</source>
        <translation>{simulator}: Qualität</translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. They follow at once.</source>
        <translation>Der Simulator, dessen Zeit die Markierungen zeigen. Sie folgen sofort.</translation>
    </message>
    <message>
        <source>Says over the view, when one of FreeCAD&apos;s simulators is started, that it would hang or take longer than the budget, and offers the better way.</source>
        <translation>Sagt über der Ansicht, wenn einer der Simulatoren von FreeCAD gestartet wird, dass er hängen bliebe oder länger als das Budget brauchte, und bietet den besseren Weg an.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Vor hängenden oder langsamen Simulatoren warnen</translation>
    </message>
    <message>
        <source>Last calibrated on {date}: times of the {simulator} are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation>Zuletzt kalibriert am {date}: Zeiten von „{simulator}“ stimmen bis auf den Faktor {factor}. Gemessen mit FreeCAD {freecad} auf {processor}, Anzeige {renderer}.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document, estimates what simulating it costs, and marks it in the tree.</source>
        <translation>Erkennt die Bearbeitungsstrategie jeder ausgewählten Operation oder aller Operationen des aktiven Dokuments, schätzt den Aufwand ihrer Simulation und markiert sie im Baum.</translation>
    </message>
    <message>
        <source>Analyze toolpaths</source>
        <translation>Werkzeugwege analysieren</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>Es ist kein Dokument geöffnet. Öffnen Sie zuerst eines mit einem Auftrag oder einem Werkzeugweg.</translation>
    </message>
    <message>
        <source>Analysis cancelled, nothing changed.</source>
        <translation>Analyse abgebrochen, nichts wurde geändert.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>In diesem Dokument gibt es keine Operation zu analysieren. Legen Sie einen Auftrag mit Operationen an oder importieren Sie G-Code.</translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation>Die Markierungen stehen in der Spalte „Beschreibung“ des Baums, die jetzt sichtbar ist. Im Kontextmenü des Baums lässt sie sich wieder ausblenden: Baumeinstellungen, Beschreibung anzeigen.</translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>{count} operation analyzed</source>
        <translation>{count} Operation analysiert</translation>
    </message>
    <message>
        <source>{count} operations analyzed</source>
        <translation>{count} Operationen analysiert</translation>
    </message>
    <message>
        <source>{count} has a warning</source>
        <translation>{count} mit einer Warnung</translation>
    </message>
    <message>
        <source>{count} have warnings</source>
        <translation>{count} mit Warnungen</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Es wird gemessen, wie schnell dieser Rechner simuliert…</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document; your own descriptions stay.</source>
        <translation>Entfernt die Markierungen der ausgewählten Operationen oder alle des aktiven Dokuments; Ihre eigenen Beschreibungen bleiben.</translation>
    </message>
    <message>
        <source>Clear analysis</source>
        <translation>Analyse löschen</translation>
    </message>
    <message>
        <source>{count} mark removed</source>
        <translation>{count} Markierung entfernt</translation>
    </message>
    <message>
        <source>{count} marks removed</source>
        <translation>{count} Markierungen entfernt</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation>Gauß-Abbildung</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern…</translation>
    </message>
    <message>
        <source>Saves the three plots as they stand, as PNG or SVG.</source>
        <translation>Speichert die drei Diagramme, wie sie sind, als PNG oder SVG.</translation>
    </message>
    <message>
        <source>Steps through the trajectories k of the area.</source>
        <translation>Geht schrittweise durch die Bewegungen k des Bereichs.</translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation>Bereich {}: {} Bewegungen, {}</translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation>Gauß-Abbildung der letzten {} Bewegungen bis k.</translation>
    </message>
    <message>
        <source>Select an operation in the tree.</source>
        <translation>Wählen Sie eine Operation im Baum aus.</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>exact reversal</source>
        <translation>genaue Umkehrung</translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy: its toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Zeigt, warum die ausgewählte Operation ihre Strategie hat: ihren Werkzeugweg, die Gauß-Abbildung seiner Richtungen und des Vektors V_k sowie die kumulierte Winkelfunktion.</translation>
    </message>
    <message>
        <source>This area: {}</source>
        <translation>Dieser Bereich: {}</translation>
    </message>
    <message>
        <source>φ between {} and {} turns, level n = {}, exact reversals: {}</source>
        <translation>φ zwischen {} und {} Umdrehungen, Stufe n = {}, exakte Umkehrungen: {}</translation>
    </message>
    <message>
        <source>Reading {}…</source>
        <translation>{} wird gelesen…</translation>
    </message>
    <message>
        <source>with the closing turn φ = {}, n = {}</source>
        <translation>mit der schließenden Drehung φ = {}, n = {}</translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge: first the one that shows the strategy best, then the longest.</source>
        <translation>Die Bereiche, die das Werkzeug ohne Eilgang oder Eintauchen schneidet: zuerst der, der die Strategie am besten zeigt, dann die längsten.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The wheel zooms, dragging moves, a double click shows all again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Das Mausrad vergrößert, Ziehen verschiebt, ein Doppelklick zeigt wieder alles.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: no move cuts sideways, so there is no direction to show</source>
        <translation>{}: Keine Bewegung schneidet zur Seite, daher ist keine Richtung zu zeigen</translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. That of v&lt;sub&gt;k&lt;/sub&gt; goes to and fro on a part of the circle in a zigzag, and all around in a contour; that of V&lt;sub&gt;k&lt;/sub&gt; goes all around only where the path begins inside the contour. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path reaches the dashed lines ±2π, a zigzag stays between them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Links der Werkzeugweg mit dem Vektor V&lt;sub&gt;k&lt;/sub&gt; vom ersten Punkt des Bereichs aus. Auf dem Einheitskreis die Bilder der Bewegung v&lt;sub&gt;k&lt;/sub&gt; und von V&lt;sub&gt;k&lt;/sub&gt;; die Bögen zeigen, wie sie gewandert sind. Das von v&lt;sub&gt;k&lt;/sub&gt; geht bei einem Zickzack auf einem Teil des Kreises hin und her, bei einer Kontur ganz herum; das von V&lt;sub&gt;k&lt;/sub&gt; geht nur dann ganz herum, wenn der Weg innerhalb der Kontur beginnt. Rechts die kumulierte Winkelfunktion φ und der Winkel θ auf Stufe n: Ein konturparalleler Weg erreicht die gestrichelten Linien ±2π, ein Zickzack bleibt dazwischen.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation>Werkzeugweg-Ergebnisse</translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation>In diesem Dokument ist noch nichts analysiert: Klicken Sie auf „Werkzeugwege analysieren“.</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>CSV exportieren</translation>
    </message>
    <message>
        <source>Export JSON</source>
        <translation>JSON exportieren</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>The machining strategy recognized from the toolpath alone</source>
        <translation>Die Bearbeitungsstrategie, allein aus dem Werkzeugweg erkannt</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>Sicher</translation>
    </message>
    <message>
        <source>How sure the recognition is</source>
        <translation>Wie sicher die Erkennung ist</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Länge der schneidenden Bewegungen</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <extracomment>FreeCAD&apos;s newer one, which draws the cuts of all operations before with every operation.</extracomment>
        <translation>Zeit des OpenGL-Simulators von FreeCAD bei höchster Geschwindigkeit</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator</source>
        <translation>Speicher des OpenGL-Simulators von FreeCAD</translation>
    </message>
    <message>
        <source>What is wrong with the operation, or will be with its simulation</source>
        <translation>Was an der Operation nicht stimmt oder in ihrer Simulation schiefgehen wird</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences</source>
        <extracomment>FreeCAD&apos;s older one.</extracomment>
        <translation>Zeit des alten FreeCAD-Simulators im schnellen Vorlauf, bei der Genauigkeit aus den Einstellungen</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences</source>
        <translation>Speicher des alten FreeCAD-Simulators, bei der Genauigkeit aus den Einstellungen</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Empfohlenes Bild: {}</translation>
    </message>
    <message>
        <source>Recommended
image</source>
        <translation>Empfohlenes
Bild</translation>
    </message>
    <message>
        <source>The finest image of the z-buffer within the budgets of the preferences</source>
        <translation>Das feinste Bild des Z-Buffers innerhalb der Grenzen aus den Einstellungen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Machining
time</source>
        <translation>Bearbei-
tungszeit</translation>
    </message>
    <message>
        <source>Time on the machine at the programmed feeds; rapids where the tool controller gives their speed</source>
        <translation>Zeit auf der Maschine mit den programmierten Vorschüben; Eilgänge, wo der Werkzeugcontroller ihre Geschwindigkeit nennt</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>&amp;CSV exportieren…</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>&amp;JSON exportieren…</translation>
    </message>
    <message>
        <source>C&amp;opy to clipboard</source>
        <translation>In die &amp;Zwischenablage</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
        <translation>&amp;Spalten</translation>
    </message>
    <message>
        <source>Sort as &amp;posted</source>
        <translation>Sortieren wie &amp;ausgegeben</translation>
    </message>
    <message>
        <source>Select an operation to read what it does and why.</source>
        <translation>Wählen Sie eine Operation aus, um zu lesen, was sie tut und warum.</translation>
    </message>
    <message>
        <source>Selection in {job}</source>
        <translation>Auswahl in {job}</translation>
    </message>
    <message>
        <source>Simulation
time</source>
        <translation>Simulations-
zeit</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since; analyze it again</source>
        <translation>Veraltet: Werkzeugweg, Werkzeug oder Rohteil wurden seither geändert; erneut analysieren</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Number of straight moves; an arc counts as several</source>
        <translation>Anzahl gerader Bewegungen; ein Bogen zählt als mehrere</translation>
    </message>
    <message>
        <source>{simulator}
time</source>
        <translation>{simulator}:
Zeit</translation>
    </message>
    <message>
        <source>{simulator}
memory</source>
        <translation>{simulator}:
Speicher</translation>
    </message>
    <message>
        <source>Shows the analyzed operations: strategy, machining and simulation time, and what is wrong with them.</source>
        <translation>Zeigt die analysierten Operationen: Strategie, Bearbeitungs- und Simulationszeit, und was an ihnen nicht stimmt.</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Veraltet: Werkzeugweg, Werkzeug oder Rohteil wurden seither geändert. Erneut analysieren.</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <source>Fewer numbers</source>
        <translation>Weniger Zahlen</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Sure: {share}</source>
        <translation>Sicher: {share}</translation>
    </message>
    <message>
        <source>Show it in the Gauss map</source>
        <translation>In der Gauß-Abbildung zeigen</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Shows operations with this text in name, strategy or warnings</source>
        <translation>Zeigt Operationen mit diesem Text in Namen, Strategie oder Warnungen</translation>
    </message>
    <message>
        <source>Shows operations of this strategy</source>
        <translation>Zeigt Operationen mit dieser Strategie</translation>
    </message>
    <message>
        <source>&amp;Warnings only</source>
        <translation>Nur &amp;Warnungen</translation>
    </message>
    <message>
        <source>Shows operations with warnings, and outdated ones</source>
        <translation>Zeigt Operationen mit Warnungen, und veraltete</translation>
    </message>
    <message>
        <source>All strategies</source>
        <translation>Alle Strategien</translation>
    </message>
    <message>
        <source>{count} of {all} operations</source>
        <translation>{count} von {all} Operationen</translation>
    </message>
    <message>
        <source>{count} operation</source>
        <translation>{count} Operation</translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation>{count} Operationen</translation>
    </message>
    <message>
        <source>the total of what was analyzed, not of the whole job</source>
        <translation>die Summe des Analysierten, nicht des ganzen Auftrags</translation>
    </message>
    <message>
        <source>How long the {simulator} takes, as the marks show it</source>
        <translation>Wie lange es dauert: {simulator}, wie in den Markierungen</translation>
    </message>
    <message>
        <source>The longest that the {simulator} should take: its estimate times the factor by which estimates are off</source>
        <translation>So lange sollte es höchstens dauern: {simulator}; die Schätzung mal dem, wie weit Schätzungen danebenliegen</translation>
    </message>
    <message>
        <source>Simulation time
at most</source>
        <translation>Simulationszeit
höchstens</translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer: an operation alone, on the whole stock; a job one operation after another, each on what is left</source>
        <extracomment>The paper&apos;s; its columns in CSV and JSON have no prefix.</extracomment>
        <translation>Zeit der Simulation in einem erweiterten Z-Buffer: eine Operation allein, am ganzen Rohteil; ein Auftrag eine Operation nach der anderen, jede an dem, was noch da ist</translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer: of an operation alone, with the whole stock; of a job with the stock once</source>
        <translation>Speicher der Simulation in einem erweiterten Z-Buffer: einer Operation allein, mit dem ganzen Rohteil; eines Auftrags mit dem Rohteil nur einmal</translation>
    </message>
    <message>
        <source>not in the total: its dress-up is counted instead</source>
        <translation>nicht in der Summe: Stattdessen zählt ihre Anpassung</translation>
    </message>
    <message>
        <source>not in the total: it is switched off</source>
        <translation>nicht in der Summe: Sie ist ausgeschaltet</translation>
    </message>
    <message>
        <source>Shortest move at feed</source>
        <translation>Kürzeste Bewegung im Vorschub</translation>
    </message>
    <message>
        <source>Median move at feed</source>
        <translation>Median der Bewegungen im Vorschub</translation>
    </message>
    <message>
        <source>The filter lets no operation through.</source>
        <translation>Der Filter lässt keine Operation durch.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
    <message>
        <source>machined</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document, and shows the part at any moment, what made each of its surfaces, and rapid moves that cut.</source>
        <translation>Simuliert den gewählten Auftrag oder die gewählten Operationen, sonst den Auftrag des aktiven Dokuments, und zeigt das Teil in jedem Augenblick, was jede seiner Flächen gemacht hat, und Eilgänge, die schneiden.</translation>
    </message>
    <message>
        <source>Simulate toolpaths</source>
        <translation>Werkzeugwege simulieren</translation>
    </message>
    <message>
        <source>Simulation: {}</source>
        <translation>Simulation: {}</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Folder of the Pictures</source>
        <translation>Ordner der Bilder</translation>
    </message>
    <message>
        <source>Save Removal Rates</source>
        <translation>Zeitspanvolumen speichern</translation>
    </message>
    <message>
        <source>{} cannot be written.</source>
        <translation>{} kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Simulated part</source>
        <translation>Simuliertes Teil</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Von rechts</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Von hinten</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Von links</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Von unten</translation>
    </message>
    <message>
        <source>As the 3D view</source>
        <translation>Wie die 3D-Ansicht</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Where the part is seen from.</source>
        <translation>Von wo das Teil gesehen wird.</translation>
    </message>
    <message>
        <source>What the surfaces are colored by.</source>
        <translation>Wonach die Flächen gefärbt sind.</translation>
    </message>
    <message>
        <source>What the operation of this moment removes, alone or on the part.</source>
        <translation>Was die Operation dieses Augenblicks abträgt, allein oder auf dem Teil.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Späne</translation>
    </message>
    <message>
        <source>Part and chips</source>
        <translation>Teil und Späne</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save what is shown.</source>
        <translation>Speichern, was zu sehen ist.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Pictures of the whole job…</source>
        <translation>Bilder des ganzen Auftrags…</translation>
    </message>
    <message>
        <source>Removal rates…</source>
        <translation>Zeitspanvolumen…</translation>
    </message>
    <message>
        <source>Play or pause (Space).</source>
        <translation>Abspielen oder anhalten (Leertaste).</translation>
    </message>
    <message>
        <source>How many times as fast as the machine.</source>
        <translation>Wie viel schneller als die Maschine.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Auftrag in {}</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>To the beginning of the operation.</source>
        <translation>An den Anfang der Operation.</translation>
    </message>
    <message>
        <source>Back by one command of the program.</source>
        <translation>Einen Befehl des Programms zurück.</translation>
    </message>
    <message>
        <source>Back by one trajectory.</source>
        <translation>Eine Bewegung zurück.</translation>
    </message>
    <message>
        <source>Forward by one trajectory.</source>
        <translation>Eine Bewegung weiter.</translation>
    </message>
    <message>
        <source>Forward by one command of the program.</source>
        <translation>Einen Befehl des Programms weiter.</translation>
    </message>
    <message>
        <source>To the end of the operation.</source>
        <translation>An das Ende der Operation.</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>etwa {}</translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation>Simuliert… {}</translation>
    </message>
    <message>
        <source>finest picture in about {}, {}</source>
        <translation>feinstes Bild in etwa {}, {}</translation>
    </message>
    <message>
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation>{} × {} Pixel von {}, {} Spuren, {}, simuliert in {}</translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation>{} von {}   {}, Befehl {}: {}</translation>
    </message>
    <message>
        <source>This surface is the raw stock&apos;s.</source>
        <translation>Diese Fläche ist die des Rohteils.</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>{} wird gelesen ({} von {})…</translation>
    </message>
    <message>
        <source>there is no closed model</source>
        <translation>es gibt kein geschlossenes Modell</translation>
    </message>
    <message>
        <source>gouged by {} to {}</source>
        <translation>zu tief, {} bis {}</translation>
    </message>
    <message>
        <source>left, {} to {}</source>
        <translation>stehen geblieben, {} bis {}</translation>
    </message>
    <message>
        <source>as the model</source>
        <translation>wie das Modell</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>kein Modell</translation>
    </message>
    <message>
        <source>Difference to the model</source>
        <translation>Abweichung vom Modell</translation>
    </message>
    <message>
        <source>Smaller differences to the model do not count.</source>
        <translation>Kleinere Abweichungen vom Modell zählen nicht.</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Where the part differs most from the model. Choose a place to see it.</source>
        <translation>Wo das Teil am meisten vom Modell abweicht. Eine Stelle wählen, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Crashes, gouges and fast plunges of the simulation. Choose one to see it.</source>
        <translation>Kollisionen, zu tiefe Schnitte und zu schnelles Eintauchen in der Simulation. Eine Zeile wählen, um sie zu sehen.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Warnungen: {}</translation>
    </message>
    <message>
        <source>… and {} more</source>
        <translation>… und {} weitere</translation>
    </message>
    <message>
        <source>raw stock: {}</source>
        <translation>Rohteil: {}</translation>
    </message>
    <message>
        <source>{}, command {}: {} ({})</source>
        <translation>{}, Befehl {}: {} ({})</translation>
    </message>
    <message>
        <source>removes {}</source>
        <translation>trägt {} ab</translation>
    </message>
    <message>
        <source>removes nothing</source>
        <translation>trägt nichts ab</translation>
    </message>
    <message>
        <source>the model comes with the finest picture</source>
        <translation>das Modell kommt mit dem feinsten Bild</translation>
    </message>
    <message>
        <source>They are known when the finest picture is there.</source>
        <translation>Sie sind bekannt, wenn das feinste Bild da ist.</translation>
    </message>
    <message>
        <source>Saving the pictures when the finest is there…</source>
        <translation>Die Bilder werden gespeichert, wenn das feinste da ist…</translation>
    </message>
    <message>
        <source>{} of {} pictures are saved in {}.</source>
        <translation>{} von {} Bildern sind in {} gespeichert.</translation>
    </message>
    <message>
        <source>{} pictures</source>
        <translation>{} Bilder</translation>
    </message>
    <message>
        <source>{}, at X {} Y {} Z {} {}</source>
        <translation>{}, bei X {} Y {} Z {} {}</translation>
    </message>
    <message>
        <source>What is simulated has changed. Simulate again</source>
        <translation>Was simuliert wird, hat sich geändert. Neu simulieren</translation>
    </message>
    <message>
        <source>Which job?</source>
        <translation>Welcher Auftrag?</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, rapid moves grey. The document is not changed.</source>
        <translation>Färbt die Werkzeugwege in der 3D-Ansicht nach ihrer Bearbeitungsstrategie, Eilgänge grau. Das Dokument wird nicht geändert.</translation>
    </message>
    <message>
        <source>Show strategies</source>
        <translation>Strategien zeigen</translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Drawing strategies, operations to go: {}</source>
        <translation>Strategien werden gezeichnet, noch offene Operationen: {}</translation>
    </message>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation>In diesem Dokument gibt es keinen Werkzeugweg zu färben. Legen Sie einen Auftrag mit Operationen an oder importieren Sie G-Code.</translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Fast-forward</source>
        <translation>Schneller Vorlauf</translation>
    </message>
    <message>
        <source>Use the {simulator}</source>
        <translation>{simulator} benutzen</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates what simulating them costs.</source>
        <translation>Erkennt Bearbeitungsstrategien von Werkzeugwegen und schätzt den Aufwand ihrer Simulation.</translation>
    </message>
</context>
</TS>
