<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>The machining strategy recognized from the toolpath.</source>
        <translation>由刀具路径识别出的加工策略。</translation>
    </message>
    <message>
        <source>The reason for this strategy.</source>
        <translation>判定为此策略的理由。</translation>
    </message>
    <message>
        <source>The text of the mark in the description.</source>
        <extracomment>The results of this session.</extracomment>
        <translation>说明中标记的文字。</translation>
    </message>
    <message>
        <source>The confidence of the recognition, in percent.</source>
        <translation>识别的置信度，百分比。</translation>
    </message>
    <message>
        <source>Problems of the operation, and what to know before simulating it.</source>
        <translation>操作的问题，以及模拟前应知道的事项。</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>切削移动的长度。</translation>
    </message>
    <message>
        <source>Time on the machine.</source>
        <translation>机床时间。</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows.</source>
        <translation>标记所示模拟的估计时间。</translation>
    </message>
</context>
<context>
    <name>Pills</name>
    <message>
        <source>outdated</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>{} operation</source>
        <translation>{} 个操作</translation>
    </message>
    <message>
        <source>{} operations</source>
        <translation>{} 个操作</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>此结果已过期，因为刀具路径、刀具或毛坯已更改。请重新分析此操作。</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known. Analyze the operation again.</source>
        <translation>{simulator} 中的时间未知。请重新分析此操作。</translation>
    </message>
    <message>
        <source>{strategy}, confidence {share}</source>
        <translation>{strategy}，置信度 {share}</translation>
    </message>
    <message>
        <source>Cutting length: {length}.</source>
        <translation>切削长度：{length}。</translation>
    </message>
    <message>
        <source>Machining time: {time}. Cutting length: {length}.</source>
        <translation>加工时间：{time}。切削长度：{length}。</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>{simulator} 中的模拟时间：{time}。内存：{memory}。</translation>
    </message>
    <message>
        <source>Simulation time in the {simulator}: at least {time}. Memory: {memory}.</source>
        <translation>{simulator} 中的模拟时间：至少 {time}。内存：{memory}。</translation>
    </message>
    <message>
        <source>Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.</source>
        <translation>单独模拟此操作在 {simulator} 中的时间：{time}。内存：{memory}。</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>已停用</translation>
    </message>
    <message>
        <source>sim {time}</source>
        <translation>仿真 {time}</translation>
    </message>
    <message>
        <source>at least {time}</source>
        <translation>至少 {time}</translation>
    </message>
    <message>
        <source>Machining time at constant feed: {time}. Cutting length: {length}.</source>
        <translation>恒定进给下的加工时间：{time}。切削长度：{length}。</translation>
    </message>
    <message>
        <source>Tool changes and starts of the spindle: {time}.</source>
        <translation>换刀和主轴启动：{time}。</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>刀具路径分析</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>No move cuts, because there are only rapid moves.</source>
        <translation>没有切削移动，因为只有快速移动。</translation>
    </message>
    <message>
        <source>No move cuts, because there are no moves.</source>
        <translation>没有切削移动，因为没有任何移动。</translation>
    </message>
    <message>
        <source>, counter-clockwise</source>
        <translation>，逆时针</translation>
    </message>
    <message>
        <source>, clockwise</source>
        <translation>，顺时针</translation>
    </message>
    <message>
        <source>descending at a constant radius</source>
        <translation>以固定半径下降</translation>
    </message>
    <message>
        <source>the direction of nested loops alternates</source>
        <translation>嵌套环的方向交替</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>在平面内间隔均匀，深度上则不然</translation>
    </message>
    <message>
        <source>with a shape that changes with the depth</source>
        <translation>形状随深度变化</translation>
    </message>
    <message>
        <source>a winding with a helical entry or with extra cuts in the corners</source>
        <translation>带螺旋切入或角部附加切削的卷绕</translation>
    </message>
    <message>
        <source>one winding that never closes</source>
        <translation>一条从不闭合的卷绕</translation>
    </message>
    <message>
        <source>nested</source>
        <translation>嵌套</translation>
    </message>
    <message>
        <source>small loops that advance along the path</source>
        <translation>沿路径前移的小环</translation>
    </message>
    <message>
        <source>an open pass lies inside a contour</source>
        <translation>轮廓内有一条开放走刀</translation>
    </message>
    <message>
        <source>no nested offsets</source>
        <translation>没有嵌套的轮廓</translation>
    </message>
    <message>
        <source>half-turns alternate in sign</source>
        <translation>半圈转向正负交替</translation>
    </message>
    <message>
        <source>all rows run the same way</source>
        <translation>所有行方向相同</translation>
    </message>
    <message>
        <source>open contours change with the depth</source>
        <translation>开放轮廓随深度变化</translation>
    </message>
    <message>
        <source>one open contour</source>
        <translation>一个开放轮廓</translation>
    </message>
    <message>
        <source>an open contour is repeated</source>
        <translation>同一开放轮廓重复</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>开放笔画与工件等长</translation>
    </message>
    <message>
        <source>short strokes that do not fill an area</source>
        <translation>不填充任何区域的短笔画</translation>
    </message>
    <message>
        <source>The toolpath has no cutting move.</source>
        <translation>刀具路径中没有切削移动。</translation>
    </message>
    <message>
        <source>The operation has no toolpath. Recompute it and read FreeCAD&apos;s report view.</source>
        <translation>此操作没有刀具路径。请重新计算并查看 FreeCAD 的报告视图。</translation>
    </message>
    <message>
        <source>The operation has no tool. Give it a tool controller.</source>
        <translation>此操作没有刀具。请为其指定刀具控制器。</translation>
    </message>
    <message>
        <source>{label} has no tool. Choose a tool bit for it.</source>
        <translation>{label} 没有刀具。请为其选择刀具。</translation>
    </message>
    <message>
        <source>The tool in {label} has no diameter. Enter one in its tool bit.</source>
        <translation>{label} 中的刀具没有直径。请在刀具中输入直径。</translation>
    </message>
    <message>
        <source>The toolpath has no stock. Put it into a job.</source>
        <translation>刀具路径没有毛坯。请将其放入作业。</translation>
    </message>
    <message>
        <source>{label} has no stock. Give it one in the job&apos;s settings.</source>
        <translation>{label} 没有毛坯。请在作业设置中为其指定毛坯。</translation>
    </message>
    <message>
        <source>The simulation cost of {labels} is unknown.</source>
        <translation>{labels} 的模拟开销未知。</translation>
    </message>
    <message>
        <source>Words without a motion before them are ignored.</source>
        <translation>之前没有运动指令的字被忽略。</translation>
    </message>
    <message>
        <source>A feed rate that is not a usable number is ignored.</source>
        <translation>无效的进给速度被忽略。</translation>
    </message>
    <message>
        <source>Center words (I, J, K) that are not usable numbers are ignored.</source>
        <translation>无效的圆心字 (I, J, K) 被忽略。</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored.</source>
        <translation>无效的 {letter} 字被忽略。</translation>
    </message>
    <message>
        <source>Positions farther than a kilometer from the origin are limited to a kilometer.</source>
        <translation>距原点超过一公里的位置被限制为一公里。</translation>
    </message>
    <message>
        <source>A drilling cycle without a depth (Z) drills no hole.</source>
        <translation>没有深度 (Z) 的钻孔循环不钻孔。</translation>
    </message>
    <message>
        <source>A drilling cycle without R starts at the current height.</source>
        <translation>没有 R 的钻孔循环从当前高度开始。</translation>
    </message>
    <message>
        <source>An arc with an unknown start is ignored.</source>
        <translation>起点未知的圆弧被忽略。</translation>
    </message>
    <message>
        <source>An arc without a usable center or radius is read as a line.</source>
        <translation>没有有效圆心或半径的圆弧按直线处理。</translation>
    </message>
    <message>
        <source>An arc that does not end on its circle is read with a changing radius.</source>
        <translation>终点不在圆上的圆弧按变半径处理。</translation>
    </message>
    <message>
        <source>without an X or Y word</source>
        <translation>没有 X 或 Y 字</translation>
    </message>
    <message>
        <source>without a Z word</source>
        <translation>没有 Z 字</translation>
    </message>
    <message>
        <source>without a center</source>
        <translation>没有圆心</translation>
    </message>
    <message>
        <source>that is a full circle</source>
        <translation>是整圆</translation>
    </message>
    <message>
        <source>Leave this operation out of the simulation.</source>
        <translation>模拟时请略去此操作。</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>过深</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>过高</translation>
    </message>
    <message>
        <source>Move its accuracy slider to the left.</source>
        <translation>请将其精度滑块左移。</translation>
    </message>
    <message>
        <source>Simulate fewer operations at a time.</source>
        <translation>请一次模拟较少的操作。</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>None, because not even a single pixel fits into the memory.</source>
        <translation>无，因为内存连一个像素也放不下。</translation>
    </message>
    <message>
        <source>The cost is estimated for a stock that is a box around the cuts.</source>
        <translation>开销按包围切削部分的方块毛坯估计。</translation>
    </message>
    <message>
        <source>The operation does not touch the stock. Check its depths, its placement and the stock.</source>
        <translation>此操作没有接触毛坯。请检查其深度、放置和毛坯。</translation>
    </message>
    <message>
        <source>The tool is wider than the stock. Check the tool&apos;s diameter and the stock.</source>
        <translation>刀具比毛坯宽。请检查刀具直径和毛坯。</translation>
    </message>
    <message>
        <source>Choose a smaller image in the preferences.</source>
        <translation>请在首选项中选择更小的图像。</translation>
    </message>
    <message>
        <source>that sweeps no angle</source>
        <translation>没有扫过任何角度</translation>
    </message>
    <message>
        <source>about {number}</source>
        <translation>约 {number}</translation>
    </message>
    <message>
        <source>{number}%</source>
        <translation>{number}%</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>The corner radius must be between 0 and {radius:mm}, not {corner:mm}.</source>
        <translation>圆角半径必须在 0 与 {radius:mm} 之间，而不是 {corner:mm}。</translation>
    </message>
    <message>
        <source>The tip angle must be between 0 and pi, not {angle:g}.</source>
        <translation>刀尖角必须在 0 与 π 之间，而不是 {angle:g}。</translation>
    </message>
    <message>
        <source>The stock has no volume. Its upper corner must exceed its lower corner in x, y and z.</source>
        <translation>毛坯没有体积。其上角点在 x、y、z 上必须大于下角点。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.</source>
        <translation>加工时间不包括 {count:n} 个没有进给速度的移动中的 {length:mm4} 切削。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.</source>
        <translation>加工时间不包括 {count:n} 个没有进给速度的移动中的 {length:mm4} 切削。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} is 0.</source>
        <translation>加工时间不包括 {length:mm4} 的快速移动，因为刀具控制器的 {name} 为 0。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the tool controller&apos;s {name} and {other} are 0.</source>
        <translation>加工时间不包括 {length:mm4} 的快速移动，因为刀具控制器的 {name} 和 {other} 为 0。</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation>及另外 {count:n} 处</translation>
    </message>
    <message>
        <source> Passes {step:mm3} apart need {cell:mm2}.</source>
        <translation>间距 {step:mm3} 的走刀需要 {cell:mm2}。</translation>
    </message>
    <message>
        <source> For passes {step:mm3} apart, {cell:mm2} is fine enough.</source>
        <translation>对间距 {step:mm3} 的走刀，{cell:mm2} 已足够精细。</translation>
    </message>
    <message>
        <source>None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}</source>
        <translation>无，因为仅移动就需要 {time:s}。请减少模拟的操作。{heaviest}</translation>
    </message>
    <message>
        <source> The slowest is {label} with {time:s}.</source>
        <translation>最慢的是 {label}，需要 {time:s}。</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation>及另外 1 处</translation>
    </message>
    <message>
        <source>Command {command:#}: {sentence}</source>
        <translation>命令 {command:#}：{sentence}</translation>
    </message>
    <message>
        <source>Command {command:#} (first of {count:n}): {sentence}</source>
        <translation>命令 {command:#}（共 {count:n} 处中的第一处）：{sentence}</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored.</source>
        <translation>未知代码 {name} 被忽略。</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored.</source>
        <translation>另有 1 个未知代码被忽略。</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored.</source>
        <translation>另有 {count:n} 个未知代码被忽略。</translation>
    </message>
    <message>
        <source>The arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}. Choose a larger tolerance in the preferences.</source>
        <translation>公差为 {tolerance:mm} 时圆弧和循环需要 {moves:n} 次移动。请在首选项中选择更大的公差。</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}：{sentence}</translation>
    </message>
    <message>
        <source>The analysis failed. Please report the error together with the file: {error}</source>
        <translation>分析失败。请连同文件一起报告此错误：{error}</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在 {count:n} 行{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在 {count:n} 行{spread}中保持为 0，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在一段开放笔画{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在 {count:n} 段开放笔画{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在一段开放笔画{spread}中保持为 0，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在 {count:n} 段开放笔画{spread}中保持为 0，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ 在一个环{spread}中达到 {reached:turns} 圈，{seen}：{strategy:strategy}{turning}。</translation>
    </message>
    <message>
        <source>Phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}.</source>
        <translation>φ 在 {count:n} 个环{spread}中达到 {reached:turns} 圈，{seen}：{strategy:strategy}{turning}。</translation>
    </message>
    <message>
        <source>Phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}.</source>
        <translation>φ 在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at one point: {strategy:strategy}.</source>
        <translation>φ 没有定义，因为移动在一个点上竖直：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at {count:n} points: {strategy:strategy}.</source>
        <translation>φ 没有定义，因为移动在 {count:n} 个点上竖直：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi is not defined, because the moves are vertical at some points: {strategy:strategy}.</source>
        <translation>φ 没有定义，因为移动在若干点上竖直：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling, show {strategies:strategy}: {strategy:strategy}.</source>
        <translation>由换刀、标题、退刀或钻孔分开的 {count:n} 段显示 {strategies:strategy}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>, {step:mm3} apart at {depths:n} depths</source>
        <translation>（间距 {step:mm3}，{depths:n} 个深度）</translation>
    </message>
    <message>
        <source>, {step:mm3} apart</source>
        <translation>（间距 {step:mm3}）</translation>
    </message>
    <message>
        <source> at {depths:n} depths</source>
        <translation>（{depths:n} 个深度）</translation>
    </message>
    <message>
        <source>{count:n} engagements in the same direction overlap</source>
        <translation>{count:n} 次同向切入相互重叠</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) fill the same area</source>
        <translation>行（占长度 {rows:%}）与环（{loops:%}）填充同一区域</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} 至 {high}</translation>
    </message>
    <message>
        <source>Line {line:#}: {what}</source>
        <translation>第 {line:#} 行：{what}</translation>
    </message>
    <message>
        <source>Line {line:#} (first of {count:n}): {what}</source>
        <translation>第 {line:#} 行（共 {count:n} 处中的第一处）：{what}</translation>
    </message>
    <message>
        <source>Lines with a block delete (/) are read like all others.</source>
        <translation>带跳段符（/）的行按普通行读取。</translation>
    </message>
    <message>
        <source>A subprogram or macro call is ignored.</source>
        <translation>子程序或宏调用被忽略。</translation>
    </message>
    <message>
        <source>Jumps, loops and calls are ignored.</source>
        <translation>跳转、循环和调用被忽略。</translation>
    </message>
    <message>
        <source>Words with variables or expressions are ignored.</source>
        <translation>含有变量或表达式的字被忽略。</translation>
    </message>
    <message>
        <source>Lines that do not consist of words like G1 X10 are ignored.</source>
        <translation>不是由 G1 X10 这类字组成的行被忽略。</translation>
    </message>
    <message>
        <source>{name} is ignored. The coordinates after it are read as if it were not there.</source>
        <translation>{name} 被忽略。其后的坐标按没有它来读取。</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as a line.</source>
        <translation>样条（{name}）按直线读取。</translation>
    </message>
    <message>
        <source>Lines after the end of the program are ignored.</source>
        <translation>程序结束之后的行被忽略。</translation>
    </message>
    <message>
        <source>Line {line:#}: The program is written for {name} controls. Post it as G-code (ISO) to analyze it.</source>
        <translation>第 {line:#} 行：此程序为 {name} 控制系统编写。请以 G 代码（ISO）输出后再分析。</translation>
    </message>
    <message>
        <source>This is not an NC program. {part:n} of its {lines:n} lines do not consist of words like G1 X10. The first of them is line {line:#}.</source>
        <translation>这不是 NC 程序。{lines:n} 行中有 {part:n} 行不是由 G1 X10 这类字组成。第一处是第 {line:#} 行。</translation>
    </message>
    <message>
        <source>This is not an NC program. None of its lines moves a tool.</source>
        <translation>这不是 NC 程序。没有一行移动刀具。</translation>
    </message>
    <message>
        <source>None of the moves can be read. {problems}</source>
        <translation>没有可读取的运动。{problems}</translation>
    </message>
    <message>
        <source>This is not an NC program, because it is not text.</source>
        <translation>这不是 NC 程序，因为它不是文本。</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a lathe. Milling strategies do not apply to it.</source>
        <translation>第 {line:#} 行：{name} 表明这是车床程序。铣削策略对它不适用。</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a 3D printer. Milling strategies do not apply to it.</source>
        <translation>第 {line:#} 行：{name} 表明这是 3D 打印机程序。铣削策略对它不适用。</translation>
    </message>
    <message>
        <source>Line {line:#}: {name} shows a program for a wire cutter. Milling strategies do not apply to it.</source>
        <translation>第 {line:#} 行：{name} 表明这是线切割程序。铣削策略对它不适用。</translation>
    </message>
    <message>
        <source>Line {line:#}: A rotary axis turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>第 {line:#} 行：切削时旋转轴在转动。此处刀具的路径未知。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because a program does not contain their speed.</source>
        <translation>加工时间不包括 {length:mm4} 的快速移动，因为程序不含其速度。</translation>
    </message>
    <message>
        <source>The program does not contain the tool&apos;s diameter, so the cost is unknown.</source>
        <translation>程序不含刀具直径，因此开销未知。</translation>
    </message>
    <message>
        <source>The file cannot be read: {name}.</source>
        <translation>无法读取文件：{name}。</translation>
    </message>
    <message>
        <source>The file is larger than {size:bytes}.</source>
        <translation>文件大于 {size:bytes}。</translation>
    </message>
    <message>
        <source>The analysis was stopped after {time:s}.</source>
        <translation>分析在 {time:s} 后停止。</translation>
    </message>
    <message>
        <source>The process that read the file ended unexpectedly, perhaps for lack of memory.</source>
        <translation>读取文件的进程意外终止，可能是内存不足。</translation>
    </message>
    <message>
        <source>The toolpath looks 25.4 times too small. Inches are probably read as millimeters.</source>
        <translation>刀具路径看起来小了 25.4 倍。可能把英寸读成了毫米。</translation>
    </message>
    <message>
        <source>There is nothing to simulate. Choose a job, or operations with a toolpath.</source>
        <translation>没有可模拟的内容。请选择一个作业，或带有刀具路径的操作。</translation>
    </message>
    <message>
        <source>These operations belong to several jobs. Choose operations of one job only: {labels}.</source>
        <translation>这些操作属于多个作业。请只选择其中一个作业的操作：{labels}。</translation>
    </message>
    <message>
        <source>legacy simulator</source>
        <translation>旧版模拟器</translation>
    </message>
    <message>
        <source>OpenGL simulator</source>
        <translation>OpenGL 模拟器</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}</source>
        <translation>{simulator:simulator}会卡在{reason}的圆弧上（命令 {command:#}{others}）。{instead}</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>{simulator:simulator}以错误深度切削 {count:n} 处斜坡，最多 {error:mm2} {way}（命令 {command:#}）。不要据此判断深度。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}). Do not judge depths by it.</source>
        <translation>{simulator:simulator}以错误深度切削 {count:n} 处斜坡，最多 {error:mm2} {way}（命令 {command:#}）。不要据此判断深度。</translation>
    </message>
    <message>
        <source>Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.</source>
        <translation>在{simulator:simulator}中播放约需 {longer:estimate}。请使用快进，约需 {time:estimate}。</translation>
    </message>
    <message>
        <source>Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. Simulate fewer operations at a time.</source>
        <translation>在{simulator:simulator}中以最快速度播放约需 {time:estimate}。请一次模拟较少的操作。</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>{count:n} 个移动短于{simulator:simulator}的一个单元（{cell:mm2}）。它们耗时却看不出来。请为操作选择更粗的公差。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>{simulator:simulator}此操作约需 {memory:bytes}，超过您的限额 {allowed:bytes}。{instead}</translation>
    </message>
    <message>
        <source>Use the {simulator:simulator} for this operation.</source>
        <translation>请对此操作使用 {simulator:simulator}。</translation>
    </message>
    <message>
        <source>The tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}.</source>
        <translation>刀具直径必须为正数且不超过一千米，而不是 {diameter:mm}。</translation>
    </message>
    <message>
        <source>The corners of the stock must be numbers within a kilometer of the origin.</source>
        <translation>毛坯的角点必须是距原点一千米以内的数。</translation>
    </message>
    <message>
        <source>Feeds up to {feed:g} mm/s are read as mm/min, because FreeCAD&apos;s G-code import does not convert them.</source>
        <translation>不超过 {feed:g} mm/s 的进给按 mm/min 读取，因为 FreeCAD 的 G 代码导入不换算它们。</translation>
    </message>
    <message>
        <source>The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}.</source>
        <translation>刀尖直径必须在 0 和 {diameter:mm} 之间，而不是 {tip:mm}。</translation>
    </message>
    <message>
        <source>The surface of the solid is not closed.</source>
        <translation>实体的表面不封闭。</translation>
    </message>
    <message>
        <source>The stock of {label} is simulated as the box around it. {sentence}</source>
        <translation>{label} 的毛坯按其外接长方体模拟。{sentence}</translation>
    </message>
    <message>
        <source>{label} is simulated only approximately, {instead}.</source>
        <translation>{label} 只是近似模拟，{instead}。</translation>
    </message>
    <message>
        <source>as an end mill with its largest diameter</source>
        <translation>按其最大直径的平底立铣刀模拟</translation>
    </message>
    <message>
        <source>as a ball end mill with the diameter of its tip</source>
        <translation>按刀尖直径的球头铣刀模拟</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>按钻头模拟</translation>
    </message>
    <message>
        <source>A rotary axis ({letter}) turns while the tool cuts. The tool&apos;s path is unknown here.</source>
        <translation>切削时旋转轴（{letter}）在转动。此处刀具的路径未知。</translation>
    </message>
    <message>
        <source>Moves of a rotary axis ({letter}) are ignored.</source>
        <translation>旋转轴（{letter}）的运动被忽略。</translation>
    </message>
    <message>
        <source>{letter} words are ignored.</source>
        <translation>{letter} 字被忽略。</translation>
    </message>
    <message>
        <source>The repeats of a cycle ({letter}) are ignored.</source>
        <translation>循环的重复（{letter}）被忽略。</translation>
    </message>
    <message>
        <source>Inches (G20) are ignored. Lengths are read in mm.</source>
        <translation>英寸（G20）被忽略。长度按 mm 读取。</translation>
    </message>
    <message>
        <source>Cutter compensation ({name}) is ignored. The programmed path is used.</source>
        <translation>刀具半径补偿（{name}）被忽略。使用编程的路径。</translation>
    </message>
    <message>
        <source>Feeds after {name} are ignored.</source>
        <translation>{name} 之后的进给被忽略。</translation>
    </message>
    <message>
        <source>Dwell times are not included in the machining time.</source>
        <translation>加工时间不包括暂停时间。</translation>
    </message>
    <message>
        <source>open strokes side by side at an even distance</source>
        <translation>开放走刀等距并排</translation>
    </message>
    <message>
        <source>open strokes side by side, from one wall to the other</source>
        <translation>开放走刀并排，从一侧壁到另一侧壁</translation>
    </message>
    <message>
        <source>many small contours of different shapes</source>
        <translation>许多形状各异的小轮廓</translation>
    </message>
    <message>
        <source>{count:n} row{spread}, {seen}.</source>
        <translation>{count:n} 行{spread}，{seen}。</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}.</source>
        <translation>{count:n} 行{spread}，{seen}。</translation>
    </message>
    <message>
        <source>One open cut{spread}, {seen}.</source>
        <translation>一条开放切削{spread}，{seen}。</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}.</source>
        <translation>{count:n} 条开放切削{spread}，{seen}。</translation>
    </message>
    <message>
        <source>One loop{spread}{turning}, {seen}.</source>
        <translation>一圈{spread}{turning}，{seen}。</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}.</source>
        <translation>{count:n} 圈{spread}{turning}，{seen}。</translation>
    </message>
    <message>
        <source>Straight down at one point.</source>
        <translation>在一点垂直向下。</translation>
    </message>
    <message>
        <source>Straight down at {count:n} points.</source>
        <translation>在 {count:n} 点垂直向下。</translation>
    </message>
    <message>
        <source>Straight down at some points.</source>
        <translation>在一些点垂直向下。</translation>
    </message>
    <message>
        <source>{count:n} sections, separated by tool changes, titles, retracts or drilling: {strategies:strategy}.</source>
        <translation>{count:n} 段，由换刀、标题、退刀或钻孔分开：{strategies:strategy}。</translation>
    </message>
    <message>
        <source>{count:n} overlapping engagements</source>
        <translation>{count:n} 次相互重叠的切入</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>一圈顺时针，下一圈逆时针</translation>
    </message>
    <message>
        <source>all in one continuous cut that never closes</source>
        <translation>全部由一条从不闭合的连续切削构成</translation>
    </message>
    <message>
        <source>one inside the other</source>
        <translation>一圈套一圈</translation>
    </message>
    <message>
        <source>none inside another</source>
        <translation>互不嵌套</translation>
    </message>
    <message>
        <source>cut back and forth</source>
        <translation>来回切削</translation>
    </message>
    <message>
        <source>all cut in the same direction</source>
        <translation>都按同一方向切削</translation>
    </message>
    <message>
        <source>Phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在一行{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>Phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}.</source>
        <translation>φ 在一行{spread}中保持为 0，{seen}：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It takes time, but cannot be seen. Choose a coarser tolerance for the operation.</source>
        <translation>有 1 个移动短于{simulator:simulator}的一个单元（{cell:mm2}）。它耗时却看不出来。请为操作选择更粗的公差。</translation>
    </message>
    <message>
        <source>arranged as in known toolpaths ({share:%} of the votes)</source>
        <translation>其排布与已知刀具路径相似（{share:%} 的投票）</translation>
    </message>
    <message>
        <source>unlike any known machining ({share:%} of the votes)</source>
        <translation>与任何已知加工都不相似（{share:%} 的投票）</translation>
    </message>
    <message>
        <source> The tool enters on a ramp.</source>
        <translation>刀具沿斜线切入。</translation>
    </message>
    <message>
        <source> The tool enters on a ramp that goes back and forth.</source>
        <translation>刀具沿往复斜线切入。</translation>
    </message>
    <message>
        <source> The tool enters on a helix.</source>
        <translation>刀具沿螺旋线切入。</translation>
    </message>
    <message>
        <source> A contour around the rows finishes the area.</source>
        <translation>最后绕各行作一圈轮廓精加工。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this simulation: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator}会在此模拟中卡死：{label} 的命令 {command:#}{others}是{reason}的圆弧。</translation>
    </message>
    <message>
        <source> (also in another operation)</source>
        <translation>（另有 1 个操作）</translation>
    </message>
    <message>
        <source> (also in {count:n} other operations)</source>
        <translation>（另有 {count:n} 个操作）</translation>
    </message>
    <message>
        <source>Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}.</source>
        <translation>在{simulator:simulator}中播放此模拟需要{bound} {time:estimate}。</translation>
    </message>
    <message>
        <source>about</source>
        <translation>约</translation>
    </message>
    <message>
        <source>at least</source>
        <translation>至少</translation>
    </message>
    <message>
        <source>Simulate Toolpaths shows the finished part at once, coarse at first.</source>
        <translation>“模拟刀具路径”立即显示成品零件，先粗后细。</translation>
    </message>
    <message>
        <source>A rapid move removes {volume:mm³2}.</source>
        <translation>快速移动去除了 {volume:mm³2} 材料。</translation>
    </message>
    <message>
        <source>The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}.</source>
        <translation>刀具以 {feed:mm/min3} 向实体材料下刀。其限值为 {allowed:mm/min3}。</translation>
    </message>
    <message>
        <source>{depth:mm2} of stock is left on the model.</source>
        <translation>模型上残留 {depth:mm2} 毛坯。</translation>
    </message>
    <message>
        <source>A finer picture would take longer than the {allowed:s} limit in the preferences.</source>
        <translation>更精细的图像所需时间将超过首选项中的限额 {allowed:s}。</translation>
    </message>
    <message>
        <source>The simulation shows a fault at command {command:#}: {fault}</source>
        <translation>模拟显示命令 {command:#} 有误：{fault}</translation>
    </message>
    <message>
        <source>All moves are in X and Z, with passes along Z at many X, as on a lathe: {strategy:strategy}.</source>
        <translation>所有运动都在 X 和 Z 方向，并在许多 X 处沿 Z 走刀，与车床相同：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>The placement of the operation must be numbers within a kilometer of the origin.</source>
        <translation>操作的放置必须是距原点一千米以内的数。</translation>
    </message>
    <message>
        <source>Of two {letter} words in a line, the last one is read.</source>
        <translation>一行中有两个 {letter} 字时，读取最后一个。</translation>
    </message>
    <message>
        <source>{told} A small part is {strategies:strategy}.</source>
        <translation>{told}另有一小部分是{strategies:strategy}。</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}</source>
        <translation>{width:n} × {height:n} 像素，每个 {pixel:mm2}，受{limit}限制。{passes}</translation>
    </message>
    <message>
        <source>Lines with variables or expressions are ignored.</source>
        <translation>含有变量或表达式的行被忽略。</translation>
    </message>
    <message>
        <source>Moves to machine positions ({name}) are ignored, because the program does not contain these positions.</source>
        <translation>到机床位置的移动（{name}）被忽略，因为程序不含这些位置。</translation>
    </message>
    <message>
        <source>The holes of a pattern ({name}) are ignored.</source>
        <translation>孔阵列的孔（{name}）被忽略。</translation>
    </message>
    <message>
        <source>The toolpath spans meters in whole numbers. Thousandths without a decimal point are probably read as whole units.</source>
        <translation>刀具路径全为整数且跨越数米。可能把没有小数点的千分之一读成了整单位。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}</source>
        <translation>{simulator:simulator}需要{bound} {time:estimate}，超过您的限额 {allowed:s}。{better}</translation>
    </message>
    <message>
        <source>The centers of arcs are read as positions (as with G90.1). The arcs only close this way.</source>
        <translation>圆弧的圆心按坐标读取（同 G90.1）。只有这样圆弧才能闭合。</translation>
    </message>
    <message>
        <source>strokes that rise toward their ends, as in V-carving</source>
        <translation>笔画在末端抬升，如同 V 形雕刻</translation>
    </message>
    <message>
        <source>cut in strokes, as between holding tags</source>
        <translation>分段切削，如同固定桥之间</translation>
    </message>
    <message>
        <source>The unknown code {name} is ignored, and the {letters} words of its line with it.</source>
        <translation>未知代码 {name} 以及该行的 {letters} 字被忽略。</translation>
    </message>
    <message>
        <source>Probing moves are not included in the machining time.</source>
        <translation>加工时间不包括探测移动。</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} into the model.</source>
        <translation>刀具切入模型 {depth:mm2}。</translation>
    </message>
    <message>
        <source>The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}</source>
        <translation>模拟显示 {count:n} 条命令有误，例如命令 {command:#}：{fault}</translation>
    </message>
    <message>
        <source>The operation is called {name}, but its toolpath is {strategy:strategy}.</source>
        <translation>此操作名为 {name}，但其刀具路径是：{strategy:strategy}。</translation>
    </message>
    <message>
        <source>This is not an NC program, but a zip archive. Unpack it first.</source>
        <translation>这不是 NC 程序，而是 zip 压缩包。请先解压。</translation>
    </message>
    <message>
        <source>This is not an NC program, but a FreeCAD document. Analyze it in FreeCAD. For a folder of documents, use the macro examples/macros/folder_to_csv.py.</source>
        <translation>这不是 NC 程序，而是 FreeCAD 文档。请在 FreeCAD 中分析。文档文件夹请使用宏 examples/macros/folder_to_csv.py。</translation>
    </message>
    <message>
        <source>The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.</source>
        <translation>毛坯对模型来说小了 {depth:mm2}。请选择更大的毛坯，或移动其中的模型。</translation>
    </message>
    <message>
        <source>The operation is switched off. It has no toolpath until you switch it on and recompute it.</source>
        <translation>此操作已停用。启用并重新计算后才有刀具路径。</translation>
    </message>
    <message>
        <source>This is not a file, but a pipe or a device.</source>
        <translation>这不是文件，而是管道或设备。</translation>
    </message>
    <message>
        <source>The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.</source>
        <translation>此操作没有接触毛坯，毛坯已是成品零件。请选择包围它的坯料块作为毛坯。</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, which is over your {allowed:bytes} limit. {instead}</source>
        <translation>该模拟峰值约占用 {memory:bytes}（{dexels:n} 个 dexel 和 {traces:n} 个痕迹元素），超过您的限额 {allowed:bytes}。{instead}</translation>
    </message>
    <message>
        <source>Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the preferences, or simulate fewer operations.</source>
        <translation>请在首选项中选择 {width:n} × {height:n} 像素、每个 {pixel:mm2} 的图像，或减少模拟的操作。</translation>
    </message>
    <message>
        <source>A peck depth (Q) that needs more than {most:n} pecks is ignored. The hole is drilled at once.</source>
        <translation>需要超过 {most:n} 次啄钻的啄钻深度（Q）被忽略。孔一次钻成。</translation>
    </message>
    <message>
        <source>The program does not show whether the centers of its circles are offsets (G91.1) or positions (G90.1). They are read as offsets.</source>
        <translation>程序没有表明整圆的圆心是偏移量（G91.1）还是位置（G90.1）。按偏移量读取。</translation>
    </message>
    <message>
        <source>The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long.</source>
        <translation>刀具切削深度超出切削刃 {depth:mm2}，切削刃长 {length:mm3}。</translation>
    </message>
    <message>
        <source>The shank collides with material {depth:mm2} high.</source>
        <translation>刀柄碰到高 {depth:mm2} 的材料。</translation>
    </message>
    <message>
        <source>The holder collides with material {depth:mm2} high.</source>
        <translation>刀夹碰到高 {depth:mm2} 的材料。</translation>
    </message>
    <message>
        <source>The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.</source>
        <translation>刀具太短：刀具长 {length:mm3}，旁边的材料比刀具上端高 {depth:mm2}。</translation>
    </message>
    <message>
        <source>{part} collides with the clamp {clamp}.</source>
        <translation>{part}碰到夹具 {clamp}。</translation>
    </message>
    <message>
        <source>The tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>The shank</source>
        <translation>刀柄</translation>
    </message>
    <message>
        <source>The holder</source>
        <translation>刀夹</translation>
    </message>
    <message>
        <source>{sentences}</source>
        <translation>{sentences}</translation>
    </message>
    <message>
        <source>Shanks were checked.</source>
        <translation>已检查刀柄。</translation>
    </message>
    <message>
        <source>Shanks were not checked, because no tool has a cutting edge height and a shank diameter.</source>
        <translation>未检查刀柄，因为没有刀具同时给出切削刃高度和刀柄直径。</translation>
    </message>
    <message>
        <source>The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.</source>
        <translation>未检查 {labels} 的刀柄，因为刀具没有切削刃高度或刀柄直径。</translation>
    </message>
    <message>
        <source>Holders were checked.</source>
        <translation>已检查刀夹。</translation>
    </message>
    <message>
        <source>No holder is given.</source>
        <translation>未给出刀夹。</translation>
    </message>
    <message>
        <source>No holder is given for {labels}.</source>
        <translation>{labels} 未给出刀夹。</translation>
    </message>
    <message>
        <source>1 clamp was checked.</source>
        <translation>已检查 1 个夹具。</translation>
    </message>
    <message>
        <source>{count:n} clamps were checked.</source>
        <translation>已检查 {count:n} 个夹具。</translation>
    </message>
    <message>
        <source>No clamps are given.</source>
        <translation>未给出夹具。</translation>
    </message>
    <message>
        <source>Nothing is checked yet.</source>
        <translation>尚未检查。</translation>
    </message>
    <message>
        <source>No {what}, checked to {pixel:mm2}.</source>
        <translation>没有{what}，检查精度为 {pixel:mm2}。</translation>
    </message>
    <message>
        <source>Checked to {pixel:mm2}.</source>
        <translation>检查精度为 {pixel:mm2}。</translation>
    </message>
    <message>
        <source>collision, gouge or fast plunge</source>
        <translation>碰撞、过切或过快的下刀</translation>
    </message>
    <message>
        <source>collision or fast plunge</source>
        <translation>碰撞或过快的下刀</translation>
    </message>
    <message>
        <source>1 rapid cuts into material.</source>
        <translation>1 个快速移动切入材料。</translation>
    </message>
    <message>
        <source>{count:n} rapids cut into material.</source>
        <translation>{count:n} 个快速移动切入材料。</translation>
    </message>
    <message>
        <source>1 gouge is {depth:mm2} deep in the model.</source>
        <translation>1 处过切，深入模型 {depth:mm2}。</translation>
    </message>
    <message>
        <source>{count:n} gouges are up to {depth:mm2} deep in the model.</source>
        <translation>{count:n} 处过切，最深深入模型 {depth:mm2}。</translation>
    </message>
    <message>
        <source>1 plunge is too fast.</source>
        <translation>1 次下刀过快。</translation>
    </message>
    <message>
        <source>{count:n} plunges are too fast.</source>
        <translation>{count:n} 次下刀过快。</translation>
    </message>
    <message>
        <source>The file has more than {lines:n} lines.</source>
        <translation>文件超过 {lines:n} 行。</translation>
    </message>
    <message>
        <source>This is not an NC program. It has a line of more than {characters:n} characters.</source>
        <translation>这不是 NC 程序。其中有一行超过 {characters:n} 个字符。</translation>
    </message>
    <message>
        <source>The memory is not sufficient for this program. Divide it into smaller programs.</source>
        <translation>内存不足以处理此程序。请将其拆分为较小的程序。</translation>
    </message>
    <message>
        <source>Shank checked; no holder and no clamps given.</source>
        <translation>已检查刀柄；未给出刀夹和夹具。</translation>
    </message>
    <message>
        <source>FreeCAD is still reading {document}. Try again when the document is open.</source>
        <translation>FreeCAD 仍在读取 {document}。请在文档打开后重试。</translation>
    </message>
    <message>
        <source>A drilling cycle outside the XY plane drills along {letter}. Such holes are not recognized.</source>
        <translation>XY 平面之外的钻孔循环沿 {letter} 钻孔。这样的孔不被识别。</translation>
    </message>
    <message>
        <source>A cycle with more than {most:n} repeats is read with {most:n} repeats.</source>
        <translation>重复超过 {most:n} 次的循环按 {most:n} 次读取。</translation>
    </message>
    <message>
        <source>A number of turns of an arc (P) that is not usable is ignored.</source>
        <translation>圆弧的不可用的圈数（P）被忽略。</translation>
    </message>
    <message>
        <source>A probing move is read as a rapid to its end. Where the probe touches is not in the program.</source>
        <translation>探测移动按快速移动到其终点读取。测头接触的位置不在程序中。</translation>
    </message>
    <message>
        <source>The feed rate of a thread ({name}) is its pitch times the spindle speed.</source>
        <translation>螺纹（{name}）的进给速度是螺距乘以主轴转速。</translation>
    </message>
    <message>
        <source>Feed rates are read as mm/s, because the text is a path from FreeCAD without a post processor.</source>
        <translation>进给速度按 mm/s 读取，因为文本是未经后处理的 FreeCAD 路径。</translation>
    </message>
    <message>
        <source>Commas in numbers are read as decimal points.</source>
        <translation>数字中的逗号按小数点读取。</translation>
    </message>
    <message>
        <source>Text that does not consist of words like G1 X10 is ignored. The words beside it are read.</source>
        <translation>不由 G1 X10 这样的字组成的文本被忽略。旁边的字照常读取。</translation>
    </message>
    <message>
        <source>A spline ({name}) is read as short lines.</source>
        <translation>样条（{name}）按短直线读取。</translation>
    </message>
    <message>
        <source> A closed contour finishes the walls.</source>
        <translation>最后用一圈封闭轮廓精加工侧壁。</translation>
    </message>
    <message>
        <source>climbing at a constant radius</source>
        <translation>以固定半径上升</translation>
    </message>
    <message>
        <source>only {share:%} of their length nested</source>
        <translation>只有 {share:%} 的长度是嵌套的</translation>
    </message>
    <message>
        <source>The stock is where the other job leaves it, because the jobs have different models.</source>
        <translation>毛坯位于另一个作业留下的位置，因为两个作业的模型不同。</translation>
    </message>
    <message>
        <source>1 move was not checked for lack of time: command {command:#} of {label}.</source>
        <translation>时间不足，1 个移动未检查：{label} 的第 {command:#} 条命令。</translation>
    </message>
    <message>
        <source>{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.</source>
        <translation>时间不足，{count:n} 个移动未检查，第一个是 {label} 的第 {command:#} 条命令。</translation>
    </message>
    <message>
        <source>The program is read up to this line. {why}</source>
        <translation>程序只读到这一行。{why}</translation>
    </message>
    <message>
        <source>The value of {name} comes from the machine.</source>
        <translation>{name} 的值来自机床。</translation>
    </message>
    <message>
        <source>The value of {name} is assigned in a line that cannot be read.</source>
        <translation>{name} 的值在无法读取的一行中赋予。</translation>
    </message>
    <message>
        <source>A control stops here, because {name} has no value.</source>
        <translation>数控系统在此停止，因为 {name} 没有值。</translation>
    </message>
    <message>
        <source>A control stops here, because it has no variable {name}.</source>
        <translation>数控系统在此停止，因为它没有变量 {name}。</translation>
    </message>
    <message>
        <source>A control stops here, because an expression has no result, such as a division by zero.</source>
        <translation>数控系统在此停止，因为某个表达式没有结果，例如除以零。</translation>
    </message>
    <message>
        <source>The program stops here with an alarm (#3000).</source>
        <translation>程序在此因报警而停止 (#3000)。</translation>
    </message>
    <message>
        <source>This jump, loop or call cannot be read.</source>
        <translation>无法读取此跳转、循环或调用。</translation>
    </message>
    <message>
        <source>The end of this loop, condition or subprogram is missing.</source>
        <translation>此循环、条件或子程序缺少结尾。</translation>
    </message>
    <message>
        <source>The program jumps to the block N{number}, which does not exist.</source>
        <translation>程序跳转到不存在的程序段 N{number}。</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would run more than {count:n} lines, which is the limit.</source>
        <translation>循环、跳转和调用将执行超过 {count:n} 行，这是上限。</translation>
    </message>
    <message>
        <source>Loops, jumps and calls would make more than {count:n} moves, which is the limit.</source>
        <translation>循环、跳转和调用将产生超过 {count:n} 个移动，这是上限。</translation>
    </message>
    <message>
        <source>A loop runs more than {count:n} lines without a move, which is the limit.</source>
        <translation>循环执行了超过 {count:n} 行而没有移动，这是上限。</translation>
    </message>
    <message>
        <source>The program jumps back from here without end.</source>
        <translation>程序从此处无休止地跳回。</translation>
    </message>
    <message>
        <source>The expressions take more than {count:n} steps to calculate, which is the limit.</source>
        <translation>表达式的计算超过 {count:n} 步，这是上限。</translation>
    </message>
    <message>
        <source>Calls are nested deeper than {count:n} levels, which is the limit.</source>
        <translation>调用嵌套超过 {count:n} 层，这是上限。</translation>
    </message>
    <message>
        <source>A variable is read that the program has not set. It is read as 0, on a Fanuc control as empty.</source>
        <translation>读取了程序未赋值的变量。其值按 0 处理，在 Fanuc 系统上按空值处理。</translation>
    </message>
    <message>
        <source>A command with two codes, such as G90 and G1, is read with both. Some post processors write only the first.</source>
        <translation>含有两个代码（如 G90 和 G1）的命令按两个代码读取。有些后处理器只写第一个。</translation>
    </message>
    <message>
        <source>The program has no unit and looks like inches. It is simulated in inches.</source>
        <translation>程序没有单位，看起来是英寸。按英寸仿真。</translation>
    </message>
    <message>
        <source>No stock is given. The simulation uses a box around the cuts.</source>
        <translation>未给出毛坯。仿真使用包围切削的长方体。</translation>
    </message>
    <message>
        <source>The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}.</source>
        <translation>作业沿 {axis} 移动 {needed:mm4}，但机床行程为 {travel:mm4}。</translation>
    </message>
    <message>
        <source>The time did not suffice to check all walls for gouges narrower than {pixel:mm2}.</source>
        <translation>时间不足，未能在所有壁面上检查窄于 {pixel:mm2} 的切入模型之处。</translation>
    </message>
    <message>
        <source>The height of a move to a machine position ({name}) is not in the program. The greatest height is used.</source>
        <translation>到机床位置的移动（{name}）的高度不在程序中。使用最大高度。</translation>
    </message>
    <message>
        <source>The tool length offset changes before a move without a Z word. The height of the move is unknown.</source>
        <translation>刀具长度补偿在没有 Z 字的移动之前改变。该移动的高度未知。</translation>
    </message>
    <message>
        <source>A clamp was not checked. {sentence}</source>
        <translation>有一个夹具未检查。{sentence}</translation>
    </message>
    <message>
        <source>This is a toolpath for a lathe. It is simulated like a mill&apos;s, so that the part is wrong.</source>
        <translation>这是车床的刀具路径。它按铣床模拟，因此零件不正确。</translation>
    </message>
    <message>
        <source>The verdict of the simulation is outdated, because the job has changed. Simulate the job again.</source>
        <translation>模拟的结论已过期，因为作业已更改。请重新模拟该作业。</translation>
    </message>
    <message>
        <source>No {what} was found, checked to {pixel:mm2}.</source>
        <translation>未发现{what}，检查精度为 {pixel:mm2}。</translation>
    </message>
    <message>
        <source>Not everything could be checked: {first}</source>
        <translation>并非全部都能检查：{first}</translation>
    </message>
    <message>
        <source>Not everything could be checked, for {count:n} reasons. The first reason: {first}</source>
        <translation>由于 {count:n} 个原因，并非全部都能检查。第一个原因：{first}</translation>
    </message>
    <message>
        <source>{label} already begins with what this job leaves. Choose another job.</source>
        <translation>{label} 已经从此作业留下的零件开始。请选择其他作业。</translation>
    </message>
    <message>
        <source>The cuts of a pocket or circle ({name}) are ignored.</source>
        <translation>型腔或圆（{name}）的切削被忽略。</translation>
    </message>
    <message>
        <source>{label} from line {line:#} on is not simulated, because its tool is unknown. Name the tool in a comment before it, for example (T1 D=6 end mill), or give the tool to vkworkbench.simulate.</source>
        <translation>从第 {line:#} 行起的 {label} 未模拟，因为其刀具未知。请在前面的注释中写明刀具，例如 (T1 D=6 end mill)，或将刀具传给 vkworkbench.simulate。</translation>
    </message>
    <message>
        <source>Nothing was checked, because no tool meets the stock. Check the stock and its position.</source>
        <translation>没有检查任何内容，因为没有刀具接触毛坯。请检查毛坯及其位置。</translation>
    </message>
    <message>
        <source>{name} moves the coordinates. The origin before it is not in the program, and is read as 0.</source>
        <translation>{name} 移动坐标。程序中没有它之前的原点，按 0 读取。</translation>
    </message>
    <message>
        <source>An F word in the line of {name} is read in the unit before, as in LinuxCNC. Some controls use the new unit.</source>
        <translation>{name} 所在行的 F 字与 LinuxCNC 一样按之前的单位读取。有些控制器使用新单位。</translation>
    </message>
    <message>
        <source>The program has no unit (G20, G21) and is read in millimeters. It can also be in inches.</source>
        <translation>程序没有单位（G20、G21），按毫米读取。也可能是英寸。</translation>
    </message>
    <message>
        <source>Simulate Toolpaths simulator</source>
        <translation>模拟刀具路径</translation>
    </message>
    <message>
        <source>This toolpath has no tool. Import its program into a job.</source>
        <translation>此刀具路径不能有刀具。请将其程序导入到作业中。</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.</source>
        <translation>FreeCAD 为此作业给出的 CycleTime 是 {seconds:clock}。FreeCAD 对圆弧的测量有误，且不计加速度和暂停时间。</translation>
    </message>
    <message>
        <source>The machining time does not include {length:mm4} of rapids, because the operation has no tool controller. Choose your machine in the preferences, page Machine.</source>
        <translation>加工时间不包括 {length:mm4} 的快速移动，因为操作没有刀具控制器。请在首选项的“机床”页面选择您的机床。</translation>
    </message>
    <message>
        <source>More than the sum: the {simulator:simulator} slows down with every cut.</source>
        <translation>大于总和：{simulator:simulator} 每次切削后都会变慢。</translation>
    </message>
    <message>
        <source>Less than the sum: the {simulator:simulator} simulates all operations in one run.</source>
        <translation>小于总和：{simulator:simulator} 一次运行中仿真所有操作。</translation>
    </message>
    <message>
        <source>More than the sum: tool changes and starts of the spindle take {time:clock}.</source>
        <translation>大于总和：换刀和主轴启动需要 {time:clock}。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} slows to about {frames:g1} frames per second at the end of this job, mostly because of arcs. Simulate fewer operations at a time.</source>
        <translation>{simulator:simulator}在此作业结束时降至约每秒 {frames:g1} 帧，主要由于圆弧。请一次模拟较少的操作。</translation>
    </message>
    <message>
        <source>Gouges were not checked, because the job has no model with a volume.</source>
        <translation>未检查过切，因为作业没有实体模型。</translation>
    </message>
    <message>
        <source>Gouges of {labels} were not checked, because the tool is simulated by a simpler shape.</source>
        <translation>未检查 {labels} 的过切，因为刀具由更简单的形状模拟。</translation>
    </message>
    <message>
        <source>Shank, holder and clamps were not checked.</source>
        <translation>未检查刀柄、刀夹和夹具。</translation>
    </message>
    <message>
        <source>Of two codes of one kind in a line, such as G0 and G1 or G90 and G91, the last one is read.</source>
        <translation>一行中有两个同类代码（例如 G0 和 G1，或 G90 和 G91）时，按最后一个读取。</translation>
    </message>
    <message>
        <source>After G80, a move without G0 or G1 is read as a rapid. Some controls move at the feed rate.</source>
        <translation>G80 之后没有 G0 或 G1 的移动按快速移动读取。有些控制系统按进给速度移动。</translation>
    </message>
    <message>
        <source>Under cutter compensation ({name}), the first move and outer corners are read as in LinuxCNC. On Fanuc controls, they can differ by up to the diameter of the tool.</source>
        <translation>在刀具半径补偿（{name}）下，第一个移动和外角按 LinuxCNC 的方式读取。在 Fanuc 控制器上，偏差最多可达一个刀具直径。</translation>
    </message>
    <message>
        <source>Lines after M2, M17 or M30 are read as part of the same program.</source>
        <translation>M2、M17 或 M30 之后的行按同一程序的一部分读取。</translation>
    </message>
    <message>
        <source>{seen}{spread}.</source>
        <translation>{seen}{spread}。</translation>
    </message>
    <message>
        <source>{seen}.</source>
        <translation>{seen}。</translation>
    </message>
    <message>
        <source>The pecks of {name} are ignored. Each hole is drilled in one move.</source>
        <translation>{name} 的啄钻被忽略。每个孔按一次移动钻成。</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>The operation has no strategy, or several strategies.</extracomment>
        <translation>往复</translation>
    </message>
    <message>
        <source>one-way</source>
        <translation>单向</translation>
    </message>
    <message>
        <source>contour-parallel</source>
        <translation>环切</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>waterline</source>
        <translation>等高线</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>平面螺旋</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>螺旋线</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>drilling</source>
        <translation>钻孔</translation>
    </message>
    <message>
        <source>engraving</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>混合</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
</context>
<context>
    <name>VkMachine</name>
    <message>
        <source>grbl Settings</source>
        <translation>grbl 设置</translation>
    </message>
    <message>
        <source>The lines that grbl answers to the command $$:</source>
        <translation>grbl 对命令 $$ 回应的各行：</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Machining Times</source>
        <translation>加工时间</translation>
    </message>
    <message>
        <source>The machine that machining times are planned for. The next analysis uses it.</source>
        <translation>用于规划加工时间的机床。下一次分析时生效。</translation>
    </message>
    <message>
        <source>None: constant feed, no acceleration</source>
        <translation>无：恒定进给，不计加速度</translation>
    </message>
    <message>
        <source>Hobby router with grbl</source>
        <translation>使用 grbl 的业余雕刻机</translation>
    </message>
    <message>
        <source>Small milling machine</source>
        <translation>小型铣床</translation>
    </message>
    <message>
        <source>Machining center</source>
        <translation>加工中心</translation>
    </message>
    <message>
        <source>Own values</source>
        <translation>自定义数值</translation>
    </message>
    <message>
        <source>Speed X</source>
        <translation>X 轴速度</translation>
    </message>
    <message>
        <source>Largest speed of the X axis. Rapids use it.</source>
        <translation>X 轴的最大速度，快速移动使用此速度。</translation>
    </message>
    <message>
        <source>Speed Y</source>
        <translation>Y 轴速度</translation>
    </message>
    <message>
        <source>Largest speed of the Y axis. Rapids use it.</source>
        <translation>Y 轴的最大速度，快速移动使用此速度。</translation>
    </message>
    <message>
        <source>Speed Z</source>
        <translation>Z 轴速度</translation>
    </message>
    <message>
        <source>Largest speed of the Z axis. Rapids use it.</source>
        <translation>Z 轴的最大速度，快速移动使用此速度。</translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation>X 轴加速度</translation>
    </message>
    <message>
        <source>Acceleration of the X axis.</source>
        <translation>X 轴的加速度。</translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation>Y 轴加速度</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis.</source>
        <translation>Y 轴的加速度。</translation>
    </message>
    <message>
        <source>Acceleration Z</source>
        <translation>Z 轴加速度</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis.</source>
        <translation>Z 轴的加速度。</translation>
    </message>
    <message>
        <source>Corner deviation</source>
        <translation>拐角偏差</translation>
    </message>
    <message>
        <source>Distance from a corner at which the controller may round it: grbl&apos;s junction deviation ($11), LinuxCNC&apos;s path tolerance (G64 P). With 0, the tool stops at each corner.</source>
        <translation>控制器可以在距拐角多远处将其圆滑：grbl 的 junction deviation（$11），LinuxCNC 的路径公差（G64 P）。为 0 时，刀具在每个拐角停止。</translation>
    </message>
    <message>
        <source>Moves planned ahead</source>
        <translation>预读的移动数</translation>
    </message>
    <message>
        <source>Number of moves that the controller plans ahead. grbl on an Arduino plans 15.</source>
        <translation>控制器预先规划的移动数。Arduino 上的 grbl 规划 15 个。</translation>
    </message>
    <message>
        <source>Measured / planned time</source>
        <translation>实测时间 / 规划时间</translation>
    </message>
    <message>
        <source>Measured time of a job divided by the time planned here. Multiplies all times.</source>
        <translation>作业的实测时间除以此处规划的时间。所有时间都乘以该系数。</translation>
    </message>
    <message>
        <source>Fills the values from the answer of grbl to the command $$.</source>
        <translation>用 grbl 对命令 $$ 的回应填写数值。</translation>
    </message>
    <message>
        <source>Paste grbl Settings…</source>
        <translation>粘贴 grbl 设置…</translation>
    </message>
    <message>
        <source>Travel and Tool Holder</source>
        <translation>行程与刀柄</translation>
    </message>
    <message>
        <source>Travel in X</source>
        <translation>X 轴行程</translation>
    </message>
    <message>
        <source>Travel of the machine along X. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>机床沿 X 轴的行程。分析会警告需要更大行程的作业和程序。0：未知。</translation>
    </message>
    <message>
        <source>Travel in Y</source>
        <translation>Y 轴行程</translation>
    </message>
    <message>
        <source>Travel of the machine along Y. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>机床沿 Y 轴的行程。分析会警告需要更大行程的作业和程序。0：未知。</translation>
    </message>
    <message>
        <source>Travel in Z</source>
        <translation>Z 轴行程</translation>
    </message>
    <message>
        <source>Travel of the machine along Z. The analysis warns of jobs and programs that need more. 0: unknown.</source>
        <translation>机床沿 Z 轴的行程。分析会警告需要更大行程的作业和程序。0：未知。</translation>
    </message>
    <message>
        <source>Holder diameter</source>
        <translation>刀夹直径</translation>
    </message>
    <message>
        <source>Diameter of the tool holder. The simulation warns of collisions. A property HolderDiameter of a tool bit takes precedence. 0: unknown.</source>
        <translation>刀夹直径。仿真会警告碰撞。刀具的 HolderDiameter 属性优先。0：未知。</translation>
    </message>
    <message>
        <source>Holder length</source>
        <translation>刀夹长度</translation>
    </message>
    <message>
        <source>Length of the tool holder. A property HolderLength of a tool bit takes precedence. 0: the holder has no upper end.</source>
        <translation>刀夹长度。刀具的 HolderLength 属性优先。0：刀夹没有上端。</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>换刀</translation>
    </message>
    <message>
        <source>Time from the end of an operation to the next operation with another tool. The time of the job includes it.</source>
        <translation>从一个操作结束到使用另一把刀具的下一个操作的时间。作业的时间包含此时间。</translation>
    </message>
    <message>
        <source>Start of the spindle</source>
        <translation>主轴启动</translation>
    </message>
    <message>
        <source>Time until the spindle turns at its speed. The time of the job includes it for each tool.</source>
        <translation>主轴达到转速所需的时间。作业的时间包含每把刀具的此时间。</translation>
    </message>
    <message>
        <source>There is no line such as $110=3000. Paste the lines that grbl answers to the command $$.</source>
        <translation>缺少类似 $110=3000 的行。请粘贴 grbl 对命令 $$ 的应答行。</translation>
    </message>
</context>
<context>
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Never calibrated on this computer. The times of FreeCAD&apos;s simulators are right to within a factor of 2.</source>
        <translation>尚未在此计算机上校准。FreeCAD 模拟器的时间误差在 2 倍以内。</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Marks in the Tree</source>
        <translation>树中的标记</translation>
    </message>
    <message>
        <source>Show times for</source>
        <translation>显示时间的模拟器</translation>
    </message>
    <message>
        <source>Shows the marks in the tree as colored pills. If switched off, shows them as plain text.</source>
        <translation>在树中以彩色标签显示标记。关闭后显示为纯文本。</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>以标签显示标记</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. With large toolpaths, each recompute takes longer.</source>
        <translation>每次重新计算改变了已标记的操作后，重新分析它们。刀具路径很大时，每次重新计算会更久。</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>重新计算后再次分析</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Longest time that a simulation may take. The analysis warns of longer simulations and recommends an accuracy within this limit.</source>
        <translation>模拟允许的最长时间。分析会对更长的模拟发出警告，并推荐此限额内的精度。</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>Largest memory that a simulation may take. The analysis warns of larger simulations and recommends an accuracy within this limit.</source>
        <translation>模拟允许占用的最大内存。分析会对更大的模拟发出警告，并推荐此限额内的精度。</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Direction from which the part is viewed.</source>
        <translation>观察零件的方向。</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Edge length of the cells, in percent of the stock&apos;s longer side. 0.1 is the finest position of the accuracy slider, 1 the coarsest.</source>
        <translation>单元边长，占毛坯长边的百分比。0.1 是精度滑块最精细的位置，1 最粗。</translation>
    </message>
    <message>
        <source>Position of the quality slider. 10 is the best quality.</source>
        <translation>质量滑块的位置。10 为最佳质量。</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>圆弧公差</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves that replace it.</source>
        <translation>圆弧与替代它的直线移动之间的最大距离。</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>FreeCAD&apos;s default ({simulator})</source>
        <translation>FreeCAD 默认（{simulator}）</translation>
    </message>
    <message>
        <source>{simulator}: accuracy</source>
        <translation>{simulator}：精度</translation>
    </message>
    <message>
        <source>{simulator}: quality</source>
        <translation>{simulator}：质量</translation>
    </message>
    <message>
        <source>The simulator whose time the marks show. The marks change at once.</source>
        <translation>标记显示哪个模拟器的时间。标记立即随之更新。</translation>
    </message>
    <message>
        <source>Shows a bar above the 3D view when a simulation in one of FreeCAD&apos;s simulators would hang or take too long, and suggests a faster way.</source>
        <translation>当在 FreeCAD 的模拟器中模拟会卡死或耗时过长时，在三维视图上方显示一个栏，并建议更快的方式。</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>在启动会卡死或耗时过长的模拟之前警告</translation>
    </message>
    <message>
        <source>Last calibrated on {date}. The times of the {simulator} are right to within a factor of {factor}. Measured on {processor}, display {renderer}.</source>
        <translation>上次校准于 {date}。{simulator}的时间误差在 {factor} 倍以内。测量环境：{processor}，显示 {renderer}。</translation>
    </message>
    <message>
        <source>Measures how fast this computer simulates, and saves the result. This takes some seconds.</source>
        <translation>测量此计算机的仿真速度并保存结果。这需要几秒钟。</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限额</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image width</source>
        <translation>模拟刀具路径：图像宽度</translation>
    </message>
    <message>
        <source>Width of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>估算“模拟刀具路径”的时间和内存所用的图像宽度。</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: image height</source>
        <translation>模拟刀具路径：图像高度</translation>
    </message>
    <message>
        <source>Height of the picture for which the time and memory of Simulate Toolpaths are estimated.</source>
        <translation>估算“模拟刀具路径”的时间和内存所用的图像高度。</translation>
    </message>
    <message>
        <source>Simulate Toolpaths: view</source>
        <translation>模拟刀具路径：视图</translation>
    </message>
</context>
<context>
    <name>Vk_AddMesh</name>
    <message>
        <source>Add Simulated Part as Mesh</source>
        <translation>将模拟零件添加为网格</translation>
    </message>
    <message>
        <source>Simulates the job, and adds the part that it leaves to the document as a mesh.</source>
        <translation>模拟该作业，并将其留下的零件作为网格添加到文档中。</translation>
    </message>
    <message>
        <source>{} was added to the document.</source>
        <translation>{} 已添加到文档中。</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document. Estimates what simulating each operation costs, and marks it in the tree.</source>
        <translation>识别所选操作（或活动文档所有操作）的加工策略。估计模拟每个操作的开销，并在树中标记。</translation>
    </message>
    <message>
        <source>Analyze Toolpaths</source>
        <translation>分析刀具路径</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>没有打开的文档。请先打开含有作业或刀具路径的文档。</translation>
    </message>
    <message>
        <source>The analysis was cancelled. Nothing has changed.</source>
        <translation>分析已取消。未作任何更改。</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>此文档中没有可分析的操作。请创建带有操作的作业，或导入 G 代码。</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>刀具路径分析</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>{count} operation was analyzed.</source>
        <translation>已分析 {count} 个操作。</translation>
    </message>
    <message>
        <source>{count} operations were analyzed.</source>
        <translation>已分析 {count} 个操作。</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>正在测量本机的模拟速度…</translation>
    </message>
    <message>
        <source>Reading the operations…</source>
        <translation>正在读取操作…</translation>
    </message>
    <message>
        <source>{count} mark has a warning: see Toolpath Results (V, R).</source>
        <translation>{count} 个标记有警告：请见刀具路径结果 (V, R)。</translation>
    </message>
    <message>
        <source>{count} marks have warnings: see Toolpath Results (V, R).</source>
        <translation>{count} 个标记有警告：请见刀具路径结果 (V, R)。</translation>
    </message>
</context>
<context>
    <name>Vk_Clamps</name>
    <message>
        <source>Set Clamps from Selection</source>
        <translation>将所选对象设为夹具</translation>
    </message>
    <message>
        <source>{} has no clamps.</source>
        <translation>{} 没有夹具。</translation>
    </message>
    <message>
        <source>Remove Clamps</source>
        <translation>移除夹具</translation>
    </message>
    <message>
        <source>Clamps of {}: {}.</source>
        <translation>{} 的夹具：{}。</translation>
    </message>
    <message>
        <source>Makes the selected solids, such as clamps and vices, the clamps of the job. The simulation warns if a tool, shank or holder collides with them. If no solid is selected, the command shows the present clamps and can remove them.</source>
        <translation>将所选实体（例如压板和虎钳）设为该作业的夹具。如果刀具、刀柄或夹头与其碰撞，模拟会发出警告。如果没有选择实体，该命令会显示当前的夹具，并可将其移除。</translation>
    </message>
    <message>
        <source>To set clamps, select their solids and start this command again. If the document has several jobs, select the job, too.</source>
        <translation>要设置夹具，请选择其实体，然后再次启动该命令。如果文档有多个作业，还要选择作业。</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document. Your own descriptions stay.</source>
        <translation>移除所选操作的标记，或活动文档的所有标记。您自己的描述会保留。</translation>
    </message>
    <message>
        <source>Clear Analysis</source>
        <translation>清除分析</translation>
    </message>
    <message>
        <source>The marks were removed.</source>
        <translation>标记已移除。</translation>
    </message>
    <message>
        <source>There are no marks to remove.</source>
        <translation>没有可移除的标记。</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss Map</source>
        <translation>高斯映射</translation>
    </message>
    <message>
        <source>Save Picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Saves the three plots as PNG or SVG.</source>
        <translation>将三幅图保存为 PNG 或 SVG。</translation>
    </message>
    <message>
        <source>Steps through the trajectories k of the area.</source>
        <translation>逐步浏览该区域的轨迹 k。</translation>
    </message>
    <message>
        <source>Area {}: {} trajectories, {}</source>
        <translation>区域 {}：{} 段轨迹，{}</translation>
    </message>
    <message>
        <source>Gauss map of the last {} trajectories up to k.</source>
        <translation>高斯映射显示到 k 为止的最后 {} 段轨迹。</translation>
    </message>
    <message>
        <source>Select an operation in the tree.</source>
        <translation>请在树中选择一个操作。</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>exact reversal</source>
        <translation>正好反向</translation>
    </message>
    <message>
        <source>Shows why the selected operation has its strategy. Shows the toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>显示所选操作为何具有其策略。显示刀具路径、方向和向量 V_k 的高斯映射，以及累积角函数。</translation>
    </message>
    <message>
        <source>This area: {}</source>
        <translation>此区域：{}</translation>
    </message>
    <message>
        <source>φ between {} and {} turns, level n = {}, exact reversals: {}</source>
        <translation>φ 在 {} 与 {} 圈之间，级别 n = {}，精确反向：{}</translation>
    </message>
    <message>
        <source>Reading {}…</source>
        <translation>正在读取 {}…</translation>
    </message>
    <message>
        <source>Areas that the tool cuts without a rapid move or a plunge. The area that shows the strategy best comes first, then the longest areas.</source>
        <translation>刀具在没有快速移动或下刀的情况下切削的区域。最能体现策略的区域排在最前，然后是最长的区域。</translation>
    </message>
    <message>
        <source>&lt;p&gt;Use the wheel to zoom, drag to move, and double-click to show everything again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;滚轮缩放，拖动平移，双击恢复全部显示。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: No move cuts sideways, so there is no direction to show.</source>
        <translation>{}：没有横向切削的移动，因此没有方向可显示。</translation>
    </message>
    <message>
        <source>&lt;p&gt;The left plot shows the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the first point of the area. The unit circle shows the directions of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;. Its arcs show how these directions have moved. In a zigzag, the direction of v&lt;sub&gt;k&lt;/sub&gt; moves back and forth on a part of the circle. In a contour, it moves all around the circle. The direction of V&lt;sub&gt;k&lt;/sub&gt; moves all around only if the path begins inside the contour. The right plot shows the cumulative angular function φ and the angle θ on level n, in turns. A contour-parallel path reaches the dashed lines, one turn from its start. A zigzag stays between the dashed lines, one turn from its middle.&lt;/p&gt;</source>
        <translation>&lt;p&gt;左图显示刀具路径以及从区域起点出发的向量 V&lt;sub&gt;k&lt;/sub&gt;。单位圆显示轨迹 v&lt;sub&gt;k&lt;/sub&gt; 和 V&lt;sub&gt;k&lt;/sub&gt; 的方向。圆弧显示这些方向如何移动。在往复路径中，v&lt;sub&gt;k&lt;/sub&gt; 的方向在圆的一部分上来回移动。在轮廓路径中，它绕圆一周。V&lt;sub&gt;k&lt;/sub&gt; 的方向只有当路径从轮廓内部开始时才绕圆一周。右图显示累积角函数 φ 和层级 n 上的角 θ，以圈为单位。环切路径达到虚线，距起点一圈。往复路径保持在虚线之间，距中心一圈。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>with the closing turn {}, n = {}</source>
        <translation>加上闭合转角 {}，n = {}</translation>
    </message>
    <message>
        <source>φ = {} turns</source>
        <translation>φ = {} 圈</translation>
    </message>
</context>
<context>
    <name>Vk_Jobs</name>
    <message>
        <source>The document has no job.</source>
        <translation>该文档没有作业。</translation>
    </message>
    <message>
        <source>Choose the job:</source>
        <translation>选择作业：</translation>
    </message>
    <message>
        <source>Simulating {}…</source>
        <translation>正在模拟 {}…</translation>
    </message>
    <message>
        <source>The simulation was cancelled. Nothing has changed.</source>
        <translation>模拟已取消。没有任何更改。</translation>
    </message>
</context>
<context>
    <name>Vk_PreviousJob</name>
    <message>
        <source>Begin with the Part of Another Job</source>
        <translation>从另一个作业的零件开始</translation>
    </message>
    <message>
        <source>Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. The part is moved and turned with the model.</source>
        <translation>让该作业的模拟从另一个作业留下的零件开始，例如加工零件的第二面。零件随模型一起移动和旋转。</translation>
    </message>
    <message>
        <source>No other job of this document machines the part of {}.</source>
        <translation>该文档中没有其他作业加工 {} 的零件。</translation>
    </message>
    <message>
        <source>The simulation of {} begins with:</source>
        <translation>{} 的模拟开始于：</translation>
    </message>
    <message>
        <source>The stock of {}</source>
        <translation>{} 的毛坯</translation>
    </message>
    <message>
        <source>{} begins with its own stock.</source>
        <translation>{} 从自己的毛坯开始。</translation>
    </message>
    <message>
        <source>{} begins with the part that {} leaves.</source>
        <translation>{} 从 {} 留下的零件开始。</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath Results</source>
        <translation>刀具路径结果</translation>
    </message>
    <message>
        <source>Nothing is analyzed in this document yet. Click Analyze Toolpaths.</source>
        <translation>此文档尚未分析。请点击“分析刀具路径”。</translation>
    </message>
    <message>
        <source>Export CSV</source>
        <translation>导出 CSV</translation>
    </message>
    <message>
        <source>Export JSON</source>
        <translation>导出 JSON</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>The machining strategy, recognized from the toolpath alone.</source>
        <translation>仅由刀具路径识别出的加工策略。</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>置信度</translation>
    </message>
    <message>
        <source>The confidence of the recognition.</source>
        <translation>识别的置信度。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Length of the cutting moves.</source>
        <translation>切削移动的长度。</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s OpenGL simulator at its highest speed.</source>
        <extracomment>FreeCAD&apos;s newer simulator, which draws the cuts of all earlier operations with every operation.</extracomment>
        <translation>FreeCAD OpenGL 模拟器以最高速度所需的时间。</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator.</source>
        <translation>FreeCAD OpenGL 模拟器的内存。</translation>
    </message>
    <message>
        <source>Problems of the operation, and what goes wrong when you simulate it.</source>
        <translation>操作存在的问题，以及模拟时出现的问题。</translation>
    </message>
    <message>
        <source>Time in FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences.</source>
        <extracomment>FreeCAD&apos;s older simulator.</extracomment>
        <translation>FreeCAD 旧版模拟器以首选项中的精度快进所需的时间。</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences.</source>
        <translation>FreeCAD 旧版模拟器在首选项精度下的内存。</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>推荐图像：{}</translation>
    </message>
    <message>
        <source>Recommended
Image</source>
        <translation>推荐
图像</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Machining
Time</source>
        <translation>加工
时间</translation>
    </message>
    <message>
        <source>Export &amp;CSV…</source>
        <translation>导出 &amp;CSV…</translation>
    </message>
    <message>
        <source>Export &amp;JSON…</source>
        <translation>导出 &amp;JSON…</translation>
    </message>
    <message>
        <source>C&amp;opy to Clipboard</source>
        <translation>复制到剪贴板(&amp;O)</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>Col&amp;umns</source>
        <translation>列(&amp;U)</translation>
    </message>
    <message>
        <source>Sort as &amp;Posted</source>
        <translation>按输出顺序排列(&amp;P)</translation>
    </message>
    <message>
        <source>Select an operation to read what it does and why.</source>
        <translation>选择一个操作，查看它做什么以及为什么。</translation>
    </message>
    <message>
        <source>Selection in {job}</source>
        <translation>{job} 中的选择</translation>
    </message>
    <message>
        <source>Simulation
Time</source>
        <translation>模拟
时间</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>A result is outdated if the toolpath, the tool or the stock has changed since. Analyze the operation again.</source>
        <translation>如果刀具路径、刀具或毛坯此后已更改，结果即已过期。请重新分析此操作。</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>已过期</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Number of straight moves. An arc counts as several.</source>
        <translation>直线移动的数量。一段圆弧算作多个。</translation>
    </message>
    <message>
        <source>{simulator}
Time</source>
        <translation>{simulator}
时间</translation>
    </message>
    <message>
        <source>{simulator}
Memory</source>
        <translation>{simulator}
内存</translation>
    </message>
    <message>
        <source>Shows the analyzed operations with their strategies, machining times, simulation times and warnings.</source>
        <translation>显示已分析的操作及其策略、加工时间、模拟时间和警告。</translation>
    </message>
    <message>
        <source>This result is outdated, because the toolpath, the tool or the stock has changed. Analyze the operation again.</source>
        <translation>此结果已过期，因为刀具路径、刀具或毛坯已更改。请重新分析此操作。</translation>
    </message>
    <message>
        <source>All Numbers</source>
        <translation>所有数值</translation>
    </message>
    <message>
        <source>Fewer Numbers</source>
        <translation>较少数值</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>为什么？</translation>
    </message>
    <message>
        <source>Confidence: {share}</source>
        <translation>置信度：{share}</translation>
    </message>
    <message>
        <source>Show in the Gauss Map</source>
        <translation>在高斯映射中显示</translation>
    </message>
    <message>
        <source>Cutting Length</source>
        <translation>切削长度</translation>
    </message>
    <message>
        <source>Rapid Length</source>
        <translation>快速移动长度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Shows operations that contain this text in their name, strategy or warnings.</source>
        <translation>显示名称、策略或警告中含有此文字的操作。</translation>
    </message>
    <message>
        <source>Shows operations with this strategy.</source>
        <translation>显示此策略的操作。</translation>
    </message>
    <message>
        <source>&amp;Warnings Only</source>
        <translation>仅警告(&amp;W)</translation>
    </message>
    <message>
        <source>Shows operations that have warnings or are outdated.</source>
        <translation>显示有警告的和已过期的操作。</translation>
    </message>
    <message>
        <source>All Strategies</source>
        <translation>所有策略</translation>
    </message>
    <message>
        <source>{count} of {all} operations</source>
        <translation>{all} 个操作中的 {count} 个</translation>
    </message>
    <message>
        <source>{count} operation</source>
        <translation>{count} 个操作</translation>
    </message>
    <message>
        <source>{count} operations</source>
        <translation>{count} 个操作</translation>
    </message>
    <message>
        <source>This total covers the analyzed operations only.</source>
        <translation>此合计仅包括已分析的操作。</translation>
    </message>
    <message>
        <source>Time in the {simulator}, as the marks show it.</source>
        <translation>{simulator}中的时间，与标记所示一致。</translation>
    </message>
    <message>
        <source>Longest time that the {simulator} is expected to take. It is the estimate, multiplied by the factor to within which estimates are right.</source>
        <translation>{simulator}预计需要的最长时间。它是估计值乘以估计的误差倍数。</translation>
    </message>
    <message>
        <source>Simulation Time
at Most</source>
        <translation>模拟时间
最长</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because its dress-up is.</source>
        <translation>此操作不计入合计，因为其修饰已计入。</translation>
    </message>
    <message>
        <source>This operation is not included in the total, because it is switched off.</source>
        <translation>此操作不计入合计，因为它已停用。</translation>
    </message>
    <message>
        <source>Shortest Move at Feed</source>
        <translation>最短的进给移动</translation>
    </message>
    <message>
        <source>Median Move at Feed</source>
        <translation>进给移动的中位长度</translation>
    </message>
    <message>
        <source>No operation matches the filter.</source>
        <translation>没有符合筛选条件的操作。</translation>
    </message>
    <message>
        <source>Time on the machine of the preferences. Without a machine: at constant feeds, and with rapids if the tool controller has rapid speeds.</source>
        <translation>首选项中所选机床上的时间。未选机床时：按恒定进给计算，若刀具控制器设有快速速度则包括快速移动。</translation>
    </message>
    <message>
        <source>In Plain Words</source>
        <translation>简单说明</translation>
    </message>
    <message>
        <source>The toolpath in one sentence: the reason for the strategy.</source>
        <translation>用一句话描述刀具路径：判定该策略的理由。</translation>
    </message>
    <message>
        <source>At constant feed. Choose your machine in the preferences, page Machine.</source>
        <translation>按恒定进给计算。请在首选项的“机床”页面选择您的机床。</translation>
    </message>
    <message>
        <source>Enter the Measured Time…</source>
        <translation>输入实测时间…</translation>
    </message>
    <message>
        <source>Measured Time</source>
        <translation>实测时间</translation>
    </message>
    <message>
        <source>Time that {label} took on the machine, in minutes and seconds, such as 17:30:</source>
        <translation>{label} 在机床上所用的时间，以分和秒表示，例如 17:30：</translation>
    </message>
    <message>
        <source>This is not a possible time. Enter it like 17:30 or 1:02:30.</source>
        <translation>该时间无效。请输入如 17:30 或 1:02:30 的时间。</translation>
    </message>
    <message>
        <source>Time that Simulate Toolpaths takes. An operation is simulated alone, on the whole stock. In a job, each operation cuts the stock that is left.</source>
        <extracomment>Attributes of `Rings` whose shares of the section&apos;s length are measures.</extracomment>
        <translation>“模拟刀具路径”所需的时间。操作单独在完整毛坯上模拟。在作业中，每个操作切削剩余的毛坯。</translation>
    </message>
    <message>
        <source>Memory that Simulate Toolpaths takes. An operation includes the whole stock. A job includes the stock once.</source>
        <translation>“模拟刀具路径”所需的内存。操作包含完整毛坯。作业中毛坯只计一次。</translation>
    </message>
    <message>
        <source>The finest image of Simulate Toolpaths within your limits of time and memory.</source>
        <translation>在您的时间和内存限额内，“模拟刀具路径”的最精细图像。</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Remarks that need no action, such as problems of a simulator that the marks do not show.</source>
        <translation>无需处理的说明，例如标记未显示的模拟器的问题。</translation>
    </message>
    <message>
        <source>Jobs and Operations</source>
        <translation>作业和操作</translation>
    </message>
    <message>
        <source>Details of the Selected Operation</source>
        <translation>所选操作的详细信息</translation>
    </message>
</context>
<context>
    <name>Vk_SaveStl</name>
    <message>
        <source>Save Simulated Part as STL</source>
        <translation>将模拟零件保存为 STL</translation>
    </message>
    <message>
        <source>Simulates the job, and saves the part that it leaves as an STL file.</source>
        <translation>模拟该作业，并将其留下的零件保存为 STL 文件。</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>无法写入 {}：{}</translation>
    </message>
    <message>
        <source>The part is saved in {}.</source>
        <translation>零件已保存到 {}。</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>Raw Stock</source>
        <translation>毛坯面</translation>
    </message>
    <message>
        <source>Machined</source>
        <translation>加工面</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Removal Rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document. Shows the part at any moment, the operation that made each surface, and rapid moves that cut.</source>
        <translation>模拟所选作业或操作（否则为当前文档的作业）。显示任意时刻的工件、加工出每个表面的操作，以及会切到材料的快速移动。</translation>
    </message>
    <message>
        <source>Simulate Toolpaths</source>
        <translation>模拟刀具路径</translation>
    </message>
    <message>
        <source>Simulation: {}</source>
        <translation>模拟：{}</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Folder for the Pictures</source>
        <translation>图片文件夹</translation>
    </message>
    <message>
        <source>Save Removal Rates</source>
        <translation>保存去除率</translation>
    </message>
    <message>
        <source>{} cannot be written.</source>
        <translation>无法写入 {}。</translation>
    </message>
    <message>
        <source>Simulated Part</source>
        <translation>模拟工件</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>As in the 3D View</source>
        <translation>与三维视图相同</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Property that colors the surfaces.</source>
        <translation>表面着色的依据。</translation>
    </message>
    <message>
        <source>Shows the part, the material that the current operation removes, or both.</source>
        <translation>显示工件、当前操作所去除的材料，或两者。</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>工件</translation>
    </message>
    <message>
        <source>Chips</source>
        <translation>切屑</translation>
    </message>
    <message>
        <source>Part and Chips</source>
        <translation>工件和切屑</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>图片…</translation>
    </message>
    <message>
        <source>Pictures of the Whole Job…</source>
        <translation>整个作业的图片…</translation>
    </message>
    <message>
        <source>Removal Rates…</source>
        <translation>去除率…</translation>
    </message>
    <message>
        <source>Plays or pauses the simulation (Space).</source>
        <translation>播放或暂停（空格键）。</translation>
    </message>
    <message>
        <source>Speed of the playback, compared with the machine.</source>
        <translation>播放速度，与机床相比。</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>{}内完成</translation>
    </message>
    <message>
        <source>Real Time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Go to the beginning of the operation.</source>
        <translation>到操作开头。</translation>
    </message>
    <message>
        <source>Go back by one command of the program.</source>
        <translation>后退一条程序指令。</translation>
    </message>
    <message>
        <source>Go back by one trajectory.</source>
        <translation>后退一个运动。</translation>
    </message>
    <message>
        <source>Go forward by one trajectory.</source>
        <translation>前进一个运动。</translation>
    </message>
    <message>
        <source>Go forward by one command of the program.</source>
        <translation>前进一条程序指令。</translation>
    </message>
    <message>
        <source>Go to the end of the operation.</source>
        <translation>到操作末尾。</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>约{}</translation>
    </message>
    <message>
        <source>Simulating… {}</source>
        <translation>正在模拟… {}</translation>
    </message>
    <message>
        <source>The finest picture takes about {} and {}.</source>
        <translation>最精细的图片约需 {} 和 {}。</translation>
    </message>
    <message>
        <source>{} × {} pixels of {}, {} traces, {}, simulated in {}</source>
        <translation>{} × {} 像素，每个 {}，{} 条痕迹，{}，模拟用时 {}</translation>
    </message>
    <message>
        <source>{} of {}   {}, command {}: {}</source>
        <translation>{} / {}   {}，指令 {}：{}</translation>
    </message>
    <message>
        <source>This is uncut stock.</source>
        <translation>这是未切削的毛坯。</translation>
    </message>
    <message>
        <source>Time Line</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>正在读取 {}（{}/{}）…</translation>
    </message>
    <message>
        <source>There is no closed model.</source>
        <translation>没有封闭的模型。</translation>
    </message>
    <message>
        <source>Gouged, {} to {}</source>
        <translation>过切 {} 至 {}</translation>
    </message>
    <message>
        <source>Stock Left, {} to {}</source>
        <translation>残留 {} 至 {}</translation>
    </message>
    <message>
        <source>As the Model</source>
        <translation>与模型一致</translation>
    </message>
    <message>
        <source>No Model</source>
        <translation>无模型</translation>
    </message>
    <message>
        <source>Difference to the Model</source>
        <translation>与模型的差异</translation>
    </message>
    <message>
        <source>Differences from the model below this value are ignored.</source>
        <translation>小于此值的差异被忽略。</translation>
    </message>
    <message>
        <source>Worst Places</source>
        <translation>最差位置</translation>
    </message>
    <message>
        <source>Places where the part differs most from the model. Choose a place to see it.</source>
        <translation>零件与模型差异最大的地方。选择一处即可查看。</translation>
    </message>
    <message>
        <source>Collisions, gouges and fast plunges in the simulation. Choose one to see it.</source>
        <translation>模拟中的碰撞、过切和过快的下刀。选择一项即可查看。</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ 警告：{}</translation>
    </message>
    <message>
        <source>Stock: {}</source>
        <translation>毛坯：{}</translation>
    </message>
    <message>
        <source>{}, command {} ({}): {}</source>
        <translation>{}，命令 {}（{}）：{}</translation>
    </message>
    <message>
        <source>Removed: {}</source>
        <translation>去除：{}</translation>
    </message>
    <message>
        <source>Nothing removed</source>
        <translation>未去除材料</translation>
    </message>
    <message>
        <source>The model is shown with the finest picture.</source>
        <translation>模型将随最精细的画面一起显示。</translation>
    </message>
    <message>
        <source>The pictures are saved when the finest picture is ready…</source>
        <translation>最精细的图片完成后保存图片…</translation>
    </message>
    <message>
        <source>{} of {} pictures are saved in {}.</source>
        <translation>{} / {} 张图片已保存到 {}。</translation>
    </message>
    <message>
        <source>{} pictures</source>
        <translation>{} 图片</translation>
    </message>
    <message>
        <source>{} (X {} Y {} Z {} {})</source>
        <translation>{}（X {} Y {} Z {} {}）</translation>
    </message>
    <message>
        <source>The simulated job has changed. Simulate it again.</source>
        <translation>所模拟的作业已更改。请重新模拟。</translation>
    </message>
    <message>
        <source>Choose the job to simulate:</source>
        <translation>请选择要模拟的作业：</translation>
    </message>
    <message>
        <source>Checking… {}</source>
        <translation>正在检查… {}</translation>
    </message>
    <message>
        <source>Gray: removal rate. Orange: cuts air. Triangles: warnings.</source>
        <translation>灰色：材料去除率。橙色：空切。三角：警告。</translation>
    </message>
    <message>
        <source>Direction of the view, path of the tool, section, and measuring.</source>
        <translation>视图方向、刀具路径、剖切和测量。</translation>
    </message>
    <message>
        <source>Path of the Tool</source>
        <translation>刀具路径</translation>
    </message>
    <message>
        <source>Shows the path of the operation: blue is done, pink to come.</source>
        <translation>显示该操作的路径：蓝色为已完成，粉色为未完成。</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Two clicks on the part show their distance. Esc ends it.</source>
        <translation>在零件上点击两处即显示其距离。按 Esc 结束测量。</translation>
    </message>
    <message>
        <source>Section in {}</source>
        <translation>{} 向剖切</translation>
    </message>
    <message>
        <source>No Section</source>
        <translation>不剖切</translation>
    </message>
    <message>
        <source>Moves the section through the stock.</source>
        <translation>在毛坯中移动剖切面。</translation>
    </message>
    <message>
        <source>Depth below the stock&apos;s top: {}</source>
        <translation>毛坯顶面以下深度：{}</translation>
    </message>
    <message>
        <source>Measuring: click on the first point.</source>
        <translation>测量：请点击第一个点。</translation>
    </message>
    <message>
        <source>Click on the second point.</source>
        <translation>请点击第二个点。</translation>
    </message>
    <message>
        <source>Distance: {}   ΔX {}   ΔY {}   ΔZ {}</source>
        <translation>距离：{}   ΔX {}   ΔY {}   ΔZ {}</translation>
    </message>
    <message>
        <source>This is the section.</source>
        <translation>这是剖切面。</translation>
    </message>
    <message>
        <source>Saves pictures, the shown part as a solid, or removal rates.</source>
        <translation>保存图片、作为实体的所示零件或材料去除率。</translation>
    </message>
    <message>
        <source>Shown Part as STL…</source>
        <translation>将所示零件保存为 STL…</translation>
    </message>
    <message>
        <source>Shown Part as Mesh in the Document</source>
        <translation>将所示零件作为网格加入文档</translation>
    </message>
    <message>
        <source>This is available when the finest picture is ready.</source>
        <translation>最精细的图片完成后可用。</translation>
    </message>
    <message>
        <source>Save Part as STL</source>
        <translation>将零件保存为 STL</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, and rapid moves gray. The document is not changed.</source>
        <translation>在三维视图中按加工策略为刀具路径着色，快速移动为灰色。文档不会更改。</translation>
    </message>
    <message>
        <source>Show Strategies</source>
        <translation>显示策略</translation>
    </message>
    <message>
        <source>Rapid Moves</source>
        <translation>快速移动</translation>
    </message>
    <message>
        <source>Drawing strategies, operations left: {}</source>
        <translation>正在绘制策略，剩余操作：{}</translation>
    </message>
    <message>
        <source>There is no toolpath to color in this document. Create a job with operations, or import G-code.</source>
        <translation>此文档中没有可着色的刀具路径。请创建带有操作的作业，或导入 G 代码。</translation>
    </message>
</context>
<context>
    <name>Vk_Warning</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath Analysis</source>
        <translation>刀具路径分析</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates the cost of their simulation.</source>
        <translation>识别刀具路径的加工策略，并估计模拟的开销。</translation>
    </message>
</context>
</TS>
