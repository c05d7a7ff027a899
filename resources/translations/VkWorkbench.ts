<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The text of the mark in the description.</source>
        <extracomment>The results of this session.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining strategy recognized from the toolpath.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reason for this strategy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems of the operation, and what to know before simulating it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time on the machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The confidence of the recognition, in percent.</source>
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
        <source>switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known. Analyze the operation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{strategy}, confidence {share}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting length: {length}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining time: {time}. Cutting length: {length}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: {time}. Memory: {memory}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: at least {time}. Memory: {memory}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sim {time}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least {time}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining time at constant feed: {time}. Cutting length: {length}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool changes and starts of the spindle: {time}.</source>
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
        <source>evenly spaced in the plane, not in depth</source>
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
        <source>open strokes as long as the part</source>
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
        <source>too deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too high</source>
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
        <source> and {count:n} more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
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
        <source>{low} to {high}</source>
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
        <source>as a drill</source>
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
        <source>one clockwise, the next counter-clockwise</source>
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
        <source> (also in another operation)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
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
        <source>Command {command:#}: {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command {command:#} (first of {count:n}): {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words without a motion before them are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A feed rate that is not a usable number is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Center words (I, J, K) that are not usable numbers are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positions farther than a kilometer from the origin are limited to a kilometer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A drilling cycle without a depth (Z) drills no hole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A drilling cycle without R starts at the current height.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An arc with an unknown start is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An arc without a usable center or radius is read as a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An arc that does not end on its circle is read with a changing radius.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The centers of arcs are read as positions (as with G90.1). The arcs only close this way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored, and the {letters} words of its line with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 more unknown code is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A rotary axis ({letter}) turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves of a rotary axis ({letter}) are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{letter} words are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The repeats of a cycle ({letter}) are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches (G20) are ignored. Lengths are read in mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutter compensation ({name}) is ignored. The programmed path is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feeds after {name} are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dwell times are not included in the machining time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probing moves are not included in the machining time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}. Choose a larger tolerance in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation is switched off. It has no toolpath until you switch it on and recompute it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation has no toolpath. Recompute it and read FreeCAD&apos;s report view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolpath has no cutting move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis failed. Please report the error together with the file: {error}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation is called {name}, but its toolpath is {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation has no tool. Give it a tool controller.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no tool. Choose a tool bit for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool in {label} has no diameter. Enter one in its tool bit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corner radius must be between 0 and {radius:mm}, not {corner:mm}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tip angle must be between 0 and pi, not {angle:g}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolpath has no stock. Put it into a job.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} has no stock. Give it one in the job&apos;s settings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The corners of the stock must be numbers within a kilometer of the origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The placement of the operation must be numbers within a kilometer of the origin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stock has no volume. Its upper corner must exceed its lower corner in x, y and z.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface of the solid is not closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stock of {label} is simulated as the box around it. {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} is simulated only approximately, {instead}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as an end mill with its largest diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as a ball end mill with the diameter of its tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation cost of {labels} is unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to simulate. Choose a job, or operations with a toolpath.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These operations belong to several jobs. Choose operations of one job only: {labels}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cost is estimated for a stock that is a box around the cuts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation does not touch the stock. Check its depths, its placement and the stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is wider than the stock. Check the tool&apos;s diameter and the stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} is 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} and {other} are 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One open cut{spread}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One loop{spread}{turning}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight down at one point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight down at {count:n} points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight down at some points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} overlapping engagements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all in one continuous cut that never closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut back and forth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all cut in the same direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: {what}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#} (first of {count:n}): {what}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines with a block delete (/) are read like all others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A subprogram or macro call is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jumps, loops and calls are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words with variables or expressions are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines with variables or expressions are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines that do not consist of words like G1 X10 are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of two {letter} words in a line, the last one is read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} is ignored. The coordinates after it are read as if it were not there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves to machine positions ({name}) are ignored, because the program does not contain these positions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The holes of a pattern ({name}) are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A spline ({name}) is read as a line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines after the end of the program are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program. {part:n} of its {lines:n} lines do not consist of words like G1 X10. The first of them is line {line:#}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program. None of its lines moves a tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of the moves can be read. {problems}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program, because it is not text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program, but a zip archive. Unpack it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a folder of documents, use the macro examples/macros/folder_to_csv.py.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line {line:#}: A rotary axis turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program does not contain the tool&apos;s diameter, so the cost is unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD&apos;s G-code import does not convert them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read: {name}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a file, but a pipe or a device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis was stopped after {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The process that read the file ended unexpectedly, perhaps for lack of memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is larger than {size:bytes}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at one point: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at some points: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling, show {strategies:strategy}: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{told} A small part is {strategies:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No move cuts, because there are only rapid moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No move cuts, because there are no moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The tool enters on a ramp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The tool enters on a ramp that goes back and forth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The tool enters on a helix.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> A contour around the rows finishes the area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} engagements in the same direction overlap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) fill the same area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the direction of nested loops alternates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with a shape that changes with the depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a winding with a helical entry or with extra cuts in the corners</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut in strokes, as between holding tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>small loops that advance along the path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an open contour is repeated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strokes that rise toward their ends, as in V-carving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>short strokes that do not fill an area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arranged as in known toolpaths ({share:%} of the votes)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unlike any known machining ({share:%} of the votes)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A rapid move removes {volume:mm³2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} into the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{depth:mm2} of stock is left on the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A finer picture would take longer than the {allowed:s} limit in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation shows a fault at command {command:#}: {fault}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It takes time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, which is over your {allowed:bytes} limit. {instead}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this simulation: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate Toolpaths shows the finished part at once, coarse at first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the {simulator:simulator} for this operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave this operation out of the simulation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate fewer operations at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a smaller image in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move its accuracy slider to the left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, which is over your {allowed:bytes} limit. {instead}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the preferences, or simulate fewer operations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Passes {step:mm3} apart need {cell:mm2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> For passes {step:mm3} apart, {cell:mm2} is fine enough.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None, because not even a single pixel fits into the memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> The slowest is {label} with {time:s}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolpath looks 25.4 times too small. Inches are probably read as millimeters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). They are read as offsets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shank collides with material {depth:mm2} high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The holder collides with material {depth:mm2} high.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{part} collides with the clamp {clamp}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{sentences}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shanks were checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shanks were not checked, because no tool has a cutting edge height and a shank diameter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holders were checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No holder is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No holder is given for {labels}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 clamp was checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} clamps were checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No clamps are given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is checked yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No {what}, checked to {pixel:mm2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checked to {pixel:mm2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>collision, gouge or fast plunge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>collision or fast plunge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 rapid cuts into material.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} rapids cut into material.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 gouge is {depth:mm2} deep in the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} gouges are up to {depth:mm2} deep in the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 plunge is too fast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} plunges are too fast.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has more than {lines:n} lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not an NC program. It has a line of more than {characters:n} characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory is not sufficient for this program. Divide it into smaller programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank checked; no holder and no clamps given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD is still reading {document}. Try again when the document is open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cycle with more than {most:n} repeats is read with {most:n} repeats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A number of turns of an arc (P) that is not usable is ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A probing move is read as a rapid to its end. Where the probe touches is not in the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The feed rate of a thread ({name}) is its pitch times the spindle speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commas in numbers are read as decimal points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text that does not consist of words like G1 X10 is ignored. The words beside it are read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A spline ({name}) is read as short lines.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> A closed contour finishes the walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climbing at a constant radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only {share:%} of their length nested</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stock is where the other job leaves it, because the jobs have different models.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 move was not checked for lack of time: command {command:#} of {label}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program is read up to this line. {why}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of {name} comes from the machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The value of {name} is assigned in a line that cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A control stops here, because {name} has no value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A control stops here, because it has no variable {name}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A control stops here, because an expression has no result, such as a division by zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program stops here with an alarm (#3000).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This jump, loop or call cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The end of this loop, condition or subprogram is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program jumps to the block N{number}, which does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loops, jumps and calls would run more than {count:n} lines, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loops, jumps and calls would make more than {count:n} moves, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A loop runs more than {count:n} lines without a move, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program jumps back from here without end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The expressions take more than {count:n} steps to calculate, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calls are nested deeper than {count:n} levels, which is the limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has no unit and looks like inches. It is simulated in inches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stock is given. The simulation uses a box around the cuts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time did not suffice to check all walls for gouges narrower than {pixel:mm2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The height of a move to a machine position ({name}) is not in the program. The greatest height is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool length offset changes before a move without a Z word. The height of the move is unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A clamp was not checked. {sentence}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a toolpath for a lathe. It is simulated like a mill&apos;s, so that the part is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The verdict of the simulation is outdated, because the job has changed. Simulate the job again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No {what} was found, checked to {pixel:mm2}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything could be checked: {first}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything could be checked, for {count:n} reasons. The first reason: {first}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} already begins with what this job leaves. Choose another job.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cuts of a pocket or circle ({name}) are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was checked, because no tool meets the stock. Check the stock and its position.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. Simulate fewer operations at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{name} moves the coordinates. The origin before it is not in the program, and is read as 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program has no unit (G20, G21) and is read in millimeters. It can also be in inches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate Toolpaths simulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This toolpath has no tool. Import its program into a job.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD&apos;s CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than the sum: the {simulator:simulator} slows down with every cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Less than the sum: the {simulator:simulator} simulates all operations in one run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than the sum: tool changes and starts of the spindle take {time:clock}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {simulator:simulator} slows to about {frames:g1} frames per second at the end of this job, mostly because of arcs. Simulate fewer operations at a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gouges were not checked, because the job has no model with a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gouges of {labels} were not checked, because the tool is simulated by a simpler shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shank, holder and clamps were not checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. On Fanuc controls, they can differ by up to the diameter of the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines after M2, M17 or M30 are read as part of the same program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{seen}{spread}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{seen}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pecks of {name} are ignored. Each hole is drilled in one move.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>The operation has no strategy, or several strategies.</extracomment>
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
    <name>VkMachine</name>
    <message>
        <source>grbl Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lines that grbl answers to the command $$:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining Times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machine that machining times are planned for. The next analysis uses it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: constant feed, no acceleration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hobby router with grbl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small milling machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest speed of the X axis. Rapids use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest speed of the Y axis. Rapids use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest speed of the Z axis. Rapids use it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of the X axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of the Y axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acceleration of the Z axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from a corner at which the controller may round it: grbl&apos;s junction deviation ($11), LinuxCNC&apos;s path tolerance (G64 P). With 0, the tool stops at each corner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves planned ahead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of moves that the controller plans ahead. grbl on an Arduino plans 15.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured / planned time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured time of a job divided by the time planned here. Multiplies all times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fills the values from the answer of grbl to the command $$.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste grbl Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel and Tool Holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel in X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel of the machine along X. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel in Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel of the machine along Y. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel in Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travel of the machine along Z. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter of the tool holder. The simulation warns of collisions. A property HolderDiameter of a tool bit takes precedence. 0: unknown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the tool holder. A property HolderLength of a tool bit takes precedence. 0: the holder has no upper end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time from the end of an operation to the next operation with another tool. The time of the job includes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of the spindle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time until the spindle turns at its speed. The time of the job includes it for each tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no line such as $110=3000. Paste the lines that grbl answers to the command $$.</source>
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
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation</source>
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
        <source>Arc tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
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
        <source>FreeCAD&apos;s default ({simulator})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Never calibrated on this computer. The times of FreeCAD&apos;s simulators are right to within a factor of 2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show times for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. The marks change at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the marks in the tree as colored pills. If switched off, shows them as plain text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. With large toolpaths, each recompute takes longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows a bar above the 3D view when a simulation in one of FreeCAD&apos;s simulators would hang or take too long, and suggests a faster way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest time that a simulation may take. The analysis warns of longer simulations and recommends an accuracy within this limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest memory that a simulation may take. The analysis warns of larger simulations and recommends an accuracy within this limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction from which the part is viewed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge length of the cells, in percent of the stock&apos;s longer side. 0.1 is the finest position of the accuracy slider, 1 the coarsest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the quality slider. 10 is the best quality.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves that replace it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last calibrated on {date}. The times of the {simulator} are right to within a factor of {factor}. Measured on {processor}, display {renderer}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how fast this computer simulates, and saves the result. This takes some seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulate Toolpaths: view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_AddMesh</name>
    <message>
        <source>Add Simulated Part as Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates the job, and adds the part that it leaves to the document as a mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Analyze Toolpaths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document. Estimates what simulating each operation costs, and marks it in the tree.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The analysis was cancelled. Nothing has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operation was analyzed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} operations were analyzed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the operations…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} mark has a warning: see Toolpath Results (V, R).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} marks have warnings: see Toolpath Results (V, R).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Clamps</name>
    <message>
        <source>Set Clamps from Selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} has no clamps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove Clamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamps of {}: {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the selected solids, such as clamps and vices, the clamps of the job. The simulation warns if a tool, shank or holder collides with them. If no solid is selected, the command shows the present clamps and can remove them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To set clamps, select their solids and start this command again. If the document has several jobs, select the job, too.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Clear Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document. Your own descriptions stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks were removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no marks to remove.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
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
        <source>Gauss Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy. Shows the toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Areas that the tool cuts without a rapid move or a plunge. The area that shows the strategy best comes first, then the longest areas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the three plots as PNG or SVG.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Use the wheel to zoom, drag to move, and double-click to show everything again.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}: No move cuts sideways, so there is no direction to show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;The left plot shows the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the first point of the area. The unit circle shows the directions of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;. Its arcs show how these directions have moved. In a zigzag, the direction of v&lt;sub&gt;k&lt;/sub&gt; moves back and forth on a part of the circle. In a contour, it moves all around the circle. The direction of V&lt;sub&gt;k&lt;/sub&gt; moves all around only if the path begins inside the contour. The right plot shows the cumulative angular function φ and the angle θ on level n, in turns. A contour-parallel path reaches the dashed lines, one turn from its start. A zigzag stays between the dashed lines, one turn from its middle.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with the closing turn {}, n = {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>φ = {} turns</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Jobs</name>
    <message>
        <source>The document has no job.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the job:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulating {}…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation was cancelled. Nothing has changed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_PreviousJob</name>
    <message>
        <source>Begin with the Part of Another Job</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. The part is moved and turned with the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other job of this document machines the part of {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulation of {} begins with:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stock of {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} begins with its own stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} begins with the part that {} leaves.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
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
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
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
        <source>E&amp;xport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
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
        <source>State</source>
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
        <source>Why?</source>
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
        <source>Recommended
Image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences.</source>
        <extracomment>FreeCAD&apos;s older simulator.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s OpenGL simulator at its highest speed.</source>
        <extracomment>FreeCAD&apos;s newer simulator, which draws the cuts of all earlier operations with every operation.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time in the {simulator}, as the marks show it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The machining strategy, recognized from the toolpath alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machining
Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation
Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A result is outdated if the toolpath, the tool or the stock has changed since. Analyze the operation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Problems of the operation, and what goes wrong when you simulate it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest time that the {simulator} is expected to take. It is the estimate, multiplied by the factor to within which estimates are right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation Time
at Most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The confidence of the recognition.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of straight moves. An arc counts as several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}
Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{simulator}
Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toolpath Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the analyzed operations with their strategies, machining times, simulation times and warnings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fewer Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Confidence: {share}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in the Gauss Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest Move at Feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median Move at Feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations that contain this text in their name, strategy or warnings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations with this strategy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Warnings Only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows operations that have warnings or are outdated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Strategies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;opy to Clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sort as &amp;Posted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is analyzed in this document yet. Click Analyze Toolpaths.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No operation matches the filter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This operation is not included in the total, because its dress-up is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This operation is not included in the total, because it is switched off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This total covers the analyzed operations only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time on the machine of the preferences. Without a machine: at constant feeds, and with rapids if the tool controller has rapid speeds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In Plain Words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolpath in one sentence: the reason for the strategy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At constant feed. Choose your machine in the preferences, page Machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter the Measured Time…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time that {label} took on the machine, in minutes and seconds, such as 17:30:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a possible time. Enter it like 17:30 or 1:02:30.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time that Simulate Toolpaths takes. An operation is simulated alone, on the whole stock. In a job, each operation cuts the stock that is left.</source>
        <extracomment>Attributes of `Rings` whose shares of the section&apos;s length are measures.</extracomment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finest image of Simulate Toolpaths within your limits of time and memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remarks that need no action, such as problems of a simulator that the marks do not show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jobs and Operations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details of the Selected Operation</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_SaveStl</name>
    <message>
        <source>Save Simulated Part as STL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates the job, and saves the part that it leaves as an STL file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part is saved in {}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
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
        <source>Simulation: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
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
        <source>View</source>
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
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Job in {}</source>
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
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
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
        <source>Simulate Toolpaths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw Stock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is shown with the finest picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no closed model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gouged, {} to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stock Left, {} to {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference to the Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document. Shows the part at any moment, the operation that made each surface, and rapid moves that cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the job to simulate:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the 3D View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Property that colors the surfaces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the part, the material that the current operation removes, or both.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part and Chips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differences from the model below this value are ignored.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Worst Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places where the part differs most from the model. Choose a place to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collisions, gouges and fast plunges in the simulation. Choose one to see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures of the Whole Job…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removal Rates…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plays or pauses the simulation (Space).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the playback, compared with the machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the beginning of the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back by one command of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go back by one trajectory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go forward by one trajectory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go forward by one command of the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the end of the operation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pictures are saved when the finest picture is ready…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stock: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{}, command {} ({}): {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{} (X {} Y {} Z {} {})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is uncut stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finest picture takes about {} and {}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated job has changed. Simulate it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removed: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking… {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gray: removal rate. Orange: cuts air. Triangles: warnings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the view, path of the tool, section, and measuring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path of the Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the path of the operation: blue is done, pink to come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two clicks on the part show their distance. Esc ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section in {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the section through the stock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth below the stock&apos;s top: {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring: click on the first point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on the second point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance: {}   ΔX {}   ΔY {}   ΔZ {}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves pictures, the shown part as a solid, or removal rates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown Part as STL…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown Part as Mesh in the Document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is available when the finest picture is ready.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Part as STL</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show Strategies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, and rapid moves gray. The document is not changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rapid Moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing strategies, operations left: {}</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates the cost of their simulation.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
