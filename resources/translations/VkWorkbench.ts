<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognized from the toolpath</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the mark in the description says</source>
        <extracomment>The results of this session.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sure the recognition is, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong with the operation, unknown about it, or to be known before simulating it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Pills</name>
    <message>
        <source>outdated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known: analyze it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{strategy}, {share} sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the machine: {length} of cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the machine: {time}, {length} of cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the machine: at least {time}, {length} of cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: {time}, {memory}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: at least {time}, {memory}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating it alone in the {simulator}: {time}, {memory}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switched off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>nothing cuts: there are only rapid moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing cuts: there are no moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>descending at a constant radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the sense of nested loops alternates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whose shape changes with the depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a winding with a helical entry or bites out of the corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>small loops move along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no nested offsets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half-turns alternate in sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all rows run the same way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open contours change with the depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one open contour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an open contour comes again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>short strokes that fill nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no cutting move in its toolpath</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no toolpath: recompute the operation and see FreeCAD&apos;s report view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tool: give the operation a tool controller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tool in {label}: choose a tool bit for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tool in {label} has no diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no stock: put the toolpath into a job</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no stock: give {label} a stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cost unknown for {labels}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>words without a motion before them are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a feed rate that is not a usable number is ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>center words (I, J, K) that are not usable numbers are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>positions beyond a kilometer are cut off there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a drilling cycle without a depth (Z) drills nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a drilling cycle without R starts at the current height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a drilling cycle outside the XY plane is read as one in XY</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an arc whose start is not known is ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an arc without a usable center or radius is read as a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an arc whose end is not on its circle is read with a changing radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without an X or Y word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without a Z word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without a center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that is a full circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave this operation out of the simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move its accuracy slider to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulate fewer operations at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no resolution helps, not even a single pixel fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cost is that of a box around its cuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not touch the stock: check its depths, its placement and the stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its tool is wider than the stock: check the tool&apos;s diameter and the stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose a smaller image in the preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that sweeps no angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {number}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{number}%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tip angle must lie between 0 and pi, not be {angle:g}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stock has no volume: its upper corner must exceed its lower corner in x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} move without a feed rate are not in the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} is 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} and {other} are 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; passes {step:mm3} apart ask for {cell:mm2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; {cell:mm2} would do for passes {step:mm3} apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; the heaviest is {label} with {time:s}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sentence} (command {command:#})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sentence} ({count:n} times, first at command {command:#})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 more unknown code is ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>could not be analyzed, please report it with the file: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} bites of one sense overlap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) share the area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} (line {line:#})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{what} ({count:n} times, first in line {line:#})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines with a block delete (/) are read like the others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a subprogram or macro call is not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jumps, loops and calls are not followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variables and expressions are not read: the words with them are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines that are not made of words like G1 X10 are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coordinates that {name} changes are read as if it were not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a spline ({name}) is read as a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what follows M2 or M30 is read as the same program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what follows the program&apos;s end is not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an NC program: no line of it moves a tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none of its moves can be read: {problems}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an NC program: it is not text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time: a program does not say how fast they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tool: the program does not say its diameter, so the cost is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file cannot be read: {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file is larger than {size:bytes}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>given up after {time:s}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the process that read it died, perhaps for lack of memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it looks 25.4 times too small: inches read as millimeters?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is nothing to simulate: choose a job, or operations with a toolpath</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these operations belong to several jobs, choose one of them: {labels}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extended z-buffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>legacy simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenGL simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time and none is seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>use the {simulator:simulator} for this operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the stock&apos;s corners must be numbers within a kilometer of the origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD&apos;s importer keeps them as mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the tip&apos;s diameter must lie between 0 and {diameter:mm}, not be {tip:mm}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the solid&apos;s surface is not closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the box around the stock of {label} is taken for it: {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is not simulated exactly, but {instead}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as an end mill of its largest diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a ball end of its tip&apos;s diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns of a rotary axis ({letter}) are not followed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} words are not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a cycle&apos;s repeats ({letter}) are not made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>further turns of an arc (P) are not made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inches (G20) are not followed: lengths are read in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cutter compensation ({name}) is not followed: the path is the programmed one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feeds after {name} are not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dwells are not in the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open strokes side by side at an even distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open strokes side by side, from one wall to the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>many small contours of different shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one open cut{spread}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one loop{spread}{turning}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight down at one point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight down at {count:n} points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight down at some points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} overlapping bites</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all in one cut that winds on and never closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut to and fro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all cut the same way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which lie like those of known toolpaths ({share:%} of the votes)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unlike anything that machines ({share:%} of the votes)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, entered by a ramp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, entered by a ramp to and fro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, entered by a helix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, finished by a contour around the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (also in another operation)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing this takes {bound} {time:s} in the {simulator:simulator}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast-forward takes {bound} {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} in fast-forward: {bound} {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator}: {bound} {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate toolpaths shows the finished part at once, coarse at first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a rapid move removes {volume:mm³2}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{depth:mm2} are left on the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a finer picture would take longer than the {allowed:s} that the preferences allow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as simulated, command {command:#} is wrong: {fault}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the operation&apos;s placement must be numbers within a kilometer of the origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line with two {letter} words: the last one is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line with two motions, such as G0 and G1: the last one is read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{told}, with a little {strategies:strategy} beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variables and expressions are not read: the lines with them are left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves to positions of the machine ({name}) are left out: a program does not say where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the holes of a pattern ({name}) are not made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it spans meters in whole numbers: thousandths without a decimal point read as whole units?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: simulate this operation alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strokes that rise to their ends, as V-carving does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut in strokes, as between tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored, and with it the {letters} words of its line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probing moves are not in the time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cuts {depth:mm2} into the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as simulated, {count:n} commands are wrong, among them {command:#}: {fault}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy:strategy}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an NC program, but a zip archive: unpack it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro examples/macros/folder_to_csv.py</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lacks {depth:mm2} of the model: choose a larger stock, or move the model within it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>switched off: it has no toolpath until you switch it on and recompute it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this is no file, but a pipe or a device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not touch the stock, which is the finished part: choose a block around it as the stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>No strategy, or several.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one-way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contour-parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waterline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spiral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>helix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drilling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>engraving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never calibrated on this computer: times of FreeCAD&apos;s simulators are right within a factor of two.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time and memory of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the marks as colored pills in the tree; as plain text if switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. Large toolpaths make each recompute longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Budget</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long a simulation may take. The analysis warns of more, and recommends an accuracy that takes no longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much memory a simulation may take. The analysis warns of more, and recommends an accuracy that takes no more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z-buffer image width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the image whose pixels the extended z-buffer computes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z-buffer image height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the image whose pixels the extended z-buffer computes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z-buffer view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the z-buffer looks at the part from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of its quality slider; 10 is the best.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves it is chopped into.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how fast FreeCAD&apos;s simulators are on this computer, which takes about a second, and remembers it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That of FreeCAD&apos;s button: {simulator}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}: accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}: quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. They follow at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Says over the view, when one of FreeCAD&apos;s simulators is started, that it would hang or take longer than the budget, and offers the better way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last calibrated on {date}: times of the {simulator} are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document, estimates what simulating it costs, and marks it in the tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyze toolpaths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analysis cancelled, nothing changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operation analyzed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operations analyzed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} has a warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} have warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document; your own descriptions stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} mark removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} marks removed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the three plots as they stand, as PNG or SVG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps through the trajectories k of the area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an operation in the tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact reversal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy: its toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This area: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ between {} and {} turns, level n = {}, exact reversals: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {}…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the closing turn φ = {}, n = {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge: first the one that shows the strategy best, then the longest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;The wheel zooms, dragging moves, a double click shows all again.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: no move cuts sideways, so there is no direction to show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. That of v&lt;sub&gt;k&lt;/sub&gt; goes to and fro on a part of the circle in a zigzag, and all around in a contour; that of V&lt;sub&gt;k&lt;/sub&gt; goes all around only where the path begins inside the contour. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path reaches the dashed lines ±2π, a zigzag stays between them.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining strategy recognized from the toolpath alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sure the recognition is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <extracomment>FreeCAD&apos;s newer one, which draws the cuts of all operations before with every operation.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong with the operation, or will be with its simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences</source>
        <extracomment>FreeCAD&apos;s older one.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended
image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finest image of the z-buffer within the budgets of the preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining
time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time on the machine at the programmed feeds; rapids where the tool controller gives their speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;opy to clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sort as &amp;posted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select an operation to read what it does and why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selection in {job}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation
time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since; analyze it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outdated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of straight moves; an arc counts as several</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}
time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}
memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the analyzed operations: strategy, machining and simulation time, and what is wrong with them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sure: {share}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show it in the Gauss map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations with this text in name, strategy or warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations of this strategy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Warnings only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations with warnings, and outdated ones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All strategies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} of {all} operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the total of what was analyzed, not of the whole job</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long the {simulator} takes, as the marks show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The longest that the {simulator} should take: its estimate times the factor by which estimates are off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation time
at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer: an operation alone, on the whole stock; a job one operation after another, each on what is left</source>
        <extracomment>The paper&apos;s; its columns in CSV and JSON have no prefix.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer: of an operation alone, with the whole stock; of a job with the stock once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the total: its dress-up is counted instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not in the total: it is switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest move at feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median move at feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The filter lets no operation through.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>raw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>machined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removal rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document, and shows the part at any moment, what made each of its surfaces, and rapid moves that cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate toolpaths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of the Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Removal Rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} cannot be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the 3D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the part is seen from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the surfaces are colored by.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the operation of this moment removes, alone or on the part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part and chips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures of the whole job…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removal rates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (Space).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times as fast as the machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the beginning of the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back by one command of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back by one trajectory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward by one trajectory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward by one command of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end of the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finest picture in about {}, {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This surface is the raw stock&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no closed model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gouged by {} to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left, {} to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference to the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller differences to the model do not count.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the part differs most from the model. Choose a place to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crashes, gouges and fast plunges of the simulation. Choose one to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and {} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>raw stock: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, command {}: {} ({})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removes {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>removes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model comes with the finest picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are known when the finest picture is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving the pictures when the finest is there…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {} pictures are saved in {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, at X {} Y {} Z {} {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is simulated has changed. Simulate again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which job?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, rapid moves grey. The document is not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show strategies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing strategies, operations to go: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast-forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the {simulator}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates what simulating them costs.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
