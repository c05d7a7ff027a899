<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognized from the toolpath</source>
        <translation>Estrategia de mecanizado reconocida en la trayectoria de la herramienta</translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation>Por qué esta estrategia</translation>
    </message>
    <message>
        <source>What the mark in the description says</source>
        <extracomment>The results of this session.</extracomment>
        <translation>Lo que dice la marca en la descripción</translation>
    </message>
    <message>
        <source>How sure the recognition is, in percent</source>
        <translation>Seguridad del reconocimiento, en tanto por ciento</translation>
    </message>
    <message>
        <source>What is wrong with the operation, unknown about it, or to be known before simulating it</source>
        <translation>Lo que está mal o se desconoce de la operación, o que hay que saber antes de simularla</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Longitud de los movimientos de corte</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>Tiempo en la máquina</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows</source>
        <translation>Tiempo estimado de la simulación que muestra la marca</translation>
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
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Anticuado: la trayectoria, la herramienta o el material han cambiado desde entonces. Analícela de nuevo.</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known: analyze it again.</source>
        <translation>El tiempo en el {simulator} no se conoce: analícelo de nuevo.</translation>
    </message>
    <message>
        <source>{strategy}, {share} sure</source>
        <translation>{strategy}, seguro al {share}</translation>
    </message>
    <message>
        <source>On the machine: {length} of cutting</source>
        <translation>En la máquina: {length} de corte</translation>
    </message>
    <message>
        <source>On the machine: {time}, {length} of cutting</source>
        <translation>En la máquina: {time}, {length} de corte</translation>
    </message>
    <message>
        <source>On the machine: at least {time}, {length} of cutting</source>
        <translation>En la máquina: al menos {time}, {length} de corte</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: {time}, {memory}</source>
        <translation>Simulación en el {simulator}: {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: at least {time}, {memory}</source>
        <translation>Simulación en el {simulator}: al menos {time}, {memory}</translation>
    </message>
    <message>
        <source>Simulating it alone in the {simulator}: {time}, {memory}</source>
        <translation>Simulación por sí sola en el {simulator}: {time}, {memory}</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivada</translation>
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
        <source>nothing cuts: there are only rapid moves</source>
        <translation>nada corta: solo hay movimientos rápidos</translation>
    </message>
    <message>
        <source>nothing cuts: there are no moves</source>
        <translation>nada corta: no hay movimientos</translation>
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
        <source>the sense of nested loops alternates</source>
        <translation>el sentido de los lazos anidados se alterna</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>espaciados por igual en el plano, no en profundidad</translation>
    </message>
    <message>
        <source>whose shape changes with the depth</source>
        <translation>cuya forma cambia con la profundidad</translation>
    </message>
    <message>
        <source>a winding with a helical entry or bites out of the corners</source>
        <translation>un devanado con entrada helicoidal o bocados en las esquinas</translation>
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
        <source>small loops move along</source>
        <translation>lazos pequeños que avanzan</translation>
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
        <source>an open contour comes again</source>
        <translation>un contorno abierto se repite</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>trazos abiertos tan largos como la pieza</translation>
    </message>
    <message>
        <source>short strokes that fill nothing</source>
        <translation>trazos cortos que no rellenan nada</translation>
    </message>
    <message>
        <source>no cutting move in its toolpath</source>
        <translation>ningún movimiento de corte en su trayectoria</translation>
    </message>
    <message>
        <source>no toolpath: recompute the operation and see FreeCAD&apos;s report view</source>
        <translation>sin trayectoria: recalcule la operación y mire la vista de informe de FreeCAD</translation>
    </message>
    <message>
        <source>no tool: give the operation a tool controller</source>
        <translation>sin herramienta: asigne a la operación un controlador de herramienta</translation>
    </message>
    <message>
        <source>no tool in {label}: choose a tool bit for it</source>
        <translation>sin herramienta en {label}: elija una para él</translation>
    </message>
    <message>
        <source>the tool in {label} has no diameter</source>
        <translation>la herramienta de {label} no tiene diámetro</translation>
    </message>
    <message>
        <source>no stock: put the toolpath into a job</source>
        <translation>sin material: ponga la trayectoria en un trabajo</translation>
    </message>
    <message>
        <source>no stock: give {label} a stock</source>
        <translation>sin material: asigne un material a {label}</translation>
    </message>
    <message>
        <source>cost unknown for {labels}</source>
        <translation>coste desconocido de {labels}</translation>
    </message>
    <message>
        <source>words without a motion before them are ignored</source>
        <translation>palabras sin movimiento previo ignoradas</translation>
    </message>
    <message>
        <source>a feed rate that is not a usable number is ignored</source>
        <translation>avance que no es un número utilizable ignorado</translation>
    </message>
    <message>
        <source>center words (I, J, K) that are not usable numbers are ignored</source>
        <translation>palabra de centro (I, J, K) que no es un número utilizable ignorada</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored</source>
        <translation>palabra {letter} que no es un número utilizable ignorada</translation>
    </message>
    <message>
        <source>positions beyond a kilometer are cut off there</source>
        <translation>posición más allá de un kilómetro recortada allí</translation>
    </message>
    <message>
        <source>a drilling cycle without a depth (Z) drills nothing</source>
        <translation>ciclo de taladrado sin profundidad (Z): ningún agujero</translation>
    </message>
    <message>
        <source>a drilling cycle without R starts at the current height</source>
        <translation>ciclo de taladrado sin R: empieza donde está</translation>
    </message>
    <message>
        <source>a drilling cycle outside the XY plane is read as one in XY</source>
        <translation>ciclo de taladrado fuera del plano XY leído como en XY</translation>
    </message>
    <message>
        <source>an arc whose start is not known is ignored</source>
        <translation>arco cuyo comienzo aún no se conoce ignorado</translation>
    </message>
    <message>
        <source>an arc without a usable center or radius is read as a line</source>
        <translation>arco sin centro ni radio utilizables leído como recta</translation>
    </message>
    <message>
        <source>an arc whose end is not on its circle is read with a changing radius</source>
        <translation>arco cuyo final no está en su círculo leído con radio variable</translation>
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
        <source>leave this operation out of the simulation</source>
        <translation>deje esta operación fuera de la simulación</translation>
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
        <source>move its accuracy slider to the left</source>
        <translation>mueva su control de precisión a la izquierda</translation>
    </message>
    <message>
        <source>simulate fewer operations at a time</source>
        <translation>simule menos operaciones a la vez</translation>
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
        <source>no resolution helps, not even a single pixel fits</source>
        <translation>ninguna resolución ayuda, ni un solo píxel cabe</translation>
    </message>
    <message>
        <source>the cost is that of a box around its cuts</source>
        <translation>el coste es el de un bloque alrededor de sus cortes</translation>
    </message>
    <message>
        <source>it does not touch the stock: check its depths, its placement and the stock</source>
        <translation>no toca el material en bruto: compruebe sus profundidades, su ubicación y el bruto</translation>
    </message>
    <message>
        <source>its tool is wider than the stock: check the tool&apos;s diameter and the stock</source>
        <translation>su herramienta es más ancha que el material en bruto: compruebe el diámetro y el bruto</translation>
    </message>
    <message>
        <source>choose a smaller image in the preferences</source>
        <translation>elija una imagen más pequeña en las preferencias</translation>
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
        <source>the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}</source>
        <translation>el radio de esquina debe estar entre 0 y {radius:mm}, no ser {corner:mm}</translation>
    </message>
    <message>
        <source>the tip angle must lie between 0 and pi, not be {angle:g}</source>
        <translation>el ángulo de punta debe estar entre 0 y π, no ser {angle:g}</translation>
    </message>
    <message>
        <source>the stock has no volume: its upper corner must exceed its lower corner in x, y and z</source>
        <translation>el material no tiene volumen: su esquina superior debe superar a la inferior en x, y y z</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} move without a feed rate are not in the time</source>
        <translation>{length:mm4} de corte en {count:n} movimiento sin avance no están en el tiempo</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time</source>
        <translation>{length:mm4} de corte en {count:n} movimientos sin avance no están en el tiempo</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} is 0</source>
        <translation>{length:mm4} de rápidos no están en el tiempo porque {name} del controlador de herramienta es 0</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} and {other} are 0</source>
        <translation>{length:mm4} de rápidos no están en el tiempo porque {name} y {other} del controlador de herramienta son 0</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation> y {count:n} más</translation>
    </message>
    <message>
        <source>; passes {step:mm3} apart ask for {cell:mm2}</source>
        <translation>; pasadas a {step:mm3} piden {cell:mm2}</translation>
    </message>
    <message>
        <source>; {cell:mm2} would do for passes {step:mm3} apart</source>
        <translation>; {cell:mm2} bastarían para pasadas a {step:mm3}</translation>
    </message>
    <message>
        <source>no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}</source>
        <translation>ninguna resolución basta, solo las trayectorias tardan {time:s}: simule menos operaciones{heaviest}</translation>
    </message>
    <message>
        <source>; the heaviest is {label} with {time:s}</source>
        <translation>; la más pesada es {label} con {time:s}</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation> y 1 más</translation>
    </message>
    <message>
        <source>{sentence} (command {command:#})</source>
        <translation>{sentence} (orden {command:#})</translation>
    </message>
    <message>
        <source>{sentence} ({count:n} times, first at command {command:#})</source>
        <translation>{sentence} ({count:n} veces, primero en la orden {command:#})</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored</source>
        <translation>código desconocido {name} ignorado</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored</source>
        <translation>otro código desconocido ignorado</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored</source>
        <translation>otros {count:n} códigos desconocidos ignorados</translation>
    </message>
    <message>
        <source>the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance</source>
        <translation>los arcos y ciclos necesitarían {moves:n} movimientos con una tolerancia de {tolerance:mm}; use una tolerancia mayor</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}: {sentence}</translation>
    </message>
    <message>
        <source>could not be analyzed, please report it with the file: {error}</source>
        <translation>no se pudo analizar, por favor infórmelo con el archivo: {error}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en {count:n} filas{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene en 0 en {count:n} filas{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en un trazo abierto{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene entre {low:turns} y {high:turns} vueltas en {count:n} trazos abiertos{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene en 0 en un trazo abierto{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ se mantiene en 0 en {count:n} trazos abiertos{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ alcanza {reached:turns} vueltas en un lazo{spread}, {seen}: {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ alcanza {reached:turns} vueltas en {count:n} lazos{spread}, {seen}: {strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}</source>
        <translation>φ está entre {low:turns} y {high:turns} vueltas, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}</source>
        <translation>φ no tiene dirección, los movimientos son verticales en un punto: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}</source>
        <translation>φ no tiene dirección, los movimientos son verticales en {count:n} puntos: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}</source>
        <translation>φ no tiene dirección, los movimientos son verticales en algunos puntos: {strategy:strategy}</translation>
    </message>
    <message>
        <source>{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: {strategy:strategy}</source>
        <translation>{count:n} secciones separadas por cambios de herramienta, títulos, retiradas o taladros muestran {strategies:strategy}: {strategy:strategy}</translation>
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
        <source>{count:n} bites of one sense overlap</source>
        <translation>{count:n} bocados de un mismo sentido se solapan</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) share the area</source>
        <translation>filas ({rows:%} de la longitud) y lazos ({loops:%}) se reparten la superficie</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} a {high}</translation>
    </message>
    <message>
        <source>{what} (line {line:#})</source>
        <translation>{what} (línea {line:#})</translation>
    </message>
    <message>
        <source>{what} ({count:n} times, first in line {line:#})</source>
        <translation>{what} ({count:n} veces, la primera en la línea {line:#})</translation>
    </message>
    <message>
        <source>lines with a block delete (/) are read like the others</source>
        <translation>las líneas con salto de bloque (/) se leen como las demás</translation>
    </message>
    <message>
        <source>a subprogram or macro call is not read</source>
        <translation>un subprograma o una llamada a macro no se lee</translation>
    </message>
    <message>
        <source>jumps, loops and calls are not followed</source>
        <translation>no se siguen saltos, bucles ni llamadas</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the words with them are left out</source>
        <translation>las variables y expresiones no se leen: se omiten las palabras que las contienen</translation>
    </message>
    <message>
        <source>lines that are not made of words like G1 X10 are left out</source>
        <translation>se omiten las líneas que no constan de palabras como G1 X10</translation>
    </message>
    <message>
        <source>coordinates that {name} changes are read as if it were not there</source>
        <translation>las coordenadas que {name} cambia se leen como si no estuviera</translation>
    </message>
    <message>
        <source>a spline ({name}) is read as a line</source>
        <translation>un spline ({name}) se lee como una recta</translation>
    </message>
    <message>
        <source>what follows M2 or M30 is read as the same program</source>
        <translation>lo que sigue a M2 o M30 se lee como el mismo programa</translation>
    </message>
    <message>
        <source>what follows the program&apos;s end is not read</source>
        <translation>lo que sigue al final del programa no se lee</translation>
    </message>
    <message>
        <source>a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read</source>
        <translation>un programa en el lenguaje de los controles {name} (línea {line:#}): emítalo como código G (ISO) para que se lea</translation>
    </message>
    <message>
        <source>not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}</source>
        <translation>no es un programa CN: {part:n} de sus {lines:n} líneas no constan de palabras como G1 X10, la primera es la línea {line:#}</translation>
    </message>
    <message>
        <source>not an NC program: no line of it moves a tool</source>
        <translation>no es un programa CN: ninguna línea mueve una herramienta</translation>
    </message>
    <message>
        <source>none of its moves can be read: {problems}</source>
        <translation>no se puede leer ninguno de sus movimientos: {problems}</translation>
    </message>
    <message>
        <source>not an NC program: it is not text</source>
        <translation>no es un programa CN: no es un texto</translation>
    </message>
    <message>
        <source>a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programa para un torno ({name}, línea {line:#}): las estrategias de fresado no dicen nada de él</translation>
    </message>
    <message>
        <source>a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programa para una impresora 3D ({name}, línea {line:#}): las estrategias de fresado no dicen nada de él</translation>
    </message>
    <message>
        <source>a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>un programa para una cortadora de hilo ({name}, línea {line:#}): las estrategias de fresado no dicen nada de él</translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told</source>
        <translation>un eje rotativo gira mientras la herramienta corta (línea {line:#}): no se conoce el recorrido de la herramienta</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time: a program does not say how fast they are</source>
        <translation>{length:mm4} de rápidos no están en el tiempo: un programa no dice su velocidad</translation>
    </message>
    <message>
        <source>no tool: the program does not say its diameter, so the cost is not known</source>
        <translation>sin herramienta: el programa no dice su diámetro, así que el coste se desconoce</translation>
    </message>
    <message>
        <source>the file cannot be read: {name}</source>
        <translation>no se puede leer el archivo: {name}</translation>
    </message>
    <message>
        <source>the file is larger than {size:bytes}</source>
        <translation>el archivo supera {size:bytes}</translation>
    </message>
    <message>
        <source>given up after {time:s}</source>
        <translation>abandonado tras {time:s}</translation>
    </message>
    <message>
        <source>the process that read it died, perhaps for lack of memory</source>
        <translation>el proceso que lo leía murió, quizá por falta de memoria</translation>
    </message>
    <message>
        <source>it looks 25.4 times too small: inches read as millimeters?</source>
        <translation>parece 25,4 veces demasiado pequeño: ¿pulgadas leídas como milímetros?</translation>
    </message>
    <message>
        <source>there is nothing to simulate: choose a job, or operations with a toolpath</source>
        <translation>no hay nada que simular: elija un trabajo u operaciones con una trayectoria</translation>
    </message>
    <message>
        <source>these operations belong to several jobs, choose one of them: {labels}</source>
        <translation>estas operaciones pertenecen a varios trabajos, elija uno de ellos: {labels}</translation>
    </message>
    <message>
        <source>extended z-buffer</source>
        <translation>z-buffer extendido</translation>
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
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}.</source>
        <translation>El {simulator:simulator} se bloquea en un arco {reason} (orden {command:#}{others}): {instead}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>El {simulator:simulator} corta {count:n} rampa a una profundidad falsa, hasta {error:mm2} {way} (orden {command:#}): no juzgue las profundidades por él.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>El {simulator:simulator} corta {count:n} rampas a una profundidad falsa, hasta {error:mm2} {way} (orden {command:#}): no juzgue las profundidades por él.</translation>
    </message>
    <message>
        <source>Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.</source>
        <translation>La reproducción dura unos {longer:s} en el {simulator:simulator}: el avance rápido dura unos {time:s}.</translation>
    </message>
    <message>
        <source>Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.</source>
        <translation>La reproducción dura unos {time:s} en el {simulator:simulator} a su máxima velocidad: simule menos operaciones a la vez.</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time and none is seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>{count:n} movimientos son más cortos que una celda del {simulator:simulator} ({cell:mm2}), cada uno lleva su tiempo y ninguno se ve por sí solo: una tolerancia más gruesa de la operación no pierde nada ahí.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>El {simulator:simulator} ocupa unos {memory:bytes} en esta operación, más de los {allowed:bytes} permitidos: {instead}.</translation>
    </message>
    <message>
        <source>use the {simulator:simulator} for this operation</source>
        <translation>use el {simulator:simulator} para esta operación</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}</source>
        <translation>el diámetro de la herramienta debe ser positivo y de un kilómetro como máximo, no {diameter:mm}</translation>
    </message>
    <message>
        <source>the stock&apos;s corners must be numbers within a kilometer of the origin</source>
        <translation>las esquinas del material deben ser números a menos de un kilómetro del origen</translation>
    </message>
    <message>
        <source>its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD&apos;s importer keeps them as mm/s</source>
        <translation>sus avances, de hasta {feed:g} mm/s, se leen como mm/min: la importación de FreeCAD los conserva como mm/s</translation>
    </message>
    <message>
        <source>the tip&apos;s diameter must lie between 0 and {diameter:mm}, not be {tip:mm}</source>
        <translation>el diámetro de la punta debe estar entre 0 y {diameter:mm}, no ser {tip:mm}</translation>
    </message>
    <message>
        <source>the solid&apos;s surface is not closed</source>
        <translation>la superficie del sólido no está cerrada</translation>
    </message>
    <message>
        <source>the box around the stock of {label} is taken for it: {sentence}</source>
        <translation>como material de {label} se toma la caja que lo rodea: {sentence}</translation>
    </message>
    <message>
        <source>{label} is not simulated exactly, but {instead}</source>
        <translation>{label} no se simula exactamente, sino {instead}</translation>
    </message>
    <message>
        <source>as an end mill of its largest diameter</source>
        <translation>como fresa recta de su diámetro mayor</translation>
    </message>
    <message>
        <source>as a ball end of its tip&apos;s diameter</source>
        <translation>como fresa esférica del diámetro de su punta</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>como broca</translation>
    </message>
    <message>
        <source>a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told</source>
        <translation>un eje rotativo ({letter}) gira mientras la herramienta corta: no se puede saber su recorrido</translation>
    </message>
    <message>
        <source>turns of a rotary axis ({letter}) are not followed</source>
        <translation>no se siguen los giros de un eje rotativo ({letter})</translation>
    </message>
    <message>
        <source>{letter} words are not read</source>
        <translation>no se leen las palabras {letter}</translation>
    </message>
    <message>
        <source>a cycle&apos;s repeats ({letter}) are not made</source>
        <translation>no se hacen las repeticiones de un ciclo ({letter})</translation>
    </message>
    <message>
        <source>further turns of an arc (P) are not made</source>
        <translation>no se hacen las vueltas adicionales de un arco (P)</translation>
    </message>
    <message>
        <source>inches (G20) are not followed: lengths are read in mm</source>
        <translation>no se siguen las pulgadas (G20): las longitudes se leen en mm</translation>
    </message>
    <message>
        <source>cutter compensation ({name}) is not followed: the path is the programmed one</source>
        <translation>no se sigue la compensación de radio ({name}): el recorrido es el del programa</translation>
    </message>
    <message>
        <source>feeds after {name} are not read</source>
        <translation>no se leen los avances después de {name}</translation>
    </message>
    <message>
        <source>dwells are not in the time</source>
        <translation>las pausas no están incluidas en el tiempo</translation>
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
        <source>{count:n} row{spread}, {seen}</source>
        <translation>{count:n} fila{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}</source>
        <translation>{count:n} filas{spread}, {seen}</translation>
    </message>
    <message>
        <source>one open cut{spread}, {seen}</source>
        <translation>un corte abierto{spread}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}</source>
        <translation>{count:n} cortes abiertos{spread}, {seen}</translation>
    </message>
    <message>
        <source>one loop{spread}{turning}, {seen}</source>
        <translation>una vuelta{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}</source>
        <translation>{count:n} vueltas{spread}{turning}, {seen}</translation>
    </message>
    <message>
        <source>straight down at one point</source>
        <translation>recto hacia abajo en un punto</translation>
    </message>
    <message>
        <source>straight down at {count:n} points</source>
        <translation>recto hacia abajo en {count:n} puntos</translation>
    </message>
    <message>
        <source>straight down at some points</source>
        <translation>recto hacia abajo en algunos puntos</translation>
    </message>
    <message>
        <source>{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}</source>
        <translation>{count:n} secciones, separadas por cambios de herramienta, títulos, retracciones o taladrado: {strategies:strategy}</translation>
    </message>
    <message>
        <source>{count:n} overlapping bites</source>
        <translation>{count:n} bocados que se solapan</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>una horaria, la siguiente antihoraria</translation>
    </message>
    <message>
        <source>all in one cut that winds on and never closes</source>
        <translation>todo en un corte que se enrolla y nunca se cierra</translation>
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
        <source>cut to and fro</source>
        <translation>cortadas de ida y vuelta</translation>
    </message>
    <message>
        <source>all cut the same way</source>
        <translation>todas cortadas en el mismo sentido</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ permanece entre {low:turns} y {high:turns} vueltas en una fila{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ permanece en 0 en una fila{spread}, {seen}: {strategy:strategy}</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>Un movimiento es más corto que una celda de {simulator:simulator} ({cell:mm2}), lleva su tiempo y no se ve por sí solo: una tolerancia más gruesa de la operación no pierde nada ahí.</translation>
    </message>
    <message>
        <source>which lie like those of known toolpaths ({share:%} of the votes)</source>
        <translation>dispuestos como los de trayectorias conocidas ({share:%} de los votos)</translation>
    </message>
    <message>
        <source>unlike anything that machines ({share:%} of the votes)</source>
        <translation>como nada que mecanice ({share:%} de los votos)</translation>
    </message>
    <message>
        <source>, entered by a ramp</source>
        <translation>, con entrada en rampa</translation>
    </message>
    <message>
        <source>, entered by a ramp to and fro</source>
        <translation>, con entrada en rampa de vaivén</translation>
    </message>
    <message>
        <source>, entered by a helix</source>
        <translation>, con entrada en hélice</translation>
    </message>
    <message>
        <source>, finished by a contour around the rows</source>
        <translation>, con un acabado en contorno alrededor de las filas</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator} se bloquea con esto: la orden {command:#} de {label}{others} es un arco {reason}.</translation>
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
        <source>Playing this takes {bound} {time:s} in the {simulator:simulator}.</source>
        <translation>{simulator:simulator}: la reproducción tarda {bound} {time:s}.</translation>
    </message>
    <message>
        <source>Fast-forward takes {bound} {time:s}.</source>
        <translation>El avance rápido tarda {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} in fast-forward: {bound} {time:s}.</source>
        <translation>{simulator:simulator} en avance rápido: {bound} {time:s}.</translation>
    </message>
    <message>
        <source>The {simulator:simulator}: {bound} {time:s}.</source>
        <translation>{simulator:simulator}: {bound} {time:s}.</translation>
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
        <source>Simulate toolpaths shows the finished part at once, coarse at first.</source>
        <translation>«Simular trayectorias» muestra enseguida la pieza acabada, al principio tosca.</translation>
    </message>
    <message>
        <source>a rapid move removes {volume:mm³2}</source>
        <translation>un movimiento rápido quita {volume:mm³2}</translation>
    </message>
    <message>
        <source>plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}</source>
        <translation>entra en pleno material a {feed:mm/min3}, su herramienta puede entrar a {allowed:mm/min3}</translation>
    </message>
    <message>
        <source>{depth:mm2} are left on the model</source>
        <translation>quedan {depth:mm2} sobre el modelo</translation>
    </message>
    <message>
        <source>a finer picture would take longer than the {allowed:s} that the preferences allow</source>
        <translation>una imagen más fina tardaría más que los {allowed:s} que permiten las preferencias</translation>
    </message>
    <message>
        <source>as simulated, command {command:#} is wrong: {fault}</source>
        <translation>según la simulación, la orden {command:#} está mal: {fault}</translation>
    </message>
    <message>
        <source>moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}</source>
        <translation>movimientos solo en X y Z, con pasadas a lo largo de Z en muchas X, como los hace un torno: {strategy:strategy}</translation>
    </message>
    <message>
        <source>the operation&apos;s placement must be numbers within a kilometer of the origin</source>
        <translation>la ubicación de la operación debe constar de números a menos de un kilómetro del origen</translation>
    </message>
    <message>
        <source>a line with two {letter} words: the last one is read</source>
        <translation>una línea con dos palabras {letter}: se lee la última</translation>
    </message>
    <message>
        <source>a line with two motions, such as G0 and G1: the last one is read</source>
        <translation>una línea con dos movimientos, como G0 y G1: se lee el último</translation>
    </message>
    <message>
        <source>{told}, with a little {strategies:strategy} beside it</source>
        <translation>{told}, con un poco de {strategies:strategy} al lado</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}</source>
        <translation>{width:n} × {height:n} píxeles de {pixel:mm2}, limitados por {limit}{passes}</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds</source>
        <translation>{length:mm4} de rápidos no están en el tiempo porque la operación no tiene controlador de herramienta: asígnele uno con velocidades rápidas</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the lines with them are left out</source>
        <translation>las variables y expresiones no se leen: se omiten las líneas que las contienen</translation>
    </message>
    <message>
        <source>moves to positions of the machine ({name}) are left out: a program does not say where they are</source>
        <translation>se omiten los movimientos a posiciones de la máquina ({name}): un programa no dice dónde están</translation>
    </message>
    <message>
        <source>the holes of a pattern ({name}) are not made</source>
        <translation>no se hacen los agujeros de un patrón ({name})</translation>
    </message>
    <message>
        <source>it spans meters in whole numbers: thousandths without a decimal point read as whole units?</source>
        <translation>abarca metros en números enteros: ¿milésimas sin punto decimal leídas como unidades enteras?</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: simulate this operation alone.</source>
        <translation>El {simulator:simulator} tarda al final unos {time:s} por imagen, el {percent:n} % en arcos: simule esta operación sola.</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}</source>
        <translation>El {simulator:simulator} tarda {bound} {time:s}, más de los {allowed:s} permitidos. {better}</translation>
    </message>
    <message>
        <source>the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles</source>
        <translation>los centros de los arcos se leen como posiciones (como con G90.1): solo así los arcos terminan en sus círculos</translation>
    </message>
    <message>
        <source>strokes that rise to their ends, as V-carving does</source>
        <translation>trazos que suben hacia sus extremos, como en el tallado en V</translation>
    </message>
    <message>
        <source>cut in strokes, as between tags</source>
        <translation>cortados en trazos, como entre pestañas</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored, and with it the {letters} words of its line</source>
        <translation>código desconocido {name} ignorado, y con él las palabras {letters} de su línea</translation>
    </message>
    <message>
        <source>probing moves are not in the time</source>
        <translation>los movimientos de palpado no están incluidos en el tiempo</translation>
    </message>
    <message>
        <source>cuts {depth:mm2} into the model</source>
        <translation>corta {depth:mm2} dentro del modelo</translation>
    </message>
    <message>
        <source>as simulated, {count:n} commands are wrong, among them {command:#}: {fault}</source>
        <translation>según la simulación, {count:n} órdenes están mal, entre ellas la {command:#}: {fault}</translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy:strategy}</source>
        <translation>se llama {name}, pero su trayectoria es: {strategy:strategy}</translation>
    </message>
    <message>
        <source>not an NC program, but a zip archive: unpack it first</source>
        <translation>no es un programa CN, sino un archivo zip: descomprímalo primero</translation>
    </message>
    <message>
        <source>not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro examples/macros/folder_to_csv.py</source>
        <translation>no es un programa CN, sino un documento de FreeCAD: analícelo en FreeCAD, una carpeta de ellos con la macro examples/macros/folder_to_csv.py</translation>
    </message>
    <message>
        <source>lacks {depth:mm2} of the model: choose a larger stock, or move the model within it</source>
        <translation>le faltan {depth:mm2} del modelo: elija un material en bruto mayor o mueva el modelo dentro de él</translation>
    </message>
    <message>
        <source>switched off: it has no toolpath until you switch it on and recompute it</source>
        <translation>desactivada: no tiene trayectoria hasta que la active y la recalcule</translation>
    </message>
    <message>
        <source>this is no file, but a pipe or a device</source>
        <translation>no es un archivo, sino una tubería o un dispositivo</translation>
    </message>
    <message>
        <source>it does not touch the stock, which is the finished part: choose a block around it as the stock</source>
        <translation>no toca el material en bruto, que ya es la pieza terminada: elija como bruto un bloque que la rodee</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>La simulación ocupa unos {memory:bytes} como máximo, para {dexels:n} dexels y {traces:n} elementos de traza, más que los {allowed:bytes} permitidos: {instead}.</translation>
    </message>
    <message>
        <source>choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations</source>
        <translation>elija una imagen de {width:n} × {height:n} píxeles de {pixel:mm2} o simule menos operaciones</translation>
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
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>Never calibrated on this computer: times of FreeCAD&apos;s simulators are right within a factor of two.</source>
        <translation>Nunca calibrado en este equipo: los tiempos de los simuladores de FreeCAD aciertan dentro de un factor dos.</translation>
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
        <source>Time and memory of</source>
        <translation>Tiempo y memoria de</translation>
    </message>
    <message>
        <source>Shows the marks as colored pills in the tree; as plain text if switched off.</source>
        <translation>Muestra las marcas como etiquetas de color en el árbol; si se desactiva, como texto sencillo.</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>Mostrar las marcas como etiquetas</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. Large toolpaths make each recompute longer.</source>
        <translation>Analiza de nuevo las operaciones marcadas tras cada recálculo que las haya cambiado. Las trayectorias largas alargan cada recálculo.</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>Analizar de nuevo tras un recálculo</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>How long a simulation may take. The analysis warns of more, and recommends an accuracy that takes no longer.</source>
        <translation>Cuánto puede durar una simulación. El análisis avisa si dura más y recomienda una precisión que no lo supere.</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memoria</translation>
    </message>
    <message>
        <source>How much memory a simulation may take. The analysis warns of more, and recommends an accuracy that takes no more.</source>
        <translation>Cuánta memoria puede ocupar una simulación. El análisis avisa si ocupa más y recomienda una precisión que no lo supere.</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Z-buffer image width</source>
        <translation>Ancho de imagen del z-buffer</translation>
    </message>
    <message>
        <source>Width of the image whose pixels the extended z-buffer computes.</source>
        <translation>Ancho de la imagen cuyos píxeles calcula el z-buffer extendido.</translation>
    </message>
    <message>
        <source>Z-buffer image height</source>
        <translation>Alto de imagen del z-buffer</translation>
    </message>
    <message>
        <source>Height of the image whose pixels the extended z-buffer computes.</source>
        <translation>Alto de la imagen cuyos píxeles calcula el z-buffer extendido.</translation>
    </message>
    <message>
        <source>Z-buffer view</source>
        <translation>Vista del z-buffer</translation>
    </message>
    <message>
        <source>Where the z-buffer looks at the part from.</source>
        <translation>Desde dónde mira el z-buffer la pieza.</translation>
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
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation>Arista de sus celdas en tanto por ciento del lado más largo del material: 0,1 es la posición más fina de su control, 1 la más gruesa.</translation>
    </message>
    <message>
        <source>Position of its quality slider; 10 is the best.</source>
        <translation>Posición de su control de calidad; 10 es la mejor.</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolerancia de los arcos</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves it is chopped into.</source>
        <translation>Mayor distancia entre un arco y los movimientos rectos en que se trocea.</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Measures how fast FreeCAD&apos;s simulators are on this computer, which takes about a second, and remembers it.</source>
        <translation>Mide en un segundo aproximadamente lo rápidos que son los simuladores de FreeCAD en este equipo, y lo recuerda.</translation>
    </message>
    <message>
        <source>That of FreeCAD&apos;s button: {simulator}</source>
        <translation>El del botón de FreeCAD: {simulator}</translation>
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
        <source>The simulator whose time the marks show. They follow at once.</source>
        <translation>El simulador cuyo tiempo muestran las marcas. Estas lo siguen de inmediato.</translation>
    </message>
    <message>
        <source>Says over the view, when one of FreeCAD&apos;s simulators is started, that it would hang or take longer than the budget, and offers the better way.</source>
        <translation>Avisa sobre la vista, al iniciar un simulador de FreeCAD, de que se bloquearía o tardaría más que el presupuesto, y ofrece un camino mejor.</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>Avisar si un simulador se bloquea o tarda mucho</translation>
    </message>
    <message>
        <source>Last calibrated on {date}: times of the {simulator} are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation>Última calibración el {date}: los tiempos del {simulator} aciertan dentro de un factor {factor}. Medido con FreeCAD {freecad} en {processor}, pantalla {renderer}.</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document, estimates what simulating it costs, and marks it in the tree.</source>
        <translation>Reconoce la estrategia de mecanizado de cada operación seleccionada, o de todas las del documento activo, estima lo que cuesta simularla y la marca en el árbol.</translation>
    </message>
    <message>
        <source>Analyze toolpaths</source>
        <translation>Analizar trayectorias</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>No hay ningún documento abierto. Abra primero uno con un trabajo o una trayectoria de herramienta.</translation>
    </message>
    <message>
        <source>Analysis cancelled, nothing changed.</source>
        <translation>Análisis cancelado, no ha cambiado nada.</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>No hay ninguna operación que analizar en este documento. Cree un trabajo con operaciones o importe código G.</translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation>Las marcas están en la columna Descripción del árbol, que ahora es visible. Puede ocultarla de nuevo en el menú contextual del árbol: configuración del árbol, mostrar descripción.</translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>{count} operation analyzed</source>
        <translation>{count} operación analizada</translation>
    </message>
    <message>
        <source>{count} operations analyzed</source>
        <translation>{count} operaciones analizadas</translation>
    </message>
    <message>
        <source>{count} has a warning</source>
        <translation>{count} con una advertencia</translation>
    </message>
    <message>
        <source>{count} have warnings</source>
        <translation>{count} con advertencias</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>Midiendo a qué velocidad simula este ordenador…</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document; your own descriptions stay.</source>
        <translation>Quita las marcas de las operaciones seleccionadas, o todas las del documento activo; sus propias descripciones se conservan.</translation>
    </message>
    <message>
        <source>Clear analysis</source>
        <translation>Borrar el análisis</translation>
    </message>
    <message>
        <source>{count} mark removed</source>
        <translation>{count} marca eliminada</translation>
    </message>
    <message>
        <source>{count} marks removed</source>
        <translation>{count} marcas eliminadas</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation>Aplicación de Gauss</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Guardar imagen…</translation>
    </message>
    <message>
        <source>Saves the three plots as they stand, as PNG or SVG.</source>
        <translation>Guarda los tres gráficos tal como están, como PNG o SVG.</translation>
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
        <source>Save picture</source>
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
        <source>Shows why the selected operation has its strategy: its toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>Muestra por qué la operación seleccionada tiene su estrategia: su trayectoria, la aplicación de Gauss de sus direcciones y del vector V_k, y la función angular acumulada.</translation>
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
        <source>with the closing turn φ = {}, n = {}</source>
        <translation>con el giro de cierre φ = {}, n = {}</translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge: first the one that shows the strategy best, then the longest.</source>
        <translation>Las áreas que la herramienta corta sin movimiento rápido ni entrada: primero la que mejor muestra la estrategia, después las más largas.</translation>
    </message>
    <message>
        <source>&lt;p&gt;The wheel zooms, dragging moves, a double click shows all again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;La rueda amplía, arrastrar desplaza, un doble clic muestra todo de nuevo.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: no move cuts sideways, so there is no direction to show</source>
        <translation>{}: ningún movimiento corta hacia los lados, así que no hay dirección que mostrar</translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. That of v&lt;sub&gt;k&lt;/sub&gt; goes to and fro on a part of the circle in a zigzag, and all around in a contour; that of V&lt;sub&gt;k&lt;/sub&gt; goes all around only where the path begins inside the contour. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path reaches the dashed lines ±2π, a zigzag stays between them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;A la izquierda, la trayectoria de la herramienta con el vector V&lt;sub&gt;k&lt;/sub&gt; desde el primer punto de la zona. En el círculo unidad, las imágenes del tramo v&lt;sub&gt;k&lt;/sub&gt; y de V&lt;sub&gt;k&lt;/sub&gt;; los arcos muestran cómo se han movido. La de v&lt;sub&gt;k&lt;/sub&gt; va y viene por una parte del círculo en un zigzag y da la vuelta entera en un contorno; la de V&lt;sub&gt;k&lt;/sub&gt; solo da la vuelta entera si la trayectoria empieza dentro del contorno. A la derecha, la función angular acumulada φ y el ángulo θ en el nivel n: una trayectoria de contornos paralelos alcanza las líneas discontinuas ±2π, un zigzag queda entre ellas.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation>Resultados de trayectorias</translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation>Todavía no se ha analizado nada en este documento: haga clic en «Analizar trayectorias».</translation>
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
        <source>The machining strategy recognized from the toolpath alone</source>
        <translation>La estrategia de mecanizado reconocida solo por la trayectoria</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>Seguridad</translation>
    </message>
    <message>
        <source>How sure the recognition is</source>
        <translation>Seguridad del reconocimiento</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>Longitud de los movimientos de corte</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <extracomment>FreeCAD&apos;s newer one, which draws the cuts of all operations before with every operation.</extracomment>
        <translation>Tiempo del simulador OpenGL de FreeCAD a su mayor velocidad</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator</source>
        <translation>Memoria del simulador OpenGL de FreeCAD</translation>
    </message>
    <message>
        <source>What is wrong with the operation, or will be with its simulation</source>
        <translation>Lo que falla en la operación, o fallará en su simulación</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences</source>
        <extracomment>FreeCAD&apos;s older one.</extracomment>
        <translation>Tiempo del simulador antiguo de FreeCAD en avance rápido, con la precisión de las preferencias</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences</source>
        <translation>Memoria del simulador antiguo de FreeCAD, con la precisión de las preferencias</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>Imagen recomendada: {}</translation>
    </message>
    <message>
        <source>Recommended
image</source>
        <translation>Imagen
recomendada</translation>
    </message>
    <message>
        <source>The finest image of the z-buffer within the budgets of the preferences</source>
        <translation>La imagen más fina del z-buffer dentro de los límites de las preferencias</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Machining
time</source>
        <translation>Tiempo de
mecanizado</translation>
    </message>
    <message>
        <source>Time on the machine at the programmed feeds; rapids where the tool controller gives their speed</source>
        <translation>Tiempo en la máquina con los avances programados; rápidos si el controlador de herramienta da su velocidad</translation>
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
        <source>C&amp;opy to clipboard</source>
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
        <source>Sort as &amp;posted</source>
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
time</source>
        <translation>Tiempo de
simulación</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since; analyze it again</source>
        <translation>Desactualizado: la trayectoria, la herramienta o el material han cambiado desde entonces; analícela de nuevo</translation>
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
        <source>Number of straight moves; an arc counts as several</source>
        <translation>Número de movimientos rectos; un arco cuenta como varios</translation>
    </message>
    <message>
        <source>{simulator}
time</source>
        <translation>{simulator}:
tiempo</translation>
    </message>
    <message>
        <source>{simulator}
memory</source>
        <translation>{simulator}:
memoria</translation>
    </message>
    <message>
        <source>Shows the analyzed operations: strategy, machining and simulation time, and what is wrong with them.</source>
        <translation>Muestra las operaciones analizadas: estrategia, tiempo de mecanizado y de simulación, y qué les pasa.</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>Desactualizado: la trayectoria, la herramienta o el material han cambiado desde entonces. Analícela de nuevo.</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>Todos los números</translation>
    </message>
    <message>
        <source>Fewer numbers</source>
        <translation>Menos números</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>¿Por qué?</translation>
    </message>
    <message>
        <source>Sure: {share}</source>
        <translation>Seguridad: {share}</translation>
    </message>
    <message>
        <source>Show it in the Gauss map</source>
        <translation>Mostrarlo en el mapa de Gauss</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Rápidos</translation>
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
        <source>Shows operations with this text in name, strategy or warnings</source>
        <translation>Muestra las operaciones con este texto en nombre, estrategia o advertencias</translation>
    </message>
    <message>
        <source>Shows operations of this strategy</source>
        <translation>Muestra las operaciones de esta estrategia</translation>
    </message>
    <message>
        <source>&amp;Warnings only</source>
        <translation>Solo &amp;advertencias</translation>
    </message>
    <message>
        <source>Shows operations with warnings, and outdated ones</source>
        <translation>Muestra las operaciones con advertencias y las desactualizadas</translation>
    </message>
    <message>
        <source>All strategies</source>
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
        <source>the total of what was analyzed, not of the whole job</source>
        <translation>el total de lo analizado, no de todo el trabajo</translation>
    </message>
    <message>
        <source>How long the {simulator} takes, as the marks show it</source>
        <translation>Cuánto tarda: {simulator}, como en las marcas</translation>
    </message>
    <message>
        <source>The longest that the {simulator} should take: its estimate times the factor by which estimates are off</source>
        <translation>Lo más que debería tardar: {simulator}; la estimación multiplicada por lo que suelen fallar las estimaciones</translation>
    </message>
    <message>
        <source>Simulation time
at most</source>
        <translation>Tiempo de simulación
como mucho</translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer: an operation alone, on the whole stock; a job one operation after another, each on what is left</source>
        <extracomment>The paper&apos;s; its columns in CSV and JSON have no prefix.</extracomment>
        <translation>Tiempo de simulación en un z-buffer extendido: una operación sola, con el material en bruto entero; un trabajo operación tras operación, cada una con lo que queda</translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer: of an operation alone, with the whole stock; of a job with the stock once</source>
        <translation>Memoria de simulación en un z-buffer extendido: de una operación sola, con el material en bruto entero; de un trabajo con el material en bruto una sola vez</translation>
    </message>
    <message>
        <source>not in the total: its dress-up is counted instead</source>
        <translation>fuera del total: en su lugar cuenta su aderezo</translation>
    </message>
    <message>
        <source>not in the total: it is switched off</source>
        <translation>fuera del total: está desactivada</translation>
    </message>
    <message>
        <source>Shortest move at feed</source>
        <translation>Movimiento más corto en avance de trabajo</translation>
    </message>
    <message>
        <source>Median move at feed</source>
        <translation>Movimiento mediano en avance de trabajo</translation>
    </message>
    <message>
        <source>The filter lets no operation through.</source>
        <translation>El filtro no deja pasar ninguna operación.</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>raw</source>
        <translation>en bruto</translation>
    </message>
    <message>
        <source>machined</source>
        <translation>mecanizado</translation>
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
        <source>Removal rate</source>
        <translation>Caudal de viruta</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document, and shows the part at any moment, what made each of its surfaces, and rapid moves that cut.</source>
        <translation>Simula el trabajo o las operaciones seleccionadas, o el trabajo del documento activo, y muestra la pieza en cualquier momento, qué hizo cada superficie y los movimientos rápidos que cortan.</translation>
    </message>
    <message>
        <source>Simulate toolpaths</source>
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
        <source>Folder of the Pictures</source>
        <translation>Carpeta de las imágenes</translation>
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
        <source>Simulated part</source>
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
        <source>As the 3D view</source>
        <translation>Como la vista 3D</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Where the part is seen from.</source>
        <translation>Desde dónde se ve la pieza.</translation>
    </message>
    <message>
        <source>What the surfaces are colored by.</source>
        <translation>Según qué se colorean las superficies.</translation>
    </message>
    <message>
        <source>What the operation of this moment removes, alone or on the part.</source>
        <translation>Lo que quita la operación de este momento, solo o sobre la pieza.</translation>
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
        <source>Part and chips</source>
        <translation>Pieza y viruta</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save what is shown.</source>
        <translation>Guardar lo que se muestra.</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Imagen…</translation>
    </message>
    <message>
        <source>Pictures of the whole job…</source>
        <translation>Imágenes de todo el trabajo…</translation>
    </message>
    <message>
        <source>Removal rates…</source>
        <translation>Caudales de viruta…</translation>
    </message>
    <message>
        <source>Play or pause (Space).</source>
        <translation>Reproducir o pausar (Espacio).</translation>
    </message>
    <message>
        <source>How many times as fast as the machine.</source>
        <translation>Cuántas veces más rápido que la máquina.</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>Trabajo en {}</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Tiempo real</translation>
    </message>
    <message>
        <source>To the beginning of the operation.</source>
        <translation>Al comienzo de la operación.</translation>
    </message>
    <message>
        <source>Back by one command of the program.</source>
        <translation>Retroceder una orden del programa.</translation>
    </message>
    <message>
        <source>Back by one trajectory.</source>
        <translation>Retroceder un movimiento.</translation>
    </message>
    <message>
        <source>Forward by one trajectory.</source>
        <translation>Avanzar un movimiento.</translation>
    </message>
    <message>
        <source>Forward by one command of the program.</source>
        <translation>Avanzar una orden del programa.</translation>
    </message>
    <message>
        <source>To the end of the operation.</source>
        <translation>Al final de la operación.</translation>
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
        <source>finest picture in about {}, {}</source>
        <translation>imagen más fina en unos {}, {}</translation>
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
        <source>This surface is the raw stock&apos;s.</source>
        <translation>Esta superficie es la del material en bruto.</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>Leyendo {} ({} de {})…</translation>
    </message>
    <message>
        <source>there is no closed model</source>
        <translation>no hay un modelo cerrado</translation>
    </message>
    <message>
        <source>gouged by {} to {}</source>
        <translation>demasiado hondo, {} a {}</translation>
    </message>
    <message>
        <source>left, {} to {}</source>
        <translation>resto, {} a {}</translation>
    </message>
    <message>
        <source>as the model</source>
        <translation>como el modelo</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>sin modelo</translation>
    </message>
    <message>
        <source>Difference to the model</source>
        <translation>Diferencia con el modelo</translation>
    </message>
    <message>
        <source>Smaller differences to the model do not count.</source>
        <translation>Las diferencias con el modelo hasta este valor no cuentan.</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>Peores lugares</translation>
    </message>
    <message>
        <source>Where the part differs most from the model. Choose a place to see it.</source>
        <translation>Dónde la pieza difiere más del modelo. Elija un lugar para verlo.</translation>
    </message>
    <message>
        <source>Crashes, gouges and fast plunges of the simulation. Choose one to see it.</source>
        <translation>Choques, cortes demasiado hondos y entradas demasiado rápidas de la simulación. Elija una para verla.</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ Avisos: {}</translation>
    </message>
    <message>
        <source>… and {} more</source>
        <translation>… y {} más</translation>
    </message>
    <message>
        <source>raw stock: {}</source>
        <translation>material en bruto: {}</translation>
    </message>
    <message>
        <source>{}, command {}: {} ({})</source>
        <translation>{}, orden {}: {} ({})</translation>
    </message>
    <message>
        <source>removes {}</source>
        <translation>quita {}</translation>
    </message>
    <message>
        <source>removes nothing</source>
        <translation>no quita nada</translation>
    </message>
    <message>
        <source>the model comes with the finest picture</source>
        <translation>el modelo llega con la imagen más fina</translation>
    </message>
    <message>
        <source>They are known when the finest picture is there.</source>
        <translation>Se conocen cuando está la imagen más fina.</translation>
    </message>
    <message>
        <source>Saving the pictures when the finest is there…</source>
        <translation>Las imágenes se guardan cuando está la más fina…</translation>
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
        <source>{}, at X {} Y {} Z {} {}</source>
        <translation>{}, en X {} Y {} Z {} {}</translation>
    </message>
    <message>
        <source>What is simulated has changed. Simulate again</source>
        <translation>Lo que se simula ha cambiado. Simular de nuevo</translation>
    </message>
    <message>
        <source>Which job?</source>
        <translation>¿Qué trabajo?</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, rapid moves grey. The document is not changed.</source>
        <translation>Colorea las trayectorias en la vista 3D según su estrategia de mecanizado, los movimientos rápidos en gris. El documento no cambia.</translation>
    </message>
    <message>
        <source>Show strategies</source>
        <translation>Mostrar estrategias</translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation>movimientos rápidos</translation>
    </message>
    <message>
        <source>Drawing strategies, operations to go: {}</source>
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
    <message>
        <source>Fast-forward</source>
        <translation>Avance rápido</translation>
    </message>
    <message>
        <source>Use the {simulator}</source>
        <translation>Usar {simulator}</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>Análisis de trayectorias</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates what simulating them costs.</source>
        <translation>Reconoce las estrategias de mecanizado de las trayectorias y estima lo que cuesta simularlas.</translation>
    </message>
</context>
</TS>
