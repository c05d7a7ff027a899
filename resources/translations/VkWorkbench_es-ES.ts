<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The machining strategy recognized from the toolpath.</source>
        <translation>Estrategia de mecanizado reconocida en la trayectoria de la herramienta.</translation>
    </message>
    <message>
        <source>The reason for this strategy.</source>
        <translation>La razón de esta estrategia.</translation>
    </message>
    <message>
        <source>The text of the mark in the description.</source>
        <extracomment>The results of this session.</extracomment>
        <translation>El texto de la marca en la descripción.</translation>
    </message>
    <message>
        <source>The confidence of the recognition, in percent.</source>
        <translation>La confianza del reconocimiento, en tanto por ciento.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what to know before simulating it.</source>
        <translation>Los problemas de la operación y lo que hay que saber antes de simularla.</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Longitud de los movimientos de corte.</translation>
    </message>
    <message>
        <source>Time on the machine.</source>
        <translation>Tiempo en la máquina.</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows.</source>
        <translation>Tiempo estimado de la simulación que muestra la marca.</translation>
    </message>
</context>
<context>
    <name>Pills</name>
    <message>
        <source>outdated</source>
        <translation>anticuado</translation>
    </message>
    <message>
        <source>{} operation</source>
        <translation>{} operación</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} operaciones</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Este resultado está anticuado, porque la trayectoria, la herramienta o el material ha cambiado. Analice la operación de nuevo.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known. Analyze the operation again.</source>
        <translation>El tiempo en el {simulator} no se conoce. Analice la operación de nuevo.</translation>
    </message>
    <message>
        <source>{strategy}, confidence {share}</source>
        <translation>{strategy}, confianza {share}</translation>
    </message>
    <message>
        <source>Cutting length: {length}.</source>
        <translation>Longitud de corte: {length}.</translation>
    </message>
    <message>
        <source>Machining time: {time}. Cutting length: {length}.</source>
        <translation>Tiempo de mecanizado: {time}. Longitud de corte: {length}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Tiempo de simulación en el {simulator}: {time}. Memoria: {memory}.</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: at least {time}. Memory: {memory}.</source>
        <translation>Tiempo de simulación en el {simulator}: al menos {time}. Memoria: {memory}.</translation>
    </message>
    <message>
        <source>Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>Tiempo de simulación de esta operación sola en el {simulator}: {time}. Memoria: {memory}.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>sim {time}</source>
        <translation>sim. {time}</translation>
    </message>
    <message>
        <source>at least {time}</source>
        <translation>al menos {time}</translation>
    </message>
    <message>
        <source>Machining time at constant feed: {time}. Cutting length: {length}.</source>
        <translation>Tiempo de mecanizado con avance constante: {time}. Longitud de corte: {length}.</translation>
    </message>
    <message>
        <source>Tool changes and starts of the spindle: {time}.</source>
        <translation>Cambios de herramienta y arranques del husillo: {time}.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>No move cuts, because there are only rapid moves.</source>
        <translation>Ningún movimiento corta, porque solo hay movimientos rápidos.</translation>
    </message>
    <message>
        <source>No move cuts, because there are no moves.</source>
        <translation>Ningún movimiento corta, porque no hay movimientos.</translation>
    </message>
    <message>
        <source>, counter-clockwise</source>
        <translation>, sentido antihorario</translation>
    </message>
    <message>
        <source>, clockwise</source>
        <translation>, sentido horario</translation>
    </message>
    <message>
        <source>descending at a constant radius</source>
        <translation>que descienden con radio constante</translation>
    </message>
    <message>
        <source>the direction of nested loops alternates</source>
        <translation>el sentido de los lazos anidados se alterna</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>espaciados por igual en el plano, no en profundidad</translation>
    </message>
    <message>
        <source>with a shape that changes with the depth</source>
        <translation>con una forma que cambia con la profundidad</translation>
    </message>
    <message>
        <source>a winding with a helical entry or with extra cuts in the corners</source>
        <translation>un devanado con entrada helicoidal o cortes adicionales en las esquinas</translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation>un devanado que nunca se cierra</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>anidados</translation>
    </message>
    <message>
        <source>small loops that advance along the path</source>
        <translation>lazos pequeños que avanzan a lo largo de la trayectoria</translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation>una pasada abierta queda dentro de un contorno</translation>
    </message>
    <message>
        <source>no nested offsets</source>
        <translation>sin contornos anidados</translation>
    </message>
    <message>
        <source>half-turns alternate in sign</source>
        <translation>las medias vueltas alternan de signo</translation>
    </message>
    <message>
        <source>all rows run the same way</source>
        <translation>todas las filas van en el mismo sentido</translation>
    </message>
    <message>
        <source>open contours change with the depth</source>
        <translation>los contornos abiertos cambian con la profundidad</translation>
    </message>
    <message>
        <source>one open contour</source>
        <translation>un solo contorno abierto</translation>
    </message>
    <message>
        <source>an open contour is repeated</source>
        <translation>un contorno abierto se repite</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>trazos abiertos tan largos como la pieza</translation>
    </message>
    <message>
        <source>short strokes that do not fill an area</source>
        <translation>trazos cortos que no rellenan un área</translation>
    </message>
    <message>
        <source>The toolpath has no cutting move.</source>
        <translation>La trayectoria no tiene ningún movimiento de corte.</translation>
    </message>
    <message>
        <source>The operation has no toolpath. Recompute it and read FreeCAD&apos;s report view.</source>
        <translation>La operación no tiene trayectoria. Recalcúlela y lea la vista de informe de FreeCAD.</translation>
    </message>
    <message>
        <source>The operation has no tool. Give it a tool controller.</source>
        <translation>La operación no tiene herramienta. Asígnele un controlador de herramienta.</translation>
    </message>
    <message>
        <source>{label} has no tool. Choose a tool bit for it.</source>
        <translation>{label} no tiene herramienta. Elija una para él.</translation>
    </message>
    <message>
        <source>The tool in {label} has no diameter. Enter one in its tool bit.</source>
        <translation>La herramienta de {label} no tiene diámetro. Indique uno en la herramienta.</translation>
    </message>
    <message>
        <source>The toolpath has no stock. Put it into a job.</source>
        <translation>La trayectoria no tiene material en bruto. Póngala en un trabajo.</translation>
    </message>
    <message>
        <source>{label} has no stock. Give it one in the job&apos;s settings.</source>
        <translation>{label} no tiene material en bruto. Asígnele uno en los ajustes del trabajo.</translation>
    </message>
    <message>
        <source>The simulation cost of {labels} is unknown.</source>
        <translation>Se desconoce el coste de simulación de {labels}.</translation>
    </message>
    <message>
        <source>Words without a motion before them are ignored.</source>
        <translation>Las palabras sin un movimiento previo se ignoran.</translation>
    </message>
    <message>
        <source>A feed rate that is not a usable number is ignored.</source>
        <translation>Un avance que no es un número utilizable se ignora.</translation>
    </message>
    <message>
        <source>Center words (I, J, K) that are not usable numbers are ignored.</source>
        <translation>Las palabras de centro (I, J, K) que no son números utilizables se ignoran.</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored.</source>
        <translation>Las palabras {letter} que no son números utilizables se ignoran.</translation>
    </message>
    <message>
        <source>Positions farther than a kilometer from the origin are limited to a kilometer.</source>
        <translation>Las posiciones a más de un kilómetro del origen se limitan a un kilómetro.</translation>
    </message>
    <message>
        <source>A drilling cycle without a depth (Z) drills no hole.</source>
        <translation>Un ciclo de taladrado sin profundidad (Z) no taladra ningún agujero.</translation>
    </message>
    <message>
        <source>A drilling cycle without R starts at the current height.</source>
        <translation>Un ciclo de taladrado sin R empieza a la altura actual.</translation>
    </message>
    <message>
        <source>An arc with an unknown start is ignored.</source>
        <translation>Un arco cuyo comienzo se desconoce se ignora.</translation>
    </message>
    <message>
        <source>An arc without a usable center or radius is read as a line.</source>
        <translation>Un arco sin centro ni radio utilizables se lee como una recta.</translation>
    </message>
    <message>
        <source>An arc that does not end on its circle is read with a changing radius.</source>
        <translation>Un arco que no termina en su círculo se lee con radio variable.</translation>
    </message>
    <message>
        <source>without an X or Y word</source>
        <translation>sin palabra X o Y</translation>
    </message>
    <message>
        <source>without a Z word</source>
        <translation>sin palabra Z</translation>
    </message>
    <message>
        <source>without a center</source>
        <translation>sin centro</translation>
    </message>
    <message>
        <source>that is a full circle</source>
        <translation>que es un círculo completo</translation>
    </message>
    <message>
        <source>Leave this operation out of the simulation.</source>
        <translation>Deje esta operación fuera de la simulación.</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>demasiado hondo</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>demasiado alto</translation>
    </message>
    <message>
        <source>Move its accuracy slider to the left.</source>
        <translation>Mueva su control de precisión a la izquierda.</translation>
    </message>
    <message>
        <source>Simulate fewer operations at a time.</source>
        <translation>Simule menos operaciones a la vez.</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>la memoria</translation>
    </message>
    <message>
        <source>time</source>
        <translation>el tiempo</translation>
    </message>
    <message>
        <source>None, because not even a single pixel fits into the memory.</source>
        <translation>Ninguna, porque ni un solo píxel cabe en la memoria.</translation>
    </message>
    <message>
        <source>The cost is estimated for a stock that is a box around the cuts.</source>
        <translation>El coste se estima para un material en bruto que es un bloque alrededor de los cortes.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock. Check its depths, its placement and the stock.</source>
        <translation>La operación no toca el material en bruto. Compruebe sus profundidades, su ubicación y el material.</translation>
    </message>
    <message>
        <source>The tool is wider than the stock. Check the tool&apos;s diameter and the stock.</source>
        <translation>La herramienta es más ancha que el material en bruto. Compruebe el diámetro de la herramienta y el material.</translation>
    </message>
    <message>
        <source>Choose a smaller image in the preferences.</source>
        <translation>Elija una imagen más pequeña en las preferencias.</translation>
    </message>
    <message>
        <source>that sweeps no angle</source>
        <translation>que no barre ningún ángulo</translation>
    </message>
    <message>
        <source>about {number}</source>
        <translation>unos {number}</translation>
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
        <translation>El radio de esquina debe estar entre 0 y {radius:mm}, no ser {corner:mm}.</translation>
    </message>
    <message>
        <source>The tip angle must be between 0 and pi, not {angle:g}.</source>
        <translation>El ángulo de punta debe estar entre 0 y π, no ser {angle:g}.</translation>
    </message>
    <message>
        <source>The stock has no volume. Its upper corner must exceed its lower corner in x, y and z.</source>
        <translation>El material no tiene volumen. Su esquina superior debe superar a la inferior en x, y y z.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de corte en {count:n} movimiento sin avance.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de corte en {count:n} movimientos sin avance.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} is 0.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de rápidos, porque {name} del controlador de herramienta es 0.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} and {other} are 0.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de rápidos, porque {name} y {other} del controlador de herramienta son 0.</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> y {count:n} más</translation>
    </message>
    <message>
        <source> Passes {step:mm3} apart need {cell:mm2}.</source>
        <translation> Pasadas a {step:mm3} piden {cell:mm2}.</translation>
    </message>
    <message>
        <source> For passes {step:mm3} apart, {cell:mm2} is fine enough.</source>
        <translation> Para pasadas a {step:mm3} bastan {cell:mm2}.</translation>
    </message>
    <message>
        <source>None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}</source>
        <translation>Ninguna, porque solo los movimientos tardan {time:s}. Simule menos operaciones.{heaviest}</translation>
    </message>
    <message>
        <source> The slowest is {label} with {time:s}.</source>
        <translation> La más lenta es {label} con {time:s}.</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> y 1 más</translation>
    </message>
    <message>
        <source>Command {command:#}: {sentence}</source>
        <translation>Orden {command:#}: {sentence}</translation>
    </message>
    <message>
        <source>Command {command:#} (first of {count:n}): {sentence}</source>
        <translation>Orden {command:#} (la primera de {count:n}): {sentence}</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored.</source>
        <translation>El código desconocido {name} se ignora.</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored.</source>
        <translation>Se ignora otro código desconocido.</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored.</source>
        <translation>Se ignoran otros {count:n} códigos desconocidos.</translation>
    </message>
    <message>
        <source>The arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}. Choose a larger tolerance in the preferences.</source>
        <translation>Los arcos y ciclos necesitarían {moves:n} movimientos con una tolerancia de {tolerance:mm}. Elija una tolerancia mayor en las preferencias.</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}: {sentence}</translation>
    </message>
    <message>
        <source>The analysis failed. Please report the error together with the file: {error}</source>
        <translation>El análisis ha fallado. Informe del error junto con el archivo: {error}</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en {count:n} filas{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene en 0 en {count:n} filas{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en un trazo abierto{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en {count:n} trazos abiertos{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene en 0 en un trazo abierto{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ se mantiene en 0 en {count:n} trazos abiertos{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ alcanza {reached:turns} vueltas en un lazo{spread}, {seen}: {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ alcanza {reached:turns} vueltas en {count:n} lazos{spread}, {seen}: {strategy:strategy}{turning}.</translation>
    </message>
    <message>
        <source>Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}.</source>
        <translation>φ está entre {low:turns} y {high:turns} vueltas, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at one point: {strategy:strategy}.</source>
        <translation>φ no está definido, porque los movimientos son verticales en un punto: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}.</source>
        <translation>φ no está definido, porque los movimientos son verticales en {count:n} puntos: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at some points: {strategy:strategy}.</source>
        <translation>φ no está definido, porque los movimientos son verticales en algunos puntos: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling, show {strategies:strategy}: {strategy:strategy}.</source>
        <translation>{count:n} secciones separadas por cambios de herramienta, títulos, retiradas o taladros muestran {strategies:strategy}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation> a {step:mm3} en {depths:n} profundidades</translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation> a {step:mm3}</translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation> en {depths:n} profundidades</translation>
    </message>
    <message>
        <source>{count:n} engagements in the same direction overlap</source>
        <translation>{count:n} cortes de un mismo sentido se solapan</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) fill the same area</source>
        <translation>filas ({rows:%} de la longitud) y lazos ({loops:%}) rellenan la misma superficie</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} a {high}</translation>
    </message>
    <message>
        <source>Line {line:#}: {what}</source>
        <translation>Línea {line:#}: {what}</translation>
    </message>
    <message>
        <source>Line {line:#} (first of {count:n}): {what}</source>
        <translation>Línea {line:#} (la primera de {count:n}): {what}</translation>
    </message>
    <message>
        <source>Lines with a block delete (/) are read like all others.</source>
        <translation>Las líneas con salto de bloque (/) se leen como las demás.</translation>
    </message>
    <message>
        <source>A subprogram or macro call is ignored.</source>
        <translation>Una llamada a subprograma o macro se ignora.</translation>
    </message>
    <message>
        <source>Jumps, loops and calls are ignored.</source>
        <translation>Los saltos, bucles y llamadas se ignoran.</translation>
    </message>
    <message>
        <source>Words with variables or expressions are ignored.</source>
        <translation>Las palabras con variables o expresiones se ignoran.</translation>
    </message>
    <message>
        <source>Lines that do not consist of words like G1 X10 are ignored.</source>
        <translation>Las líneas que no constan de palabras como G1 X10 se ignoran.</translation>
    </message>
    <message>
        <source>{name} is ignored. The coordinates after it are read as if it were not there.</source>
        <translation>{name} se ignora. Las coordenadas que siguen se leen como si no estuviera.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as a line.</source>
        <translation>Un spline ({name}) se lee como una recta.</translation>
    </message>
    <message>
        <source>Lines after the end of the program are ignored.</source>
        <translation>Las líneas después del final del programa se ignoran.</translation>
    </message>
    <message>
        <source>Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.</source>
        <translation>Línea {line:#}: El programa está escrito para controles {name}. Emítalo como código G (ISO) para analizarlo.</translation>
    </message>
    <message>
        <source>This is not an NC program. {part:n} of its {lines:n} lines do not consist of words like G1 X10. The first of them is line {line:#}.</source>
        <translation>No es un programa CN. {part:n} de sus {lines:n} líneas no constan de palabras como G1 X10. La primera es la línea {line:#}.</translation>
    </message>
    <message>
        <source>This is not an NC program. None of its lines moves a tool.</source>
        <translation>No es un programa CN. Ninguna de sus líneas mueve una herramienta.</translation>
    </message>
    <message>
        <source>None of the moves can be read. {problems}</source>
        <translation>No se puede leer ninguno de los movimientos. {problems}</translation>
    </message>
    <message>
        <source>This is not an NC program, because it is not text.</source>
        <translation>No es un programa CN, porque no es un texto.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it.</source>
        <translation>Línea {line:#}: {name} indica un programa para un torno. Las estrategias de fresado no se le aplican.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it.</source>
        <translation>Línea {line:#}: {name} indica un programa para una impresora 3D. Las estrategias de fresado no se le aplican.</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it.</source>
        <translation>Línea {line:#}: {name} indica un programa para una cortadora de hilo. Las estrategias de fresado no se le aplican.</translation>
    </message>
    <message>
        <source>Line {line:#}: A rotary axis turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Línea {line:#}: Un eje rotativo gira mientras la herramienta corta. El recorrido de la herramienta se desconoce aquí.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de rápidos, porque un programa no contiene su velocidad.</translation>
    </message>
    <message>
        <source>The program does not contain the tool&apos;s diameter, so the cost is unknown.</source>
        <translation>El programa no contiene el diámetro de la herramienta, así que el coste se desconoce.</translation>
    </message>
    <message>
        <source>The file cannot be read: {name}.</source>
        <translation>No se puede leer el archivo: {name}.</translation>
    </message>
    <message>
        <source>The file is larger than {size:bytes}.</source>
        <translation>El archivo supera {size:bytes}.</translation>
    </message>
    <message>
        <source>The analysis was stopped after {time:s}.</source>
        <translation>El análisis se detuvo tras {time:s}.</translation>
    </message>
    <message>
        <source>The process that read the file ended unexpectedly, perhaps for lack of memory.</source>
        <translation>El proceso que leía el archivo terminó de forma inesperada, quizá por falta de memoria.</translation>
    </message>
    <message>
        <source>The toolpath looks 25.4 times too small. Inches are probably read as millimeters.</source>
        <translation>La trayectoria parece 25,4 veces demasiado pequeña. Probablemente se leen pulgadas como milímetros.</translation>
    </message>
    <message>
        <source>There is nothing to simulate. Choose a job, or operations with a toolpath.</source>
        <translation>No hay nada que simular. Elija un trabajo u operaciones con una trayectoria.</translation>
    </message>
    <message>
        <source>These operations belong to several jobs. Choose operations of one job only: {labels}.</source>
        <translation>Estas operaciones pertenecen a varios trabajos. Elija operaciones de un solo trabajo: {labels}.</translation>
    </message>
    <message>
        <source>legacy simulator</source>
        <translation>simulador antiguo</translation>
    </message>
    <message>
        <source>OpenGL simulator</source>
        <translation>simulador OpenGL</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}</source>
        <translation>El {simulator:simulator} se bloquea en un arco {reason} (orden {command:#}{others}). {instead}</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>El {simulator:simulator} corta {count:n} rampa a una profundidad falsa, hasta {error:mm2} {way} (orden {command:#}). No juzgue las profundidades por él.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>El {simulator:simulator} corta {count:n} rampas a una profundidad falsa, hasta {error:mm2} {way} (orden {command:#}). No juzgue las profundidades por él.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.</source>
        <translation>La reproducción dura unos {longer:estimate} en el {simulator:simulator}. Use el avance rápido, que dura unos {time:estimate}.</translation>
    </message>
    <message>
        <source>Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. Simulate fewer operations at a time.</source>
        <translation>La reproducción dura unos {time:estimate} en el {simulator:simulator} a su máxima velocidad. Simule menos operaciones a la vez.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>{count:n} movimientos son más cortos que una celda del {simulator:simulator} ({cell:mm2}). Llevan tiempo, pero no se ven. Elija una tolerancia más gruesa para la operación.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>El {simulator:simulator} ocupa unos {memory:bytes} en esta operación, más que su límite de {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Use the {simulator:simulator} for this operation.</source>
        <translation>Use el {simulator:simulator} para esta operación.</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}.</source>
        <translation>El diámetro de la herramienta debe ser positivo y de un kilómetro como máximo, no {diameter:mm}.</translation>
    </message>
    <message>
        <source>The corners of the stock must be numbers within a kilometer of the origin.</source>
        <translation>Las esquinas del material deben ser números a menos de un kilómetro del origen.</translation>
    </message>
    <message>
        <source>Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD&apos;s G-code import does not convert them.</source>
        <translation>Los avances de hasta {feed:g} mm/s se leen como mm/min, porque la importación de código G de FreeCAD no los convierte.</translation>
    </message>
    <message>
        <source>The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}.</source>
        <translation>El diámetro de la punta debe estar entre 0 y {diameter:mm}, no ser {tip:mm}.</translation>
    </message>
    <message>
        <source>The surface of the solid is not closed.</source>
        <translation>La superficie del sólido no está cerrada.</translation>
    </message>
    <message>
        <source>The stock of {label} is simulated as the box around it. {sentence}</source>
        <translation>El material de {label} se simula como la caja que lo rodea. {sentence}</translation>
    </message>
    <message>
        <source>{label} is simulated only approximately, {instead}.</source>
        <translation>{label} se simula solo de forma aproximada, {instead}.</translation>
    </message>
    <message>
        <source>as an end mill with its largest diameter</source>
        <translation>como fresa recta de su diámetro mayor</translation>
    </message>
    <message>
        <source>as a ball end mill with the diameter of its tip</source>
        <translation>como fresa esférica del diámetro de su punta</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>como broca</translation>
    </message>
    <message>
        <source>A rotary axis ({letter}) turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>Un eje rotativo ({letter}) gira mientras la herramienta corta. El recorrido de la herramienta se desconoce aquí.</translation>
    </message>
    <message>
        <source>Moves of a rotary axis ({letter}) are ignored.</source>
        <translation>Los movimientos de un eje rotativo ({letter}) se ignoran.</translation>
    </message>
    <message>
        <source>{letter} words are ignored.</source>
        <translation>Las palabras {letter} se ignoran.</translation>
    </message>
    <message>
        <source>The repeats of a cycle ({letter}) are ignored.</source>
        <translation>Las repeticiones de un ciclo ({letter}) se ignoran.</translation>
    </message>
    <message>
        <source>Inches (G20) are ignored. Lengths are read in mm.</source>
        <translation>Las pulgadas (G20) se ignoran. Las longitudes se leen en mm.</translation>
    </message>
    <message>
        <source>Cutter compensation ({name}) is ignored. The programmed path is used.</source>
        <translation>La compensación de radio ({name}) se ignora. Se usa el recorrido programado.</translation>
    </message>
    <message>
        <source>Feeds after {name} are ignored.</source>
        <translation>Los avances después de {name} se ignoran.</translation>
    </message>
    <message>
        <source>Dwell times are not included in the machining time.</source>
        <translation>Las pausas no están incluidas en el tiempo de mecanizado.</translation>
    </message>
    <message>
        <source>open strokes side by side at an even distance</source>
        <translation>trazos abiertos uno junto a otro a igual distancia</translation>
    </message>
    <message>
        <source>open strokes side by side, from one wall to the other</source>
        <translation>trazos abiertos uno junto a otro, de una pared a la otra</translation>
    </message>
    <message>
        <source>many small contours of different shapes</source>
        <translation>muchos contornos pequeños de formas distintas</translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}.</source>
        <translation>{count:n} fila{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}.</source>
        <translation>{count:n} filas{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One open cut{spread}, {seen}.</source>
        <translation>Un corte abierto{spread}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}.</source>
        <translation>{count:n} cortes abiertos{spread}, {seen}.</translation>
    </message>
    <message>
        <source>One loop{spread}{turning}, {seen}.</source>
        <translation>Una vuelta{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}.</source>
        <translation>{count:n} vueltas{spread}{turning}, {seen}.</translation>
    </message>
    <message>
        <source>Straight down at one point.</source>
        <translation>Recto hacia abajo en un punto.</translation>
    </message>
    <message>
        <source>Straight down at {count:n} points.</source>
        <translation>Recto hacia abajo en {count:n} puntos.</translation>
    </message>
    <message>
        <source>Straight down at some points.</source>
        <translation>Recto hacia abajo en algunos puntos.</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.</source>
        <translation>{count:n} secciones, separadas por cambios de herramienta, títulos, retracciones o taladrado: {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{count:n} overlapping engagements</source>
        <translation>{count:n} cortes que se solapan</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>una horaria, la siguiente antihoraria</translation>
    </message>
    <message>
        <source>all in one continuous cut that never closes</source>
        <translation>todo en un corte continuo que nunca se cierra</translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation>una dentro de otra</translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation>ninguna dentro de otra</translation>
    </message>
    <message>
        <source>cut back and forth</source>
        <translation>cortadas de ida y vuelta</translation>
    </message>
    <message>
        <source>all cut in the same direction</source>
        <translation>todas cortadas en el mismo sentido</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ permanece entre {low:turns} y {high:turns} vueltas en una fila{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ permanece en 0 en una fila{spread}, {seen}: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It takes time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>Un movimiento es más corto que una celda del {simulator:simulator} ({cell:mm2}). Lleva tiempo, pero no se ve. Elija una tolerancia más gruesa para la operación.</translation>
    </message>
    <message>
        <source>arranged as in known toolpaths ({share:%} of the votes)</source>
        <translation>dispuestos como en trayectorias conocidas ({share:%} de los votos)</translation>
    </message>
    <message>
        <source>unlike any known machining ({share:%} of the votes)</source>
        <translation>distinto de todo mecanizado conocido ({share:%} de los votos)</translation>
    </message>
    <message>
        <source> The tool enters on a ramp.</source>
        <translation> La herramienta entra en rampa.</translation>
    </message>
    <message>
        <source> The tool enters on a ramp that goes back and forth.</source>
        <translation> La herramienta entra en una rampa de ida y vuelta.</translation>
    </message>
    <message>
        <source> The tool enters on a helix.</source>
        <translation> La herramienta entra en hélice.</translation>
    </message>
    <message>
        <source> A contour around the rows finishes the area.</source>
        <translation> Un contorno alrededor de las filas acaba la superficie.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this simulation: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator} se bloquea en esta simulación: la orden {command:#} de {label}{others} es un arco {reason}.</translation>
    </message>
    <message>
        <source> (also in another operation)</source>
        <translation> (y otra operación)</translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
        <translation> (y {count:n} operaciones más)</translation>
    </message>
    <message>
        <source>Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}.</source>
        <translation>Reproducir esta simulación tarda {bound} {time:estimate} en el {simulator:simulator}.</translation>
    </message>
    <message>
        <source>about</source>
        <translation>unos</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>al menos</translation>
    </message>
    <message>
        <source>Simulate Toolpaths shows the finished part at once, coarse at first.</source>
        <translation>«Simular trayectorias» muestra enseguida la pieza acabada, al principio tosca.</translation>
    </message>
    <message>
        <source>A rapid move removes {volume:mm³2}.</source>
        <translation>Un movimiento rápido quita {volume:mm³2}.</translation>
    </message>
    <message>
        <source>The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}.</source>
        <translation>La herramienta entra en pleno material a {feed:mm/min3}. Su límite es {allowed:mm/min3}.</translation>
    </message>
    <message>
        <source>{depth:mm2} of stock is left on the model.</source>
        <translation>Quedan {depth:mm2} de material sobre el modelo.</translation>
    </message>
    <message>
        <source>A finer picture would take longer than the {allowed:s} limit in the preferences.</source>
        <translation>Una imagen más fina tardaría más que el límite de {allowed:s} de las preferencias.</translation>
    </message>
    <message>
        <source>The simulation shows a fault at command {command:#}: {fault}</source>
        <translation>La simulación muestra un fallo en la orden {command:#}: {fault}</translation>
    </message>
    <message>
        <source>All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}.</source>
        <translation>Todos los movimientos son en X y Z, con pasadas a lo largo de Z en muchas X, como en un torno: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>The placement of the operation must be numbers within a kilometer of the origin.</source>
        <translation>La ubicación de la operación debe constar de números a menos de un kilómetro del origen.</translation>
    </message>
    <message>
        <source>Of two {letter} words in a line, the last one is read.</source>
        <translation>De dos palabras {letter} en una línea se lee la última.</translation>
    </message>
    <message>
        <source>{told} A small part is {strategies:strategy}.</source>
        <translation>{told} Una pequeña parte es: {strategies:strategy}.</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}</source>
        <translation>{width:n} × {height:n} píxeles de {pixel:mm2}, limitados por {limit}.{passes}</translation>
    </message>
    <message>
        <source>Lines with variables or expressions are ignored.</source>
        <translation>Las líneas con variables o expresiones se ignoran.</translation>
    </message>
    <message>
        <source>Moves to machine positions ({name}) are ignored, because the program does not contain these positions.</source>
        <translation>Los movimientos a posiciones de la máquina ({name}) se ignoran, porque el programa no contiene estas posiciones.</translation>
    </message>
    <message>
        <source>The holes of a pattern ({name}) are ignored.</source>
        <translation>Los agujeros de un patrón ({name}) se ignoran.</translation>
    </message>
    <message>
        <source>The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units.</source>
        <translation>La trayectoria abarca metros en números enteros. Probablemente se leen milésimas sin punto decimal como unidades enteras.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}</source>
        <translation>El {simulator:simulator} tarda {bound} {time:estimate}, más que su límite de {allowed:s}. {better}</translation>
    </message>
    <message>
        <source>The centers of arcs are read as positions (as with G90.1). The arcs only close this way.</source>
        <translation>Los centros de los arcos se leen como posiciones (como con G90.1). Solo así se cierran los arcos.</translation>
    </message>
    <message>
        <source>strokes that rise toward their ends, as in V-carving</source>
        <translation>trazos que suben hacia sus extremos, como en el tallado en V</translation>
    </message>
    <message>
        <source>cut in strokes, as between holding tags</source>
        <translation>cortados en trazos, como entre pestañas</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored, and the {letters} words of its line with it.</source>
        <translation>El código desconocido {name} se ignora, y con él las palabras {letters} de su línea.</translation>
    </message>
    <message>
        <source>Probing moves are not included in the machining time.</source>
        <translation>Los movimientos de palpado no están incluidos en el tiempo de mecanizado.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} into the model.</source>
        <translation>La herramienta corta {depth:mm2} dentro del modelo.</translation>
    </message>
    <message>
        <source>The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}</source>
        <translation>La simulación muestra fallos en {count:n} órdenes, por ejemplo en la orden {command:#}: {fault}</translation>
    </message>
    <message>
        <source>The operation is called {name}, but its toolpath is {strategy:strategy}.</source>
        <translation>La operación se llama {name}, pero su trayectoria es: {strategy:strategy}.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a zip archive. Unpack it first.</source>
        <translation>No es un programa CN, sino un archivo zip. Descomprímalo primero.</translation>
    </message>
    <message>
        <source>This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a folder of documents, use the macro examples/macros/folder_to_csv.py.</source>
        <translation>No es un programa CN, sino un documento de FreeCAD. Analícelo en FreeCAD. Para una carpeta de documentos, use la macro examples/macros/folder_to_csv.py.</translation>
    </message>
    <message>
        <source>The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.</source>
        <translation>El material en bruto es {depth:mm2} demasiado pequeño para el modelo. Elija un material mayor o mueva el modelo dentro de él.</translation>
    </message>
    <message>
        <source>The operation is switched off. It has no toolpath until you switch it on and recompute it.</source>
        <translation>La operación está desactivada. No tiene trayectoria hasta que la active y la recalcule.</translation>
    </message>
    <message>
        <source>This is not a file, but a pipe or a device.</source>
        <translation>No es un archivo, sino una tubería o un dispositivo.</translation>
    </message>
    <message>
        <source>The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.</source>
        <translation>La operación no toca el material en bruto, que ya es la pieza terminada. Elija como material un bloque que la rodee.</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>La simulación ocupa unos {memory:bytes} como máximo, para {dexels:n} dexels y {traces:n} elementos de traza, más que su límite de {allowed:bytes}. {instead}</translation>
    </message>
    <message>
        <source>Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the preferences, or simulate fewer operations.</source>
        <translation>Elija en las preferencias una imagen de {width:n} × {height:n} píxeles de {pixel:mm2} o simule menos operaciones.</translation>
    </message>
    <message>
        <source>A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once.</source>
        <translation>Una profundidad de picoteo (Q) que necesita más de {most:n} picoteos se ignora. El agujero se taladra de una vez.</translation>
    </message>
    <message>
        <source>The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). They are read as offsets.</source>
        <translation>El programa no muestra si los centros de sus círculos son desplazamientos (G91.1) o posiciones (G90.1). Se leen como desplazamientos.</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long.</source>
        <translation>La herramienta corta {depth:mm2} más profundo que sus filos, que miden {length:mm3}.</translation>
    </message>
    <message>
        <source>The shank collides with material {depth:mm2} high.</source>
        <translation>El vástago choca con material de {depth:mm2} de altura.</translation>
    </message>
    <message>
        <source>The holder collides with material {depth:mm2} high.</source>
        <translation>El portaherramientas choca con material de {depth:mm2} de altura.</translation>
    </message>
    <message>
        <source>The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.</source>
        <translation>La herramienta es demasiado corta: mide {length:mm3}, y el material de al lado supera su extremo superior en {depth:mm2}.</translation>
    </message>
    <message>
        <source>{part} collides with the clamp {clamp}.</source>
        <translation>{part} choca con la brida {clamp}.</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>La herramienta</translation>
    </message>
    <message>
        <source>The shank</source>
        <translation>El vástago</translation>
    </message>
    <message>
        <source>The holder</source>
        <translation>El portaherramientas</translation>
    </message>
    <message>
        <source>{sentences}</source>
        <translation>{sentences}</translation>
    </message>
    <message>
        <source>Shanks were checked.</source>
        <translation>Los vástagos se han comprobado.</translation>
    </message>
    <message>
        <source>Shanks were not checked, because no tool has a cutting edge height and a shank diameter.</source>
        <translation>Los vástagos no se han comprobado, porque ninguna herramienta tiene altura de filo y diámetro de vástago.</translation>
    </message>
    <message>
        <source>The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.</source>
        <translation>Los vástagos de {labels} no se han comprobado, porque las herramientas no tienen altura de filo o diámetro de vástago.</translation>
    </message>
    <message>
        <source>Holders were checked.</source>
        <translation>Los portaherramientas se han comprobado.</translation>
    </message>
    <message>
        <source>No holder is given.</source>
        <translation>No se ha indicado ningún portaherramientas.</translation>
    </message>
    <message>
        <source>No holder is given for {labels}.</source>
        <translation>No se ha indicado ningún portaherramientas para {labels}.</translation>
    </message>
    <message>
        <source>1 clamp was checked.</source>
        <translation>Se ha comprobado 1 brida.</translation>
    </message>
    <message>
        <source>{count:n} clamps were checked.</source>
        <translation>Se han comprobado {count:n} bridas.</translation>
    </message>
    <message>
        <source>No clamps are given.</source>
        <translation>No se han indicado bridas.</translation>
    </message>
    <message>
        <source>Nothing is checked yet.</source>
        <translation>Todavía no se ha comprobado nada.</translation>
    </message>
    <message>
        <source>No {what}, checked to {pixel:mm2}.</source>
        <translation>Sin {what}, comprobado con una precisión de {pixel:mm2}.</translation>
    </message>
    <message>
        <source>Checked to {pixel:mm2}.</source>
        <translation>Comprobado con una precisión de {pixel:mm2}.</translation>
    </message>
    <message>
        <source>collision, gouge or fast plunge</source>
        <translation>colisión, corte en el modelo ni entrada demasiado rápida</translation>
    </message>
    <message>
        <source>collision or fast plunge</source>
        <translation>colisión ni entrada demasiado rápida</translation>
    </message>
    <message>
        <source>1 rapid cuts into material.</source>
        <translation>1 movimiento rápido corta material.</translation>
    </message>
    <message>
        <source>{count:n} rapids cut into material.</source>
        <translation>{count:n} movimientos rápidos cortan material.</translation>
    </message>
    <message>
        <source>1 gouge is {depth:mm2} deep in the model.</source>
        <translation>1 corte entra {depth:mm2} en el modelo.</translation>
    </message>
    <message>
        <source>{count:n} gouges are up to {depth:mm2} deep in the model.</source>
        <translation>{count:n} cortes entran hasta {depth:mm2} en el modelo.</translation>
    </message>
    <message>
        <source>1 plunge is too fast.</source>
        <translation>1 entrada es demasiado rápida.</translation>
    </message>
    <message>
        <source>{count:n} plunges are too fast.</source>
        <translation>{count:n} entradas son demasiado rápidas.</translation>
    </message>
    <message>
        <source>The file has more than {lines:n} lines.</source>
        <translation>El archivo tiene más de {lines:n} líneas.</translation>
    </message>
    <message>
        <source>This is not an NC program. It has a line of more than {characters:n} characters.</source>
        <translation>Esto no es un programa CN. Tiene una línea de más de {characters:n} caracteres.</translation>
    </message>
    <message>
        <source>The memory is not sufficient for this program. Divide it into smaller programs.</source>
        <translation>La memoria no es suficiente para este programa. Divídalo en programas más pequeños.</translation>
    </message>
    <message>
        <source>Shank checked; no holder and no clamps given.</source>
        <translation>Vástago comprobado; sin portaherramientas ni bridas indicados.</translation>
    </message>
    <message>
        <source>FreeCAD is still reading {document}. Try again when the document is open.</source>
        <translation>FreeCAD todavía está leyendo {document}. Inténtelo de nuevo cuando el documento esté abierto.</translation>
    </message>
    <message>
        <source>A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized.</source>
        <translation>Un ciclo de taladrado fuera del plano XY taladra a lo largo de {letter}. Esos agujeros no se reconocen.</translation>
    </message>
    <message>
        <source>A cycle with more than {most:n} repeats is read with {most:n} repeats.</source>
        <translation>Un ciclo con más de {most:n} repeticiones se lee con {most:n} repeticiones.</translation>
    </message>
    <message>
        <source>A number of turns of an arc (P) that is not usable is ignored.</source>
        <translation>Un número de vueltas de un arco (P) que no es utilizable se ignora.</translation>
    </message>
    <message>
        <source>A probing move is read as a rapid to its end. Where the probe touches is not in the program.</source>
        <translation>Un movimiento de palpado se lee como un rápido hasta su final. El programa no contiene dónde toca el palpador.</translation>
    </message>
    <message>
        <source>The feed rate of a thread ({name}) is its pitch times the spindle speed.</source>
        <translation>El avance de una rosca ({name}) es su paso por la velocidad del husillo.</translation>
    </message>
    <message>
        <source>Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor.</source>
        <translation>Los avances se leen en mm/s, porque el texto es una trayectoria de FreeCAD sin posprocesador.</translation>
    </message>
    <message>
        <source>Commas in numbers are read as decimal points.</source>
        <translation>Las comas en los números se leen como puntos decimales.</translation>
    </message>
    <message>
        <source>Text that does not consist of words like G1 X10 is ignored. The words beside it are read.</source>
        <translation>El texto que no consta de palabras como G1 X10 se ignora. Las palabras a su lado se leen.</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as short lines.</source>
        <translation>Un spline ({name}) se lee como rectas cortas.</translation>
    </message>
    <message>
        <source> A closed contour finishes the walls.</source>
        <translation> Un contorno cerrado acaba las paredes.</translation>
    </message>
    <message>
        <source>climbing at a constant radius</source>
        <translation>que ascienden con radio constante</translation>
    </message>
    <message>
        <source>only {share:%} of their length nested</source>
        <translation>solo {share:%} de su longitud anidado</translation>
    </message>
    <message>
        <source>The stock is where the other job leaves it, because the jobs have different models.</source>
        <translation>El material bruto está donde lo deja el otro trabajo, porque los trabajos tienen modelos diferentes.</translation>
    </message>
    <message>
        <source>1 move was not checked for lack of time: command {command:#} of {label}.</source>
        <translation>Por falta de tiempo no se ha comprobado 1 movimiento: comando {command:#} de {label}.</translation>
    </message>
    <message>
        <source>{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.</source>
        <translation>Por falta de tiempo no se han comprobado {count:n} movimientos; el primero es el comando {command:#} de {label}.</translation>
    </message>
    <message>
        <source>The program is read up to this line. {why}</source>
        <translation>El programa se lee hasta esta línea. {why}</translation>
    </message>
    <message>
        <source>The value of {name} comes from the machine.</source>
        <translation>El valor de {name} proviene de la máquina.</translation>
    </message>
    <message>
        <source>The value of {name} is assigned in a line that cannot be read.</source>
        <translation>El valor de {name} se asigna en una línea que no se puede leer.</translation>
    </message>
    <message>
        <source>A control stops here, because {name} has no value.</source>
        <translation>Un control se detiene aquí, porque {name} no tiene valor.</translation>
    </message>
    <message>
        <source>A control stops here, because it has no variable {name}.</source>
        <translation>Un control se detiene aquí, porque no tiene la variable {name}.</translation>
    </message>
    <message>
        <source>A control stops here, because an expression has no result, such as a division by zero.</source>
        <translation>Un control se detiene aquí, porque una expresión no tiene resultado, por ejemplo una división por cero.</translation>
    </message>
    <message>
        <source>The program stops here with an alarm (#3000).</source>
        <translation>El programa se detiene aquí con una alarma (#3000).</translation>
    </message>
    <message>
        <source>This jump, loop or call cannot be read.</source>
        <translation>Este salto, bucle o llamada no se puede leer.</translation>
    </message>
    <message>
        <source>The end of this loop, condition or subprogram is missing.</source>
        <translation>Falta el final de este bucle, condición o subprograma.</translation>
    </message>
    <message>
        <source>The program jumps to the block N{number}, which does not exist.</source>
        <translation>El programa salta al bloque N{number}, que no existe.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would run more than {count:n} lines, which is the limit.</source>
        <translation>Los bucles, saltos y llamadas ejecutarían más de {count:n} líneas, que es el límite.</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would make more than {count:n} moves, which is the limit.</source>
        <translation>Los bucles, saltos y llamadas producirían más de {count:n} movimientos, que es el límite.</translation>
    </message>
    <message>
        <source>A loop runs more than {count:n} lines without a move, which is the limit.</source>
        <translation>Un bucle ejecuta más de {count:n} líneas sin movimiento, que es el límite.</translation>
    </message>
    <message>
        <source>The program jumps back from here without end.</source>
        <translation>El programa salta hacia atrás desde aquí sin fin.</translation>
    </message>
    <message>
        <source>The expressions take more than {count:n} steps to calculate, which is the limit.</source>
        <translation>Las expresiones requieren más de {count:n} pasos de cálculo, que es el límite.</translation>
    </message>
    <message>
        <source>Calls are nested deeper than {count:n} levels, which is the limit.</source>
        <translation>Las llamadas están anidadas a más de {count:n} niveles, que es el límite.</translation>
    </message>
    <message>
        <source>A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty.</source>
        <translation>Se lee una variable que el programa no ha definido. Vale 0, o está vacía en un control Fanuc.</translation>
    </message>
    <message>
        <source>A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.</source>
        <translation>Un comando con dos códigos, como G90 y G1, se lee con los dos. Algunos posprocesadores escriben solo el primero.</translation>
    </message>
    <message>
        <source>The program has no unit and looks like inches. It is simulated in inches.</source>
        <translation>El programa no indica unidad y parece estar en pulgadas. Se simula en pulgadas.</translation>
    </message>
    <message>
        <source>No stock is given. The simulation uses a box around the cuts.</source>
        <translation>No se ha indicado material bruto. La simulación usa una caja alrededor de los cortes.</translation>
    </message>
    <message>
        <source>The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}.</source>
        <translation>El trabajo se mueve {needed:mm4} en {axis}, pero el recorrido de la máquina es {travel:mm4}.</translation>
    </message>
    <message>
        <source>The time did not suffice to check all walls for gouges narrower than {pixel:mm2}.</source>
        <translation>El tiempo no alcanzó para buscar en todas las paredes cortes en el modelo más estrechos que {pixel:mm2}.</translation>
    </message>
    <message>
        <source>The height of a move to a machine position ({name}) is not in the program. The greatest height is used.</source>
        <translation>La altura de un movimiento a una posición de la máquina ({name}) no está en el programa. Se usa la altura mayor.</translation>
    </message>
    <message>
        <source>The tool length offset changes before a move without a Z word. The height of the move is unknown.</source>
        <translation>La compensación de longitud de herramienta cambia antes de un movimiento sin palabra Z. La altura del movimiento se desconoce.</translation>
    </message>
    <message>
        <source>A clamp was not checked. {sentence}</source>
        <translation>No se ha comprobado una brida. {sentence}</translation>
    </message>
    <message>
        <source>This is a toolpath for a lathe. It is simulated like a mill&apos;s, so that the part is wrong.</source>
        <translation>Esta trayectoria es para un torno. Se simula como en una fresadora, por lo que la pieza es incorrecta.</translation>
    </message>
    <message>
        <source>The verdict of the simulation is outdated, because the job has changed. Simulate the job again.</source>
        <translation>El veredicto de la simulación está desactualizado, porque el trabajo ha cambiado. Simúlelo de nuevo.</translation>
    </message>
    <message>
        <source>No {what} was found, checked to {pixel:mm2}.</source>
        <translation>No se ha encontrado {what}, comprobado con una precisión de {pixel:mm2}.</translation>
    </message>
    <message>
        <source>Not everything could be checked: {first}</source>
        <translation>No se ha podido comprobar todo: {first}</translation>
    </message>
    <message>
        <source>Not everything could be checked, for {count:n} reasons. The first reason: {first}</source>
        <translation>No se ha podido comprobar todo, por {count:n} motivos. El primer motivo: {first}</translation>
    </message>
    <message>
        <source>{label} already begins with what this job leaves. Choose another job.</source>
        <translation>{label} ya empieza con lo que deja este trabajo. Elija otro trabajo.</translation>
    </message>
    <message>
        <source>The cuts of a pocket or circle ({name}) are ignored.</source>
        <translation>Los cortes de una cajera o de un círculo ({name}) se ignoran.</translation>
    </message>
    <message>
        <source>{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.</source>
        <translation>{label} a partir de la línea {line:#} no se simula, porque se desconoce su herramienta. Nombre la herramienta antes en un comentario, por ejemplo (T1 D=6 end mill), o indíquela a vkworkbench.simulate.</translation>
    </message>
    <message>
        <source>Nothing was checked, because no tool meets the stock. Check the stock and its position.</source>
        <translation>No se ha comprobado nada, porque ninguna herramienta toca el material bruto. Revise el material bruto y su posición.</translation>
    </message>
    <message>
        <source>{name} moves the coordinates. The origin before it is not in the program, and is read as 0.</source>
        <translation>{name} desplaza las coordenadas. El origen anterior no está en el programa y se lee como 0.</translation>
    </message>
    <message>
        <source>An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.</source>
        <translation>Una palabra F en la línea de {name} se lee en la unidad anterior, como en LinuxCNC. Algunos controles usan la unidad nueva.</translation>
    </message>
    <message>
        <source>The program has no unit (G20, G21) and is read in millimeters. It can also be in inches.</source>
        <translation>El programa no indica unidad (G20, G21) y se lee en milímetros. También puede estar en pulgadas.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths simulator</source>
        <translation>Simular trayectorias</translation>
    </message>
    <message>
        <source>This toolpath has no tool. Import its program into a job.</source>
        <translation>Esta trayectoria no puede tener herramienta. Importe su programa en un trabajo.</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.</source>
        <translation>El CycleTime de FreeCAD para este trabajo es {seconds:clock}. FreeCAD mide mal los arcos y no cuenta las aceleraciones ni las pausas.</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.</source>
        <translation>El tiempo de mecanizado no incluye {length:mm4} de rápidos, porque la operación no tiene controlador de herramienta. Elija su máquina en las preferencias, página Máquina.</translation>
    </message>
    <message>
        <source>More than the sum: the {simulator:simulator} slows down with every cut.</source>
        <translation>Más que la suma: {simulator:simulator} se ralentiza con cada corte.</translation>
    </message>
    <message>
        <source>Less than the sum: the {simulator:simulator} simulates all operations in one run.</source>
        <translation>Menos que la suma: {simulator:simulator} simula todas las operaciones en una sola pasada.</translation>
    </message>
    <message>
        <source>More than the sum: tool changes and starts of the spindle take {time:clock}.</source>
        <translation>Más que la suma: los cambios de herramienta y los arranques del husillo duran {time:clock}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} slows to about {frames:g1} frames per second at the end of this job, mostly because of arcs. Simulate fewer operations at a time.</source>
        <translation>El {simulator:simulator} baja a unas {frames:g1} imágenes por segundo al final de este trabajo, sobre todo por los arcos. Simule menos operaciones a la vez.</translation>
    </message>
    <message>
        <source>Gouges were not checked, because the job has no model with a volume.</source>
        <translation>No se han comprobado cortes en el modelo, porque el trabajo no tiene un modelo con volumen.</translation>
    </message>
    <message>
        <source>Gouges of {labels} were not checked, because the tool is simulated by a simpler shape.</source>
        <translation>No se han comprobado cortes en el modelo de {labels}, porque la herramienta se simula con una forma más simple.</translation>
    </message>
    <message>
        <source>Shank, holder and clamps were not checked.</source>
        <translation>No se han comprobado vástago, portaherramientas ni bridas.</translation>
    </message>
    <message>
        <source>Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read.</source>
        <translation>De dos códigos del mismo tipo en una línea, como G0 y G1 o G90 y G91, se lee el último.</translation>
    </message>
    <message>
        <source>After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate.</source>
        <translation>Después de G80, un movimiento sin G0 ni G1 se lee como un rápido. Algunos controles se mueven al avance.</translation>
    </message>
    <message>
        <source>Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. On Fanuc controls, they can differ by up to the diameter of the tool.</source>
        <translation>Con la compensación de radio ({name}), el primer movimiento y las esquinas exteriores se leen como en LinuxCNC. En los controles Fanuc pueden diferir hasta el diámetro de la herramienta.</translation>
    </message>
    <message>
        <source>Lines after M2, M17 or M30 are read as part of the same program.</source>
        <translation>Las líneas después de M2, M17 o M30 se leen como parte del mismo programa.</translation>
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
        <translation>Los picoteos de {name} se ignoran. Cada agujero se taladra en un solo movimiento.</translation>
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
        <translation>un sentido</translation>
    </message>
    <message>
        <source>contour-parallel</source>
        <translation>contornos paralelos</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>perfil</translation>
    </message>
    <message>
        <source>waterline</source>
        <translation>curvas de nivel</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>espiral</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>hélice</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptativa</translation>
    </message>
    <message>
        <source>drilling</source>
        <translation>taladrado</translation>
    </message>
    <message>
        <source>engraving</source>
        <translation>grabado</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixta</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocida</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>vacía</translation>
    </message>
</context>
<context>
    <name>VkMachine</name>
    <message>
        <source>grbl Settings</source>
        <translation>Ajustes de grbl</translation>
    </message>
    <message>
        <source>The lines that grbl answers to the command $$:</source>
        <translation>Las líneas con las que grbl responde al comando $$:</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Machining Times</source>
        <translation>Tiempos de mecanizado</translation>
    </message>
    <message>
        <source>The machine that machining times are planned for. The next analysis uses it.</source>
        <translation>La máquina para la que se planifican los tiempos de mecanizado. El próximo análisis la usa.</translation>
    </message>
    <message>
        <source>None: constant feed, no acceleration</source>
        <translation>Ninguna: avance constante, sin aceleración</translation>
    </message>
    <message>
        <source>Hobby router with grbl</source>
        <translation>Fresadora de aficionado con grbl</translation>
    </message>
    <message>
        <source>Small milling machine</source>
        <translation>Fresadora pequeña</translation>
    </message>
    <message>
        <source>Machining center</source>
        <translation>Centro de mecanizado</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>Valores propios</translation>
    </message>
    <message>
        <source>Speed X</source>
        <translation>Velocidad X</translation>
    </message>
    <message>
        <source>Largest speed of the X axis. Rapids use it.</source>
        <translation>Velocidad máxima del eje X. Los movimientos rápidos la usan.</translation>
    </message>
    <message>
        <source>Speed Y</source>
        <translation>Velocidad Y</translation>
    </message>
    <message>
        <source>Largest speed of the Y axis. Rapids use it.</source>
        <translation>Velocidad máxima del eje Y. Los movimientos rápidos la usan.</translation>
    </message>
    <message>
        <source>Speed Z</source>
        <translation>Velocidad Z</translation>
    </message>
    <message>
        <source>Largest speed of the Z axis. Rapids use it.</source>
        <translation>Velocidad máxima del eje Z. Los movimientos rápidos la usan.</translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation>Aceleración X</translation>
    </message>
    <message>
        <source>Acceleration of the X axis.</source>
        <translation>Aceleración del eje X.</translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation>Aceleración Y</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis.</source>
        <translation>Aceleración del eje Y.</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>Aceleración Z</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis.</source>
        <translation>Aceleración del eje Z.</translation>
    </message>
    <message>
        <source>Corner deviation</source>
        <translation>Desviación en esquinas</translation>
    </message>
    <message>
        <source>Distance from a corner at which the controller may round it: grbl&apos;s junction deviation ($11), LinuxCNC&apos;s path tolerance (G64 P). With 0, the tool stops at each corner.</source>
        <translation>Distancia de una esquina a la que el control puede redondearla: junction deviation de grbl ($11), tolerancia de trayectoria de LinuxCNC (G64 P). Con 0, la herramienta se detiene en cada esquina.</translation>
    </message>
    <message>
        <source>Moves planned ahead</source>
        <translation>Movimientos planificados por adelantado</translation>
    </message>
    <message>
        <source>Number of moves that the controller plans ahead. grbl on an Arduino plans 15.</source>
        <translation>Número de movimientos que el control planifica por adelantado. grbl en un Arduino planifica 15.</translation>
    </message>
    <message>
        <source>Measured / planned time</source>
        <translation>Tiempo medido / planificado</translation>
    </message>
    <message>
        <source>Measured time of a job divided by the time planned here. Multiplies all times.</source>
        <translation>Tiempo medido de un trabajo dividido por el tiempo planificado aquí. Multiplica todos los tiempos.</translation>
    </message>
    <message>
        <source>Fills the values from the answer of grbl to the command $$.</source>
        <translation>Rellena los valores con la respuesta de grbl al comando $$.</translation>
    </message>
    <message>
        <source>Paste grbl Settings…</source>
        <translation>Pegar ajustes de grbl…</translation>
    </message>
    <message>
        <source>Travel and Tool Holder</source>
        <translation>Recorrido y portaherramientas</translation>
    </message>
    <message>
        <source>Travel in X</source>
        <translation>Recorrido en X</translation>
    </message>
    <message>
        <source>Travel of the machine along X. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Recorrido de la máquina en X. El análisis advierte de los trabajos y programas que necesitan más. 0: desconocido.</translation>
    </message>
    <message>
        <source>Travel in Y</source>
        <translation>Recorrido en Y</translation>
    </message>
    <message>
        <source>Travel of the machine along Y. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Recorrido de la máquina en Y. El análisis advierte de los trabajos y programas que necesitan más. 0: desconocido.</translation>
    </message>
    <message>
        <source>Travel in Z</source>
        <translation>Recorrido en Z</translation>
    </message>
    <message>
        <source>Travel of the machine along Z. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>Recorrido de la máquina en Z. El análisis advierte de los trabajos y programas que necesitan más. 0: desconocido.</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>Diámetro del portaherramientas</translation>
    </message>
    <message>
        <source>Diameter of the tool holder. The simulation warns of collisions. A property HolderDiameter of a tool bit takes precedence. 0: unknown.</source>
        <translation>Diámetro del portaherramientas. La simulación advierte de colisiones. Una propiedad HolderDiameter de la herramienta tiene prioridad. 0: desconocido.</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>Longitud del portaherramientas</translation>
    </message>
    <message>
        <source>Length of the tool holder. A property HolderLength of a tool bit takes precedence. 0: the holder has no upper end.</source>
        <translation>Longitud del portaherramientas. Una propiedad HolderLength de la herramienta tiene prioridad. 0: el portaherramientas no tiene extremo superior.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Cambio de herramienta</translation>
    </message>
    <message>
        <source>Time from the end of an operation to the next operation with another tool. The time of the job includes it.</source>
        <translation>Tiempo desde el final de una operación hasta la siguiente operación con otra herramienta. El tiempo del trabajo lo incluye.</translation>
    </message>
    <message>
        <source>Start of the spindle</source>
        <translation>Arranque del husillo</translation>
    </message>
    <message>
        <source>Time until the spindle turns at its speed. The time of the job includes it for each tool.</source>
        <translation>Tiempo hasta que el husillo alcanza su velocidad. El tiempo del trabajo lo incluye para cada herramienta.</translation>
    </message>
    <message>
        <source>There is no line such as $110=3000. Paste the lines that grbl answers to the command $$.</source>
        <translation>Falta una línea como $110=3000. Pegue las líneas que grbl responde a la orden $$.</translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>Never calibrated on this computer. The times of FreeCAD&apos;s simulators are right to within a factor of 2.</source>
        <translation>Nunca calibrado en este equipo. Los tiempos de los simuladores de FreeCAD aciertan dentro de un factor 2.</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation>Marcas en el árbol</translation>
    </message>
    <message>
        <source>Show times for</source>
        <translation>Mostrar tiempos de</translation>
    </message>
    <message>
        <source>Shows the marks in the tree as colored pills. If switched off, shows them as plain text.</source>
        <translation>Muestra las marcas en el árbol como etiquetas de color. Si se desactiva, las muestra como texto sencillo.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Mostrar las marcas como etiquetas</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. With large toolpaths, each recompute takes longer.</source>
        <translation>Analiza de nuevo las operaciones marcadas tras cada recálculo que las haya cambiado. Las trayectorias largas alargan cada recálculo.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Analizar de nuevo tras un recálculo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Longest time that a simulation may take. The analysis warns of longer simulations and recommends an accuracy within this limit.</source>
        <translation>Tiempo más largo que puede durar una simulación. El análisis avisa de simulaciones más largas y recomienda una precisión dentro de este límite.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>Largest memory that a simulation may take. The analysis warns of larger simulations and recommends an accuracy within this limit.</source>
        <translation>Memoria máxima que puede ocupar una simulación. El análisis avisa de simulaciones más grandes y recomienda una precisión dentro de este límite.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Direction from which the part is viewed.</source>
        <translation>Dirección desde la que se ve la pieza.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Derecha</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Izquierda</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrica</translation>
    </message>
    <message>
        <source>Edge length of the cells, in percent of the stock&apos;s longer side. 0.1 is the finest position of the accuracy slider, 1 the coarsest.</source>
        <translation>Arista de las celdas, en tanto por ciento del lado más largo del material. 0,1 es la posición más fina del control de precisión, 1 la más gruesa.</translation>
    </message>
    <message>
        <source>Position of the quality slider. 10 is the best quality.</source>
        <translation>Posición del control de calidad. 10 es la mejor calidad.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolerancia de los arcos</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves that replace it.</source>
        <translation>Mayor distancia entre un arco y los movimientos rectos que lo sustituyen.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s default ({simulator})</source>
        <translation>El del botón de FreeCAD ({simulator})</translation>
    </message>
    <message>
        <source>{simulator}: accuracy</source>
        <translation>{simulator}: precisión</translation>
    </message>
    <message>
        <source>{simulator}: quality</source>
        <translation>{simulator}: calidad</translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. The marks change at once.</source>
        <translation>El simulador cuyo tiempo muestran las marcas. Las marcas cambian de inmediato.</translation>
    </message>
    <message>
        <source>Shows a bar above the 3D view when a simulation in one of FreeCAD&apos;s simulators would hang or take too long, and suggests a faster way.</source>
        <translation>Muestra una barra sobre la vista 3D cuando una simulación en un simulador de FreeCAD se bloquearía o tardaría demasiado, y propone un camino más rápido.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Avisar antes de iniciar una simulación que se bloquearía o tardaría demasiado</translation>
    </message>
    <message>
        <source>Last calibrated on {date}. The times of the {simulator} are right to within a factor of {factor}. Measured on {processor}, display {renderer}.</source>
        <translation>Última calibración el {date}. Los tiempos del {simulator} aciertan dentro de un factor {factor}. Medido en {processor}, pantalla {renderer}.</translation>
    </message>
    <message>
        <source>Measures how fast this computer simulates, and saves the result. This takes some seconds.</source>
        <translation>Mide la velocidad de simulación de este equipo y guarda el resultado. Esto tarda unos segundos.</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image width</source>
        <translation>Simular trayectorias: ancho de imagen</translation>
    </message>
    <message>
        <source>Width of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Ancho de la imagen para la que se estiman el tiempo y la memoria de «Simular trayectorias».</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image height</source>
        <translation>Simular trayectorias: alto de imagen</translation>
    </message>
    <message>
        <source>Height of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>Alto de la imagen para la que se estiman el tiempo y la memoria de «Simular trayectorias».</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: view</source>
        <translation>Simular trayectorias: vista</translation>
    </message>
</context>
<context>
    <name>Vk_AddMesh</name>
    <message>
        <source>Add Simulated Part as Mesh</source>
        <translation>Añadir la pieza simulada como malla</translation>
    </message>
    <message>
        <source>Simulates the job, and adds the part that it leaves to the document as a mesh.</source>
        <translation>Simula el trabajo y añade al documento la pieza que deja, como malla.</translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation>Se ha añadido {} al documento.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document. Estimates what simulating each operation costs, and marks it in the tree.</source>
        <translation>Reconoce la estrategia de mecanizado de cada operación seleccionada, o de todas las del documento activo. Estima lo que cuesta simular cada operación y la marca en el árbol.</translation>
    </message>
    <message>
        <source>Analyze Toolpaths</source>
        <translation>Analizar trayectorias</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>No hay ningún documento abierto. Abra primero uno con un trabajo o una trayectoria de herramienta.</translation>
    </message>
    <message>
        <source>The analysis was cancelled. Nothing has changed.</source>
        <translation>El análisis se ha cancelado. No ha cambiado nada.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>No hay ninguna operación que analizar en este documento. Cree un trabajo con operaciones o importe código G.</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>{count} operation was analyzed.</source>
        <translation>{count} operación analizada.</translation>
    </message>
    <message>
        <source>{count} operations were analyzed.</source>
        <translation>{count} operaciones analizadas.</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Midiendo a qué velocidad simula este ordenador…</translation>
    </message>
    <message>
        <source>Reading the operations…</source>
        <translation>Leyendo las operaciones…</translation>
    </message>
    <message>
        <source>{count} mark has a warning: see Toolpath Results (V, R).</source>
        <translation>{count} marca tiene una advertencia: vea Resultados de trayectorias (V, R).</translation>
    </message>
    <message>
        <source>{count} marks have warnings: see Toolpath Results (V, R).</source>
        <translation>{count} marcas tienen advertencias: vea Resultados de trayectorias (V, R).</translation>
    </message>
</context>
<context>
    <name>Vk_Clamps</name>
    <message>
        <source>Set Clamps from Selection</source>
        <translation>Definir las bridas a partir de la selección</translation>
    </message>
    <message>
        <source>{} has no clamps.</source>
        <translation>{} no tiene bridas.</translation>
    </message>
    <message>
        <source>Remove Clamps</source>
        <translation>Quitar las bridas</translation>
    </message>
    <message>
        <source>Clamps of {}: {}.</source>
        <translation>Bridas de {}: {}.</translation>
    </message>
    <message>
        <source>Makes the selected solids, such as clamps and vices, the clamps of the job. The simulation warns if a tool, shank or holder collides with them. If no solid is selected, the command shows the present clamps and can remove them.</source>
        <translation>Convierte los sólidos seleccionados, por ejemplo bridas y mordazas, en las bridas del trabajo. La simulación avisa si una herramienta, un vástago o un portaherramientas choca con ellas. Si no hay ningún sólido seleccionado, el comando muestra las bridas actuales y puede quitarlas.</translation>
    </message>
    <message>
        <source>To set clamps, select their solids and start this command again. If the document has several jobs, select the job, too.</source>
        <translation>Para definir bridas, seleccione sus sólidos y vuelva a iniciar este comando. Si el documento tiene varios trabajos, seleccione también el trabajo.</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document. Your own descriptions stay.</source>
        <translation>Quita las marcas de las operaciones seleccionadas, o todas las del documento activo. Sus propias descripciones se conservan.</translation>
    </message>
    <message>
        <source>Clear Analysis</source>
        <translation>Borrar el análisis</translation>
    </message>
    <message>
        <source>The marks were removed.</source>
        <translation>Las marcas se han eliminado.</translation>
    </message>
    <message>
        <source>There are no marks to remove.</source>
        <translation>No hay marcas que eliminar.</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss Map</source>
        <translation>Aplicación de Gauss</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>Guardar imagen…</translation>
    </message>
    <message>
        <source>Saves the three plots as PNG or SVG.</source>
        <translation>Guarda los tres gráficos como PNG o SVG.</translation>
    </message>
    <message>
        <source>Steps through the trajectories k of the area.</source>
        <translation>Recorre paso a paso los tramos k de la zona.</translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation>Zona {}: {} tramos, {}</translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation>Aplicación de Gauss de los últimos {} tramos hasta k.</translation>
    </message>
    <message>
        <source>Select an operation in the tree.</source>
        <translation>Seleccione una operación en el árbol.</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>sentido antihorario</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>sentido horario</translation>
    </message>
    <message>
        <source>exact reversal</source>
        <translation>inversión exacta</translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy. Shows the toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Muestra por qué la operación seleccionada tiene su estrategia. Muestra la trayectoria, la aplicación de Gauss de sus direcciones y del vector V_k, y la función angular acumulada.</translation>
    </message>
    <message>
        <source>This area: {}</source>
        <translation>Esta área: {}</translation>
    </message>
    <message>
        <source>φ between {} and {} turns, level n = {}, exact reversals: {}</source>
        <translation>φ entre {} y {} vueltas, nivel n = {}, inversiones exactas: {}</translation>
    </message>
    <message>
        <source>Reading {}…</source>
        <translation>Leyendo {}…</translation>
    </message>
    <message>
        <source>Areas that the tool cuts without a rapid move or a plunge. The area that shows the strategy best comes first, then the longest areas.</source>
        <translation>Áreas que la herramienta corta sin movimiento rápido ni entrada. Primero viene la que mejor muestra la estrategia, después las más largas.</translation>
    </message>
    <message>
        <source>&lt;p&gt;Use the wheel to zoom, drag to move, and double-click to show everything again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Use la rueda para ampliar, arrastre para desplazar y haga doble clic para mostrar todo de nuevo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: No move cuts sideways, so there is no direction to show.</source>
        <translation>{}: Ningún movimiento corta hacia los lados, así que no hay dirección que mostrar.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The left plot shows the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the first point of the area. The unit circle shows the directions of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;. Its arcs show how these directions have moved. In a zigzag, the direction of v&lt;sub&gt;k&lt;/sub&gt; moves back and forth on a part of the circle. In a contour, it moves all around the circle. The direction of V&lt;sub&gt;k&lt;/sub&gt; moves all around only if the path begins inside the contour. The right plot shows the cumulative angular function φ and the angle θ on level n, in turns. A contour-parallel path reaches the dashed lines, one turn from its start. A zigzag stays between the dashed lines, one turn from its middle.&lt;/p&gt;</source>
        <translation>&lt;p&gt;El gráfico izquierdo muestra la trayectoria de la herramienta con el vector V&lt;sub&gt;k&lt;/sub&gt; desde el primer punto de la zona. El círculo unidad muestra las direcciones del tramo v&lt;sub&gt;k&lt;/sub&gt; y de V&lt;sub&gt;k&lt;/sub&gt;. Sus arcos muestran cómo se han movido estas direcciones. En un zigzag, la dirección de v&lt;sub&gt;k&lt;/sub&gt; va y viene por una parte del círculo. En un contorno, da la vuelta entera. La dirección de V&lt;sub&gt;k&lt;/sub&gt; solo da la vuelta entera si la trayectoria empieza dentro del contorno. El gráfico derecho muestra la función angular acumulada φ y el ángulo θ en el nivel n, en vueltas. Una trayectoria de contornos paralelos alcanza las líneas discontinuas, a una vuelta de su inicio. Un zigzag queda entre las líneas discontinuas, a una vuelta de su centro.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>with the closing turn {}, n = {}</source>
        <translation>con el giro de cierre {}, n = {}</translation>
    </message>
    <message>
        <source>φ = {} turns</source>
        <translation>φ = {} vueltas</translation>
    </message>
</context>
<context>
    <name>Vk_Jobs</name>
    <message>
        <source>The document has no job.</source>
        <translation>El documento no tiene ningún trabajo.</translation>
    </message>
    <message>
        <source>Choose the job:</source>
        <translation>Elija el trabajo:</translation>
    </message>
    <message>
        <source>Simulating {}…</source>
        <translation>Simulando {}…</translation>
    </message>
    <message>
        <source>The simulation was cancelled. Nothing has changed.</source>
        <translation>La simulación se ha cancelado. Nada ha cambiado.</translation>
    </message>
</context>
<context>
    <name>Vk_PreviousJob</name>
    <message>
        <source>Begin with the Part of Another Job</source>
        <translation>Empezar con la pieza de otro trabajo</translation>
    </message>
    <message>
        <source>Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. The part is moved and turned with the model.</source>
        <translation>Hace que la simulación del trabajo empiece con la pieza que deja otro trabajo, como para la segunda cara de una pieza. La pieza se mueve y se gira con el modelo.</translation>
    </message>
    <message>
        <source>No other job of this document machines the part of {}.</source>
        <translation>Ningún otro trabajo de este documento mecaniza la pieza de {}.</translation>
    </message>
    <message>
        <source>The simulation of {} begins with:</source>
        <translation>La simulación de {} empieza con:</translation>
    </message>
    <message>
        <source>The stock of {}</source>
        <translation>El material bruto de {}</translation>
    </message>
    <message>
        <source>{} begins with its own stock.</source>
        <translation>{} empieza con su propio material bruto.</translation>
    </message>
    <message>
        <source>{} begins with the part that {} leaves.</source>
        <translation>{} empieza con la pieza que deja {}.</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath Results</source>
        <translation>Resultados de trayectorias</translation>
    </message>
    <message>
        <source>Nothing is analyzed in this document yet. Click Analyze Toolpaths.</source>
        <translation>Todavía no se ha analizado nada en este documento. Haga clic en «Analizar trayectorias».</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>Exportar CSV</translation>
    </message>
    <message>
        <source>Export JSON</source>
        <translation>Exportar JSON</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Estrategia</translation>
    </message>
    <message>
        <source>The machining strategy, recognized from the toolpath alone.</source>
        <translation>La estrategia de mecanizado, reconocida solo por la trayectoria.</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Confianza</translation>
    </message>
    <message>
        <source>The confidence of the recognition.</source>
        <translation>La confianza del reconocimiento.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>Longitud de los movimientos de corte.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s OpenGL simulator at its highest speed.</source>
        <extracomment>FreeCAD&apos;s newer simulator, which draws the cuts of all earlier operations with every operation.</extracomment>
        <translation>Tiempo del simulador OpenGL de FreeCAD a su mayor velocidad.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator.</source>
        <translation>Memoria del simulador OpenGL de FreeCAD.</translation>
    </message>
    <message>
        <source>Problems of the operation, and what goes wrong when you simulate it.</source>
        <translation>Los problemas de la operación y lo que falla al simularla.</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences.</source>
        <extracomment>FreeCAD&apos;s older simulator.</extracomment>
        <translation>Tiempo del simulador antiguo de FreeCAD en avance rápido, con la precisión de las preferencias.</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences.</source>
        <translation>Memoria del simulador antiguo de FreeCAD, con la precisión de las preferencias.</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Imagen recomendada: {}</translation>
    </message>
    <message>
        <source>Recommended
Image</source>
        <translation>Imagen
recomendada</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Machining
Time</source>
        <translation>Tiempo de
mecanizado</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>Exportar &amp;CSV…</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>Exportar &amp;JSON…</translation>
    </message>
    <message>
        <source>C&amp;opy to Clipboard</source>
        <translation>C&amp;opiar al portapapeles</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportar</translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
        <translation>Col&amp;umnas</translation>
    </message>
    <message>
        <source>Sort as &amp;Posted</source>
        <translation>Ordenar como se &amp;emite</translation>
    </message>
    <message>
        <source>Select an operation to read what it does and why.</source>
        <translation>Seleccione una operación para leer qué hace y por qué.</translation>
    </message>
    <message>
        <source>Selection in {job}</source>
        <translation>Selección en {job}</translation>
    </message>
    <message>
        <source>Simulation
Time</source>
        <translation>Tiempo de
simulación</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>A result is outdated if the toolpath, the tool or the stock has changed since. Analyze the operation again.</source>
        <translation>Un resultado está desactualizado si la trayectoria, la herramienta o el material ha cambiado desde entonces. Analice la operación de nuevo.</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>desactualizado</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Advertencias</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Movimientos</translation>
    </message>
    <message>
        <source>Number of straight moves. An arc counts as several.</source>
        <translation>Número de movimientos rectos. Un arco cuenta como varios.</translation>
    </message>
    <message>
        <source>{simulator}
Time</source>
        <translation>{simulator}:
tiempo</translation>
    </message>
    <message>
        <source>{simulator}
Memory</source>
        <translation>{simulator}:
memoria</translation>
    </message>
    <message>
        <source>Shows the analyzed operations with their strategies, machining times, simulation times and warnings.</source>
        <translation>Muestra las operaciones analizadas con sus estrategias, tiempos de mecanizado, tiempos de simulación y advertencias.</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>Este resultado está desactualizado, porque la trayectoria, la herramienta o el material ha cambiado. Analice la operación de nuevo.</translation>
    </message>
    <message>
        <source>All Numbers</source>
        <translation>Todos los números</translation>
    </message>
    <message>
        <source>Fewer Numbers</source>
        <translation>Menos números</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>Confidence: {share}</source>
        <translation>Confianza: {share}</translation>
    </message>
    <message>
        <source>Show in the Gauss Map</source>
        <translation>Mostrar en la aplicación de Gauss</translation>
    </message>
    <message>
        <source>Cutting Length</source>
        <translation>Longitud de corte</translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation>Longitud en rápido</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrar</translation>
    </message>
    <message>
        <source>Shows operations that contain this text in their name, strategy or warnings.</source>
        <translation>Muestra las operaciones que contienen este texto en su nombre, estrategia o advertencias.</translation>
    </message>
    <message>
        <source>Shows operations with this strategy.</source>
        <translation>Muestra las operaciones con esta estrategia.</translation>
    </message>
    <message>
        <source>&amp;Warnings Only</source>
        <translation>Solo &amp;advertencias</translation>
    </message>
    <message>
        <source>Shows operations that have warnings or are outdated.</source>
        <translation>Muestra las operaciones que tienen advertencias o están desactualizadas.</translation>
    </message>
    <message>
        <source>All Strategies</source>
        <translation>Todas las estrategias</translation>
    </message>
    <message>
        <source>{count} of {all} operations</source>
        <translation>{count} de {all} operaciones</translation>
    </message>
    <message>
        <source>{count} operation</source>
        <translation>{count} operación</translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation>{count} operaciones</translation>
    </message>
    <message>
        <source>This total covers the analyzed operations only.</source>
        <translation>Este total incluye solo las operaciones analizadas.</translation>
    </message>
    <message>
        <source>Time in the {simulator}, as the marks show it.</source>
        <translation>Tiempo en el {simulator}, como lo muestran las marcas.</translation>
    </message>
    <message>
        <source>Longest time that the {simulator} is expected to take. It is the estimate, multiplied by the factor to within which estimates are right.</source>
        <translation>Tiempo más largo que cabe esperar en el {simulator}. Es la estimación, multiplicada por el factor dentro del cual aciertan las estimaciones.</translation>
    </message>
    <message>
        <source>Simulation Time
at Most</source>
        <translation>Tiempo de simulación
como mucho</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because its dress-up is.</source>
        <translation>Esta operación no está incluida en el total, porque su aderezo lo está.</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because it is switched off.</source>
        <translation>Esta operación no está incluida en el total, porque está desactivada.</translation>
    </message>
    <message>
        <source>Shortest Move at Feed</source>
        <translation>Movimiento más corto en avance de trabajo</translation>
    </message>
    <message>
        <source>Median Move at Feed</source>
        <translation>Movimiento mediano en avance de trabajo</translation>
    </message>
    <message>
        <source>No operation matches the filter.</source>
        <translation>Ninguna operación coincide con el filtro.</translation>
    </message>
    <message>
        <source>Time on the machine of the preferences. Without a machine: at constant feeds, and with rapids if the tool controller has rapid speeds.</source>
        <translation>Tiempo en la máquina de las preferencias. Sin máquina: con avance constante, y con movimientos rápidos si el controlador de herramienta tiene velocidades rápidas.</translation>
    </message>
    <message>
        <source>In Plain Words</source>
        <translation>En palabras sencillas</translation>
    </message>
    <message>
        <source>The toolpath in one sentence: the reason for the strategy.</source>
        <translation>La trayectoria en una frase: la razón de la estrategia.</translation>
    </message>
    <message>
        <source>At constant feed. Choose your machine in the preferences, page Machine.</source>
        <translation>Con avance constante. Elija su máquina en las preferencias, página Máquina.</translation>
    </message>
    <message>
        <source>Enter the Measured Time…</source>
        <translation>Introducir el tiempo medido…</translation>
    </message>
    <message>
        <source>Measured Time</source>
        <translation>Tiempo medido</translation>
    </message>
    <message>
        <source>Time that {label} took on the machine, in minutes and seconds, such as 17:30:</source>
        <translation>Tiempo que {label} tardó en la máquina, en minutos y segundos, por ejemplo 17:30:</translation>
    </message>
    <message>
        <source>This is not a possible time. Enter it like 17:30 or 1:02:30.</source>
        <translation>Este tiempo no es posible. Introdúzcalo como 17:30 o 1:02:30.</translation>
    </message>
    <message>
        <source>Time that Simulate Toolpaths takes. An operation is simulated alone, on the whole stock. In a job, each operation cuts the stock that is left.</source>
        <extracomment>Attributes of `Rings` whose shares of the section&apos;s length are measures.</extracomment>
        <translation>Tiempo de «Simular trayectorias». Una operación se simula sola, sobre el material entero. En un trabajo, cada operación corta el material que queda.</translation>
    </message>
    <message>
        <source>Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.</source>
        <translation>Memoria de «Simular trayectorias». Una operación incluye el material entero. Un trabajo incluye el material una sola vez.</translation>
    </message>
    <message>
        <source>The finest image of Simulate Toolpaths within your limits of time and memory.</source>
        <translation>La imagen más fina de «Simular trayectorias» dentro de sus límites de tiempo y memoria.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>Remarks that need no action, such as problems of a simulator that the marks do not show.</source>
        <translation>Notas que no requieren nada, como los problemas de un simulador que las marcas no muestran.</translation>
    </message>
    <message>
        <source>Jobs and Operations</source>
        <translation>Trabajos y operaciones</translation>
    </message>
    <message>
        <source>Details of the Selected Operation</source>
        <translation>Detalles de la operación seleccionada</translation>
    </message>
</context>
<context>
    <name>Vk_SaveStl</name>
    <message>
        <source>Save Simulated Part as STL</source>
        <translation>Guardar la pieza simulada como STL</translation>
    </message>
    <message>
        <source>Simulates the job, and saves the part that it leaves as an STL file.</source>
        <translation>Simula el trabajo y guarda la pieza que deja como archivo STL.</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>No se puede escribir {}: {}</translation>
    </message>
    <message>
        <source>The part is saved in {}.</source>
        <translation>La pieza se ha guardado en {}.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>Raw Stock</source>
        <translation>Material en bruto</translation>
    </message>
    <message>
        <source>Machined</source>
        <translation>Mecanizado</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Estrategia</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation>Caudal de viruta</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document. Shows the part at any moment, the operation that made each surface, and rapid moves that cut.</source>
        <translation>Simula el trabajo o las operaciones seleccionadas, o el trabajo del documento activo. Muestra la pieza en cualquier momento, la operación que hizo cada superficie y los movimientos rápidos que cortan.</translation>
    </message>
    <message>
        <source>Simulate Toolpaths</source>
        <translation>Simular trayectorias</translation>
    </message>
    <message>
        <source>Simulation: {}</source>
        <translation>Simulación: {}</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation>Carpeta para las imágenes</translation>
    </message>
    <message>
        <source>Save Removal Rates</source>
        <translation>Guardar caudales de viruta</translation>
    </message>
    <message>
        <source>{} cannot be written.</source>
        <translation>No se puede escribir {}.</translation>
    </message>
    <message>
        <source>Simulated Part</source>
        <translation>Pieza simulada</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrica</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Desde arriba</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>De frente</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Desde la derecha</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Desde atrás</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Desde la izquierda</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Desde abajo</translation>
    </message>
    <message>
        <source>As in the 3D View</source>
        <translation>Como la vista 3D</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Property that colors the surfaces.</source>
        <translation>Propiedad según la que se colorean las superficies.</translation>
    </message>
    <message>
        <source>Shows the part, the material that the current operation removes, or both.</source>
        <translation>Muestra la pieza, el material que quita la operación actual o ambos.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pieza</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>Viruta</translation>
    </message>
    <message>
        <source>Part and Chips</source>
        <translation>Pieza y viruta</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Imagen…</translation>
    </message>
    <message>
        <source>Pictures of the Whole Job…</source>
        <translation>Imágenes de todo el trabajo…</translation>
    </message>
    <message>
        <source>Removal Rates…</source>
        <translation>Caudales de viruta…</translation>
    </message>
    <message>
        <source>Plays or pauses the simulation (Space).</source>
        <translation>Reproduce o pausa la simulación (Espacio).</translation>
    </message>
    <message>
        <source>Speed of the playback, compared with the machine.</source>
        <translation>Velocidad de la reproducción, comparada con la máquina.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Trabajo en {}</translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation>Tiempo real</translation>
    </message>
    <message>
        <source>Go to the beginning of the operation.</source>
        <translation>Ir al comienzo de la operación.</translation>
    </message>
    <message>
        <source>Go back by one command of the program.</source>
        <translation>Retroceder una orden del programa.</translation>
    </message>
    <message>
        <source>Go back by one trajectory.</source>
        <translation>Retroceder un movimiento.</translation>
    </message>
    <message>
        <source>Go forward by one trajectory.</source>
        <translation>Avanzar un movimiento.</translation>
    </message>
    <message>
        <source>Go forward by one command of the program.</source>
        <translation>Avanzar una orden del programa.</translation>
    </message>
    <message>
        <source>Go to the end of the operation.</source>
        <translation>Ir al final de la operación.</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>unos {}</translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation>Simulando… {}</translation>
    </message>
    <message>
        <source>The finest picture takes about {} and {}.</source>
        <translation>La imagen más fina ocupa unos {} y {}.</translation>
    </message>
    <message>
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation>{} × {} píxeles de {}, {} trazas, {}, simulado en {}</translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation>{} de {}   {}, orden {}: {}</translation>
    </message>
    <message>
        <source>This is uncut stock.</source>
        <translation>Esto es material sin mecanizar.</translation>
    </message>
    <message>
        <source>Time Line</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>Leyendo {} ({} de {})…</translation>
    </message>
    <message>
        <source>There is no closed model.</source>
        <translation>No hay un modelo cerrado.</translation>
    </message>
    <message>
        <source>Gouged, {} to {}</source>
        <translation>Demasiado hondo, {} a {}</translation>
    </message>
    <message>
        <source>Stock Left, {} to {}</source>
        <translation>Material restante, {} a {}</translation>
    </message>
    <message>
        <source>As the Model</source>
        <translation>Como el modelo</translation>
    </message>
    <message>
        <source>No Model</source>
        <translation>Sin modelo</translation>
    </message>
    <message>
        <source>Difference to the Model</source>
        <translation>Diferencia con el modelo</translation>
    </message>
    <message>
        <source>Differences from the model below this value are ignored.</source>
        <translation>Las diferencias con el modelo por debajo de este valor se ignoran.</translation>
    </message>
    <message>
        <source>Worst Places</source>
        <translation>Peores lugares</translation>
    </message>
    <message>
        <source>Places where the part differs most from the model. Choose a place to see it.</source>
        <translation>Lugares donde la pieza difiere más del modelo. Elija un lugar para verlo.</translation>
    </message>
    <message>
        <source>Collisions, gouges and fast plunges in the simulation. Choose one to see it.</source>
        <translation>Choques, cortes demasiado hondos y entradas demasiado rápidas de la simulación. Elija una para verla.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Avisos: {}</translation>
    </message>
    <message>
        <source>Stock: {}</source>
        <translation>Material en bruto: {}</translation>
    </message>
    <message>
        <source>{}, command {} ({}): {}</source>
        <translation>{}, orden {} ({}): {}</translation>
    </message>
    <message>
        <source>Removed: {}</source>
        <translation>Quitado: {}</translation>
    </message>
    <message>
        <source>Nothing removed</source>
        <translation>Nada quitado</translation>
    </message>
    <message>
        <source>The model is shown with the finest picture.</source>
        <translation>El modelo se muestra con la imagen más fina.</translation>
    </message>
    <message>
        <source>The pictures are saved when the finest picture is ready…</source>
        <translation>Las imágenes se guardan cuando la imagen más fina está lista…</translation>
    </message>
    <message>
        <source>{} of {} pictures are saved in {}.</source>
        <translation>{} de {} imágenes están guardadas en {}.</translation>
    </message>
    <message>
        <source>{} pictures</source>
        <translation>{} imágenes</translation>
    </message>
    <message>
        <source>{} (X {} Y {} Z {} {})</source>
        <translation>{} (X {} Y {} Z {} {})</translation>
    </message>
    <message>
        <source>The simulated job has changed. Simulate it again.</source>
        <translation>El trabajo simulado ha cambiado. Simúlelo de nuevo.</translation>
    </message>
    <message>
        <source>Choose the job to simulate:</source>
        <translation>Elija el trabajo que desea simular:</translation>
    </message>
    <message>
        <source>Checking… {}</source>
        <translation>Comprobando… {}</translation>
    </message>
    <message>
        <source>Gray: removal rate. Orange: cuts air. Triangles: warnings.</source>
        <translation>Gris: caudal de viruta. Naranja: corte en el aire. Triángulos: avisos.</translation>
    </message>
    <message>
        <source>Direction of the view, path of the tool, section, and measuring.</source>
        <translation>Dirección de la vista, trayectoria de la herramienta, sección y medición.</translation>
    </message>
    <message>
        <source>Path of the Tool</source>
        <translation>Trayectoria de la herramienta</translation>
    </message>
    <message>
        <source>Shows the path of the operation: blue is done, pink to come.</source>
        <translation>Muestra la trayectoria de la operación: azul, lo hecho; rosa, lo pendiente.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Two clicks on the part show their distance. Esc ends it.</source>
        <translation>Dos clics en la pieza muestran su distancia. Esc termina la medición.</translation>
    </message>
    <message>
        <source>Section in {}</source>
        <translation>Sección en {}</translation>
    </message>
    <message>
        <source>No Section</source>
        <translation>Sin sección</translation>
    </message>
    <message>
        <source>Moves the section through the stock.</source>
        <translation>Mueve la sección por el material en bruto.</translation>
    </message>
    <message>
        <source>Depth below the stock&apos;s top: {}</source>
        <translation>Profundidad bajo la cara superior del material en bruto: {}</translation>
    </message>
    <message>
        <source>Measuring: click on the first point.</source>
        <translation>Medición: haga clic en el primer punto.</translation>
    </message>
    <message>
        <source>Click on the second point.</source>
        <translation>Haga clic en el segundo punto.</translation>
    </message>
    <message>
        <source>Distance: {}   ΔX {}   ΔY {}   ΔZ {}</source>
        <translation>Distancia: {}   ΔX {}   ΔY {}   ΔZ {}</translation>
    </message>
    <message>
        <source>This is the section.</source>
        <translation>Esta es la superficie de corte.</translation>
    </message>
    <message>
        <source>Saves pictures, the shown part as a solid, or removal rates.</source>
        <translation>Guarda imágenes, la pieza mostrada como sólido o caudales de viruta.</translation>
    </message>
    <message>
        <source>Shown Part as STL…</source>
        <translation>Pieza mostrada como STL…</translation>
    </message>
    <message>
        <source>Shown Part as Mesh in the Document</source>
        <translation>Pieza mostrada como malla en el documento</translation>
    </message>
    <message>
        <source>This is available when the finest picture is ready.</source>
        <translation>Disponible cuando la imagen más fina esté lista.</translation>
    </message>
    <message>
        <source>Save Part as STL</source>
        <translation>Guardar pieza como STL</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, and rapid moves gray. The document is not changed.</source>
        <translation>Colorea las trayectorias en la vista 3D según su estrategia de mecanizado, los movimientos rápidos en gris. El documento no cambia.</translation>
    </message>
    <message>
        <source>Show Strategies</source>
        <translation>Mostrar estrategias</translation>
    </message>
    <message>
        <source>Rapid Moves</source>
        <translation>Movimientos rápidos</translation>
    </message>
    <message>
        <source>Drawing strategies, operations left: {}</source>
        <translation>Dibujando estrategias, operaciones pendientes: {}</translation>
    </message>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation>No hay ninguna trayectoria que colorear en este documento. Cree un trabajo con operaciones o importe código G.</translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates the cost of their simulation.</source>
        <translation>Reconoce las estrategias de mecanizado de las trayectorias y estima lo que cuesta simularlas.</translation>
    </message>
</context>
</TS>
