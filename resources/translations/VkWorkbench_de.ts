<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The machining strategy recognized from the toolpath.</source>
        <translation>Die aus dem Werkzeugweg erkannte Bearbeitungsstrategie.</translation>
    </message>
    <message>
        <source>The reason for this strategy.</source>
        <translation>Der Grund für diese Strategie.</translation>
    </message>
    <message>
        <source>The text of the mark in the description.</source>
        <extracomment>The results of this session.</extracomment>
        <translation>Der Text der Markierung in der Beschreibung.</translation>
    </message>
    <message>
        <source>The confidence of the recognition, in percent.</source>
        <translation>Die Sicherheit der Erkennung, in Prozent.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what to know before simulating it.</source>
        <translation>Probleme der Operation, und was vor dem Simulieren zu wissen ist.</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Länge der schneidenden Bewegungen.</translation>
    </message>
    <message>
        <source>Time on the machine.</source>
        <translation>Zeit auf der Maschine.</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows.</source>
        <translation>Geschätzte Zeit der Simulation, die die Markierung zeigt.</translation>
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
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Dieses Ergebnis ist veraltet, weil sich Werkzeugweg, Werkzeug oder Rohteil geändert haben. Analysieren Sie die Operation erneut.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known. Analyze the operation again.</source>
        <translation>Die Zeit mit „{simulator}“ ist nicht bekannt. Analysieren Sie die Operation erneut.</translation>
    </message>
    <message>
        <source>{strategy}, confidence {share}</source>
        <translation>{strategy}, Sicherheit {share}</translation>
    </message>
    <message>
        <source>Cutting length: {length}.</source>
        <translation>Schnittweg: {length}.</translation>
    </message>
    <message>
        <source>Machining time: {time}. Cutting length: {length}.</source>
        <translation>Bearbeitungszeit: {time}. Schnittweg: {length}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Simulationszeit mit „{simulator}“: {time}. Speicher: {memory}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: at least {time}. Memory: {memory}.</source>
        <translation>Simulationszeit mit „{simulator}“: mindestens {time}. Speicher: {memory}.</translation>
    </message>
    <message>
        <source>Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Simulationszeit nur dieser Operation mit „{simulator}“: {time}. Speicher: {memory}.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>sim {time}</source>
        <translation>Sim. {time}</translation>
    </message>
    <message>
        <source>at least {time}</source>
        <translation>mindestens {time}</translation>
    </message>
    <message>
        <source>Machining time at constant feed: {time}. Cutting length: {length}.</source>
        <translation>Bearbeitungszeit bei konstantem Vorschub: {time}. Schnittweg: {length}.</translation>
    </message>
    <message>
        <source>Tool changes and starts of the spindle: {time}.</source>
        <translation>Werkzeugwechsel und Spindelanläufe: {time}.</translation>
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
        <source>No move cuts, because there are only rapid moves.</source>
        <translation>Keine Bewegung schneidet, denn es gibt nur Eilgänge.</translation>
    </message>
    <message>
        <source>No move cuts, because there are no moves.</source>
        <translation>Keine Bewegung schneidet, denn es gibt keine Bewegungen.</translation>
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
        <source>the direction of nested loops alternates</source>
        <translation>der Drehsinn der ineinander liegenden Schleifen wechselt</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>in der Ebene gleichmäßig verteilt, nicht in der Tiefe</translation>
    </message>
    <message>
        <source>with a shape that changes with the depth</source>
        <translation>mit einer Form, die sich mit der Tiefe ändert</translation>
    </message>
    <message>
        <source>a winding with a helical entry or with extra cuts in the corners</source>
        <translation>eine Windung mit Helix-Eintritt oder zusätzlichen Schnitten in den Ecken</translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation>eine Windung, die sich nie schließt</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>ineinander liegend</translation>
    </message>
    <message>
        <source>small loops that advance along the path</source>
        <translation>kleine Schleifen, die am Weg entlang fortschreiten</translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation>eine offene Bahn liegt innerhalb einer Kontur</translation>
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
        <source>an open contour is repeated</source>
        <translation>eine offene Kontur wird wiederholt</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>offene Züge so lang wie das Werkstück</translation>
    </message>
    <message>
        <source>short strokes that do not fill an area</source>
        <translation>kurze Züge, die keine Fläche füllen</translation>
    </message>
    <message>
        <source>The toolpath has no cutting move.</source>
        <translation>Der Werkzeugweg hat keine schneidende Bewegung.</translation>
    </message>
    <message>
        <source>The operation has no toolpath. Recompute it and read FreeCAD&apos;s report view.</source>
        <translation>Die Operation hat keinen Werkzeugweg. Berechnen Sie sie neu und lesen Sie FreeCADs Ausgabefenster.</translation>
    </message>
    <message>
        <source>The operation has no tool. Give it a tool controller.</source>
        <translation>Die Operation hat kein Werkzeug. Geben Sie ihr einen Werkzeugcontroller.</translation>
    </message>
    <message>
        <source>{label} has no tool. Choose a tool bit for it.</source>
        <translation>{label} hat kein Werkzeug. Wählen Sie eines dafür.</translation>
    </message>
    <message>
        <source>The tool in {label} has no diameter. Enter one in its tool bit.</source>
        <translation>Das Werkzeug in {label} hat keinen Durchmesser. Geben Sie einen im Werkzeug ein.</translation>
    </message>
    <message>
        <source>The toolpath has no stock. Put it into a job.</source>
        <translation>Der Werkzeugweg hat kein Rohteil. Legen Sie ihn in einen Auftrag.</translation>
    </message>
    <message>
        <source>{label} has no stock. Give it one in the job&apos;s settings.</source>
        <translation>{label} hat kein Rohteil. Geben Sie ihm eines in den Einstellungen des Auftrags.</translation>
    </message>
    <message>
        <source>The simulation cost of {labels} is unknown.</source>
        <translation>Der Simulationsaufwand ist unbekannt für: {labels}.</translation>
    </message>
    <message>
        <source>Words without a motion before them are ignored.</source>
        <translation>Wörter ohne eine Bewegung davor werden übergangen.</translation>
    </message>
    <message>
        <source>A feed rate that is not a usable number is ignored.</source>
        <translation>Ein Vorschub, der keine brauchbare Zahl ist, wird übergangen.</translation>
    </message>
    <message>
        <source>Center words (I, J, K) that are not usable numbers are ignored.</source>
        <translation>Mittelpunktwörter (I, J, K), die keine brauchbaren Zahlen sind, werden übergangen.</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored.</source>
        <translation>{letter}-Wörter, die keine brauchbaren Zahlen sind, werden übergangen.</translation>
    </message>
    <message>
        <source>Positions farther than a kilometer from the origin are limited to a kilometer.</source>
        <translation>Positionen, die weiter als einen Kilometer vom Ursprung entfernt sind, werden auf einen Kilometer begrenzt.</translation>
    </message>
    <message>
        <source>A drilling cycle without a depth (Z) drills no hole.</source>
        <translation>Ein Bohrzyklus ohne Tiefe (Z) bohrt kein Loch.</translation>
    </message>
    <message>
        <source>A drilling cycle without R starts at the current height.</source>
        <translation>Ein Bohrzyklus ohne R beginnt auf der aktuellen Höhe.</translation>
    </message>
    <message>
        <source>An arc with an unknown start is ignored.</source>
        <translation>Ein Bogen mit unbekanntem Anfang wird übergangen.</translation>
    </message>
    <message>
        <source>An arc without a usable center or radius is read as a line.</source>
        <translation>Ein Bogen ohne brauchbaren Mittelpunkt oder Radius wird als Gerade gelesen.</translation>
    </message>
    <message>
        <source>An arc that does not end on its circle is read with a changing radius.</source>
        <translation>Ein Bogen, der nicht auf seinem Kreis endet, wird mit veränderlichem Radius gelesen.</translation>
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
        <source>Leave this operation out of the simulation.</source>
        <translation>Lassen Sie diese Operation bei der Simulation aus.</translation>
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
        <source>Move its accuracy slider to the left.</source>
        <translation>Schieben Sie seinen Genauigkeitsregler nach links.</translation>
    </message>
    <message>
        <source>Simulate fewer operations at a time.</source>
        <translation>Simulieren Sie weniger Operationen auf einmal.</translation>
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
        <source>None, because not even a single pixel fits into the memory.</source>
        <translation>Keines, denn nicht einmal ein einziges Pixel passt in den Speicher.</translation>
    </message>
    <message>
        <source>The cost is estimated for a stock that is a box around the cuts.</source>
        <translation>Der Aufwand ist für ein Rohteil geschätzt, das ein Quader um die Schnitte ist.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock. Check its depths, its placement and the stock.</source>
        <translation>Die Operation berührt das Rohteil nicht. Prüfen Sie ihre Tiefen, ihre Platzierung und das Rohteil.</translation>
    </message>
    <message>
        <source>The tool is wider than the stock. Check the tool&apos;s diameter and the stock.</source>
        <translation>Das Werkzeug ist breiter als das Rohteil. Prüfen Sie den Durchmesser des Werkzeugs und das Rohteil.</translation>
    </message>
    <message>
        <source>Choose a smaller image in the preferences.</source>
        <translation>Wählen Sie in den Einstellungen ein kleineres Bild.</translation>
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
        <source>The corner radius must be between 0 and {radius:mm}, not {corner:mm}.</source>
        <translation>Der Eckenradius muss zwischen 0 und {radius:mm} liegen, nicht bei {corner:mm}.</translation>
    </message>
    <message>
        <source>The tip angle must be between 0 and pi, not {angle:g}.</source>
        <translation>Der Spitzenwinkel muss zwischen 0 und π liegen, nicht bei {angle:g}.</translation>
    </message>
    <message>
        <source>The stock has no volume. Its upper corner must exceed its lower corner in x, y and z.</source>
        <translation>Das Rohteil hat kein Volumen. Seine obere Ecke muss in x, y und z über der unteren liegen.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Schnittweg in {count:n} Bewegung ohne Vorschub nicht.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Schnittweg in {count:n} Bewegungen ohne Vorschub nicht.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} is 0.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Eilgang nicht, weil {name} des Werkzeugcontrollers 0 ist.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} and {other} are 0.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Eilgang nicht, weil {name} und {other} des Werkzeugcontrollers 0 sind.</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> und {count:n} weitere</translation>
    </message>
    <message>
        <source> Passes {step:mm3} apart need {cell:mm2}.</source>
        <translation> Bahnen im Abstand von {step:mm3} brauchen {cell:mm2}.</translation>
    </message>
    <message>
        <source> For passes {step:mm3} apart, {cell:mm2} is fine enough.</source>
        <translation> Für Bahnen im Abstand von {step:mm3} sind {cell:mm2} fein genug.</translation>
    </message>
    <message>
        <source>None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}</source>
        <translation>Keines, denn allein die Bewegungen brauchen {time:s}. Simulieren Sie weniger Operationen.{heaviest}</translation>
    </message>
    <message>
        <source> The slowest is {label} with {time:s}.</source>
        <translation> Am längsten braucht {label} mit {time:s}.</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> und 1 weiterer</translation>
    </message>
    <message>
        <source>Command {command:#}: {sentence}</source>
        <translation>Befehl {command:#}: {sentence}</translation>
    </message>
    <message>
        <source>Command {command:#} (first of {count:n}): {sentence}</source>
        <translation>Befehl {command:#} (der erste von {count:n}): {sentence}</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored.</source>
        <translation>Der unbekannte Code {name} wird übergangen.</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored.</source>
        <translation>1 weiterer unbekannter Code wird übergangen.</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored.</source>
        <translation>{count:n} weitere unbekannte Codes werden übergangen.</translation>
    </message>
    <message>
        <source>The arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}. Choose a larger tolerance in the preferences.</source>
        <translation>Die Bögen und Zyklen bräuchten bei einer Toleranz von {tolerance:mm} {moves:n} Bewegungen. Wählen Sie in den Einstellungen eine größere Toleranz.</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}: {sentence}</translation>
    </message>
    <message>
        <source>The analysis failed. Please report the error together with the file: {error}</source>
        <translation>Die Analyse ist fehlgeschlagen. Bitte melden Sie den Fehler zusammen mit der Datei: {error}</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über {count:n} Zeilen{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über {count:n} Zeilen{spread} bei 0, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über einen offenen Zug{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über {count:n} offene Züge{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über einen offenen Zug{spread} bei 0, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über {count:n} offene Züge{spread} bei 0, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ erreicht über eine Schleife{spread} {reached:turns} Umdrehungen, {seen}: {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ erreicht über {count:n} Schleifen{spread} {reached:turns} Umdrehungen, {seen}: {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}.</source>
        <translation>φ liegt zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at one point: {strategy:strategy}.</source>
        <translation>φ ist nicht definiert, weil die Bewegungen an einem Punkt senkrecht sind: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}.</source>
        <translation>φ ist nicht definiert, weil die Bewegungen an {count:n} Punkten senkrecht sind: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at some points: {strategy:strategy}.</source>
        <translation>φ ist nicht definiert, weil die Bewegungen an einigen Punkten senkrecht sind: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling, show {strategies:strategy}: {strategy:strategy}.</source>
        <translation>{count:n} Abschnitte, getrennt durch Werkzeugwechsel, Titel, Rückzüge oder Bohren, zeigen {strategies:strategy}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation> im Abstand von {step:mm3} in {depths:n} Tiefen</translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation> im Abstand von {step:mm3}</translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation> in {depths:n} Tiefen</translation>
    </message>
    <message>
        <source>{count:n} engagements in the same direction overlap</source>
        <translation>{count:n} Eingriffe mit gleichem Drehsinn überlappen sich</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) fill the same area</source>
        <translation>Zeilen ({rows:%} der Länge) und Schleifen ({loops:%}) füllen dieselbe Fläche</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} bis {high}</translation>
    </message>
    <message>
        <source>Line {line:#}: {what}</source>
        <translation>Zeile {line:#}: {what}</translation>
    </message>
    <message>
        <source>Line {line:#} (first of {count:n}): {what}</source>
        <translation>Zeile {line:#} (die erste von {count:n}): {what}</translation>
    </message>
    <message>
        <source>Lines with a block delete (/) are read like all others.</source>
        <translation>Zeilen mit Ausblendzeichen (/) werden wie alle anderen gelesen.</translation>
    </message>
    <message>
        <source>A subprogram or macro call is ignored.</source>
        <translation>Ein Unterprogramm- oder Makroaufruf wird übergangen.</translation>
    </message>
    <message>
        <source>Jumps, loops and calls are ignored.</source>
        <translation>Sprünge, Schleifen und Aufrufe werden übergangen.</translation>
    </message>
    <message>
        <source>Words with variables or expressions are ignored.</source>
        <translation>Wörter mit Variablen oder Ausdrücken werden übergangen.</translation>
    </message>
    <message>
        <source>Lines that do not consist of words like G1 X10 are ignored.</source>
        <translation>Zeilen, die nicht aus Wörtern wie G1 X10 bestehen, werden übergangen.</translation>
    </message>
    <message>
        <source>{name} is ignored. The coordinates after it are read as if it were not there.</source>
        <translation>{name} wird übergangen. Die Koordinaten danach werden gelesen, als stünde es nicht da.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as a line.</source>
        <translation>Ein Spline ({name}) wird als Gerade gelesen.</translation>
    </message>
    <message>
        <source>Lines after the end of the program are ignored.</source>
        <translation>Zeilen nach dem Programmende werden übergangen.</translation>
    </message>
    <message>
        <source>Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.</source>
        <translation>Zeile {line:#}: Das Programm ist für {name}-Steuerungen geschrieben. Geben Sie es als G-Code (ISO) aus, um es zu analysieren.</translation>
    </message>
    <message>
        <source>This is not an NC program. {part:n} of its {lines:n} lines do not consist of words like G1 X10. The first of them is line {line:#}.</source>
        <translation>Das ist kein NC-Programm. {part:n} seiner {lines:n} Zeilen bestehen nicht aus Wörtern wie G1 X10. Die erste davon ist Zeile {line:#}.</translation>
    </message>
    <message>
        <source>This is not an NC program. None of its lines moves a tool.</source>
        <translation>Das ist kein NC-Programm. Keine seiner Zeilen bewegt ein Werkzeug.</translation>
    </message>
    <message>
        <source>None of the moves can be read. {problems}</source>
        <translation>Keine der Bewegungen kann gelesen werden. {problems}</translation>
    </message>
    <message>
        <source>This is not an NC program, because it is not text.</source>
        <translation>Das ist kein NC-Programm, denn es ist kein Text.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it.</source>
        <translation>Zeile {line:#}: {name} zeigt ein Programm für eine Drehmaschine. Frässtrategien gelten dafür nicht.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it.</source>
        <translation>Zeile {line:#}: {name} zeigt ein Programm für einen 3D-Drucker. Frässtrategien gelten dafür nicht.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it.</source>
        <translation>Zeile {line:#}: {name} zeigt ein Programm für eine Drahtschneidemaschine. Frässtrategien gelten dafür nicht.</translation>
    </message>
    <message>
        <source>Line {line:#}: A rotary axis turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Zeile {line:#}: Eine Drehachse dreht, während das Werkzeug schneidet. Der Weg des Werkzeugs ist hier unbekannt.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Eilgang nicht, weil ein Programm dessen Geschwindigkeit nicht nennt.</translation>
    </message>
    <message>
        <source>The program does not contain the tool&apos;s diameter, so the cost is unknown.</source>
        <translation>Das Programm nennt den Durchmesser des Werkzeugs nicht, daher ist der Aufwand unbekannt.</translation>
    </message>
    <message>
        <source>The file cannot be read: {name}.</source>
        <translation>Die Datei kann nicht gelesen werden: {name}.</translation>
    </message>
    <message>
        <source>The file is larger than {size:bytes}.</source>
        <translation>Die Datei ist größer als {size:bytes}.</translation>
    </message>
    <message>
        <source>The analysis was stopped after {time:s}.</source>
        <translation>Die Analyse wurde nach {time:s} abgebrochen.</translation>
    </message>
    <message>
        <source>The process that read the file ended unexpectedly, perhaps for lack of memory.</source>
        <translation>Der Prozess, der die Datei las, endete unerwartet, vielleicht aus Speichermangel.</translation>
    </message>
    <message>
        <source>The toolpath looks 25.4 times too small. Inches are probably read as millimeters.</source>
        <translation>Der Werkzeugweg sieht 25,4-mal zu klein aus. Wahrscheinlich werden Zoll als Millimeter gelesen.</translation>
    </message>
    <message>
        <source>There is nothing to simulate. Choose a job, or operations with a toolpath.</source>
        <translation>Es gibt nichts zu simulieren. Wählen Sie einen Auftrag oder Operationen mit einem Werkzeugweg.</translation>
    </message>
    <message>
        <source>These operations belong to several jobs. Choose operations of one job only: {labels}.</source>
        <translation>Diese Operationen gehören zu mehreren Aufträgen. Wählen Sie nur Operationen eines Auftrags: {labels}.</translation>
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
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}</source>
        <translation>„{simulator:simulator}“ hängt bei einem Bogen, {reason} (Befehl {command:#}{others}). {instead}</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>„{simulator:simulator}“ schneidet {count:n} Rampe in falscher Tiefe, bis zu {error:mm2} {way} (Befehl {command:#}). Beurteilen Sie Tiefen nicht danach.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>„{simulator:simulator}“ schneidet {count:n} Rampen in falscher Tiefe, bis zu {error:mm2} {way} (Befehl {command:#}). Beurteilen Sie Tiefen nicht danach.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.</source>
        <translation>Das Abspielen dauert mit „{simulator:simulator}“ etwa {longer:estimate}. Benutzen Sie den schnellen Vorlauf, der etwa {time:estimate} dauert.</translation>
    </message>
    <message>
        <source>Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. Simulate fewer operations at a time.</source>
        <translation>Das Abspielen dauert mit „{simulator:simulator}“ auch bei höchster Geschwindigkeit etwa {time:estimate}. Simulieren Sie weniger Operationen auf einmal.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>{count:n} Bewegungen sind kürzer als eine Zelle von „{simulator:simulator}“ ({cell:mm2}). Sie kosten Zeit, sind aber nicht zu sehen. Wählen Sie für die Operation eine gröbere Toleranz.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>„{simulator:simulator}“ braucht für diese Operation etwa {memory:bytes}, mehr als Ihre Grenze von {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Use the {simulator:simulator} for this operation.</source>
        <translation>Benutzen Sie für diese Operation „{simulator:simulator}“.</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}.</source>
        <translation>Der Werkzeugdurchmesser muss positiv und höchstens ein Kilometer sein, nicht {diameter:mm}.</translation>
    </message>
    <message>
        <source>The corners of the stock must be numbers within a kilometer of the origin.</source>
        <translation>Die Ecken des Rohteils müssen Zahlen innerhalb eines Kilometers vom Ursprung sein.</translation>
    </message>
    <message>
        <source>Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD&apos;s G-code import does not convert them.</source>
        <translation>Vorschübe bis {feed:g} mm/s werden als mm/min gelesen, weil FreeCADs G-Code-Import sie nicht umrechnet.</translation>
    </message>
    <message>
        <source>The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}.</source>
        <translation>Der Durchmesser der Spitze muss zwischen 0 und {diameter:mm} liegen, nicht bei {tip:mm}.</translation>
    </message>
    <message>
        <source>The surface of the solid is not closed.</source>
        <translation>Die Oberfläche des Körpers ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>The stock of {label} is simulated as the box around it. {sentence}</source>
        <translation>Das Rohteil von {label} wird als der Quader um es herum simuliert. {sentence}</translation>
    </message>
    <message>
        <source>{label} is simulated only approximately, {instead}.</source>
        <translation>{label} wird nur angenähert simuliert, {instead}.</translation>
    </message>
    <message>
        <source>as an end mill with its largest diameter</source>
        <translation>als Schaftfräser mit seinem größten Durchmesser</translation>
    </message>
    <message>
        <source>as a ball end mill with the diameter of its tip</source>
        <translation>als Kugelfräser mit dem Durchmesser der Spitze</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>als Bohrer</translation>
    </message>
    <message>
        <source>A rotary axis ({letter}) turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Eine Drehachse ({letter}) dreht, während das Werkzeug schneidet. Der Weg des Werkzeugs ist hier unbekannt.</translation>
    </message>
    <message>
        <source>Moves of a rotary axis ({letter}) are ignored.</source>
        <translation>Bewegungen einer Drehachse ({letter}) werden übergangen.</translation>
    </message>
    <message>
        <source>{letter} words are ignored.</source>
        <translation>{letter}-Wörter werden übergangen.</translation>
    </message>
    <message>
        <source>The repeats of a cycle ({letter}) are ignored.</source>
        <translation>Die Wiederholungen eines Zyklus ({letter}) werden übergangen.</translation>
    </message>
    <message>
        <source>Inches (G20) are ignored. Lengths are read in mm.</source>
        <translation>Zoll (G20) werden übergangen. Längen werden in mm gelesen.</translation>
    </message>
    <message>
        <source>Cutter compensation ({name}) is ignored. The programmed path is used.</source>
        <translation>Die Radiuskorrektur ({name}) wird übergangen. Der programmierte Weg wird benutzt.</translation>
    </message>
    <message>
        <source>Feeds after {name} are ignored.</source>
        <translation>Vorschübe nach {name} werden übergangen.</translation>
    </message>
    <message>
        <source>Dwell times are not included in the machining time.</source>
        <translation>Verweilzeiten sind in der Bearbeitungszeit nicht enthalten.</translation>
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
        <source>{count:n} row{spread}, {seen}.</source>
        <translation>{count:n} Zeile{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}.</source>
        <translation>{count:n} Zeilen{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One open cut{spread}, {seen}.</source>
        <translation>Ein offener Schnitt{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}.</source>
        <translation>{count:n} offene Schnitte{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One loop{spread}{turning}, {seen}.</source>
        <translation>Ein Umlauf{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}.</source>
        <translation>{count:n} Umläufe{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>Straight down at one point.</source>
        <translation>An einer Stelle gerade nach unten.</translation>
    </message>
    <message>
        <source>Straight down at {count:n} points.</source>
        <translation>An {count:n} Stellen gerade nach unten.</translation>
    </message>
    <message>
        <source>Straight down at some points.</source>
        <translation>An einigen Stellen gerade nach unten.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.</source>
        <translation>{count:n} Abschnitte, getrennt durch Werkzeugwechsel, Titel, Rückzüge oder Bohren: {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} overlapping engagements</source>
        <translation>{count:n} überlappende Eingriffe</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>einer im Uhrzeigersinn, der nächste dagegen</translation>
    </message>
    <message>
        <source>all in one continuous cut that never closes</source>
        <translation>alles in einem durchgehenden Schnitt, der sich nie schließt</translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation>ineinander liegend</translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation>keiner im anderen</translation>
    </message>
    <message>
        <source>cut back and forth</source>
        <translation>hin und her geschnitten</translation>
    </message>
    <message>
        <source>all cut in the same direction</source>
        <translation>alle in derselben Richtung geschnitten</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über eine Zeile{spread} zwischen {low:turns} und {high:turns} Umdrehungen, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ bleibt über eine Zeile{spread} bei 0, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It takes time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>Eine Bewegung ist kürzer als eine Zelle von „{simulator:simulator}“ ({cell:mm2}). Sie kostet Zeit, ist aber nicht zu sehen. Wählen Sie für die Operation eine gröbere Toleranz.</translation>
    </message>
    <message>
        <source>arranged as in known toolpaths ({share:%} of the votes)</source>
        <translation>angeordnet wie in bekannten Werkzeugwegen ({share:%} der Stimmen)</translation>
    </message>
    <message>
        <source>unlike any known machining ({share:%} of the votes)</source>
        <translation>anders als jede bekannte Bearbeitung ({share:%} der Stimmen)</translation>
    </message>
    <message>
        <source> The tool enters on a ramp.</source>
        <translation> Das Werkzeug taucht auf einer Rampe ein.</translation>
    </message>
    <message>
        <source> The tool enters on a ramp that goes back and forth.</source>
        <translation> Das Werkzeug taucht auf einer Rampe ein, die hin und her geht.</translation>
    </message>
    <message>
        <source> The tool enters on a helix.</source>
        <translation> Das Werkzeug taucht auf einer Helix ein.</translation>
    </message>
    <message>
        <source> A contour around the rows finishes the area.</source>
        <translation> Eine Kontur um die Zeilen schlichtet die Fläche.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this simulation: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>„{simulator:simulator}“ hängt bei dieser Simulation: Befehl {command:#} von {label}{others} ist ein Bogen, {reason}.</translation>
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
        <source>Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}.</source>
        <translation>Diese Simulation abzuspielen dauert mit „{simulator:simulator}“ {bound} {time:estimate}.</translation>
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
        <source>Simulate Toolpaths shows the finished part at once, coarse at first.</source>
        <translation>„Werkzeugwege simulieren“ zeigt sofort das fertige Teil, zuerst grob.</translation>
    </message>
    <message>
        <source>A rapid move removes {volume:mm³2}.</source>
        <translation>Ein Eilgang trägt {volume:mm³2} ab.</translation>
    </message>
    <message>
        <source>The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}.</source>
        <translation>Das Werkzeug taucht mit {feed:mm/min3} ins volle Material ein. Seine Grenze ist {allowed:mm/min3}.</translation>
    </message>
    <message>
        <source>{depth:mm2} of stock is left on the model.</source>
        <translation>{depth:mm2} Rohteil bleiben auf dem Modell stehen.</translation>
    </message>
    <message>
        <source>A finer picture would take longer than the {allowed:s} limit in the preferences.</source>
        <translation>Ein feineres Bild würde länger dauern als die Grenze von {allowed:s} in den Einstellungen.</translation>
    </message>
    <message>
        <source>The simulation shows a fault at command {command:#}: {fault}</source>
        <translation>Die Simulation zeigt einen Fehler bei Befehl {command:#}: {fault}</translation>
    </message>
    <message>
        <source>All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}.</source>
        <translation>Alle Bewegungen sind in X und Z, mit Schnitten längs Z bei vielen X, wie auf einer Drehmaschine: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>The placement of the operation must be numbers within a kilometer of the origin.</source>
        <translation>Die Platzierung der Operation muss aus Zahlen innerhalb eines Kilometers vom Ursprung bestehen.</translation>
    </message>
    <message>
        <source>Of two {letter} words in a line, the last one is read.</source>
        <translation>Von zwei {letter}-Wörtern in einer Zeile wird das letzte gelesen.</translation>
    </message>
    <message>
        <source>{told} A small part is {strategies:strategy}.</source>
        <translation>{told} Ein kleiner Teil ist: {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}</source>
        <translation>{width:n} × {height:n} Pixel von {pixel:mm2}, begrenzt durch {limit}.{passes}</translation>
    </message>
    <message>
        <source>Lines with variables or expressions are ignored.</source>
        <translation>Zeilen mit Variablen oder Ausdrücken werden übergangen.</translation>
    </message>
    <message>
        <source>Moves to machine positions ({name}) are ignored, because the program does not contain these positions.</source>
        <translation>Bewegungen zu Maschinenpositionen ({name}) werden übergangen, weil das Programm diese Positionen nicht nennt.</translation>
    </message>
    <message>
        <source>The holes of a pattern ({name}) are ignored.</source>
        <translation>Die Löcher eines Lochbilds ({name}) werden übergangen.</translation>
    </message>
    <message>
        <source>The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units.</source>
        <translation>Der Werkzeugweg erstreckt sich in ganzen Zahlen über Meter. Wahrscheinlich werden Tausendstel ohne Dezimalpunkt als ganze Einheiten gelesen.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}</source>
        <translation>„{simulator:simulator}“ braucht {bound} {time:estimate}, mehr als Ihre Grenze von {allowed:s}. {better}</translation>
    </message>
    <message>
        <source>The centers of arcs are read as positions (as with G90.1). The arcs only close this way.</source>
        <translation>Die Mittelpunkte von Kreisbögen werden als Positionen gelesen (wie bei G90.1). Nur so schließen sich die Bögen.</translation>
    </message>
    <message>
        <source>strokes that rise toward their ends, as in V-carving</source>
        <translation>Züge, die zu ihren Enden hin ansteigen, wie beim V-Carving</translation>
    </message>
    <message>
        <source>cut in strokes, as between holding tags</source>
        <translation>in Zügen geschnitten, wie zwischen Haltestegen</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored, and the {letters} words of its line with it.</source>
        <translation>Der unbekannte Code {name} wird übergangen, und mit ihm die Wörter {letters} seiner Zeile.</translation>
    </message>
    <message>
        <source>Probing moves are not included in the machining time.</source>
        <translation>Antastbewegungen sind in der Bearbeitungszeit nicht enthalten.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} into the model.</source>
        <translation>Das Werkzeug schneidet {depth:mm2} tief in das Modell.</translation>
    </message>
    <message>
        <source>The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}</source>
        <translation>Die Simulation zeigt Fehler bei {count:n} Befehlen, zum Beispiel bei Befehl {command:#}: {fault}</translation>
    </message>
    <message>
        <source>The operation is called {name}, but its toolpath is {strategy:strategy}.</source>
        <translation>Die Operation heißt {name}, doch ihr Werkzeugweg ist: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a zip archive. Unpack it first.</source>
        <translation>Das ist kein NC-Programm, sondern ein ZIP-Archiv. Entpacken Sie es zuerst.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a folder of documents, use the macro examples/macros/folder_to_csv.py.</source>
        <translation>Das ist kein NC-Programm, sondern ein FreeCAD-Dokument. Analysieren Sie es in FreeCAD. Für einen Ordner von Dokumenten gibt es das Makro examples/macros/folder_to_csv.py.</translation>
    </message>
    <message>
        <source>The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.</source>
        <translation>Das Rohteil ist {depth:mm2} zu klein für das Modell. Wählen Sie ein größeres Rohteil oder verschieben Sie das Modell darin.</translation>
    </message>
    <message>
        <source>The operation is switched off. It has no toolpath until you switch it on and recompute it.</source>
        <translation>Die Operation ist ausgeschaltet. Sie hat keinen Werkzeugweg, bis Sie sie einschalten und neu berechnen.</translation>
    </message>
    <message>
        <source>This is not a file, but a pipe or a device.</source>
        <translation>Das ist keine Datei, sondern eine Pipe oder ein Gerät.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.</source>
        <translation>Die Operation berührt das Rohteil nicht, das schon das fertige Teil ist. Wählen Sie als Rohteil einen Block darum.</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>Die Simulation braucht in der Spitze etwa {memory:bytes}, für {dexels:n} Dexel und {traces:n} Spurelemente, mehr als Ihre Grenze von {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the preferences, or simulate fewer operations.</source>
        <translation>Wählen Sie in den Einstellungen ein Bild von {width:n} × {height:n} Pixel zu {pixel:mm2}, oder simulieren Sie weniger Operationen.</translation>
    </message>
    <message>
        <source>A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once.</source>
        <translation>Eine Zustelltiefe (Q), die mehr als {most:n} Zustellungen braucht, wird übergangen. Das Loch wird in einem Zug gebohrt.</translation>
    </message>
    <message>
        <source>The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). They are read as offsets.</source>
        <translation>Das Programm zeigt nicht, ob die Mittelpunkte seiner Kreise Abstände (G91.1) oder Positionen (G90.1) sind. Sie werden als Abstände gelesen.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long.</source>
        <translation>Das Werkzeug schneidet {depth:mm2} tiefer als seine Schneiden, die {length:mm3} lang sind.</translation>
    </message>
    <message>
        <source>The shank collides with material {depth:mm2} high.</source>
        <translation>Der Schaft stößt gegen {depth:mm2} hohes Material.</translation>
    </message>
    <message>
        <source>The holder collides with material {depth:mm2} high.</source>
        <translation>Der Werkzeughalter stößt gegen {depth:mm2} hohes Material.</translation>
    </message>
    <message>
        <source>The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.</source>
        <translation>Das Werkzeug ist zu kurz: Es ist {length:mm3} lang, und das Material daneben ist {depth:mm2} höher als sein oberes Ende.</translation>
    </message>
    <message>
        <source>{part} collides with the clamp {clamp}.</source>
        <translation>{part} stößt gegen die Spannvorrichtung {clamp}.</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>Das Werkzeug</translation>
    </message>
    <message>
        <source>The shank</source>
        <translation>Der Schaft</translation>
    </message>
    <message>
        <source>The holder</source>
        <translation>Der Werkzeughalter</translation>
    </message>
    <message>
        <source>{sentences}</source>
        <translation>{sentences}</translation>
    </message>
    <message>
        <source>Shanks were checked.</source>
        <translation>Die Schäfte wurden geprüft.</translation>
    </message>
    <message>
        <source>Shanks were not checked, because no tool has a cutting edge height and a shank diameter.</source>
        <translation>Die Schäfte wurden nicht geprüft, weil kein Werkzeug eine Schneidenhöhe und einen Schaftdurchmesser hat.</translation>
    </message>
    <message>
        <source>The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.</source>
        <translation>Die Schäfte von {labels} wurden nicht geprüft, weil die Werkzeuge keine Schneidenhöhe oder keinen Schaftdurchmesser haben.</translation>
    </message>
    <message>
        <source>Holders were checked.</source>
        <translation>Die Werkzeughalter wurden geprüft.</translation>
    </message>
    <message>
        <source>No holder is given.</source>
        <translation>Es ist kein Werkzeughalter angegeben.</translation>
    </message>
    <message>
        <source>No holder is given for {labels}.</source>
        <translation>Für {labels} ist kein Werkzeughalter angegeben.</translation>
    </message>
    <message>
        <source>1 clamp was checked.</source>
        <translation>1 Spannvorrichtung wurde geprüft.</translation>
    </message>
    <message>
        <source>{count:n} clamps were checked.</source>
        <translation>{count:n} Spannvorrichtungen wurden geprüft.</translation>
    </message>
    <message>
        <source>No clamps are given.</source>
        <translation>Es sind keine Spannvorrichtungen angegeben.</translation>
    </message>
    <message>
        <source>Nothing is checked yet.</source>
        <translation>Noch ist nichts geprüft.</translation>
    </message>
    <message>
        <source>No {what}, checked to {pixel:mm2}.</source>
        <translation>Ohne {what}, auf {pixel:mm2} genau geprüft.</translation>
    </message>
    <message>
        <source>Checked to {pixel:mm2}.</source>
        <translation>Auf {pixel:mm2} genau geprüft.</translation>
    </message>
    <message>
        <source>collision, gouge or fast plunge</source>
        <translation>Kollision, Schnitt ins Modell oder zu schnelles Eintauchen</translation>
    </message>
    <message>
        <source>collision or fast plunge</source>
        <translation>Kollision oder zu schnelles Eintauchen</translation>
    </message>
    <message>
        <source>1 rapid cuts into material.</source>
        <translation>1 Eilgang schneidet in Material.</translation>
    </message>
    <message>
        <source>{count:n} rapids cut into material.</source>
        <translation>{count:n} Eilgänge schneiden in Material.</translation>
    </message>
    <message>
        <source>1 gouge is {depth:mm2} deep in the model.</source>
        <translation>1 Schnitt geht {depth:mm2} tief ins Modell.</translation>
    </message>
    <message>
        <source>{count:n} gouges are up to {depth:mm2} deep in the model.</source>
        <translation>{count:n} Schnitte gehen bis {depth:mm2} tief ins Modell.</translation>
    </message>
    <message>
        <source>1 plunge is too fast.</source>
        <translation>1 Eintauchen ist zu schnell.</translation>
    </message>
    <message>
        <source>{count:n} plunges are too fast.</source>
        <translation>{count:n}-mal wird zu schnell eingetaucht.</translation>
    </message>
    <message>
        <source>The file has more than {lines:n} lines.</source>
        <translation>Die Datei hat mehr als {lines:n} Zeilen.</translation>
    </message>
    <message>
        <source>This is not an NC program. It has a line of more than {characters:n} characters.</source>
        <translation>Das ist kein NC-Programm. Es hat eine Zeile mit mehr als {characters:n} Zeichen.</translation>
    </message>
    <message>
        <source>The memory is not sufficient for this program. Divide it into smaller programs.</source>
        <translation>Der Speicher reicht für dieses Programm nicht aus. Teilen Sie es in kleinere Programme auf.</translation>
    </message>
    <message>
        <source>Shank checked; no holder and no clamps given.</source>
        <translation>Schaft geprüft; kein Halter und keine Spannvorrichtungen angegeben.</translation>
    </message>
    <message>
        <source>FreeCAD is still reading {document}. Try again when the document is open.</source>
        <translation>FreeCAD liest {document} noch. Versuchen Sie es wieder, wenn das Dokument geöffnet ist.</translation>
    </message>
    <message>
        <source>A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized.</source>
        <translation>Ein Bohrzyklus außerhalb der XY-Ebene bohrt entlang {letter}. Solche Löcher werden nicht erkannt.</translation>
    </message>
    <message>
        <source>A cycle with more than {most:n} repeats is read with {most:n} repeats.</source>
        <translation>Ein Zyklus mit mehr als {most:n} Wiederholungen wird mit {most:n} Wiederholungen gelesen.</translation>
    </message>
    <message>
        <source>A number of turns of an arc (P) that is not usable is ignored.</source>
        <translation>Eine nicht brauchbare Zahl von Umläufen eines Bogens (P) wird übergangen.</translation>
    </message>
    <message>
        <source>A probing move is read as a rapid to its end. Where the probe touches is not in the program.</source>
        <translation>Eine Messbewegung wird als Eilgang zu ihrem Ende gelesen. Wo der Taster berührt, steht nicht im Programm.</translation>
    </message>
    <message>
        <source>The feed rate of a thread ({name}) is its pitch times the spindle speed.</source>
        <translation>Der Vorschub eines Gewindes ({name}) ist seine Steigung mal die Drehzahl der Spindel.</translation>
    </message>
    <message>
        <source>Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor.</source>
        <translation>Vorschübe werden als mm/s gelesen, weil der Text ein Pfad aus FreeCAD ohne Postprozessor ist.</translation>
    </message>
    <message>
        <source>Commas in numbers are read as decimal points.</source>
        <translation>Kommas in Zahlen werden als Dezimalpunkte gelesen.</translation>
    </message>
    <message>
        <source>Text that does not consist of words like G1 X10 is ignored. The words beside it are read.</source>
        <translation>Text, der nicht aus Wörtern wie G1 X10 besteht, wird übergangen. Die Wörter daneben werden gelesen.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as short lines.</source>
        <translation>Ein Spline ({name}) wird als kurze Geraden gelesen.</translation>
    </message>
    <message>
        <source> A closed contour finishes the walls.</source>
        <translation> Eine geschlossene Kontur schlichtet die Wände.</translation>
    </message>
    <message>
        <source>climbing at a constant radius</source>
        <translation>mit gleichbleibendem Radius aufsteigend</translation>
    </message>
    <message>
        <source>only {share:%} of their length nested</source>
        <translation>nur {share:%} ihrer Länge ineinander liegend</translation>
    </message>
    <message>
        <source>The stock is where the other job leaves it, because the jobs have different models.</source>
        <translation>Das Rohteil liegt dort, wo der andere Auftrag es zurücklässt, weil die Aufträge verschiedene Modelle haben.</translation>
    </message>
    <message>
        <source>1 move was not checked for lack of time: command {command:#} of {label}.</source>
        <translation>Für 1 Bewegung reichte die Zeit nicht: Befehl {command:#} von {label}.</translation>
    </message>
    <message>
        <source>{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.</source>
        <translation>Für {count:n} Bewegungen reichte die Zeit nicht, zuerst Befehl {command:#} von {label}.</translation>
    </message>
    <message>
        <source>The program is read up to this line. {why}</source>
        <translation>Das Programm wird bis zu dieser Zeile gelesen. {why}</translation>
    </message>
    <message>
        <source>The value of {name} comes from the machine.</source>
        <translation>Der Wert von {name} kommt von der Maschine.</translation>
    </message>
    <message>
        <source>The value of {name} is assigned in a line that cannot be read.</source>
        <translation>Der Wert von {name} wird in einer Zeile zugewiesen, die nicht lesbar ist.</translation>
    </message>
    <message>
        <source>A control stops here, because {name} has no value.</source>
        <translation>Eine Steuerung hält hier an, weil {name} keinen Wert hat.</translation>
    </message>
    <message>
        <source>A control stops here, because it has no variable {name}.</source>
        <translation>Eine Steuerung hält hier an, weil sie keine Variable {name} hat.</translation>
    </message>
    <message>
        <source>A control stops here, because an expression has no result, such as a division by zero.</source>
        <translation>Eine Steuerung hält hier an, weil ein Ausdruck kein Ergebnis hat, etwa eine Division durch null.</translation>
    </message>
    <message>
        <source>The program stops here with an alarm (#3000).</source>
        <translation>Das Programm hält hier mit einem Alarm an (#3000).</translation>
    </message>
    <message>
        <source>This jump, loop or call cannot be read.</source>
        <translation>Dieser Sprung, diese Schleife oder dieser Aufruf ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The end of this loop, condition or subprogram is missing.</source>
        <translation>Das Ende dieser Schleife, dieser Bedingung oder dieses Unterprogramms fehlt.</translation>
    </message>
    <message>
        <source>The program jumps to the block N{number}, which does not exist.</source>
        <translation>Das Programm springt zum Satz N{number}, den es nicht gibt.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would run more than {count:n} lines, which is the limit.</source>
        <translation>Schleifen, Sprünge und Aufrufe würden mehr als {count:n} Zeilen ausführen; das ist die Grenze.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would make more than {count:n} moves, which is the limit.</source>
        <translation>Schleifen, Sprünge und Aufrufe würden mehr als {count:n} Bewegungen ergeben; das ist die Grenze.</translation>
    </message>
    <message>
        <source>A loop runs more than {count:n} lines without a move, which is the limit.</source>
        <translation>Eine Schleife führt mehr als {count:n} Zeilen ohne Bewegung aus; das ist die Grenze.</translation>
    </message>
    <message>
        <source>The program jumps back from here without end.</source>
        <translation>Das Programm springt von hier ohne Ende zurück.</translation>
    </message>
    <message>
        <source>The expressions take more than {count:n} steps to calculate, which is the limit.</source>
        <translation>Die Ausdrücke erfordern mehr als {count:n} Rechenschritte; das ist die Grenze.</translation>
    </message>
    <message>
        <source>Calls are nested deeper than {count:n} levels, which is the limit.</source>
        <translation>Aufrufe sind tiefer als {count:n} Ebenen verschachtelt; das ist die Grenze.</translation>
    </message>
    <message>
        <source>A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty.</source>
        <translation>Eine Variable wird gelesen, die das Programm nicht gesetzt hat. Sie gilt als 0, auf einer Fanuc-Steuerung als leer.</translation>
    </message>
    <message>
        <source>A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.</source>
        <translation>Ein Befehl mit zwei Codes, wie G90 und G1, wird mit beiden gelesen. Manche Postprozessoren schreiben nur den ersten.</translation>
    </message>
    <message>
        <source>The program has no unit and looks like inches. It is simulated in inches.</source>
        <translation>Das Programm nennt keine Einheit und sieht nach Zoll aus. Es wird in Zoll simuliert.</translation>
    </message>
    <message>
        <source>No stock is given. The simulation uses a box around the cuts.</source>
        <translation>Es ist kein Rohteil angegeben. Die Simulation verwendet einen Quader um die Schnitte.</translation>
    </message>
    <message>
        <source>The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}.</source>
        <translation>Der Auftrag verfährt {needed:mm4} in {axis}, aber der Verfahrweg der Maschine ist {travel:mm4}.</translation>
    </message>
    <message>
        <source>The time did not suffice to check all walls for gouges narrower than {pixel:mm2}.</source>
        <translation>Die Zeit reichte nicht, um alle Wände auf Schnitte ins Modell zu prüfen, die schmaler als {pixel:mm2} sind.</translation>
    </message>
    <message>
        <source>The height of a move to a machine position ({name}) is not in the program. The greatest height is used.</source>
        <translation>Die Höhe einer Bewegung zu einer Maschinenposition ({name}) steht nicht im Programm. Die größte Höhe wird verwendet.</translation>
    </message>
    <message>
        <source>The tool length offset changes before a move without a Z word. The height of the move is unknown.</source>
        <translation>Die Werkzeuglängenkorrektur ändert sich vor einer Bewegung ohne Z-Wort. Die Höhe der Bewegung ist unbekannt.</translation>
    </message>
    <message>
        <source>A clamp was not checked. {sentence}</source>
        <translation>Eine Spannvorrichtung wurde nicht geprüft. {sentence}</translation>
    </message>
    <message>
        <source>This is a toolpath for a lathe. It is simulated like a mill&apos;s, so that the part is wrong.</source>
        <translation>Dieser Werkzeugweg ist für eine Drehmaschine. Er wird wie auf einer Fräsmaschine simuliert, das Teil ist daher falsch.</translation>
    </message>
    <message>
        <source>The verdict of the simulation is outdated, because the job has changed. Simulate the job again.</source>
        <translation>Das Urteil der Simulation ist veraltet, weil sich der Auftrag geändert hat. Simulieren Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>No {what} was found, checked to {pixel:mm2}.</source>
        <translation>Nichts gefunden ({what}), auf {pixel:mm2} genau geprüft.</translation>
    </message>
    <message>
        <source>Not everything could be checked: {first}</source>
        <translation>Nicht alles konnte geprüft werden: {first}</translation>
    </message>
    <message>
        <source>Not everything could be checked, for {count:n} reasons. The first reason: {first}</source>
        <translation>Aus {count:n} Gründen konnte nicht alles geprüft werden. Der erste Grund: {first}</translation>
    </message>
    <message>
        <source>{label} already begins with what this job leaves. Choose another job.</source>
        <translation>{label} beginnt bereits mit dem, was dieser Auftrag zurücklässt. Wählen Sie einen anderen Auftrag.</translation>
    </message>
    <message>
        <source>The cuts of a pocket or circle ({name}) are ignored.</source>
        <translation>Die Schnitte einer Tasche oder eines Kreises ({name}) werden übergangen.</translation>
    </message>
    <message>
        <source>{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.</source>
        <translation>{label} ab Zeile {line:#} wird nicht simuliert, weil das Werkzeug unbekannt ist. Nennen Sie es davor in einem Kommentar, zum Beispiel (T1 D=6 end mill), oder übergeben Sie es an vkworkbench.simulate.</translation>
    </message>
    <message>
        <source>Nothing was checked, because no tool meets the stock. Check the stock and its position.</source>
        <translation>Nichts wurde geprüft, weil kein Werkzeug das Rohteil trifft. Prüfen Sie das Rohteil und seine Lage.</translation>
    </message>
    <message>
        <source>{name} moves the coordinates. The origin before it is not in the program, and is read as 0.</source>
        <translation>{name} verschiebt die Koordinaten. Der Nullpunkt davor steht nicht im Programm und wird als 0 gelesen.</translation>
    </message>
    <message>
        <source>An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.</source>
        <translation>Ein F-Wort in der Zeile von {name} wird wie in LinuxCNC in der Einheit davor gelesen. Manche Steuerungen verwenden die neue Einheit.</translation>
    </message>
    <message>
        <source>The program has no unit (G20, G21) and is read in millimeters. It can also be in inches.</source>
        <translation>Das Programm nennt keine Einheit (G20, G21) und wird in Millimetern gelesen. Es kann auch in Zoll sein.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths simulator</source>
        <translation>Werkzeugwege simulieren</translation>
    </message>
    <message>
        <source>This toolpath has no tool. Import its program into a job.</source>
        <translation>Dieser Werkzeugweg kann kein Werkzeug haben. Importieren Sie sein Programm in einen Auftrag.</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.</source>
        <translation>FreeCADs CycleTime für diesen Auftrag ist {seconds:clock}. FreeCAD misst Bögen falsch und lässt Beschleunigungen und Verweilzeiten weg.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.</source>
        <translation>Die Bearbeitungszeit enthält {length:mm4} Eilgang nicht, weil die Operation keinen Werkzeugcontroller hat. Wählen Sie Ihre Maschine in den Einstellungen, Seite Maschine.</translation>
    </message>
    <message>
        <source>More than the sum: the {simulator:simulator} slows down with every cut.</source>
        <translation>Mehr als die Summe: „{simulator:simulator}“ wird mit jedem Schnitt langsamer.</translation>
    </message>
    <message>
        <source>Less than the sum: the {simulator:simulator} simulates all operations in one run.</source>
        <translation>Weniger als die Summe: „{simulator:simulator}“ simuliert alle Operationen in einem Lauf.</translation>
    </message>
    <message>
        <source>More than the sum: tool changes and starts of the spindle take {time:clock}.</source>
        <translation>Mehr als die Summe: Werkzeugwechsel und Spindelanläufe dauern {time:clock}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} slows to about {frames:g1} frames per second at the end of this job, mostly because of arcs. Simulate fewer operations at a time.</source>
        <translation>„{simulator:simulator}“ wird am Ende dieses Auftrags auf etwa {frames:g1} Bilder pro Sekunde langsamer, vor allem wegen der Bögen. Simulieren Sie weniger Operationen auf einmal.</translation>
    </message>
    <message>
        <source>Gouges were not checked, because the job has no model with a volume.</source>
        <translation>Schnitte ins Modell wurden nicht geprüft, weil der Auftrag kein Modell mit Volumen hat.</translation>
    </message>
    <message>
        <source>Gouges of {labels} were not checked, because the tool is simulated by a simpler shape.</source>
        <translation>Schnitte ins Modell von {labels} wurden nicht geprüft, weil das Werkzeug durch eine einfachere Form simuliert wird.</translation>
    </message>
    <message>
        <source>Shank, holder and clamps were not checked.</source>
        <translation>Schaft, Halter und Spannvorrichtungen wurden nicht geprüft.</translation>
    </message>
    <message>
        <source>Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read.</source>
        <translation>Von zwei Codes derselben Art in einer Zeile, etwa G0 und G1 oder G90 und G91, wird der letzte gelesen.</translation>
    </message>
    <message>
        <source>After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate.</source>
        <translation>Nach G80 wird eine Bewegung ohne G0 oder G1 als Eilgang gelesen. Manche Steuerungen fahren im Vorschub.</translation>
    </message>
    <message>
        <source>Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. On Fanuc controls, they can differ by up to the diameter of the tool.</source>
        <translation>Unter der Radiuskorrektur ({name}) werden die erste Bewegung und Außenecken wie in LinuxCNC gelesen. Auf Fanuc-Steuerungen können sie um bis zu einem Werkzeugdurchmesser abweichen.</translation>
    </message>
    <message>
        <source>Lines after M2, M17 or M30 are read as part of the same program.</source>
        <translation>Zeilen nach M2, M17 oder M30 werden als Teil desselben Programms gelesen.</translation>
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
        <translation>Die Zustellungen von {name} werden übergangen. Jede Bohrung wird in einer Bewegung gebohrt.</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>The operation has no strategy, or several strategies.</extracomment>
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
        <translation>Profil</translation>
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
    <name>VkMachine</name>
    <message>
        <source>grbl Settings</source>
        <translation>grbl-Einstellungen</translation>
    </message>
    <message>
        <source>The lines that grbl answers to the command $$:</source>
        <translation>Die Zeilen, mit denen grbl auf den Befehl $$ antwortet:</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machining Times</source>
        <translation>Bearbeitungszeiten</translation>
    </message>
    <message>
        <source>The machine that machining times are planned for. The next analysis uses it.</source>
        <translation>Die Maschine, für die Bearbeitungszeiten geplant werden. Die nächste Analyse verwendet sie.</translation>
    </message>
    <message>
        <source>None: constant feed, no acceleration</source>
        <translation>Keine: konstanter Vorschub, keine Beschleunigung</translation>
    </message>
    <message>
        <source>Hobby router with grbl</source>
        <translation>Hobbyfräse mit grbl</translation>
    </message>
    <message>
        <source>Small milling machine</source>
        <translation>Kleine Fräsmaschine</translation>
    </message>
    <message>
        <source>Machining center</source>
        <translation>Bearbeitungszentrum</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Speed X</source>
        <translation>Geschwindigkeit X</translation>
    </message>
    <message>
        <source>Largest speed of the X axis. Rapids use it.</source>
        <translation>Größte Geschwindigkeit der X-Achse. Eilgänge verwenden sie.</translation>
    </message>
    <message>
        <source>Speed Y</source>
        <translation>Geschwindigkeit Y</translation>
    </message>
    <message>
        <source>Largest speed of the Y axis. Rapids use it.</source>
        <translation>Größte Geschwindigkeit der Y-Achse. Eilgänge verwenden sie.</translation>
    </message>
    <message>
        <source>Speed Z</source>
        <translation>Geschwindigkeit Z</translation>
    </message>
    <message>
        <source>Largest speed of the Z axis. Rapids use it.</source>
        <translation>Größte Geschwindigkeit der Z-Achse. Eilgänge verwenden sie.</translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation>Beschleunigung X</translation>
    </message>
    <message>
        <source>Acceleration of the X axis.</source>
        <translation>Beschleunigung der X-Achse.</translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation>Beschleunigung Y</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis.</source>
        <translation>Beschleunigung der Y-Achse.</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>Beschleunigung Z</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis.</source>
        <translation>Beschleunigung der Z-Achse.</translation>
    </message>
    <message>
        <source>Corner deviation</source>
        <translation>Eckenabweichung</translation>
    </message>
    <message>
        <source>Distance from a corner at which the controller may round it: grbl&apos;s junction deviation ($11), LinuxCNC&apos;s path tolerance (G64 P). With 0, the tool stops at each corner.</source>
        <translation>Abstand von einer Ecke, in dem die Steuerung sie runden darf: Junction Deviation von grbl ($11), Bahntoleranz von LinuxCNC (G64 P). Bei 0 hält das Werkzeug an jeder Ecke.</translation>
    </message>
    <message>
        <source>Moves planned ahead</source>
        <translation>Vorausgeplante Bewegungen</translation>
    </message>
    <message>
        <source>Number of moves that the controller plans ahead. grbl on an Arduino plans 15.</source>
        <translation>Anzahl der Bewegungen, die die Steuerung vorausplant. grbl auf einem Arduino plant 15.</translation>
    </message>
    <message>
        <source>Measured / planned time</source>
        <translation>Gemessene / geplante Zeit</translation>
    </message>
    <message>
        <source>Measured time of a job divided by the time planned here. Multiplies all times.</source>
        <translation>Gemessene Zeit eines Auftrags geteilt durch die hier geplante Zeit. Multipliziert alle Zeiten.</translation>
    </message>
    <message>
        <source>Fills the values from the answer of grbl to the command $$.</source>
        <translation>Füllt die Werte aus der Antwort von grbl auf den Befehl $$.</translation>
    </message>
    <message>
        <source>Paste grbl Settings…</source>
        <translation>grbl-Einstellungen einfügen…</translation>
    </message>
    <message>
        <source>Travel and Tool Holder</source>
        <translation>Verfahrweg und Werkzeughalter</translation>
    </message>
    <message>
        <source>Travel in X</source>
        <translation>Verfahrweg in X</translation>
    </message>
    <message>
        <source>Travel of the machine along X. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Verfahrweg der Maschine in X. Die Analyse warnt vor Aufträgen und Programmen, die mehr brauchen. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Travel in Y</source>
        <translation>Verfahrweg in Y</translation>
    </message>
    <message>
        <source>Travel of the machine along Y. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Verfahrweg der Maschine in Y. Die Analyse warnt vor Aufträgen und Programmen, die mehr brauchen. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Travel in Z</source>
        <translation>Verfahrweg in Z</translation>
    </message>
    <message>
        <source>Travel of the machine along Z. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Verfahrweg der Maschine in Z. Die Analyse warnt vor Aufträgen und Programmen, die mehr brauchen. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>Halterdurchmesser</translation>
    </message>
    <message>
        <source>Diameter of the tool holder. The simulation warns of collisions. A property HolderDiameter of a tool bit takes precedence. 0: unknown.</source>
        <translation>Durchmesser des Werkzeughalters. Die Simulation warnt vor Kollisionen. Eine Eigenschaft HolderDiameter des Werkzeugs hat Vorrang. 0: unbekannt.</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>Halterlänge</translation>
    </message>
    <message>
        <source>Length of the tool holder. A property HolderLength of a tool bit takes precedence. 0: the holder has no upper end.</source>
        <translation>Länge des Werkzeughalters. Eine Eigenschaft HolderLength des Werkzeugs hat Vorrang. 0: Der Halter hat kein oberes Ende.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message>
        <source>Time from the end of an operation to the next operation with another tool. The time of the job includes it.</source>
        <translation>Zeit vom Ende einer Operation bis zur nächsten Operation mit einem anderen Werkzeug. Die Zeit des Auftrags enthält sie.</translation>
    </message>
    <message>
        <source>Start of the spindle</source>
        <translation>Spindelanlauf</translation>
    </message>
    <message>
        <source>Time until the spindle turns at its speed. The time of the job includes it for each tool.</source>
        <translation>Zeit, bis die Spindel ihre Drehzahl erreicht. Die Zeit des Auftrags enthält sie für jedes Werkzeug.</translation>
    </message>
    <message>
        <source>There is no line such as $110=3000. Paste the lines that grbl answers to the command $$.</source>
        <translation>Es fehlt eine Zeile wie $110=3000. Fügen Sie die Zeilen ein, die grbl auf den Befehl $$ antwortet.</translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Never calibrated on this computer. The times of FreeCAD&apos;s simulators are right to within a factor of 2.</source>
        <translation>Auf diesem Computer noch nie kalibriert. Die Zeiten der FreeCAD-Simulatoren stimmen bis auf den Faktor 2.</translation>
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
        <source>Show times for</source>
        <translation>Zeiten anzeigen für</translation>
    </message>
    <message>
        <source>Shows the marks in the tree as colored pills. If switched off, shows them as plain text.</source>
        <translation>Zeigt die Markierungen im Baum als farbige Schildchen. Ausgeschaltet zeigt es sie als einfachen Text.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Markierungen als Schildchen zeigen</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. With large toolpaths, each recompute takes longer.</source>
        <translation>Analysiert markierte Operationen nach jeder Neuberechnung, die sie geändert hat, erneut. Bei großen Werkzeugwegen dauert jede Neuberechnung länger.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Nach einer Neuberechnung erneut analysieren</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Longest time that a simulation may take. The analysis warns of longer simulations and recommends an accuracy within this limit.</source>
        <translation>Längste Zeit, die eine Simulation dauern darf. Die Analyse warnt vor längeren Simulationen und empfiehlt eine Genauigkeit innerhalb dieser Grenze.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Largest memory that a simulation may take. The analysis warns of larger simulations and recommends an accuracy within this limit.</source>
        <translation>Größter Speicher, den eine Simulation brauchen darf. Die Analyse warnt vor größeren Simulationen und empfiehlt eine Genauigkeit innerhalb dieser Grenze.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Direction from which the part is viewed.</source>
        <translation>Richtung, aus der das Teil gesehen wird.</translation>
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
        <source>Edge length of the cells, in percent of the stock&apos;s longer side. 0.1 is the finest position of the accuracy slider, 1 the coarsest.</source>
        <translation>Kantenlänge der Zellen, in Prozent der längeren Seite des Rohteils. 0,1 ist die feinste Stellung des Genauigkeitsreglers, 1 die gröbste.</translation>
    </message>
    <message>
        <source>Position of the quality slider. 10 is the best quality.</source>
        <translation>Stellung des Qualitätsreglers. 10 ist die beste Qualität.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Bogentoleranz</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves that replace it.</source>
        <translation>Größter Abstand zwischen einem Bogen und den geraden Bewegungen, die ihn ersetzen.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s default ({simulator})</source>
        <translation>Wie FreeCADs Schaltfläche ({simulator})</translation>
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
        <source>The simulator whose time the marks show. The marks change at once.</source>
        <translation>Der Simulator, dessen Zeit die Markierungen zeigen. Die Markierungen ändern sich sofort.</translation>
    </message>
    <message>
        <source>Shows a bar above the 3D view when a simulation in one of FreeCAD&apos;s simulators would hang or take too long, and suggests a faster way.</source>
        <translation>Zeigt eine Leiste über der Ansicht, wenn eine Simulation in einem der FreeCAD-Simulatoren hängen bliebe oder zu lange dauerte, und schlägt einen schnelleren Weg vor.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Vor Simulationen warnen, die hängen oder zu lange dauern</translation>
    </message>
    <message>
        <source>Last calibrated on {date}. The times of the {simulator} are right to within a factor of {factor}. Measured on {processor}, display {renderer}.</source>
        <translation>Zuletzt kalibriert am {date}. Die Zeiten von „{simulator}“ stimmen bis auf den Faktor {factor}. Gemessen auf {processor}, Anzeige {renderer}.</translation>
    </message>
    <message>
        <source>Measures how fast this computer simulates, and saves the result. This takes some seconds.</source>
        <translation>Misst, wie schnell dieser Computer simuliert, und speichert das Ergebnis. Das dauert einige Sekunden.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image width</source>
        <translation>Werkzeugwege simulieren: Bildbreite</translation>
    </message>
    <message>
        <source>Width of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Breite des Bildes, für das Zeit und Speicher von „Werkzeugwege simulieren“ geschätzt werden.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image height</source>
        <translation>Werkzeugwege simulieren: Bildhöhe</translation>
    </message>
    <message>
        <source>Height of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Höhe des Bildes, für das Zeit und Speicher von „Werkzeugwege simulieren“ geschätzt werden.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: view</source>
        <translation>Werkzeugwege simulieren: Ansicht</translation>
    </message>
</context>
<context>
    <name>Vk_AddMesh</name>
    <message>
        <source>Add Simulated Part as Mesh</source>
        <translation>Simuliertes Teil als Netz hinzufügen</translation>
    </message>
    <message>
        <source>Simulates the job, and adds the part that it leaves to the document as a mesh.</source>
        <translation>Simuliert den Auftrag und fügt das Teil, das er zurücklässt, dem Dokument als Netz hinzu.</translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation>{} wurde dem Dokument hinzugefügt.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document. Estimates what simulating each operation costs, and marks it in the tree.</source>
        <translation>Erkennt die Bearbeitungsstrategie jeder ausgewählten Operation oder aller Operationen des aktiven Dokuments. Schätzt den Aufwand, jede Operation zu simulieren, und markiert sie im Baum.</translation>
    </message>
    <message>
        <source>Analyze Toolpaths</source>
        <translation>Werkzeugwege analysieren</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>Es ist kein Dokument geöffnet. Öffnen Sie zuerst eines mit einem Auftrag oder einem Werkzeugweg.</translation>
    </message>
    <message>
        <source>The analysis was cancelled. Nothing has changed.</source>
        <translation>Die Analyse wurde abgebrochen. Es hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>In diesem Dokument gibt es keine Operation zu analysieren. Legen Sie einen Auftrag mit Operationen an oder importieren Sie G-Code.</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>{count} operation was analyzed.</source>
        <translation>{count} Operation wurde analysiert.</translation>
    </message>
    <message>
        <source>{count} operations were analyzed.</source>
        <translation>{count} Operationen wurden analysiert.</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Es wird gemessen, wie schnell dieser Computer simuliert…</translation>
    </message>
    <message>
        <source>Reading the operations…</source>
        <translation>Operationen werden gelesen…</translation>
    </message>
    <message>
        <source>{count} mark has a warning: see Toolpath Results (V, R).</source>
        <translation>{count} Markierung hat eine Warnung: siehe Werkzeugweg-Ergebnisse (V, R).</translation>
    </message>
    <message>
        <source>{count} marks have warnings: see Toolpath Results (V, R).</source>
        <translation>{count} Markierungen haben Warnungen: siehe Werkzeugweg-Ergebnisse (V, R).</translation>
    </message>
</context>
<context>
    <name>Vk_Clamps</name>
    <message>
        <source>Set Clamps from Selection</source>
        <translation>Auswahl als Spannvorrichtungen festlegen</translation>
    </message>
    <message>
        <source>{} has no clamps.</source>
        <translation>{} hat keine Spannvorrichtungen.</translation>
    </message>
    <message>
        <source>Remove Clamps</source>
        <translation>Spannvorrichtungen entfernen</translation>
    </message>
    <message>
        <source>Clamps of {}: {}.</source>
        <translation>Spannvorrichtungen von {}: {}.</translation>
    </message>
    <message>
        <source>Makes the selected solids, such as clamps and vices, the clamps of the job. The simulation warns if a tool, shank or holder collides with them. If no solid is selected, the command shows the present clamps and can remove them.</source>
        <translation>Macht die ausgewählten Körper, zum Beispiel Spannpratzen und Schraubstöcke, zu den Spannvorrichtungen des Auftrags. Die Simulation warnt, wenn Werkzeug, Schaft oder Halter mit ihnen kollidieren. Ist kein Körper ausgewählt, zeigt der Befehl die jetzigen Spannvorrichtungen und kann sie entfernen.</translation>
    </message>
    <message>
        <source>To set clamps, select their solids and start this command again. If the document has several jobs, select the job, too.</source>
        <translation>Um Spannvorrichtungen festzulegen, wählen Sie deren Körper aus und starten Sie diesen Befehl noch einmal. Hat das Dokument mehrere Aufträge, wählen Sie auch den Auftrag aus.</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document. Your own descriptions stay.</source>
        <translation>Entfernt die Markierungen der ausgewählten Operationen oder alle des aktiven Dokuments. Ihre eigenen Beschreibungen bleiben.</translation>
    </message>
    <message>
        <source>Clear Analysis</source>
        <translation>Analyse löschen</translation>
    </message>
    <message>
        <source>The marks were removed.</source>
        <translation>Die Markierungen wurden entfernt.</translation>
    </message>
    <message>
        <source>There are no marks to remove.</source>
        <translation>Es gibt keine Markierungen zu entfernen.</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss Map</source>
        <translation>Gauß-Abbildung</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Bild speichern…</translation>
    </message>
    <message>
        <source>Saves the three plots as PNG or SVG.</source>
        <translation>Speichert die drei Diagramme als PNG oder SVG.</translation>
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
        <source>Save Picture</source>
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
        <source>Shows why the selected operation has its strategy. Shows the toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Zeigt, warum die ausgewählte Operation ihre Strategie hat. Zeigt den Werkzeugweg, die Gauß-Abbildung seiner Richtungen und des Vektors V_k sowie die kumulierte Winkelfunktion.</translation>
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
        <source>Areas that the tool cuts without a rapid move or a plunge. The area that shows the strategy best comes first, then the longest areas.</source>
        <translation>Bereiche, die das Werkzeug ohne Eilgang oder Eintauchen schneidet. Zuerst kommt der Bereich, der die Strategie am besten zeigt, dann die längsten.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Use the wheel to zoom, drag to move, and double-click to show everything again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Mit dem Mausrad vergrößern, durch Ziehen verschieben, mit einem Doppelklick wieder alles zeigen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: No move cuts sideways, so there is no direction to show.</source>
        <translation>{}: Keine Bewegung schneidet zur Seite, daher gibt es keine Richtung zu zeigen.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The left plot shows the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the first point of the area. The unit circle shows the directions of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;. Its arcs show how these directions have moved. In a zigzag, the direction of v&lt;sub&gt;k&lt;/sub&gt; moves back and forth on a part of the circle. In a contour, it moves all around the circle. The direction of V&lt;sub&gt;k&lt;/sub&gt; moves all around only if the path begins inside the contour. The right plot shows the cumulative angular function φ and the angle θ on level n, in turns. A contour-parallel path reaches the dashed lines, one turn from its start. A zigzag stays between the dashed lines, one turn from its middle.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Das linke Diagramm zeigt den Werkzeugweg mit dem Vektor V&lt;sub&gt;k&lt;/sub&gt; vom ersten Punkt des Bereichs aus. Der Einheitskreis zeigt die Richtungen der Bewegung v&lt;sub&gt;k&lt;/sub&gt; und von V&lt;sub&gt;k&lt;/sub&gt;. Seine Bögen zeigen, wie diese Richtungen gewandert sind. Bei einem Zickzack wandert die Richtung von v&lt;sub&gt;k&lt;/sub&gt; auf einem Teil des Kreises hin und her. Bei einer Kontur wandert sie ganz herum. Die Richtung von V&lt;sub&gt;k&lt;/sub&gt; wandert nur dann ganz herum, wenn der Weg innerhalb der Kontur beginnt. Das rechte Diagramm zeigt die kumulierte Winkelfunktion φ und den Winkel θ auf Stufe n, in Umdrehungen. Ein konturparalleler Weg erreicht die gestrichelten Linien, eine Umdrehung von seinem Anfang. Ein Zickzack bleibt zwischen den gestrichelten Linien, eine Umdrehung von seiner Mitte.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>with the closing turn {}, n = {}</source>
        <translation>mit der schließenden Drehung {}, n = {}</translation>
    </message>
    <message>
        <source>φ = {} turns</source>
        <translation>φ = {} Umdrehungen</translation>
    </message>
</context>
<context>
    <name>Vk_Jobs</name>
    <message>
        <source>The document has no job.</source>
        <translation>Das Dokument hat keinen Auftrag.</translation>
    </message>
    <message>
        <source>Choose the job:</source>
        <translation>Wählen Sie den Auftrag:</translation>
    </message>
    <message>
        <source>Simulating {}…</source>
        <translation>{} wird simuliert…</translation>
    </message>
    <message>
        <source>The simulation was cancelled. Nothing has changed.</source>
        <translation>Die Simulation wurde abgebrochen. Nichts hat sich geändert.</translation>
    </message>
</context>
<context>
    <name>Vk_PreviousJob</name>
    <message>
        <source>Begin with the Part of Another Job</source>
        <translation>Mit dem Teil eines anderen Auftrags beginnen</translation>
    </message>
    <message>
        <source>Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. The part is moved and turned with the model.</source>
        <translation>Lässt die Simulation des Auftrags mit dem Teil beginnen, das ein anderer Auftrag zurücklässt, wie für die zweite Seite eines Teils. Das Teil wird mit dem Modell verschoben und gedreht.</translation>
    </message>
    <message>
        <source>No other job of this document machines the part of {}.</source>
        <translation>Kein anderer Auftrag dieses Dokuments bearbeitet das Teil von {}.</translation>
    </message>
    <message>
        <source>The simulation of {} begins with:</source>
        <translation>Die Simulation von {} beginnt mit:</translation>
    </message>
    <message>
        <source>The stock of {}</source>
        <translation>Rohteil von {}</translation>
    </message>
    <message>
        <source>{} begins with its own stock.</source>
        <translation>{} beginnt mit dem eigenen Rohteil.</translation>
    </message>
    <message>
        <source>{} begins with the part that {} leaves.</source>
        <translation>{} beginnt mit dem Teil, das {} zurücklässt.</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath Results</source>
        <translation>Werkzeugweg-Ergebnisse</translation>
    </message>
    <message>
        <source>Nothing is analyzed in this document yet. Click Analyze Toolpaths.</source>
        <translation>In diesem Dokument ist noch nichts analysiert. Klicken Sie auf „Werkzeugwege analysieren“.</translation>
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
        <source>The machining strategy, recognized from the toolpath alone.</source>
        <translation>Die Bearbeitungsstrategie, allein aus dem Werkzeugweg erkannt.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>The confidence of the recognition.</source>
        <translation>Die Sicherheit der Erkennung.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Länge der schneidenden Bewegungen.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s OpenGL simulator at its highest speed.</source>
        <extracomment>FreeCAD&apos;s newer simulator, which draws the cuts of all earlier operations with every operation.</extracomment>
        <translation>Zeit im OpenGL-Simulator von FreeCAD bei höchster Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator.</source>
        <translation>Speicher des OpenGL-Simulators von FreeCAD.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what goes wrong when you simulate it.</source>
        <translation>Probleme der Operation, und was beim Simulieren schiefgeht.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences.</source>
        <extracomment>FreeCAD&apos;s older simulator.</extracomment>
        <translation>Zeit im alten FreeCAD-Simulator im schnellen Vorlauf, bei der Genauigkeit aus den Einstellungen.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences.</source>
        <translation>Speicher des alten FreeCAD-Simulators, bei der Genauigkeit aus den Einstellungen.</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Empfohlenes Bild: {}</translation>
    </message>
    <message>
        <source>Recommended
Image</source>
        <translation>Empfohlenes
Bild</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>Machining
Time</source>
        <translation>Bearbei-
tungszeit</translation>
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
        <source>C&amp;opy to Clipboard</source>
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
        <source>Sort as &amp;Posted</source>
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
Time</source>
        <translation>Simulations-
zeit</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>A result is outdated if the toolpath, the tool or the stock has changed since. Analyze the operation again.</source>
        <translation>Ein Ergebnis ist veraltet, wenn sich Werkzeugweg, Werkzeug oder Rohteil seither geändert haben. Analysieren Sie die Operation erneut.</translation>
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
        <source>Number of straight moves. An arc counts as several.</source>
        <translation>Anzahl gerader Bewegungen. Ein Bogen zählt als mehrere.</translation>
    </message>
    <message>
        <source>{simulator}
Time</source>
        <translation>{simulator}:
Zeit</translation>
    </message>
    <message>
        <source>{simulator}
Memory</source>
        <translation>{simulator}:
Speicher</translation>
    </message>
    <message>
        <source>Shows the analyzed operations with their strategies, machining times, simulation times and warnings.</source>
        <translation>Zeigt die analysierten Operationen mit ihren Strategien, Bearbeitungszeiten, Simulationszeiten und Warnungen.</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Dieses Ergebnis ist veraltet, weil sich Werkzeugweg, Werkzeug oder Rohteil geändert haben. Analysieren Sie die Operation erneut.</translation>
    </message>
    <message>
        <source>All Numbers</source>
        <translation>Alle Zahlen</translation>
    </message>
    <message>
        <source>Fewer Numbers</source>
        <translation>Weniger Zahlen</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Confidence: {share}</source>
        <translation>Sicherheit: {share}</translation>
    </message>
    <message>
        <source>Show in the Gauss Map</source>
        <translation>In der Gauß-Abbildung zeigen</translation>
    </message>
    <message>
        <source>Cutting Length</source>
        <translation>Schnittweg</translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation>Eilgangweg</translation>
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
        <source>Shows operations that contain this text in their name, strategy or warnings.</source>
        <translation>Zeigt Operationen, die diesen Text in Namen, Strategie oder Warnungen enthalten.</translation>
    </message>
    <message>
        <source>Shows operations with this strategy.</source>
        <translation>Zeigt Operationen mit dieser Strategie.</translation>
    </message>
    <message>
        <source>&amp;Warnings Only</source>
        <translation>Nur &amp;Warnungen</translation>
    </message>
    <message>
        <source>Shows operations that have warnings or are outdated.</source>
        <translation>Zeigt Operationen, die Warnungen haben oder veraltet sind.</translation>
    </message>
    <message>
        <source>All Strategies</source>
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
        <source>This total covers the analyzed operations only.</source>
        <translation>Diese Summe umfasst nur die analysierten Operationen.</translation>
    </message>
    <message>
        <source>Time in the {simulator}, as the marks show it.</source>
        <translation>Zeit mit „{simulator}“, wie die Markierungen sie zeigen.</translation>
    </message>
    <message>
        <source>Longest time that the {simulator} is expected to take. It is the estimate, multiplied by the factor to within which estimates are right.</source>
        <translation>Längste Zeit, die mit „{simulator}“ zu erwarten ist. Sie ist die Schätzung, multipliziert mit dem Faktor, bis auf den Schätzungen stimmen.</translation>
    </message>
    <message>
        <source>Simulation Time
at Most</source>
        <translation>Simulationszeit
höchstens</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because its dress-up is.</source>
        <translation>Diese Operation ist nicht in der Summe enthalten, weil ihre Anpassung es ist.</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because it is switched off.</source>
        <translation>Diese Operation ist nicht in der Summe enthalten, weil sie ausgeschaltet ist.</translation>
    </message>
    <message>
        <source>Shortest Move at Feed</source>
        <translation>Kürzeste Bewegung im Vorschub</translation>
    </message>
    <message>
        <source>Median Move at Feed</source>
        <translation>Median der Bewegungen im Vorschub</translation>
    </message>
    <message>
        <source>No operation matches the filter.</source>
        <translation>Keine Operation passt zum Filter.</translation>
    </message>
    <message>
        <source>Time on the machine of the preferences. Without a machine: at constant feeds, and with rapids if the tool controller has rapid speeds.</source>
        <translation>Zeit auf der Maschine der Einstellungen. Ohne Maschine: mit konstantem Vorschub, und mit Eilgängen, wenn der Werkzeugcontroller Eilganggeschwindigkeiten hat.</translation>
    </message>
    <message>
        <source>In Plain Words</source>
        <translation>In einfachen Worten</translation>
    </message>
    <message>
        <source>The toolpath in one sentence: the reason for the strategy.</source>
        <translation>Der Werkzeugweg in einem Satz: der Grund für die Strategie.</translation>
    </message>
    <message>
        <source>At constant feed. Choose your machine in the preferences, page Machine.</source>
        <translation>Bei konstantem Vorschub. Wählen Sie Ihre Maschine in den Einstellungen, Seite Maschine.</translation>
    </message>
    <message>
        <source>Enter the Measured Time…</source>
        <translation>Gemessene Zeit eingeben…</translation>
    </message>
    <message>
        <source>Measured Time</source>
        <translation>Gemessene Zeit</translation>
    </message>
    <message>
        <source>Time that {label} took on the machine, in minutes and seconds, such as 17:30:</source>
        <translation>Zeit, die {label} auf der Maschine gebraucht hat, in Minuten und Sekunden, z. B. 17:30:</translation>
    </message>
    <message>
        <source>This is not a possible time. Enter it like 17:30 or 1:02:30.</source>
        <translation>Diese Zeit ist nicht möglich. Geben Sie sie in der Form 17:30 oder 1:02:30 ein.</translation>
    </message>
    <message>
        <source>Time that Simulate Toolpaths takes. An operation is simulated alone, on the whole stock. In a job, each operation cuts the stock that is left.</source>
        <extracomment>Attributes of `Rings` whose shares of the section&apos;s length are measures.</extracomment>
        <translation>Zeit für „Werkzeugwege simulieren“. Eine Operation wird allein simuliert, am ganzen Rohteil. In einem Auftrag schneidet jede Operation das Rohteil, das noch übrig ist.</translation>
    </message>
    <message>
        <source>Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.</source>
        <translation>Speicher für „Werkzeugwege simulieren“. Eine Operation enthält das ganze Rohteil. Ein Auftrag enthält das Rohteil nur einmal.</translation>
    </message>
    <message>
        <source>The finest image of Simulate Toolpaths within your limits of time and memory.</source>
        <translation>Das feinste Bild von „Werkzeugwege simulieren“ innerhalb Ihrer Grenzen für Zeit und Speicher.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Remarks that need no action, such as problems of a simulator that the marks do not show.</source>
        <translation>Hinweise, bei denen nichts zu tun ist, etwa Probleme eines Simulators, den die Markierungen nicht zeigen.</translation>
    </message>
    <message>
        <source>Jobs and Operations</source>
        <translation>Aufträge und Operationen</translation>
    </message>
    <message>
        <source>Details of the Selected Operation</source>
        <translation>Einzelheiten der ausgewählten Operation</translation>
    </message>
</context>
<context>
    <name>Vk_SaveStl</name>
    <message>
        <source>Save Simulated Part as STL</source>
        <translation>Simuliertes Teil als STL speichern</translation>
    </message>
    <message>
        <source>Simulates the job, and saves the part that it leaves as an STL file.</source>
        <translation>Simuliert den Auftrag und speichert das Teil, das er zurücklässt, als STL-Datei.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>{} kann nicht geschrieben werden: {}</translation>
    </message>
    <message>
        <source>The part is saved in {}.</source>
        <translation>Das Teil ist in {} gespeichert.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>Raw Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Machined</source>
        <translation>Bearbeitet</translation>
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
        <source>Removal Rate</source>
        <translation>Zeitspanvolumen</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document. Shows the part at any moment, the operation that made each surface, and rapid moves that cut.</source>
        <translation>Simuliert den gewählten Auftrag oder die gewählten Operationen, sonst den Auftrag des aktiven Dokuments. Zeigt das Teil in jedem Augenblick, die Operation, die jede Fläche gemacht hat, und Eilgänge, die schneiden.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths</source>
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
        <source>Folder for the Pictures</source>
        <translation>Ordner für die Bilder</translation>
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
        <source>Simulated Part</source>
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
        <source>As in the 3D View</source>
        <translation>Wie in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Property that colors the surfaces.</source>
        <translation>Eigenschaft, nach der die Flächen gefärbt sind.</translation>
    </message>
    <message>
        <source>Shows the part, the material that the current operation removes, or both.</source>
        <translation>Zeigt das Teil, das Material, das die aktuelle Operation abträgt, oder beides.</translation>
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
        <source>Part and Chips</source>
        <translation>Teil und Späne</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Bild…</translation>
    </message>
    <message>
        <source>Pictures of the Whole Job…</source>
        <translation>Bilder des ganzen Auftrags…</translation>
    </message>
    <message>
        <source>Removal Rates…</source>
        <translation>Zeitspanvolumen…</translation>
    </message>
    <message>
        <source>Plays or pauses the simulation (Space).</source>
        <translation>Spielt die Simulation ab oder hält sie an (Leertaste).</translation>
    </message>
    <message>
        <source>Speed of the playback, compared with the machine.</source>
        <translation>Geschwindigkeit der Wiedergabe, verglichen mit der Maschine.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Auftrag in {}</translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Go to the beginning of the operation.</source>
        <translation>Geht an den Anfang der Operation.</translation>
    </message>
    <message>
        <source>Go back by one command of the program.</source>
        <translation>Geht einen Befehl des Programms zurück.</translation>
    </message>
    <message>
        <source>Go back by one trajectory.</source>
        <translation>Geht eine Bewegung zurück.</translation>
    </message>
    <message>
        <source>Go forward by one trajectory.</source>
        <translation>Geht eine Bewegung weiter.</translation>
    </message>
    <message>
        <source>Go forward by one command of the program.</source>
        <translation>Geht einen Befehl des Programms weiter.</translation>
    </message>
    <message>
        <source>Go to the end of the operation.</source>
        <translation>Geht an das Ende der Operation.</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>etwa {}</translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation>Simulieren… {}</translation>
    </message>
    <message>
        <source>The finest picture takes about {} and {}.</source>
        <translation>Das feinste Bild braucht etwa {} und {}.</translation>
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
        <source>This is uncut stock.</source>
        <translation>Das ist unbearbeitetes Rohteil.</translation>
    </message>
    <message>
        <source>Time Line</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>{} wird gelesen ({} von {})…</translation>
    </message>
    <message>
        <source>There is no closed model.</source>
        <translation>Es gibt kein geschlossenes Modell.</translation>
    </message>
    <message>
        <source>Gouged, {} to {}</source>
        <translation>Zu tief geschnitten, {} bis {}</translation>
    </message>
    <message>
        <source>Stock Left, {} to {}</source>
        <translation>Rohteil übrig, {} bis {}</translation>
    </message>
    <message>
        <source>As the Model</source>
        <translation>Wie das Modell</translation>
    </message>
    <message>
        <source>No Model</source>
        <translation>Kein Modell</translation>
    </message>
    <message>
        <source>Difference to the Model</source>
        <translation>Abweichung vom Modell</translation>
    </message>
    <message>
        <source>Differences from the model below this value are ignored.</source>
        <translation>Abweichungen vom Modell unter diesem Wert werden übergangen.</translation>
    </message>
    <message>
        <source>Worst Places</source>
        <translation>Schlimmste Stellen</translation>
    </message>
    <message>
        <source>Places where the part differs most from the model. Choose a place to see it.</source>
        <translation>Stellen, an denen das Teil am meisten vom Modell abweicht. Wählen Sie eine Stelle, um sie zu sehen.</translation>
    </message>
    <message>
        <source>Collisions, gouges and fast plunges in the simulation. Choose one to see it.</source>
        <translation>Kollisionen, zu tiefe Schnitte und zu schnelles Eintauchen in der Simulation. Wählen Sie eine Zeile, um sie zu sehen.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Warnungen: {}</translation>
    </message>
    <message>
        <source>Stock: {}</source>
        <translation>Rohteil: {}</translation>
    </message>
    <message>
        <source>{}, command {} ({}): {}</source>
        <translation>{}, Befehl {} ({}): {}</translation>
    </message>
    <message>
        <source>Removed: {}</source>
        <translation>Abgetragen: {}</translation>
    </message>
    <message>
        <source>Nothing removed</source>
        <translation>Nichts abgetragen</translation>
    </message>
    <message>
        <source>The model is shown with the finest picture.</source>
        <translation>Das Modell wird mit dem feinsten Bild gezeigt.</translation>
    </message>
    <message>
        <source>The pictures are saved when the finest picture is ready…</source>
        <translation>Die Bilder werden gespeichert, wenn das feinste Bild fertig ist…</translation>
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
        <source>{} (X {} Y {} Z {} {})</source>
        <translation>{} (X {} Y {} Z {} {})</translation>
    </message>
    <message>
        <source>The simulated job has changed. Simulate it again.</source>
        <translation>Der simulierte Auftrag hat sich geändert. Simulieren Sie ihn neu.</translation>
    </message>
    <message>
        <source>Choose the job to simulate:</source>
        <translation>Wählen Sie den Auftrag, der simuliert werden soll:</translation>
    </message>
    <message>
        <source>Checking… {}</source>
        <translation>Prüfung… {}</translation>
    </message>
    <message>
        <source>Gray: removal rate. Orange: cuts air. Triangles: warnings.</source>
        <translation>Grau: Zeitspanvolumen. Orange: Luftschnitte. Dreiecke: Warnungen.</translation>
    </message>
    <message>
        <source>Direction of the view, path of the tool, section, and measuring.</source>
        <translation>Blickrichtung, Weg des Werkzeugs, Schnitt und Messen.</translation>
    </message>
    <message>
        <source>Path of the Tool</source>
        <translation>Weg des Werkzeugs</translation>
    </message>
    <message>
        <source>Shows the path of the operation: blue is done, pink to come.</source>
        <translation>Zeigt den Weg der Operation: Blau ist erledigt, Rosa kommt noch.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Two clicks on the part show their distance. Esc ends it.</source>
        <translation>Zwei Klicks auf das Teil zeigen ihren Abstand. Esc beendet das Messen.</translation>
    </message>
    <message>
        <source>Section in {}</source>
        <translation>Schnitt in {}</translation>
    </message>
    <message>
        <source>No Section</source>
        <translation>Kein Schnitt</translation>
    </message>
    <message>
        <source>Moves the section through the stock.</source>
        <translation>Bewegt den Schnitt durch das Rohteil.</translation>
    </message>
    <message>
        <source>Depth below the stock&apos;s top: {}</source>
        <translation>Tiefe unter der Oberseite des Rohteils: {}</translation>
    </message>
    <message>
        <source>Measuring: click on the first point.</source>
        <translation>Messen: Klicken Sie auf den ersten Punkt.</translation>
    </message>
    <message>
        <source>Click on the second point.</source>
        <translation>Klicken Sie auf den zweiten Punkt.</translation>
    </message>
    <message>
        <source>Distance: {}   ΔX {}   ΔY {}   ΔZ {}</source>
        <translation>Abstand: {}   ΔX {}   ΔY {}   ΔZ {}</translation>
    </message>
    <message>
        <source>This is the section.</source>
        <translation>Das ist die Schnittfläche.</translation>
    </message>
    <message>
        <source>Saves pictures, the shown part as a solid, or removal rates.</source>
        <translation>Speichert Bilder, das gezeigte Teil als Körper oder Zeitspanvolumen.</translation>
    </message>
    <message>
        <source>Shown Part as STL…</source>
        <translation>Gezeigtes Teil als STL…</translation>
    </message>
    <message>
        <source>Shown Part as Mesh in the Document</source>
        <translation>Gezeigtes Teil als Netz im Dokument</translation>
    </message>
    <message>
        <source>This is available when the finest picture is ready.</source>
        <translation>Erst verfügbar, wenn das feinste Bild fertig ist.</translation>
    </message>
    <message>
        <source>Save Part as STL</source>
        <translation>Teil als STL speichern</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, and rapid moves gray. The document is not changed.</source>
        <translation>Färbt die Werkzeugwege in der 3D-Ansicht nach ihrer Bearbeitungsstrategie und Eilgänge grau. Das Dokument wird nicht geändert.</translation>
    </message>
    <message>
        <source>Show Strategies</source>
        <translation>Strategien zeigen</translation>
    </message>
    <message>
        <source>Rapid Moves</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Drawing strategies, operations left: {}</source>
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
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Werkzeugweg-Analyse</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates the cost of their simulation.</source>
        <translation>Erkennt Bearbeitungsstrategien von Werkzeugwegen und schätzt den Aufwand ihrer Simulation.</translation>
    </message>
</context>
</TS>
