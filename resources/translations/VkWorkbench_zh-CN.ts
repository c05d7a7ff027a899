<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>Machining strategy recognized from the toolpath</source>
        <translation>由刀具路径识别出的加工策略</translation>
    </message>
    <message>
        <source>Why this strategy</source>
        <translation>判定为此策略的理由</translation>
    </message>
    <message>
        <source>What the mark in the description says</source>
        <extracomment>The results of this session.</extracomment>
        <translation>说明中的标记内容</translation>
    </message>
    <message>
        <source>How sure the recognition is, in percent</source>
        <translation>识别的把握，百分比</translation>
    </message>
    <message>
        <source>What is wrong with the operation, unknown about it, or to be known before simulating it</source>
        <translation>操作有何错误、未知之处，或模拟前应知之事</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>切削移动的长度</translation>
    </message>
    <message>
        <source>Time on the machine</source>
        <translation>机床时间</translation>
    </message>
    <message>
        <source>Estimated time of the simulation that the mark shows</source>
        <translation>标记所示模拟的估计时间</translation>
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
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>已过期：刀具路径、刀具或毛坯此后已更改。请重新分析。</translation>
    </message>
    <message>
        <source>The time in the {simulator} is not known: analyze it again.</source>
        <translation>{simulator} 中的时间未知：请重新分析。</translation>
    </message>
    <message>
        <source>{strategy}, {share} sure</source>
        <translation>{strategy}，把握 {share}</translation>
    </message>
    <message>
        <source>On the machine: {length} of cutting</source>
        <translation>机床上：切削 {length}</translation>
    </message>
    <message>
        <source>On the machine: {time}, {length} of cutting</source>
        <translation>机床上：{time}，切削 {length}</translation>
    </message>
    <message>
        <source>On the machine: at least {time}, {length} of cutting</source>
        <translation>机床上：至少 {time}，切削 {length}</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: {time}, {memory}</source>
        <translation>在 {simulator} 中模拟：{time}，{memory}</translation>
    </message>
    <message>
        <source>Simulating it in the {simulator}: at least {time}, {memory}</source>
        <translation>在 {simulator} 中模拟：至少 {time}，{memory}</translation>
    </message>
    <message>
        <source>Simulating it alone in the {simulator}: {time}, {memory}</source>
        <translation>在 {simulator} 中单独模拟：{time}，{memory}</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>已停用</translation>
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
        <source>nothing cuts: there are only rapid moves</source>
        <translation>没有切削：只有快速移动</translation>
    </message>
    <message>
        <source>nothing cuts: there are no moves</source>
        <translation>没有切削：没有移动</translation>
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
        <source>the sense of nested loops alternates</source>
        <translation>嵌套环的方向交替</translation>
    </message>
    <message>
        <source>evenly spaced in the plane, not in depth</source>
        <translation>在平面内间隔均匀，深度上则不然</translation>
    </message>
    <message>
        <source>whose shape changes with the depth</source>
        <translation>形状随深度变化</translation>
    </message>
    <message>
        <source>a winding with a helical entry or bites out of the corners</source>
        <translation>带螺旋切入或角部切入的卷绕</translation>
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
        <source>small loops move along</source>
        <translation>小环逐步前移</translation>
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
        <source>an open contour comes again</source>
        <translation>同一开放轮廓重复</translation>
    </message>
    <message>
        <source>open strokes as long as the part</source>
        <translation>开放笔画与工件等长</translation>
    </message>
    <message>
        <source>short strokes that fill nothing</source>
        <translation>不填充任何区域的短笔画</translation>
    </message>
    <message>
        <source>no cutting move in its toolpath</source>
        <translation>其刀具路径中没有切削移动</translation>
    </message>
    <message>
        <source>no toolpath: recompute the operation and see FreeCAD&apos;s report view</source>
        <translation>没有刀具路径：请重新计算操作并查看 FreeCAD 的报告视图</translation>
    </message>
    <message>
        <source>no tool: give the operation a tool controller</source>
        <translation>没有刀具：请为操作指定刀具控制器</translation>
    </message>
    <message>
        <source>no tool in {label}: choose a tool bit for it</source>
        <translation>{label} 中没有刀具：请为其选择刀具</translation>
    </message>
    <message>
        <source>the tool in {label} has no diameter</source>
        <translation>{label} 中的刀具没有直径</translation>
    </message>
    <message>
        <source>no stock: put the toolpath into a job</source>
        <translation>没有毛坯：请将刀具路径放入作业</translation>
    </message>
    <message>
        <source>no stock: give {label} a stock</source>
        <translation>没有毛坯：请为 {label} 指定毛坯</translation>
    </message>
    <message>
        <source>cost unknown for {labels}</source>
        <translation>{labels} 的开销未知</translation>
    </message>
    <message>
        <source>words without a motion before them are ignored</source>
        <translation>忽略了之前没有运动指令的字</translation>
    </message>
    <message>
        <source>a feed rate that is not a usable number is ignored</source>
        <translation>忽略了无效的进给速度</translation>
    </message>
    <message>
        <source>center words (I, J, K) that are not usable numbers are ignored</source>
        <translation>忽略了无效的圆心字 (I, J, K)</translation>
    </message>
    <message>
        <source>{letter} words that are not usable numbers are ignored</source>
        <translation>忽略了无效的 {letter} 字</translation>
    </message>
    <message>
        <source>positions beyond a kilometer are cut off there</source>
        <translation>超过一公里的位置已截断</translation>
    </message>
    <message>
        <source>a drilling cycle without a depth (Z) drills nothing</source>
        <translation>钻孔循环没有深度 (Z)：不成孔</translation>
    </message>
    <message>
        <source>a drilling cycle without R starts at the current height</source>
        <translation>钻孔循环没有 R：从当前位置开始</translation>
    </message>
    <message>
        <source>a drilling cycle outside the XY plane is read as one in XY</source>
        <translation>XY 平面之外的钻孔循环按 XY 处理</translation>
    </message>
    <message>
        <source>an arc whose start is not known is ignored</source>
        <translation>忽略了起点未知的圆弧</translation>
    </message>
    <message>
        <source>an arc without a usable center or radius is read as a line</source>
        <translation>没有有效圆心或半径的圆弧按直线处理</translation>
    </message>
    <message>
        <source>an arc whose end is not on its circle is read with a changing radius</source>
        <translation>终点不在圆上的圆弧按变半径处理</translation>
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
        <source>leave this operation out of the simulation</source>
        <translation>模拟时请略去此操作</translation>
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
        <source>move its accuracy slider to the left</source>
        <translation>请将其精度滑块左移</translation>
    </message>
    <message>
        <source>simulate fewer operations at a time</source>
        <translation>请一次模拟较少的操作</translation>
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
        <source>no resolution helps, not even a single pixel fits</source>
        <translation>任何分辨率都无济于事，连一个像素也放不下</translation>
    </message>
    <message>
        <source>the cost is that of a box around its cuts</source>
        <translation>按包围其切削部分的方块计算成本</translation>
    </message>
    <message>
        <source>it does not touch the stock: check its depths, its placement and the stock</source>
        <translation>它没有接触毛坯：请检查其深度、放置和毛坯</translation>
    </message>
    <message>
        <source>its tool is wider than the stock: check the tool&apos;s diameter and the stock</source>
        <translation>其刀具比毛坯宽：请检查刀具直径和毛坯</translation>
    </message>
    <message>
        <source>choose a smaller image in the preferences</source>
        <translation>请在首选项中选择更小的图像</translation>
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
        <source>the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}</source>
        <translation>圆角半径必须在 0 与 {radius:mm} 之间，而不是 {corner:mm}</translation>
    </message>
    <message>
        <source>the tip angle must lie between 0 and pi, not be {angle:g}</source>
        <translation>刀尖角必须在 0 与 π 之间，而不是 {angle:g}</translation>
    </message>
    <message>
        <source>the stock has no volume: its upper corner must exceed its lower corner in x, y and z</source>
        <translation>毛坯没有体积：其上角点在 x、y、z 上必须大于下角点</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} move without a feed rate are not in the time</source>
        <translation>{count:n} 个没有进给速度的动作中的 {length:mm4} 切削未计入时间</translation>
    </message>
    <message>
        <source>{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time</source>
        <translation>{count:n} 个没有进给速度的动作中的 {length:mm4} 切削未计入时间</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} is 0</source>
        <translation>刀具控制器的 {name} 为 0，因此 {length:mm4} 快速移动未计入时间</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the tool controller&apos;s {name} and {other} are 0</source>
        <translation>刀具控制器的 {name} 和 {other} 为 0，因此 {length:mm4} 快速移动未计入时间</translation>
    </message>
    <message>
        <source> and {count:n} more</source>
        <translation>及另外 {count:n} 处</translation>
    </message>
    <message>
        <source>; passes {step:mm3} apart ask for {cell:mm2}</source>
        <translation>；间距 {step:mm3} 的走刀需要 {cell:mm2}</translation>
    </message>
    <message>
        <source>; {cell:mm2} would do for passes {step:mm3} apart</source>
        <translation>；对间距 {step:mm3} 的走刀，{cell:mm2} 已足够</translation>
    </message>
    <message>
        <source>no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}</source>
        <translation>任何分辨率都不行，仅轨迹就需要 {time:s}：请减少模拟的操作{heaviest}</translation>
    </message>
    <message>
        <source>; the heaviest is {label} with {time:s}</source>
        <translation>；最重的是 {label}，{time:s}</translation>
    </message>
    <message>
        <source> and 1 more</source>
        <translation>及另外 1 处</translation>
    </message>
    <message>
        <source>{sentence} (command {command:#})</source>
        <translation>{sentence}（命令 {command:#}）</translation>
    </message>
    <message>
        <source>{sentence} ({count:n} times, first at command {command:#})</source>
        <translation>{sentence}（{count:n} 次，首次在命令 {command:#}）</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored</source>
        <translation>忽略了未知代码 {name}</translation>
    </message>
    <message>
        <source>1 more unknown code is ignored</source>
        <translation>另忽略了 1 个未知代码</translation>
    </message>
    <message>
        <source>{count:n} more unknown codes are ignored</source>
        <translation>另忽略了 {count:n} 个未知代码</translation>
    </message>
    <message>
        <source>the arcs and cycles would need {moves:n} moves at a tolerance of {tolerance:mm}; use a larger tolerance</source>
        <translation>公差为 {tolerance:mm} 时圆弧和循环需要 {moves:n} 次移动；请使用更大的公差</translation>
    </message>
    <message>
        <source>{label}: {sentence}</source>
        <translation>{label}：{sentence}</translation>
    </message>
    <message>
        <source>could not be analyzed, please report it with the file: {error}</source>
        <translation>无法分析，请连同文件一起报告：{error}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在 {count:n} 行{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} rows{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在 {count:n} 行{spread}中保持为 0，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在一段开放笔画{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在 {count:n} 段开放笔画{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one open stroke{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在一段开放笔画{spread}中保持为 0，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over {count:n} open strokes{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在 {count:n} 段开放笔画{spread}中保持为 0，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over one loop{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ 在一个环{spread}中达到 {reached:turns} 圈，{seen}：{strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi reaches {reached:turns} turns over {count:n} loops{spread}, {seen}: {strategy:strategy}{turning}</source>
        <translation>φ 在 {count:n} 个环{spread}中达到 {reached:turns} 圈，{seen}：{strategy:strategy}{turning}</translation>
    </message>
    <message>
        <source>phi lies between {low:turns} and {high:turns} turns, {seen}: {strategy:strategy}</source>
        <translation>φ 在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at one point: {strategy:strategy}</source>
        <translation>φ 没有方向可转，移动在一个点上竖直：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at {count:n} points: {strategy:strategy}</source>
        <translation>φ 没有方向可转，移动在 {count:n} 个点上竖直：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi has no direction to turn, the moves are vertical at some points: {strategy:strategy}</source>
        <translation>φ 没有方向可转，移动在若干点上竖直：{strategy:strategy}</translation>
    </message>
    <message>
        <source>{count:n} sections parted by tool changes, titles, retracts or drilling show {strategies:strategy}: {strategy:strategy}</source>
        <translation>由换刀、标题、退刀或钻孔分开的 {count:n} 段显示 {strategies:strategy}：{strategy:strategy}</translation>
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
        <source>{count:n} bites of one sense overlap</source>
        <translation>{count:n} 次同向切入相互重叠</translation>
    </message>
    <message>
        <source>rows ({rows:%} of the length) and loops ({loops:%}) share the area</source>
        <translation>行（占长度 {rows:%}）与环（{loops:%}）共享区域</translation>
    </message>
    <message>
        <source>{low} to {high}</source>
        <translation>{low} 至 {high}</translation>
    </message>
    <message>
        <source>{what} (line {line:#})</source>
        <translation>{what}（第 {line:#} 行）</translation>
    </message>
    <message>
        <source>{what} ({count:n} times, first in line {line:#})</source>
        <translation>{what}（{count:n} 次，首次在第 {line:#} 行）</translation>
    </message>
    <message>
        <source>lines with a block delete (/) are read like the others</source>
        <translation>带跳段符（/）的行按普通行读取</translation>
    </message>
    <message>
        <source>a subprogram or macro call is not read</source>
        <translation>子程序或宏调用未读取</translation>
    </message>
    <message>
        <source>jumps, loops and calls are not followed</source>
        <translation>不跟随跳转、循环和调用</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the words with them are left out</source>
        <translation>变量和表达式不读取：含有它们的字被略去</translation>
    </message>
    <message>
        <source>lines that are not made of words like G1 X10 are left out</source>
        <translation>不是由 G1 X10 这类字组成的行被略去</translation>
    </message>
    <message>
        <source>coordinates that {name} changes are read as if it were not there</source>
        <translation>{name} 改变的坐标按没有它来读取</translation>
    </message>
    <message>
        <source>a spline ({name}) is read as a line</source>
        <translation>样条（{name}）按直线读取</translation>
    </message>
    <message>
        <source>what follows M2 or M30 is read as the same program</source>
        <translation>M2 或 M30 之后的内容按同一程序读取</translation>
    </message>
    <message>
        <source>what follows the program&apos;s end is not read</source>
        <translation>程序结束之后的内容不读取</translation>
    </message>
    <message>
        <source>a program in the language of {name} controls (line {line:#}): post it as G-code (ISO) to have it read</source>
        <translation>{name} 控制系统语言的程序（第 {line:#} 行）：请以 G 代码（ISO）输出后再读取</translation>
    </message>
    <message>
        <source>not an NC program: {part:n} of its {lines:n} lines are not made of words like G1 X10, the first is line {line:#}</source>
        <translation>不是 NC 程序：{lines:n} 行中有 {part:n} 行不是由 G1 X10 这类字组成，第一处是第 {line:#} 行</translation>
    </message>
    <message>
        <source>not an NC program: no line of it moves a tool</source>
        <translation>不是 NC 程序：没有一行移动刀具</translation>
    </message>
    <message>
        <source>none of its moves can be read: {problems}</source>
        <translation>其中没有可读取的运动：{problems}</translation>
    </message>
    <message>
        <source>not an NC program: it is not text</source>
        <translation>不是 NC 程序：它不是文本</translation>
    </message>
    <message>
        <source>a program for a lathe ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>车床程序（{name}，第 {line:#} 行）：铣削策略对它不适用</translation>
    </message>
    <message>
        <source>a program for a 3D printer ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>3D 打印机程序（{name}，第 {line:#} 行）：铣削策略对它不适用</translation>
    </message>
    <message>
        <source>a program for a wire cutter ({name}, line {line:#}): milling strategies say nothing about it</source>
        <translation>线切割程序（{name}，第 {line:#} 行）：铣削策略对它不适用</translation>
    </message>
    <message>
        <source>a rotary axis turns while the tool cuts (line {line:#}): the path of the tool cannot be told</source>
        <translation>切削时旋转轴在转动（第 {line:#} 行）：无法得知刀具的路径</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time: a program does not say how fast they are</source>
        <translation>{length:mm4} 的快速移动未计入时间：程序未说明其速度</translation>
    </message>
    <message>
        <source>no tool: the program does not say its diameter, so the cost is not known</source>
        <translation>没有刀具：程序未说明其直径，因此代价未知</translation>
    </message>
    <message>
        <source>the file cannot be read: {name}</source>
        <translation>无法读取文件：{name}</translation>
    </message>
    <message>
        <source>the file is larger than {size:bytes}</source>
        <translation>文件大于 {size:bytes}</translation>
    </message>
    <message>
        <source>given up after {time:s}</source>
        <translation>{time:s} 后放弃</translation>
    </message>
    <message>
        <source>the process that read it died, perhaps for lack of memory</source>
        <translation>读取它的进程已终止，可能是内存不足</translation>
    </message>
    <message>
        <source>it looks 25.4 times too small: inches read as millimeters?</source>
        <translation>看起来小了 25.4 倍：是否把英寸读成了毫米？</translation>
    </message>
    <message>
        <source>there is nothing to simulate: choose a job, or operations with a toolpath</source>
        <translation>没有可模拟的内容：请选择一个作业，或带有刀具路径的操作</translation>
    </message>
    <message>
        <source>these operations belong to several jobs, choose one of them: {labels}</source>
        <translation>这些操作属于多个作业，请选择其中一个：{labels}</translation>
    </message>
    <message>
        <source>extended z-buffer</source>
        <translation>扩展 Z-buffer</translation>
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
        <source>The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}.</source>
        <translation>{simulator:simulator}会卡在{reason}的圆弧上（命令 {command:#}{others}）：{instead}。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>{simulator:simulator}以错误深度切削 {count:n} 处斜坡，最多 {error:mm2} {way}（命令 {command:#}）：不要据此判断深度。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command {command:#}): do not judge depths by it.</source>
        <translation>{simulator:simulator}以错误深度切削 {count:n} 处斜坡，最多 {error:mm2} {way}（命令 {command:#}）：不要据此判断深度。</translation>
    </message>
    <message>
        <source>Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.</source>
        <translation>在{simulator:simulator}中播放约需 {longer:s}：快进约需 {time:s}。</translation>
    </message>
    <message>
        <source>Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.</source>
        <translation>在 {simulator:simulator}中以最快速度播放约需 {time:s}：请一次模拟较少的操作。</translation>
    </message>
    <message>
        <source>{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time and none is seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>{count:n} 次移动短于{simulator:simulator}的一个单元（{cell:mm2}），每次都耗时却无法单独看出：对操作使用更粗的公差在此毫无损失。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>{simulator:simulator}此操作约需 {memory:bytes}，超过允许的 {allowed:bytes}：{instead}。</translation>
    </message>
    <message>
        <source>use the {simulator:simulator} for this operation</source>
        <translation>请对此操作使用 {simulator:simulator}</translation>
    </message>
    <message>
        <source>the tool&apos;s diameter must be a positive number of at most a kilometer, not {diameter:mm}</source>
        <translation>刀具直径必须为正数且不超过一千米，而不是 {diameter:mm}</translation>
    </message>
    <message>
        <source>the stock&apos;s corners must be numbers within a kilometer of the origin</source>
        <translation>毛坯的角点必须是距原点一千米以内的数</translation>
    </message>
    <message>
        <source>its feeds, up to {feed:g} mm/s, are taken for mm/min: FreeCAD&apos;s importer keeps them as mm/s</source>
        <translation>其进给速度（最高 {feed:g} mm/s）按 mm/min 读取：FreeCAD 导入时将其保留为 mm/s</translation>
    </message>
    <message>
        <source>the tip&apos;s diameter must lie between 0 and {diameter:mm}, not be {tip:mm}</source>
        <translation>刀尖直径必须在 0 和 {diameter:mm} 之间，而不是 {tip:mm}</translation>
    </message>
    <message>
        <source>the solid&apos;s surface is not closed</source>
        <translation>实体的表面不封闭</translation>
    </message>
    <message>
        <source>the box around the stock of {label} is taken for it: {sentence}</source>
        <translation>{label} 的毛坯按其外接长方体计算：{sentence}</translation>
    </message>
    <message>
        <source>{label} is not simulated exactly, but {instead}</source>
        <translation>{label} 不是精确模拟，而是{instead}</translation>
    </message>
    <message>
        <source>as an end mill of its largest diameter</source>
        <translation>按其最大直径的平底立铣刀模拟</translation>
    </message>
    <message>
        <source>as a ball end of its tip&apos;s diameter</source>
        <translation>按刀尖直径的球头铣刀模拟</translation>
    </message>
    <message>
        <source>as a drill</source>
        <translation>按钻头模拟</translation>
    </message>
    <message>
        <source>a rotary axis ({letter}) turns while the tool cuts: the path of the tool cannot be told</source>
        <translation>切削时旋转轴（{letter}）在转动：无法确定刀具的路径</translation>
    </message>
    <message>
        <source>turns of a rotary axis ({letter}) are not followed</source>
        <translation>不跟随旋转轴（{letter}）的转动</translation>
    </message>
    <message>
        <source>{letter} words are not read</source>
        <translation>不读取 {letter} 字</translation>
    </message>
    <message>
        <source>a cycle&apos;s repeats ({letter}) are not made</source>
        <translation>不执行循环的重复（{letter}）</translation>
    </message>
    <message>
        <source>further turns of an arc (P) are not made</source>
        <translation>不执行圆弧的附加圈数（P）</translation>
    </message>
    <message>
        <source>inches (G20) are not followed: lengths are read in mm</source>
        <translation>不处理英寸（G20）：长度按 mm 读取</translation>
    </message>
    <message>
        <source>cutter compensation ({name}) is not followed: the path is the programmed one</source>
        <translation>不处理刀具半径补偿（{name}）：路径按程序读取</translation>
    </message>
    <message>
        <source>feeds after {name} are not read</source>
        <translation>不读取 {name} 之后的进给</translation>
    </message>
    <message>
        <source>dwells are not in the time</source>
        <translation>时间不包括暂停</translation>
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
        <source>{count:n} row{spread}, {seen}</source>
        <translation>{count:n} 行{spread}，{seen}</translation>
    </message>
    <message>
        <source>{count:n} rows{spread}, {seen}</source>
        <translation>{count:n} 行{spread}，{seen}</translation>
    </message>
    <message>
        <source>one open cut{spread}, {seen}</source>
        <translation>一条开放切削{spread}，{seen}</translation>
    </message>
    <message>
        <source>{count:n} open cuts{spread}, {seen}</source>
        <translation>{count:n} 条开放切削{spread}，{seen}</translation>
    </message>
    <message>
        <source>one loop{spread}{turning}, {seen}</source>
        <translation>一圈{spread}{turning}，{seen}</translation>
    </message>
    <message>
        <source>{count:n} loops{spread}{turning}, {seen}</source>
        <translation>{count:n} 圈{spread}{turning}，{seen}</translation>
    </message>
    <message>
        <source>straight down at one point</source>
        <translation>在一点垂直向下</translation>
    </message>
    <message>
        <source>straight down at {count:n} points</source>
        <translation>在 {count:n} 点垂直向下</translation>
    </message>
    <message>
        <source>straight down at some points</source>
        <translation>在一些点垂直向下</translation>
    </message>
    <message>
        <source>{count:n} sections, parted by tool changes, titles, retracts or drilling: {strategies:strategy}</source>
        <translation>{count:n} 段，由换刀、标题、退刀或钻孔分开：{strategies:strategy}</translation>
    </message>
    <message>
        <source>{count:n} overlapping bites</source>
        <translation>{count:n} 次相互重叠的切入</translation>
    </message>
    <message>
        <source>one clockwise, the next counter-clockwise</source>
        <translation>一圈顺时针，下一圈逆时针</translation>
    </message>
    <message>
        <source>all in one cut that winds on and never closes</source>
        <translation>全部由一条不断盘绕而不闭合的切削构成</translation>
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
        <source>cut to and fro</source>
        <translation>来回切削</translation>
    </message>
    <message>
        <source>all cut the same way</source>
        <translation>都按同一方向切削</translation>
    </message>
    <message>
        <source>phi stays between {low:turns} and {high:turns} turns over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在一行{spread}中保持在 {low:turns} 与 {high:turns} 圈之间，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>phi stays at 0 over one row{spread}, {seen}: {strategy:strategy}</source>
        <translation>φ 在一行{spread}中保持为 0，{seen}：{strategy:strategy}</translation>
    </message>
    <message>
        <source>One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen by itself: a coarser tolerance of the operation loses nothing there.</source>
        <translation>有 1 个移动短于{simulator:simulator}的一个单元（{cell:mm2}），既耗时又看不出来：放宽操作的公差在此没有损失。</translation>
    </message>
    <message>
        <source>which lie like those of known toolpaths ({share:%} of the votes)</source>
        <translation>其排布与已知刀具路径相似（{share:%} 的投票）</translation>
    </message>
    <message>
        <source>unlike anything that machines ({share:%} of the votes)</source>
        <translation>与任何加工都不相似（{share:%} 的投票）</translation>
    </message>
    <message>
        <source>, entered by a ramp</source>
        <translation>，斜线切入</translation>
    </message>
    <message>
        <source>, entered by a ramp to and fro</source>
        <translation>，往复斜线切入</translation>
    </message>
    <message>
        <source>, entered by a helix</source>
        <translation>，螺旋切入</translation>
    </message>
    <message>
        <source>, finished by a contour around the rows</source>
        <translation>，并绕各行作一圈轮廓精加工</translation>
    </message>
    <message>
        <source>The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.</source>
        <translation>{simulator:simulator}会在此卡死：{label} 的命令 {command:#}{others}是{reason}的圆弧。</translation>
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
        <source>Playing this takes {bound} {time:s} in the {simulator:simulator}.</source>
        <translation>{simulator:simulator}：播放需要{bound} {time:s}。</translation>
    </message>
    <message>
        <source>Fast-forward takes {bound} {time:s}.</source>
        <translation>快进需要{bound} {time:s}。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} in fast-forward: {bound} {time:s}.</source>
        <translation>{simulator:simulator}快进：{bound} {time:s}。</translation>
    </message>
    <message>
        <source>The {simulator:simulator}: {bound} {time:s}.</source>
        <translation>{simulator:simulator}：{bound} {time:s}。</translation>
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
        <source>Simulate toolpaths shows the finished part at once, coarse at first.</source>
        <translation>“模拟刀具路径”立即显示成品零件，先粗后细。</translation>
    </message>
    <message>
        <source>a rapid move removes {volume:mm³2}</source>
        <translation>快速移动去除了 {volume:mm³2} 材料</translation>
    </message>
    <message>
        <source>plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}</source>
        <translation>以 {feed:mm/min3} 向实体材料下刀，其刀具允许 {allowed:mm/min3}</translation>
    </message>
    <message>
        <source>{depth:mm2} are left on the model</source>
        <translation>模型上残留 {depth:mm2}</translation>
    </message>
    <message>
        <source>a finer picture would take longer than the {allowed:s} that the preferences allow</source>
        <translation>更精细的图像所需时间将超过首选项允许的 {allowed:s}</translation>
    </message>
    <message>
        <source>as simulated, command {command:#} is wrong: {fault}</source>
        <translation>模拟显示命令 {command:#} 有误：{fault}</translation>
    </message>
    <message>
        <source>moves in X and Z only, with passes along Z at many X, as a lathe makes them: {strategy:strategy}</source>
        <translation>只在 X 和 Z 方向运动，并在许多 X 处沿 Z 走刀，与车床的走刀相同：{strategy:strategy}</translation>
    </message>
    <message>
        <source>the operation&apos;s placement must be numbers within a kilometer of the origin</source>
        <translation>操作的放置必须是距原点一千米以内的数</translation>
    </message>
    <message>
        <source>a line with two {letter} words: the last one is read</source>
        <translation>一行中有两个 {letter} 字：读取最后一个</translation>
    </message>
    <message>
        <source>a line with two motions, such as G0 and G1: the last one is read</source>
        <translation>一行中有两个运动指令（如 G0 和 G1）：读取最后一个</translation>
    </message>
    <message>
        <source>{told}, with a little {strategies:strategy} beside it</source>
        <translation>{told}，另有少量{strategies:strategy}</translation>
    </message>
    <message>
        <source>{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}</source>
        <translation>{width:n} × {height:n} 像素，每个 {pixel:mm2}，受{limit}限制{passes}</translation>
    </message>
    <message>
        <source>{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds</source>
        <translation>操作没有刀具控制器，因此 {length:mm4} 快速移动未计入时间：请为其指定一个带有快速移动速度的刀具控制器</translation>
    </message>
    <message>
        <source>variables and expressions are not read: the lines with them are left out</source>
        <translation>变量和表达式不读取：含有它们的行被略去</translation>
    </message>
    <message>
        <source>moves to positions of the machine ({name}) are left out: a program does not say where they are</source>
        <translation>略去到机床位置的移动（{name}）：程序未说明这些位置在何处</translation>
    </message>
    <message>
        <source>the holes of a pattern ({name}) are not made</source>
        <translation>不执行孔阵列的孔（{name}）</translation>
    </message>
    <message>
        <source>it spans meters in whole numbers: thousandths without a decimal point read as whole units?</source>
        <translation>全为整数且跨越数米：是否把没有小数点的千分之一读成了整单位？</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: simulate this operation alone.</source>
        <translation>{simulator:simulator}最后每幅画面约需 {time:s}，其中 {percent:n}% 用于圆弧：请单独模拟此操作。</translation>
    </message>
    <message>
        <source>The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}</source>
        <translation>{simulator:simulator}需要{bound} {time:s}，超过允许的 {allowed:s}。{better}</translation>
    </message>
    <message>
        <source>the centers of arcs are read as positions (as by G90.1): only so the arcs end on their circles</source>
        <translation>圆弧的圆心按坐标读取（同 G90.1）：只有这样圆弧的终点才在其圆上</translation>
    </message>
    <message>
        <source>strokes that rise to their ends, as V-carving does</source>
        <translation>笔画在末端抬升，如同 V 形雕刻</translation>
    </message>
    <message>
        <source>cut in strokes, as between tags</source>
        <translation>分段切削，如同固定桥之间</translation>
    </message>
    <message>
        <source>the unknown code {name} is ignored, and with it the {letters} words of its line</source>
        <translation>忽略了未知代码 {name}，以及该行的 {letters} 字</translation>
    </message>
    <message>
        <source>probing moves are not in the time</source>
        <translation>时间不包括探测移动</translation>
    </message>
    <message>
        <source>cuts {depth:mm2} into the model</source>
        <translation>切入模型 {depth:mm2}</translation>
    </message>
    <message>
        <source>as simulated, {count:n} commands are wrong, among them {command:#}: {fault}</source>
        <translation>模拟显示 {count:n} 条命令有误，其中有 {command:#}：{fault}</translation>
    </message>
    <message>
        <source>called {name}, but its toolpath is {strategy:strategy}</source>
        <translation>名为 {name}，但其刀具路径是：{strategy:strategy}</translation>
    </message>
    <message>
        <source>not an NC program, but a zip archive: unpack it first</source>
        <translation>不是 NC 程序，而是 zip 压缩包：请先解压</translation>
    </message>
    <message>
        <source>not an NC program, but a FreeCAD document: analyze it in FreeCAD, a folder of them with the macro examples/macros/folder_to_csv.py</source>
        <translation>不是 NC 程序，而是 FreeCAD 文档：请在 FreeCAD 中分析；整个文件夹可用宏 examples/macros/folder_to_csv.py</translation>
    </message>
    <message>
        <source>lacks {depth:mm2} of the model: choose a larger stock, or move the model within it</source>
        <translation>比模型缺少 {depth:mm2}：请选择更大的毛坯，或移动其中的模型</translation>
    </message>
    <message>
        <source>switched off: it has no toolpath until you switch it on and recompute it</source>
        <translation>已停用：启用并重新计算后才有刀具路径</translation>
    </message>
    <message>
        <source>this is no file, but a pipe or a device</source>
        <translation>这不是文件，而是管道或设备</translation>
    </message>
    <message>
        <source>it does not touch the stock, which is the finished part: choose a block around it as the stock</source>
        <translation>它没有接触毛坯，毛坯已是成品零件：请选择包围它的坯料块作为毛坯</translation>
    </message>
    <message>
        <source>The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of traces, more than the {allowed:bytes} allowed: {instead}.</source>
        <translation>该模拟峰值约占用 {memory:bytes}（{dexels:n} 个 dexel 和 {traces:n} 个轨迹痕迹元素），超过允许的 {allowed:bytes}：{instead}。</translation>
    </message>
    <message>
        <source>choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations</source>
        <translation>请选择 {width:n} × {height:n} 像素、每个 {pixel:mm2} 的图像，或减少模拟的操作</translation>
    </message>
</context>
<context>
    <name>Strategy</name>
    <message>
        <source>zigzag</source>
        <extracomment>No strategy, or several.</extracomment>
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
    <name>VkPreferences</name>
    <message>
        <source>Calibrate</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Never calibrated on this computer: times of FreeCAD&apos;s simulators are right within a factor of two.</source>
        <translation>尚未在此计算机上校准：FreeCAD 模拟器的时间误差在两倍以内。</translation>
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
        <source>Time and memory of</source>
        <translation>显示其时间和内存</translation>
    </message>
    <message>
        <source>Shows the marks as colored pills in the tree; as plain text if switched off.</source>
        <translation>在树中以彩色标签显示标记；关闭后显示为纯文本。</translation>
    </message>
    <message>
        <source>Show marks as pills</source>
        <translation>以标签显示标记</translation>
    </message>
    <message>
        <source>Analyzes marked operations again after each recompute that changed them. Large toolpaths make each recompute longer.</source>
        <translation>每次重新计算改变了已标记的操作后，重新分析它们。刀具路径很大时，每次重新计算会更久。</translation>
    </message>
    <message>
        <source>Analyze again after a recompute</source>
        <translation>重新计算后再次分析</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>限额</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>How long a simulation may take. The analysis warns of more, and recommends an accuracy that takes no longer.</source>
        <translation>模拟允许花费的时间。超出时分析会警告，并推荐不超时的精度。</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>内存</translation>
    </message>
    <message>
        <source>How much memory a simulation may take. The analysis warns of more, and recommends an accuracy that takes no more.</source>
        <translation>模拟允许占用的内存。超出时分析会警告，并推荐不超限的精度。</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Z-buffer image width</source>
        <translation>Z 缓冲图像宽度</translation>
    </message>
    <message>
        <source>Width of the image whose pixels the extended z-buffer computes.</source>
        <translation>扩展 Z 缓冲所计算图像的宽度。</translation>
    </message>
    <message>
        <source>Z-buffer image height</source>
        <translation>Z 缓冲图像高度</translation>
    </message>
    <message>
        <source>Height of the image whose pixels the extended z-buffer computes.</source>
        <translation>扩展 Z 缓冲所计算图像的高度。</translation>
    </message>
    <message>
        <source>Z-buffer view</source>
        <translation>Z 缓冲视图</translation>
    </message>
    <message>
        <source>Where the z-buffer looks at the part from.</source>
        <translation>Z 缓冲从哪个方向观察工件。</translation>
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
        <source>Edge of its cells in percent of the stock&apos;s longer side: 0.1 is the finest position of its slider, 1 the coarsest.</source>
        <translation>单元边长占毛坯长边的百分比：0.1 是其滑块最精细的位置，1 最粗。</translation>
    </message>
    <message>
        <source>Position of its quality slider; 10 is the best.</source>
        <translation>其质量滑块的位置；10 为最佳。</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>圆弧公差</translation>
    </message>
    <message>
        <source>Largest distance between an arc and the straight moves it is chopped into.</source>
        <translation>圆弧与其分段后的直线移动之间的最大距离。</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Measures how fast FreeCAD&apos;s simulators are on this computer, which takes about a second, and remembers it.</source>
        <translation>用大约一秒测量 FreeCAD 模拟器在此计算机上的速度，并记住结果。</translation>
    </message>
    <message>
        <source>That of FreeCAD&apos;s button: {simulator}</source>
        <translation>FreeCAD 按钮的模拟器：{simulator}</translation>
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
        <source>The simulator whose time the marks show. They follow at once.</source>
        <translation>标记显示哪个模拟器的时间。标记立即随之更新。</translation>
    </message>
    <message>
        <source>Says over the view, when one of FreeCAD&apos;s simulators is started, that it would hang or take longer than the budget, and offers the better way.</source>
        <translation>启动 FreeCAD 的模拟器时，若会卡死或超出限额，则在视图上方提示，并提供更好的方式。</translation>
    </message>
    <message>
        <source>Warn of simulators that hang or take too long</source>
        <translation>模拟器会卡死或耗时过长时警告</translation>
    </message>
    <message>
        <source>Last calibrated on {date}: times of the {simulator} are right within a factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display {renderer}.</source>
        <translation>上次校准于 {date}：{simulator}的时间误差在 {factor} 倍以内。测量环境：FreeCAD {freecad}，{processor}，显示 {renderer}。</translation>
    </message>
</context>
<context>
    <name>Vk_Analyze</name>
    <message>
        <source>Recognizes the machining strategy of each selected operation, or of all operations of the active document, estimates what simulating it costs, and marks it in the tree.</source>
        <translation>识别所选操作（或活动文档所有操作）的加工策略，估计模拟的开销，并在树中标记。</translation>
    </message>
    <message>
        <source>Analyze toolpaths</source>
        <translation>分析刀具路径</translation>
    </message>
    <message>
        <source>No document is open. Open one with a job or a toolpath first.</source>
        <translation>没有打开的文档。请先打开含有作业或刀具路径的文档。</translation>
    </message>
    <message>
        <source>Analysis cancelled, nothing changed.</source>
        <translation>分析已取消，未作任何更改。</translation>
    </message>
    <message>
        <source>There is no operation to analyze in this document. Create a job with operations, or import G-code.</source>
        <translation>此文档中没有可分析的操作。请创建带有操作的作业，或导入 G 代码。</translation>
    </message>
    <message>
        <source>The marks are in the tree&apos;s Description column, which is now visible. You can hide it again in the tree&apos;s context menu: Tree settings, Show description.</source>
        <translation>标记位于树的“描述”列，该列现已显示。可在树的右键菜单中再次隐藏：树设置，显示描述。</translation>
    </message>
    <message>
        <source>Toolpath analysis</source>
        <translation>刀具路径分析</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>{count} operation analyzed</source>
        <translation>已分析 {count} 个操作</translation>
    </message>
    <message>
        <source>{count} operations analyzed</source>
        <translation>已分析 {count} 个操作</translation>
    </message>
    <message>
        <source>{count} has a warning</source>
        <translation>{count} 个有警告</translation>
    </message>
    <message>
        <source>{count} have warnings</source>
        <translation>{count} 个有警告</translation>
    </message>
    <message>
        <source>Measuring how fast this computer simulates…</source>
        <translation>正在测量本机的模拟速度…</translation>
    </message>
</context>
<context>
    <name>Vk_Clear</name>
    <message>
        <source>Removes the marks of the selected operations, or all marks of the active document; your own descriptions stay.</source>
        <translation>移除所选操作的标记，或活动文档的所有标记；您自己的描述会保留。</translation>
    </message>
    <message>
        <source>Clear analysis</source>
        <translation>清除分析</translation>
    </message>
    <message>
        <source>{count} mark removed</source>
        <translation>已移除 {count} 个标记</translation>
    </message>
    <message>
        <source>{count} marks removed</source>
        <translation>已移除 {count} 个标记</translation>
    </message>
</context>
<context>
    <name>Vk_GaussMap</name>
    <message>
        <source>Gauss map</source>
        <translation>高斯映射</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>保存图片…</translation>
    </message>
    <message>
        <source>Saves the three plots as they stand, as PNG or SVG.</source>
        <translation>将当前三幅图保存为 PNG 或 SVG。</translation>
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
        <source>Save picture</source>
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
        <source>Shows why the selected operation has its strategy: its toolpath, the Gauss map of its directions and of the vector V_k, and the cumulative angular function.</source>
        <translation>显示所选操作为何被判定为其策略：刀具路径、方向和向量 V_k 的高斯映射，以及累积角函数。</translation>
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
        <source>with the closing turn φ = {}, n = {}</source>
        <translation>加上闭合转角 φ = {}，n = {}</translation>
    </message>
    <message>
        <source>The areas that the tool cuts without a rapid move or a plunge: first the one that shows the strategy best, then the longest.</source>
        <translation>刀具在没有快速移动或下刀的情况下切削的区域：首先是最能体现策略的区域，然后是最长的区域。</translation>
    </message>
    <message>
        <source>&lt;p&gt;The wheel zooms, dragging moves, a double click shows all again.&lt;/p&gt;</source>
        <translation>&lt;p&gt;滚轮缩放，拖动平移，双击恢复全部显示。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>{}: no move cuts sideways, so there is no direction to show</source>
        <translation>{}：没有横向切削的移动，因此没有方向可显示</translation>
    </message>
    <message>
        <source>&lt;p&gt;Left the toolpath with the vector V&lt;sub&gt;k&lt;/sub&gt; from the area&apos;s first point. On the unit circle the images of the trajectory v&lt;sub&gt;k&lt;/sub&gt; and of V&lt;sub&gt;k&lt;/sub&gt;; the arcs show how they moved. That of v&lt;sub&gt;k&lt;/sub&gt; goes to and fro on a part of the circle in a zigzag, and all around in a contour; that of V&lt;sub&gt;k&lt;/sub&gt; goes all around only where the path begins inside the contour. Right the cumulative angular function φ and the angle θ on level n: a contour-parallel path reaches the dashed lines ±2π, a zigzag stays between them.&lt;/p&gt;</source>
        <translation>&lt;p&gt;左侧是刀具路径以及从区域起点出发的向量 V&lt;sub&gt;k&lt;/sub&gt;。单位圆上是轨迹 v&lt;sub&gt;k&lt;/sub&gt; 和 V&lt;sub&gt;k&lt;/sub&gt; 的像；圆弧显示它们如何移动。v&lt;sub&gt;k&lt;/sub&gt; 的像在往复路径中于圆的一部分上来回，在轮廓路径中绕圆一周；V&lt;sub&gt;k&lt;/sub&gt; 的像只有当路径从轮廓内部开始时才绕圆一周。右侧是累积角函数 φ 和层级 n 上的角 θ：环切路径达到虚线 ±2π，往复路径保持在其间。&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>Vk_Results</name>
    <message>
        <source>Toolpath results</source>
        <translation>刀具路径结果</translation>
    </message>
    <message>
        <source>Nothing is analyzed yet in this document: click Analyze toolpaths.</source>
        <translation>此文档尚未分析：请点击“分析刀具路径”。</translation>
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
        <source>The machining strategy recognized from the toolpath alone</source>
        <translation>仅由刀具路径识别出的加工策略</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>把握</translation>
    </message>
    <message>
        <source>How sure the recognition is</source>
        <translation>识别的把握程度</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Length of the cutting moves</source>
        <translation>切削移动的长度</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s OpenGL simulator at its highest speed</source>
        <extracomment>FreeCAD&apos;s newer one, which draws the cuts of all operations before with every operation.</extracomment>
        <translation>FreeCAD OpenGL 模拟器以最高速度所需的时间</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s OpenGL simulator</source>
        <translation>FreeCAD OpenGL 模拟器的内存</translation>
    </message>
    <message>
        <source>What is wrong with the operation, or will be with its simulation</source>
        <translation>操作存在的问题，或模拟时将出现的问题</translation>
    </message>
    <message>
        <source>Time of FreeCAD&apos;s legacy simulator in fast-forward, at the accuracy set in the preferences</source>
        <extracomment>FreeCAD&apos;s older one.</extracomment>
        <translation>FreeCAD 旧版模拟器以首选项中的精度快进所需的时间</translation>
    </message>
    <message>
        <source>Memory of FreeCAD&apos;s legacy simulator, at the accuracy set in the preferences</source>
        <translation>FreeCAD 旧版模拟器在首选项精度下的内存</translation>
    </message>
    <message>
        <source>Recommended image: {}</source>
        <translation>推荐图像：{}</translation>
    </message>
    <message>
        <source>Recommended
image</source>
        <translation>推荐
图像</translation>
    </message>
    <message>
        <source>The finest image of the z-buffer within the budgets of the preferences</source>
        <translation>在首选项限额内最精细的 Z 缓冲图像</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Machining
time</source>
        <translation>加工
时间</translation>
    </message>
    <message>
        <source>Time on the machine at the programmed feeds; rapids where the tool controller gives their speed</source>
        <translation>按编程进给在机床上的时间；刀具控制器给出速度时包括快速移动</translation>
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
        <source>C&amp;opy to clipboard</source>
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
        <source>Sort as &amp;posted</source>
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
time</source>
        <translation>模拟
时间</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since; analyze it again</source>
        <translation>已过期：刀具路径、刀具或毛坯此后已更改；请重新分析</translation>
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
        <source>Number of straight moves; an arc counts as several</source>
        <translation>直线移动的数量；一段圆弧算作多个</translation>
    </message>
    <message>
        <source>{simulator}
time</source>
        <translation>{simulator}
时间</translation>
    </message>
    <message>
        <source>{simulator}
memory</source>
        <translation>{simulator}
内存</translation>
    </message>
    <message>
        <source>Shows the analyzed operations: strategy, machining and simulation time, and what is wrong with them.</source>
        <translation>显示已分析的操作：策略、加工和模拟时间，以及存在的问题。</translation>
    </message>
    <message>
        <source>Outdated: toolpath, tool or stock have changed since. Analyze it again.</source>
        <translation>已过期：刀具路径、刀具或毛坯此后已更改。请重新分析。</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>所有数值</translation>
    </message>
    <message>
        <source>Fewer numbers</source>
        <translation>较少数值</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>为什么？</translation>
    </message>
    <message>
        <source>Sure: {share}</source>
        <translation>把握：{share}</translation>
    </message>
    <message>
        <source>Show it in the Gauss map</source>
        <translation>在高斯图中显示</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>切削</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>快速移动</translation>
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
        <source>Shows operations with this text in name, strategy or warnings</source>
        <translation>显示名称、策略或警告中含有此文字的操作</translation>
    </message>
    <message>
        <source>Shows operations of this strategy</source>
        <translation>显示此策略的操作</translation>
    </message>
    <message>
        <source>&amp;Warnings only</source>
        <translation>仅警告(&amp;W)</translation>
    </message>
    <message>
        <source>Shows operations with warnings, and outdated ones</source>
        <translation>显示有警告的和已过期的操作</translation>
    </message>
    <message>
        <source>All strategies</source>
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
        <source>the total of what was analyzed, not of the whole job</source>
        <translation>仅为已分析部分的合计，并非整个作业</translation>
    </message>
    <message>
        <source>How long the {simulator} takes, as the marks show it</source>
        <translation>{simulator}所需时间，与标记所示一致</translation>
    </message>
    <message>
        <source>The longest that the {simulator} should take: its estimate times the factor by which estimates are off</source>
        <translation>{simulator}最长需要的时间：估计值乘以估计的偏差倍数</translation>
    </message>
    <message>
        <source>Simulation time
at most</source>
        <translation>模拟时间
最长</translation>
    </message>
    <message>
        <source>Time to simulate it in an extended z-buffer: an operation alone, on the whole stock; a job one operation after another, each on what is left</source>
        <extracomment>The paper&apos;s; its columns in CSV and JSON have no prefix.</extracomment>
        <translation>在扩展 Z 缓冲中模拟所需的时间：单个工序按完整毛坯单独计算；作业按工序依次进行，每道工序只加工剩余材料</translation>
    </message>
    <message>
        <source>Memory to simulate it in an extended z-buffer: of an operation alone, with the whole stock; of a job with the stock once</source>
        <translation>在扩展 Z 缓冲中模拟所需的内存：单个工序包含完整毛坯；作业中毛坯只计一次</translation>
    </message>
    <message>
        <source>not in the total: its dress-up is counted instead</source>
        <translation>不计入总和：由其修饰代替计入</translation>
    </message>
    <message>
        <source>not in the total: it is switched off</source>
        <translation>不计入总和：已停用</translation>
    </message>
    <message>
        <source>Shortest move at feed</source>
        <translation>最短的进给移动</translation>
    </message>
    <message>
        <source>Median move at feed</source>
        <translation>进给移动的中位长度</translation>
    </message>
    <message>
        <source>The filter lets no operation through.</source>
        <translation>没有符合筛选条件的操作。</translation>
    </message>
</context>
<context>
    <name>Vk_Simulate</name>
    <message>
        <source>raw</source>
        <translation>毛坯面</translation>
    </message>
    <message>
        <source>machined</source>
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
        <source>Removal rate</source>
        <translation>材料去除率</translation>
    </message>
    <message>
        <source>Simulates the selected job or operations, or the job of the active document, and shows the part at any moment, what made each of its surfaces, and rapid moves that cut.</source>
        <translation>模拟所选作业或操作（否则为当前文档的作业），显示任意时刻的工件、每个表面由什么加工而成，以及会切到材料的快速移动。</translation>
    </message>
    <message>
        <source>Simulate toolpaths</source>
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
        <source>Folder of the Pictures</source>
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
        <source>Simulated part</source>
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
        <source>As the 3D view</source>
        <translation>与三维视图相同</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Where the part is seen from.</source>
        <translation>观察工件的方向。</translation>
    </message>
    <message>
        <source>What the surfaces are colored by.</source>
        <translation>表面着色的依据。</translation>
    </message>
    <message>
        <source>What the operation of this moment removes, alone or on the part.</source>
        <translation>此刻的操作所去除的材料，单独显示或显示在工件上。</translation>
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
        <source>Part and chips</source>
        <translation>工件和切屑</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save what is shown.</source>
        <translation>保存所显示的内容。</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>图片…</translation>
    </message>
    <message>
        <source>Pictures of the whole job…</source>
        <translation>整个作业的图片…</translation>
    </message>
    <message>
        <source>Removal rates…</source>
        <translation>去除率…</translation>
    </message>
    <message>
        <source>Play or pause (Space).</source>
        <translation>播放或暂停（空格键）。</translation>
    </message>
    <message>
        <source>How many times as fast as the machine.</source>
        <translation>比机床快多少倍。</translation>
    </message>
    <message>
        <source>Job in {}</source>
        <translation>{}内完成</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>To the beginning of the operation.</source>
        <translation>到操作开头。</translation>
    </message>
    <message>
        <source>Back by one command of the program.</source>
        <translation>后退一条程序指令。</translation>
    </message>
    <message>
        <source>Back by one trajectory.</source>
        <translation>后退一个运动。</translation>
    </message>
    <message>
        <source>Forward by one trajectory.</source>
        <translation>前进一个运动。</translation>
    </message>
    <message>
        <source>Forward by one command of the program.</source>
        <translation>前进一条程序指令。</translation>
    </message>
    <message>
        <source>To the end of the operation.</source>
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
        <source>finest picture in about {}, {}</source>
        <translation>最精细的图片约需 {}，{}</translation>
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
        <source>This surface is the raw stock&apos;s.</source>
        <translation>这是毛坯本身的表面。</translation>
    </message>
    <message>
        <source>Time line</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Reading {} ({} of {})…</source>
        <translation>正在读取 {}（{}/{}）…</translation>
    </message>
    <message>
        <source>there is no closed model</source>
        <translation>没有封闭的模型</translation>
    </message>
    <message>
        <source>gouged by {} to {}</source>
        <translation>过切 {} 至 {}</translation>
    </message>
    <message>
        <source>left, {} to {}</source>
        <translation>残留 {} 至 {}</translation>
    </message>
    <message>
        <source>as the model</source>
        <translation>与模型一致</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>无模型</translation>
    </message>
    <message>
        <source>Difference to the model</source>
        <translation>与模型的差异</translation>
    </message>
    <message>
        <source>Smaller differences to the model do not count.</source>
        <translation>不超过此值的差异不计。</translation>
    </message>
    <message>
        <source>Worst places</source>
        <translation>最差位置</translation>
    </message>
    <message>
        <source>Where the part differs most from the model. Choose a place to see it.</source>
        <translation>零件与模型差异最大的地方。选择一处即可查看。</translation>
    </message>
    <message>
        <source>Crashes, gouges and fast plunges of the simulation. Choose one to see it.</source>
        <translation>模拟中的碰撞、过切和过快的下刀。选择一项即可查看。</translation>
    </message>
    <message>
        <source>⚠ Warnings: {}</source>
        <translation>⚠ 警告：{}</translation>
    </message>
    <message>
        <source>… and {} more</source>
        <translation>…… 另有 {} 项</translation>
    </message>
    <message>
        <source>raw stock: {}</source>
        <translation>毛坯：{}</translation>
    </message>
    <message>
        <source>{}, command {}: {} ({})</source>
        <translation>{}，命令 {}：{}（{}）</translation>
    </message>
    <message>
        <source>removes {}</source>
        <translation>去除 {}</translation>
    </message>
    <message>
        <source>removes nothing</source>
        <translation>不去除材料</translation>
    </message>
    <message>
        <source>the model comes with the finest picture</source>
        <translation>模型将随最精细的画面一起显示</translation>
    </message>
    <message>
        <source>They are known when the finest picture is there.</source>
        <translation>最精细的图片完成后才能得知。</translation>
    </message>
    <message>
        <source>Saving the pictures when the finest is there…</source>
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
        <source>{}, at X {} Y {} Z {} {}</source>
        <translation>{}，位于 X {} Y {} Z {} {}</translation>
    </message>
    <message>
        <source>What is simulated has changed. Simulate again</source>
        <translation>所模拟的内容已更改。重新模拟</translation>
    </message>
    <message>
        <source>Which job?</source>
        <translation>哪个作业？</translation>
    </message>
</context>
<context>
    <name>Vk_Strategies</name>
    <message>
        <source>Colors the toolpaths in the 3D view by their machining strategy, rapid moves grey. The document is not changed.</source>
        <translation>在三维视图中按加工策略为刀具路径着色，快速移动为灰色。文档不会更改。</translation>
    </message>
    <message>
        <source>Show strategies</source>
        <translation>显示策略</translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation>快速移动</translation>
    </message>
    <message>
        <source>Drawing strategies, operations to go: {}</source>
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
    <message>
        <source>Fast-forward</source>
        <translation>快进</translation>
    </message>
    <message>
        <source>Use the {simulator}</source>
        <translation>使用{simulator}</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Toolpath analysis</source>
        <translation>刀具路径分析</translation>
    </message>
    <message>
        <source>Toolpath Analysis</source>
        <translation>刀具路径分析</translation>
    </message>
    <message>
        <source>Recognizes machining strategies of toolpaths and estimates what simulating them costs.</source>
        <translation>识别刀具路径的加工策略，并估计模拟的开销。</translation>
    </message>
</context>
</TS>
