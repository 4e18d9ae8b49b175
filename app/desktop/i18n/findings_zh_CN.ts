<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>alignment</name>
        <message>
            <source>a distance of %1 m</source>
            <translation>距离 %1 m</translation>
        </message>
        <message>
            <source>more than 0</source>
            <translation>大于 0</translation>
        </message>
        <message>
            <source>a cloud without points</source>
            <translation>没有点的点云</translation>
        </message>
        <message>
            <source>two with points</source>
            <translation>两个都有点</translation>
        </message>
        <message>
            <source>a reach of %1 m</source>
            <translation>搜索范围 %1 m</translation>
        </message>
        <message>
            <source>%1 pairs of points</source>
            <translation>%1 对点</translation>
        </message>
        <message>
            <source>3 that are not on a line</source>
            <translation>3 对不在一条直线上的点</translation>
        </message>
        <message>
            <source>Pick more pairs</source>
            <translation>请选取更多点对</translation>
        </message>
        <message>
            <source>the points of the pairs lie on a line</source>
            <translation>点对的点在一条直线上</translation>
        </message>
        <message>
            <source>some beside it, so that the turn about it is known</source>
            <translation>线外的一些点，以确定绕该线的旋转</translation>
        </message>
        <message>
            <source>Pick a pair away from the line</source>
            <translation>请在远离该线处选取一对点</translation>
        </message>
    </context>
    <context>
        <name>base</name>
        <message>
            <source>Move the folder away</source>
            <translation>请移走该文件夹</translation>
        </message>
        <message>
            <source>a name that is free</source>
            <translation>可用的名称</translation>
        </message>
        <message>
            <source>cannot write '%1': there is a folder of that name</source>
            <translation>无法写入“%1”：已有同名的文件夹</translation>
        </message>
        <message>
            <source>cannot put '%1' in place: %2</source>
            <translation>无法放置“%1”：%2</translation>
        </message>
        <message>
            <source>a folder that may be written to</source>
            <translation>可写的文件夹</translation>
        </message>
        <message>
            <source>cannot write '%1'</source>
            <translation>无法写入“%1”</translation>
        </message>
        <message>
            <source>space on the disk</source>
            <translation>磁盘空间</translation>
        </message>
        <message>
            <source>true or false%1</source>
            <translation>true 或 false 之一%1</translation>
        </message>
        <message>
            <source>true or false, or %1</source>
            <translation>true 或 false，或 %1</translation>
        </message>
        <message>
            <source>a whole number from %1 to %2</source>
            <translation>%1 至 %2 的整数</translation>
        </message>
        <message>
            <source>a whole number from %1 to %2 %3</source>
            <translation>%1 至 %2 %3 的整数</translation>
        </message>
        <message>
            <source>a whole number from %1 to %2 %3, or %4</source>
            <translation>%1 至 %2 %3 的整数，或 %4</translation>
        </message>
        <message>
            <source>a whole number from %1 to %2, or %3</source>
            <translation>%1 至 %2 的整数，或 %3</translation>
        </message>
        <message>
            <source>a number from %1 to %2</source>
            <translation>%1 至 %2 的数</translation>
        </message>
        <message>
            <source>a number from %1 to %2 %3</source>
            <translation>%1 至 %2 %3 的数</translation>
        </message>
        <message>
            <source>a number from %1 to %2 %3, or %4</source>
            <translation>%1 至 %2 %3 的数，或 %4</translation>
        </message>
        <message>
            <source>a number from %1 to %2, or %3</source>
            <translation>%1 至 %2 的数，或 %3</translation>
        </message>
        <message>
            <source>one of</source>
            <translation>之一</translation>
        </message>
        <message>
            <source>one of%1</source>
            <translation>下列之一：%1</translation>
        </message>
        <message>
            <source>option %1 is '%2'</source>
            <translation>选项 %1 为“%2”</translation>
        </message>
        <message>
            <source>no option: there is none here</source>
            <translation>没有选项：此处没有选项</translation>
        </message>
        <message>
            <source>the name of an option</source>
            <translation>选项的名称</translation>
        </message>
        <message>
            <source>there is no option '%1'</source>
            <translation>没有选项“%1”</translation>
        </message>
        <message>
            <source> or %1</source>
            <translation> 或 %1</translation>
        </message>
        <message>
            <source>Did you mean %1</source>
            <translation>是否指 %1</translation>
        </message>
        <message>
            <source>'%1' is none of the choices</source>
            <translation>“%1”不在可选值中</translation>
        </message>
        <message>
            <source>Set the environment variable BOLE_RESOURCE_DIR to the folder 'resources' of Bole</source>
            <translation>请将环境变量 BOLE_RESOURCE_DIR 设为 Bole 的文件夹“resources”</translation>
        </message>
        <message>
            <source>a file that comes with Bole</source>
            <translation>随 Bole 提供的文件</translation>
        </message>
        <message>
            <source>there is no '%1'</source>
            <translation>没有“%1”</translation>
        </message>
        <message>
            <source>ended early: the result is not complete</source>
            <translation>提前结束：结果不完整</translation>
        </message>
    </context>
    <context>
        <name>camera</name>
        <message>
            <source>the camera's %1 is %2</source>
            <translation>相机的 %1 为 %2</translation>
        </message>
        <message>
            <source>the camera's image is %1 x %2 pixels</source>
            <translation>相机的图像为 %1 x %2 像素</translation>
        </message>
        <message>
            <source>at least 1 x 1</source>
            <translation>至少 1 x 1</translation>
        </message>
        <message>
            <source>pixels, 1 or more</source>
            <translation>以像素计，1 或更大</translation>
        </message>
        <message>
            <source>a pixel near the image's middle</source>
            <translation>接近图像中心的像素</translation>
        </message>
        <message>
            <source>five numbers: k1, k2, p1, p2, k3</source>
            <translation>五个数：k1、k2、p1、p2、k3</translation>
        </message>
        <message>
            <source>the camera's distortion has no inverse at the corners of the image</source>
            <translation>相机的畸变在图像的角上不可逆</translation>
        </message>
        <message>
            <source>k1, k2, p1, p2, k3 as OpenCV gives them</source>
            <translation>OpenCV 给出的 k1、k2、p1、p2、k3</translation>
        </message>
    </context>
    <context>
        <name>cloud</name>
        <message>
            <source>Measure the stems anew, or take the fact breast_height_m away</source>
            <translation>请重新测定单木，或去掉附注 breast_height_m</translation>
        </message>
        <message>
            <source>metres from 0.1 to 5</source>
            <translation>0.1 至 5 的米数</translation>
        </message>
        <message>
            <source>the stem table says "%1" for its breast height</source>
            <translation>单木表给出的胸高为“%1”</translation>
        </message>
        <message>
            <source>15 numbers</source>
            <translation>15 个数</translation>
        </message>
        <message>
            <source>Run the stage survey.georeference again</source>
            <translation>请重新运行步骤 survey.georeference</translation>
        </message>
        <message>
            <source>the data say '%1' for '%2'</source>
            <translation>数据中“%2”为“%1”</translation>
        </message>
        <message>
            <source>a matrix that keeps lengths</source>
            <translation>保持长度的矩阵</translation>
        </message>
        <message>
            <source>the place of the axes ('%1') is no turn and shift</source>
            <translation>坐标轴的位置（“%1”）不是旋转加平移</translation>
        </message>
        <message>
            <source>only_free is %1</source>
            <translation>only_free 为 %1</translation>
        </message>
        <message>
            <source>true or false</source>
            <translation>true 或 false 之一</translation>
        </message>
        <message>
            <source>only_tree and only_free are both given</source>
            <translation>同时给出了 only_tree 和 only_free</translation>
        </message>
        <message>
            <source>points of one tree, or of none</source>
            <translation>一株树的点，或不属于任何树的点</translation>
        </message>
        <message>
            <source>at most %1</source>
            <translation>至多 %1 个</translation>
        </message>
        <message>
            <source>outline has %1 places</source>
            <translation>轮廓有 %1 个位置</translation>
        </message>
        <message>
            <source>path has %1 places</source>
            <translation>路径有 %1 个位置</translation>
        </message>
        <message>
            <source>within has %1 places</source>
            <translation>within 有 %1 个位置</translation>
        </message>
        <message>
            <source>[least, most] in metres</source>
            <translation>以米计的 [最小, 最大]</translation>
        </message>
        <message>
            <source>depth_m is %1</source>
            <translation>depth_m 为 %1</translation>
        </message>
        <message>
            <source>an outline around points</source>
            <translation>围住点的轮廓</translation>
        </message>
        <message>
            <source>the corners of the outline lie on one line</source>
            <translation>轮廓的角点在一条直线上</translation>
        </message>
        <message>
            <source>Draw it again</source>
            <translation>请重新绘制</translation>
        </message>
        <message>
            <source>sides that do not meet</source>
            <translation>互不相交的边</translation>
        </message>
        <message>
            <source>the outline crosses itself</source>
            <translation>轮廓自相交</translation>
        </message>
        <message>
            <source>%1 has %2</source>
            <translation>%1 有 %2</translation>
        </message>
        <message>
            <source>[x, y, z] in metres</source>
            <translation>以米计的 [x, y, z]</translation>
        </message>
        <message>
            <source>outline (with eye and depth_m where needed), or centre and size_m (and turn_deg), or path and radius_m</source>
            <translation>outline（需要时带 eye 和 depth_m），或 centre 和 size_m（以及 turn_deg），或 path 和 radius_m</translation>
        </message>
        <message>
            <source>the edit does not say which points</source>
            <translation>编辑没有指明哪些点</translation>
        </message>
        <message>
            <source>its lower corner first, in x, y and z</source>
            <translation>先给出 x、y 和 z 较小的角点</translation>
        </message>
        <message>
            <source>within ends before it begins</source>
            <translation>within 的终点在起点之前</translation>
        </message>
        <message>
            <source>nothing of the right kind is connected to the input '%1'</source>
            <translation>输入“%1”没有连接合适类型的内容</translation>
        </message>
        <message>
            <source>the output of an earlier stage</source>
            <translation>前面步骤的输出</translation>
        </message>
        <message>
            <source>"action": one of %1</source>
            <translation>"action"：%1 之一</translation>
        </message>
        <message>
            <source>no known action in %1</source>
            <translation>%1 中没有已知的操作</translation>
        </message>
        <message>
            <source>%1 without %2</source>
            <translation>%1 缺少 %2</translation>
        </message>
        <message>
            <source>%1 does not take '%2'</source>
            <translation>%1 不接受“%2”</translation>
        </message>
        <message>
            <source>only what the action uses</source>
            <translation>只给出该操作所用的内容</translation>
        </message>
        <message>
            <source>%1 is %2</source>
            <translation>%1 为 %2</translation>
        </message>
        <message>
            <source>a position [x, y] in metres</source>
            <translation>以米计的位置 [x, y]</translation>
        </message>
        <message>
            <source>a list of at least %1</source>
            <translation>至少 %1 项的列表</translation>
        </message>
        <message>
            <source>a text</source>
            <translation>文本</translation>
        </message>
        <message>
            <source>a JSON list of edits</source>
            <translation>编辑的 JSON 列表</translation>
        </message>
        <message>
            <source>the edits are no JSON</source>
            <translation>编辑不是 JSON</translation>
        </message>
        <message>
            <source>the edits are no list</source>
            <translation>编辑不是列表</translation>
        </message>
        <message>
            <source>a file with a JSON list of edits</source>
            <translation>含编辑的 JSON 列表的文件</translation>
        </message>
        <message>
            <source>cannot read %1</source>
            <translation>无法读取 %1</translation>
        </message>
        <message>
            <source>Looking at the cloud</source>
            <translation>查看点云</translation>
        </message>
        <message>
            <source>Set the option that stands for this fact, or correct the data</source>
            <translation>请设置代表该附注的选项，或更正数据</translation>
        </message>
        <message>
            <source>given or estimated</source>
            <translation>给定的或估计的</translation>
        </message>
        <message>
            <source>the facts of the file are damaged (no JSON object) and were left out</source>
            <translation>文件中的附注已损坏（不是 JSON 对象），已舍去</translation>
        </message>
        <message>
            <source>the fact '%1' of the file is no text and was left out</source>
            <translation>文件中的附注“%1”不是文本，已舍去</translation>
        </message>
        <message>
            <source>the fact '%1' of the file was left out: %2</source>
            <translation>文件中的附注“%1”已舍去：%2</translation>
        </message>
        <message>
            <source>%1 GB of columns stay in memory: no folder for temporary files has room for them. Free room on the disk, or set TMPDIR to a folder that has it</source>
            <translation>%1 GB 的列留在内存中：没有临时文件夹容得下它们。请腾出磁盘空间，或将 TMPDIR 设为有空间的文件夹</translation>
        </message>
        <message>
            <source>a table without '%1' in its facts</source>
            <translation>附注中没有“%1”的表</translation>
        </message>
        <message>
            <source>the plot of a stage survey.plot</source>
            <translation>步骤 survey.plot 给出的样地</translation>
        </message>
        <message>
            <source>a number</source>
            <translation>数</translation>
        </message>
        <message>
            <source>the fact '%1' of the plot is '%2'</source>
            <translation>样地的附注“%1”为“%2”</translation>
        </message>
        <message>
            <source>vertex %1 of the plot boundary has no position</source>
            <translation>样地边界的第 %1 个顶点没有位置</translation>
        </message>
        <message>
            <source>x_m and y_m in every row</source>
            <translation>每行都有 x_m 和 y_m</translation>
        </message>
        <message>
            <source>a plot boundary of %1 vertices that encloses nothing</source>
            <translation>%1 个顶点的样地边界没有围住任何区域</translation>
        </message>
        <message>
            <source>at least three that do not lie on one line</source>
            <translation>至少三个，且不在一条直线上</translation>
        </message>
        <message>
            <source>the plot boundary crosses itself</source>
            <translation>样地边界自相交</translation>
        </message>
        <message>
            <source>vertices in order around the plot</source>
            <translation>沿样地依次排列的顶点</translation>
        </message>
        <message>
            <source>circle of radius %1 m</source>
            <translation>半径 %1 m 的圆</translation>
        </message>
        <message>
            <source>polygon of %1 vertices</source>
            <translation>%1 个顶点的多边形</translation>
        </message>
        <message>
            <source>no boundary</source>
            <translation>没有边界</translation>
        </message>
        <message>
            <source>axes '%1'</source>
            <translation>坐标轴“%1”</translation>
        </message>
        <message>
            <source>unknown, sensor, map, plot or global</source>
            <translation>unknown、sensor、map、plot 或 global</translation>
        </message>
        <message>
            <source>It has: %1</source>
            <translation>现有：%1</translation>
        </message>
        <message>
            <source>It has: none</source>
            <translation>现有：无</translation>
        </message>
        <message>
            <source>one of that name</source>
            <translation>该名称的数组</translation>
        </message>
        <message>
            <source>the cloud has no array '%1'</source>
            <translation>点云没有数组“%1”</translation>
        </message>
        <message>
            <source>%1, one per point</source>
            <translation>%1 个，每点一个</translation>
        </message>
        <message>
            <source>array '%1' has %2 values</source>
            <translation>数组“%1”有 %2 个值</translation>
        </message>
        <message>
            <source>another type</source>
            <translation>另一类型</translation>
        </message>
        <message>
            <source>array '%1' has type %2</source>
            <translation>数组“%1”的类型为 %2</translation>
        </message>
        <message>
            <source>table column '%1' has %2 rows</source>
            <translation>表的列“%1”有 %2 行</translation>
        </message>
        <message>
            <source>the table has no column '%1'</source>
            <translation>表没有列“%1”</translation>
        </message>
        <message>
            <source>column '%1' holds text</source>
            <translation>列“%1”为文本</translation>
        </message>
        <message>
            <source>numbers</source>
            <translation>数</translation>
        </message>
        <message>
            <source>column '%1' does not hold whole numbers</source>
            <translation>列“%1”不是整数</translation>
        </message>
        <message>
            <source>whole numbers</source>
            <translation>整数</translation>
        </message>
        <message>
            <source>column '%1' holds numbers</source>
            <translation>列“%1”为数</translation>
        </message>
        <message>
            <source>at least 2</source>
            <translation>至少 2 个</translation>
        </message>
        <message>
            <source>the trajectory has %1 poses</source>
            <translation>轨迹有 %1 个位姿</translation>
        </message>
        <message>
            <source>Check that the trajectory and the scan use the same clock</source>
            <translation>请检查轨迹和扫描是否使用同一时钟</translation>
        </message>
        <message>
            <source>a time from %1 to %2 s</source>
            <translation>%1 至 %2 s 之间的时间</translation>
        </message>
        <message>
            <source>no pose near time %1 s</source>
            <translation>时间 %1 s 附近没有位姿</translation>
        </message>
    </context>
    <context>
        <name>documents</name>
        <message>
            <source>a pipeline document (JSON), or one that comes with Bole: %1</source>
            <translation>处理流程文档（JSON），或随 Bole 提供的：%1</translation>
        </message>
        <message>
            <source>there is no pipeline '%1'</source>
            <translation>没有处理流程“%1”</translation>
        </message>
        <message>
            <source>To survey it: bole survey %1 --out DIR</source>
            <translation>要调查它：bole survey %1 --out DIR</translation>
        </message>
        <message>
            <source>a pipeline document (JSON)</source>
            <translation>处理流程文档（JSON）</translation>
        </message>
        <message>
            <source>'%1' is %2 (%3)</source>
            <translation>“%1”是%2（%3）</translation>
        </message>
        <message>
            <source>'%1' is a folder without frames of a scan</source>
            <translation>“%1”是不含扫描帧的文件夹</translation>
        </message>
    </context>
    <context>
        <name>evaluation</name>
        <message>
            <source>%1: the columns of its stems were taken by their headings: %2</source>
            <translation>%1：其单木的各列按列标题识别：%2</translation>
        </message>
        <message>
            <source>%1: the columns of its reference were taken by their headings: %2</source>
            <translation>%1：其参照数据的各列按列标题识别：%2</translation>
        </message>
        <message>
            <source>%1: %2 of %3 trees agree with the reference; its figures mean nothing and are not pooled; %4</source>
            <translation>%1：%3 株中有 %2 株与参照一致；其数值没有意义，不参与合并；%4</translation>
        </message>
        <message>
            <source>%1 and %2: %3 of %4 stems agree; %5</source>
            <translation>%1 与 %2：%4 株中有 %3 株一致；%5</translation>
        </message>
        <message>
            <source>%1, stems from %2 cm</source>
            <translation>%1，单木自 %2 cm 起</translation>
        </message>
        <message>
            <source>%1 takes the boundary of %2 (%3)</source>
            <translation>%1 采用 %2 的边界（%3）</translation>
        </message>
        <message>
            <source>%1 and %2 are of one plot and count other trees (%3; %4): their figures are not of the same trees</source>
            <translation>%1 与 %2 属于同一样地，但计入的树木不同（%3；%4）：两者的数值不是同一批树木的</translation>
        </message>
        <message>
            <source>%1 and %2</source>
            <translation>%1 和 %2</translation>
        </message>
        <message>
            <source>the reference has %1 poses</source>
            <translation>参照有 %1 个位姿</translation>
        </message>
        <message>
            <source>names of the plants</source>
            <translation>植株的名称</translation>
        </message>
        <message>
            <source>the estimated table has %1 plants and no column plant_id</source>
            <translation>估计表有 %1 株植株而没有列 plant_id</translation>
        </message>
        <message>
            <source>the reference table has %1 plants and no column plant_id</source>
            <translation>参照表有 %1 株植株而没有列 plant_id</translation>
        </message>
        <message>
            <source>every plant once</source>
            <translation>每株植株一次</translation>
        </message>
        <message>
            <source>the estimated table has the plant '%1' twice</source>
            <translation>估计表中植株“%1”出现两次</translation>
        </message>
        <message>
            <source>the reference table has the plant '%1' twice</source>
            <translation>参照表中植株“%1”出现两次</translation>
        </message>
        <message>
            <source>first estimated: '%1', first reference: '%2'</source>
            <translation>估计表的第一个：“%1”，参照表的第一个：“%2”</translation>
        </message>
        <message>
            <source>no plant_id is in both tables</source>
            <translation>没有同时在两个表中的 plant_id</translation>
        </message>
        <message>
            <source>the same names in both</source>
            <translation>两者名称相同</translation>
        </message>
        <message>
            <source>height_mm and the like</source>
            <translation>height_mm 之类的列</translation>
        </message>
        <message>
            <source>the tables share no column of numbers with values</source>
            <translation>两个表没有共同的有值的数值列</translation>
        </message>
        <message>
            <source>Compare rows.csv with rows.csv, or plants.csv with plants.csv</source>
            <translation>请将 rows.csv 与 rows.csv 比较，或将 plants.csv 与 plants.csv 比较</translation>
        </message>
        <message>
            <source>both rows (row_id, x0_m, y0_m, x1_m, y1_m) or both plants (row_id, x_m, y_m)</source>
            <translation>同为行（row_id, x0_m, y0_m, x1_m, y1_m）或同为植株（row_id, x_m, y_m）</translation>
        </message>
        <message>
            <source>the two tables are not of one kind</source>
            <translation>两个表的类型不同</translation>
        </message>
        <message>
            <source>Name them: evaluate.reference_columns="x_m=E, y_m=N, dbh_cm=DIAM:mm" (on the command line --reference-columns)</source>
            <translation>请指定：evaluate.reference_columns="x_m=E, y_m=N, dbh_cm=DIAM:mm"（命令行为 --reference-columns）</translation>
        </message>
        <message>
            <source>the columns of the reference are %1</source>
            <translation>参照的列为 %1</translation>
        </message>
        <message>
            <source>x_m, y_m (or azimuth_deg, distance_m) and dbh_cm, or headings that say the same</source>
            <translation>x_m、y_m（或 azimuth_deg、distance_m）和 dbh_cm，或同义的标题</translation>
        </message>
        <message>
            <source>stems</source>
            <translation>单木表</translation>
        </message>
        <message>
            <source>reference</source>
            <translation>参照表</translation>
        </message>
        <message>
            <source>%1 to %2 s</source>
            <translation>%1 至 %2 s</translation>
        </message>
        <message>
            <source>empty</source>
            <translation>空</translation>
        </message>
        <message>
            <source>%1 of %2 poses have a reference at their time (estimate %3, reference %4)</source>
            <translation>%2 个位姿中有 %1 个在其时刻有参照（估计 %3，参照 %4）</translation>
        </message>
        <message>
            <source>Check that both trajectories use the same clock, or raise max_time_gap</source>
            <translation>请检查两条轨迹是否使用同一时钟，或增大 max_time_gap</translation>
        </message>
        <message>
            <source>at least 3</source>
            <translation>至少 3 个</translation>
        </message>
        <message>
            <source>option columns: '%1'</source>
            <translation>选项 columns：“%1”</translation>
        </message>
        <message>
            <source>option rows: '%1'</source>
            <translation>选项 rows：“%1”</translation>
        </message>
        <message>
            <source>rules such as dbh_cm=DIAM:mm</source>
            <translation>dbh_cm=DIAM:mm 之类的规则</translation>
        </message>
        <message>
            <source>rules such as plot=3</source>
            <translation>plot=3 之类的规则</translation>
        </message>
        <message>
            <source>one of: %1</source>
            <translation>下列之一：%1</translation>
        </message>
        <message>
            <source>there is no column '%1'</source>
            <translation>没有列“%1”</translation>
        </message>
        <message>
            <source>mm, cm, dm, m, in or ft for lengths, deg or gon for angles, and a name that ends in its unit</source>
            <translation>长度用 mm、cm、dm、m、in 或 ft，角度用 deg 或 gon，且名称以其单位结尾</translation>
        </message>
        <message>
            <source>unit '%1' for column '%2'</source>
            <translation>列“%2”的单位“%1”</translation>
        </message>
        <message>
            <source>a value that the column has</source>
            <translation>该列具有的值</translation>
        </message>
        <message>
            <source>no row has %1</source>
            <translation>没有行满足 %1</translation>
        </message>
        <message>
            <source>%1 runs of %2 plots, %3 with a reference, %4 pairs</source>
            <translation>%2 块样地的 %1 次运行，其中 %3 次有参照，共 %4 对</translation>
        </message>
        <message>
            <source>there is nothing to compare: no run has a reference, and no two runs are of one plot. Give reference_trees.file, or runs of the same plot</source>
            <translation>没有可比较的内容：没有一次运行有参照，也没有两次运行属于同一样地。请给出 reference_trees.file，或给出同一样地的多次运行</translation>
        </message>
        <message>
            <source>no run has a reference: the figures are differences between runs, and no errors</source>
            <translation>没有一次运行有参照：数值是各次运行之间的差异，不是误差</translation>
        </message>
        <message>
            <source>%1 of %2 runs have no reference and are in no table of errors</source>
            <translation>%2 次运行中有 %1 次没有参照，不列入任何误差表</translation>
        </message>
        <message>
            <source>one run is compared with its reference only: no other is named</source>
            <translation>只有一次运行与其参照比较：没有指定其他运行</translation>
        </message>
        <message>
            <source>no row of the %1 has a position</source>
            <translation>%1没有一行有位置</translation>
        </message>
        <message>
            <source>x_m and y_m</source>
            <translation>列 x_m 和 y_m</translation>
        </message>
        <message>
            <source>%1 of %2 rows of the %3 have no position and are left out</source>
            <translation>%3的 %2 行中有 %1 行没有位置，已舍去</translation>
        </message>
        <message>
            <source>centimetres</source>
            <translation>厘米</translation>
        </message>
        <message>
            <source>centimetres, those of the other list in inches</source>
            <translation>厘米（另一表以英寸计）</translation>
        </message>
        <message>
            <source>centimetres, those of the other list in millimetres</source>
            <translation>厘米（另一表以毫米计）</translation>
        </message>
        <message>
            <source>feet</source>
            <translation>英尺</translation>
        </message>
        <message>
            <source>inches</source>
            <translation>英寸</translation>
        </message>
        <message>
            <source>metres</source>
            <translation>米</translation>
        </message>
        <message>
            <source>metres, the other list in centimetres</source>
            <translation>米（另一表以厘米计）</translation>
        </message>
        <message>
            <source>metres, the other list in feet</source>
            <translation>米（另一表以英尺计）</translation>
        </message>
        <message>
            <source>millimetres</source>
            <translation>毫米</translation>
        </message>
        <message>
            <source>their places agree, and the diameters look like %1. Name the unit: dbh_cm=COLUMN:UNIT in the columns of the list</source>
            <translation>位置一致，直径看来以%1为单位。请注明单位：在该表的列设置中写 dbh_cm=COLUMN:UNIT</translation>
        </message>
        <message>
            <source>their places agree, their diameters do not (dbh_gate): are both at breast height, in cm?</source>
            <translation>位置一致，但直径不一致（dbh_gate）：两者都是胸高处的直径，单位都是 cm 吗？</translation>
        </message>
        <message>
            <source>their places agree when multiplied by %1: they look like %2</source>
            <translation>乘以 %1 后位置一致：看来以%2为单位</translation>
        </message>
        <message>
            <source>their places agree with x and y swapped</source>
            <translation>交换 x 和 y 后位置一致</translation>
        </message>
        <message>
            <source>they are in other axes: turned by %1 deg and moved by (%2, %3) m, %4 trees agree. align_stems=search compares them so</source>
            <translation>两者的坐标轴不同：旋转 %1 度并平移 (%2, %3) m 后，%4 株一致。align_stems=search 按此比较</translation>
        </message>
        <message>
            <source>neither another unit nor another place of the axes brings them together: they are of different plots</source>
            <translation>换用其他单位或移动坐标轴都不能使两者一致：它们属于不同的样地</translation>
        </message>
        <message>
            <source>the columns of the reference were taken by their headings: %1. Set evaluate.reference_columns where that is wrong</source>
            <translation>参照数据的各列按列标题识别：%1。如有误，请设置 evaluate.reference_columns</translation>
        </message>
        <message>
            <source>the stems were compared with no reference: %1</source>
            <translation>单木没有与参照比较：%1</translation>
        </message>
        <message>
            <source>the paper has no figures of the preset %1: those of its improved LOAM are listed. Set evaluate.published_system for others</source>
            <translation>论文中没有预设 %1 的数值：列出的是其改进型 LOAM 的数值。要列出其他系统，请设置 evaluate.published_system</translation>
        </message>
        <message>
            <source>the preset that made the trajectory is not known: those of its improved LOAM are listed. Set evaluate.published_system for others</source>
            <translation>生成该轨迹的预设未知：列出的是论文中改进型 LOAM 的数值。要列出其他系统，请设置 evaluate.published_system</translation>
        </message>
        <message>
            <source>no stem matches a reference tree: are both in the same axes? align_stems and match_distance may help</source>
            <translation>没有单木与参照树木匹配：两者的坐标轴相同吗？可尝试 align_stems 和 match_distance</translation>
        </message>
        <message>
            <source>%1 of %2 trees agree with the reference: its figures mean nothing; %3</source>
            <translation>%2 株中有 %1 株与参照一致：其数值没有意义；%3</translation>
        </message>
        <message>
            <source>Connect the input 'trajectory'</source>
            <translation>请连接输入“trajectory”</translation>
        </message>
        <message>
            <source>a reference trajectory is connected but no trajectory</source>
            <translation>连接了参照轨迹而没有连接轨迹</translation>
        </message>
        <message>
            <source>both</source>
            <translation>两者</translation>
        </message>
        <message>
            <source>%1 poses compared</source>
            <translation>比较了 %1 个位姿</translation>
        </message>
        <message>
            <source>; %1 poses compared</source>
            <translation>；比较了 %1 个位姿</translation>
        </message>
        <message>
            <source>%1 stems matched, %2 missed, %3 false</source>
            <translation>匹配 %1 株，漏检 %2 株，误检 %3 株</translation>
        </message>
        <message>
            <source>%1 stems matched, %2 missed, %3 false%4</source>
            <translation>匹配 %1 株，漏检 %2 株，误检 %3 株%4</translation>
        </message>
        <message>
            <source>nothing to compare with: no reference is connected</source>
            <translation>没有可比较的对象：未连接参照</translation>
        </message>
        <message>
            <source>the reference could not be read</source>
            <translation>无法读取参照</translation>
        </message>
        <message>
            <source>the reference could not be read%1</source>
            <translation>无法读取参照%1</translation>
        </message>
        <message>
            <source>no row matches a reference row: are both in the same axes? Place the frame (place.x, place.y, place.yaw, or marks), or raise match_distance</source>
            <translation>没有行与参照行匹配：两者的坐标轴相同吗？请放置坐标框架（place.x、place.y、place.yaw 或标志），或增大 match_distance</translation>
        </message>
        <message>
            <source>%1 rows matched, %2 missed, %3 false</source>
            <translation>匹配 %1 行，漏检 %2 行，误检 %3 行</translation>
        </message>
    </context>
    <context>
        <name>geo</name>
        <message>
            <source>Place another mark</source>
            <translation>请再设一个标志</translation>
        </message>
        <message>
            <source>a pose from %1 marks</source>
            <translation>由 %1 个标志确定的位姿</translation>
        </message>
        <message>
            <source>finite coordinates, and a distance from the sensor</source>
            <translation>有限的坐标，且与传感器有距离</translation>
        </message>
        <message>
            <source>mark %1 has no place, or is seen in the sensor itself</source>
            <translation>标志 %1 没有位置，或位于传感器处</translation>
        </message>
        <message>
            <source>a standard deviation of %1</source>
            <translation>标准差为 %1</translation>
        </message>
        <message>
            <source>positive standard deviations</source>
            <translation>正的标准差</translation>
        </message>
        <message>
            <source>Move one mark aside</source>
            <translation>请将一个标志移到旁边</translation>
        </message>
        <message>
            <source>marks in different directions</source>
            <translation>方向不同的标志</translation>
        </message>
        <message>
            <source>the marks stand above one another and carry no heading</source>
            <translation>标志上下重叠，不能给出航向</translation>
        </message>
        <message>
            <source>no zone is given, and the table has no longitude to derive it from</source>
            <translation>没有给出投影带，表中也没有可据以推算的经度</translation>
        </message>
        <message>
            <source>the option zone</source>
            <translation>选项 zone</translation>
        </message>
        <message>
            <source>%1 points have metres and no degrees: unchanged</source>
            <translation>%1 个点只有米制坐标，没有经纬度：保持不变</translation>
        </message>
        <message>
            <source>x_m and y_m of the table are replaced by those of its latitude and longitude</source>
            <translation>表中的 x_m 和 y_m 由其纬度和经度换算的值取代</translation>
        </message>
        <message>
            <source>%1 points, central meridian %2 deg, %3</source>
            <translation>%1 个点，中央子午线 %2 度，%3</translation>
        </message>
        <message>
            <source>Look the code up at epsg.org, or copy the WKT from your GIS</source>
            <translation>请在 epsg.org 查找代码，或从 GIS 软件复制 WKT</translation>
        </message>
        <message>
            <source>a projected system in metres, by EPSG code or as WKT, for instance EPSG:25832</source>
            <translation>以米为单位的投影坐标系，用 EPSG 代码或 WKT 给出，例如 EPSG:25832</translation>
        </message>
        <message>
            <source>the coordinate reference system '%1' %2</source>
            <translation>坐标参考系“%1”%2</translation>
        </message>
        <message>
            <source>is empty</source>
            <translation>为空</translation>
        </message>
        <message>
            <source>is not known</source>
            <translation>未知</translation>
        </message>
        <message>
            <source>has degrees</source>
            <translation>以度为单位</translation>
        </message>
        <message>
            <source>is no projected system</source>
            <translation>不是投影坐标系</translation>
        </message>
        <message>
            <source>has the unit '%1' (%2 m)</source>
            <translation>的单位为“%1”（%2 m）</translation>
        </message>
        <message>
            <source>has the unit '?' (%1 m)</source>
            <translation>的单位为“?”（%1 m）</translation>
        </message>
        <message>
            <source>has no datum</source>
            <translation>没有基准</translation>
        </message>
        <message>
            <source>has a projection that PROJ does not compute</source>
            <translation>的投影 PROJ 不能计算</translation>
        </message>
        <message>
            <source>Are latitude and longitude swapped?</source>
            <translation>纬度和经度是否弄反了？</translation>
        </message>
        <message>
            <source>a position where the system is used</source>
            <translation>该坐标系适用范围内的位置</translation>
        </message>
        <message>
            <source>latitude %1, longitude %2 lies outside %3</source>
            <translation>纬度 %1、经度 %2 在 %3 之外</translation>
        </message>
        <message>
            <source>coordinates of that system</source>
            <translation>该坐标系的坐标</translation>
        </message>
        <message>
            <source>easting %1 m, northing %2 m lies outside %3</source>
            <translation>东坐标 %1 m、北坐标 %2 m 在 %3 之外</translation>
        </message>
        <message>
            <source>a resection from %1 ranges</source>
            <translation>由 %1 个距离作后方交会</translation>
        </message>
        <message>
            <source>at least 3 marks</source>
            <translation>至少 3 个标志</translation>
        </message>
        <message>
            <source>finite positions, positive ranges and sigmas</source>
            <translation>有限的位置，正的距离和标准差</translation>
        </message>
        <message>
            <source>mark %1 has position %2, range %3 m, sigma %4 m</source>
            <translation>标志 %1 的位置为 %2，距离 %3 m，标准差 %4 m</translation>
        </message>
        <message>
            <source>an approximate position, or marks that are not in one plane</source>
            <translation>近似位置，或不在一个平面内的标志</translation>
        </message>
        <message>
            <source>the ranges fit two positions alike, %1 and %2, mirrored in the plane of the marks</source>
            <translation>距离与两个位置 %1 和 %2 同样相符，两者关于标志所在平面对称</translation>
        </message>
        <message>
            <source>Raise a mark, or give the height of the sensor</source>
            <translation>请升高一个标志，或给出传感器的高度</translation>
        </message>
        <message>
            <source>Use marks in other directions</source>
            <translation>请使用其他方向的标志</translation>
        </message>
        <message>
            <source>at most %1 m</source>
            <translation>至多 %1 m</translation>
        </message>
        <message>
            <source>the position has a standard error of %1 m along %2</source>
            <translation>位置沿 %2 方向的标准误差为 %1 m</translation>
        </message>
        <message>
            <source>the position has a standard error of %1 m along %2: the sensor lies in the plane of the marks, or the ranges are too short to meet</source>
            <translation>位置沿 %2 方向的标准误差为 %1 m：传感器在标志所在平面内，或距离太短而不能相交</translation>
        </message>
        <message>
            <source>the position has a standard error of any size along %1</source>
            <translation>位置沿 %1 方向的标准误差可为任意大小</translation>
        </message>
        <message>
            <source>the position has a standard error of any size along %1: the sensor lies in the plane of the marks, or the ranges are too short to meet</source>
            <translation>位置沿 %1 方向的标准误差可为任意大小：传感器在标志所在平面内，或距离太短而不能相交</translation>
        </message>
        <message>
            <source>all marks are at one place</source>
            <translation>所有标志都在同一位置</translation>
        </message>
        <message>
            <source>marks in different directions from the sensor</source>
            <translation>从传感器看方向不同的标志</translation>
        </message>
        <message>
            <source>Move one mark off the line</source>
            <translation>请将一个标志移开直线</translation>
        </message>
        <message>
            <source>marks that span a triangle</source>
            <translation>构成三角形的标志</translation>
        </message>
        <message>
            <source>the marks lie on a line: the sensor may be anywhere on a circle about it</source>
            <translation>标志在一条直线上：传感器可能在围绕它的圆上的任何位置</translation>
        </message>
        <message>
            <source>Check which range belongs to which mark</source>
            <translation>请检查距离与标志是否对应</translation>
        </message>
        <message>
            <source>the ranges meet nowhere: the worst is off by %1 times its standard deviation</source>
            <translation>各距离不相交于一点：最差的偏差为其标准差的 %1 倍</translation>
        </message>
        <message>
            <source>a positive standard deviation</source>
            <translation>正的标准差</translation>
        </message>
        <message>
            <source>sigma %1 m</source>
            <translation>标准差 %1 m</translation>
        </message>
        <message>
            <source>Was another mark taken?</source>
            <translation>是否取成了另一个标志？</translation>
        </message>
        <message>
            <source>direction %1 is %2 m long as seen and %3 m as known</source>
            <translation>方向 %1 的观测长度为 %2 m，已知长度为 %3 m</translation>
        </message>
        <message>
            <source>lengths that agree to %1 m</source>
            <translation>相差不超过 %1 m 的长度</translation>
        </message>
        <message>
            <source>a heading from %1 directions that are as short as their error</source>
            <translation>由 %1 个短如其误差的方向确定的航向</translation>
        </message>
        <message>
            <source>at least one direction longer than that</source>
            <translation>至少一个更长的方向</translation>
        </message>
        <message>
            <source>a flattened ellipsoid such as GRS80</source>
            <translation>GRS80 之类的扁椭球</translation>
        </message>
        <message>
            <source>ellipsoid '%1' has semi-major axis %2 m and inverse flattening %3</source>
            <translation>椭球“%1”的长半轴为 %2 m，扁率倒数为 %3</translation>
        </message>
        <message>
            <source>a plane with central meridian %1 deg, latitude of origin %2 deg, scale %3, false easting %4 m, false northing %5 m</source>
            <translation>中央子午线 %1 度、起始纬度 %2 度、比例 %3、东偏移 %4 m、北偏移 %5 m 的平面</translation>
        </message>
        <message>
            <source>finite values, a positive scale, a meridian from -360 to 360 deg and a latitude from -90 to 90</source>
            <translation>有限的值，正的比例，-360 至 360 度的子午线和 -90 至 90 的纬度</translation>
        </message>
        <message>
            <source>Choose the zone that the point lies in</source>
            <translation>请选择点所在的投影带</translation>
        </message>
        <message>
            <source>at most %1 deg</source>
            <translation>至多 %1 度</translation>
        </message>
        <message>
            <source>longitude %1 deg is %2 deg from the central meridian %3 deg</source>
            <translation>经度 %1 度距中央子午线 %3 度有 %2 度</translation>
        </message>
        <message>
            <source>a latitude from -90 to 90 deg and finite numbers</source>
            <translation>-90 至 90 度的纬度和有限的数</translation>
        </message>
        <message>
            <source>latitude %1, longitude %2, height %3</source>
            <translation>纬度 %1，经度 %2，高度 %3</translation>
        </message>
        <message>
            <source>Gauss-Krueger zones of %1 deg</source>
            <translation>%1 度的高斯-克吕格投影带</translation>
        </message>
        <message>
            <source>zones of 3 or 6 deg</source>
            <translation>3 度或 6 度带</translation>
        </message>
        <message>
            <source>a longitude that is not a number</source>
            <translation>经度不是数</translation>
        </message>
        <message>
            <source>degrees</source>
            <translation>以度计的值</translation>
        </message>
        <message>
            <source>3-degree zones 1 to 120 or 6-degree zones 1 to 60</source>
            <translation>3 度带的 1 至 120 带或 6 度带的 1 至 60 带</translation>
        </message>
        <message>
            <source>Gauss-Krueger zone %1 of %2 deg</source>
            <translation>%2 度的高斯-克吕格第 %1 带</translation>
        </message>
        <message>
            <source>Check the false easting and whether the zone number stands before the easting</source>
            <translation>请检查东偏移，以及东坐标前是否带有带号</translation>
        </message>
        <message>
            <source>an easting near %1 m</source>
            <translation>%1 m 附近的东坐标</translation>
        </message>
        <message>
            <source>easting %1 m, northing %2 m lies outside the plane</source>
            <translation>东坐标 %1 m、北坐标 %2 m 在平面之外</translation>
        </message>
        <message>
            <source>-80 to 84 deg</source>
            <translation>-80 至 84 度</translation>
        </message>
        <message>
            <source>latitude %1 deg lies outside UTM</source>
            <translation>纬度 %1 度在 UTM 范围之外</translation>
        </message>
        <message>
            <source>1 to 60, or 0 for the standard zone</source>
            <translation>1 至 60，标准带为 0</translation>
        </message>
        <message>
            <source>UTM zone %1</source>
            <translation>UTM 第 %1 带</translation>
        </message>
        <message>
            <source>a zone near the point</source>
            <translation>点附近的投影带</translation>
        </message>
        <message>
            <source>latitude %1, longitude %2 in UTM zone %3: %4</source>
            <translation>UTM 第 %3 带中的纬度 %1、经度 %2：%4</translation>
        </message>
        <message>
            <source>UTM zone %1 N, easting %2 m, northing %3 m: %4</source>
            <translation>UTM 第 %1 带北半球，东坐标 %2 m，北坐标 %3 m：%4</translation>
        </message>
        <message>
            <source>UTM zone %1 S, easting %2 m, northing %3 m: %4</source>
            <translation>UTM 第 %1 带南半球，东坐标 %2 m，北坐标 %3 m：%4</translation>
        </message>
        <message>
            <source>coordinates of that zone</source>
            <translation>该投影带的坐标</translation>
        </message>
        <message>
            <source>1 to 60</source>
            <translation>1 至 60</translation>
        </message>
    </context>
    <context>
        <name>ground</name>
        <message>
            <source>Undo the edits of points</source>
            <translation>请撤销点编辑</translation>
        </message>
        <message>
            <source>all %1 points are given to noise</source>
            <translation>全部 %1 个点都归为噪声</translation>
        </message>
        <message>
            <source>points of ground and trees</source>
            <translation>地面和树木的点</translation>
        </message>
        <message>
            <source>the cloud says so (height_reference)</source>
            <translation>点云如此说明（height_reference）</translation>
        </message>
        <message>
            <source>its ground points lie at z = 0 exactly</source>
            <translation>其地面点正好位于 z = 0</translation>
        </message>
        <message>
            <source>its ground is level all over and ends at z = 0</source>
            <translation>其地面处处水平，终止于 z = 0</translation>
        </message>
        <message>
            <source>%1 of %2 upright structures begin within %3 m of z = 0</source>
            <translation>%2 个直立结构中有 %1 个从 z = 0 的 %3 m 以内开始</translation>
        </message>
        <message>
            <source>Terrain model of %1 m2 in cells of %2 m, %3 % of them filled; %4 ground points scatter by %5 cm.</source>
            <translation>地形模型面积 %1 m2，格网 %2 m，其中 %3 % 为填补；%4 个地面点的离散为 %5 cm。</translation>
        </message>
        <message>
            <source>%1 points have coordinates that are not finite: they got no height</source>
            <translation>%1 个点的坐标不是有限数：没有高度</translation>
        </message>
        <message>
            <source>%1 % of the terrain model is filled: the ground was seldom seen, or cell (%2 m) is small for this density of points</source>
            <translation>地形模型有 %1 % 为填补：很少看到地面，或格网 cell（%2 m）对此点密度而言太小</translation>
        </message>
        <message>
            <source>Level ground at %1 m, the lowest points of the cloud.</source>
            <translation>水平地面位于 %1 m，即点云的最低点。</translation>
        </message>
        <message>
            <source>heights are counted from the lowest points, not from ground</source>
            <translation>高度自最低点起算，而不是自地面起算</translation>
        </message>
        <message>
            <source>Normalised cloud: z is the height above ground.</source>
            <translation>已归一化的点云：z 即离地高度。</translation>
        </message>
        <message>
            <source>heights are taken from the cloud as they are: %1. If z is not the height above ground, set method=tin</source>
            <translation>高度直接取自点云：%1。如果 z 不是离地高度，请设置 method=tin</translation>
        </message>
        <message>
            <source>Fitting the terrain</source>
            <translation>拟合地形</translation>
        </message>
        <message>
            <source>Raise band, or lower seed</source>
            <translation>请增大 band，或减小 seed</translation>
        </message>
        <message>
            <source>no points lie within band (%1 m) of the first ground surface</source>
            <translation>初始地面的 band（%1 m）范围内没有点</translation>
        </message>
        <message>
            <source>some</source>
            <translation>至少一些</translation>
        </message>
        <message>
            <source>Filling holes</source>
            <translation>填补空洞</translation>
        </message>
        <message>
            <source>Heights above ground</source>
            <translation>离地高度</translation>
        </message>
        <message>
            <source>%1 of %2 upright structures reach further down than the ground that was seen around them: the terrain runs through their feet. Breast height is too high there by what is missing of the foot: give the cloud with its ground, or look at these stems</source>
            <translation>%2 个直立结构中有 %1 个向下延伸到周围可见地面以下：地形从其基部中间穿过。该处胸高偏高，偏差为缺失的基部高度：请给出带地面的点云，或检查这些单木</translation>
        </message>
        <message>
            <source>%1 points lie below the terrain and only %2 on it: it is not the ground. Set method=normalised if z is the height above ground, method=lowest for a tree that was cut out without ground, or give the cloud with its ground</source>
            <translation>%1 个点位于地形以下，地形上只有 %2 个点：它不是地面。如果 z 是离地高度，请设置 method=normalised；对不带地面裁出的单株树，请设置 method=lowest；否则请给出带地面的点云</translation>
        </message>
        <message>
            <source>half of the points near the terrain lie %1 cm above it or higher: litter, herbs, slash, or passes that do not meet. Breast height may be too high by as much. Compare some stems with the plot</source>
            <translation>地形附近的点有一半高出地形 %1 cm 或更多：枯枝落叶、草本、采伐剩余物，或各次经过不重合。胸高可能偏高同样的量。请抽查几株并与样地比对</translation>
        </message>
        <message>
            <source>all stems begin at z = %1 m and no ground was seen: the cloud was cut there. Set method=normalised if z is the height above ground, else give the cloud with its ground</source>
            <translation>所有单木都从 z = %1 m 开始，且没有看到地面：点云在该处被截断。如果 z 是离地高度，请设置 method=normalised，否则请给出带地面的点云</translation>
        </message>
        <message>
            <source>Finding ground</source>
            <translation>查找地面</translation>
        </message>
        <message>
            <source>Sorting points into cells</source>
            <translation>点按格网归类</translation>
        </message>
        <message>
            <source>method is normalised</source>
            <translation>method 为 normalised</translation>
        </message>
        <message>
            <source>Terrain model done</source>
            <translation>地形模型完成</translation>
        </message>
        <message>
            <source>Check the file of the terrain</source>
            <translation>请检查地形文件</translation>
        </message>
        <message>
            <source>a terrain model of the same place, in the same coordinates</source>
            <translation>同一地点、同一坐标系的地形模型</translation>
        </message>
        <message>
            <source>the terrain given lies below none of %1 points</source>
            <translation>%1 个点中没有一个位于给定地形之上</translation>
        </message>
        <message>
            <source>Heights above the terrain given, for %1 of %2 points.</source>
            <translation>已为 %2 个点中的 %1 个给出高出地形的高度。</translation>
        </message>
        <message>
            <source>at least one</source>
            <translation>至少一个</translation>
        </message>
        <message>
            <source>the cloud has %1 points, none with finite coordinates</source>
            <translation>点云有 %1 个点，没有一个的坐标是有限数</translation>
        </message>
        <message>
            <source>Crop the cloud (one stray point far away is enough to widen it) or raise cell</source>
            <translation>请裁剪点云（一个远处的杂点就足以使其变大），或增大 cell</translation>
        </message>
        <message>
            <source>at most 100 million cells</source>
            <translation>至多 100 百万个单元</translation>
        </message>
        <message>
            <source>the cloud covers %1 by %2 m: too many cells of %3 m</source>
            <translation>点云覆盖 %1 x %2 m：%3 m 的单元太多</translation>
        </message>
        <message>
            <source>Crop or thin the cloud first</source>
            <translation>请先裁剪或抽稀点云</translation>
        </message>
        <message>
            <source>fewer than 4 thousand million</source>
            <translation>少于 40 亿</translation>
        </message>
        <message>
            <source>the cloud has %1 points</source>
            <translation>点云有 %1 个点</translation>
        </message>
        <message>
            <source>a canopy height cell of %1 m</source>
            <translation>冠层高度的单元为 %1 m</translation>
        </message>
        <message>
            <source>a positive size</source>
            <translation>正的大小</translation>
        </message>
        <message>
            <source>Raise seed or lower cell</source>
            <translation>请增大 seed 或减小 cell</translation>
        </message>
        <message>
            <source>seed is %1 m and cell is %2 m</source>
            <translation>seed 为 %1 m，cell 为 %2 m</translation>
        </message>
        <message>
            <source>seed of at least twice cell</source>
            <translation>seed 至少为 cell 的两倍</translation>
        </message>
        <message>
            <source>Check that the cloud has ground points and its z axis points up, lower seed, or set method=lowest for a tree that was cut out without ground, method=normalised where z is the height above ground already</source>
            <translation>请检查点云是否有地面点、z 轴是否朝上，减小 seed；对不带地面裁出的单株树，请设置 method=lowest；如果 z 已是离地高度，请设置 method=normalised</translation>
        </message>
        <message>
            <source>at least three, not on one line</source>
            <translation>至少三个，且不在一条直线上</translation>
        </message>
        <message>
            <source>only %1 ground points were found among %2 candidates</source>
            <translation>%2 个候选中只找到 %1 个地面点</translation>
        </message>
    </context>
    <context>
        <name>inventory</name>
        <message>
            <source>Set width and length of survey.plot</source>
            <translation>请设置 survey.plot 的 width 和 length</translation>
        </message>
        <message>
            <source>a rectangle around all trees that are known</source>
            <translation>包围所有已知树木的矩形</translation>
        </message>
        <message>
            <source>the stand is no rectangle</source>
            <translation>林分不是矩形</translation>
        </message>
        <message>
            <source>Look at the place and size of the stand and at min_dbh</source>
            <translation>请检查林分的位置和大小以及 min_dbh</translation>
        </message>
        <message>
            <source>none of %1 stems is in the stand</source>
            <translation>%1 株单木中没有一株在林分内</translation>
        </message>
        <message>
            <source>trees that count</source>
            <translation>计入的树木</translation>
        </message>
        <message>
            <source>Write for instance "5 10"</source>
            <translation>例如写成“5 10”</translation>
        </message>
        <message>
            <source>numbers of metres below %1, so that a plot fits into the stand</source>
            <translation>小于 %1 的米数，使样地能放入林分</translation>
        </message>
        <message>
            <source>radii is '%1': '%2' is no radius</source>
            <translation>radii 为“%1”：“%2”不是半径</translation>
        </message>
        <message>
            <source>at least one radius in metres</source>
            <translation>至少一个以米计的半径</translation>
        </message>
        <message>
            <source>radii is empty</source>
            <translation>radii 为空</translation>
        </message>
        <message>
            <source>sampling</source>
            <translation>抽样</translation>
        </message>
        <message>
            <source>%1 plots of %2 sizes in %3 trees on %4 m2</source>
            <translation>在 %4 m2 上的 %3 株树中取 %2 种大小的 %1 个样地</translation>
        </message>
        <message>
            <source>: basal area %1</source>
            <translation>：断面积 %1</translation>
        </message>
        <message>
            <source>; %1 outside the plot</source>
            <translation>；样地外 %1 株</translation>
        </message>
        <message>
            <source>; %1 too thin</source>
            <translation>；过细 %1 株</translation>
        </message>
        <message>
            <source>%1 sound, %2 to check: basal area %3 (%4 with them)</source>
            <translation>可靠 %1 株，待查 %2 株：断面积 %3（计入待查的为 %4）</translation>
        </message>
        <message>
            <source>%1 sound, %2 to check: basal area %3 (%4 with them)%5</source>
            <translation>可靠 %1 株，待查 %2 株：断面积 %3（计入待查的为 %4）%5</translation>
        </message>
        <message>
            <source>%1 stem counts</source>
            <translation>计入 %1 株</translation>
        </message>
        <message>
            <source>%1 stem counts%2</source>
            <translation>计入 %1 株%2</translation>
        </message>
        <message>
            <source>%1 stems count</source>
            <translation>计入 %1 株</translation>
        </message>
        <message>
            <source>%1 stems count%2</source>
            <translation>计入 %1 株%2</translation>
        </message>
        <message>
            <source>%1 of the %2 stems that count are to be checked: the basal area is %3 without and %4 with them. If most have one reason, look for its cause in the cloud (registration, wind, unit, density); else look at their slices (column 'reasons' of the stem table), then accept, resize or reject them</source>
            <translation>计入的 %2 株中有 %1 株待查：不计它们时断面积为 %3，计入时为 %4。如果多数出于同一原因，请在点云中查找其来源（配准、风、单位、密度）；否则请查看它们的横切面（单木表的“reasons”列），然后接受、改直径或拒绝</translation>
        </message>
        <message>
            <source>%1 of the %2 stems that count are to be checked: the basal area is %3 without and %4 with them. Look at their slices (column 'reasons' of the stem table), then accept, resize or reject them</source>
            <translation>计入的 %2 株中有 %1 株待查：不计它们时断面积为 %3，计入时为 %4。请查看它们的横切面（单木表的“reasons”列），然后接受、改直径或拒绝</translation>
        </message>
    </context>
    <context>
        <name>io</name>
        <message>
            <source>the content of '%1' is compressed again</source>
            <translation>“%1”的内容被重复压缩</translation>
        </message>
        <message>
            <source>a recording compressed once</source>
            <translation>只压缩一次的记录</translation>
        </message>
        <message>
            <source>Decompress it with zstd -d</source>
            <translation>请用 zstd -d 解压</translation>
        </message>
        <message>
            <source>topic %1 has no messages</source>
            <translation>话题 %1 没有消息</translation>
        </message>
        <message>
            <source>messages of %1</source>
            <translation>%1 的消息</translation>
        </message>
        <message>
            <source>the recording does not say which sensor it is from: beam and range noise are not known. Name it with the option sensor</source>
            <translation>记录没有说明来自哪种传感器：光束和测距噪声未知。请用选项 sensor 指定</translation>
        </message>
        <message>
            <source>no message of topic %1 holds a point within min_range and max_range</source>
            <translation>话题 %1 没有一条消息含有 min_range 与 max_range 之间的点</translation>
        </message>
        <message>
            <source>no message of topic %1 holds a point within min_range and max_range (%2)</source>
            <translation>话题 %1 没有一条消息含有 min_range 与 max_range 之间的点（%2）</translation>
        </message>
        <message>
            <source>the points have no times: they follow from the order of the points, evenly over the time between two messages, from the stamp of the message</source>
            <translation>点没有时间：按点的顺序推算，从消息的时间戳起，均匀分布在两条消息之间</translation>
        </message>
        <message>
            <source>the points have no times: they follow from their azimuths, for a clockwise sensor that starts behind and faces forward at the stamp of the message (as in KITTI)</source>
            <translation>点没有时间：按方位角推算，假定传感器顺时针旋转，从后方开始，在消息的时间戳时朝前（与 KITTI 相同）</translation>
        </message>
        <message>
            <source>the points have %1 rings, and the sensor %2 has %3: is the option sensor right?</source>
            <translation>点有 %1 条线，而传感器 %2 有 %3 条：选项 sensor 正确吗？</translation>
        </message>
        <message>
            <source>the points have no rings: %1 evenly spaced ones are assumed. Name the sensor with the option sensor</source>
            <translation>点没有线号：假定为 %1 条均匀分布的线。请用选项 sensor 指定传感器</translation>
        </message>
        <message>
            <source>%1 % of the points are left out because their tag says that they are noise (rain, dust, or between two surfaces). In dry air that is too many: the device may give its tags another meaning</source>
            <translation>%1 % 的点因标签表明是噪声（雨、灰尘，或介于两个表面之间）而舍去。在干燥空气中这太多了：该设备的标签可能另有含义</translation>
        </message>
        <message>
            <source>the points are in the axes '%1', which are not those of a scanner: ranges and rays are wrong unless both have the same origin. Choose the topic that the driver of the scanner writes</source>
            <translation>点所在的坐标轴“%1”不是扫描仪的坐标轴：除非两者原点相同，否则距离和射线都是错的。请选择扫描仪驱动程序写出的话题</translation>
        </message>
        <message>
            <source>%1 of %2 messages that were looked at hold fewer points than they declare</source>
            <translation>检查的 %2 条消息中有 %1 条所含的点少于其声明</translation>
        </message>
        <message>
            <source>frame %1 of '%2'</source>
            <translation>“%2”的第 %1 帧</translation>
        </message>
        <message>
            <source>0 to %1</source>
            <translation>0 至 %1</translation>
        </message>
        <message>
            <source>%1: %2 frame of %3, %4</source>
            <translation>%1：%2 帧，来自 %3，%4</translation>
        </message>
        <message>
            <source>%1: %2 frame of %3, %4 rings</source>
            <translation>%1：%2 帧，来自 %3，%4 线</translation>
        </message>
        <message>
            <source>%1: %2 frame of %3, rosette</source>
            <translation>%1：%2 帧，来自 %3，花瓣形扫描</translation>
        </message>
        <message>
            <source>%1: %2 frames of %3, %4</source>
            <translation>%1：%2 帧，来自 %3，%4</translation>
        </message>
        <message>
            <source>%1: %2 frames of %3, %4 rings</source>
            <translation>%1：%2 帧，来自 %3，%4 线</translation>
        </message>
        <message>
            <source>%1: %2 frames of %3, rosette</source>
            <translation>%1：%2 帧，来自 %3，花瓣形扫描</translation>
        </message>
        <message>
            <source>'%1' is listed in metadata.yaml and is not in the folder</source>
            <translation>“%1”列在 metadata.yaml 中，但不在文件夹里</translation>
        </message>
        <message>
            <source>%1 files are not listed in metadata.yaml and are left out</source>
            <translation>%1 个文件未列在 metadata.yaml 中，已舍去</translation>
        </message>
        <message>
            <source>the folder '%1' holds no recording of ROS 2</source>
            <translation>文件夹“%1”中没有 ROS 2 的记录</translation>
        </message>
        <message>
            <source>.db3 or .mcap files</source>
            <translation>.db3 或 .mcap 文件</translation>
        </message>
        <message>
            <source>'%1' cannot be read: %2</source>
            <translation>无法读取“%1”：%2</translation>
        </message>
        <message>
            <source>no file of '%1' can be read: %2</source>
            <translation>“%1”中没有一个文件可以读取：%2</translation>
        </message>
        <message>
            <source>a recording of ROS 2</source>
            <translation>ROS 2 的记录</translation>
        </message>
        <message>
            <source>there is no metadata.yaml: the %1 files are read as one recording, in order of time</source>
            <translation>没有 metadata.yaml：%1 个文件按时间顺序作为一次记录读取</translation>
        </message>
        <message>
            <source>%1 of %2 messages that metadata.yaml declares are missing</source>
            <translation>metadata.yaml 声明的 %2 条消息中缺少 %1 条</translation>
        </message>
        <message>
            <source>the files in '%1' were recorded hours apart, and there is no metadata.yaml</source>
            <translation>“%1”中的文件记录时间相差数小时，且没有 metadata.yaml</translation>
        </message>
        <message>
            <source>a folder with the files of one recording</source>
            <translation>只含同一次记录的文件的文件夹</translation>
        </message>
        <message>
            <source>Open each file by itself</source>
            <translation>请单独打开每个文件</translation>
        </message>
        <message>
            <source>topic %1 holds no measurement that can be read (no message)</source>
            <translation>话题 %1 没有可以读取的测量（没有消息）</translation>
        </message>
        <message>
            <source>topic %1 holds no measurement that can be read (values that are no numbers)</source>
            <translation>话题 %1 没有可以读取的测量（数值不是数）</translation>
        </message>
        <message>
            <source>topic %1 holds no measurement that can be read (%2)</source>
            <translation>话题 %1 没有可以读取的测量（%2）</translation>
        </message>
        <message>
            <source>%1 of %2 messages of %3 that were looked at cannot be used (%4): such messages are gaps</source>
            <translation>检查的 %3 的 %2 条消息中有 %1 条不能使用（%4）：这些消息成为间断</translation>
        </message>
        <message>
            <source>%1 of %2 messages of %3 that were looked at cannot be used (no message): such messages are gaps</source>
            <translation>检查的 %3 的 %2 条消息中有 %1 条不能使用（没有消息）：这些消息成为间断</translation>
        </message>
        <message>
            <source>%1 of %2 messages of %3 that were looked at cannot be used (values that are no numbers): such messages are gaps</source>
            <translation>检查的 %3 的 %2 条消息中有 %1 条不能使用（数值不是数）：这些消息成为间断</translation>
        </message>
        <message>
            <source>%1 of %2 messages of %3 that were looked at have the time of the one before: such messages are left out</source>
            <translation>检查的 %3 的 %2 条消息中有 %1 条的时间与前一条相同：这些消息已舍去</translation>
        </message>
        <message>
            <source>the messages of %1 have no stamps: their recording times are taken</source>
            <translation>%1 的消息没有时间戳：采用其记录时间</translation>
        </message>
        <message>
            <source>the accelerations of %1 are about 1: they are taken as multiples of gravity, as the Livox drivers write them</source>
            <translation>%1 的加速度约为 1：视为重力加速度的倍数，Livox 驱动程序即如此写出</translation>
        </message>
        <message>
            <source>the accelerations of %1 are about %2 m/s2, not 9.8: gravity is missing, or the unit is another one</source>
            <translation>%1 的加速度约为 %2 m/s2，而不是 9.8：缺少重力，或单位不同</translation>
        </message>
        <message>
            <source>the bag holds packets of an Ouster sensor, and the option sensor is '%1'</source>
            <translation>bag 文件含有 Ouster 传感器的数据包，而选项 sensor 为“%1”</translation>
        </message>
        <message>
            <source>the JSON file of the sensor, with its beams and its packet layout</source>
            <translation>传感器的 JSON 文件，含有其光束和数据包格式</translation>
        </message>
        <message>
            <source>topic %1</source>
            <translation>话题 %1</translation>
        </message>
        <message>
            <source>the bag has no topic 'metadata' with the beams of the Ouster sensor, and there is no JSON file of a sensor beside it</source>
            <translation>bag 文件没有给出 Ouster 传感器光束的话题“metadata”，其旁也没有传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>the bag has no topic 'metadata' with the beams of the Ouster sensor, and there are %1 JSON files of a sensor beside it</source>
            <translation>bag 文件没有给出 Ouster 传感器光束的话题“metadata”，其旁有 %1 个传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>one JSON file of the sensor</source>
            <translation>一个传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>Name it with the option sensor</source>
            <translation>请用选项 sensor 指定</translation>
        </message>
        <message>
            <source>%1 messages of packets cannot be read (%2)</source>
            <translation>%1 条数据包消息无法读取（%2）</translation>
        </message>
        <message>
            <source>the stamps of the inertial unit and of the scan do not overlap (they begin %1 s apart): the two have different clocks, and the unit cannot be used</source>
            <translation>惯性单元与扫描的时间戳不重叠（起点相差 %1 s）：两者时钟不同，该单元不能使用</translation>
        </message>
        <message>
            <source>%1 s of the scan, of %2 s, have no measurement of the inertial unit: was it started with the scanner, and are the clocks the same?</source>
            <translation>扫描的 %2 s 中有 %1 s 没有惯性单元的测量：它是否与扫描仪同时启动，时钟是否相同？</translation>
        </message>
        <message>
            <source>the inertial unit is left out: %1</source>
            <translation>惯性单元未采用：%1</translation>
        </message>
        <message>
            <source>the recording has more than one inertial unit: %1. None is used; name one with the option imu</source>
            <translation>记录中有多个惯性单元：%1。均未采用；请用选项 imu 指定一个</translation>
        </message>
        <message>
            <source>%1 % of the recording cannot be read</source>
            <translation>记录的 %1 % 无法读取</translation>
        </message>
        <message>
            <source>no topics</source>
            <translation>没有话题</translation>
        </message>
        <message>
            <source>the recording has no topic '%1'</source>
            <translation>记录没有话题“%1”</translation>
        </message>
        <message>
            <source>one of %1</source>
            <translation>下列之一：%1</translation>
        </message>
        <message>
            <source>Set topic=%1</source>
            <translation>请设置 topic=%1</translation>
        </message>
        <message>
            <source>Set imu=%1</source>
            <translation>请设置 imu=%1</translation>
        </message>
        <message>
            <source>topic %1 holds %2 messages of type %3</source>
            <translation>话题 %1 含有 %2 条类型为 %3 的消息</translation>
        </message>
        <message>
            <source>point clouds or packets of a scanner: %1</source>
            <translation>点云或扫描仪的数据包：%1</translation>
        </message>
        <message>
            <source>the recording has more than one scan: %1</source>
            <translation>记录含有不止一组扫描：%1</translation>
        </message>
        <message>
            <source>one of them</source>
            <translation>其中之一</translation>
        </message>
        <message>
            <source>Set topic=%1 or another one</source>
            <translation>请设置 topic=%1 或其他话题</translation>
        </message>
        <message>
            <source>the recording holds no scan: %1</source>
            <translation>记录中没有扫描：%1</translation>
        </message>
        <message>
            <source>a topic with messages of type %1</source>
            <translation>消息类型为 %1 的话题</translation>
        </message>
        <message>
            <source>topic %1 holds messages of type %2</source>
            <translation>话题 %1 含有类型为 %2 的消息</translation>
        </message>
        <message>
            <source>measurements of an inertial unit: %1</source>
            <translation>惯性单元的测量：%1</translation>
        </message>
        <message>
            <source>a compressed message of '%1' is damaged</source>
            <translation>“%1”的一条压缩消息已损坏</translation>
        </message>
        <message>
            <source>a whole zstd frame</source>
            <translation>完整的 zstd 帧</translation>
        </message>
        <message>
            <source>'%1' is no MCAP file</source>
            <translation>“%1”不是 MCAP 文件</translation>
        </message>
        <message>
            <source>an MCAP file</source>
            <translation>MCAP 文件</translation>
        </message>
        <message>
            <source>'%1' is an MCAP file of another version</source>
            <translation>“%1”是其他版本的 MCAP 文件</translation>
        </message>
        <message>
            <source>MCAP version 0</source>
            <translation>MCAP 版本 0</translation>
        </message>
        <message>
            <source>the file has no usable summary (not closed, or cut off): its records were gone through</source>
            <translation>文件没有可用的摘要（未关闭或被截断）：已逐条查找其记录</translation>
        </message>
        <message>
            <source>chunks compressed with '%1' cannot be read</source>
            <translation>无法读取用“%1”压缩的数据块</translation>
        </message>
        <message>
            <source>looking for messages</source>
            <translation>查找消息</translation>
        </message>
        <message>
            <source>the file is cut off or damaged at byte %1 of %2: what comes before is read</source>
            <translation>文件在 %2 字节中的第 %1 字节处被截断或损坏：读取其前的内容</translation>
        </message>
        <message>
            <source>a chunk of the file is damaged: the messages before the damage are read</source>
            <translation>文件的一个数据块已损坏：读取损坏处之前的消息</translation>
        </message>
        <message>
            <source>topic %1 has %2 messages, and the file declares %3</source>
            <translation>话题 %1 有 %2 条消息，而文件声明有 %3 条</translation>
        </message>
        <message>
            <source>a message of '%1' cannot be read: its chunk is damaged</source>
            <translation>无法读取“%1”的一条消息：其数据块已损坏</translation>
        </message>
        <message>
            <source>a whole chunk</source>
            <translation>完整的数据块</translation>
        </message>
        <message>
            <source>Copy the file again from where it was recorded</source>
            <translation>请从记录处重新复制该文件</translation>
        </message>
        <message>
            <source>%1 messages of %2 are there twice: each is read once</source>
            <translation>%2 的 %1 条消息重复：每条只读一次</translation>
        </message>
        <message>
            <source>%1 of %2 messages of %3 have a recording time that no clock shows (before 1970 or after 2262): they are read first, which may not be their place</source>
            <translation>%3 的 %2 条消息中有 %1 条的记录时间不可能出自任何时钟（早于 1970 年或晚于 2262 年）：它们最先读取，这可能不是其应有的位置</translation>
        </message>
        <message>
            <source>about %1 messages of %2 are missing between the %3 that were recorded: the scan has gaps in time</source>
            <translation>在记录的 %3 条消息之间，%2 约缺少 %1 条：扫描在时间上有间断</translation>
        </message>
        <message>
            <source>the messages are not serialised by ROS</source>
            <translation>消息不是由 ROS 序列化的</translation>
        </message>
        <message>
            <source>ROS 1 or CDR</source>
            <translation>ROS 1 或 CDR</translation>
        </message>
        <message>
            <source>the message is serialised in another way (%1)</source>
            <translation>消息的序列化方式不同（%1）</translation>
        </message>
        <message>
            <source>plain CDR</source>
            <translation>普通 CDR</translation>
        </message>
        <message>
            <source>Record it again with the middleware's standard serialisation, or convert it with ros2 bag convert</source>
            <translation>请用中间件的标准序列化方式重新记录，或用 ros2 bag convert 转换</translation>
        </message>
        <message>
            <source>the message is cut off</source>
            <translation>消息被截断</translation>
        </message>
        <message>
            <source>a whole message</source>
            <translation>完整的消息</translation>
        </message>
        <message>
            <source>the clouds have the fields none</source>
            <translation>点云没有字段</translation>
        </message>
        <message>
            <source>the clouds have the fields %1</source>
            <translation>点云的字段为 %1</translation>
        </message>
        <message>
            <source>fields x, y and z</source>
            <translation>字段 x、y 和 z</translation>
        </message>
        <message>
            <source>'%1' is a bag of version '%2'</source>
            <translation>“%1”是版本“%2”的 bag 文件</translation>
        </message>
        <message>
            <source>'%1' is no ROS 1 bag</source>
            <translation>“%1”不是 ROS 1 的 bag 文件</translation>
        </message>
        <message>
            <source>a bag of version 2.0</source>
            <translation>版本 2.0 的 bag 文件</translation>
        </message>
        <message>
            <source>Convert it with rosbag migrate</source>
            <translation>请用 rosbag migrate 转换</translation>
        </message>
        <message>
            <source>the bag was not closed and has no index: its records were gone through</source>
            <translation>bag 文件未关闭，没有索引：已逐条查找其记录</translation>
        </message>
        <message>
            <source>the index of the bag is damaged: its records were gone through</source>
            <translation>bag 文件的索引已损坏：已逐条查找其记录</translation>
        </message>
        <message>
            <source>the last chunk of the bag was not finished: what it holds is read</source>
            <translation>bag 文件的最后一个数据块未写完：读取其已有的内容</translation>
        </message>
        <message>
            <source>the bag is cut off or damaged at byte %1 of %2: what comes before is read</source>
            <translation>bag 文件在 %2 字节中的第 %1 字节处被截断或损坏：读取其前的内容</translation>
        </message>
        <message>
            <source>a chunk of the bag is damaged: the messages before the damage are read</source>
            <translation>bag 文件的一个数据块已损坏：读取损坏处之前的消息</translation>
        </message>
        <message>
            <source>a chunk has %1 messages of %2, and the bag declares %3</source>
            <translation>一个数据块有 %2 的 %1 条消息，而 bag 文件声明有 %3 条</translation>
        </message>
        <message>
            <source>Copy the bag again from where it was recorded</source>
            <translation>请从记录处重新复制该 bag 文件</translation>
        </message>
        <message>
            <source>the scratch file for a compressed recording cannot be written</source>
            <translation>无法写出压缩记录的临时文件</translation>
        </message>
        <message>
            <source>room on the disk</source>
            <translation>磁盘空间</translation>
        </message>
        <message>
            <source>the content of '%1' has more than %2 MB, and the disk of '%3' has %4 MB left</source>
            <translation>“%1”的内容超过 %2 MB，而“%3”所在磁盘只剩 %4 MB</translation>
        </message>
        <message>
            <source>room on the disk for the whole content, and %1 MB more</source>
            <translation>可容纳全部内容的磁盘空间，另加 %1 MB</translation>
        </message>
        <message>
            <source>there is no folder for the content of '%1'</source>
            <translation>没有可存放“%1”内容的文件夹</translation>
        </message>
        <message>
            <source>decompressing %1</source>
            <translation>解压 %1</translation>
        </message>
        <message>
            <source>'%1' holds nothing that can be decompressed</source>
            <translation>“%1”中没有可以解压的内容</translation>
        </message>
        <message>
            <source>a whole zstd file</source>
            <translation>完整的 zstd 文件</translation>
        </message>
        <message>
            <source>the log '%1-wal' cannot be read: its messages are missing. Copy the recording to a folder that may be written to</source>
            <translation>无法读取日志“%1-wal”：其中的消息缺失。请将记录复制到可写的文件夹</translation>
        </message>
        <message>
            <source>'%1' cannot be opened: %2</source>
            <translation>无法打开“%1”：%2</translation>
        </message>
        <message>
            <source>an SQLite database</source>
            <translation>SQLite 数据库</translation>
        </message>
        <message>
            <source>Copy it to a folder of your own that may be read</source>
            <translation>请将其复制到自己可读的文件夹</translation>
        </message>
        <message>
            <source>'%1' is no SQLite database</source>
            <translation>“%1”不是 SQLite 数据库</translation>
        </message>
        <message>
            <source>'%1' is no recording of ROS 2 (%2)</source>
            <translation>“%1”不是 ROS 2 的记录（%2）</translation>
        </message>
        <message>
            <source>a database with the tables topics and messages</source>
            <translation>含有表 topics 和 messages 的数据库</translation>
        </message>
        <message>
            <source>the database is cut off or damaged (%1): %2 messages are read</source>
            <translation>数据库被截断或损坏（%1）：读取 %2 条消息</translation>
        </message>
        <message>
            <source>a message of '%1' cannot be read: %2</source>
            <translation>无法读取“%1”的一条消息：%2</translation>
        </message>
        <message>
            <source>a whole database</source>
            <translation>完整的数据库</translation>
        </message>
        <message>
            <source>the clock of the points differs from that of the messages by %1 s: points get the times of the messages' clock, with the start of the sweep at the stamp</source>
            <translation>点的时钟与消息的时钟相差 %1 s：点采用消息时钟的时间，以时间戳为一圈扫描的起点</translation>
        </message>
        <message>
            <source>. the clock of the points jumps by up to %1 s against that of the messages: such frames start at the stamps of their messages</source>
            <translation>。点的时钟相对消息的时钟跳变达 %1 s：这些帧从其消息的时间戳开始</translation>
        </message>
        <message>
            <source>the clock of the points jumps by up to %1 s against that of the messages: such frames start at the stamps of their messages</source>
            <translation>点的时钟相对消息的时钟跳变达 %1 s：这些帧从其消息的时间戳开始</translation>
        </message>
        <message>
            <source>the messages were recorded %1 after their stamp, but their points last %2 from it: the stamp may be the end of the sweep. All times may be late by %3</source>
            <translation>消息在其时间戳之后 %1 才被记录，但其中的点从时间戳起持续 %2：时间戳可能是一圈扫描的终点。所有时间可能晚 %3</translation>
        </message>
        <message>
            <source>the field '%1' (%2) is no time of points: all points of a message have the same value</source>
            <translation>字段“%1”（%2）不是点的时间：一条消息的所有点取值相同</translation>
        </message>
        <message>
            <source>the field '%1' (%2) is no time of points: its values span %3 in a message, and messages are %4 s apart</source>
            <translation>字段“%1”（%2）不是点的时间：其值在一条消息内跨 %3，而消息间隔为 %4 s</translation>
        </message>
        <message>
            <source>the time bases of the messages differ from their stamps by up to %1 s: points are timed from the stamps</source>
            <translation>消息的时间基准与其时间戳相差达 %1 s：点的时间自时间戳起算</translation>
        </message>
        <message>
            <source>a file that exists and may be read</source>
            <translation>存在且可读的文件</translation>
        </message>
        <message>
            <source>'%1' is not a file</source>
            <translation>“%1”不是文件</translation>
        </message>
        <message>
            <source>'%1' cannot be mapped into memory: %2</source>
            <translation>无法将“%1”映射到内存：%2</translation>
        </message>
        <message>
            <source>x %1 to %2, y %3 to %4, z %5 to %6</source>
            <translation>x %1 至 %2，y %3 至 %4，z %5 至 %6</translation>
        </message>
        <message>
            <source>option bounds is '%1'</source>
            <translation>选项 bounds 为“%1”</translation>
        </message>
        <message>
            <source>xmin,ymin,xmax,ymax or xmin,ymin,zmin,xmax,ymax,zmax, in the coordinates of the file</source>
            <translation>按文件坐标给出的 xmin,ymin,xmax,ymax 或 xmin,ymin,zmin,xmax,ymax,zmax</translation>
        </message>
        <message>
            <source>option bounds is '%1': a smallest coordinate is above the largest</source>
            <translation>选项 bounds 为“%1”：最小坐标大于最大坐标</translation>
        </message>
        <message>
            <source>, z %1 to %2</source>
            <translation>，z %1 至 %2</translation>
        </message>
        <message>
            <source>x %1 to %2, y %3 to %4</source>
            <translation>x %1 至 %2，y %3 至 %4</translation>
        </message>
        <message>
            <source>no point of the file lies within the option bounds (%1)</source>
            <translation>文件中没有点在选项 bounds 之内（%1）</translation>
        </message>
        <message>
            <source>bounds that meet those of the file: %1</source>
            <translation>与文件范围相交的范围：%1</translation>
        </message>
        <message>
            <source>Give bounds in the coordinates of the file</source>
            <translation>请按文件的坐标给出范围</translation>
        </message>
        <message>
            <source>reading points</source>
            <translation>读取点</translation>
        </message>
        <message>
            <source>the file is cut off: the header declares %1 points, %2 are present and were read</source>
            <translation>文件被截断：文件头声明 %1 个点，现有并已读取 %2 个</translation>
        </message>
        <message>
            <source>the points have no x</source>
            <translation>点没有 x</translation>
        </message>
        <message>
            <source>the points have no y</source>
            <translation>点没有 y</translation>
        </message>
        <message>
            <source>the points have no z</source>
            <translation>点没有 z</translation>
        </message>
        <message>
            <source>There are no fields</source>
            <translation>没有任何字段</translation>
        </message>
        <message>
            <source>There are: %1</source>
            <translation>现有字段：%1</translation>
        </message>
        <message>
            <source>%1 points dropped: their coordinates are not numbers</source>
            <translation>舍去 %1 个点：其坐标不是数</translation>
        </message>
        <message>
            <source>the file holds no points</source>
            <translation>文件中没有点</translation>
        </message>
        <message>
            <source>%1 of %2 points lie more than 100 000 km from the origin, as the bounds in the header of the file say: these are no coordinates in metres. Set the option unit, or repair scale and offset in the header</source>
            <translation>%2 个点中有 %1 个距原点超过 100 000 km，与文件头中的范围一致：这不是以米为单位的坐标。请设置选项 unit，或修复文件头中的比例和偏移</translation>
        </message>
        <message>
            <source>%1 of %2 points lie more than 100 000 km from the origin: crop or repair the cloud</source>
            <translation>%2 个点中有 %1 个距原点超过 100 000 km：请裁剪或修复点云</translation>
        </message>
        <message>
            <source>the option resolution has no effect: this file of the format %1 has no levels that can be used, all of its points were read. Convert it to COPC, or set resolution=0</source>
            <translation>选项 resolution 不起作用：这个 %1 格式的文件没有可用的层级，已读取全部点。请转换为 COPC，或设置 resolution=0</translation>
        </message>
        <message>
            <source>%1: %2 points (%3)</source>
            <translation>%1：%2 个点（%3）</translation>
        </message>
        <message>
            <source>writing points</source>
            <translation>写出点</translation>
        </message>
        <message>
            <source>the file is cut off within its last point</source>
            <translation>文件在最后一个点的中间被截断</translation>
        </message>
        <message>
            <source>%1 million points: terrain and stems need about %2 GiB of memory in all, and %3 GiB are free beside the points. If the run ends for lack of memory, cut the plot into parts that overlap by 20 m, or thin the file</source>
            <translation>%1 百万个点：地形和单木共需约 %2 GiB 内存，除点以外还有 %3 GiB 可用。如果运行因内存不足而中止，请将样地切成重叠 20 m 的几部分，或抽稀文件</translation>
        </message>
        <message>
            <source>%1 lines with fewer than %2 values were skipped</source>
            <translation>跳过了 %1 行，其数值少于 %2 个</translation>
        </message>
        <message>
            <source>%1 lines without the properties of a vertex were skipped</source>
            <translation>跳过了 %1 行，其中没有顶点的属性</translation>
        </message>
        <message>
            <source>the file holds no points: it has no element 'vertex'</source>
            <translation>文件中没有点：没有元素“vertex”</translation>
        </message>
        <message>
            <source>reading lines</source>
            <translation>读取各行</translation>
        </message>
        <message>
            <source>the file is cut off: %1 points of the grid are missing</source>
            <translation>文件被截断：格网缺少 %1 个点</translation>
        </message>
        <message>
            <source>the coordinates are longitude and latitude: lengths cannot be measured in them. Project the cloud to a metric system first</source>
            <translation>坐标是经度和纬度：不能用来量测长度。请先将点云投影到米制坐标系</translation>
        </message>
        <message>
            <source>the coordinate system of the file counts in units of %1 m: the coordinates were turned to metres, and results carry no coordinate system. unit=metre takes them as they are</source>
            <translation>文件的坐标系以 %1 m 为单位：坐标已换算为米，结果不带坐标系。unit=metre 则照原样采用</translation>
        </message>
        <message>
            <source>the coordinates were turned from %1 to metres: results carry no coordinate system</source>
            <translation>坐标已由 %1 换算为米：结果不带坐标系</translation>
        </message>
        <message>
            <source>the coordinates are %1s: %2 stems of %3 cm stand in the cloud when they are taken so. unit=%4 says it, unit=metre takes them as they are</source>
            <translation>坐标以 %1 为单位：如此理解时，点云中有 %2 株直径 %3 cm 的单木。unit=%4 即指定此单位，unit=metre 则照原样采用</translation>
        </message>
        <message>
            <source>the cloud is hundreds of metres long, wide and high with hardly a point per square metre: the unit looks like millimetres or centimetres. Set unit</source>
            <translation>点云长、宽、高达数百米，每平方米几乎不到一个点：单位看来是毫米或厘米。请设置 unit</translation>
        </message>
        <message>
            <source>the cloud is %1 m high over %2 m x %3 m: no tree is that tall, in feet neither. z looks like centimetres or millimetres where x and y are metres, or points lie far above the stand. Give x, y and z in the same unit</source>
            <translation>点云在 %2 m x %3 m 的范围内高 %1 m：没有这么高的树，以英尺计也没有。z 看来以厘米或毫米为单位而 x 和 y 以米为单位，或有点远高于林分。请使 x、y 和 z 的单位相同</translation>
        </message>
        <message>
            <source>the trees are %1 m tall and their stems %2 cm thick: they are too stout for trees in any unit. Points below the ground, or a cloud without crowns, look so. Set unit where it is not metres</source>
            <translation>树高 %1 m，树干粗 %2 cm：无论用何种单位，对树木而言都过于粗短。地面以下的点，或没有树冠的点云，会呈现这种情况。如果单位不是米，请设置 unit</translation>
        </message>
        <message>
            <source>the trees are %1 m tall%2: they are too stout for trees in any unit. Points below the ground, or a cloud without crowns, look so. Set unit where it is not metres</source>
            <translation>树高 %1 m%2：无论用何种单位，对树木而言都过于粗短。地面以下的点，或没有树冠的点云，会呈现这种情况。如果单位不是米，请设置 unit</translation>
        </message>
        <message>
            <source>the trees are %1 m tall and their stems %2 cm thick: the unit looks like feet. Set unit=foot, or unit=metre where the stand is that tall</source>
            <translation>树高 %1 m，树干粗 %2 cm：单位看来是英尺。请设置 unit=foot；如果林分确实这么高，请设置 unit=metre</translation>
        </message>
        <message>
            <source>the trees are %1 m tall%2: the unit looks like feet. Set unit=foot, or unit=metre where the stand is that tall</source>
            <translation>树高 %1 m%2：单位看来是英尺。请设置 unit=foot；如果林分确实这么高，请设置 unit=metre</translation>
        </message>
        <message>
            <source>%1 along %2</source>
            <translation>%1 株沿 %2</translation>
        </message>
        <message>
            <source>, %1 along %2</source>
            <translation>，%1 株沿 %2</translation>
        </message>
        <message>
            <source>with up=%1 the stems lie: %2. Set up=auto, or another axis</source>
            <translation>按 up=%1，树干是横卧的：%2。请设置 up=auto 或其他轴</translation>
        </message>
        <message>
            <source>%1 is up: %2 of the stems stand so (%3). The cloud was turned; up=%4 says it, up=z takes it as it is</source>
            <translation>%1 轴朝上：%2 株单木沿此竖立（%3）。点云已旋转；up=%4 即指定此轴，up=z 则照原样采用</translation>
        </message>
        <message>
            <source>%1 may be up: a smooth ground lies across it. The cloud was read with z up; set up=%2, or up=z where that is right</source>
            <translation>%1 轴可能朝上：有平滑的地面与之垂直。点云按 z 朝上读取；请设置 up=%2；如果 z 正确，请设置 up=z</translation>
        </message>
        <message>
            <source>%1 may be up: stems stand along it (%2), and a smooth ground lies across it. The cloud was read with z up; set up=%3, or up=z where that is right</source>
            <translation>%1 轴可能朝上：单木沿此竖立（%2），且有平滑的地面与之垂直。点云按 z 朝上读取；请设置 up=%3；如果 z 正确，请设置 up=z</translation>
        </message>
        <message>
            <source>%1 may be up: stems stand along it (%2). The cloud was read with z up; set up=%3, or up=z where that is right</source>
            <translation>%1 轴可能朝上：单木沿此竖立（%2）。点云按 z 朝上读取；请设置 up=%3；如果 z 正确，请设置 up=z</translation>
        </message>
        <message>
            <source>the cloud was not levelled: %1 stems were found to level by, 5 are needed. Set level=none where it is level</source>
            <translation>点云未整平：只找到 %1 株可用于整平的单木，需要 5 株。如果点云本来水平，请设置 level=none</translation>
        </message>
        <message>
            <source>the cloud was turned by %1 deg, until its %2 stems are vertical on average</source>
            <translation>点云已旋转 %1 度，使其 %2 株单木平均而言竖直</translation>
        </message>
        <message>
            <source>the %1 stems lean by %2 +- %3 deg in common: the cloud is not level, or they all grow so. Set level=stems to make it level; heights and breast height follow</source>
            <translation>%1 株单木共同倾斜 %2 +- %3 度：点云不水平，或它们都如此生长。请设置 level=stems 使其水平；高度和胸高随之改变</translation>
        </message>
        <message>
            <source>the stems have two walls, %1 cm apart towards %2 deg: the cloud holds two registrations that do not meet, and diameters are of both together. Register the scans anew</source>
            <translation>树干有两层壁，相距 %1 cm，方向 %2 度：点云含有两次不重合的配准，直径是两者合在一起的。请重新配准各次扫描</translation>
        </message>
        <message>
            <source>no stem is seen at %1 points per m2: too sparse, or airborne. It is good for terrain and heights; diameters cannot be measured in it</source>
            <translation>每 m2 %1 个点，看不到树干：太稀，或为机载数据。可用于地形和树高；不能用来测直径</translation>
        </message>
        <message>
            <source>too sparse for diameters: %1 points per stem are needed on the 1.3 m about breast height, %2 were found (median of %3 stems). Use a denser cloud</source>
            <translation>太稀，不能测直径：胸高上下 1.3 m 内每株需要 %1 个点，只有 %2 个（%3 株的中位数）。请使用更密的点云</translation>
        </message>
        <message>
            <source>the cloud is a single tree without ground around it: its heights are counted from its lowest points</source>
            <translation>点云是一株单独的树，周围没有地面：其高度自最低点起算</translation>
        </message>
        <message>
            <source>%1 % of the points have the coordinates of another one: intervals come out too narrow where points count twice. Remove them, or keep more digits</source>
            <translation>%1 % 的点与另一个点坐标相同：重复计点会使区间过窄。请去掉重复点，或保留更多位数</translation>
        </message>
        <message>
            <source>%1 points, given in memory</source>
            <translation>%1 个点，由内存给出</translation>
        </message>
        <message>
            <source>the file declares %1 points and holds %2: all were read. Is it made of several scans?</source>
            <translation>文件声明 %1 个点，实有 %2 个：已全部读取。它是由多次扫描合成的吗？</translation>
        </message>
        <message>
            <source>the column '%1' holds words in %2 lines (the first: '%3'): they count as no value, 0 in a column of whole numbers. Write numbers</source>
            <translation>列“%1”有 %2 行是文字（第一个：“%3”）：它们视为无值，在整数列中为 0。请写成数</translation>
        </message>
        <message>
            <source>the column '%1' holds words in %2 lines (the first: '%3'): they count as no value, 0 in a column of whole numbers. Write numbers (2 is ground, 5 is high vegetation)</source>
            <translation>列“%1”有 %2 行是文字（第一个：“%3”）：它们视为无值，在整数列中为 0。请写成数（2 为地面，5 为高植被）</translation>
        </message>
        <message>
            <source>%1 lines without %2 numbers were skipped; the first is line %3</source>
            <translation>跳过了 %1 行，其中不足 %2 个数；第一处为第 %3 行</translation>
        </message>
        <message>
            <source>building the octree</source>
            <translation>建立八叉树</translation>
        </message>
        <message>
            <source>the record of COPC is damaged: the file is read as LAZ, without its octree</source>
            <translation>COPC 记录已损坏：文件按 LAZ 读取，不用其八叉树</translation>
        </message>
        <message>
            <source>%1 of %2 points of node %3-%4-%5-%6 of '%7' cannot be read: the file is damaged there</source>
            <translation>“%7”的节点 %3-%4-%5-%6 的 %2 个点中有 %1 个无法读取：文件在该处已损坏</translation>
        </message>
        <message>
            <source>%1 points of the nodes that meet the box cannot be read: the file is damaged there</source>
            <translation>与范围框相交的节点中有 %1 个点无法读取：文件在该处已损坏</translation>
        </message>
        <message>
            <source>%1 says not where its points lie: it is left out</source>
            <translation>%1 没有说明其点的位置：已舍去</translation>
        </message>
        <message>
            <source>%1 has fields of an unknown type, or with limits or scales that are no numbers: it is left out</source>
            <translation>%1 含有类型未知的字段，或其界限或比例不是数：已舍去</translation>
        </message>
        <message>
            <source>the pose of %1 is no rotation and translation: it is left out</source>
            <translation>%1 的位姿不是旋转加平移：已舍去</translation>
        </message>
        <message>
            <source>scan %1</source>
            <translation>扫描 %1</translation>
        </message>
        <message>
            <source>scan %1 ('%2')</source>
            <translation>扫描 %1（“%2”）</translation>
        </message>
        <message>
            <source>the description of the file ends early (%1): scans may be missing</source>
            <translation>文件的描述提前结束（%1）：可能缺少扫描</translation>
        </message>
        <message>
            <source>%1 images were skipped</source>
            <translation>跳过了 %1 幅图像</translation>
        </message>
        <message>
            <source>the scans declare different limits of their intensities: these are given as the file has them, and those of different scans cannot be compared</source>
            <translation>各次扫描声明的强度界限不同：强度按文件原样给出，不同扫描的强度不能互相比较</translation>
        </message>
        <message>
            <source>%1 pages of the file have a wrong checksum: %2 points in them were left out. Copy or export the file again</source>
            <translation>文件有 %1 页校验和错误：其中的 %2 个点已舍去。请重新复制或导出文件</translation>
        </message>
        <message>
            <source>%1 of %2 points read: the others are damaged or missing</source>
            <translation>读取了 %2 个点中的 %1 个：其余已损坏或缺失</translation>
        </message>
        <message>
            <source>the file is cut off: %1 of %2 bytes are present</source>
            <translation>文件被截断：现有 %2 字节中的 %1 字节</translation>
        </message>
        <message>
            <source>the origin of %1 lies beside all of its points</source>
            <translation>%1 的原点在其所有点的一侧</translation>
        </message>
        <message>
            <source>most points of %1 are more than 500 m from its origin</source>
            <translation>%1 的多数点距其原点超过 500 m</translation>
        </message>
        <message>
            <source>%1: stems are measured without rays. Set scan_positions=given where the poses of the file are places of the scanner</source>
            <translation>%1：单木不用射线测定。如果文件中的位姿就是扫描仪的位置，请设置 scan_positions=given</translation>
        </message>
        <message>
            <source>the file does not say where the scanner stood (no pose but a shift, no grid and no angles, or scans that were merged)</source>
            <translation>文件没有说明扫描仪的位置（除平移外没有位姿，没有格网和角度，或扫描已合并）</translation>
        </message>
        <message>
            <source>%1, so that its pose need not be where the scanner stood</source>
            <translation>%1，因此其位姿未必是扫描仪的位置</translation>
        </message>
        <message>
            <source>rays go out from the places of %1 scans. Set scan_positions=none where the points were measured from elsewhere</source>
            <translation>射线从 %1 次扫描的位置发出。如果点是从别处测得的，请设置 scan_positions=none</translation>
        </message>
        <message>
            <source>a scan</source>
            <translation>扫描</translation>
        </message>
        <message>
            <source>a point cloud</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>%1 of %2 points lie more than 100 000 km from the origin: these are no coordinates in metres</source>
            <translation>%2 个点中有 %1 个距原点超过 100 000 km：这不是以米为单位的坐标</translation>
        </message>
        <message>
            <source>Is the file damaged or of another kind? Else set the option unit, or the columns of a text file</source>
            <translation>文件是否已损坏或属于其他类型？否则请设置选项 unit，或文本文件的列</translation>
        </message>
        <message>
            <source>no point cloud is named</source>
            <translation>没有指定点云</translation>
        </message>
        <message>
            <source>Set the option file</source>
            <translation>请设置选项 file</translation>
        </message>
        <message>
            <source>a point cloud file</source>
            <translation>点云文件</translation>
        </message>
        <message>
            <source>Read it with the stage %1</source>
            <translation>请用步骤 %1 读取</translation>
        </message>
        <message>
            <source>PCD field '%1' has type %2 of %3 bytes</source>
            <translation>PCD 字段“%1”的类型为 %3 字节的 %2</translation>
        </message>
        <message>
            <source>F of 4 or 8, I or U of 1, 2, 4 or 8 bytes</source>
            <translation>4 或 8 字节的 F，1、2、4 或 8 字节的 I 或 U</translation>
        </message>
        <message>
            <source>PCD header: %1 has '%2'</source>
            <translation>PCD 文件头：%1 为“%2”</translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation>整数</translation>
        </message>
        <message>
            <source>PCD header: %1 has %2 entries</source>
            <translation>PCD 文件头：%1 有 %2 项</translation>
        </message>
        <message>
            <source>%1, one per field</source>
            <translation>%1 项，每个字段一项</translation>
        </message>
        <message>
            <source>PCD header: %1 fields</source>
            <translation>PCD 文件头：%1 个字段</translation>
        </message>
        <message>
            <source>the PCD header has no line DATA after %1 lines</source>
            <translation>PCD 文件头在 %1 行之后仍没有 DATA 行</translation>
        </message>
        <message>
            <source>DATA ascii, binary or binary_compressed</source>
            <translation>DATA ascii、binary 或 binary_compressed</translation>
        </message>
        <message>
            <source>the PCD header names %1 values per point</source>
            <translation>PCD 文件头声明每点 %1 个值</translation>
        </message>
        <message>
            <source>the compressed PCD data has %1 bytes</source>
            <translation>压缩的 PCD 数据有 %1 字节</translation>
        </message>
        <message>
            <source>two sizes of 4 bytes and the data</source>
            <translation>两个 4 字节的长度和数据</translation>
        </message>
        <message>
            <source>the file is cut off: compressed PCD data of %1 bytes, %2 are there</source>
            <translation>文件被截断：压缩的 PCD 数据有 %1 字节，实有 %2 字节</translation>
        </message>
        <message>
            <source>the whole file</source>
            <translation>完整的文件</translation>
        </message>
        <message>
            <source>Compressed PCD data cannot be read in part: copy the file again</source>
            <translation>压缩的 PCD 数据不能部分读取：请重新复制文件</translation>
        </message>
        <message>
            <source>compressed PCD data of %1 bytes for %2 points</source>
            <translation>%2 个点的压缩 PCD 数据有 %1 字节</translation>
        </message>
        <message>
            <source>%1 bytes per point</source>
            <translation>每点 %1 字节</translation>
        </message>
        <message>
            <source>the compressed PCD data is damaged: %1</source>
            <translation>压缩的 PCD 数据已损坏：%1</translation>
        </message>
        <message>
            <source>LZF data</source>
            <translation>LZF 数据</translation>
        </message>
        <message>
            <source>it claims to unpack to more than it can</source>
            <translation>声明解压后的大小不可能达到</translation>
        </message>
        <message>
            <source>a run goes beyond the end</source>
            <translation>一段数据超出末尾</translation>
        </message>
        <message>
            <source>it ends within a length</source>
            <translation>在长度字段中间结束</translation>
        </message>
        <message>
            <source>it ends within a reference</source>
            <translation>在引用中间结束</translation>
        </message>
        <message>
            <source>a reference goes beyond the data</source>
            <translation>引用超出数据</translation>
        </message>
        <message>
            <source>it unpacks to too few bytes</source>
            <translation>解压后字节太少</translation>
        </message>
        <message>
            <source>the PCD header names no fields</source>
            <translation>PCD 文件头没有指定字段</translation>
        </message>
        <message>
            <source>a line FIELDS x y z</source>
            <translation>一行 FIELDS x y z</translation>
        </message>
        <message>
            <source>PCD data is '%1'</source>
            <translation>PCD 数据为“%1”</translation>
        </message>
        <message>
            <source>ascii, binary or binary_compressed</source>
            <translation>ascii、binary 或 binary_compressed</translation>
        </message>
        <message>
            <source>PLY header line %1: type '%2'</source>
            <translation>PLY 文件头第 %1 行：类型“%2”</translation>
        </message>
        <message>
            <source>char, uchar, short, ushort, int, uint, float or double</source>
            <translation>char、uchar、short、ushort、int、uint、float 或 double</translation>
        </message>
        <message>
            <source>PLY header line %1 is '%2'</source>
            <translation>PLY 文件头第 %1 行为“%2”</translation>
        </message>
        <message>
            <source>the PLY header has no line format</source>
            <translation>PLY 文件头没有 format 行</translation>
        </message>
        <message>
            <source>format ascii, binary_little_endian or binary_big_endian 1.0</source>
            <translation>format 为 ascii、binary_little_endian 或 binary_big_endian 1.0</translation>
        </message>
        <message>
            <source>element NAME COUNT</source>
            <translation>一行 element NAME COUNT</translation>
        </message>
        <message>
            <source>at most %1 properties</source>
            <translation>至多 %1 个属性</translation>
        </message>
        <message>
            <source>property list COUNT_TYPE TYPE NAME</source>
            <translation>一行 property list COUNT_TYPE TYPE NAME</translation>
        </message>
        <message>
            <source>format, element, property, comment or end_header</source>
            <translation>format、element、property、comment 或 end_header</translation>
        </message>
        <message>
            <source>the PLY header does not end after %1 lines</source>
            <translation>PLY 文件头在 %1 行之后仍未结束</translation>
        </message>
        <message>
            <source>a line end_header</source>
            <translation>一行 end_header</translation>
        </message>
        <message>
            <source>the file is cut off in the PLY element '%1', before the points</source>
            <translation>文件在点之前的 PLY 元素“%1”中被截断</translation>
        </message>
        <message>
            <source>the PLY format is '%1'</source>
            <translation>PLY 格式为“%1”</translation>
        </message>
        <message>
            <source>ascii, binary_little_endian or binary_big_endian</source>
            <translation>ascii、binary_little_endian 或 binary_big_endian</translation>
        </message>
        <message>
            <source>PTX line %1 is '%2'</source>
            <translation>PTX 第 %1 行为“%2”</translation>
        </message>
        <message>
            <source>the PTX file ends after line %1</source>
            <translation>PTX 文件在第 %1 行之后结束</translation>
        </message>
        <message>
            <source>the number of rows</source>
            <translation>行数</translation>
        </message>
        <message>
            <source>the PTX grid has %1 columns and %2 rows</source>
            <translation>PTX 格网有 %1 列和 %2 行</translation>
        </message>
        <message>
            <source>the scanner's position and axes, three numbers</source>
            <translation>扫描仪的位置和坐标轴，各三个数</translation>
        </message>
        <message>
            <source>a row of the 4 by 4 transformation</source>
            <translation>4 x 4 变换矩阵的一行</translation>
        </message>
        <message>
            <source>the number of columns of a scan</source>
            <translation>一次扫描的列数</translation>
        </message>
        <message>
            <source>x y z, with or without intensity and red green blue</source>
            <translation>x y z，可带强度和红绿蓝</translation>
        </message>
        <message>
            <source>the PTX file holds no points</source>
            <translation>PTX 文件中没有点</translation>
        </message>
        <message>
            <source>lines x y z intensity below the header of a scan</source>
            <translation>扫描文件头之后的 x y z 强度各行</translation>
        </message>
        <message>
            <source>the lines are poses of a trajectory</source>
            <translation>各行是轨迹的位姿</translation>
        </message>
        <message>
            <source>Read it with the stage io.read_trajectory, or name the columns with the option columns</source>
            <translation>请用步骤 io.read_trajectory 读取，或用选项 columns 指定各列</translation>
        </message>
        <message>
            <source>the first column counts the rows</source>
            <translation>第一列是行号</translation>
        </message>
        <message>
            <source>x, y and z</source>
            <translation>列 x、y 和 z</translation>
        </message>
        <message>
            <source>Name the columns with the option columns, for instance "_ x y z"</source>
            <translation>请用选项 columns 指定各列，例如 "_ x y z"</translation>
        </message>
        <message>
            <source>the numbers have no decimal points, and every second one has the same number of digits</source>
            <translation>各数没有小数点，且每隔一个数的位数相同</translation>
        </message>
        <message>
            <source>numbers that can be told apart: decimal commas do not go with commas between the columns</source>
            <translation>可以区分的数：小数逗号不能与列间的逗号并用</translation>
        </message>
        <message>
            <source>Write the file with points or with semicolons between the columns; if the commas do separate columns, set the option delimiter to comma</source>
            <translation>请用小数点书写文件，或用分号分隔各列；如果逗号确实分隔各列，请将选项 delimiter 设为 comma</translation>
        </message>
        <message>
            <source>line %1 has %2 columns</source>
            <translation>第 %1 行有 %2 列</translation>
        </message>
        <message>
            <source>the header line '%1' does not name x, y and z</source>
            <translation>标题行“%1”没有指定 x、y 和 z</translation>
        </message>
        <message>
            <source>a header line with x, y and z</source>
            <translation>含有 x、y 和 z 的标题行</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>文件为空</translation>
        </message>
        <message>
            <source>points as text</source>
            <translation>文本形式的点</translation>
        </message>
        <message>
            <source>none of the first %1 lines holds three numbers</source>
            <translation>前 %1 行中没有一行含有三个数</translation>
        </message>
        <message>
            <source>lines with x, y and z</source>
            <translation>含有 x、y 和 z 的各行</translation>
        </message>
        <message>
            <source>If the points begin further down, set the option skip_lines</source>
            <translation>如果点从更靠后处开始，请设置选项 skip_lines</translation>
        </message>
        <message>
            <source>the option columns names %1 columns, the file has %2</source>
            <translation>选项 columns 指定了 %1 列，文件有 %2 列</translation>
        </message>
        <message>
            <source>line %1 has %2 fields</source>
            <translation>第 %1 行有 %2 个字段</translation>
        </message>
        <message>
            <source>%1, as the header or the first line has</source>
            <translation>%1 个，与标题行或第一行相同</translation>
        </message>
        <message>
            <source>If its numbers have decimal commas, write them with points or separate the columns by semicolons; else name the columns with the option columns</source>
            <translation>如果数中有小数逗号，请改用小数点，或用分号分隔各列；否则请用选项 columns 指定各列</translation>
        </message>
        <message>
            <source>Name the columns with the option columns</source>
            <translation>请用选项 columns 指定各列</translation>
        </message>
        <message>
            <source>line %1 and %2 more do not hold %3 numbers, %4 lines do</source>
            <translation>第 %1 行及另外 %2 行不含 %3 个数，有 %4 行含有</translation>
        </message>
        <message>
            <source>a table of numbers</source>
            <translation>数值表</translation>
        </message>
        <message>
            <source>Set the options delimiter and columns</source>
            <translation>请设置选项 delimiter 和 columns</translation>
        </message>
        <message>
            <source>'%1' cannot be written: the disk may be full</source>
            <translation>无法写出“%1”：磁盘可能已满</translation>
        </message>
        <message>
            <source>room for all points of the cloud, uncompressed</source>
            <translation>可容纳点云全部点（未压缩）的空间</translation>
        </message>
        <message>
            <source>Free room, or set TMPDIR to a folder that has it</source>
            <translation>请腾出空间，或将 TMPDIR 设为有空间的文件夹</translation>
        </message>
        <message>
            <source>'%1' cannot be read</source>
            <translation>无法读取“%1”</translation>
        </message>
        <message>
            <source>the file that was written just now</source>
            <translation>刚写出的文件</translation>
        </message>
        <message>
            <source>Build the index again</source>
            <translation>请重新建立索引</translation>
        </message>
        <message>
            <source>no folder can be made in '%1'</source>
            <translation>无法在“%1”中建立文件夹</translation>
        </message>
        <message>
            <source>a folder to write to</source>
            <translation>可写入的文件夹</translation>
        </message>
        <message>
            <source>a cloud</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>'%1' is no LAS or LAZ file</source>
            <translation>“%1”不是 LAS 或 LAZ 文件</translation>
        </message>
        <message>
            <source>a cloud that can be read in parts</source>
            <translation>可分部分读取的点云</translation>
        </message>
        <message>
            <source>Convert it: bole convert FILE cloud.laz</source>
            <translation>请转换：bole convert FILE cloud.laz</translation>
        </message>
        <message>
            <source>%1 points</source>
            <translation>%1 个点</translation>
        </message>
        <message>
            <source>at most 4294967295 for COPC</source>
            <translation>COPC 至多 4294967295 个</translation>
        </message>
        <message>
            <source>Write LAZ, or tiles</source>
            <translation>请写出 LAZ 或分块</translation>
        </message>
        <message>
            <source>'%1' is no COPC file</source>
            <translation>“%1”不是 COPC 文件</translation>
        </message>
        <message>
            <source>'%1' has a damaged record of COPC</source>
            <translation>“%1”的 COPC 记录已损坏</translation>
        </message>
        <message>
            <source>a COPC file (.copc.laz)</source>
            <translation>COPC 文件 (.copc.laz)</translation>
        </message>
        <message>
            <source>Convert the cloud: bole convert FILE cloud.copc.laz</source>
            <translation>请转换点云：bole convert FILE cloud.copc.laz</translation>
        </message>
        <message>
            <source>the octree of '%1' has no node that can be read</source>
            <translation>“%1”的八叉树没有可以读取的节点</translation>
        </message>
        <message>
            <source>a whole file</source>
            <translation>完整的文件</translation>
        </message>
        <message>
            <source>Copy or download the file again, or convert it to COPC again</source>
            <translation>请重新复制或下载文件，或重新转换为 COPC</translation>
        </message>
        <message>
            <source>none of the %1 points of node %2-%3-%4-%5 of '%6' can be read</source>
            <translation>“%6”的节点 %2-%3-%4-%5 的 %1 个点均无法读取</translation>
        </message>
        <message>
            <source>Copy or download the file again</source>
            <translation>请重新复制或下载文件</translation>
        </message>
        <message>
            <source>the description of the E57 file is not usable: it has no e57Root</source>
            <translation>E57 文件的描述不能使用：没有 e57Root</translation>
        </message>
        <message>
            <source>the description of the E57 file is not usable: %1</source>
            <translation>E57 文件的描述不能使用：%1</translation>
        </message>
        <message>
            <source>XML with the element e57Root</source>
            <translation>含有元素 e57Root 的 XML</translation>
        </message>
        <message>
            <source>The file is damaged: export it again</source>
            <translation>文件已损坏：请重新导出</translation>
        </message>
        <message>
            <source>the file does not begin with ASTM-E57</source>
            <translation>文件不以 ASTM-E57 开头</translation>
        </message>
        <message>
            <source>an E57 file</source>
            <translation>E57 文件</translation>
        </message>
        <message>
            <source>the file ends after %1 bytes, within the E57 header</source>
            <translation>文件在 %1 字节之后结束，仍在 E57 文件头内</translation>
        </message>
        <message>
            <source>%1 bytes of header</source>
            <translation>%1 字节的文件头</translation>
        </message>
        <message>
            <source>The file was cut: copy it again</source>
            <translation>文件被截断：请重新复制</translation>
        </message>
        <message>
            <source>E57 version %1.%2</source>
            <translation>E57 版本 %1.%2</translation>
        </message>
        <message>
            <source>version 1</source>
            <translation>版本 1</translation>
        </message>
        <message>
            <source>E57 pages of %1 bytes</source>
            <translation>%1 字节的 E57 页</translation>
        </message>
        <message>
            <source>The header is damaged: copy it again</source>
            <translation>文件头已损坏：请重新复制</translation>
        </message>
        <message>
            <source>the description of the file would lie at byte %1 of %2</source>
            <translation>文件的描述应在 %2 字节中的第 %1 字节处</translation>
        </message>
        <message>
            <source>a whole file: its description (XML) lies behind the points</source>
            <translation>完整的文件：其描述（XML）位于点之后</translation>
        </message>
        <message>
            <source>the description of the E57 file (XML) has %1 of %2 bytes</source>
            <translation>E57 文件的描述（XML）有 %2 字节，现有 %1 字节</translation>
        </message>
        <message>
            <source>the checksum of the description of the E57 file (XML) is wrong: it cannot be relied on</source>
            <translation>E57 文件的描述（XML）校验和错误：不可信</translation>
        </message>
        <message>
            <source>an undamaged file</source>
            <translation>未损坏的文件</translation>
        </message>
        <message>
            <source>Copy or export the file again</source>
            <translation>请重新复制或导出文件</translation>
        </message>
        <message>
            <source>none of the %1 points of the E57 file can be read</source>
            <translation>E57 文件的 %1 个点均无法读取</translation>
        </message>
        <message>
            <source>none of the %1 points of the E57 file can be read: %2</source>
            <translation>E57 文件的 %1 个点均无法读取：%2</translation>
        </message>
        <message>
            <source>a table</source>
            <translation>表</translation>
        </message>
        <message>
            <source>a track</source>
            <translation>GNSS 轨迹</translation>
        </message>
        <message>
            <source>a trajectory</source>
            <translation>轨迹</translation>
        </message>
        <message>
            <source>a folder of views</source>
            <translation>视图文件夹</translation>
        </message>
        <message>
            <source>a compressed archive</source>
            <translation>压缩包</translation>
        </message>
        <message>
            <source>Unpack it first</source>
            <translation>请先解压</translation>
        </message>
        <message>
            <source>an HDF5 file</source>
            <translation>HDF5 文件</translation>
        </message>
        <message>
            <source>Export it as LAS or PLY</source>
            <translation>请导出为 LAS 或 PLY</translation>
        </message>
        <message>
            <source>this is %1</source>
            <translation>这是%1</translation>
        </message>
        <message>
            <source>this is no KITTI frame (%1 bytes): a .bin file holds nothing but points of four 32-bit numbers, within 2 km of the sensor</source>
            <translation>这不是 KITTI 帧（%1 字节）：.bin 文件只含有由四个 32 位数组成的点，距传感器 2 km 以内</translation>
        </message>
        <message>
            <source>the format of this file is not known (%1 bytes, ending '%2')</source>
            <translation>此文件的格式未知（%1 字节，扩展名“%2”）</translation>
        </message>
        <message>
            <source>the folder '%1' holds no frames</source>
            <translation>文件夹“%1”中没有帧</translation>
        </message>
        <message>
            <source>there is no file or folder '%1'</source>
            <translation>没有文件或文件夹“%1”</translation>
        </message>
        <message>
            <source>a scan or a point cloud</source>
            <translation>扫描或点云</translation>
        </message>
        <message>
            <source>this is %1: %2</source>
            <translation>这是%1：%2</translation>
        </message>
        <message>
            <source>'%1' is a %2</source>
            <translation>“%1”是 %2</translation>
        </message>
        <message>
            <source>there is no format '%1' of %2</source>
            <translation>没有用于%2的格式“%1”</translation>
        </message>
        <message>
            <source>%1 cannot be written as '%2'</source>
            <translation>%1不能写成“%2”</translation>
        </message>
        <message>
            <source>'%1': %2 failed: %3</source>
            <translation>“%1”：%2失败：%3</translation>
        </message>
        <message>
            <source>placing the raster</source>
            <translation>放置栅格</translation>
        </message>
        <message>
            <source>the raster's coordinate reference system is not WKT that PROJ knows</source>
            <translation>栅格的坐标参考系不是 PROJ 认识的 WKT</translation>
        </message>
        <message>
            <source>WKT 1 or 2</source>
            <translation>WKT 1 或 2</translation>
        </message>
        <message>
            <source>setting the coordinate reference system</source>
            <translation>设置坐标参考系</translation>
        </message>
        <message>
            <source>writing a row</source>
            <translation>写出一行</translation>
        </message>
        <message>
            <source>a raster of %1 x %2 cells with %3 values</source>
            <translation>%1 x %2 个单元的栅格有 %3 个值</translation>
        </message>
        <message>
            <source>one value per cell and at least one cell</source>
            <translation>每个单元一个值，且至少一个单元</translation>
        </message>
        <message>
            <source>creating the file</source>
            <translation>建立文件</translation>
        </message>
        <message>
            <source>writing the file</source>
            <translation>写出文件</translation>
        </message>
        <message>
            <source>a GeoTIFF with a band</source>
            <translation>含有一个波段的 GeoTIFF</translation>
        </message>
        <message>
            <source>'%1' has no georeference</source>
            <translation>“%1”没有地理参考</translation>
        </message>
        <message>
            <source>a georeferenced GeoTIFF</source>
            <translation>带地理参考的 GeoTIFF</translation>
        </message>
        <message>
            <source>'%1' has cells of %2 x %3 m or is rotated</source>
            <translation>“%1”的单元为 %2 x %3 m，或有旋转</translation>
        </message>
        <message>
            <source>square cells, north up</source>
            <translation>正方形的单元，北方朝上</translation>
        </message>
        <message>
            <source>no cell of '%1' lies within the bounds</source>
            <translation>“%1”没有单元在该范围内</translation>
        </message>
        <message>
            <source>bounds that meet it</source>
            <translation>与其相交的范围</translation>
        </message>
        <message>
            <source>'%1' has %2 x %3 cells</source>
            <translation>“%1”有 %2 x %3 个单元</translation>
        </message>
        <message>
            <source>at most %1 million cells</source>
            <translation>至多 %1 百万个单元</translation>
        </message>
        <message>
            <source>Cut it to the plot, or thin it</source>
            <translation>请裁剪到样地，或抽稀</translation>
        </message>
        <message>
            <source>'%1': row %2 cannot be read: %3</source>
            <translation>“%1”：无法读取第 %2 行：%3</translation>
        </message>
        <message>
            <source>this GDAL has no driver %1</source>
            <translation>此 GDAL 没有驱动程序 %1</translation>
        </message>
        <message>
            <source>a GDAL with it</source>
            <translation>含有它的 GDAL</translation>
        </message>
        <message>
            <source>no reason given</source>
            <translation>没有给出原因</translation>
        </message>
        <message>
            <source>layer '%1': %2 failed: %3</source>
            <translation>图层“%1”：%2失败：%3</translation>
        </message>
        <message>
            <source>layer '%1' has %2 shapes and %3 rows of attributes</source>
            <translation>图层“%1”有 %2 个图形和 %3 行属性</translation>
        </message>
        <message>
            <source>as many of both</source>
            <translation>两者数目相同</translation>
        </message>
        <message>
            <source>shape %1 of layer '%2' has %3 vertices</source>
            <translation>图层“%2”的图形 %1 有 %3 个顶点</translation>
        </message>
        <message>
            <source>shape %1 of layer '%2' has a coordinate that is not finite</source>
            <translation>图层“%2”的图形 %1 有一个坐标不是有限数</translation>
        </message>
        <message>
            <source>finite coordinates</source>
            <translation>有限的坐标</translation>
        </message>
        <message>
            <source>defining a field</source>
            <translation>定义字段</translation>
        </message>
        <message>
            <source>the coordinate reference system of layer '%1' is not WKT that PROJ knows</source>
            <translation>图层“%1”的坐标参考系不是 PROJ 认识的 WKT</translation>
        </message>
        <message>
            <source>creating it</source>
            <translation>建立图层</translation>
        </message>
        <message>
            <source>committing its rows</source>
            <translation>提交各行</translation>
        </message>
        <message>
            <source>'%1' cannot be written: %2</source>
            <translation>无法写出“%1”：%2</translation>
        </message>
        <message>
            <source>a folder that exists and may be written to</source>
            <translation>存在且可写的文件夹</translation>
        </message>
        <message>
            <source>'%1' could not be written to its end: %2</source>
            <translation>“%1”未能写完：%2</translation>
        </message>
        <message>
            <source>the place of layer '%1' on the earth is not known, and GeoJSON holds longitude and latitude</source>
            <translation>图层“%1”在地球上的位置未知，而 GeoJSON 存放经度和纬度</translation>
        </message>
        <message>
            <source>a coordinate reference system</source>
            <translation>坐标参考系</translation>
        </message>
        <message>
            <source>finding the transformation to longitude and latitude</source>
            <translation>求到经度和纬度的变换</translation>
        </message>
        <message>
            <source>transforming a coordinate to longitude and latitude</source>
            <translation>将坐标变换为经度和纬度</translation>
        </message>
        <message>
            <source>the coordinate system %1 is not available: %2</source>
            <translation>坐标系 %1 不可用：%2</translation>
        </message>
        <message>
            <source>the database of PROJ</source>
            <translation>PROJ 的数据库</translation>
        </message>
        <message>
            <source>option crs is '%1'</source>
            <translation>选项 crs 为“%1”</translation>
        </message>
        <message>
            <source>a projected coordinate system, for instance EPSG:25832</source>
            <translation>投影坐标系，例如 EPSG:25832</translation>
        </message>
        <message>
            <source>the path cannot be projected to '%1': %2</source>
            <translation>无法将路径投影到“%1”：%2</translation>
        </message>
        <message>
            <source>a coordinate system of the place where it was walked</source>
            <translation>行走所在地的坐标系</translation>
        </message>
        <message>
            <source>the coordinates are longitude and latitude, not metres: project the cloud first</source>
            <translation>坐标是经度和纬度，不是米：请先投影点云</translation>
        </message>
        <message>
            <source>the coordinates are in %1 (%2 m), not in metres</source>
            <translation>坐标以 %1（%2 m）为单位，不是米</translation>
        </message>
        <message>
            <source>the coordinates are in a unit without a name (%1 m), not in metres</source>
            <translation>坐标采用没有名称的单位（%1 m），不是米</translation>
        </message>
        <message>
            <source>extra bytes '%1' (type %2) do not lie within the point record; they and those after them are skipped</source>
            <translation>附加字节“%1”（类型 %2）超出点记录；它及其后的附加字节已跳过</translation>
        </message>
        <message>
            <source>extra bytes '%1' are not a single number and are skipped</source>
            <translation>附加字节“%1”不是单个数，已跳过</translation>
        </message>
        <message>
            <source>extra bytes %1 have no unique name and are skipped</source>
            <translation>附加字节 %1 没有唯一的名称，已跳过</translation>
        </message>
        <message>
            <source>the facts of the file are damaged (too long) and were left out</source>
            <translation>文件中的附注已损坏（过长），已舍去</translation>
        </message>
        <message>
            <source>the facts of the cloud take %1 bytes, a LAS record holds %2: they were not written</source>
            <translation>点云的附注占 %1 字节，而 LAS 记录只能容纳 %2 字节：未写出</translation>
        </message>
        <message>
            <source>the coordinate reference system has no EPSG code that LAS 1.2 could hold; it was not written</source>
            <translation>坐标参考系没有 LAS 1.2 能保存的 EPSG 代码；未写出</translation>
        </message>
        <message>
            <source>the file does not begin with LASF</source>
            <translation>文件不以 LASF 开头</translation>
        </message>
        <message>
            <source>a LAS or LAZ file</source>
            <translation>LAS 或 LAZ 文件</translation>
        </message>
        <message>
            <source>the file ends after %1 bytes, within the LAS header</source>
            <translation>文件在 %1 字节之后结束，仍在 LAS 文件头内</translation>
        </message>
        <message>
            <source>LAS version %1.%2</source>
            <translation>LAS 版本 %1.%2</translation>
        </message>
        <message>
            <source>1.0 to 1.4</source>
            <translation>1.0 至 1.4</translation>
        </message>
        <message>
            <source>the header of LAS 1.%1 has %2 bytes (file: %3 bytes)</source>
            <translation>LAS 1.%1 的文件头有 %2 字节（文件：%3 字节）</translation>
        </message>
        <message>
            <source>at least %1 and no more than the file</source>
            <translation>至少 %1 字节，且不超过文件</translation>
        </message>
        <message>
            <source>the points begin at byte %1</source>
            <translation>点从第 %1 字节开始</translation>
        </message>
        <message>
            <source>a place between the header (%1 bytes) and the end of the file (%2 bytes)</source>
            <translation>文件头（%1 字节）与文件末尾（%2 字节）之间的位置</translation>
        </message>
        <message>
            <source>point format %1</source>
            <translation>点格式 %1</translation>
        </message>
        <message>
            <source>0 to 10</source>
            <translation>0 至 10</translation>
        </message>
        <message>
            <source>point records of %1 bytes</source>
            <translation>%1 字节的点记录</translation>
        </message>
        <message>
            <source>at least %1 for point format %2</source>
            <translation>点格式 %2 至少 %1 字节</translation>
        </message>
        <message>
            <source>coordinate scale %1 %2 %3 and offset %4 %5 %6</source>
            <translation>坐标比例 %1 %2 %3 和偏移 %4 %5 %6</translation>
        </message>
        <message>
            <source>finite numbers, scales other than zero</source>
            <translation>有限数，比例不为零</translation>
        </message>
        <message>
            <source>coordinate scale %1 %2 %3</source>
            <translation>坐标比例 %1 %2 %3</translation>
        </message>
        <message>
            <source>scales from %1 to %2</source>
            <translation>%1 至 %2 的比例</translation>
        </message>
        <message>
            <source>The header is damaged: copy the file again</source>
            <translation>文件头已损坏：请重新复制文件</translation>
        </message>
        <message>
            <source>the coordinate scale %1 %2 %3 is negative: check that the cloud is not mirrored</source>
            <translation>坐标比例 %1 %2 %3 为负：请检查点云是否成镜像</translation>
        </message>
        <message>
            <source>the bounding box of the header is not one; that of the points is used</source>
            <translation>文件头中的范围框无效；采用点的范围框</translation>
        </message>
        <message>
            <source>the header counts %1 points in its legacy field and %2 in its extended one; %3 is used</source>
            <translation>文件头的旧字段计有 %1 个点，扩展字段计有 %2 个；采用 %3</translation>
        </message>
        <message>
            <source>%1 of %2 extended variable length records lie within the file</source>
            <translation>%2 个扩展变长记录中有 %1 个位于文件内</translation>
        </message>
        <message>
            <source>%1 of %2 variable length records lie within the file</source>
            <translation>%2 个变长记录中有 %1 个位于文件内</translation>
        </message>
        <message>
            <source>variable length record %1 of %2 (%3 %4) says it has %5 bytes, %6 are there; it and those behind it are left out</source>
            <translation>第 %1 个变长记录（共 %2 个，%3 %4）声明有 %5 字节，实有 %6 字节；它及其后的记录已舍去</translation>
        </message>
        <message>
            <source>the extended variable length records would begin at byte %1 of %2; they are left out</source>
            <translation>扩展变长记录应从 %2 字节中的第 %1 字节开始；已舍去</translation>
        </message>
        <message>
            <source>%1 entries of the octree of the file are impossible, lie outside of it or on top of others: points may be missing. Read the file without bounds and resolution</source>
            <translation>文件八叉树的 %1 个条目不可能成立、位于其外或互相重叠：可能缺少点。请不带 bounds 和 resolution 读取文件</translation>
        </message>
        <message>
            <source>%1 pages of the octree of the file cannot be read: nobody knows how many points lie below them. Read the file without bounds and resolution</source>
            <translation>文件八叉树的 %1 页无法读取：其下有多少点无从得知。请不带 bounds 和 resolution 读取文件</translation>
        </message>
        <message>
            <source>the bounds in the header of the file do not fit its points, so it cannot be read in pieces</source>
            <translation>文件头中的范围与点不符，因此不能分段读取</translation>
        </message>
        <message>
            <source>a header with right bounds</source>
            <translation>范围正确的文件头</translation>
        </message>
        <message>
            <source>Leave the options unit and up at auto, or read it in one process</source>
            <translation>请将选项 unit 和 up 保持为 auto，或在单个进程中读取</translation>
        </message>
        <message>
            <source>no point was found: %1 entries or pages of the octree of the file are damaged</source>
            <translation>没有找到点：文件八叉树有 %1 个条目或页已损坏</translation>
        </message>
        <message>
            <source>a whole octree</source>
            <translation>完整的八叉树</translation>
        </message>
        <message>
            <source>Read the file without bounds and resolution, or convert it to COPC again</source>
            <translation>请不带范围和分辨率读取文件，或重新转换为 COPC</translation>
        </message>
        <message>
            <source>the levels of the file that have a resolution of %1 hold no point within the option bounds</source>
            <translation>文件中分辨率为 %1 的层级没有点在选项 bounds 之内</translation>
        </message>
        <message>
            <source>points within the bounds</source>
            <translation>范围内的点</translation>
        </message>
        <message>
            <source>Set a smaller resolution, or 0 for all points</source>
            <translation>请设置更小的分辨率，或用 0 读取全部点</translation>
        </message>
        <message>
            <source>the header counts %1 points, the file has room for %2: those behind were not read</source>
            <translation>文件头计有 %1 个点，文件只容得下 %2 个：其后的点未读取</translation>
        </message>
        <message>
            <source>none of the %1 points that the header counts can be read</source>
            <translation>文件头所计的 %1 个点均无法读取</translation>
        </message>
        <message>
            <source>%1 of %2 points read: the file ends early or is damaged there</source>
            <translation>读取了 %2 个点中的 %1 个：文件在该处提前结束或已损坏</translation>
        </message>
        <message>
            <source>the cloud reaches further than 2^23 steps of %1 m from its middle: coordinates are rounded to float32 there</source>
            <translation>点云自其中心伸展超过 2^23 个 %1 m 的步长：该处坐标舍入为 float32</translation>
        </message>
        <message>
            <source>%1 of %2 points are marked as withheld; they are left out</source>
            <translation>%2 个点中有 %1 个标为保留不用（withheld）；已舍去</translation>
        </message>
        <message>
            <source>%1 of %2 points are marked as withheld; they are read like the others</source>
            <translation>%2 个点中有 %1 个标为保留不用（withheld）；与其他点一样读取</translation>
        </message>
        <message>
            <source>point %1 has the coordinate %2 on axis %3</source>
            <translation>点 %1 在轴 %3 上的坐标为 %2</translation>
        </message>
        <message>
            <source>finite coordinates within %1 m of %2</source>
            <translation>距 %2 在 %1 m 以内的有限坐标</translation>
        </message>
        <message>
            <source>Remove the point, or write with a coarser scale</source>
            <translation>请去掉该点，或以更粗的比例写出</translation>
        </message>
        <message>
            <source>the times are not GPS time, which is what a LAS field holds: they were not written</source>
            <translation>时间不是 GPS 时间，而 LAS 字段存放的是 GPS 时间：未写出</translation>
        </message>
        <message>
            <source>LAS version '%1'</source>
            <translation>LAS 版本“%1”</translation>
        </message>
        <message>
            <source>1.2 or 1.4</source>
            <translation>1.2 或 1.4</translation>
        </message>
        <message>
            <source>LAS 1.2 as COPC</source>
            <translation>以 LAS 1.2 写出 COPC</translation>
        </message>
        <message>
            <source>LAS 1.4</source>
            <translation>版本 LAS 1.4</translation>
        </message>
        <message>
            <source>at most 4294967295 for LAS 1.2</source>
            <translation>LAS 1.2 至多 4294967295 个</translation>
        </message>
        <message>
            <source>Write LAS 1.4</source>
            <translation>请写出 LAS 1.4</translation>
        </message>
        <message>
            <source>the LAZ record lists an item of type %1, %2 bytes, version %3</source>
            <translation>LAZ 记录列有类型 %1、%2 字节、版本 %3 的项</translation>
        </message>
        <message>
            <source>items as LASzip 1 to 3 writes them</source>
            <translation>LASzip 1 至 3 写出的项</translation>
        </message>
        <message>
            <source>points of format %1</source>
            <translation>格式 %1 的点</translation>
        </message>
        <message>
            <source>0 to 3 or 6 to 8 to be compressed</source>
            <translation>0 至 3 或 6 至 8 才能压缩</translation>
        </message>
        <message>
            <source>records of %1 bytes</source>
            <translation>%1 字节的记录</translation>
        </message>
        <message>
            <source>a chunk of %1 points in %2 bytes</source>
            <translation>%2 字节中含 %1 个点的数据块</translation>
        </message>
        <message>
            <source>less than 2^31 of both</source>
            <translation>两者均小于 2^31</translation>
        </message>
        <message>
            <source>a LAZ record of %1 bytes</source>
            <translation>%1 字节的 LAZ 记录</translation>
        </message>
        <message>
            <source>the LAZ record (laszip encoded, 22204)</source>
            <translation>LAZ 记录（laszip encoded, 22204）</translation>
        </message>
        <message>
            <source>LAZ compressor %1 with coder %2</source>
            <translation>LAZ 压缩器 %1，编码器 %2</translation>
        </message>
        <message>
            <source>compressor 1, 2 or 3 with coder 0</source>
            <translation>压缩器 1、2 或 3，编码器 0</translation>
        </message>
        <message>
            <source>a LAZ record of %1 bytes that lists %2 items</source>
            <translation>%1 字节的 LAZ 记录列有 %2 项</translation>
        </message>
        <message>
            <source>the LAZ record lists items of %1 bytes, point records have %2</source>
            <translation>LAZ 记录所列各项共 %1 字节，而点记录有 %2 字节</translation>
        </message>
        <message>
            <source>the same number</source>
            <translation>相同的数目</translation>
        </message>
        <message>
            <source>a layered LAZ file whose records do not begin with a point</source>
            <translation>分层的 LAZ 文件，其记录不以点开头</translation>
        </message>
        <message>
            <source>item POINT14 first</source>
            <translation>以 POINT14 为第一项</translation>
        </message>
        <message>
            <source>a LAZ item of type %1, version %2</source>
            <translation>类型 %1、版本 %2 的 LAZ 项</translation>
        </message>
        <message>
            <source>points, times, colours and extra bytes in layers of version 3 or point by point in version 2</source>
            <translation>版本 3 的分层或版本 2 的逐点的点、时间、颜色和附加字节</translation>
        </message>
        <message>
            <source>the file has no usable chunk table; its chunks are read in order</source>
            <translation>文件没有可用的数据块表；按顺序读取其数据块</translation>
        </message>
        <message>
            <source>reading compressed points</source>
            <translation>读取压缩的点</translation>
        </message>
        <message>
            <source>the points are compressed, but the file has no LAZ record</source>
            <translation>点已压缩，但文件没有 LAZ 记录</translation>
        </message>
        <message>
            <source>the record 'laszip encoded' 22204</source>
            <translation>记录“laszip encoded”22204</translation>
        </message>
        <message>
            <source>compressing points</source>
            <translation>压缩点</translation>
        </message>
        <message>
            <source>'%1' has no row</source>
            <translation>“%1”没有数据行</translation>
        </message>
        <message>
            <source>a file plot.csv of a survey</source>
            <translation>调查的文件 plot.csv</translation>
        </message>
        <message>
            <source>'%1' has the shape '%2'</source>
            <translation>“%1”的形状为“%2”</translation>
        </message>
        <message>
            <source>rectangle, circle, polygon or none</source>
            <translation>rectangle、circle、polygon 或 none</translation>
        </message>
        <message>
            <source>%1 names for %2 folders</source>
            <translation>%2 个文件夹有 %1 个名称</translation>
        </message>
        <message>
            <source>%1 systems for %2 folders</source>
            <translation>%2 个文件夹有 %1 个系统</translation>
        </message>
        <message>
            <source>%1 plots for %2 folders</source>
            <translation>%2 个文件夹有 %1 个样地</translation>
        </message>
        <message>
            <source>one for each folder, in their order</source>
            <translation>每个文件夹一个，按其顺序</translation>
        </message>
        <message>
            <source>'%1' is no folder</source>
            <translation>“%1”不是文件夹</translation>
        </message>
        <message>
            <source>the output folder of a run (bole run ... --out FOLDER)</source>
            <translation>运行的输出文件夹（bole run ... --out FOLDER）</translation>
        </message>
        <message>
            <source>the folder '%1' is named twice</source>
            <translation>文件夹“%1”指定了两次</translation>
        </message>
        <message>
            <source>different runs</source>
            <translation>不同的运行</translation>
        </message>
        <message>
            <source>A run compared with itself has no differences, and pooled twice counts its trees twice</source>
            <translation>运行与自身比较没有差异，合并两次则其树木重复计入</translation>
        </message>
        <message>
            <source>no folder is named</source>
            <translation>没有指定文件夹</translation>
        </message>
        <message>
            <source>the output folders of two or more runs</source>
            <translation>两次或更多次运行的输出文件夹</translation>
        </message>
        <message>
            <source>--set runs.folders=A,B</source>
            <translation>请用 --set runs.folders=A,B</translation>
        </message>
        <message>
            <source>read %1</source>
            <translation>读取 %1</translation>
        </message>
        <message>
            <source>%1 runs with %2 stems</source>
            <translation>%1 次运行，共 %2 株单木</translation>
        </message>
        <message>
            <source>summary.json of a run</source>
            <translation>运行的 summary.json</translation>
        </message>
        <message>
            <source>'%1' holds no survey: there is no stems.csv in it</source>
            <translation>“%1”中没有调查：其中没有 stems.csv</translation>
        </message>
        <message>
            <source>the output folder of a run that made a stem table</source>
            <translation>生成了单木表的运行的输出文件夹</translation>
        </message>
        <message>
            <source>FAILED_RUN.txt says why the run failed</source>
            <translation>FAILED_RUN.txt 说明运行失败的原因</translation>
        </message>
        <message>
            <source>its stems.csv has no row</source>
            <translation>其 stems.csv 没有数据行</translation>
        </message>
        <message>
            <source>what made this run is not known</source>
            <translation>这次运行由什么生成未知</translation>
        </message>
        <message>
            <source>which of its trees count is only known by the column counted</source>
            <translation>其中哪些树计入，只能由 counted 列得知</translation>
        </message>
        <message>
            <source>its trajectory takes no part</source>
            <translation>其轨迹不参与比较</translation>
        </message>
        <message>
            <source>the last run in this folder failed: the survey before it is compared</source>
            <translation>此文件夹的上一次运行失败：比较的是更早的调查</translation>
        </message>
        <message>
            <source>this run was asked to finish early</source>
            <translation>这次运行曾被要求提前结束</translation>
        </message>
        <message>
            <source>the verdict of this run is: refused</source>
            <translation>这次运行的结论为：拒绝</translation>
        </message>
        <message>
            <source>%1: there is no %2; %3</source>
            <translation>%1：没有 %2；%3</translation>
        </message>
        <message>
            <source>%1 cannot be read (%2); %3</source>
            <translation>无法读取 %1（%2）；%3</translation>
        </message>
        <message>
            <source>its reference takes no part</source>
            <translation>其参照不参与比较</translation>
        </message>
        <message>
            <source>its reference trajectory takes no part</source>
            <translation>其参照轨迹不参与比较</translation>
        </message>
        <message>
            <source>its loop closures are not drawn</source>
            <translation>不绘制其回环</translation>
        </message>
        <message>
            <source>Ouster capture</source>
            <translation>Ouster 抓包文件</translation>
        </message>
        <message>
            <source>Hesai capture</source>
            <translation>Hesai 抓包文件</translation>
        </message>
        <message>
            <source>Velodyne capture</source>
            <translation>Velodyne 抓包文件</translation>
        </message>
        <message>
            <source>ROS 1 bag</source>
            <translation>ROS 1 bag 文件</translation>
        </message>
        <message>
            <source>ROS 2 bag</source>
            <translation>ROS 2 bag 文件</translation>
        </message>
        <message>
            <source>folder of a ROS 2 bag</source>
            <translation>ROS 2 bag 文件夹</translation>
        </message>
        <message>
            <source>folder of frames</source>
            <translation>帧文件夹</translation>
        </message>
        <message>
            <source>KITTI frame</source>
            <translation>KITTI 帧</translation>
        </message>
        <message>
            <source>several calibrations of a %1 lie beside the capture: '%2', '%3'</source>
            <translation>抓包文件旁有多个 %1 的标定文件：“%2”、“%3”</translation>
        </message>
        <message>
            <source>Give it the name of the capture, or name it with the option sensor</source>
            <translation>请使其与抓包文件同名，或用选项 sensor 指定</translation>
        </message>
        <message>
            <source>%1 IP fragment</source>
            <translation>%1 个 IP 分片</translation>
        </message>
        <message>
            <source>%1 IP fragments</source>
            <translation>%1 个 IP 分片</translation>
        </message>
        <message>
            <source>%1 of datagrams that are not whole were skipped</source>
            <translation>跳过了%1，其数据报不完整</translation>
        </message>
        <message>
            <source>%1 data packet</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>%1 data packets</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>the capture is cut off or damaged after %1 (%2): the frames before that are read</source>
            <translation>抓包文件在%1之后被截断或损坏（%2）：读取其前的帧</translation>
        </message>
        <message>
            <source>the capture is cut off or damaged after %1 (%2): the frames before that are read (%3 % of the file)</source>
            <translation>抓包文件在%1之后被截断或损坏（%2）：读取其前的帧（文件的 %3 %）</translation>
        </message>
        <message>
            <source>'%1' has %2 bytes</source>
            <translation>“%1”有 %2 字节</translation>
        </message>
        <message>
            <source>%1, %2 per point of the frame</source>
            <translation>%1，帧的每点 %2 字节</translation>
        </message>
        <message>
            <source>%1 bytes, which is no whole number of points</source>
            <translation>%1 字节，不是整数个点</translation>
        </message>
        <message>
            <source>16 bytes per point: x, y, z, intensity as float32</source>
            <translation>每点 16 字节：float32 的 x、y、z 和强度</translation>
        </message>
        <message>
            <source>'%1' line %2 is '%3'</source>
            <translation>“%1”第 %2 行为“%3”</translation>
        </message>
        <message>
            <source>a time in seconds, or a date and time</source>
            <translation>以秒计的时间，或日期和时间</translation>
        </message>
        <message>
            <source>files .bin (KITTI) or .pcd, one per frame</source>
            <translation>.bin（KITTI）或 .pcd 文件，每帧一个</translation>
        </message>
        <message>
            <source>%1 files were skipped: frames are read from *%2 only</source>
            <translation>跳过了 %1 个文件：只从 *%2 读取帧</translation>
        </message>
        <message>
            <source>%1 of %2 frames are empty or cut off (first: %3)</source>
            <translation>%2 帧中有 %1 帧为空或被截断（第一帧：%3）</translation>
        </message>
        <message>
            <source>'%1' is not used: it has %2 times for %3 frames, or they do not increase</source>
            <translation>未采用“%1”：它有 %2 个时间而帧有 %3 个，或时间不是递增的</translation>
        </message>
        <message>
            <source>'%1' cannot be used</source>
            <translation>“%1”不能使用</translation>
        </message>
        <message>
            <source>{"sensor": "os1_64"}, or a description of the sensor as in resources/sensors</source>
            <translation>{"sensor": "os1_64"}，或 resources/sensors 中那样的传感器描述</translation>
        </message>
        <message>
            <source>the frames have no rings: %1 evenly spaced ones are assumed. Name the sensor with the option sensor</source>
            <translation>帧没有线号：假定为 %1 条均匀分布的线。请用选项 sensor 指定传感器</translation>
        </message>
        <message>
            <source>%1: %2 frame, %3</source>
            <translation>%1：%2 帧，%3</translation>
        </message>
        <message>
            <source>%1: %2 frame, %3 rings</source>
            <translation>%1：%2 帧，%3 线</translation>
        </message>
        <message>
            <source>%1: %2 frames, %3</source>
            <translation>%1：%2 帧，%3</translation>
        </message>
        <message>
            <source>%1: %2 frames, %3 rings</source>
            <translation>%1：%2 帧，%3 线</translation>
        </message>
        <message>
            <source>min_range is %1 m and max_range %2 m</source>
            <translation>min_range 为 %1 m，max_range 为 %2 m</translation>
        </message>
        <message>
            <source>min_range below max_range</source>
            <translation>min_range 小于 max_range</translation>
        </message>
        <message>
            <source>no scan is named</source>
            <translation>没有指定扫描</translation>
        </message>
        <message>
            <source>'%1' is a single frame</source>
            <translation>“%1”是单独的一帧</translation>
        </message>
        <message>
            <source>the folder that holds the frames</source>
            <translation>存放各帧的文件夹</translation>
        </message>
        <message>
            <source>Give the folder as the scan, or read the file as a cloud</source>
            <translation>请将该文件夹作为扫描，或将文件作为点云读取</translation>
        </message>
        <message>
            <source>the option topic is set, and '%1' (%2) has no topics</source>
            <translation>设置了选项 topic，而“%1”（%2）没有话题</translation>
        </message>
        <message>
            <source>a ROS bag</source>
            <translation>ROS bag 文件</translation>
        </message>
        <message>
            <source>Leave topic empty</source>
            <translation>请将 topic 留空</translation>
        </message>
        <message>
            <source>several correction files lie beside '%1'</source>
            <translation>“%1”旁有多个校正文件</translation>
        </message>
        <message>
            <source>the angles are those of the manual of the %1: put the correction file (CSV) of the unit beside the capture</source>
            <translation>角度取自 %1 的手册：请将该设备的校正文件（CSV）放在抓包文件旁</translation>
        </message>
        <message>
            <source>'%1' has no data packet of a Hesai sensor that is known</source>
            <translation>“%1”没有已知 Hesai 传感器的数据包</translation>
        </message>
        <message>
            <source>packets of a PandarXT-32 or Pandar40P</source>
            <translation>PandarXT-32 或 Pandar40P 的数据包</translation>
        </message>
        <message>
            <source>three columns of angular rate</source>
            <translation>三列角速度</translation>
        </message>
        <message>
            <source>, three columns of angular rate</source>
            <translation>，三列角速度</translation>
        </message>
        <message>
            <source>three columns of specific force</source>
            <translation>三列比力</translation>
        </message>
        <message>
            <source>, three columns of specific force</source>
            <translation>，三列比力</translation>
        </message>
        <message>
            <source>a column of times</source>
            <translation>时间列</translation>
        </message>
        <message>
            <source>a column of times%1</source>
            <translation>时间列%1</translation>
        </message>
        <message>
            <source>%1 has the columns %2 and lacks %3</source>
            <translation>%1 有列 %2，缺少%3</translation>
        </message>
        <message>
            <source>time_s, gyro_x_rad_s, gyro_y_rad_s, gyro_z_rad_s, accel_x_m_s2, accel_y_m_s2, accel_z_m_s2</source>
            <translation>列 time_s, gyro_x_rad_s, gyro_y_rad_s, gyro_z_rad_s, accel_x_m_s2, accel_y_m_s2, accel_z_m_s2</translation>
        </message>
        <message>
            <source>Name the columns like this in the first line</source>
            <translation>请在第一行中如此命名各列</translation>
        </message>
        <message>
            <source>%1 gives %2 as '%3'</source>
            <translation>%1 给出的 %2 为“%3”</translation>
        </message>
        <message>
            <source>%1 numbers</source>
            <translation>%1 个数</translation>
        </message>
        <message>
            <source>%1: the quaternion of T_sensor_imu has the length %2</source>
            <translation>%1：T_sensor_imu 的四元数长度为 %2</translation>
        </message>
        <message>
            <source>x y z qx qy qz qw with a quaternion of length 1</source>
            <translation>x y z qx qy qz qw，其四元数长度为 1</translation>
        </message>
        <message>
            <source>%1: the specific force is %2 m/s2 in the middle</source>
            <translation>%1：比力的中间值为 %2 m/s2</translation>
        </message>
        <message>
            <source>about 9.81 m/s2, the gravity that an accelerometer measures at rest</source>
            <translation>约 9.81 m/s2，即加速度计静止时测得的重力</translation>
        </message>
        <message>
            <source>Name the unit behind the columns: accel_x_m_s2, accel_x_g or accel_x_mg</source>
            <translation>请在列名后写明单位：accel_x_m_s2、accel_x_g 或 accel_x_mg</translation>
        </message>
        <message>
            <source>The values look like multiples of g: name the columns accel_x_g ..</source>
            <translation>数值看来是 g 的倍数：请将各列命名为 accel_x_g ..</translation>
        </message>
        <message>
            <source>The values look like thousandths of g: name the columns accel_x_mg ..</source>
            <translation>数值看来以千分之一 g 计：请将各列命名为 accel_x_mg ..</translation>
        </message>
        <message>
            <source>Gravity seems to be removed; raw measurements are needed</source>
            <translation>看来已去除重力；需要原始测量</translation>
        </message>
        <message>
            <source>%1: an angular rate of %2 rad/s</source>
            <translation>%1：角速度为 %2 rad/s</translation>
        </message>
        <message>
            <source>at most 35 rad/s (2000 deg/s)</source>
            <translation>至多 35 rad/s (2000 deg/s)</translation>
        </message>
        <message>
            <source>If they are degrees per second, name the columns gyro_x_deg_s ..</source>
            <translation>如果以度每秒计，请将各列命名为 gyro_x_deg_s ..</translation>
        </message>
        <message>
            <source>the inertial unit %1 has %2 gaps of more than %3 s, the longest %4 s</source>
            <translation>惯性单元 %1 有 %2 处超过 %3 s 的间断，最长 %4 s</translation>
        </message>
        <message>
            <source>it measures from %1 to %2 s, and the scan goes from %3 to %4 s</source>
            <translation>其测量从 %1 至 %2 s，而扫描从 %3 至 %4 s</translation>
        </message>
        <message>
            <source>%1 holds %2 usable measurements</source>
            <translation>%1 含有 %2 个可用的测量</translation>
        </message>
        <message>
            <source>%1: %2 measurements are no numbers and were left out</source>
            <translation>%1：%2 个测量值不是数，已舍去</translation>
        </message>
        <message>
            <source>%1: %2 measurements go back in time and were left out</source>
            <translation>%1：%2 个测量值的时间倒退，已舍去</translation>
        </message>
        <message>
            <source>%1 beside the scan is not of the same time: %2</source>
            <translation>扫描旁的 %1 不属于同一时间：%2</translation>
        </message>
        <message>
            <source>there is no file '%1' with an inertial unit</source>
            <translation>没有惯性单元的文件“%1”</translation>
        </message>
        <message>
            <source>a CSV file, or a topic of a ROS bag</source>
            <translation>CSV 文件，或 ROS bag 文件的话题</translation>
        </message>
        <message>
            <source>Leave the option imu empty to take imu.csv beside the scan</source>
            <translation>将选项 imu 留空即采用扫描旁的 imu.csv</translation>
        </message>
        <message>
            <source>the inertial unit %1 does not fit the scan: %2</source>
            <translation>惯性单元 %1 与扫描不符：%2</translation>
        </message>
        <message>
            <source>Add the offset between the clocks to the times of the unit</source>
            <translation>请将时钟之间的偏差加到该单元的时间上</translation>
        </message>
        <message>
            <source>the extrinsics of a device are no numbers</source>
            <translation>设备的外参不是数</translation>
        </message>
        <message>
            <source>angles in degrees, and metres</source>
            <translation>以度计的角度和以米计的长度</translation>
        </message>
        <message>
            <source>'%1' has %2 bytes and no header of an LVX file</source>
            <translation>“%1”有 %2 字节，没有 LVX 文件头</translation>
        </message>
        <message>
            <source>an LVX or LVX2 file</source>
            <translation>LVX 或 LVX2 文件</translation>
        </message>
        <message>
            <source>'%1' is an LVX file of version %2.%3</source>
            <translation>“%1”是版本 %2.%3 的 LVX 文件</translation>
        </message>
        <message>
            <source>version 1.1 or 2</source>
            <translation>版本 1.1 或 2</translation>
        </message>
        <message>
            <source>Convert it with Livox Viewer</source>
            <translation>请用 Livox Viewer 转换</translation>
        </message>
        <message>
            <source>%1 device</source>
            <translation>%1 个设备</translation>
        </message>
        <message>
            <source>%1 devices</source>
            <translation>%1 个设备</translation>
        </message>
        <message>
            <source>'%1' declares %2 in %3 bytes</source>
            <translation>“%1”声明 %2，共 %3 字节</translation>
        </message>
        <message>
            <source>the description of at least one device</source>
            <translation>至少一个设备的描述</translation>
        </message>
        <message>
            <source>indexing blocks</source>
            <translation>为数据块建立索引</translation>
        </message>
        <message>
            <source>the device type %1 is not known: its range noise and beam are not</source>
            <translation>设备类型 %1 未知：其测距噪声和光束也未知</translation>
        </message>
        <message>
            <source>%1 package</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>%1 packages</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>%1 block</source>
            <translation>%1 个数据块</translation>
        </message>
        <message>
            <source>%1 blocks</source>
            <translation>%1 个数据块</translation>
        </message>
        <message>
            <source>'%1' has no points (%2, %3)</source>
            <translation>“%1”没有点（%2，%3）</translation>
        </message>
        <message>
            <source>an LVX or LVX2 file with points</source>
            <translation>含有点的 LVX 或 LVX2 文件</translation>
        </message>
        <message>
            <source>the file is cut off or damaged after %1 (%2 % of the file): the frames before that are read</source>
            <translation>文件在%1之后被截断或损坏（文件的 %2 %）：读取其前的帧</translation>
        </message>
        <message>
            <source>%1 of a type that is not known were skipped</source>
            <translation>跳过了%1，其类型未知</translation>
        </message>
        <message>
            <source>the file has %1 devices, and not all of them have extrinsics: calibrate them in Livox Viewer</source>
            <translation>文件有 %1 个设备，并非都有外参：请在 Livox Viewer 中标定</translation>
        </message>
        <message>
            <source>%1 frame</source>
            <translation>%1 帧</translation>
        </message>
        <message>
            <source>%1 frames</source>
            <translation>%1 帧</translation>
        </message>
        <message>
            <source>%1 other device</source>
            <translation>另外 %1 个设备</translation>
        </message>
        <message>
            <source>%1 other devices</source>
            <translation>另外 %1 个设备</translation>
        </message>
        <message>
            <source>%1: %2, %3 and %4</source>
            <translation>%1：%2，%3 和%4</translation>
        </message>
        <message>
            <source>there is no Ouster JSON file beside '%1'</source>
            <translation>“%1”旁没有 Ouster 的 JSON 文件</translation>
        </message>
        <message>
            <source>the beams and the packet layout of the sensor, which the packets do not have</source>
            <translation>传感器的光束和数据包格式，数据包本身不含这些</translation>
        </message>
        <message>
            <source>Put the JSON file that the sensor or its recorder wrote beside the capture, with the same name, or name it with the option sensor</source>
            <translation>请将传感器或其记录程序写出的 JSON 文件以相同的名称放在抓包文件旁，或用选项 sensor 指定</translation>
        </message>
        <message>
            <source>%1: %2 bytes</source>
            <translation>%1：%2 字节</translation>
        </message>
        <message>
            <source>, %1: %2 bytes</source>
            <translation>，%1：%2 字节</translation>
        </message>
        <message>
            <source>none of the JSON files beside '%1' (%2) belongs to it: its packets have %3 bytes</source>
            <translation>“%1”旁的 JSON 文件（%2）都不属于它：其数据包有 %3 字节</translation>
        </message>
        <message>
            <source>the JSON file of this recording</source>
            <translation>此记录的 JSON 文件</translation>
        </message>
        <message>
            <source>several Ouster JSON files beside '%1' fit it: %2</source>
            <translation>“%1”旁有多个 Ouster 的 JSON 文件与之相符：%2</translation>
        </message>
        <message>
            <source>'%1' holds packets of an Ouster sensor, and the option sensor is '%2'</source>
            <translation>“%1”含有 Ouster 传感器的数据包，而选项 sensor 为“%2”</translation>
        </message>
        <message>
            <source>the packets of '%1' have %2 bytes</source>
            <translation>“%1”的数据包有 %2 字节</translation>
        </message>
        <message>
            <source>lidar packets of %1 bytes, as '%2' says</source>
            <translation>“%2”所述的 %1 字节的激光数据包</translation>
        </message>
        <message>
            <source>Is it the JSON file of this recording?</source>
            <translation>这是此记录的 JSON 文件吗？</translation>
        </message>
        <message>
            <source>'%1' has %2 packets but none with a column of a %3</source>
            <translation>“%1”有 %2 个数据包，但没有一个含有 %3 的列</translation>
        </message>
        <message>
            <source>'%1' has %2 packets but none with a column of a %3 (%4)</source>
            <translation>“%1”有 %2 个数据包，但没有一个含有 %3 的列（%4）</translation>
        </message>
        <message>
            <source>lidar packets of %1 bytes, as the JSON file says</source>
            <translation>JSON 文件所述的 %1 字节的激光数据包</translation>
        </message>
        <message>
            <source>Lidar packets were seen on another port: set the option port to auto</source>
            <translation>在另一端口上看到激光数据包：请将选项 port 设为 auto</translation>
        </message>
        <message>
            <source>Is the JSON file of this recording?</source>
            <translation>该 JSON 文件属于此记录吗？</translation>
        </message>
        <message>
            <source>indexing packets</source>
            <translation>为数据包建立索引</translation>
        </message>
        <message>
            <source>%1 packet</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>%1 packets</source>
            <translation>%1 个数据包</translation>
        </message>
        <message>
            <source>about %1 lost of %2</source>
            <translation>%2 个中约丢失%1</translation>
        </message>
        <message>
            <source>%1 of the sensor lost</source>
            <translation>传感器丢失%1</translation>
        </message>
        <message>
            <source>%1 whole revolution</source>
            <translation>整整 %1 圈</translation>
        </message>
        <message>
            <source>%1 whole revolutions</source>
            <translation>整整 %1 圈</translation>
        </message>
        <message>
            <source>%1 lidar packet</source>
            <translation>%1 个激光数据包</translation>
        </message>
        <message>
            <source>%1 lidar packets</source>
            <translation>%1 个激光数据包</translation>
        </message>
        <message>
            <source>%1 recorded twice: each is read once</source>
            <translation>%1重复记录：每个只读一次</translation>
        </message>
        <message>
            <source>%1 time</source>
            <translation>%1 次</translation>
        </message>
        <message>
            <source>%1 times</source>
            <translation>%1 次</translation>
        </message>
        <message>
            <source>the clock of the sensor was set %1 during the recording: times go on without the jump, by the clock of the recorder</source>
            <translation>记录期间传感器的时钟被调整%1：时间按记录器的时钟继续，不含跳变</translation>
        </message>
        <message>
            <source>%1 out of order</source>
            <translation>%1次序颠倒</translation>
        </message>
        <message>
            <source>%1 to other UDP ports than %2 were skipped: choose one with the option port</source>
            <translation>跳过了%1，其 UDP 端口不是 %2：请用选项 port 选择</translation>
        </message>
        <message>
            <source>%1 of a second sensor were left out: those of number %2 are read</source>
            <translation>第二个传感器的%1已舍去：读取编号为 %2 的传感器</translation>
        </message>
        <message>
            <source>%1 of a sensor with another serial number than that in the JSON file (%2): its beams are not exact. Take the JSON file of this sensor</source>
            <translation>%1来自另一传感器，其序列号与 JSON 文件中的（%2）不同：其光束不精确。请采用该传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>the JSON file does not name the product: range noise and beam are those of an %1, by the field of view</source>
            <translation>JSON 文件没有给出产品名称：测距噪声和光束按视场角取自 %1</translation>
        </message>
        <message>
            <source>%1 inertial sample</source>
            <translation>%1 个惯性采样</translation>
        </message>
        <message>
            <source>%1 inertial samples</source>
            <translation>%1 个惯性采样</translation>
        </message>
        <message>
            <source>%1 with the time of another one were left out</source>
            <translation>%1与另一个时间相同，已舍去</translation>
        </message>
        <message>
            <source>by the JSON file the inertial packets have a profile that is not read, and there are none of the one that is: set udp_profile_imu to LEGACY before the next recording</source>
            <translation>按 JSON 文件，惯性数据包采用无法读取的格式，而可读的格式一个也没有：下次记录前请将 udp_profile_imu 设为 LEGACY</translation>
        </message>
        <message>
            <source>%1 as long as those of the inertial unit, but to another port or with times that its clock never had, were left out</source>
            <translation>%1与惯性单元的数据包等长，但发往其他端口，或其时间是该时钟从未有过的，已舍去</translation>
        </message>
        <message>
            <source>frame %1 of '%2' can no longer be read</source>
            <translation>无法再读取“%2”的第 %1 帧</translation>
        </message>
        <message>
            <source>the file as it was when it was opened</source>
            <translation>与打开时相同的文件</translation>
        </message>
        <message>
            <source>a pcap file</source>
            <translation>pcap 文件</translation>
        </message>
        <message>
            <source>a pcap file that exists and may be read</source>
            <translation>存在且可读的 pcap 文件</translation>
        </message>
        <message>
            <source>'%1' is empty</source>
            <translation>“%1”为空</translation>
        </message>
        <message>
            <source>a pcap or pcapng capture</source>
            <translation>pcap 或 pcapng 抓包文件</translation>
        </message>
        <message>
            <source>'%1' is not a capture: %2</source>
            <translation>“%1”不是抓包文件：%2</translation>
        </message>
        <message>
            <source>a pcap or pcapng file</source>
            <translation>pcap 或 pcapng 文件</translation>
        </message>
        <message>
            <source>'%1' was captured on a link of type %2</source>
            <translation>“%1”是在类型为 %2 的链路上抓取的</translation>
        </message>
        <message>
            <source>Ethernet, Linux cooked capture, loopback or raw IP</source>
            <translation>以太网、Linux cooked 抓包、环回或原始 IP</translation>
        </message>
        <message>
            <source>%1 UDP datagram</source>
            <translation>%1 个 UDP 数据报</translation>
        </message>
        <message>
            <source>%1 UDP datagrams</source>
            <translation>%1 个 UDP 数据报</translation>
        </message>
        <message>
            <source>'%1' has %2 but no Velodyne data packet to UDP port %3</source>
            <translation>“%1”有%2，但没有发往 UDP 端口 %3 的 Velodyne 数据包</translation>
        </message>
        <message>
            <source>'%1' has %2 but no Velodyne data packet to UDP port %3 (%4)</source>
            <translation>“%1”有%2，但没有发往 UDP 端口 %3 的 Velodyne 数据包（%4）</translation>
        </message>
        <message>
            <source>datagrams of 1206 bytes</source>
            <translation>1206 字节的数据报</translation>
        </message>
        <message>
            <source>Data packets were seen on another port: set the option port to auto</source>
            <translation>在另一端口上看到数据包：请将选项 port 设为 auto</translation>
        </message>
        <message>
            <source>Is this the recording of a Velodyne sensor?</source>
            <translation>这是 Velodyne 传感器的记录吗？</translation>
        </message>
        <message>
            <source>'%1' has %2 whose blocks are all damaged</source>
            <translation>“%1”有%2，其中的数据块全部损坏</translation>
        </message>
        <message>
            <source>data packets of a %1</source>
            <translation>%1 的数据包</translation>
        </message>
        <message>
            <source>the sensor's clock was set %1 during the recording; times continue without the jump</source>
            <translation>记录期间传感器的时钟被调整%1；时间继续，不含跳变</translation>
        </message>
        <message>
            <source>'%1' holds packets of a Velodyne sensor that is not known (%2)</source>
            <translation>“%1”含有未知的 Velodyne 传感器的数据包（%2）</translation>
        </message>
        <message>
            <source>VLP-16, VLP-32C, VLS-128, HDL-32E or HDL-64E</source>
            <translation>VLP-16、VLP-32C、VLS-128、HDL-32E 或 HDL-64E</translation>
        </message>
        <message>
            <source>Name the sensor with the option sensor</source>
            <translation>请用选项 sensor 指定传感器</translation>
        </message>
        <message>
            <source>'%1' calibrates a %2, the capture is of a %3: it was left out</source>
            <translation>“%1”标定的是 %2，而抓包来自 %3：已舍去</translation>
        </message>
        <message>
            <source>every %1 is wired and calibrated by itself, and no calibration lies beside '%2': points may be decimetres off. Put the calibration of the unit (db.xml, or YAML of ROS) beside the capture</source>
            <translation>每台 %1 的接线和标定各不相同，而“%2”旁没有标定文件：点可能偏差数分米。请将该设备的标定文件（db.xml，或 ROS 的 YAML）放在抓包文件旁</translation>
        </message>
        <message>
            <source>%1 has %2 values</source>
            <translation>%1 有 %2 个值</translation>
        </message>
        <message>
            <source>%1, as many as the header line names</source>
            <translation>%1 个，与标题行的列数相同</translation>
        </message>
        <message>
            <source>'%1' line %2</source>
            <translation>“%1”第 %2 行</translation>
        </message>
        <message>
            <source>%1 has '%2'</source>
            <translation>%1 为“%2”</translation>
        </message>
        <message>
            <source>%1 has ''</source>
            <translation>%1 为“”</translation>
        </message>
        <message>
            <source>a number, with a decimal point</source>
            <translation>一个数，用小数点</translation>
        </message>
        <message>
            <source>%1 has a time of %2 s and %3 s</source>
            <translation>%1 的时间为 %2 s 和 %3 s</translation>
        </message>
        <message>
            <source>whole seconds, and a part below a second</source>
            <translation>整秒，以及不足一秒的部分</translation>
        </message>
        <message>
            <source>%1 is no rotation and translation</source>
            <translation>%1 不是旋转加平移</translation>
        </message>
        <message>
            <source>the rows of a 3 by 4 matrix</source>
            <translation>3 x 4 矩阵的各行</translation>
        </message>
        <message>
            <source>%1 has a quaternion of length %2</source>
            <translation>%1 的四元数长度为 %2</translation>
        </message>
        <message>
            <source>length 1</source>
            <translation>长度 1</translation>
        </message>
        <message>
            <source>'%1' begins with '%2'</source>
            <translation>“%1”以“%2”开头</translation>
        </message>
        <message>
            <source>a first line that names the columns, with time and x y z (or longitude latitude height)</source>
            <translation>第一行为列名，含有 time 和 x y z（或 longitude latitude height）</translation>
        </message>
        <message>
            <source>%1 has time %2 after %3</source>
            <translation>%1 的时间 %2 在 %3 之后</translation>
        </message>
        <message>
            <source>times that increase</source>
            <translation>递增的时间</translation>
        </message>
        <message>
            <source>'%1' holds no poses</source>
            <translation>“%1”中没有位姿</translation>
        </message>
        <message>
            <source>'%1' (%2 bytes) is no SBET file</source>
            <translation>“%1”（%2 字节）不是 SBET 文件</translation>
        </message>
        <message>
            <source>records of 17 numbers: time, latitude and longitude in radians, height, ...</source>
            <translation>每条 17 个数的记录：时间、以弧度计的纬度和经度、高度等</translation>
        </message>
        <message>
            <source>'%1' line %2 has more than %3 cells</source>
            <translation>“%1”第 %2 行的单元格超过 %3 个</translation>
        </message>
        <message>
            <source>'%1' line %2 opens a quote that is never closed</source>
            <translation>“%1”第 %2 行的引号没有闭合</translation>
        </message>
        <message>
            <source>a closing "</source>
            <translation>闭合的 "</translation>
        </message>
        <message>
            <source>'%1' is not text</source>
            <translation>“%1”不是文本</translation>
        </message>
        <message>
            <source>a CSV table</source>
            <translation>CSV 表</translation>
        </message>
        <message>
            <source>a line with the names of the columns</source>
            <translation>一行列名</translation>
        </message>
        <message>
            <source>'%1' line %2 has a column without a name</source>
            <translation>“%1”第 %2 行有一列没有名称</translation>
        </message>
        <message>
            <source>'%1' line %2 names the column '%3' twice</source>
            <translation>“%1”第 %2 行有两列都名为“%3”</translation>
        </message>
        <message>
            <source>one name per column</source>
            <translation>每列一个名称</translation>
        </message>
        <message>
            <source>'%1' line %2 has %3 cell</source>
            <translation>“%1”第 %2 行有 %3 个单元格</translation>
        </message>
        <message>
            <source>'%1' line %2 has %3 cells</source>
            <translation>“%1”第 %2 行有 %3 个单元格</translation>
        </message>
        <message>
            <source>%1, one per column</source>
            <translation>%1 个，每列一个</translation>
        </message>
        <message>
            <source>no table is named</source>
            <translation>没有指定表</translation>
        </message>
        <message>
            <source>a CSV file</source>
            <translation>CSV 文件</translation>
        </message>
        <message>
            <source>%1 positions go back in time and are left out, %2 are kept: look whether two logs were joined, or the clock was set</source>
            <translation>%1 个位置的时间倒退，已舍去，保留 %2 个：请检查是否合并了两份日志，或时钟被调整过</translation>
        </message>
        <message>
            <source>the track has no positions</source>
            <translation>GNSS 轨迹没有位置</translation>
        </message>
        <message>
            <source>latitude_deg and longitude_deg, or x_m and y_m</source>
            <translation>列 latitude_deg 和 longitude_deg，或 x_m 和 y_m</translation>
        </message>
        <message>
            <source>%1 positions</source>
            <translation>%1 个位置</translation>
        </message>
        <message>
            <source>%1 gaps of more than %2 s, the longest %3 s</source>
            <translation>%1 处超过 %2 s 的间断，最长 %3 s</translation>
        </message>
        <message>
            <source>line %1 does not have the columns %2</source>
            <translation>第 %1 行没有列 %2</translation>
        </message>
        <message>
            <source>%1 sentences are skipped: %2 with a wrong checksum, %3 without a checksum, %4 with fields that cannot be read</source>
            <translation>跳过了 %1 条语句：%2 条校验和错误，%3 条没有校验和，%4 条字段无法读取</translation>
        </message>
        <message>
            <source>%1 sentences report no fix</source>
            <translation>%1 条语句报告没有定位</translation>
        </message>
        <message>
            <source>%1 epochs have positions of two talkers (%2) more than a metre apart: the log may hold two receivers. That of GN counts, else the first</source>
            <translation>%1 个历元的两种发送标识（%2）的位置相差超过一米：日志可能含有两台接收机。以 GN 为准，否则以第一个为准</translation>
        </message>
        <message>
            <source>%1 has no position</source>
            <translation>%1 没有位置</translation>
        </message>
        <message>
            <source>GGA or RMC sentences with a fix, or rows with coordinates</source>
            <translation>有定位的 GGA 或 RMC 语句，或有坐标的各行</translation>
        </message>
        <message>
            <source>It was read as %1: set the option format if it is another one</source>
            <translation>它按 %1 读取：如果是其他格式，请设置选项 format</translation>
        </message>
        <message>
            <source>no track is named</source>
            <translation>没有指定 GNSS 轨迹</translation>
        </message>
        <message>
            <source>'%1' line %2 has %3 value</source>
            <translation>“%1”第 %2 行有 %3 个值</translation>
        </message>
        <message>
            <source>'%1' line %2 has %3 values</source>
            <translation>“%1”第 %2 行有 %3 个值</translation>
        </message>
        <message>
            <source>'%1' line %2 has '%3'</source>
            <translation>“%1”第 %2 行含有“%3”</translation>
        </message>
        <message>
            <source>time tx ty tz qx qy qz qw</source>
            <translation>时间和 tx ty tz qx qy qz qw（time tx ty tz qx qy qz qw）</translation>
        </message>
        <message>
            <source>length 1 and the order qx qy qz qw</source>
            <translation>长度 1，顺序为 qx qy qz qw</translation>
        </message>
        <message>
            <source>12 numbers: the rows of a 3 by 4 matrix</source>
            <translation>12 个数：3 x 4 矩阵的各行</translation>
        </message>
        <message>
            <source>%1 has no time: there are %2</source>
            <translation>%1 没有时间：共有 %2 个</translation>
        </message>
        <message>
            <source>one time per pose</source>
            <translation>每个位姿一个时间</translation>
        </message>
        <message>
            <source>no trajectory is named</source>
            <translation>没有指定轨迹</translation>
        </message>
        <message>
            <source>'%1' and '%2' differ in their point format</source>
            <translation>“%1”与“%2”的点格式不同</translation>
        </message>
        <message>
            <source>'%1' and '%2' differ in their coordinate steps</source>
            <translation>“%1”与“%2”的坐标步长不同</translation>
        </message>
        <message>
            <source>'%1' and '%2' differ in their coordinate steps (the offset)</source>
            <translation>“%1”与“%2”的坐标步长不同（偏移）</translation>
        </message>
        <message>
            <source>files of one cloud, of the same point format and steps</source>
            <translation>同一点云的文件，点格式和步长相同</translation>
        </message>
        <message>
            <source>Convert them alike: bole convert</source>
            <translation>请作同样的转换：bole convert</translation>
        </message>
        <message>
            <source>'%1' is no LAS, LAZ or COPC file</source>
            <translation>“%1”不是 LAS、LAZ 或 COPC 文件</translation>
        </message>
        <message>
            <source>the coordinates of '%1' are not in metres</source>
            <translation>“%1”的坐标不以米为单位</translation>
        </message>
        <message>
            <source>a projected coordinate system in metres</source>
            <translation>以米为单位的投影坐标系</translation>
        </message>
        <message>
            <source>Project the cloud first</source>
            <translation>请先投影点云</translation>
        </message>
        <message>
            <source>point format</source>
            <translation>点格式</translation>
        </message>
        <message>
            <source>coordinate steps</source>
            <translation>坐标步长</translation>
        </message>
        <message>
            <source>coordinate steps (the offset)</source>
            <translation>坐标步长（偏移）</translation>
        </message>
        <message>
            <source>the buffer of %1 m is wider than the tile of %2 m</source>
            <translation>缓冲区 %1 m 比分块 %2 m 更宽</translation>
        </message>
        <message>
            <source>a tile that is at least as wide as its buffer</source>
            <translation>不小于其缓冲区的分块</translation>
        </message>
        <message>
            <source>Set tile to several times buffer</source>
            <translation>请将 tile 设为 buffer 的数倍</translation>
        </message>
        <message>
            <source>the files hold no points</source>
            <translation>各文件中没有点</translation>
        </message>
        <message>
            <source>no file is given</source>
            <translation>没有给出文件</translation>
        </message>
        <message>
            <source>the files of a cloud</source>
            <translation>点云的各文件</translation>
        </message>
        <message>
            <source>Set files</source>
            <translation>请设置 files</translation>
        </message>
        <message>
            <source>the points lie in more than %1 tiles of %2 m</source>
            <translation>点分布在超过 %1 个 %2 m 的分块中</translation>
        </message>
        <message>
            <source>tiles that fit the cloud</source>
            <translation>与点云相称的分块</translation>
        </message>
        <message>
            <source>Set tile to a larger side; bole info shows how far the cloud reaches</source>
            <translation>请将 tile 设为更大的边长；bole info 显示点云的范围</translation>
        </message>
        <message>
            <source>room for the tiles, buffers included</source>
            <translation>可容纳所有分块（含缓冲区）的空间</translation>
        </message>
        <message>
            <source>'%1' cannot be read again: %2 of %3 bytes</source>
            <translation>无法重新读取'%1'：%3 字节中的 %2 字节</translation>
        </message>
        <message>
            <source>the points of the tile</source>
            <translation>该分块的点</translation>
        </message>
        <message>
            <source>Look at the disk, and cut the cloud again</source>
            <translation>请检查磁盘，然后重新切分点云</translation>
        </message>
        <message>
            <source>writing tiles</source>
            <translation>写出分块</translation>
        </message>
        <message>
            <source>%1 points in %2 tiles of %3 m with buffers of %4 m, %5 of them repeated in buffers</source>
            <translation>%1 个点分入 %2 个 %3 m 的分块，缓冲区 %4 m，其中 %5 个点在缓冲区内重复</translation>
        </message>
        <message>
            <source>the compressed file has no usable chunk table</source>
            <translation>压缩文件没有可用的数据块表</translation>
        </message>
        <message>
            <source>chunks that can be read one by one</source>
            <translation>可以逐块读取的数据块</translation>
        </message>
        <message>
            <source>Write it anew: bole convert FILE NEW.laz</source>
            <translation>请重新写出：bole convert FILE NEW.laz</translation>
        </message>
        <message>
            <source>Write camera.json (pipelines/calibrate_camera.json measures it), or set camera=FILE, camera=fx,fy,cx,cy or one of %1</source>
            <translation>请编写 camera.json（由 pipelines/calibrate_camera.json 测定），或设置 camera=FILE、camera=fx,fy,cx,cy 或下列之一：%1</translation>
        </message>
        <message>
            <source>camera is '%1'</source>
            <translation>选项 camera 为“%1”</translation>
        </message>
        <message>
            <source>a file camera.json, four numbers fx,fy,cx,cy in pixels, or one of %1</source>
            <translation>文件 camera.json，以像素计的四个数 fx,fy,cx,cy，或下列之一：%1</translation>
        </message>
        <message>
            <source>fx and fy of the camera have different signs: its axes, and those of the world, are left-handed, so that everything is mirrored</source>
            <translation>相机的 fx 与 fy 符号不同：相机及世界坐标轴为左手系，因此一切成镜像</translation>
        </message>
        <message>
            <source>the views have no file of their camera</source>
            <translation>视图没有相机的文件</translation>
        </message>
        <message>
            <source>the camera of the views</source>
            <translation>视图的相机</translation>
        </message>
        <message>
            <source>the camera is not known: its focal length is a guess that serves calibration only</source>
            <translation>相机未知：其焦距是只能用于标定的估计值</translation>
        </message>
        <message>
            <source>the entry 'distortion' has %1 numbers</source>
            <translation>条目“distortion”有 %1 个数</translation>
        </message>
        <message>
            <source>k1, k2, p1, p2 and k3</source>
            <translation>k1、k2、p1、p2 和 k3</translation>
        </message>
        <message>
            <source>Calibrate with the model of five coefficients</source>
            <translation>请用五个系数的模型标定</translation>
        </message>
        <message>
            <source>the entry 'intrinsic_matrix' is %1</source>
            <translation>条目“intrinsic_matrix”为 %1</translation>
        </message>
        <message>
            <source>fx, 0, 0, 0, fy, 0, cx, cy, 1</source>
            <translation>九个数 fx, 0, 0, 0, fy, 0, cx, cy, 1</translation>
        </message>
        <message>
            <source>camera.json has no depth_scale: 1000 units of the depth image per metre are assumed</source>
            <translation>camera.json 没有 depth_scale：假定深度图像每米 1000 个单位</translation>
        </message>
        <message>
            <source>the entry 'depth_scale' is %1</source>
            <translation>条目“depth_scale”为 %1</translation>
        </message>
        <message>
            <source>units of the depth image per metre, from 1 to 1000000 (1000: millimetres)</source>
            <translation>深度图像每米的单位数，从 1 至 1000000（1000：毫米）</translation>
        </message>
        <message>
            <source>Metres per unit are given the other way round: 0.001 is 1000</source>
            <translation>如果给出的是每单位的米数，则应取倒数：0.001 即 1000</translation>
        </message>
        <message>
            <source>the entry 'depth' is %1</source>
            <translation>条目“depth”为 %1</translation>
        </message>
        <message>
            <source>a camera: width, height, fx, fy, cx, cy</source>
            <translation>相机：width、height、fx、fy、cx、cy</translation>
        </message>
        <message>
            <source>camera.json has a depth camera and no depth_to_color: the two cameras are taken to be at one place</source>
            <translation>camera.json 有深度相机而没有 depth_to_color：视为两台相机在同一位置</translation>
        </message>
        <message>
            <source>a matrix of 4 x 4 numbers</source>
            <translation>4 x 4 的数值矩阵</translation>
        </message>
        <message>
            <source>depth_to_color moves by %1 m</source>
            <translation>depth_to_color 移动了 %1 m</translation>
        </message>
        <message>
            <source>metres between two cameras of one housing</source>
            <translation>同一机身内两台相机之间以米计的距离</translation>
        </message>
        <message>
            <source>If these are millimetres, divide them by 1000</source>
            <translation>如果以毫米计，请除以 1000</translation>
        </message>
        <message>
            <source>the entry 'squares' is %1</source>
            <translation>条目“squares”为 %1</translation>
        </message>
        <message>
            <source>two whole numbers from 2 to 100: columns and rows</source>
            <translation>两个 2 至 100 的整数：列数和行数</translation>
        </message>
        <message>
            <source>the entry 'dictionary' is '%1'</source>
            <translation>条目“dictionary”为“%1”</translation>
        </message>
        <message>
            <source>a dictionary of OpenCV, such as DICT_4X4_50 or DICT_6X6_250</source>
            <translation>OpenCV 的字典，例如 DICT_4X4_50 或 DICT_6X6_250</translation>
        </message>
        <message>
            <source>a board of %1 x %2 squares has %3 markers, %4 has %5</source>
            <translation>%1 x %2 个方格的标定板有 %3 个标志，而 %4 有 %5 个</translation>
        </message>
        <message>
            <source>a dictionary that is large enough</source>
            <translation>足够大的字典</translation>
        </message>
        <message>
            <source>marker_mm is %1 and square_mm %2</source>
            <translation>marker_mm 为 %1，square_mm 为 %2</translation>
        </message>
        <message>
            <source>markers smaller than the squares, and not below a fifth of them</source>
            <translation>标志小于方格，且不小于方格的五分之一</translation>
        </message>
        <message>
            <source>an object with width, height, fx, fy, cx, cy, distortion (five numbers) and depth_scale</source>
            <translation>含有 width、height、fx、fy、cx、cy、distortion（五个数）和 depth_scale 的对象</translation>
        </message>
        <message>
            <source>the entry 'depth_bias' is %1</source>
            <translation>条目“depth_bias”为 %1</translation>
        </message>
        <message>
            <source>up to three numbers b0, b1, b2 in metres</source>
            <translation>至多三个以米计的数 b0、b1、b2</translation>
        </message>
        <message>
            <source>{"type": "charuco", "dictionary": "DICT_4X4_50", "squares": [11, 9], "square_mm": 30, "marker_mm": 22}</source>
            <translation>例如 {"type": "charuco", "dictionary": "DICT_4X4_50", "squares": [11, 9], "square_mm": 30, "marker_mm": 22}</translation>
        </message>
        <message>
            <source>the entry 'type' is '%1'</source>
            <translation>条目“type”为“%1”</translation>
        </message>
        <message>
            <source>charuco or chessboard</source>
            <translation>charuco 或 chessboard</translation>
        </message>
        <message>
            <source>square_mm is %1</source>
            <translation>square_mm 为 %1</translation>
        </message>
        <message>
            <source>millimetres, from 1 to 1000</source>
            <translation>以毫米计，从 1 至 1000</translation>
        </message>
        <message>
            <source>Metres times 1000 are millimetres</source>
            <translation>米乘以 1000 即毫米</translation>
        </message>
        <message>
            <source>the entry 'first_square' is '%1'</source>
            <translation>条目“first_square”为“%1”</translation>
        </message>
        <message>
            <source>black or white</source>
            <translation>black 或 white</translation>
        </message>
        <message>
            <source>the file is cut off</source>
            <translation>文件被截断</translation>
        </message>
        <message>
            <source>a whole file of COLMAP</source>
            <translation>完整的 COLMAP 文件</translation>
        </message>
        <message>
            <source>the file claims %1 entries and has %2 bytes for them</source>
            <translation>文件声明 %1 个条目，而只有 %2 字节</translation>
        </message>
        <message>
            <source>a name has no end</source>
            <translation>名称没有结尾</translation>
        </message>
        <message>
            <source>a camera has the model %1</source>
            <translation>相机的模型为%1</translation>
        </message>
        <message>
            <source>SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL or OPENCV</source>
            <translation>SIMPLE_PINHOLE、PINHOLE、SIMPLE_RADIAL、RADIAL 或 OPENCV</translation>
        </message>
        <message>
            <source>Undistort the images with colmap image_undistorter first</source>
            <translation>请先用 colmap image_undistorter 对图像去畸变</translation>
        </message>
        <message>
            <source>a camera has %1 x %2 pixels</source>
            <translation>相机的尺寸为 %1 x %2 像素</translation>
        </message>
        <message>
            <source>the size of its images</source>
            <translation>其图像的尺寸</translation>
        </message>
        <message>
            <source>two cameras have the number %1</source>
            <translation>两台相机的编号都是 %1</translation>
        </message>
        <message>
            <source>a number of its own for each</source>
            <translation>每台各有编号</translation>
        </message>
        <message>
            <source>%1 has a value that is no number</source>
            <translation>%1 有一个值不是数</translation>
        </message>
        <message>
            <source>%1 has %2 words</source>
            <translation>%1 有 %2 个词</translation>
        </message>
        <message>
            <source>CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS</source>
            <translation>CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS 各项</translation>
        </message>
        <message>
            <source>%1 has %2 parameters</source>
            <translation>%1 有 %2 个参数</translation>
        </message>
        <message>
            <source>%1 for %2</source>
            <translation>%1 个，对应 %2</translation>
        </message>
        <message>
            <source>number %1</source>
            <translation>编号 %1</translation>
        </message>
        <message>
            <source>camera %1</source>
            <translation>相机 %1</translation>
        </message>
        <message>
            <source>length 1, qw first</source>
            <translation>长度 1，qw 在前</translation>
        </message>
        <message>
            <source>IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, and a line of points</source>
            <translation>IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME 各项，以及一行点</translation>
        </message>
        <message>
            <source>image %1</source>
            <translation>图像 %1</translation>
        </message>
        <message>
            <source>cameras of COLMAP</source>
            <translation>COLMAP 的相机</translation>
        </message>
        <message>
            <source>the file holds no cameras</source>
            <translation>文件中没有相机</translation>
        </message>
        <message>
            <source>images of COLMAP</source>
            <translation>COLMAP 的图像</translation>
        </message>
        <message>
            <source>the file holds no images</source>
            <translation>文件中没有图像</translation>
        </message>
        <message>
            <source>images that COLMAP registered</source>
            <translation>COLMAP 已配准的图像</translation>
        </message>
        <message>
            <source>a point</source>
            <translation>一个点</translation>
        </message>
        <message>
            <source>point %1</source>
            <translation>点 %1</translation>
        </message>
        <message>
            <source>view %1 of '%2'</source>
            <translation>“%2”的视图 %1</translation>
        </message>
        <message>
            <source>%1 images are%2</source>
            <translation>%1图像%2</translation>
        </message>
        <message>
            <source>colour images are missing</source>
            <translation>幅彩色图像缺失</translation>
        </message>
        <message>
            <source>depth images are missing</source>
            <translation>幅深度图像缺失</translation>
        </message>
        <message>
            <source>mask images are missing</source>
            <translation>幅掩膜图像缺失</translation>
        </message>
        <message>
            <source>colour images are damaged</source>
            <translation>幅彩色图像已损坏</translation>
        </message>
        <message>
            <source>depth images are damaged</source>
            <translation>幅深度图像已损坏</translation>
        </message>
        <message>
            <source>mask images are damaged</source>
            <translation>幅掩膜图像已损坏</translation>
        </message>
        <message>
            <source>colour images have another size than the camera</source>
            <translation>幅彩色图像的尺寸与相机不同</translation>
        </message>
        <message>
            <source>depth images have another size than the camera</source>
            <translation>幅深度图像的尺寸与相机不同</translation>
        </message>
        <message>
            <source>mask images have another size than the camera</source>
            <translation>幅掩膜图像的尺寸与相机不同</translation>
        </message>
        <message>
            <source>colour images do not have one channel of 16 bits</source>
            <translation>幅彩色图像不是单通道 16 位</translation>
        </message>
        <message>
            <source>depth images do not have one channel of 16 bits</source>
            <translation>幅深度图像不是单通道 16 位</translation>
        </message>
        <message>
            <source>mask images do not have one channel of 16 bits</source>
            <translation>幅掩膜图像不是单通道 16 位</translation>
        </message>
        <message>
            <source>%1 is %2, the camera %3</source>
            <translation>%1 为 %2，相机为 %3</translation>
        </message>
        <message>
            <source>%1 has %2 of %3 bits</source>
            <translation>%1 有 %2 个 %3 位通道</translation>
        </message>
        <message>
            <source>%1 %2 (first: %3)</source>
            <translation>%1 %2（第一个：%3）</translation>
        </message>
        <message>
            <source>looking at images</source>
            <translation>查看图像</translation>
        </message>
        <message>
            <source>'%1' has no view that can be used: %2</source>
            <translation>“%1”没有可用的视图：%2</translation>
        </message>
        <message>
            <source>colour images of the size of their camera</source>
            <translation>与相机尺寸相同的彩色图像</translation>
        </message>
        <message>
            <source>Calibrate the camera at the size of its images</source>
            <translation>请按图像的尺寸标定相机</translation>
        </message>
        <message>
            <source>'%1' has no depth that can be used: %2</source>
            <translation>“%1”没有可用的深度：%2</translation>
        </message>
        <message>
            <source>depth images with one channel of 16 bits, and of the size of their camera</source>
            <translation>单通道 16 位、且与相机尺寸相同的深度图像</translation>
        </message>
        <message>
            <source>Images that are not registered to colour need the entries depth and depth_to_color in camera.json</source>
            <translation>没有与彩色配准的图像需要 camera.json 中的条目 depth 和 depth_to_color</translation>
        </message>
        <message>
            <source>colour</source>
            <translation>彩色</translation>
        </message>
        <message>
            <source>these views are left out</source>
            <translation>这些视图已舍去</translation>
        </message>
        <message>
            <source>depth</source>
            <translation>深度</translation>
        </message>
        <message>
            <source>these views have no depth</source>
            <translation>这些视图没有深度</translation>
        </message>
        <message>
            <source>mask</source>
            <translation>掩膜</translation>
        </message>
        <message>
            <source>these views have no mask</source>
            <translation>这些视图没有掩膜</translation>
        </message>
        <message>
            <source>%1 is not used: %2 of its %3 poses have the time of a view. Views are at %4 s to %5 s, poses at %6 s to %7 s</source>
            <translation>未采用 %1：其 %3 个位姿中有 %2 个与某个视图的时间相同。视图在 %4 s 至 %5 s，位姿在 %6 s 至 %7 s</translation>
        </message>
        <message>
            <source>poses of %1 have no view</source>
            <translation>个 %1 的位姿没有对应的视图</translation>
        </message>
        <message>
            <source>views have no pose in %1</source>
            <translation>个视图在 %1 中没有位姿</translation>
        </message>
        <message>
            <source>a PNG, JPEG or PGM image</source>
            <translation>PNG、JPEG 或 PGM 图像</translation>
        </message>
        <message>
            <source>'%1' is no whole image (%2 bytes)</source>
            <translation>“%1”不是完整的图像（%2 字节）</translation>
        </message>
        <message>
            <source>the file is no JSON object, or it is cut off</source>
            <translation>文件不是 JSON 对象，或被截断</translation>
        </message>
        <message>
            <source>the entry '%1' is missing</source>
            <translation>缺少条目“%1”</translation>
        </message>
        <message>
            <source>the entry '%1' is %2</source>
            <translation>条目“%1”为 %2</translation>
        </message>
        <message>
            <source>the entry 'width' is %1</source>
            <translation>条目“width”为 %1</translation>
        </message>
        <message>
            <source>the entry 'height' is %1</source>
            <translation>条目“height”为 %1</translation>
        </message>
        <message>
            <source>the given poses are not used: %1</source>
            <translation>未采用给定的位姿：%1</translation>
        </message>
        <message>
            <source>%1 images are missing in the sequence of %2 (first: %3); the times of the others follow from their numbers</source>
            <translation>%2 的序列中缺少 %1 幅图像（第一幅：%3）；其余图像的时间由其编号得出</translation>
        </message>
        <message>
            <source>%1 images of %2 have no number as their name and are left out</source>
            <translation>%2 的 %1 幅图像不以编号命名，已舍去</translation>
        </message>
        <message>
            <source>%1 images of %2 repeat a number</source>
            <translation>%2 的 %1 幅图像编号重复</translation>
        </message>
        <message>
            <source>'%1' does not exist: the views have no depth</source>
            <translation>“%1”不存在：视图没有深度</translation>
        </message>
        <message>
            <source>'%1' holds no depth images: the views have no depth</source>
            <translation>“%1”中没有深度图像：视图没有深度</translation>
        </message>
        <message>
            <source>depth images have no colour image</source>
            <translation>幅深度图像没有对应的彩色图像</translation>
        </message>
        <message>
            <source>%1 is not used: it has %2 poses for %3 images with the numbers %4 to %5</source>
            <translation>未采用 %1：它有 %2 个位姿，而图像有 %3 幅，编号为 %4 至 %5</translation>
        </message>
        <message>
            <source>lengths are in the unit of %1, which need not be the metre: give a board or a known length</source>
            <translation>长度以%1的单位计，未必是米：请给出标定板或已知长度</translation>
        </message>
        <message>
            <source>'%1' does not exist</source>
            <translation>“%1”不存在</translation>
        </message>
        <message>
            <source>'%1' holds images, and none has a number as its name</source>
            <translation>“%1”中有图像，但没有一幅以编号命名</translation>
        </message>
        <message>
            <source>'%1' holds no images</source>
            <translation>“%1”中没有图像</translation>
        </message>
        <message>
            <source>images 000000.png, 000001.png, ... (.png or .jpg)</source>
            <translation>图像 000000.png、000001.png 等（.png 或 .jpg）</translation>
        </message>
        <message>
            <source>the images of '%1' are not found (first: '%2')</source>
            <translation>找不到“%1”的图像（第一幅：“%2”）</translation>
        </message>
        <message>
            <source>a folder images/ in the folder of the model or above it</source>
            <translation>模型所在文件夹或其上级中的文件夹 images/</translation>
        </message>
        <message>
            <source>'%1' holds no model of COLMAP</source>
            <translation>“%1”中没有 COLMAP 模型</translation>
        </message>
        <message>
            <source>cameras and images, .bin or .txt</source>
            <translation>cameras 和 images，.bin 或 .txt</translation>
        </message>
        <message>
            <source>the option camera is set, and the model has the cameras</source>
            <translation>设置了选项 camera，而模型已有相机</translation>
        </message>
        <message>
            <source>one of both</source>
            <translation>两者之一</translation>
        </message>
        <message>
            <source>Leave camera empty</source>
            <translation>请将 camera 留空</translation>
        </message>
        <message>
            <source>image '%1' has camera %2</source>
            <translation>图像“%1”的相机为 %2</translation>
        </message>
        <message>
            <source>one of the cameras file</source>
            <translation>cameras 文件中的一台相机</translation>
        </message>
        <message>
            <source>the model of COLMAP</source>
            <translation>COLMAP 模型</translation>
        </message>
        <message>
            <source>'%1' has no folder of colour images</source>
            <translation>“%1”没有彩色图像的文件夹</translation>
        </message>
        <message>
            <source>color/ and depth/</source>
            <translation>文件夹 color/ 和 depth/</translation>
        </message>
        <message>
            <source>'%1' holds no images that are named by a number</source>
            <translation>“%1”中没有以编号命名的图像</translation>
        </message>
        <message>
            <source>0.png, 1.png, ...</source>
            <translation>0.png、1.png 等</translation>
        </message>
        <message>
            <source>the scale of the depth is not given: 1000 units per metre are assumed. Set depth_scale (ICL and TUM: 5000)</source>
            <translation>没有给出深度的比例：假定每米 1000 个单位。请设置 depth_scale（ICL 和 TUM：5000）</translation>
        </message>
        <message>
            <source>.png, .jpg or .pgm</source>
            <translation>.png、.jpg 或 .pgm</translation>
        </message>
        <message>
            <source>transforms.json is read, and the %1 files beside it are not</source>
            <translation>读取 transforms.json，其旁的 %1 个文件不读取</translation>
        </message>
        <message>
            <source>none of its images is there (first: '%1')</source>
            <translation>其图像一幅也没有（第一幅：“%1”）</translation>
        </message>
        <message>
            <source>the images</source>
            <translation>这些图像</translation>
        </message>
        <message>
            <source>the option camera is set, and transforms.json has the cameras</source>
            <translation>设置了选项 camera，而 transforms.json 已有相机</translation>
        </message>
        <message>
            <source>'%1' holds no transforms.json</source>
            <translation>“%1”中没有 transforms.json</translation>
        </message>
        <message>
            <source>they have no pose</source>
            <translation>它们没有位姿</translation>
        </message>
        <message>
            <source>views have a matrix that is no rigid motion</source>
            <translation>个视图的矩阵不是刚体运动</translation>
        </message>
        <message>
            <source>depth is not registered to colour, and the metadata do not say where the two cameras are: they are taken to be at one place. Export aligned depth, or write camera.json</source>
            <translation>深度没有与彩色配准，元数据也没有说明两台相机的位置：视为在同一位置。请导出对齐的深度，或编写 camera.json</translation>
        </message>
        <message>
            <source>views have no depth image</source>
            <translation>个视图没有深度图像</translation>
        </message>
        <message>
            <source>'%1' holds no images NAME_Color_TIME.png</source>
            <translation>“%1”中没有名为 NAME_Color_TIME.png 的图像</translation>
        </message>
        <message>
            <source>exported images</source>
            <translation>导出的图像</translation>
        </message>
        <message>
            <source>'%1' has the time of another image</source>
            <translation>“%1”的时间与另一幅图像相同</translation>
        </message>
        <message>
            <source>one recording in a folder</source>
            <translation>一个文件夹中只有一次记录</translation>
        </message>
        <message>
            <source>there are no images NAME_Depth_TIME.png: the views have no depth</source>
            <translation>没有名为 NAME_Depth_TIME.png 的图像：视图没有深度</translation>
        </message>
        <message>
            <source>3 x 3 numbers</source>
            <translation>3 x 3 个数</translation>
        </message>
        <message>
            <source>3 numbers</source>
            <translation>3 个数</translation>
        </message>
        <message>
            <source>rotmat and tvec are no pose</source>
            <translation>rotmat 和 tvec 不是位姿</translation>
        </message>
        <message>
            <source>3 x 3 and 3 numbers</source>
            <translation>3 x 3 个数和 3 个数</translation>
        </message>
        <message>
            <source>fx, fy, cx, cy, k1, k2, p1, p2</source>
            <translation>参数 fx、fy、cx、cy、k1、k2、p1、p2</translation>
        </message>
        <message>
            <source>the camera model is %1 with %2 parameters</source>
            <translation>相机模型为 %1，有 %2 个参数</translation>
        </message>
        <message>
            <source>the metadata of an image</source>
            <translation>图像的元数据</translation>
        </message>
        <message>
            <source>x, y, z, pan and tilt</source>
            <translation>x、y、z、pan 和 tilt</translation>
        </message>
        <message>
            <source>the pose has %1 numbers</source>
            <translation>位姿有 %1 个数</translation>
        </message>
        <message>
            <source>'%1' describes no image</source>
            <translation>“%1”没有描述任何图像</translation>
        </message>
        <message>
            <source>files 00000_rgb.json</source>
            <translation>文件 00000_rgb.json 等</translation>
        </message>
        <message>
            <source>files of metadata cannot be used</source>
            <translation>个元数据文件不能使用</translation>
        </message>
        <message>
            <source>their images are left out</source>
            <translation>其图像已舍去</translation>
        </message>
        <message>
            <source>%1 poses are those that the arm was sent to, not measured: estimate the poses from the images</source>
            <translation>%1 个位姿是机械臂的指令位姿，不是测得的：请由图像估计位姿</translation>
        </message>
        <message>
            <source>'%1' is no matrix of a camera</source>
            <translation>“%1”不是相机的矩阵</translation>
        </message>
        <message>
            <source>fx 0 cx / 0 fy cy / 0 0 1</source>
            <translation>矩阵 fx 0 cx / 0 fy cy / 0 0 1</translation>
        </message>
        <message>
            <source>there are no files of poses</source>
            <translation>没有位姿文件</translation>
        </message>
        <message>
            <source>views have no file of their pose</source>
            <translation>个视图没有位姿文件</translation>
        </message>
        <message>
            <source>views were lost by the tracker that made the poses</source>
            <translation>个视图被生成位姿的跟踪器跟丢</translation>
        </message>
        <message>
            <source>files of poses are no matrix of 4 x 4 numbers</source>
            <translation>个位姿文件不是 4 x 4 的数值矩阵</translation>
        </message>
        <message>
            <source>there is no intrinsic_color.txt: colour is taken to be registered to depth</source>
            <translation>没有 intrinsic_color.txt：视为彩色已与深度配准</translation>
        </message>
        <message>
            <source>'%1' holds no files frame-000000.color.png</source>
            <translation>“%1”中没有文件 frame-000000.color.png 等</translation>
        </message>
        <message>
            <source>the layout of 7-Scenes</source>
            <translation>7-Scenes 的目录结构</translation>
        </message>
        <message>
            <source>the folder</source>
            <translation>文件夹</translation>
        </message>
        <message>
            <source>there is no camera-intrinsics.txt: the depth camera of 7-Scenes is taken (585, 585, 320, 240)</source>
            <translation>没有 camera-intrinsics.txt：采用 7-Scenes 的深度相机（585, 585, 320, 240）</translation>
        </message>
        <message>
            <source>0.jpg, 1.jpg, ...</source>
            <translation>0.jpg、1.jpg 等</translation>
        </message>
        <message>
            <source>a time and the name of a file, or both twice</source>
            <translation>一个时间和一个文件名，或两者各两个</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>已舍去</translation>
        </message>
        <message>
            <source>views have the time of another one</source>
            <translation>个视图与另一个视图时间相同</translation>
        </message>
        <message>
            <source>the associations name one file in a line</source>
            <translation>关联文件每行只有一个文件名</translation>
        </message>
        <message>
            <source>colour and depth in each line</source>
            <translation>每行有彩色和深度</translation>
        </message>
        <message>
            <source>views have no depth image within 20 ms</source>
            <translation>个视图在 20 ms 内没有深度图像</translation>
        </message>
        <message>
            <source>'%1' lists no colour images</source>
            <translation>“%1”没有列出彩色图像</translation>
        </message>
        <message>
            <source>lines 'time name'</source>
            <translation>“时间 文件名”（time name）各行</translation>
        </message>
        <message>
            <source>the camera is %1, by the name of the recording; camera=FILE gives another one</source>
            <translation>按记录的名称，相机为 %1；camera=FILE 可指定其他相机</translation>
        </message>
        <message>
            <source>has color/ and no camera.json</source>
            <translation>有 color/ 而没有 camera.json</translation>
        </message>
        <message>
            <source>holds %1 images and no file of their camera</source>
            <translation>中有 %1 幅图像，而没有其相机的文件</translation>
        </message>
        <message>
            <source>holds no views; its folder '%1' does</source>
            <translation>中没有视图；其下的文件夹“%1”中有</translation>
        </message>
        <message>
            <source>holds no views (first entry: '%1')</source>
            <translation>中没有视图（第一个条目：“%1”）</translation>
        </message>
        <message>
            <source>no folder of views is named</source>
            <translation>没有指定视图的文件夹</translation>
        </message>
        <message>
            <source>Set the option folder</source>
            <translation>请设置选项 folder</translation>
        </message>
        <message>
            <source>the folder '%1' %2</source>
            <translation>文件夹“%1”%2</translation>
        </message>
        <message>
            <source>A camera is given by camera.json in the folder (pipelines/calibrate_camera.json measures it)</source>
            <translation>相机由文件夹中的 camera.json 给出（由 pipelines/calibrate_camera.json 测定）</translation>
        </message>
        <message>
            <source>'%1' is no file of views</source>
            <translation>“%1”不是视图的文件</translation>
        </message>
        <message>
            <source>the depth images that were looked at hold no depth</source>
            <translation>检查的深度图像中没有深度</translation>
        </message>
        <message>
            <source>half of the depth lies beyond %1 m with %2 units per metre. If that is wrong, set depth_scale (1000: millimetres)</source>
            <translation>按每米 %2 个单位，一半的深度超过 %1 m。如果不对，请设置 depth_scale（1000：毫米）</translation>
        </message>
        <message>
            <source>views %1 and %2 have the same time</source>
            <translation>视图 %1 和 %2 的时间相同</translation>
        </message>
        <message>
            <source>'%1' pose %2 has no line of numbers above it</source>
            <translation>“%1”的位姿 %2 之上没有数字行</translation>
        </message>
        <message>
            <source>per view: tx ty tz qx qy qz qw, a time before them, 12 or 16 numbers of a matrix, or 4 lines of a matrix</source>
            <translation>每个视图：tx ty tz qx qy qz qw，其前可有时间，或矩阵的 12 或 16 个数，或矩阵的 4 行</translation>
        </message>
        <message>
            <source>'%1' pose %2 is cut off or no matrix</source>
            <translation>“%1”的位姿 %2 被截断或不是矩阵</translation>
        </message>
        <message>
            <source>'%1' has lines of %2 numbers</source>
            <translation>“%1”的各行有 %2 个数</translation>
        </message>
        <message>
            <source>'%1' pose %2 has %3 numbers</source>
            <translation>“%1”的位姿 %2 有 %3 个数</translation>
        </message>
        <message>
            <source>'%1' pose %2</source>
            <translation>“%1”的位姿 %2</translation>
        </message>
        <message>
            <source>%1 has %2 numbers</source>
            <translation>%1 有 %2 个数</translation>
        </message>
        <message>
            <source>4 x 4 numbers, rows first: a rotation and a translation</source>
            <translation>4 x 4 个数，按行排列：旋转和平移</translation>
        </message>
        <message>
            <source>the camera model is a fisheye</source>
            <translation>相机模型为鱼眼</translation>
        </message>
        <message>
            <source>the camera model is 'PINHOLE'</source>
            <translation>相机模型为“PINHOLE”</translation>
        </message>
        <message>
            <source>the camera model is '%1'</source>
            <translation>相机模型为“%1”</translation>
        </message>
        <message>
            <source>PINHOLE, OPENCV, SIMPLE_RADIAL or RADIAL</source>
            <translation>PINHOLE、OPENCV、SIMPLE_RADIAL 或 RADIAL</translation>
        </message>
        <message>
            <source>Undistort the images first</source>
            <translation>请先对图像去畸变</translation>
        </message>
        <message>
            <source>the camera has a coefficient k4</source>
            <translation>相机含有系数 k4</translation>
        </message>
        <message>
            <source>the image is %1 x %2 pixels</source>
            <translation>图像为 %1 x %2 像素</translation>
        </message>
        <message>
            <source>there is neither fl_x nor camera_angle_x</source>
            <translation>既没有 fl_x 也没有 camera_angle_x</translation>
        </message>
        <message>
            <source>camera_angle_x is %1</source>
            <translation>camera_angle_x 为 %1</translation>
        </message>
        <message>
            <source>fl_x in pixels, or camera_angle_x in radians, above 0 and below pi</source>
            <translation>以像素计的 fl_x，或以弧度计、大于 0 且小于 π 的 camera_angle_x</translation>
        </message>
        <message>
            <source>4 x 4 numbers</source>
            <translation>4 x 4 个数</translation>
        </message>
        <message>
            <source>an object with frames (file_path, transform_matrix) and camera_angle_x or fl_x</source>
            <translation>含有 frames（file_path、transform_matrix）和 camera_angle_x 或 fl_x 的对象</translation>
        </message>
        <message>
            <source>the file has no views ('frames')</source>
            <translation>文件没有视图（“frames”）</translation>
        </message>
        <message>
            <source>depth_unit_scale_factor is %1</source>
            <translation>depth_unit_scale_factor 为 %1</translation>
        </message>
        <message>
            <source>metres per unit, from 0.000001 to 1</source>
            <translation>每单位的米数，从 0.000001 至 1</translation>
        </message>
        <message>
            <source>it is %1</source>
            <translation>其值为 %1</translation>
        </message>
        <message>
            <source>it has no file_path</source>
            <translation>没有 file_path</translation>
        </message>
        <message>
            <source>%1 is no whole image</source>
            <translation>%1 不是完整的图像</translation>
        </message>
        <message>
            <source>a whole PNG, JPEG or PGM image</source>
            <translation>完整的 PNG、JPEG 或 PGM 图像</translation>
        </message>
        <message>
            <source>%1 is cut off</source>
            <translation>%1 被截断</translation>
        </message>
        <message>
            <source>%1 cannot be decoded: %2</source>
            <translation>无法解码 %1：%2</translation>
        </message>
        <message>
            <source>%1 is damaged or cut off</source>
            <translation>%1 已损坏或被截断</translation>
        </message>
        <message>
            <source>%1 cannot be encoded</source>
            <translation>无法编码 %1</translation>
        </message>
        <message>
            <source>an image that is not empty, .png or .jpg</source>
            <translation>非空的图像，.png 或 .jpg</translation>
        </message>
        <message>
            <source>%1 is no colour image</source>
            <translation>%1 不是彩色图像</translation>
        </message>
        <message>
            <source>%1 has %2 channels of %3 bits</source>
            <translation>%1 有 %2 个 %3 位通道</translation>
        </message>
        <message>
            <source>depth images of one channel and 16 bits</source>
            <translation>单通道 16 位的深度图像</translation>
        </message>
        <message>
            <source>%1 is no depth image</source>
            <translation>%1 不是深度图像</translation>
        </message>
        <message>
            <source> or %1 (%2)</source>
            <translation> 或 %1（%2）</translation>
        </message>
        <message>
            <source>the option crs has no effect: the positions of the file are no longitudes and latitudes</source>
            <translation>选项 crs 不起作用：文件中的位置不是经度和纬度</translation>
        </message>
        <message>
            <source>the positions of the trajectory are longitudes and latitudes</source>
            <translation>轨迹的位置是经度和纬度</translation>
        </message>
        <message>
            <source>the coordinate system of the points</source>
            <translation>点的坐标系</translation>
        </message>
        <message>
            <source>the path was projected to %1; its heights are above the ellipsoid, unless crs has a height system. Those of the points must be the same</source>
            <translation>路径已投影到 %1；除非 crs 含有高程系统，其高度为椭球高。点的坐标系必须相同</translation>
        </message>
        <message>
            <source>%1 rows, %2 columns</source>
            <translation>%1 行，%2 列</translation>
        </message>
        <message>
            <source>, given in memory</source>
            <translation>，由内存给出</translation>
        </message>
        <message>
            <source>%1 poses repeat the time of an earlier one and were left out</source>
            <translation>%1 个位姿的时间与更早的相同，已舍去</translation>
        </message>
        <message>
            <source>%1 records cannot be (times, angles or heights out of range) and were left out</source>
            <translation>%1 条记录不可能成立（时间、角度或高度超出范围），已舍去</translation>
        </message>
        <message>
            <source>the file ends within a record: it was cut off, and the end of the path may be missing</source>
            <translation>文件在一条记录的中间结束：它被截断，路径的末尾可能缺失</translation>
        </message>
        <message>
            <source>orientations of the path are not known: only its positions can be used</source>
            <translation>路径的姿态未知：只能使用其位置</translation>
        </message>
        <message>
            <source>%1 poses</source>
            <translation>%1 个位姿</translation>
        </message>
        <message>
            <source>there is no folder to write the tiles into</source>
            <translation>没有可写出分块的文件夹</translation>
        </message>
        <message>
            <source>an output folder</source>
            <translation>输出文件夹</translation>
        </message>
        <message>
            <source>Give --out DIR</source>
            <translation>请用 --out DIR 指定</translation>
        </message>
        <message>
            <source>%1 x %2 cells of %3 m</source>
            <translation>%1 x %2 个单元，每个 %3 m</translation>
        </message>
        <message>
            <source>'%1' does not show the survey: it is %2 away</source>
            <translation>“%1”中看不到调查数据：两者相距 %2</translation>
        </message>
        <message>
            <source>'%1' does not tell where on the earth it lies</source>
            <translation>“%1”没有给出它在地球上的位置</translation>
        </message>
        <message>
            <source>'%1' has no band with colours</source>
            <translation>“%1”没有颜色波段</translation>
        </message>
        <message>
            <source>'%1' is in '%2', and PROJ knows no way from there to '%3': %4</source>
            <translation>“%1”的坐标系是“%2”，PROJ 没有从它到“%3”的转换：%4</translation>
        </message>
        <message>
            <source>'%1' is not there</source>
            <translation>找不到“%1”</translation>
        </message>
        <message>
            <source>'%1' shows another part of the earth</source>
            <translation>“%1”显示的是地球上的另一处</translation>
        </message>
        <message>
            <source>Check the coordinate systems of the picture and of the survey</source>
            <translation>请检查图像和调查数据的坐标系</translation>
        </message>
        <message>
            <source>Georeference the picture in a GIS</source>
            <translation>请在 GIS 中为图像配准</translation>
        </message>
        <message>
            <source>PROJ does not know the coordinate system of the survey, '%1'</source>
            <translation>PROJ 不认识调查数据的坐标系“%1”</translation>
        </message>
        <message>
            <source>a GeoTIFF with a georeference, or a PNG or JPEG with a world file (.pgw, .jgw) beside it</source>
            <translation>带地理参照的 GeoTIFF，或旁边有坐标文件(.pgw、.jgw)的 PNG 或 JPEG</translation>
        </message>
        <message>
            <source>a coordinate system of the same place on the earth</source>
            <translation>地球上同一地点的坐标系</translation>
        </message>
        <message>
            <source>a picture</source>
            <translation>图像</translation>
        </message>
        <message>
            <source>a picture of the place of the survey</source>
            <translation>调查所在地的图像</translation>
        </message>
        <message>
            <source>a picture that GDAL reads: GeoTIFF, PNG, JPEG, ...</source>
            <translation>GDAL 能读取的图像：GeoTIFF、PNG、JPEG 等</translation>
        </message>
        <message>
            <source>a projected coordinate system</source>
            <translation>投影坐标系</translation>
        </message>
        <message>
            <source>a smaller picture</source>
            <translation>较小的图像</translation>
        </message>
        <message>
            <source>band %1 of '%2' holds complex numbers</source>
            <translation>“%2”的波段 %1 为复数</translation>
        </message>
        <message>
            <source>map</source>
            <translation>底图</translation>
        </message>
        <message>
            <source>the map could not be warped: %1</source>
            <translation>底图无法重采样：%1</translation>
        </message>
        <message>
            <source>the survey is in '%1', which is no plane</source>
            <translation>调查数据的坐标系是“%1”，不是平面坐标系</translation>
        </message>
        <message>
            <source>there is no memory for the map</source>
            <translation>没有足够的内存容纳底图</translation>
        </message>
    </context>
    <context>
        <name>pipeline</name>
        <message>
            <source>%1 has an unknown key '%2'</source>
            <translation>%1 有未知的键“%2”</translation>
        </message>
        <message>
            <source>one of the keys that `bole stages --schema` lists</source>
            <translation>`bole stages --schema` 列出的键之一</translation>
        </message>
        <message>
            <source>%1: 'description' is %2</source>
            <translation>%1：“description”为 %2</translation>
        </message>
        <message>
            <source>%1: 'id' is %2</source>
            <translation>%1：“id”为 %2</translation>
        </message>
        <message>
            <source>%1: 'title' is %2</source>
            <translation>%1：“title”为 %2</translation>
        </message>
        <message>
            <source>%1: 'type' is %2</source>
            <translation>%1：“type”为 %2</translation>
        </message>
        <message>
            <source>option %1 is %2</source>
            <translation>选项 %1 为 %2</translation>
        </message>
        <message>
            <source>an object with id, type, inputs, options</source>
            <translation>含 id、type、inputs、options 的对象</translation>
        </message>
        <message>
            <source>stage %1 is %2</source>
            <translation>步骤 %1 为 %2</translation>
        </message>
        <message>
            <source>a name without a dot</source>
            <translation>不含点号的名称</translation>
        </message>
        <message>
            <source>stage %1 has the id '%2'</source>
            <translation>步骤 %1 的 id 为“%2”</translation>
        </message>
        <message>
            <source>stage %1</source>
            <translation>步骤 %1</translation>
        </message>
        <message>
            <source>stage '%1'</source>
            <translation>步骤“%1”</translation>
        </message>
        <message>
            <source>'optional' is %1</source>
            <translation>“optional”为 %1</translation>
        </message>
        <message>
            <source>'inputs' is %1</source>
            <translation>“inputs”为 %1</translation>
        </message>
        <message>
            <source>an object of port: "id.port"</source>
            <translation>port: "id.port" 形式的对象</translation>
        </message>
        <message>
            <source>a text "id.port"</source>
            <translation>文本 "id.port"</translation>
        </message>
        <message>
            <source>input '%1' is %2</source>
            <translation>输入“%1”为 %2</translation>
        </message>
        <message>
            <source>'options' is %1</source>
            <translation>“options”为 %1</translation>
        </message>
        <message>
            <source>an object of option: value</source>
            <translation>option: value 形式的对象</translation>
        </message>
        <message>
            <source>"id.port" of another stage</source>
            <translation>另一步骤的 "id.port"</translation>
        </message>
        <message>
            <source>a pipeline document</source>
            <translation>处理流程文档</translation>
        </message>
        <message>
            <source>not a JSON text: %1</source>
            <translation>不是 JSON 文本：%1</translation>
        </message>
        <message>
            <source>an object with a list "stages"</source>
            <translation>含列表 "stages" 的对象</translation>
        </message>
        <message>
            <source>no list of stages</source>
            <translation>没有步骤列表</translation>
        </message>
        <message>
            <source>the document</source>
            <translation>文档</translation>
        </message>
        <message>
            <source>different ids</source>
            <translation>不同的 id</translation>
        </message>
        <message>
            <source>two stages have the id '%1'</source>
            <translation>两个步骤的 id 都是“%1”</translation>
        </message>
        <message>
            <source>the document has no stage</source>
            <translation>文档没有步骤</translation>
        </message>
        <message>
            <source>a readable JSON file</source>
            <translation>可读的 JSON 文件</translation>
        </message>
        <message>
            <source>cannot open the pipeline '%1'</source>
            <translation>无法打开处理流程“%1”</translation>
        </message>
        <message>
            <source>the pipeline has no stage '%1'</source>
            <translation>处理流程没有步骤“%1”</translation>
        </message>
        <message>
            <source>stage '%1' takes its own output</source>
            <translation>步骤“%1”以自己的输出为输入</translation>
        </message>
        <message>
            <source>stages joined without a circle</source>
            <translation>没有循环的步骤连接</translation>
        </message>
        <message>
            <source>Choose another folder, move the file away, or allow that it is written over (--force)</source>
            <translation>请选择另一文件夹，移走该文件，或允许覆盖（--force）</translation>
        </message>
        <message>
            <source>'%1' is a file</source>
            <translation>“%1”是文件</translation>
        </message>
        <message>
            <source>Give another --out DIR</source>
            <translation>请给出另一个 --out DIR</translation>
        </message>
        <message>
            <source>a folder for the results</source>
            <translation>存放结果的文件夹</translation>
        </message>
        <message>
            <source>cannot make the folder '%1': %2</source>
            <translation>无法创建文件夹“%1”：%2</translation>
        </message>
        <message>
            <source>cannot find the folder '%1': %2</source>
            <translation>找不到文件夹“%1”：%2</translation>
        </message>
        <message>
            <source>cannot write into the folder '%1': %2</source>
            <translation>无法写入文件夹“%1”：%2</translation>
        </message>
        <message>
            <source>'%1' is a folder</source>
            <translation>“%1”是文件夹</translation>
        </message>
        <message>
            <source>Move it away or choose another folder</source>
            <translation>请移走它或选择另一文件夹</translation>
        </message>
        <message>
            <source>a name that is free for a result</source>
            <translation>可用于结果的名称</translation>
        </message>
        <message>
            <source>a folder without them</source>
            <translation>不含这些文件的文件夹</translation>
        </message>
        <message>
            <source>the folder '%1' holds files that no run of Bole wrote and that have the names of results: %2</source>
            <translation>文件夹“%1”含有并非由 Bole 写出、但与结果同名的文件：%2</translation>
        </message>
        <message>
            <source>a name that is free: results go into a folder of that name</source>
            <translation>可用的名称：结果存入该名称的文件夹</translation>
        </message>
        <message>
            <source>'%1' was not written by Bole</source>
            <translation>“%1”不是由 Bole 写出的</translation>
        </message>
        <message>
            <source>'%1' was changed since Bole wrote it and cannot be kept: %2</source>
            <translation>“%1”在 Bole 写出后被改动，且无法保存：%2</translation>
        </message>
        <message>
            <source>space for a copy</source>
            <translation>存放副本的空间</translation>
        </message>
        <message>
            <source>%1 was changed after Bole wrote it: the changed file is kept as %2, and this survey does not hold what was typed into it</source>
            <translation>%1 在 Bole 写出后被改动：改动过的文件保存为 %2，此次调查不含其中填入的内容</translation>
        </message>
        <message>
            <source>input '%1' is not connected</source>
            <translation>输入“%1”未连接</translation>
        </message>
        <message>
            <source>input '%1' is a %2</source>
            <translation>输入“%1”是 %2</translation>
        </message>
        <message>
            <source>less data at once</source>
            <translation>一次处理较少的数据</translation>
        </message>
        <message>
            <source>out of memory</source>
            <translation>内存不足</translation>
        </message>
        <message>
            <source>Set its option with the path</source>
            <translation>请设置其路径选项</translation>
        </message>
        <message>
            <source>a file</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>the stage takes no data from memory</source>
            <translation>该步骤不接受内存中的数据</translation>
        </message>
        <message>
            <source>a %1 was given</source>
            <translation>给出的是 %1</translation>
        </message>
        <message>
            <source>one of the readers that do</source>
            <translation>能如此读取的步骤之一</translation>
        </message>
        <message>
            <source>the stage gives no pieces</source>
            <translation>该步骤不分块给出</translation>
        </message>
        <message>
            <source>a name of its own for each</source>
            <translation>各自不同的名称</translation>
        </message>
        <message>
            <source>there are two stage types '%1'</source>
            <translation>有两个步骤类型“%1”</translation>
        </message>
        <message>
            <source>one that `bole stages` lists</source>
            <translation>`bole stages` 列出的类型之一</translation>
        </message>
        <message>
            <source>there is no stage type '%1'</source>
            <translation>没有步骤类型“%1”</translation>
        </message>
    </context>
    <context>
        <name>plant</name>
        <message>
            <source>the table of traits has %1 rows</source>
            <translation>性状表有 %1 行</translation>
        </message>
        <message>
            <source>one plant</source>
            <translation>一株植株</translation>
        </message>
        <message>
            <source>Edit %1 (%2) was not applied: %3.</source>
            <translation>第 %1 项编辑（%2）未应用：%3。</translation>
        </message>
        <message>
            <source>%1 of %2 edits applied</source>
            <translation>应用了 %2 项编辑中的 %1 项</translation>
        </message>
        <message>
            <source>assign</source>
            <translation>指定</translation>
        </message>
        <message>
            <source>trait is '%1'</source>
            <translation>trait 为“%1”</translation>
        </message>
        <message>
            <source>height, breadth_length, breadth_width or stem_diameter</source>
            <translation>height、breadth_length、breadth_width 或 stem_diameter</translation>
        </message>
        <message>
            <source>the box ends before it begins</source>
            <translation>范围框的终点在起点之前</translation>
        </message>
        <message>
            <source>min below max in x, y and z</source>
            <translation>在 x、y 和 z 上 min 均小于 max</translation>
        </message>
        <message>
            <source>assign does not say which points</source>
            <translation>assign 没有说明是哪些点</translation>
        </message>
        <message>
            <source>at and radius_m, or min and max, or outline (and eye)</source>
            <translation>at 和 radius_m，或 min 和 max，或 outline（和 eye）</translation>
        </message>
        <message>
            <source>finding where to look</source>
            <translation>确定查找范围</translation>
        </message>
        <message>
            <source>no depth of two views lies at one place of the region</source>
            <translation>区域内没有一处有两个视图的深度</translation>
        </message>
        <message>
            <source>depth of the plant</source>
            <translation>植株的深度</translation>
        </message>
        <message>
            <source>Check the region, the poses and the depth scale</source>
            <translation>请检查区域、位姿和深度比例</translation>
        </message>
        <message>
            <source>Voxels of %1 mm need more than %2 MiB: %3 mm were used. Give a smaller region or more memory.</source>
            <translation>%1 mm 的体素需要超过 %2 MiB：采用 %3 mm。请给出更小的区域或更多内存。</translation>
        </message>
        <message>
            <source>rendering depth</source>
            <translation>渲染深度</translation>
        </message>
        <message>
            <source>it ends early</source>
            <translation>提前结束</translation>
        </message>
        <message>
            <source>it has no fact 'field' or no column 'value'</source>
            <translation>没有附注“field”或没有列“value”</translation>
        </message>
        <message>
            <source>reading views</source>
            <translation>读取视图</translation>
        </message>
        <message>
            <source>view %1 has no colour image</source>
            <translation>视图 %1 没有彩色图像</translation>
        </message>
        <message>
            <source>colour images with three channels</source>
            <translation>三通道的彩色图像</translation>
        </message>
        <message>
            <source>the masks of the views leave no room in common</source>
            <translation>各视图的掩膜没有共同的空间</translation>
        </message>
        <message>
            <source>masks that show one object from all sides</source>
            <translation>从各个方向显示同一物体的掩膜</translation>
        </message>
        <message>
            <source>Check masks and poses, or give background=scene, which uses no masks</source>
            <translation>请检查掩膜和位姿，或设置不用掩膜的 background=scene</translation>
        </message>
        <message>
            <source>pose %1 of %2 poses</source>
            <translation>%2 个位姿中的位姿 %1</translation>
        </message>
        <message>
            <source>the table is no field: %1</source>
            <translation>该表不是辐射场：%1</translation>
        </message>
        <message>
            <source>the output 'field' of plant.field</source>
            <translation>plant.field 的输出“field”</translation>
        </message>
        <message>
            <source>value %1 is %2</source>
            <translation>值 %1 为 %2</translation>
        </message>
        <message>
            <source>its step is out of range</source>
            <translation>步长超出范围</translation>
        </message>
        <message>
            <source>it has %1 boxes</source>
            <translation>有 %1 个框</translation>
        </message>
        <message>
            <source>a box has no blocks</source>
            <translation>一个框没有块</translation>
        </message>
        <message>
            <source>a box is larger than its numbers</source>
            <translation>一个框大于其数值</translation>
        </message>
        <message>
            <source>The stem could not be followed from its foot: leaves and internodes were not measured. Look at the base of the plant.</source>
            <translation>无法从基部沿茎追踪：未测叶片和节间。请检查植株的基部。</translation>
        </message>
        <message>
            <source>%1 of %2 leaves touch others, or are hidden in part: their rows say check.</source>
            <translation>%2 片叶中有 %1 片与其他叶接触或部分被遮挡：其所在行标为 check。</translation>
        </message>
        <message>
            <source>%1 of %2 leaves hang on others: the cloud is too coarse or too thick to tell leaves and stem apart. Number and area of the leaves and the length of the stem are left out; do not use the tables of leaves and internodes.</source>
            <translation>%2 片叶中有 %1 片长在其他叶上：点云太粗或太厚，无法区分叶与茎。叶的数量和面积以及茎的长度不给出；请勿使用叶和节间的表。</translation>
        </message>
        <message>
            <source>The plant's points lie too far apart: %1 gaps between them were bridged. Do not use the leaves and internodes.</source>
            <translation>植株的点相距太远：连接了其间的 %1 处间隙。请勿使用叶和节间的数据。</translation>
        </message>
        <message>
            <source>%1 % of the plant's points are not connected with its stem: leaves may be missing, and the leaf area is a lower bound.</source>
            <translation>植株的点有 %1 % 与茎不相连：可能缺少叶片，叶面积为下限。</translation>
        </message>
        <message>
            <source>stem and leaves</source>
            <translation>茎和叶</translation>
        </message>
        <message>
            <source>leaves</source>
            <translation>叶片</translation>
        </message>
        <message>
            <source>matching views</source>
            <translation>匹配视图</translation>
        </message>
        <message>
            <source>No three views agree on a point. Views need texture, poses, and angles of 2 to 40 degrees between them.</source>
            <translation>没有三个视图在任何一点上一致。视图需要纹理、位姿以及彼此间 2 至 40 度的夹角。</translation>
        </message>
        <message>
            <source>the points have no fact '%1'</source>
            <translation>点没有附注“%1”</translation>
        </message>
        <message>
            <source>points of plant.separate</source>
            <translation>plant.separate 的点</translation>
        </message>
        <message>
            <source>connect the output 'points' of a stage plant.separate</source>
            <translation>请连接步骤 plant.separate 的输出“points”</translation>
        </message>
        <message>
            <source>the fact '%1' of the points is '%2'</source>
            <translation>点的附注“%1”为“%2”</translation>
        </message>
        <message>
            <source>the facts of the points give an up direction and a soil that do not fit</source>
            <translation>点的附注给出的朝上方向与土壤不符</translation>
        </message>
        <message>
            <source>directions of length 1, the soil roughly level</source>
            <translation>长度为 1 的方向，土壤大致水平</translation>
        </message>
        <message>
            <source>run plant.separate again</source>
            <translation>请重新运行 plant.separate</translation>
        </message>
        <message>
            <source>The plant begins %1 mm above the soil: the lower stem is missing in the cloud.</source>
            <translation>植株从土壤以上 %1 mm 处开始：点云缺少茎的下部。</translation>
        </message>
        <message>
            <source>%1 points of the plant, %2 floaters</source>
            <translation>植株 %1 个点，悬浮点 %2 个</translation>
        </message>
        <message>
            <source>the option %1 is '%2'</source>
            <translation>选项 %1 为“%2”</translation>
        </message>
        <message>
            <source>the option box is '%1'</source>
            <translation>选项 box 为“%1”</translation>
        </message>
        <message>
            <source>minimum before maximum on each axis</source>
            <translation>各轴上最小值在最大值之前</translation>
        </message>
        <message>
            <source>the cloud has %1 points in the box</source>
            <translation>点云在范围框内有 %1 个点</translation>
        </message>
        <message>
            <source>check the reconstruction, or the option box</source>
            <translation>请检查重建，或选项 box</translation>
        </message>
        <message>
            <source>all points of the cloud lie at one place</source>
            <translation>点云的所有点都在同一处</translation>
        </message>
        <message>
            <source>a plant</source>
            <translation>植株</translation>
        </message>
        <message>
            <source>The scale of the cloud is unknown: traits are in thousandths of its unit, not in millimetres. Use a board (mat.json), a depth camera, or set scale=metres.</source>
            <translation>点云的比例未知：性状以其单位的千分之一计，而不是毫米。请使用标定板（mat.json）、深度相机，或设置 scale=metres。</translation>
        </message>
        <message>
            <source>The scene is %1 m across, which no potted seedling is: check the unit.</source>
            <translation>场景宽达 %1 m，盆栽幼苗不会如此：请检查单位。</translation>
        </message>
        <message>
            <source>No table, mat or soil was found that shows which way is up: z is taken. Check it, or set up.</source>
            <translation>没有找到能表明哪个方向朝上的桌面、垫板或土壤：取 z 轴。请检查，或设置 up。</translation>
        </message>
        <message>
            <source>only %1 points stand above soil, pot and table</source>
            <translation>土壤、盆和桌面以上只有 %1 个点</translation>
        </message>
        <message>
            <source>check the reconstruction, up and box</source>
            <translation>请检查重建、up 和 box</translation>
        </message>
        <message>
            <source>The cloud has no stem near the soil: the middle of the pot is taken for its foot. Set base where that is wrong.</source>
            <translation>点云在土壤附近没有茎：以盆的中心为茎的基部。如果不对，请设置 base。</translation>
        </message>
        <message>
            <source>No round pot was found. Heights are counted from the level surface below the plant; check the soil, or set base.</source>
            <translation>没有找到圆形的盆。高度自植株下方的水平面起算；请检查土壤，或设置 base。</translation>
        </message>
        <message>
            <source>nothing stands above the table</source>
            <translation>桌面以上没有任何东西</translation>
        </message>
        <message>
            <source>No soil was found: heights are counted from the lowest point of the cloud.</source>
            <translation>没有找到土壤：高度自点云的最低点起算。</translation>
        </message>
        <message>
            <source>The soil in the pot was not found: heights are counted from the rim.</source>
            <translation>没有找到盆中的土壤：高度自盆沿起算。</translation>
        </message>
        <message>
            <source>comparing views</source>
            <translation>比较视图</translation>
        </message>
        <message>
            <source>%1 of %2 views have a pose</source>
            <translation>%2 个视图中有 %1 个带位姿</translation>
        </message>
        <message>
            <source>Connect the poses that belong to these views (their times must agree)</source>
            <translation>请连接属于这些视图的位姿（其时间须一致）</translation>
        </message>
        <message>
            <source>%1 of %2 views have no pose and are left out.</source>
            <translation>%2 个视图中有 %1 个没有位姿，已舍去。</translation>
        </message>
        <message>
            <source>the views look in one direction and have no depth</source>
            <translation>各视图朝同一方向，且没有深度</translation>
        </message>
        <message>
            <source>views from around the plant, or depth</source>
            <translation>环绕植株的视图，或深度</translation>
        </message>
        <message>
            <source>Give the region with the option 'region'</source>
            <translation>请用选项“region”给出区域</translation>
        </message>
        <message>
            <source>the region is '%1'</source>
            <translation>区域为“%1”</translation>
        </message>
        <message>
            <source>six numbers: min x, y, z, max x, y, z in metres, min below max</source>
            <translation>以米计的六个数：min x, y, z, max x, y, z，min 小于 max</translation>
        </message>
        <message>
            <source>no view has a depth above zero</source>
            <translation>没有视图含有大于零的深度</translation>
        </message>
        <message>
            <source>views with depth</source>
            <translation>含有深度的视图</translation>
        </message>
        <message>
            <source>Look at the depth images of the folder</source>
            <translation>请检查文件夹中的深度图像</translation>
        </message>
        <message>
            <source>Few places are seen by %1 % of the views: the region holds what %2 % see. Give the region with the option 'region' where it is wrong.</source>
            <translation>很少有地方被 %1 % 的视图看到：区域取 %2 % 的视图所见的范围。如果不对，请用选项“region”给出区域。</translation>
        </message>
        <message>
            <source>no place is seen by several of the %1 views</source>
            <translation>没有一处被 %1 个视图中的多个看到</translation>
        </message>
        <message>
            <source>views that look at one plant</source>
            <translation>朝向同一植株的视图</translation>
        </message>
        <message>
            <source>Check the poses, or give the region with the option 'region'</source>
            <translation>请检查位姿，或用选项“region”给出区域</translation>
        </message>
        <message>
            <source>the views have no depth</source>
            <translation>视图没有深度</translation>
        </message>
        <message>
            <source>views of an RGB-D camera</source>
            <translation>RGB-D 相机的视图</translation>
        </message>
        <message>
            <source>Use plant.field without a start, or plant.match_views</source>
            <translation>请使用 plant.field 而不给初始，或使用 plant.match_views</translation>
        </message>
        <message>
            <source>finding the surfaces</source>
            <translation>查找表面</translation>
        </message>
        <message>
            <source>no depth lies in the region</source>
            <translation>区域内没有深度</translation>
        </message>
        <message>
            <source>Voxels of %1 mm need more than %2 MiB: %3 mm were used. Give a smaller region, or more memory.</source>
            <translation>%1 mm 的体素需要超过 %2 MiB：采用 %3 mm。请给出更小的区域，或更多内存。</translation>
        </message>
        <message>
            <source>fusing depth</source>
            <translation>融合深度</translation>
        </message>
        <message>
            <source>the checkpoint %1 is damaged: %2</source>
            <translation>检查点 %1 已损坏：%2</translation>
        </message>
        <message>
            <source>a file that a training has written</source>
            <translation>训练写出的文件</translation>
        </message>
        <message>
            <source>Delete it to train from the start</source>
            <translation>请删除它以从头训练</translation>
        </message>
        <message>
            <source>the checkpoint %1 cannot be read</source>
            <translation>无法读取检查点 %1</translation>
        </message>
        <message>
            <source>its content has changed or is cut off</source>
            <translation>其内容已改变或被截断</translation>
        </message>
        <message>
            <source>it begins with something else</source>
            <translation>开头不是应有的内容</translation>
        </message>
        <message>
            <source>it has %1 bytes</source>
            <translation>有 %1 字节</translation>
        </message>
        <message>
            <source>the checkpoint %1 belongs to another training</source>
            <translation>检查点 %1 属于另一次训练</translation>
        </message>
        <message>
            <source>one with the same options, region, pictures and poses</source>
            <translation>选项、区域、图像和位姿都相同的训练</translation>
        </message>
        <message>
            <source>Delete it, or give this training a checkpoint of its own</source>
            <translation>请删除它，或为此训练指定单独的检查点</translation>
        </message>
        <message>
            <source>%1 bytes are left over</source>
            <translation>多余 %1 字节</translation>
        </message>
        <message>
            <source>all views are kept back</source>
            <translation>所有视图都被保留</translation>
        </message>
        <message>
            <source>views to learn from</source>
            <translation>用于学习的视图</translation>
        </message>
        <message>
            <source>Set hold_out to 0</source>
            <translation>请将 hold_out 设为 0</translation>
        </message>
        <message>
            <source>The training went on after step %1 of %2, from %3.</source>
            <translation>训练从 %2 步中的第 %1 步之后继续，取自 %3。</translation>
        </message>
        <message>
            <source>step %1, training %2 dB, held out %3 dB</source>
            <translation>第 %1 步，训练 %2 dB，保留视图 %3 dB</translation>
        </message>
        <message>
            <source>The training used up its %1 s after %2 of %3 steps. Raise max_seconds for a sharper field; a run that is ended by time is not repeated to the digit.</source>
            <translation>训练在 %3 步中的第 %2 步之后用完了 %1 s。要得到更清晰的辐射场，请增大 max_seconds；因时间而结束的运行不能逐位重复。</translation>
        </message>
        <message>
            <source>The field of step %1 shows the views kept back better than that of step %2, and was kept.</source>
            <translation>第 %1 步的辐射场比第 %2 步的更好地再现保留的视图，因此予以保留。</translation>
        </message>
        <message>
            <source>%1 steps, no views kept back</source>
            <translation>%1 步，没有保留的视图</translation>
        </message>
        <message>
            <source>No views were kept back, so nothing tells how good the field is.</source>
            <translation>没有保留视图，因此无法得知辐射场的好坏。</translation>
        </message>
        <message>
            <source>%1 steps, %2 dB on %3 views kept back</source>
            <translation>%1 步，在 %3 个保留的视图上为 %2 dB</translation>
        </message>
        <message>
            <source>Views kept back are shown with %1 dB only (28 or more is usual): sizes may be farther off than their intervals say. Train longer, or check the poses, the region, and whether the plant moved.</source>
            <translation>保留的视图只以 %1 dB 再现（通常为 28 或更高）：尺寸的偏差可能大于其区间。请延长训练，或检查位姿、区域以及植株是否移动过。</translation>
        </message>
        <message>
            <source>testing on the views kept back</source>
            <translation>用保留的视图检验</translation>
        </message>
        <message>
            <source>room for the plant in the pictures</source>
            <translation>植株在图像中的范围</translation>
        </message>
        <message>
            <source>outlines in the pictures</source>
            <translation>图像中的轮廓</translation>
        </message>
        <message>
            <source>The cloud has points beside the plant or lacks parts of it: height and breadth are those of the plant's outlines in the pictures. Clouds of depth alone are like this; plant.field makes better ones.</source>
            <translation>点云在植株旁有多余的点或缺少植株的一部分：高度和冠幅取自植株在图像中的轮廓。只由深度得到的点云就是这样；plant.field 能得到更好的点云。</translation>
        </message>
        <message>
            <source>The pictures show parts of the plant's colour that nothing in the cloud connects with it, above it: leaves that the cloud lacks, or something else. The intervals of height and breadth reach to them. plant.field makes clouds that have them.</source>
            <translation>图像在植株上方显示具有植株颜色的部分，但点云中没有与之相连的内容：点云缺少的叶片，或其他东西。高度和冠幅的区间包括这些部分。plant.field 得到的点云含有它们。</translation>
        </message>
        <message>
            <source>The pictures show parts of the plant's colour that nothing in the cloud connects with it, beside it: leaves that the cloud lacks, or something else. The intervals of height and breadth reach to them. plant.field makes clouds that have them.</source>
            <translation>图像在植株旁边显示具有植株颜色的部分，但点云中没有与之相连的内容：点云缺少的叶片，或其他东西。高度和冠幅的区间包括这些部分。plant.field 得到的点云含有它们。</translation>
        </message>
        <message>
            <source>The plant reaches the border of what was reconstructed, or of the pictures. Height and breadth are those of a part: the value is a lower bound. Too few views see the rest; take views that show all of the plant, or give a larger region to plant.field.</source>
            <translation>植株伸到重建范围或图像的边缘。高度和冠幅只是其一部分的：该值为下限。看到其余部分的视图太少；请拍摄能看到整株的视图，或为 plant.field 给出更大的区域。</translation>
        </message>
        <message>
            <source>The plant reaches the border of what was reconstructed, or of the pictures. The breadth is that of a part: the value is a lower bound. Too few views see the rest; take views that show all of the plant, or give a larger region to plant.field.</source>
            <translation>植株伸到重建范围或图像的边缘。冠幅只是其一部分的：该值为下限。看到其余部分的视图太少；请拍摄能看到整株的视图，或为 plant.field 给出更大的区域。</translation>
        </message>
        <message>
            <source>The plant reaches the border of what was reconstructed, or of the pictures. The height is that of a part: the value is a lower bound. Too few views see the rest; take views that show all of the plant, or give a larger region to plant.field.</source>
            <translation>植株伸到重建范围或图像的边缘。高度只是其一部分的：该值为下限。看到其余部分的视图太少；请拍摄能看到整株的视图，或为 plant.field 给出更大的区域。</translation>
        </message>
        <message>
            <source>stem contours</source>
            <translation>茎的轮廓</translation>
        </message>
        <message>
            <source>tips in the pictures</source>
            <translation>图像中的叶尖</translation>
        </message>
        <message>
            <source>the table of traits does not tell how it was measured</source>
            <translation>性状表没有说明是如何测得的</translation>
        </message>
        <message>
            <source>the output 'traits' of plant.traits</source>
            <translation>plant.traits 的输出“traits”</translation>
        </message>
        <message>
            <source>the fact 'plant_trait_options' is damaged</source>
            <translation>附注“plant_trait_options”已损坏</translation>
        </message>
        <message>
            <source>a JSON object</source>
            <translation>JSON 对象</translation>
        </message>
        <message>
            <source>not measured</source>
            <translation>未测</translation>
        </message>
        <message>
            <source>at least %1 mm</source>
            <translation>至少 %1 mm</translation>
        </message>
        <message>
            <source>%1 mm (%2 to %3)</source>
            <translation>%1 mm（%2 至 %3）</translation>
        </message>
        <message>
            <source>height %1, breadth %2 x %3, stem %4</source>
            <translation>高 %1，冠幅 %2 x %3，茎 %4</translation>
        </message>
        <message>
            <source>stem</source>
            <translation>茎</translation>
        </message>
        <message>
            <source>stem above the height of measurement</source>
            <translation>测量高度以上的茎</translation>
        </message>
        <message>
            <source>the points have no column 'part'</source>
            <translation>点没有列“part”</translation>
        </message>
        <message>
            <source>the cloud has %1 points of the plant</source>
            <translation>点云中植株有 %1 个点</translation>
        </message>
        <message>
            <source>at least 20</source>
            <translation>至少 20 个</translation>
        </message>
        <message>
            <source>look at the column 'part', and set up, box or base of plant.separate</source>
            <translation>请检查列“part”，并设置 plant.separate 的 up、box 或 base</translation>
        </message>
        <message>
            <source>The scale of the cloud is unknown: the columns in mm hold thousandths of its unit.</source>
            <translation>点云的比例未知：以 mm 为单位的各列是其单位的千分之一。</translation>
        </message>
        <message>
            <source>The cloud has no stem around the height of measurement: it is looked for in the pictures above its foot.</source>
            <translation>点云在测量高度附近没有茎：在图像中从基部向上查找。</translation>
        </message>
        <message>
            <source>no views or poses are connected</source>
            <translation>未连接视图或位姿</translation>
        </message>
        <message>
            <source>fewer than three views have a pose</source>
            <translation>有位姿的视图不足三个</translation>
        </message>
        <message>
            <source>the pictures show its edges in %1 views only</source>
            <translation>只有 %1 个视图的图像显示其边缘</translation>
        </message>
        <message>
            <source>The cloud's stem is much thinner than the pictures': look at the contours.</source>
            <translation>点云中的茎比图像中的细得多：请检查轮廓。</translation>
        </message>
        <message>
            <source>The diameter of the stem is unusual: look at the contours.</source>
            <translation>茎的直径异常：请检查轮廓。</translation>
        </message>
        <message>
            <source>The stem was not measured: the cloud has none at its height, and %1.</source>
            <translation>茎未测：点云在其高度处没有茎，且%1。</translation>
        </message>
        <message>
            <source>The stem was not measured: the cloud has none at its height, and contours were not asked for.</source>
            <translation>茎未测：点云在其高度处没有茎，且未要求用轮廓测量。</translation>
        </message>
        <message>
            <source>The stem was measured in the cloud, since %1. Clouds made of depth show thin stems too wide; the interval says by how much.</source>
            <translation>茎在点云中测量，因为%1。由深度得到的点云使细茎显得过粗；区间给出其程度。</translation>
        </message>
        <message>
            <source>The cloud has the plant in pieces, and no pictures tell what it lacks: the breadth is a lower bound.</source>
            <translation>植株在点云中断成几块，又没有图像说明缺少什么：冠幅为下限。</translation>
        </message>
        <message>
            <source>The depth images show no surface in the region: check the poses and the depth scale.</source>
            <translation>深度图像在区域内没有表面：请检查位姿和深度比例。</translation>
        </message>
        <message>
            <source>%1 surface points from %2 views</source>
            <translation>由 %2 个视图得到 %1 个表面点</translation>
        </message>
        <message>
            <source>No two views agree on a surface: check the poses, the region and the number of views.</source>
            <translation>没有两个视图在任何表面上一致：请检查位姿、区域和视图的数量。</translation>
        </message>
        <message>
            <source>%1 x %2 pixels</source>
            <translation>%1 x %2 像素</translation>
        </message>
        <message>
            <source>%1 points from %2 views</source>
            <translation>由 %2 个视图得到 %1 个点</translation>
        </message>
    </context>
    <context>
        <name>render</name>
        <message>
            <source>the table of growth has no tree</source>
            <translation>生长量表中没有树</translation>
        </message>
        <message>
            <source>one at least</source>
            <translation>至少一株</translation>
        </message>
        <message>
            <source>no tree was found again</source>
            <translation>没有再次找到任何树</translation>
        </message>
        <message>
            <source>a tree with both diameters</source>
            <translation>两次都有直径的树</translation>
        </message>
        <message>
            <source>a trajectory of %1 poses</source>
            <translation>有 %1 个位姿的轨迹</translation>
        </message>
        <message>
            <source>figure '%1' could not be drawn: %2</source>
            <translation>无法绘制图“%1”：%2</translation>
        </message>
        <message>
            <source>figure '%1' would have %2 x %3 pixels</source>
            <translation>图“%1”将有 %2 x %3 像素</translation>
        </message>
        <message>
            <source>at most %1 a side</source>
            <translation>每边至多 %1</translation>
        </message>
        <message>
            <source>Lower its resolution or width</source>
            <translation>请减小其分辨率或宽度</translation>
        </message>
        <message>
            <source>a PNG could not be written: %1</source>
            <translation>无法写出 PNG：%1</translation>
        </message>
        <message>
            <source>the check has no cell with a measure</source>
            <translation>检查没有含指标的单元</translation>
        </message>
        <message>
            <source>there is no run to draw</source>
            <translation>没有可绘制的运行</translation>
        </message>
        <message>
            <source>the trajectory of a run</source>
            <translation>运行的轨迹</translation>
        </message>
        <message>
            <source>there is no path to draw</source>
            <translation>没有可绘制的路径</translation>
        </message>
        <message>
            <source>the raster of %1 has no value in the plot</source>
            <translation>%1的栅格在样地中没有值</translation>
        </message>
        <message>
            <source>a terrain or canopy model</source>
            <translation>地形模型或冠层模型</translation>
        </message>
        <message>
            <source>there is no raster</source>
            <translation>没有栅格</translation>
        </message>
        <message>
            <source>a raster</source>
            <translation>栅格</translation>
        </message>
        <message>
            <source>this program is not linked with OSMesa</source>
            <translation>此程序没有链接 OSMesa</translation>
        </message>
        <message>
            <source>libOSMesa before libOpenGL among its libraries</source>
            <translation>其库中 libOSMesa 在 libOpenGL 之前</translation>
        </message>
        <message>
            <source>Use the bole program, or run this one under xvfb-run with the backend glx</source>
            <translation>请使用 bole 程序，或在 xvfb-run 下以绘图后端 glx 运行此程序</translation>
        </message>
        <message>
            <source>there is no drawing backend '%1'</source>
            <translation>没有绘图后端“%1”</translation>
        </message>
        <message>
            <source>auto, osmesa, egl or glx</source>
            <translation>auto、osmesa、egl 或 glx</translation>
        </message>
        <message>
            <source>VTK %1 has no EGL window</source>
            <translation>VTK %1 没有 EGL 窗口</translation>
        </message>
        <message>
            <source>VTK 9.4 or later</source>
            <translation>VTK 9.4 或更高版本</translation>
        </message>
        <message>
            <source>Use the backend osmesa</source>
            <translation>请使用绘图后端 osmesa</translation>
        </message>
        <message>
            <source>the environment variable DISPLAY is not set</source>
            <translation>没有设置环境变量 DISPLAY</translation>
        </message>
        <message>
            <source>an X display for the backend glx</source>
            <translation>绘图后端 glx 所需的 X 显示</translation>
        </message>
        <message>
            <source>Run it under xvfb-run, or use the bole program, which draws without a display</source>
            <translation>请在 xvfb-run 下运行，或使用无需显示即可绘图的 bole 程序</translation>
        </message>
        <message>
            <source>a step from the frame to the rows is not connected</source>
            <translation>从帧到行的某个步骤未连接</translation>
        </message>
        <message>
            <source>region, cleaned, clusters, trunk points, centres, plants and lines</source>
            <translation>区域、清理后的点、聚类、树干点、中心、植株和行线</translation>
        </message>
        <message>
            <source>there are %1 different views to fly through</source>
            <translation>可供飞越的不同视图有 %1 个</translation>
        </message>
        <message>
            <source>two or more</source>
            <translation>两个或更多</translation>
        </message>
        <message>
            <source>Bookmark more views (Ctrl+B)</source>
            <translation>请将更多视图加为书签 (Ctrl+B)</translation>
        </message>
        <message>
            <source>the walk is %1 m long</source>
            <translation>行走路径长 %1 m</translation>
        </message>
        <message>
            <source>a walk of a metre or more</source>
            <translation>一米或更长的行走路径</translation>
        </message>
        <message>
            <source>there are no points to fly through</source>
            <translation>没有可供飞越的点</translation>
        </message>
        <message>
            <source>the map has no points</source>
            <translation>地图没有点</translation>
        </message>
        <message>
            <source>no point of the map lies in the window that is drawn</source>
            <translation>绘制的窗口内没有地图的点</translation>
        </message>
        <message>
            <source>points around the plot or the stems</source>
            <translation>样地或单木周围的点</translation>
        </message>
        <message>
            <source>no point lies below the height of the cut</source>
            <translation>剖切高度以下没有点</translation>
        </message>
        <message>
            <source>a higher cut</source>
            <translation>更高的剖切高度</translation>
        </message>
        <message>
            <source>%1 is of the kind %2</source>
            <translation>%1的类型为 %2</translation>
        </message>
        <message>
            <source>point, distance, angle or ring</source>
            <translation>point、distance、angle 或 ring</translation>
        </message>
        <message>
            <source>%1 holds %2</source>
            <translation>%1含有 %2</translation>
        </message>
        <message>
            <source>an object with "kind" and "points"</source>
            <translation>含有 "kind" 和 "points" 的对象</translation>
        </message>
        <message>
            <source>%1 has %2 points</source>
            <translation>%1有 %2 个点</translation>
        </message>
        <message>
            <source>%1 for the kind %2</source>
            <translation>%1 个，类型为 %2 时</translation>
        </message>
        <message>
            <source>%1 has a point %2</source>
            <translation>%1有一个点 %2</translation>
        </message>
        <message>
            <source>the measurements are no JSON object with a list</source>
            <translation>量测不是含有列表的 JSON 对象</translation>
        </message>
        <message>
            <source>{"measurements": [...]}</source>
            <translation>对象 {"measurements": [...]}</translation>
        </message>
        <message>
            <source>%1 measurements</source>
            <translation>%1 个量测</translation>
        </message>
        <message>
            <source>measurement %1</source>
            <translation>量测 %1</translation>
        </message>
        <message>
            <source>sorting points for display</source>
            <translation>为显示整理点</translation>
        </message>
        <message>
            <source>a cloud of %1 points</source>
            <translation>有 %1 个点的点云</translation>
        </message>
        <message>
            <source>at most 4 294 967 294</source>
            <translation>至多 4 294 967 294 个</translation>
        </message>
        <message>
            <source>Thin it</source>
            <translation>请抽稀</translation>
        </message>
        <message>
            <source>depth images of two sizes are compared</source>
            <translation>比较的深度图像尺寸不同</translation>
        </message>
        <message>
            <source>the views are no JSON list</source>
            <translation>视图不是 JSON 列表</translation>
        </message>
        <message>
            <source>a list of views, as the window writes it</source>
            <translation>窗口写出的视图列表</translation>
        </message>
        <message>
            <source>the views cannot be read: %1</source>
            <translation>无法读取视图：%1</translation>
        </message>
        <message>
            <source>Bookmark the views again</source>
            <translation>请重新将视图加为书签</translation>
        </message>
    </context>
    <context>
        <name>report</name>
        <message>
            <source>position errors</source>
            <translation>位置误差图</translation>
        </message>
        <message>
            <source>diameters</source>
            <translation>直径图</translation>
        </message>
        <message>
            <source>diameter errors</source>
            <translation>直径误差图</translation>
        </message>
        <message>
            <source>positions</source>
            <translation>位置图</translation>
        </message>
        <message>
            <source>paths on the cloud</source>
            <translation>点云上的路径图</translation>
        </message>
        <message>
            <source>slices</source>
            <translation>横切面图</translation>
        </message>
        <message>
            <source>loop closures</source>
            <translation>回环</translation>
        </message>
        <message>
            <source>, read report.html first</source>
            <translation>，请先阅读 report.html</translation>
        </message>
        <message>
            <source>asked to finish early: figures are left out</source>
            <translation>应要求提前结束：不绘制图</translation>
        </message>
        <message>
            <source>draw %1</source>
            <translation>绘制%1</translation>
        </message>
        <message>
            <source>the plot values have no measure '%1'</source>
            <translation>样地数值中没有指标“%1”</translation>
        </message>
        <message>
            <source>the table of inventory.plot_values</source>
            <translation>inventory.plot_values 的表</translation>
        </message>
        <message>
            <source>Connect plot_values of that stage to the report</source>
            <translation>请将该步骤的 plot_values 连接到报告</translation>
        </message>
        <message>
            <source>the views of %1 cannot be read</source>
            <translation>无法读取 %1 中的视图</translation>
        </message>
        <message>
            <source>a file of bookmarks, such as plot.views.json</source>
            <translation>书签视图的文件，例如 plot.views.json</translation>
        </message>
        <message>
            <source>there is no folder for the frames</source>
            <translation>没有存放各帧的文件夹</translation>
        </message>
        <message>
            <source>Give it with --out DIR</source>
            <translation>请用 --out DIR 指定</translation>
        </message>
        <message>
            <source>beside_color is '%1'</source>
            <translation>beside_color 为 '%1'</translation>
        </message>
        <message>
            <source>%1 or a colour such as #d98e04</source>
            <translation>%1，或一种颜色，例如 #d98e04</translation>
        </message>
        <message>
            <source>Bring it into the axes of the survey: align it in the window and save it</source>
            <translation>请先在窗口中将其对齐到测量的坐标轴并保存</translation>
        </message>
        <message>
            <source>clouds in the same axes</source>
            <translation>坐标轴相同的点云</translation>
        </message>
        <message>
            <source>the points lie %1 km from the %2</source>
            <translation>点距“%2”%1 km</translation>
        </message>
        <message>
            <source>files in the same axes</source>
            <translation>坐标轴相同的文件</translation>
        </message>
        <message>
            <source>Give the cloud that was written with them</source>
            <translation>请给出与它们一同写出的点云</translation>
        </message>
        <message>
            <source>views</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>the survey has no place on the earth for the map %1</source>
            <translation>测量没有地理位置，无法使用地图 %1</translation>
        </message>
        <message>
            <source>a georeferenced survey</source>
            <translation>已定位的测量</translation>
        </message>
        <message>
            <source>Give its plot control points (survey.georeference), or leave the map out</source>
            <translation>请为样地给出控制点（survey.georeference），或不使用地图</translation>
        </message>
        <message>
            <source>the map names no coordinate system and was taken to have that of the survey</source>
            <translation>地图没有注明坐标系，按测量的坐标系处理</translation>
        </message>
        <message>
            <source>the points have no heights above ground: the terrain is not drawn</source>
            <translation>点没有离地高度：不绘制地形</translation>
        </message>
        <message>
            <source>the points have no heights above ground: the map is flat</source>
            <translation>点没有离地高度：地图为平面</translation>
        </message>
        <message>
            <source>the cloud beside the survey lies %1 km away</source>
            <translation>旁置点云距测量 %1 km</translation>
        </message>
        <message>
            <source>the points were moved with a walk that was made %1 % longer, and the slice was not: stems that are added lie off by %2 cm in 10 m. Connect the slice of stems.measure</source>
            <translation>点已随加长 %1 % 的行走路径移动，而切片没有：添加的单木每 10 m 偏差 %2 cm。请连接 stems.measure 的切片</translation>
        </message>
        <message>
            <source>there is no walk to fly along</source>
            <translation>没有可沿其飞行的行走路径</translation>
        </message>
        <message>
            <source>Set course=views and give a file of bookmarked views</source>
            <translation>请设置 course=views 并给出书签视图的文件</translation>
        </message>
        <message>
            <source>points</source>
            <translation>点</translation>
        </message>
        <message>
            <source>frame %1 of %2</source>
            <translation>%2 帧中的第 %1 帧</translation>
        </message>
        <message>
            <source>%1 frames of %2 x %3 pixels</source>
            <translation>%1 帧，%2 x %3 像素</translation>
        </message>
        <message>
            <source>there is no video: ffmpeg is not in PATH. Install it, or make the video from flythrough/ elsewhere</source>
            <translation>没有视频：PATH 中没有 ffmpeg。请安装它，或在别处由 flythrough/ 制作视频</translation>
        </message>
        <message>
            <source>video</source>
            <translation>视频</translation>
        </message>
        <message>
            <source>ffmpeg cannot be started (%1)</source>
            <translation>无法启动 ffmpeg（%1）</translation>
        </message>
        <message>
            <source>a program that runs</source>
            <translation>可以运行的程序</translation>
        </message>
        <message>
            <source>ffmpeg wrote no video: %1</source>
            <translation>ffmpeg 没有写出视频：%1</translation>
        </message>
        <message>
            <source>an ffmpeg with libx264</source>
            <translation>带 libx264 的 ffmpeg</translation>
        </message>
        <message>
            <source>The frames are in %1</source>
            <translation>各帧在 %1 中</translation>
        </message>
        <message>
            <source>report</source>
            <translation>报告</translation>
        </message>
        <message>
            <source>write %1</source>
            <translation>写出%1</translation>
        </message>
        <message>
            <source>the 3-D maps could not be drawn: %1</source>
            <translation>无法绘制三维地图：%1</translation>
        </message>
        <message>
            <source>report.plant has no input</source>
            <translation>report.plant 没有输入</translation>
        </message>
        <message>
            <source>at least the traits or the points</source>
            <translation>至少有性状或点</translation>
        </message>
        <message>
            <source>no point was found to be of the plant: cloud.ply has all points</source>
            <translation>没有点被判为植株：cloud.ply 含全部点</translation>
        </message>
        <message>
            <source>plant</source>
            <translation>植株</translation>
        </message>
        <message>
            <source>stem in depth</source>
            <translation>深度中的茎</translation>
        </message>
        <message>
            <source>matches</source>
            <translation>匹配</translation>
        </message>
        <message>
            <source>held-out views</source>
            <translation>保留的视图</translation>
        </message>
        <message>
            <source>making of the field</source>
            <translation>辐射场的生成过程</translation>
        </message>
        <message>
            <source>there is no folder to write the report into</source>
            <translation>没有可写出报告的文件夹</translation>
        </message>
        <message>
            <source>%1 could not be written: %2</source>
            <translation>无法写出%1：%2</translation>
        </message>
        <message>
            <source>, no GeoJSON: the place on the earth is not known</source>
            <translation>，没有 GeoJSON：在地球上的位置未知</translation>
        </message>
        <message>
            <source>%1 files%2</source>
            <translation>%1 个文件%2</translation>
        </message>
        <message>
            <source>the map</source>
            <translation>地图</translation>
        </message>
        <message>
            <source>the growth</source>
            <translation>生长量</translation>
        </message>
        <message>
            <source>curves</source>
            <translation>曲线</translation>
        </message>
        <message>
            <source>error curves</source>
            <translation>误差曲线</translation>
        </message>
        <message>
            <source>report.steering has no input</source>
            <translation>report.steering 没有输入</translation>
        </message>
        <message>
            <source>at least one of summary, passes, errors, log, parameters, steps, lines</source>
            <translation>summary、passes、errors、log、parameters、steps、lines 中的至少一个</translation>
        </message>
        <message>
            <source>map by height</source>
            <translation>按高度着色的地图</translation>
        </message>
        <message>
            <source>map by tree</source>
            <translation>按单木着色的地图</translation>
        </message>
        <message>
            <source>map by intensity</source>
            <translation>按强度着色的地图</translation>
        </message>
        <message>
            <source>map from above</source>
            <translation>俯视地图</translation>
        </message>
        <message>
            <source>hero</source>
            <translation>标题图</translation>
        </message>
        <message>
            <source>heights over diameters</source>
            <translation>树高-直径图</translation>
        </message>
        <message>
            <source>taper</source>
            <translation>尖削度图</translation>
        </message>
        <message>
            <source>terrain</source>
            <translation>地形图</translation>
        </message>
        <message>
            <source>canopy height</source>
            <translation>冠层高度图</translation>
        </message>
        <message>
            <source>stem map</source>
            <translation>单木分布图</translation>
        </message>
        <message>
            <source>diameter distribution</source>
            <translation>径阶分布图</translation>
        </message>
        <message>
            <source>check of the map</source>
            <translation>地图检查图</translation>
        </message>
        <message>
            <source>estimated against reference diameter</source>
            <translation>估计直径与参照直径对比图</translation>
        </message>
        <message>
            <source>walk</source>
            <translation>行走路径图</translation>
        </message>
        <message>
            <source>walk and reference</source>
            <translation>行走路径与参照图</translation>
        </message>
        <message>
            <source>errors of the walk</source>
            <translation>行走路径误差图</translation>
        </message>
        <message>
            <source>breast-height slices</source>
            <translation>胸高横切面图</translation>
        </message>
        <message>
            <source>cannot begin the workbook %1</source>
            <translation>无法建立工作簿 %1</translation>
        </message>
        <message>
            <source>cannot write the workbook: %1</source>
            <translation>无法写出工作簿：%1</translation>
        </message>
        <message>
            <source>cannot add the sheet %1</source>
            <translation>无法添加工作表 %1</translation>
        </message>
    </context>
    <context>
        <name>rgbd</name>
        <message>
            <source>first square black, markers counted from the lower row</source>
            <translation>首格为黑色，标志从下行起编号</translation>
        </message>
        <message>
            <source>first square black, markers counted from the upper row</source>
            <translation>首格为黑色，标志从上行起编号</translation>
        </message>
        <message>
            <source>first square white, markers counted from the lower row</source>
            <translation>首格为白色，标志从下行起编号</translation>
        </message>
        <message>
            <source>first square white, markers counted from the upper row</source>
            <translation>首格为白色，标志从上行起编号</translation>
        </message>
        <message>
            <source>the board's dictionary is '%1'</source>
            <translation>标定板的字典为“%1”</translation>
        </message>
        <message>
            <source>the board has %1 x %2 squares of %3 m with markers of %4 m</source>
            <translation>标定板有 %1 x %2 个方格，方格 %3 m，标志 %4 m</translation>
        </message>
        <message>
            <source>2 to 1000 squares in each direction</source>
            <translation>每个方向 2 至 1000 个方格</translation>
        </message>
        <message>
            <source>Correct mat.json.</source>
            <translation>请更正 mat.json。</translation>
        </message>
        <message>
            <source>markers smaller than their squares</source>
            <translation>标志小于其方格</translation>
        </message>
        <message>
            <source>Correct square_mm and marker_mm in mat.json.</source>
            <translation>请更正 mat.json 中的 square_mm 和 marker_mm。</translation>
        </message>
        <message>
            <source>the views have no board (mat.json)</source>
            <translation>视图没有标定板（mat.json）</translation>
        </message>
        <message>
            <source>the board that they show</source>
            <translation>视图所示的标定板</translation>
        </message>
        <message>
            <source>Set board=chessboard or board=charuco with columns, rows and square, or write mat.json</source>
            <translation>请设置 board=chessboard 或 board=charuco 以及 columns、rows 和 square，或编写 mat.json</translation>
        </message>
        <message>
            <source>a chessboard of %1 x %2 squares is too small</source>
            <translation>%1 x %2 个方格的棋盘格太小</translation>
        </message>
        <message>
            <source>4 x 4 squares or more</source>
            <translation>4 x 4 个方格或更多</translation>
        </message>
        <message>
            <source>looking for the board</source>
            <translation>查找标定板</translation>
        </message>
        <message>
            <source>the corners have no column 'view'</source>
            <translation>角点没有列“view”</translation>
        </message>
        <message>
            <source>view, x_px, y_px, board_x_m, board_y_m</source>
            <translation>view、x_px、y_px、board_x_m、board_y_m 各列</translation>
        </message>
        <message>
            <source>row %1 of the corners has a missing number</source>
            <translation>角点的第 %1 行缺少一个数</translation>
        </message>
        <message>
            <source>four numbers</source>
            <translation>四个数</translation>
        </message>
        <message>
            <source>there are no views</source>
            <translation>没有视图</translation>
        </message>
        <message>
            <source>pictures of a board</source>
            <translation>标定板的图像</translation>
        </message>
        <message>
            <source>neither views nor corners are connected</source>
            <translation>视图和角点都未连接</translation>
        </message>
        <message>
            <source>pictures of a board, or a table of its corners</source>
            <translation>标定板的图像，或其角点的表</translation>
        </message>
        <message>
            <source>the size of the images is not given</source>
            <translation>没有给出图像的尺寸</translation>
        </message>
        <message>
            <source>the options width and height, in pixels</source>
            <translation>以像素计的选项 width 和 height</translation>
        </message>
        <message>
            <source>depth camera: %1</source>
            <translation>深度相机：%1</translation>
        </message>
        <message>
            <source>%1 pairs of views give the depth camera another place and are left out</source>
            <translation>%1 对视图给出的深度相机位置不同，已舍去</translation>
        </message>
        <message>
            <source>%1 of %2 views, residual %3 px</source>
            <translation>%2 个视图中的 %1 个，残差 %3 px</translation>
        </message>
        <message>
            <source>marker is %1 m and square %2 m</source>
            <translation>marker 为 %1 m，square 为 %2 m</translation>
        </message>
        <message>
            <source>markers smaller than the squares</source>
            <translation>标志小于方格</translation>
        </message>
        <message>
            <source>reading the depth of the boards</source>
            <translation>读取标定板的深度</translation>
        </message>
        <message>
            <source>%1 views have depth on the board; %2 are needed: the depth is left as it is</source>
            <translation>%1 个视图在标定板上有深度；需要 %2 个：深度保持不变</translation>
        </message>
        <message>
            <source>the boards leave the place of the depth camera open (standard deviation %1 mm): the depth stays as given. Tilt the boards more</source>
            <translation>标定板不能确定深度相机的位置（标准差 %1 mm）：深度保持给定值。请使标定板更加倾斜</translation>
        </message>
        <message>
            <source>%1 views of the board were taken by both cameras</source>
            <translation>两台相机都拍到标定板的视图有 %1 个</translation>
        </message>
        <message>
            <source>%1 at least, at the same times</source>
            <translation>至少 %1 个，时间相同</translation>
        </message>
        <message>
            <source>the corners of %1 views fit no camera (%2)</source>
            <translation>%1 个视图的角点与任何相机都不符（%2）</translation>
        </message>
        <message>
            <source>views of one flat board, tilted in several directions</source>
            <translation>同一平面标定板向多个方向倾斜的视图</translation>
        </message>
        <message>
            <source>%1 of %2 views show the board</source>
            <translation>%2 个视图中有 %1 个拍到标定板</translation>
        </message>
        <message>
            <source>%1 views at least, better 20</source>
            <translation>至少 %1 个视图，最好 20 个</translation>
        </message>
        <message>
            <source>Check the size of the board (columns and rows count squares), or take more pictures</source>
            <translation>请检查标定板的尺寸（columns 和 rows 为方格数），或拍摄更多图像</translation>
        </message>
        <message>
            <source>the boards of all %1 views are parallel to within %2 deg</source>
            <translation>全部 %1 个视图的标定板在 %2 度以内互相平行</translation>
        </message>
        <message>
            <source>boards that are tilted by 20 deg and more, in several directions</source>
            <translation>标定板向多个方向倾斜 20 度或更多</translation>
        </message>
        <message>
            <source>the views leave the focal length open by %1 % (standard deviation)</source>
            <translation>视图使焦距的不确定度达 %1 %（标准差）</translation>
        </message>
        <message>
            <source>boards that are tilted more, and nearer</source>
            <translation>标定板倾斜更大、更近</translation>
        </message>
        <message>
            <source>Take 20 views, near and far, in all corners</source>
            <translation>请拍摄 20 个视图，远近都有，遍及图像各角</translation>
        </message>
        <message>
            <source>the views give a distortion that folds the image</source>
            <translation>视图得出的畸变使图像折叠</translation>
        </message>
        <message>
            <source>corners in all parts of the image</source>
            <translation>遍及图像各部分的角点</translation>
        </message>
        <message>
            <source>Set distortion=k1_k2, or take views with the board in the corners of the image</source>
            <translation>请设置 distortion=k1_k2，或拍摄标定板位于图像各角的视图</translation>
        </message>
        <message>
            <source>%1 views do not fit the others and are left out: %2</source>
            <translation>%1 个视图与其余不符，已舍去：%2</translation>
        </message>
        <message>
            <source>%1 views were used; 20 make a good calibration</source>
            <translation>使用了 %1 个视图；20 个才能得到好的标定</translation>
        </message>
        <message>
            <source>corners lie in %1 % of the image: the distortion of the rest is not measured</source>
            <translation>角点只分布在图像的 %1 % 内：其余部分的畸变未测</translation>
        </message>
        <message>
            <source>corners lie %1 px from their places: is the board flat, and sharp?</source>
            <translation>角点偏离其位置 %1 px：标定板平整、清晰吗？</translation>
        </message>
        <message>
            <source>fitting the camera</source>
            <translation>拟合相机</translation>
        </message>
        <message>
            <source>a depth image is %1 x %2 pixels, its camera %3 x %4</source>
            <translation>深度图像为 %1 x %2 像素，其相机为 %3 x %4</translation>
        </message>
        <message>
            <source>one size</source>
            <translation>相同的尺寸</translation>
        </message>
        <message>
            <source>Give the depth camera (depth, depth_to_color), or depth registered to colour.</source>
            <translation>请给出深度相机（depth、depth_to_color），或与彩色配准的深度。</translation>
        </message>
        <message>
            <source>an image has %1 channels</source>
            <translation>图像有 %1 个通道</translation>
        </message>
        <message>
            <source>1 or 3</source>
            <translation>1 或 3 个</translation>
        </message>
        <message>
            <source>features of two kinds are compared</source>
            <translation>比较的特征种类不同</translation>
        </message>
        <message>
            <source>one kind</source>
            <translation>同一种类</translation>
        </message>
        <message>
            <source>bundle adjustment</source>
            <translation>光束法平差</translation>
        </message>
        <message>
            <source>Check the folder of the views.</source>
            <translation>请检查视图的文件夹。</translation>
        </message>
        <message>
            <source>there are %1 views</source>
            <translation>有 %1 个视图</translation>
        </message>
        <message>
            <source>Read every n-th view, or a part of them (options every and max_views of io.read_views).</source>
            <translation>请每隔若干视图读取一个，或只读取一部分（io.read_views 的选项 every 和 max_views）。</translation>
        </message>
        <message>
            <source>measured depth is %1 times what the board says</source>
            <translation>测得的深度是标定板所示的 %1 倍</translation>
        </message>
        <message>
            <source>depth and board of one size</source>
            <translation>尺寸一致的深度和标定板</translation>
        </message>
        <message>
            <source>Correct depth_scale (units per metre) in camera.json, or square_mm in mat.json.</source>
            <translation>请更正 camera.json 中的 depth_scale（每米的单位数），或 mat.json 中的 square_mm。</translation>
        </message>
        <message>
            <source>measured depth is %1 times what the board says; the scale of the board is used. Check depth_scale in camera.json and square_mm in mat.json</source>
            <translation>测得的深度是标定板所示的 %1 倍；采用标定板的比例。请检查 camera.json 中的 depth_scale 和 mat.json 中的 square_mm</translation>
        </message>
        <message>
            <source>there is one view and no board in it</source>
            <translation>只有一个视图，且其中没有标定板</translation>
        </message>
        <message>
            <source>at least 2 views, or a board that fixes the pose</source>
            <translation>至少 2 个视图，或能确定位姿的标定板</translation>
        </message>
        <message>
            <source>Give a folder with all views.</source>
            <translation>请给出含有全部视图的文件夹。</translation>
        </message>
        <message>
            <source>no feature of any view has depth</source>
            <translation>没有视图的特征带有深度</translation>
        </message>
        <message>
            <source>the views have no depth and no board</source>
            <translation>视图既没有深度也没有标定板</translation>
        </message>
        <message>
            <source>depth images, or a ChArUco board in the views</source>
            <translation>深度图像，或视图中的 ChArUco 标定板</translation>
        </message>
        <message>
            <source>Check the depth images and depth_scale, or give poses and source=given. Poses without scale: allow_unscaled=true.</source>
            <translation>请检查深度图像和 depth_scale，或给出位姿并设置 source=given。不带比例的位姿：allow_unscaled=true。</translation>
        </message>
        <message>
            <source>no two of the views show the same thing</source>
            <translation>没有两个视图拍到同样的内容</translation>
        </message>
        <message>
            <source>at least %1 matches between two views</source>
            <translation>两个视图之间至少 %1 个匹配</translation>
        </message>
        <message>
            <source>Take views that overlap by half or more, with texture in them.</source>
            <translation>请拍摄重叠一半或更多、且有纹理的视图。</translation>
        </message>
        <message>
            <source>the bundle adjustment found no solution, and the first poses are kept: %1</source>
            <translation>光束法平差没有解，保留最初的位姿：%1</translation>
        </message>
        <message>
            <source>the views have neither depth nor a board: lengths are in units of the median distance of the points, not in metres</source>
            <translation>视图既没有深度也没有标定板：长度以点的中位距离为单位，而不是米</translation>
        </message>
        <message>
            <source>the views came without poses</source>
            <translation>视图没有附带位姿</translation>
        </message>
        <message>
            <source>a trajectory, or source=slam</source>
            <translation>轨迹，或 source=slam</translation>
        </message>
        <message>
            <source>Set source=slam, or put poses.tum beside the views.</source>
            <translation>请设置 source=slam，或将 poses.tum 放在视图旁。</translation>
        </message>
        <message>
            <source>the given pose of view %1 (%2) is no rigid motion</source>
            <translation>视图 %1（%2）的给定位姿不是刚体运动</translation>
        </message>
        <message>
            <source>an orthonormal rotation with determinant +1 and a finite place</source>
            <translation>行列式为 +1 的正交旋转和有限的位置</translation>
        </message>
        <message>
            <source>Correct the file of poses, or set source=slam.</source>
            <translation>请更正位姿文件，或设置 source=slam。</translation>
        </message>
        <message>
            <source>none of the given poses has the time of a view</source>
            <translation>给定的位姿都没有与任何视图相同的时间</translation>
        </message>
        <message>
            <source>times that agree to a microsecond</source>
            <translation>相差不超过一微秒的时间</translation>
        </message>
        <message>
            <source>Correct the times in the file of poses, or set source=slam.</source>
            <translation>请更正位姿文件中的时间，或设置 source=slam。</translation>
        </message>
        <message>
            <source>the given poses could not be checked: the views have too few matches with depth</source>
            <translation>无法检查给定的位姿：视图之间带深度的匹配太少</translation>
        </message>
        <message>
            <source>, with their lengths times %1</source>
            <translation>，其长度乘以 %1</translation>
        </message>
        <message>
            <source>; they would fit with a median of %1 px %2</source>
            <translation>；采用%2时中位数为 %1 px，才相符</translation>
        </message>
        <message>
            <source>the given poses do not agree with the images: matches lie a median of %1 px from where the poses and the depth put them%2. Check the poses, the camera and the depth scale, or set source=slam</source>
            <translation>给定的位姿与图像不一致：匹配点偏离位姿和深度所定位置的中位数为 %1 px%2。请检查位姿、相机和深度比例，或设置 source=slam</translation>
        </message>
        <message>
            <source>distances between the given poses are %1 times what the board says. Check the unit of the poses and square_mm in mat.json</source>
            <translation>给定位姿之间的距离是标定板所示的 %1 倍。请检查位姿的单位和 mat.json 中的 square_mm</translation>
        </message>
        <message>
            <source>adding views</source>
            <translation>加入视图</translation>
        </message>
        <message>
            <source>matching neighbours</source>
            <translation>匹配相邻视图</translation>
        </message>
        <message>
            <source>matching views that look alike</source>
            <translation>匹配相似的视图</translation>
        </message>
        <message>
            <source>matching loops</source>
            <translation>匹配回环</translation>
        </message>
        <message>
            <source>a part of the images moves and the object does not; what moves is left out where it disagrees</source>
            <translation>图像的一部分在移动而目标不动；移动的部分在不一致处已舍去</translation>
        </message>
        <message>
            <source>matching without the still background</source>
            <translation>去除静止背景后匹配</translation>
        </message>
        <message>
            <source>axes and scale of the board</source>
            <translation>坐标轴和比例取自标定板</translation>
        </message>
        <message>
            <source>axes of the given poses</source>
            <translation>坐标轴取自给定的位姿</translation>
        </message>
        <message>
            <source>axes of the first view, scale of the depth</source>
            <translation>坐标轴取自第一个视图，比例取自深度</translation>
        </message>
        <message>
            <source>axes of the first view, without scale</source>
            <translation>坐标轴取自第一个视图，没有比例</translation>
        </message>
        <message>
            <source>no pose is given for %1 of %2 views, which are left out: %3</source>
            <translation>%2 个视图中有 %1 个没有给定位姿，已舍去：%3</translation>
        </message>
        <message>
            <source>tracking lost at %1 of %2 views: %3. The largest connected part is kept</source>
            <translation>%2 个视图中有 %1 个跟踪丢失：%3。保留最大的连通部分</translation>
        </message>
        <message>
            <source>%1 of %2 views have a given pose; %3</source>
            <translation>%2 个视图中有 %1 个带给定位姿；%3</translation>
        </message>
        <message>
            <source>%1 of %2 views tracked; %3</source>
            <translation>跟踪了 %2 个视图中的 %1 个；%3</translation>
        </message>
        <message>
            <source>the image of view %1 (%2) is %3 x %4 pixels, its camera %5 x %6</source>
            <translation>视图 %1（%2）的图像为 %3 x %4 像素，其相机为 %5 x %6</translation>
        </message>
        <message>
            <source>Correct width and height of the camera.</source>
            <translation>请更正相机的 width 和 height。</translation>
        </message>
        <message>
            <source>the views should show a board, but it was found in none of them; check dictionary, squares and marker size in mat.json</source>
            <translation>视图应拍到标定板，但没有一个视图中找到它；请检查 mat.json 中的字典、方格数和标志尺寸</translation>
        </message>
        <message>
            <source>the print has its %1, not as mat.json says; the print is followed</source>
            <translation>打印的标定板%1，与 mat.json 所述不同；以打印的为准</translation>
        </message>
        <message>
            <source>the board is a chessboard without markers, which has no place of its own where a part is hidden; it is not used</source>
            <translation>标定板是没有标志的棋盘格，部分被遮挡时位置不唯一；未采用</translation>
        </message>
        <message>
            <source>finding features</source>
            <translation>提取特征</translation>
        </message>
        <message>
            <source>no view has any feature: the images are black or without texture</source>
            <translation>没有视图含有任何特征：图像全黑或没有纹理</translation>
        </message>
        <message>
            <source>views with texture</source>
            <translation>有纹理的视图</translation>
        </message>
        <message>
            <source>Check the images, the exposure and the lamp.</source>
            <translation>请检查图像、曝光和灯光。</translation>
        </message>
        <message>
            <source> and %1 more</source>
            <translation> 及另外 %1 个</translation>
        </message>
    </context>
    <context>
        <name>rows</name>
        <message>
            <source>edit %1 (%2)%3</source>
            <translation>第 %1 项编辑（%2）%3</translation>
        </message>
        <message>
            <source> is not applied: %1</source>
            <translation>未应用：%1</translation>
        </message>
        <message>
            <source>no edits</source>
            <translation>没有编辑</translation>
        </message>
        <message>
            <source>no row within %1 m of (%2, %3)</source>
            <translation>(%2, %3) 周围 %1 m 内没有行</translation>
        </message>
        <message>
            <source>no row within %1 m of (%2, %3), the nearest passes %4 m away</source>
            <translation>(%2, %3) 周围 %1 m 内没有行，最近的行在 %4 m 处经过</translation>
        </message>
        <message>
            <source>rows %1 and %2 both pass near (%3, %4)</source>
            <translation>第 %1 行与第 %2 行都从 (%3, %4) 附近经过</translation>
        </message>
        <message>
            <source>there is a row %1 already</source>
            <translation>已有第 %1 行</translation>
        </message>
        <message>
            <source>the row ran at %1 deg and now runs at %2 deg</source>
            <translation>该行原方向为 %1 度，现为 %2 度</translation>
        </message>
        <message>
            <source>all plants of row %1 stand on one side of the cut</source>
            <translation>第 %1 行的所有植株都在切口的同一侧</translation>
        </message>
        <message>
            <source>the cut lies beyond the ends of row %1</source>
            <translation>切口在第 %1 行的两端之外</translation>
        </message>
        <message>
            <source>row %1 is named twice</source>
            <translation>第 %1 行出现了两次</translation>
        </message>
        <message>
            <source>renumber</source>
            <translation>重新编号</translation>
        </message>
        <message>
            <source>%1 has both ends at one place</source>
            <translation>%1 的两端在同一位置</translation>
        </message>
        <message>
            <source>two ends that are apart</source>
            <translation>分开的两端</translation>
        </message>
        <message>
            <source>row_id is empty</source>
            <translation>row_id 为空</translation>
        </message>
        <message>
            <source>the new id</source>
            <translation>新的编号</translation>
        </message>
        <message>
            <source>attitude %1 has no number or a time that does not increase</source>
            <translation>第 %1 个姿态没有数值，或其时间不递增</translation>
        </message>
        <message>
            <source>time_s in increasing order, roll_deg, pitch_deg, yaw_deg</source>
            <translation>递增的 time_s，以及 roll_deg、pitch_deg、yaw_deg</translation>
        </message>
        <message>
            <source>the attitude table is empty</source>
            <translation>姿态表为空</translation>
        </message>
        <message>
            <source>time_s, roll_deg, pitch_deg, yaw_deg</source>
            <translation>列 time_s、roll_deg、pitch_deg、yaw_deg</translation>
        </message>
        <message>
            <source>a point has the time %1 s</source>
            <translation>一个点的时间为 %1 s</translation>
        </message>
        <message>
            <source>attitudes around it: they run from %1 to %2</source>
            <translation>其前后的姿态：姿态从 %1 至 %2</translation>
        </message>
        <message>
            <source>Give roll_deg and pitch_deg instead</source>
            <translation>请改为给出 roll_deg 和 pitch_deg</translation>
        </message>
        <message>
            <source>a time for every point</source>
            <translation>每个点的时间</translation>
        </message>
        <message>
            <source>the frame has no column time and attitudes are connected</source>
            <translation>帧没有列 time，而连接了姿态</translation>
        </message>
        <message>
            <source>a minimum below the maximum</source>
            <translation>小于最大值的最小值</translation>
        </message>
        <message>
            <source>min_x is %1 and max_x is %2</source>
            <translation>min_x 为 %1，max_x 为 %2</translation>
        </message>
        <message>
            <source>min_x is %1 and max_y is %2</source>
            <translation>min_x 为 %1，max_y 为 %2</translation>
        </message>
        <message>
            <source>min_x is %1 and max_z is %2</source>
            <translation>min_x 为 %1，max_z 为 %2</translation>
        </message>
        <message>
            <source>min_y is %1 and max_x is %2</source>
            <translation>min_y 为 %1，max_x 为 %2</translation>
        </message>
        <message>
            <source>min_y is %1 and max_y is %2</source>
            <translation>min_y 为 %1，max_y 为 %2</translation>
        </message>
        <message>
            <source>min_y is %1 and max_z is %2</source>
            <translation>min_y 为 %1，max_z 为 %2</translation>
        </message>
        <message>
            <source>min_z is %1 and max_x is %2</source>
            <translation>min_z 为 %1，max_x 为 %2</translation>
        </message>
        <message>
            <source>min_z is %1 and max_y is %2</source>
            <translation>min_z 为 %1，max_y 为 %2</translation>
        </message>
        <message>
            <source>min_z is %1 and max_z is %2</source>
            <translation>min_z 为 %1，max_z 为 %2</translation>
        </message>
        <message>
            <source>Cut a region first: it drops them</source>
            <translation>请先裁出区域：这会去掉它们</translation>
        </message>
        <message>
            <source>finite points</source>
            <translation>有限的点</translation>
        </message>
        <message>
            <source>point %1 is not finite</source>
            <translation>第 %1 个点不是有限数</translation>
        </message>
        <message>
            <source>Leave out x, y and yaw</source>
            <translation>请去掉 x、y 和 yaw</translation>
        </message>
        <message>
            <source>one of the two</source>
            <translation>两者之一</translation>
        </message>
        <message>
            <source>the place of the sensor is given twice, by the options and by its marks</source>
            <translation>传感器的位置给出了两次：由选项和由标志</translation>
        </message>
        <message>
            <source>%1 poses of the sensor</source>
            <translation>传感器有 %1 个位姿</translation>
        </message>
        <message>
            <source>one</source>
            <translation>一个</translation>
        </message>
        <message>
            <source>the pose of the sensor is not finite</source>
            <translation>传感器的位姿不是有限数</translation>
        </message>
        <message>
            <source>Pick the marks in the frame: without them the heading is unknown</source>
            <translation>请在帧中选取标志：没有标志则航向未知</translation>
        </message>
        <message>
            <source>seen_x_m, seen_y_m, seen_z_m</source>
            <translation>列 seen_x_m、seen_y_m、seen_z_m</translation>
        </message>
        <message>
            <source>the marks have no coordinates as the sensor sees them</source>
            <translation>标志没有传感器所见的坐标</translation>
        </message>
        <message>
            <source>Put stage geo.project before</source>
            <translation>请在前面加入步骤 geo.project</translation>
        </message>
        <message>
            <source>the marks have latitude and longitude</source>
            <translation>标志为纬度和经度</translation>
        </message>
        <message>
            <source>mark %1 has the range %2 m and is seen at %3 m</source>
            <translation>标志 %1 的距离为 %2 m，而观测到的为 %3 m</translation>
        </message>
        <message>
            <source>the range to the place that is seen</source>
            <translation>到观测位置的距离</translation>
        </message>
        <message>
            <source>which of them is wrong cannot be told</source>
            <translation>无法判断其中哪个有误</translation>
        </message>
        <message>
            <source>without mark %1 the others agree</source>
            <translation>去掉标志 %1 后其余一致</translation>
        </message>
        <message>
            <source>Check which mark is which, or raise the standard deviations</source>
            <translation>请检查标志是否对应，或增大标准差</translation>
        </message>
        <message>
            <source>distances that agree to %1 m</source>
            <translation>相差不超过 %1 m 的间距</translation>
        </message>
        <message>
            <source>marks %1 and %2 are %3 m apart as seen and %4 m as known; %5</source>
            <translation>标志 %1 和 %2 的观测间距为 %3 m，已知间距为 %4 m；%5</translation>
        </message>
        <message>
            <source>Set method=vectors, which takes the directions to the marks too</source>
            <translation>请设置 method=vectors，它还使用到标志的方向</translation>
        </message>
        <message>
            <source>marks all around and at several heights</source>
            <translation>四周且在不同高度的标志</translation>
        </message>
        <message>
            <source>the ranges carry no position: %1</source>
            <translation>距离不能确定位置：%1</translation>
        </message>
        <message>
            <source>Place the marks farther apart, or raise max_sigma</source>
            <translation>请将标志放得更开，或增大 max_sigma</translation>
        </message>
        <message>
            <source>the position has a standard error of %1 m</source>
            <translation>位置的标准误差为 %1 m</translation>
        </message>
        <message>
            <source>Place the marks farther apart, or raise max_heading_sigma</source>
            <translation>请将标志放得更开，或增大 max_heading_sigma</translation>
        </message>
        <message>
            <source>the heading has a standard error of %1 deg</source>
            <translation>航向的标准误差为 %1 度</translation>
        </message>
        <message>
            <source>%1 marks</source>
            <translation>%1 个标志</translation>
        </message>
        <message>
            <source>three marks of known position, two at the least</source>
            <translation>三个位置已知的标志，至少两个</translation>
        </message>
        <message>
            <source>Check which mark is which, and the level of the frame</source>
            <translation>请检查标志是否对应，以及帧是否水平</translation>
        </message>
        <message>
            <source>the marks as seen do not fit those as known: residuals are %1 times their standard deviation; %2</source>
            <translation>标志的观测位置与已知位置不符：残差是其标准差的 %1 倍；%2</translation>
        </message>
        <message>
            <source>the same marks in axes of the same hand</source>
            <translation>同一手性坐标轴中的相同标志</translation>
        </message>
        <message>
            <source>x and y of the marks are swapped: exchange them</source>
            <translation>标志的 x 和 y 弄反了：请交换</translation>
        </message>
        <message>
            <source>the marks as seen fit those as known %1 times worse than the standard deviations say, and the standard errors are raised by this; %2</source>
            <translation>标志的观测位置与已知位置的偏差是标准差所示的 %1 倍，标准误差已按此放大；%2</translation>
        </message>
        <message>
            <source>two marks carry the pose, so an error in one of them can hardly be seen: take a third</source>
            <translation>位姿由两个标志确定，因此其中一个的误差几乎无法发现：请增加第三个</translation>
        </message>
        <message>
            <source>%1 marks: position to %2 cm, heading to %3 deg (standard errors)</source>
            <translation>%1 个标志：位置精度 %2 cm，航向精度 %3 度（标准误差）</translation>
        </message>
        <message>
            <source>Connect dense to the output of rows.region, or set centre to mean</source>
            <translation>请将 dense 连接到 rows.region 的输出，或将 centre 设为 mean</translation>
        </message>
        <message>
            <source>centre is face and the input dense is not connected</source>
            <translation>centre 为 face，而输入 dense 未连接</translation>
        </message>
        <message>
            <source>the levelled frame before it was thinned</source>
            <translation>抽稀前的整平帧</translation>
        </message>
        <message>
            <source>%1 clusters have fewer than %2 trunk layers and are not plants: raise max_extent_x and max_extent_y where trunks are thicker</source>
            <translation>%1 个聚类的树干层少于 %2 层，不是植株：如果树干更粗，请增大 max_extent_x 和 max_extent_y</translation>
        </message>
        <message>
            <source>%1 clusters hold no trunk of %2 m or more</source>
            <translation>%1 个聚类没有达到 %2 m 的树干</translation>
        </message>
        <message>
            <source>%1 plants</source>
            <translation>%1 株植株</translation>
        </message>
        <message>
            <source>looking for rows</source>
            <translation>查找行</translation>
        </message>
        <message>
            <source>numbering plants</source>
            <translation>植株编号</translation>
        </message>
        <message>
            <source>tables</source>
            <translation>表格</translation>
        </message>
        <message>
            <source>Are these degrees, or a wrong line?</source>
            <translation>这些是度，还是有错误的行？</translation>
        </message>
        <message>
            <source>metres of one plane</source>
            <translation>同一平面上的米</translation>
        </message>
        <message>
            <source>stem %1 at (%2, %3) is more than %4 km from the first</source>
            <translation>位于 (%2, %3) 的单木 %1 距第一株超过 %4 km</translation>
        </message>
        <message>
            <source>columns x_m and y_m with numbers</source>
            <translation>有数值的列 x_m 和 y_m</translation>
        </message>
        <message>
            <source>the table has %1 rows and no stem with coordinates</source>
            <translation>表有 %1 行，没有带坐标的单木</translation>
        </message>
        <message>
            <source>%1 stems without coordinates are ignored</source>
            <translation>忽略 %1 株没有坐标的单木</translation>
        </message>
        <message>
            <source>row_id %1 in line %2</source>
            <translation>第 %2 行的 row_id 为 %1</translation>
        </message>
        <message>
            <source>whole numbers or names</source>
            <translation>整数或名称</translation>
        </message>
        <message>
            <source>an id for every plant of a row</source>
            <translation>行中每株植株的编号</translation>
        </message>
        <message>
            <source>the column row_id is empty</source>
            <translation>列 row_id 为空</translation>
        </message>
        <message>
            <source>%1 rows in %2 blocks: %3 plants, %4 missing, %5 strays</source>
            <translation>%2 个地块中有 %1 行：植株 %3 株，缺株 %4 处，离群植株 %5 株</translation>
        </message>
        <message>
            <source>no row of %1 or more plants among %2 stems at %3 deg from east: lower min_plants or raise lateral_tolerance</source>
            <translation>%2 株单木中没有与正东成 %3 度、含 %1 株或更多植株的行：请减小 min_plants 或增大 lateral_tolerance</translation>
        </message>
        <message>
            <source>no row of %1 or more plants among %2 stems at %3 deg from east: lower min_plants or raise lateral_tolerance, or leave direction open. It counts in the axes of the stems, after they were placed</source>
            <translation>%2 株单木中没有与正东成 %3 度、含 %1 株或更多植株的行：请减小 min_plants 或增大 lateral_tolerance，或不指定 direction。该方向以放置后的单木坐标轴计</translation>
        </message>
        <message>
            <source>no row of %1 or more plants among %2 stems: lower min_plants or raise lateral_tolerance</source>
            <translation>%2 株单木中没有含 %1 株或更多植株的行：请减小 min_plants 或增大 lateral_tolerance</translation>
        </message>
        <message>
            <source>no row of %1 or more plants among %2 stems: lower min_plants or raise lateral_tolerance, or leave direction open. It counts in the axes of the stems, after they were placed</source>
            <translation>%2 株单木中没有含 %1 株或更多植株的行：请减小 min_plants 或增大 lateral_tolerance，或不指定 direction。该方向以放置后的单木坐标轴计</translation>
        </message>
        <message>
            <source>%1 rows are planted too unevenly to find missing plants: set plant_spacing if it is known</source>
            <translation>%1 行的株距太不均匀，无法判断缺株：如果已知株距，请设置 plant_spacing</translation>
        </message>
        <message>
            <source>rows are %1 m apart and plants %2 m: the rows may run the other way. Set direction to fix it</source>
            <translation>行距 %1 m，株距 %2 m：行可能是另一个方向。请设置 direction 加以固定</translation>
        </message>
        <message>
            <source>Cut a region first</source>
            <translation>请先裁出区域</translation>
        </message>
        <message>
            <source>a field of less than 10 km</source>
            <translation>小于 10 km 的田块</translation>
        </message>
        <message>
            <source>point %1 lies %2 m from the first</source>
            <translation>第 %1 个点距第一个点 %2 m</translation>
        </message>
        <message>
            <source>Check the bounds of rows.region</source>
            <translation>请检查 rows.region 的范围</translation>
        </message>
        <message>
            <source>the canopy of a row</source>
            <translation>一行的冠层</translation>
        </message>
        <message>
            <source>the cloud has no point</source>
            <translation>点云没有点</translation>
        </message>
        <message>
            <source>%1 rows at %2 deg in %3 pieces</source>
            <translation>%3 段中有 %1 行，方向 %2 度</translation>
        </message>
        <message>
            <source>%1 of %2 points</source>
            <translation>%2 个点中的 %1 个</translation>
        </message>
        <message>
            <source>levelled point by point</source>
            <translation>逐点整平</translation>
        </message>
        <message>
            <source>levelled with one attitude</source>
            <translation>用一个姿态整平</translation>
        </message>
        <message>
            <source>%1 stems placed</source>
            <translation>放置了 %1 株单木</translation>
        </message>
    </context>
    <context>
        <name>sensor</name>
        <message>
            <source>the calibration enables %1 lasers</source>
            <translation>标定文件启用了 %1 个激光器</translation>
        </message>
        <message>
            <source>128, 64, 32 or 16 (Velodyne)</source>
            <translation>128、64、32 或 16 个（Velodyne）</translation>
        </message>
        <message>
            <source>laser %1 is there twice</source>
            <translation>激光器 %1 重复</translation>
        </message>
        <message>
            <source>one entry per laser</source>
            <translation>每个激光器一项</translation>
        </message>
        <message>
            <source>laser %1 is absent</source>
            <translation>缺少激光器 %1</translation>
        </message>
        <message>
            <source>all %1 lasers of a %2</source>
            <translation>%2 的全部 %1 个激光器</translation>
        </message>
        <message>
            <source>%1 is '%2'</source>
            <translation>%1 为“%2”</translation>
        </message>
        <message>
            <source>the file is no correction table</source>
            <translation>文件不是校正表</translation>
        </message>
        <message>
            <source>the header 'Laser id,Elevation,Azimuth' and a line per laser</source>
            <translation>标题行“Laser id,Elevation,Azimuth”和每个激光器一行</translation>
        </message>
        <message>
            <source>the correction file has the line '%1'</source>
            <translation>校正文件含有一行“%1”</translation>
        </message>
        <message>
            <source>a laser from 1 to %1, elevation and azimuth in degrees</source>
            <translation>1 至 %1 的激光器编号，以度计的仰角和方位角</translation>
        </message>
        <message>
            <source>the correction file has %1 lasers</source>
            <translation>校正文件有 %1 个激光器</translation>
        </message>
        <message>
            <source>%1, as the %2 has</source>
            <translation>%1 个，与 %2 相同</translation>
        </message>
        <message>
            <source>the sensor %1 has %2 lasers</source>
            <translation>传感器 %1 有 %2 个激光器</translation>
        </message>
        <message>
            <source>%1, as the packets have</source>
            <translation>%1 个，与数据包相同</translation>
        </message>
        <message>
            <source>the sensor %1 does not send Hesai packets that are known</source>
            <translation>传感器 %1 不发送已知的 Hesai 数据包</translation>
        </message>
        <message>
            <source>a PandarXT-32 or Pandar40P</source>
            <translation>PandarXT-32 或 Pandar40P</translation>
        </message>
        <message>
            <source>a firing of %1 echoes</source>
            <translation>一次发射有 %1 个回波</translation>
        </message>
        <message>
            <source>%1, one per laser of the %2</source>
            <translation>%1 个，%2 的每个激光器一个</translation>
        </message>
        <message>
            <source>the sensor %1 does not send Ouster packets</source>
            <translation>传感器 %1 不发送 Ouster 数据包</translation>
        </message>
        <message>
            <source>an Ouster sensor</source>
            <translation>Ouster 传感器</translation>
        </message>
        <message>
            <source>a turn of the %1 at %2 revolutions per second has %3 columns</source>
            <translation>%1 以每秒 %2 圈旋转时每圈有 %3 列</translation>
        </message>
        <message>
            <source>a multiple of 16, as with 5, 10 or 20 revolutions per second</source>
            <translation>16 的倍数，例如每秒 5、10 或 20 圈时</translation>
        </message>
        <message>
            <source>a column of %1 echoes</source>
            <translation>一列有 %1 个回波</translation>
        </message>
        <message>
            <source>'%1' is not a list of at most 256 numbers</source>
            <translation>“%1”不是至多 256 个数的列表</translation>
        </message>
        <message>
            <source>a list of numbers up to +-%1</source>
            <translation>+-%1 以内的数的列表</translation>
        </message>
        <message>
            <source>'%1' holds %2</source>
            <translation>“%1”含有 %2</translation>
        </message>
        <message>
            <source>'beam_altitude_angles' is absent</source>
            <translation>缺少“beam_altitude_angles”</translation>
        </message>
        <message>
            <source>'beam_azimuth_angles' is absent</source>
            <translation>缺少“beam_azimuth_angles”</translation>
        </message>
        <message>
            <source>the JSON file of an Ouster sensor</source>
            <translation>Ouster 传感器的 JSON 文件</translation>
        </message>
        <message>
            <source>'%1' is %2</source>
            <translation>“%1”为 %2</translation>
        </message>
        <message>
            <source>'lidar_to_sensor_transform' has %1 numbers</source>
            <translation>“lidar_to_sensor_transform”有 %1 个数</translation>
        </message>
        <message>
            <source>'imu_to_sensor_transform' has %1 numbers</source>
            <translation>“imu_to_sensor_transform”有 %1 个数</translation>
        </message>
        <message>
            <source>'lidar_to_sensor_transform' is no rigid motion</source>
            <translation>“lidar_to_sensor_transform”不是刚体运动</translation>
        </message>
        <message>
            <source>'imu_to_sensor_transform' is no rigid motion</source>
            <translation>“imu_to_sensor_transform”不是刚体运动</translation>
        </message>
        <message>
            <source>a rotation and a translation in millimetres</source>
            <translation>旋转和以毫米计的平移</translation>
        </message>
        <message>
            <source>the sensor sent the profile '%1'</source>
            <translation>传感器发送的格式为“%1”</translation>
        </message>
        <message>
            <source>Set udp_profile_lidar of the sensor to one of these, and record again</source>
            <translation>请将传感器的 udp_profile_lidar 设为其中之一，并重新记录</translation>
        </message>
        <message>
            <source>'beam_to_lidar_transform' has %1 numbers</source>
            <translation>“beam_to_lidar_transform”有 %1 个数</translation>
        </message>
        <message>
            <source>'lidar_origin_to_beam_origin_mm' is %1</source>
            <translation>“lidar_origin_to_beam_origin_mm”为 %1</translation>
        </message>
        <message>
            <source>'column_window' is %1</source>
            <translation>“column_window”为 %1</translation>
        </message>
        <message>
            <source>two columns from 0 to %1</source>
            <translation>0 至 %1 的两列</translation>
        </message>
        <message>
            <source>the text is not a JSON object</source>
            <translation>文本不是 JSON 对象</translation>
        </message>
        <message>
            <source>the file has %1 beam altitude angles and %2 azimuth angles</source>
            <translation>文件有 %1 个光束仰角和 %2 个方位角</translation>
        </message>
        <message>
            <source>one of each per line</source>
            <translation>每条线各一个</translation>
        </message>
        <message>
            <source>the file has %1 beams for %2 pixels</source>
            <translation>文件的 %2 个像素有 %1 条光束</translation>
        </message>
        <message>
            <source>one beam per pixel of a column</source>
            <translation>一列的每个像素一条光束</translation>
        </message>
        <message>
            <source>a datagram of %1 bytes</source>
            <translation>%1 字节的数据报</translation>
        </message>
        <message>
            <source>cannot write to '%1'</source>
            <translation>无法写入“%1”</translation>
        </message>
        <message>
            <source>'%1' is absent</source>
            <translation>缺少“%1”</translation>
        </message>
        <message>
            <source>'elevation_deg' is not a list</source>
            <translation>“elevation_deg”不是列表</translation>
        </message>
        <message>
            <source>'azimuth_offset_deg' is not a list</source>
            <translation>“azimuth_offset_deg”不是列表</translation>
        </message>
        <message>
            <source>'firing_time_us' is not a list</source>
            <translation>“firing_time_us”不是列表</translation>
        </message>
        <message>
            <source>'height_offset_mm' is not a list</source>
            <translation>“height_offset_mm”不是列表</translation>
        </message>
        <message>
            <source>one number per laser, in the order of the packet</source>
            <translation>每个激光器一个数，按数据包中的顺序</translation>
        </message>
        <message>
            <source>'elevation_deg' has %1 entries</source>
            <translation>“elevation_deg”有 %1 项</translation>
        </message>
        <message>
            <source>'azimuth_offset_deg' has %1 entries</source>
            <translation>“azimuth_offset_deg”有 %1 项</translation>
        </message>
        <message>
            <source>'firing_time_us' has %1 entries</source>
            <translation>“firing_time_us”有 %1 项</translation>
        </message>
        <message>
            <source>'height_offset_mm' has %1 entries</source>
            <translation>“height_offset_mm”有 %1 项</translation>
        </message>
        <message>
            <source>1 to %1</source>
            <translation>1 至 %1</translation>
        </message>
        <message>
            <source>%1, as elevation_deg has</source>
            <translation>%1 项，与 elevation_deg 相同</translation>
        </message>
        <message>
            <source>'elevation_deg' holds %1</source>
            <translation>“elevation_deg”含有 %1</translation>
        </message>
        <message>
            <source>'azimuth_offset_deg' holds %1</source>
            <translation>“azimuth_offset_deg”含有 %1</translation>
        </message>
        <message>
            <source>'firing_time_us' holds %1</source>
            <translation>“firing_time_us”含有 %1</translation>
        </message>
        <message>
            <source>'height_offset_mm' holds %1</source>
            <translation>“height_offset_mm”含有 %1</translation>
        </message>
        <message>
            <source>numbers from %1 to %2</source>
            <translation>%1 至 %2 的数</translation>
        </message>
        <message>
            <source>'pattern' is '%1'</source>
            <translation>“pattern”为“%1”</translation>
        </message>
        <message>
            <source>lines or rosette</source>
            <translation>lines 或 rosette</translation>
        </message>
        <message>
            <source>'beam_assumed' is %1</source>
            <translation>“beam_assumed”为 %1</translation>
        </message>
        <message>
            <source>'dual_return' is %1</source>
            <translation>“dual_return”为 %1</translation>
        </message>
        <message>
            <source>'packet' is '%1'</source>
            <translation>“packet”为“%1”</translation>
        </message>
        <message>
            <source>velodyne, hesai, ouster or none</source>
            <translation>velodyne、hesai、ouster 或 none</translation>
        </message>
        <message>
            <source>a Velodyne block of %1 lasers and %2 sequences</source>
            <translation>Velodyne 数据块有 %1 个激光器和 %2 个序列</translation>
        </message>
        <message>
            <source>16 lasers twice, 32 once, or 64 or 128 in banks of 32</source>
            <translation>16 个激光器两次，32 个一次，或 64 或 128 个按 32 个一组</translation>
        </message>
        <message>
            <source>the sensor is not a JSON object</source>
            <translation>传感器不是 JSON 对象</translation>
        </message>
        <message>
            <source>an object with the entries of resources/sensors/vlp16.json</source>
            <translation>含有 resources/sensors/vlp16.json 各项的对象</translation>
        </message>
        <message>
            <source>the calibration of a Velodyne unit (XML or YAML)</source>
            <translation>Velodyne 设备的标定文件（XML 或 YAML）</translation>
        </message>
        <message>
            <source>'%1' is larger than 4 MB</source>
            <translation>“%1”大于 4 MB</translation>
        </message>
        <message>
            <source>the calibration of a Velodyne unit</source>
            <translation>Velodyne 设备的标定文件</translation>
        </message>
        <message>
            <source>there is no sensor '%1'</source>
            <translation>没有传感器“%1”</translation>
        </message>
        <message>
            <source>one of %1, or the path of a JSON file or of a Velodyne calibration (XML, YAML)</source>
            <translation>下列之一：%1，或 JSON 文件、Velodyne 标定文件（XML、YAML）的路径</translation>
        </message>
        <message>
            <source>a sensor description in JSON</source>
            <translation>JSON 格式的传感器描述</translation>
        </message>
        <message>
            <source>'%1' is not JSON</source>
            <translation>“%1”不是 JSON</translation>
        </message>
        <message>
            <source>a sensor description like resources/sensors/vlp16.json</source>
            <translation>resources/sensors/vlp16.json 那样的传感器描述</translation>
        </message>
        <message>
            <source>the calibration is no XML: %1</source>
            <translation>标定文件不是 XML：%1</translation>
        </message>
        <message>
            <source>the db.xml of a Velodyne unit</source>
            <translation>Velodyne 设备的 db.xml</translation>
        </message>
        <message>
            <source>the XML has no &lt;DB&gt; in &lt;boost_serialization&gt;</source>
            <translation>XML 的 &lt;boost_serialization&gt; 中没有 &lt;DB&gt;</translation>
        </message>
        <message>
            <source>the sensor %1 does not send Velodyne packets</source>
            <translation>传感器 %1 不发送 Velodyne 数据包</translation>
        </message>
        <message>
            <source>a Velodyne sensor</source>
            <translation>Velodyne 传感器</translation>
        </message>
        <message>
            <source>the sensor %1 has no dual return</source>
            <translation>传感器 %1 没有双回波</translation>
        </message>
        <message>
            <source>strongest or last</source>
            <translation>strongest 或 last</translation>
        </message>
        <message>
            <source>a firing sequence of %1 echoes</source>
            <translation>一个发射序列有 %1 个回波</translation>
        </message>
        <message>
            <source>'%1' is there twice in one entry</source>
            <translation>同一项中“%1”重复</translation>
        </message>
        <message>
            <source>a list of lasers as velodyne_pointcloud has it</source>
            <translation>velodyne_pointcloud 那样的激光器列表</translation>
        </message>
        <message>
            <source>more than 1024 lasers</source>
            <translation>激光器超过 1024 个</translation>
        </message>
        <message>
            <source>up to 128</source>
            <translation>至多 128 个</translation>
        </message>
        <message>
            <source>a laser has no '%1'</source>
            <translation>一个激光器没有“%1”</translation>
        </message>
        <message>
            <source>laser_id, rot_correction and vert_correction of each laser</source>
            <translation>每个激光器的 laser_id、rot_correction 和 vert_correction</translation>
        </message>
        <message>
            <source>the calibration lists no lasers</source>
            <translation>标定文件没有列出激光器</translation>
        </message>
        <message>
            <source>the YAML of velodyne_pointcloud, or the db.xml of the maker</source>
            <translation>velodyne_pointcloud 的 YAML，或厂家的 db.xml</translation>
        </message>
        <message>
            <source>num_lasers is %1, the list has %2</source>
            <translation>num_lasers 为 %1，而列表有 %2 个</translation>
        </message>
        <message>
            <source>as many as the list has</source>
            <translation>与列表的数目相同</translation>
        </message>
        <message>
            <source>'distance_resolution' is negative</source>
            <translation>“distance_resolution”为负</translation>
        </message>
        <message>
            <source>metres, such as 0.002</source>
            <translation>以米计的值，例如 0.002</translation>
        </message>
    </context>
    <context>
        <name>sim</name>
        <message>
            <source>recipe field 'plants.diameter_min_mm' is above diameter_max_mm</source>
            <translation>方案字段“plants.diameter_min_mm”大于 diameter_max_mm</translation>
        </message>
        <message>
            <source>the smaller one first</source>
            <translation>较小的在前</translation>
        </message>
        <message>
            <source>scanning the field</source>
            <translation>扫描田块</translation>
        </message>
        <message>
            <source>%1: %2 frames of %3 s, %4 returns, %5 plants in %6 rows</source>
            <translation>%1：%2 帧，每帧 %3 s，%4 个回波，%6 行中有 %5 株植株</translation>
        </message>
        <message>
            <source>recipe '%1': %2 trees do not fit in %3 m x %4 m at a spacing of %5 m</source>
            <translation>方案“%1”：株距 %5 m 时 %3 m x %4 m 容不下 %2 株树</translation>
        </message>
        <message>
            <source>a plot they fit in</source>
            <translation>容得下它们的样地</translation>
        </message>
        <message>
            <source>Lower trees.count or layout.min_spacing_m</source>
            <translation>请减小 trees.count 或 layout.min_spacing_m</translation>
        </message>
        <message>
            <source>recipe '%1': the rows hold %2 plants within the plot</source>
            <translation>方案“%1”：样地内各行有 %2 株植株</translation>
        </message>
        <message>
            <source>at least %1 (trees.count)</source>
            <translation>至少 %1 株（trees.count）</translation>
        </message>
        <message>
            <source>Lower trees.count or the spacings</source>
            <translation>请减小 trees.count 或间距</translation>
        </message>
        <message>
            <source>recipe fields vineyard: %1 rows of %2 m, %3 m apart, in a plot of %4 m</source>
            <translation>方案字段 vineyard：%4 m 的样地中有 %1 行，每行 %2 m，行距 %3 m</translation>
        </message>
        <message>
            <source>%1 m of headland on each side</source>
            <translation>每侧 %1 m 的地头</translation>
        </message>
        <message>
            <source>Raise size_m</source>
            <translation>请增大 size_m</translation>
        </message>
        <message>
            <source>recipe field 'vineyard.canopy_bottom_m' is %1</source>
            <translation>方案字段“vineyard.canopy_bottom_m”为 %1</translation>
        </message>
        <message>
            <source>less than canopy_top_m, %1</source>
            <translation>小于 canopy_top_m，即 %1</translation>
        </message>
        <message>
            <source>recipe fields trees.dbh_min_cm %1 and dbh_max_cm %2</source>
            <translation>方案字段 trees.dbh_min_cm 为 %1，dbh_max_cm 为 %2</translation>
        </message>
        <message>
            <source>recipe field 'trees.dbh_mean_cm' is %1</source>
            <translation>方案字段“trees.dbh_mean_cm”为 %1</translation>
        </message>
        <message>
            <source>a mean between dbh_min_cm and dbh_max_cm</source>
            <translation>dbh_min_cm 与 dbh_max_cm 之间的平均值</translation>
        </message>
        <message>
            <source>recipe field 'trees.dbh_sd_cm' is %1</source>
            <translation>方案字段“trees.dbh_sd_cm”为 %1</translation>
        </message>
        <message>
            <source>a spread that fits between dbh_min_cm and dbh_max_cm</source>
            <translation>与 dbh_min_cm 至 dbh_max_cm 的范围相称的离散</translation>
        </message>
        <message>
            <source>Lower it, or widen the limits</source>
            <translation>请减小它，或放宽界限</translation>
        </message>
        <message>
            <source>recipe fields understorey.pole_min_cm %1 and pole_max_cm %2</source>
            <translation>方案字段 understorey.pole_min_cm 为 %1，pole_max_cm 为 %2</translation>
        </message>
        <message>
            <source>recipe field 'terrain.terrace_riser_m' is %1</source>
            <translation>方案字段“terrain.terrace_riser_m”为 %1</translation>
        </message>
        <message>
            <source>less than terrace_width_m, %1</source>
            <translation>小于 terrace_width_m，即 %1</translation>
        </message>
        <message>
            <source>recipe field '%1' is %2</source>
            <translation>方案字段“%1”为 %2</translation>
        </message>
        <message>
            <source>(whole file)</source>
            <translation>（整个文件）</translation>
        </message>
        <message>
            <source>a JSON object {...}</source>
            <translation>JSON 对象 {...}</translation>
        </message>
        <message>
            <source>unknown recipe field '%1'</source>
            <translation>未知的方案字段“%1”</translation>
        </message>
        <message>
            <source>a field of modules/sim/README.md</source>
            <translation>modules/sim/README.md 中的字段</translation>
        </message>
        <message>
            <source>Did you mean '%1'?</source>
            <translation>是否指“%1”？</translation>
        </message>
        <message>
            <source>a list of up to %1</source>
            <translation>至多 %1 项的列表</translation>
        </message>
        <message>
            <source>rows of positions [x, y] within 1000 m</source>
            <translation>1000 m 以内的位置 [x, y] 各行</translation>
        </message>
        <message>
            <source>[smallest, largest] from %1 to %2</source>
            <translation>[smallest, largest]，从 %1 至 %2</translation>
        </message>
        <message>
            <source>there is no recipe '%1' in resources/%2</source>
            <translation>resources/%2 中没有方案“%1”</translation>
        </message>
        <message>
            <source>one of %1, or the path of a recipe file</source>
            <translation>下列之一：%1，或方案文件的路径</translation>
        </message>
        <message>
            <source>cannot open the recipe %1</source>
            <translation>无法打开方案 %1</translation>
        </message>
        <message>
            <source>a readable file</source>
            <translation>可读的文件</translation>
        </message>
        <message>
            <source>%1 is not valid JSON: %2</source>
            <translation>%1 不是有效的 JSON：%2</translation>
        </message>
        <message>
            <source>a recipe</source>
            <translation>模拟方案</translation>
        </message>
        <message>
            <source>cannot open the walk %1</source>
            <translation>无法打开行走路线 %1</translation>
        </message>
        <message>
            <source>a readable file with one x_m,y_m per line</source>
            <translation>可读的文件，每行一个 x_m,y_m</translation>
        </message>
        <message>
            <source>%1:%2 is '%3'</source>
            <translation>%1:%2 为“%3”</translation>
        </message>
        <message>
            <source>x_m,y_m in plot axes, within 200 m</source>
            <translation>样地坐标轴中的 x_m,y_m，200 m 以内</translation>
        </message>
        <message>
            <source>%1 has more than 10000 way-points</source>
            <translation>%1 的路点超过 10000 个</translation>
        </message>
        <message>
            <source>fewer</source>
            <translation>更少</translation>
        </message>
        <message>
            <source>%1 has %2 way-points</source>
            <translation>%1 有 %2 个路点</translation>
        </message>
        <message>
            <source>cannot write %1</source>
            <translation>无法写出 %1</translation>
        </message>
        <message>
            <source>a writable folder with free space</source>
            <translation>可写且有剩余空间的文件夹</translation>
        </message>
        <message>
            <source>%1: %2 trees, %3 s of %4, %5 returns</source>
            <translation>%1：%2 株树，%4 的 %3 s，%5 个回波</translation>
        </message>
        <message>
            <source>cannot make the folder %1: %2</source>
            <translation>无法建立文件夹 %1：%2</translation>
        </message>
        <message>
            <source>growing the plot</source>
            <translation>生成样地</translation>
        </message>
        <message>
            <source>planning the walk</source>
            <translation>规划行走路线</translation>
        </message>
        <message>
            <source>building the ray tracer</source>
            <translation>建立光线追踪</translation>
        </message>
        <message>
            <source>GDAL has no GeoTIFF driver</source>
            <translation>GDAL 没有 GeoTIFF 驱动程序</translation>
        </message>
        <message>
            <source>Check the installation of GDAL</source>
            <translation>请检查 GDAL 的安装</translation>
        </message>
        <message>
            <source>a writable folder</source>
            <translation>可写的文件夹</translation>
        </message>
        <message>
            <source>free space on the disk</source>
            <translation>磁盘上的剩余空间</translation>
        </message>
        <message>
            <source>the calibration of the sensor %1 corrects ranges at two distances</source>
            <translation>传感器 %1 的标定在两个距离上改正测距</translation>
        </message>
        <message>
            <source>a sensor without such a correction: the simulator does not have it</source>
            <translation>没有这种改正的传感器：模拟器不支持</translation>
        </message>
        <message>
            <source>Embree has no memory for a mesh of %1 triangles</source>
            <translation>Embree 没有内存存放 %1 个三角形的网格</translation>
        </message>
        <message>
            <source>Use a smaller plot or fewer trees</source>
            <translation>请使用更小的样地或更少的树</translation>
        </message>
        <message>
            <source>Embree could not start</source>
            <translation>Embree 无法启动</translation>
        </message>
        <message>
            <source>Embree error %1 while building the scene</source>
            <translation>建立场景时 Embree 出现错误 %1</translation>
        </message>
        <message>
            <source>Embree has no memory for the seedling</source>
            <translation>Embree 没有内存存放幼苗</translation>
        </message>
        <message>
            <source>Embree error %1 while building the seedling</source>
            <translation>建立幼苗时 Embree 出现错误 %1</translation>
        </message>
        <message>
            <source>a folder that can be written to, and space on the disk</source>
            <translation>可写入的文件夹，以及磁盘空间</translation>
        </message>
        <message>
            <source>recipe field 'pot.soil_below_mm' leaves less than 15 mm of soil</source>
            <translation>方案字段“pot.soil_below_mm”使土壤不足 15 mm</translation>
        </message>
        <message>
            <source>a deeper pot or more soil</source>
            <translation>更深的盆或更多的土壤</translation>
        </message>
        <message>
            <source>%1 already holds pictures</source>
            <translation>%1 中已有图像</translation>
        </message>
        <message>
            <source>a folder without the subfolder color</source>
            <translation>没有子文件夹 color 的文件夹</translation>
        </message>
        <message>
            <source>Remove it, or choose another folder</source>
            <translation>请将其移走，或选择其他文件夹</translation>
        </message>
        <message>
            <source>lighting the seedling</source>
            <translation>为幼苗布光</translation>
        </message>
        <message>
            <source>rendering views</source>
            <translation>渲染视图</translation>
        </message>
        <message>
            <source>%1: %2 views, height %3 mm, breadth %4 x %5 mm, stem %6 mm, %7 leaves</source>
            <translation>%1：%2 个视图，高 %3 mm，冠幅 %4 x %5 mm，茎 %6 mm，%7 片叶</translation>
        </message>
        <message>
            <source>cannot copy %1 to %2: %3</source>
            <translation>无法将 %1 复制到 %2：%3</translation>
        </message>
        <message>
            <source>a walk of %1 way-points</source>
            <translation>有 %1 个路点的行走路线</translation>
        </message>
        <message>
            <source>trees leave no free ground to walk on</source>
            <translation>树木之间没有可以行走的空地</translation>
        </message>
        <message>
            <source>trees block the walk between its way-points</source>
            <translation>树木挡住了路点之间的行走路线</translation>
        </message>
        <message>
            <source>gaps of at least 0.6 m</source>
            <translation>至少 0.6 m 的间隙</translation>
        </message>
        <message>
            <source>Use a wider spacing or another walk</source>
            <translation>请使用更大的间距或其他行走路线</translation>
        </message>
        <message>
            <source>scanning: %1 of %2 s</source>
            <translation>扫描：%2 s 中的 %1 s</translation>
        </message>
        <message>
            <source>the recording of the sensor %1 is written as frames, which hold one return</source>
            <translation>传感器 %1 的记录以帧写出，每帧只含一个回波</translation>
        </message>
        <message>
            <source>dual_return=false, or a sensor with packets of Velodyne, Ouster or Hesai</source>
            <translation>dual_return=false，或采用 Velodyne、Ouster 或 Hesai 数据包的传感器</translation>
        </message>
        <message>
            <source>a route of %1 points</source>
            <translation>有 %1 个点的路线</translation>
        </message>
        <message>
            <source>a walk of at least a metre</source>
            <translation>至少一米的行走路线</translation>
        </message>
    </context>
    <context>
        <name>slam</name>
        <message>
            <source>the loop closure between %1 that was accepted by hand is not met: %2 m and %3 deg are left. Two loops contradict each other; strike out the wrong one</source>
            <translation>人工接受的%1之间的回环未得到满足：剩余 %2 m 和 %3 度。两个回环互相矛盾；请划去错误的一个</translation>
        </message>
        <message>
            <source>edit %1 (%2) is not applied: %3</source>
            <translation>第 %1 项编辑（%2）未应用：%3</translation>
        </message>
        <message>
            <source>the pose graph has no solution with these loop closures, and the map is that of the odometry; check the ones that were accepted by hand</source>
            <translation>位姿图在这些回环下无解，地图是里程计的地图；请检查人工接受的回环</translation>
        </message>
        <message>
            <source>%1 loop closures that were accepted before contradict the edits and are refused</source>
            <translation>%1 个先前接受的回环与编辑矛盾，已拒绝</translation>
        </message>
        <message>
            <source>%1 loop closures, no edits</source>
            <translation>%1 个回环，没有编辑</translation>
        </message>
        <message>
            <source>%1 of %2 edits applied; %3 loop closures</source>
            <translation>应用了 %2 项编辑中的 %1 项；%3 个回环</translation>
        </message>
        <message>
            <source>frame %1 was not followed; the odometry has frames %2 to %3</source>
            <translation>第 %1 帧未被跟踪；里程计有第 %2 至 %3 帧</translation>
        </message>
        <message>
            <source>slam.run followed no frame</source>
            <translation>slam.run 没有跟踪任何帧</translation>
        </message>
        <message>
            <source>frames %1 and %2 have the same keyframe</source>
            <translation>第 %1 帧与第 %2 帧属于同一关键帧</translation>
        </message>
        <message>
            <source>frames %1 and %2</source>
            <translation>第 %1 帧与第 %2 帧</translation>
        </message>
        <message>
            <source>there is no loop closure within %1 frames of frames %2 and %3</source>
            <translation>第 %2 帧与第 %3 帧前后 %1 帧内没有回环</translation>
        </message>
        <message>
            <source>there is no candidate within %1 frames of frames %2 and %3; give its relative_pose to accept one</source>
            <translation>第 %2 帧与第 %3 帧前后 %1 帧内没有候选；要接受一个，请给出其 relative_pose</translation>
        </message>
        <message>
            <source>refuse</source>
            <translation>划去</translation>
        </message>
        <message>
            <source>from_frame is %1</source>
            <translation>from_frame 为 %1</translation>
        </message>
        <message>
            <source>the number of a frame, from 0 on</source>
            <translation>帧的编号，从 0 起</translation>
        </message>
        <message>
            <source>to_frame is %1</source>
            <translation>to_frame 为 %1</translation>
        </message>
        <message>
            <source>relative_pose is %1</source>
            <translation>relative_pose 为 %1</translation>
        </message>
        <message>
            <source>seven numbers: x, y, z in metres and qx, qy, qz, qw</source>
            <translation>七个数：以米计的 x、y、z 和 qx、qy、qz、qw</translation>
        </message>
        <message>
            <source>one of length 1</source>
            <translation>长度为 1 的四元数</translation>
        </message>
        <message>
            <source>relative_pose has a quaternion of length %1</source>
            <translation>relative_pose 的四元数长度为 %1</translation>
        </message>
        <message>
            <source>from_frame and to_frame are both %1</source>
            <translation>from_frame 和 to_frame 都是 %1</translation>
        </message>
        <message>
            <source>two frames</source>
            <translation>两个帧</translation>
        </message>
        <message>
            <source>%1 frames have measurements of the unit; %2 are needed</source>
            <translation>%1 帧有惯性单元的测量值；需要 %2 帧</translation>
        </message>
        <message>
            <source>the walk turns too little about some axis: the mount is known only to %1 deg</source>
            <translation>行走绕某个轴的转动太少：安装只知道到 %1 度</translation>
        </message>
        <message>
            <source>the rates of the unit explain only %1 % of the turns of the scanner: is it of this recording, and in rad/s?</source>
            <translation>惯性单元的角速度只能解释扫描仪转动的 %1 %：它属于这次记录吗，单位是 rad/s 吗？</translation>
        </message>
        <message>
            <source>looking for loops</source>
            <translation>查找回环</translation>
        </message>
        <message>
            <source>numbers in x_m, y_m, z_m, and a quaternion of length 1 in qx, qy, qz, qw</source>
            <translation>x_m、y_m、z_m 为数，qx、qy、qz、qw 为长度 1 的四元数</translation>
        </message>
        <message>
            <source>row %1 of the table loop_candidates has no pose</source>
            <translation>表 loop_candidates 的第 %1 行没有位姿</translation>
        </message>
        <message>
            <source>row %1 of the table odometry has no pose</source>
            <translation>表 odometry 的第 %1 行没有位姿</translation>
        </message>
        <message>
            <source>Use tables of one run of slam.run</source>
            <translation>请使用同一次 slam.run 的表</translation>
        </message>
        <message>
            <source>a number from 0 to %1</source>
            <translation>0 至 %1 的数</translation>
        </message>
        <message>
            <source>the table loop_candidates has %1 %2</source>
            <translation>表 loop_candidates 有 %1 %2</translation>
        </message>
        <message>
            <source>the table odometry has %1 %2</source>
            <translation>表 odometry 有 %1 %2</translation>
        </message>
        <message>
            <source>the table odometry has no poses</source>
            <translation>表 odometry 没有位姿</translation>
        </message>
        <message>
            <source>the table odometry of slam.run, with x_m to qw</source>
            <translation>slam.run 的表 odometry，含 x_m 至 qw</translation>
        </message>
        <message>
            <source>a row per frame in order of time, as slam.run gives it</source>
            <translation>每帧一行，按时间排序，与 slam.run 给出的相同</translation>
        </message>
        <message>
            <source>the frames of the table odometry are out of order at row %1</source>
            <translation>表 odometry 的帧在第 %1 行次序颠倒</translation>
        </message>
        <message>
            <source>an earlier and a later keyframe</source>
            <translation>一个较早和一个较晚的关键帧</translation>
        </message>
        <message>
            <source>row %1 of the table loop_candidates goes from keyframe %2 to %3</source>
            <translation>表 loop_candidates 的第 %1 行从关键帧 %2 到 %3</translation>
        </message>
        <message>
            <source>closing loops</source>
            <translation>闭合回环</translation>
        </message>
        <message>
            <source>the adjustment of %1 loop closures stopped after %2 iterations without converging</source>
            <translation>%1 个回环的平差在 %2 次迭代后停止，未收敛</translation>
        </message>
        <message>
            <source>the path has %1 poses</source>
            <translation>路径有 %1 个位姿</translation>
        </message>
        <message>
            <source>Sort the poses by time</source>
            <translation>请按时间排列位姿</translation>
        </message>
        <message>
            <source>later than the pose before it</source>
            <translation>晚于前一个位姿</translation>
        </message>
        <message>
            <source>pose %1 has time %2 s</source>
            <translation>第 %1 个位姿的时间为 %2 s</translation>
        </message>
        <message>
            <source>it has no solution</source>
            <translation>它没有解</translation>
        </message>
        <message>
            <source>it would move the path by %1 m</source>
            <translation>它会使路径移动 %1 m</translation>
        </message>
        <message>
            <source>adjusting the path</source>
            <translation>平差路径</translation>
        </message>
        <message>
            <source>a readable TUM file</source>
            <translation>可读的 TUM 文件</translation>
        </message>
        <message>
            <source>the trajectory %1 cannot be opened</source>
            <translation>无法打开轨迹 %1</translation>
        </message>
        <message>
            <source>eight numbers: time x y z qx qy qz qw</source>
            <translation>八个数：time x y z qx qy qz qw</translation>
        </message>
        <message>
            <source>a quaternion of length %1</source>
            <translation>长度为 %1 的四元数</translation>
        </message>
        <message>
            <source>a time after %1 s</source>
            <translation>%1 s 之后的时间</translation>
        </message>
        <message>
            <source>time %1 s</source>
            <translation>时间 %1 s</translation>
        </message>
        <message>
            <source>the trajectory %1 has %2 poses</source>
            <translation>轨迹 %1 有 %2 个位姿</translation>
        </message>
        <message>
            <source>looking for the mount of the inertial unit</source>
            <translation>求惯性单元的安装</translation>
        </message>
        <message>
            <source>the mount of the inertial unit (T_sensor_imu) was not checked: the walk turns too little about some axis, or the turns of unit and scanner do not agree in size. A wrong mount bends the map</source>
            <translation>惯性单元的安装（T_sensor_imu）未检查：行走绕某个轴的转动太少，或惯性单元与扫描仪的转动大小不一致。错误的安装会使地图弯曲</translation>
        </message>
        <message>
            <source>its mount (T_sensor_imu) is given %1 deg off from what the turns of the scanner show; correct it, or leave it out to have it estimated</source>
            <translation>给定的安装（T_sensor_imu）与扫描仪转动所示相差 %1 度；请更正，或不给出而由程序估计</translation>
        </message>
        <message>
            <source>, lever arm to %1 m</source>
            <translation>，杆臂精度 %1 m</translation>
        </message>
        <message>
            <source>; its lever arm cannot be told from this walk (%1 m)</source>
            <translation>；由这次行走无法得知其杆臂（%1 m）</translation>
        </message>
        <message>
            <source>the mount of the inertial unit was not given and is estimated: turn to %1 deg, clock ahead by %2 ms to %3 ms</source>
            <translation>没有给出惯性单元的安装，已作估计：转角精度 %1 度，时钟超前 %2 ms，精度 %3 ms</translation>
        </message>
        <message>
            <source>the mount of the inertial unit was not given and is estimated: turn to %1 deg, clock ahead by %2 ms to %3 ms%4</source>
            <translation>没有给出惯性单元的安装，已作估计：转角精度 %1 度，时钟超前 %2 ms，精度 %3 ms%4</translation>
        </message>
        <message>
            <source>Name its file with the option imu of the scan, or use the preset best</source>
            <translation>请用扫描的选项 imu 指定其文件，或使用预设 best</translation>
        </message>
        <message>
            <source>an inertial unit that fits the scan</source>
            <translation>与扫描相符的惯性单元</translation>
        </message>
        <message>
            <source>the inertial unit cannot be used: %1</source>
            <translation>惯性单元不能使用：%1</translation>
        </message>
        <message>
            <source>the inertial unit is not used: %1</source>
            <translation>未采用惯性单元：%1</translation>
        </message>
        <message>
            <source>Put imu.csv beside the scan, name its file with the option imu of the scan, or use preset best</source>
            <translation>请将 imu.csv 放在扫描旁，用扫描的选项 imu 指定其文件，或使用预设 best</translation>
        </message>
        <message>
            <source>one, with preset inertial</source>
            <translation>预设 inertial 需要一个</translation>
        </message>
        <message>
            <source>the recording has no inertial unit</source>
            <translation>记录没有惯性单元</translation>
        </message>
        <message>
            <source>frames are not elastic</source>
            <translation>帧不是弹性的</translation>
        </message>
        <message>
            <source>its mount in the scanner is not given and cannot be told: %1</source>
            <translation>没有给出其在扫描仪中的安装，也无法得知：%1</translation>
        </message>
        <message>
            <source>for %1 s (until frame %2) the surroundings left a direction of motion open and the inertial unit alone carried it: the map behind may be shifted by %3 m or more. Walk where there are stems, or give control points</source>
            <translation>有 %1 s（至第 %2 帧）周围环境不能确定一个运动方向，只靠惯性单元维持：其后的地图可能偏移 %3 m 或更多。请在有树干的地方行走，或给出控制点</translation>
        </message>
        <message>
            <source>only %1 usable points</source>
            <translation>只有 %1 个可用的点</translation>
        </message>
        <message>
            <source>... and %1 more frames</source>
            <translation>…… 以及另外 %1 帧</translation>
        </message>
        <message>
            <source>frame %1 at %2: %3</source>
            <translation>第 %1 帧，在 %2：%3</translation>
        </message>
        <message>
            <source>%1 points were left out: their ring is not one of the sensor's</source>
            <translation>舍去 %1 个点：其线号不属于该传感器</translation>
        </message>
        <message>
            <source>found again %1 after the last good frame: %2 of the points agree, doubt %3</source>
            <translation>在最后一个良好的帧之后 %1 重新找到：%2 的点一致，疑度 %3</translation>
        </message>
        <message>
            <source>. A frame takes %1, in which a walk bends it: let the scanner turn 10 times a second or more</source>
            <translation>。一帧历时 %1，其间行走会使其弯曲：请让扫描仪每秒旋转 10 圈或更多</translation>
        </message>
        <message>
            <source>the track was lost at frame %1, %2 after the start: %3. The map ends there%4</source>
            <translation>在第 %1 帧（开始后 %2）跟踪丢失：%3。地图到此为止%4</translation>
        </message>
        <message>
            <source>finished on request at frame %1 of %2</source>
            <translation>应要求在 %2 帧中的第 %1 帧结束</translation>
        </message>
        <message>
            <source>left out: %1</source>
            <translation>已舍去：%1</translation>
        </message>
        <message>
            <source>the adjustment of the whole path ended after %1 of %2 iterations: %3; the path before it was kept</source>
            <translation>整条路径的平差在 %2 次迭代中的第 %1 次之后结束：%3；保留平差前的路径</translation>
        </message>
        <message>
            <source>it did not measure while the scanner did</source>
            <translation>它在扫描仪测量时没有测量</translation>
        </message>
        <message>
            <source>it fits only %1 of %2 frames; is its mount in the scanner (T_sensor_imu) right, and its clock that of the scan?</source>
            <translation>它只与 %2 帧中的 %1 帧相符；它在扫描仪中的安装（T_sensor_imu）正确吗，其时钟与扫描的时钟相同吗？</translation>
        </message>
        <message>
            <source>its motion contradicts the scans (tension %1, at most 1 where they agree); is its mount in the scanner (T_sensor_imu) right, and its clock that of the scan?</source>
            <translation>其运动与扫描矛盾（张力 %1，一致时至多为 1）；它在扫描仪中的安装（T_sensor_imu）正确吗，其时钟与扫描的时钟相同吗？</translation>
        </message>
        <message>
            <source>it would have biases of %1 deg/s and %2 m/s2, more than units have; is its mount in the scanner (T_sensor_imu) right?</source>
            <translation>它的零偏将达 %1 度/s 和 %2 m/s2，超过惯性单元的正常范围；它在扫描仪中的安装（T_sensor_imu）正确吗？</translation>
        </message>
        <message>
            <source>%1 of %2 frames (first: %3) hardly determine a motion: their observability is below %4. The preset keeps to a paper that does not test this. Compare the map with one of slam.preset=best before you use it</source>
            <translation>%2 帧中有 %1 帧（第一帧：%3）几乎不能确定运动：其可观测性低于 %4。该预设遵循的论文不作此检验。使用前请将地图与 slam.preset=best 的地图比较</translation>
        </message>
        <message>
            <source>for %1 s (from frame %2) nearly all surfaces face one way, as in a corridor or between walls: the position along (%3, %4) of the map may be wrong by metres, however good the frames look. Walk where there are stems or corners, or give control points</source>
            <translation>有 %1 s（自第 %2 帧起）几乎所有表面都朝同一方向，如在走廊中或墙壁之间：无论各帧看来多好，地图沿 (%3, %4) 方向的位置可能差数米。请在有树干或墙角的地方行走，或给出控制点</translation>
        </message>
        <message>
            <source>Correct its file, or use the preset best</source>
            <translation>请更正其文件，或使用预设 best</translation>
        </message>
        <message>
            <source>a unit that moves with the scanner</source>
            <translation>随扫描仪移动的惯性单元</translation>
        </message>
        <message>
            <source>the inertial unit does not fit the scan: %1</source>
            <translation>惯性单元与扫描不符：%1</translation>
        </message>
        <message>
            <source>%1 of %2 frames could be used</source>
            <translation>%2 帧中有 %1 帧可用</translation>
        </message>
        <message>
            <source>at least 2 frames with returns that fit together</source>
            <translation>至少 2 个回波相符的帧</translation>
        </message>
        <message>
            <source>Add the offset between the clocks to the times in the trajectory; if both began together it is %1 s</source>
            <translation>请将时钟差加到轨迹的时间上；如果两者同时开始，其值为 %1 s</translation>
        </message>
        <message>
            <source>no frame lies within the trajectory: frames from %1 to %2 s, trajectory from %3 to %4 s</source>
            <translation>没有帧在轨迹之内：帧为 %1 至 %2 s，轨迹为 %3 至 %4 s</translation>
        </message>
        <message>
            <source>times of one clock</source>
            <translation>同一时钟的时间</translation>
        </message>
        <message>
            <source>%1 of %2 frames lie outside the trajectory and were left out</source>
            <translation>%2 帧中有 %1 帧在轨迹之外，已舍去</translation>
        </message>
        <message>
            <source>less than max_range, %1 m</source>
            <translation>小于 max_range，即 %1 m</translation>
        </message>
        <message>
            <source>min_range is %1 m</source>
            <translation>min_range 为 %1 m</translation>
        </message>
        <message>
            <source>less than map_max_range, %1 m</source>
            <translation>小于 map_max_range，即 %1 m</translation>
        </message>
        <message>
            <source>map_min_range is %1 m</source>
            <translation>map_min_range 为 %1 m</translation>
        </message>
        <message>
            <source>Set solve to joint, or deskew to once</source>
            <translation>请将 solve 设为 joint，或将 deskew 设为 once</translation>
        </message>
        <message>
            <source>solve is %1 with deskew elastic</source>
            <translation>deskew 为 elastic 时 solve 为 %1</translation>
        </message>
        <message>
            <source>solve joint with elastic frames</source>
            <translation>弹性帧用 solve joint（联合求解）</translation>
        </message>
        <message>
            <source>Set first_guess to velocity, or deskew to once or twice</source>
            <translation>请将 first_guess 设为 velocity，或将 deskew 设为 once 或 twice</translation>
        </message>
        <message>
            <source>another first guess, since elastic frames estimate their motion themselves</source>
            <translation>另一种初值，因为弹性帧自行估计其运动</translation>
        </message>
        <message>
            <source>first_guess is matched_motion with deskew elastic</source>
            <translation>deskew 为 elastic 时 first_guess 为 matched_motion</translation>
        </message>
        <message>
            <source>Set deskew to elastic</source>
            <translation>请将 deskew 设为 elastic</translation>
        </message>
        <message>
            <source>elastic frames, which the inertial unit is joined to</source>
            <translation>与惯性单元结合的弹性帧</translation>
        </message>
        <message>
            <source>inertial is required with deskew %1</source>
            <translation>deskew 为 %1 时 inertial 为 required</translation>
        </message>
        <message>
            <source>mapping frame %1 of %2</source>
            <translation>%2 帧中的第 %1 帧成图</translation>
        </message>
        <message>
            <source>%1 of %2 frames could not be read a second time. They are missing in the map</source>
            <translation>%2 帧中有 %1 帧无法再次读取。地图中缺少它们</translation>
        </message>
        <message>
            <source>the map was thinned to every %1th point to stay below map_max_points, %2 million</source>
            <translation>地图已抽稀为每 %1 点取一点，以不超过 map_max_points，即 %2 百万</translation>
        </message>
        <message>
            <source>Leave the option features to the preset, or set it to sampled</source>
            <translation>请将选项 features 留给预设，或设为 sampled</translation>
        </message>
        <message>
            <source>features %1 need scan lines, and the beams of this scanner never repeat their path</source>
            <translation>features %1 需要扫描线，而此扫描仪的光束从不重复其路径</translation>
        </message>
        <message>
            <source>features sampled</source>
            <translation>features 为 sampled</translation>
        </message>
        <message>
            <source>preset %1 repeats a published method, for comparison. On simulated plots such presets made walks up to 0.5 % too short and bent the map by centimetres: distances are wrong by that, and diameters uncertain. For a survey use preset=best</source>
            <translation>预设 %1 重现已发表的方法，用于比较。在模拟样地上，这类预设使行走路径最多偏短 0.5 %，并使点云弯曲数厘米：距离因此有误，直径不确定。正式调查请用 preset=best</translation>
        </message>
        <message>
            <source>the scan has no frames</source>
            <translation>扫描没有帧</translation>
        </message>
        <message>
            <source>%1 of %2 frames followed along %3 m</source>
            <translation>沿 %3 m 跟踪了 %2 帧中的 %1 帧</translation>
        </message>
        <message>
            <source>%1 of %2 frames followed along %3 m with the given trajectory</source>
            <translation>用给定的轨迹沿 %3 m 跟踪了 %2 帧中的 %1 帧</translation>
        </message>
        <message>
            <source>%1 of %2 frames mapped to %3 points along %4 m</source>
            <translation>%2 帧中有 %1 帧成图，沿 %4 m 得到 %3 个点</translation>
        </message>
        <message>
            <source>%1 of %2 frames mapped to %3 points along %4 m with the given trajectory</source>
            <translation>%2 帧中有 %1 帧用给定的轨迹成图，沿 %4 m 得到 %3 个点</translation>
        </message>
    </context>
    <context>
        <name>steering</name>
        <message>
            <source>speeds is '%1': '%2' is no speed</source>
            <translation>speeds 为“%1”：“%2”不是速度</translation>
        </message>
        <message>
            <source>numbers from 0.1 to 40 km/h</source>
            <translation>0.1 至 40 km/h 的数</translation>
        </message>
        <message>
            <source>Write for instance "3 5 7"</source>
            <translation>例如写成“3 5 7”</translation>
        </message>
        <message>
            <source>speeds is empty</source>
            <translation>speeds 为空</translation>
        </message>
        <message>
            <source>at least one speed in km/h</source>
            <translation>至少一个以 km/h 计的速度</translation>
        </message>
        <message>
            <source>the tractor left line %1 at %2 km/h: %3 m beside it after %4 s</source>
            <translation>拖拉机以 %2 km/h 行驶时偏离了导航线 %1：%4 s 后偏离 %3 m</translation>
        </message>
        <message>
            <source>gains that keep it on the line</source>
            <translation>能使其保持在线上的增益</translation>
        </message>
        <message>
            <source>Lower gain_p or raise preview (stage steering.tune finds both)</source>
            <translation>请减小 gain_p 或增大 preview（步骤 steering.tune 可求出两者）</translation>
        </message>
        <message>
            <source>driving at %1 km/h</source>
            <translation>以 %1 km/h 行驶</translation>
        </message>
        <message>
            <source>%1 drives over %2 lines of %3 m</source>
            <translation>在 %2 条 %3 m 的线上行驶 %1 次</translation>
        </message>
        <message>
            <source>A is (%1, %2) and B is (%3, %4)</source>
            <translation>A 为 (%1, %2)，B 为 (%3, %4)</translation>
        </message>
        <message>
            <source>two places at least 0.1 m apart</source>
            <translation>相距至少 0.1 m 的两处</translation>
        </message>
        <message>
            <source>A and B have latitude and longitude</source>
            <translation>A 和 B 给出的是纬度和经度</translation>
        </message>
        <message>
            <source>the table does not hold A and B</source>
            <translation>表中没有 A 和 B</translation>
        </message>
        <message>
            <source>two rows with x_m and y_m, or a_x_m, a_y_m, b_x_m, b_y_m</source>
            <translation>含有 x_m 和 y_m 的两行，或 a_x_m, a_y_m, b_x_m, b_y_m</translation>
        </message>
        <message>
            <source>Write one row for A and one for B</source>
            <translation>请为 A 和 B 各写一行</translation>
        </message>
        <message>
            <source>A and B are the same row</source>
            <translation>A 和 B 是同一行</translation>
        </message>
        <message>
            <source>a row named A and one named B</source>
            <translation>名为 A 和名为 B 的各一行</translation>
        </message>
        <message>
            <source>corner %1 of the boundary has no place</source>
            <translation>边界的角点 %1 没有位置</translation>
        </message>
        <message>
            <source>a boundary of %1 corners</source>
            <translation>有 %1 个角点的边界</translation>
        </message>
        <message>
            <source>three at the least</source>
            <translation>至少三个</translation>
        </message>
        <message>
            <source>the boundary crosses itself</source>
            <translation>边界自相交</translation>
        </message>
        <message>
            <source>corners in their order along the field</source>
            <translation>沿田块按顺序排列的角点</translation>
        </message>
        <message>
            <source>the boundary encloses no area</source>
            <translation>边界没有围成面积</translation>
        </message>
        <message>
            <source>corners of a field</source>
            <translation>田块的角点</translation>
        </message>
        <message>
            <source>the headland could not be computed</source>
            <translation>无法计算地头</translation>
        </message>
        <message>
            <source>GDAL with GEOS</source>
            <translation>带 GEOS 的 GDAL</translation>
        </message>
        <message>
            <source>a headland of %1 m covers the whole field</source>
            <translation>%1 m 的地头覆盖了整个田块</translation>
        </message>
        <message>
            <source>room for a line within it</source>
            <translation>其中可容纳导航线的空间</translation>
        </message>
        <message>
            <source>Lower headland_passes, or look at the unit of the boundary</source>
            <translation>请减小 headland_passes，或检查边界的单位</translation>
        </message>
        <message>
            <source>%1 lines over a field of %2 m</source>
            <translation>%2 m 的田块上有 %1 条线</translation>
        </message>
        <message>
            <source>Look at the units of the boundary and the width</source>
            <translation>请检查边界的单位和宽度</translation>
        </message>
        <message>
            <source>a line could not be cut at the boundary</source>
            <translation>无法在边界处截断导航线</translation>
        </message>
        <message>
            <source>no line of %1 m fits into the boundary</source>
            <translation>边界内容不下 %1 m 的导航线</translation>
        </message>
        <message>
            <source>a field beside A and B</source>
            <translation>A 和 B 旁的田块</translation>
        </message>
        <message>
            <source>Look at the units of A, B and the boundary, or lower headland_passes and min_length</source>
            <translation>请检查 A、B 和边界的单位，或减小 headland_passes 和 min_length</translation>
        </message>
        <message>
            <source>A, B and the boundary</source>
            <translation>A、B 和边界</translation>
        </message>
        <message>
            <source>%1 lines, %2 m</source>
            <translation>%1 条线，%2 m</translation>
        </message>
        <message>
            <source>an overlap of %1 m and a width of %2 m</source>
            <translation>重叠 %1 m，宽度 %2 m</translation>
        </message>
        <message>
            <source>an overlap below the width</source>
            <translation>小于宽度的重叠</translation>
        </message>
        <message>
            <source>accept is '%1': '%2' is no fix quality</source>
            <translation>accept 为“%1”：“%2”不是定位质量</translation>
        </message>
        <message>
            <source>digits of GGA sentences, 0 to 9</source>
            <translation>GGA 语句中的数字，0 至 9</translation>
        </message>
        <message>
            <source>Write for instance "4 5"</source>
            <translation>例如写成“4 5”</translation>
        </message>
        <message>
            <source>accept is empty</source>
            <translation>accept 为空</translation>
        </message>
        <message>
            <source>at least one fix quality</source>
            <translation>至少一种定位质量</translation>
        </message>
        <message>
            <source>, unknown: %1</source>
            <translation>，未知：%1</translation>
        </message>
        <message>
            <source>unknown: %1</source>
            <translation>未知：%1</translation>
        </message>
        <message>
            <source>the track has no %1, but latitude and longitude</source>
            <translation>轨迹没有 %1，只有纬度和经度</translation>
        </message>
        <message>
            <source>the track has no %1</source>
            <translation>轨迹没有 %1</translation>
        </message>
        <message>
            <source>positions in metres</source>
            <translation>以米计的位置</translation>
        </message>
        <message>
            <source>%1 of %2 fixes have a quality that is not accepted and are left out (%3)</source>
            <translation>%2 个定位点中有 %1 个的质量不被接受，已舍去（%3）</translation>
        </message>
        <message>
            <source>%1 fixes go back in time and are left out: look whether two logs were joined, or the clock was set</source>
            <translation>%1 个定位点的时间倒退，已舍去：请检查是否合并了两份日志，或时钟被调整过</translation>
        </message>
        <message>
            <source>no lever arm is given: positions and errors are those of the antenna, not of the rear axle</source>
            <translation>没有给出杆臂：位置和误差是天线的，而不是后桥的</translation>
        </message>
        <message>
            <source>the lever arm is turned by the direction of motion, which lags in turns and is wrong in reverse</source>
            <translation>杆臂按运动方向旋转，转弯时有滞后，倒车时是错的</translation>
        </message>
        <message>
            <source>headings count from true north and the track does not say by how much grid north differs</source>
            <translation>航向自真北起算，而轨迹没有说明坐标北与之相差多少</translation>
        </message>
        <message>
            <source>roll and pitch are unknown: the antenna is %1 m up and moves the control point by %2 cm per degree of side slope</source>
            <translation>横滚和俯仰未知：天线高 %1 m，横坡每度使控制点移动 %2 cm</translation>
        </message>
        <message>
            <source>filtering fixes</source>
            <translation>定位点滤波</translation>
        </message>
        <message>
            <source>%1 fixes have no heading and are left out</source>
            <translation>%1 个定位点没有航向，已舍去</translation>
        </message>
        <message>
            <source>%1 gaps of more than %2 s: what was driven there is unknown</source>
            <translation>%1 处超过 %2 s 的间断：其间如何行驶未知</translation>
        </message>
        <message>
            <source>%1 fixes lie more than %2 standard deviations from where they were expected; the position jumped %3 times</source>
            <translation>%1 个定位点偏离预期位置超过 %2 倍标准差；位置跳变 %3 次</translation>
        </message>
        <message>
            <source>the fixes are good to about %1 m: passes can be told by them, errors of steering of centimetres cannot</source>
            <translation>定位点的精度约为 %1 m：可据以区分各次行程，但不能得知厘米级的转向误差</translation>
        </message>
        <message>
            <source>none of %1 positions can be used (fix qualities none)</source>
            <translation>%1 个位置都不能使用（没有定位质量）</translation>
        </message>
        <message>
            <source>none of %1 positions can be used (fix qualities %2)</source>
            <translation>%1 个位置都不能使用（定位质量 %2）</translation>
        </message>
        <message>
            <source>positions of the qualities %1</source>
            <translation>质量为 %1 的位置</translation>
        </message>
        <message>
            <source>Change accept, or record with a correction service</source>
            <translation>请修改 accept，或用差分改正服务重新记录</translation>
        </message>
        <message>
            <source>the lever arm needs a heading, and neither the track nor its motion gives one</source>
            <translation>杆臂需要航向，而轨迹及其运动都没有给出</translation>
        </message>
        <message>
            <source>heading_deg, course_deg, attitudes, or a drive of some metres</source>
            <translation>列 heading_deg、course_deg，姿态，或行驶数米</translation>
        </message>
        <message>
            <source>the track gives no fix quality: its fixes are taken to be good to %1 cm</source>
            <translation>轨迹没有给出定位质量：视其定位点精度为 %1 cm</translation>
        </message>
        <message>
            <source>%1 fixes, good to %2 cm; %3 left out</source>
            <translation>%1 个定位点，精度 %2 cm；舍去 %3 个</translation>
        </message>
        <message>
            <source>A, B and the boundary lie in different planes</source>
            <translation>A、B 和边界在不同的投影平面中</translation>
        </message>
        <message>
            <source>log and lines lie in different planes</source>
            <translation>日志和导航线在不同的投影平面中</translation>
        </message>
        <message>
            <source>one plane for both</source>
            <translation>两者采用同一投影平面</translation>
        </message>
        <message>
            <source>Set the same plane and zone for both (stage geo.project)</source>
            <translation>请为两者设置相同的投影平面和投影带（步骤 geo.project）</translation>
        </message>
        <message>
            <source>the attitudes hold no angle</source>
            <translation>姿态中没有角度</translation>
        </message>
        <message>
            <source>roll_deg, pitch_deg, heading_deg or yaw_deg</source>
            <translation>roll_deg、pitch_deg、heading_deg 或 yaw_deg</translation>
        </message>
        <message>
            <source>time_s of the attitudes does not rise at row %1</source>
            <translation>姿态的 time_s 在第 %1 行没有递增</translation>
        </message>
        <message>
            <source>rising times</source>
            <translation>递增的时间</translation>
        </message>
        <message>
            <source>the times of the reference fall</source>
            <translation>参照的时间倒退</translation>
        </message>
        <message>
            <source>rising time_s</source>
            <translation>递增的 time_s</translation>
        </message>
        <message>
            <source>time_s does not rise at row %1 of the log</source>
            <translation>日志的 time_s 在第 %1 行没有递增</translation>
        </message>
        <message>
            <source>rising times within a run</source>
            <translation>在一次行驶内递增的时间</translation>
        </message>
        <message>
            <source>A and B are the same place</source>
            <translation>A 和 B 在同一处</translation>
        </message>
        <message>
            <source>two points of the line</source>
            <translation>线上的两个点</translation>
        </message>
        <message>
            <source>run %1 has no straight stretch of %2 m</source>
            <translation>行驶 %1 没有 %2 m 的直线段</translation>
        </message>
        <message>
            <source>a line to measure against</source>
            <translation>据以测量的线</translation>
        </message>
        <message>
            <source>Give A and B (lines), or lower min_length</source>
            <translation>请给出 A 和 B（lines），或减小 min_length</translation>
        </message>
        <message>
            <source>passes lie up to %1 m beside the line, and no row width says which line they followed: their errors count from that one line. Set row_width</source>
            <translation>行程偏离导航线达 %1 m，而没有行宽说明它们跟随的是哪条线：其误差以这一条线计。请设置 row_width</translation>
        </message>
        <message>
            <source>log and lines</source>
            <translation>日志和导航线</translation>
        </message>
        <message>
            <source>measuring passes</source>
            <translation>测量各次行程</translation>
        </message>
        <message>
            <source>none of %1 fixes is on a pass of %2 m along the line</source>
            <translation>%1 个定位点都不在沿线 %2 m 的行程上</translation>
        </message>
        <message>
            <source>a drive along the line from A to B</source>
            <translation>沿 A 至 B 的线行驶</translation>
        </message>
        <message>
            <source>Check A and B, or lower run_in and min_length</source>
            <translation>请检查 A 和 B，或减小 run_in 和 min_length</translation>
        </message>
        <message>
            <source>no reference: errors are measured with the receiver itself, so its own error is unknown (connect 'reference', or a log with ref_x_m and ref_y_m)</source>
            <translation>没有参照：误差由接收机自身测得，因此其自身的误差未知（请连接“reference”，或含有 ref_x_m 和 ref_y_m 的日志）</translation>
        </message>
        <message>
            <source>no neighbouring passes: no adjacent-row error (set row_width, or drive the next line)</source>
            <translation>没有相邻的行程：没有邻行误差（请设置 row_width，或行驶下一条线）</translation>
        </message>
        <message>
            <source>%1 passes, standard deviation %2 cm</source>
            <translation>%1 次行程，标准差 %2 cm</translation>
        </message>
        <message>
            <source>preview</source>
            <translation>预瞄</translation>
        </message>
        <message>
            <source>the loop oscillates at %1 km/h with any D up to %2</source>
            <translation>D 直到 %2 时，回路在 %1 km/h 下仍振荡</translation>
        </message>
        <message>
            <source>a gain that calms it</source>
            <translation>能使其平稳的增益</translation>
        </message>
        <message>
            <source>Lower first_p or the steering's delay and lag</source>
            <translation>请减小 first_p，或转向的延迟和滞后</translation>
        </message>
        <message>
            <source>no oscillation up to P = %1, where the search ends</source>
            <translation>直到搜索终点 P = %1 仍没有振荡</translation>
        </message>
        <message>
            <source>%1 km/h: preview %2 m, P %3, I %4, D %5 (published %6, %7, %8, %9)</source>
            <translation>%1 km/h：预瞄 %2 m，P %3，I %4，D %5（已发表 %6、%7、%8、%9）</translation>
        </message>
    </context>
    <context>
        <name>stems</name>
        <message>
            <source>one of %1, or the path of a JSON file</source>
            <translation>%1 之一，或 JSON 文件的路径</translation>
        </message>
        <message>
            <source>there is no bark '%1'</source>
            <translation>没有树皮类型“%1”</translation>
        </message>
        <message>
            <source>a bark description in JSON</source>
            <translation>JSON 格式的树皮描述</translation>
        </message>
        <message>
            <source>cannot open '%1'</source>
            <translation>无法打开“%1”</translation>
        </message>
        <message>
            <source>title, and relief_mm and relief_sd_mm from 0 to %1</source>
            <translation>title，以及 0 至 %1 的 relief_mm 和 relief_sd_mm（标题、起伏）</translation>
        </message>
        <message>
            <source>it is not JSON</source>
            <translation>它不是 JSON</translation>
        </message>
        <message>
            <source>some stems are too sparse for diameters here: %1 points on the bark of a stem needed, %2 found in the middle of %3 of %4 stems. Use the cloud before it was thinned, or scan from nearer</source>
            <translation>此处部分单木太稀，不能测直径：每株树皮上需要 %1 个点，%4 株中的 %3 株中间只有 %2 个。请使用抽稀前的点云，或从更近处扫描</translation>
        </message>
        <message>
            <source>too sparse for diameters here: %1 points on the bark of a stem needed, %2 found in the middle of %3 of %4 stems. Use the cloud before it was thinned, or scan from nearer</source>
            <translation>此处太稀，不能测直径：每株树皮上需要 %1 个点，%4 株中的 %3 株中间只有 %2 个。请使用抽稀前的点云，或从更近处扫描</translation>
        </message>
        <message>
            <source>ranges scatter by %1 cm on the bark: diameters are uncertain by +-%2 cm, half of the stems by more. Scan more slowly or from nearer, or check the poses</source>
            <translation>树皮上的距离离散为 %1 cm：直径的不确定度为 +-%2 cm，半数单木更大。请更慢或从更近处扫描，或检查位姿</translation>
        </message>
        <message>
            <source>the points scatter by %1 cm on the bark (median of %2 stems): registrations or passes that do not meet, wind, a noisy sensor, or coordinates in feet. Diameters are of all that together</source>
            <translation>点在树皮上的离散为 %1 cm（%2 株的中位数）：配准或各次经过不重合、风、传感器噪声大，或坐标以英尺计。直径受上述各项的共同影响</translation>
        </message>
        <message>
            <source>%1 of %2 stems were seen on %3 deg of their bark or less, and model=surface leaves out how wide the beam of the scanner was: their diameters can be too large by %4 cm (half of them by more). Give the path of the scanner (trajectory.file, for a cloud with times), or scan from more sides</source>
            <translation>%2 株中有 %1 株只看到树皮的 %3 度或更少，而 model=surface 不考虑扫描仪光束的宽度：其直径可能偏大 %4 cm（其中半数更多）。请给出扫描仪的路径（trajectory.file，用于带时间的点云），或从更多方向扫描</translation>
        </message>
        <message>
            <source>%1 of %2 stems were seen on %3 deg of their bark or less, and model=surface leaves out how wide the beam of the scanner was: their diameters can be too large by %4 cm (half of them by more). Set stems.model=ray</source>
            <translation>%2 株中有 %1 株只看到树皮的 %3 度或更少，而 model=surface 不考虑扫描仪光束的宽度：其直径可能偏大 %4 cm（其中半数更多）。请设置 stems.model=ray</translation>
        </message>
        <message>
            <source>%1 of %2 stems were seen on %3 deg of their bark or less, and nothing says how wide the beam of the scanner was: their diameters can be too large by %4 cm (half of them by more). Give the path of the scanner (trajectory.file, for a cloud with times), or scan from more sides</source>
            <translation>%2 株中有 %1 株只看到树皮的 %3 度或更少，而扫描仪光束的宽度无从得知：其直径可能偏大 %4 cm（其中半数更多）。请给出扫描仪的路径（trajectory.file，用于带时间的点云），或从更多方向扫描</translation>
        </message>
        <message>
            <source>%1 of %2 stems were seen on %3 deg of their bark or less, and nothing says how wide the beam of the scanner was: their diameters can be too large by %4 cm (half of them by more). Set stems.model=ray</source>
            <translation>%2 株中有 %1 株只看到树皮的 %3 度或更少，而扫描仪光束的宽度无从得知：其直径可能偏大 %4 cm（其中半数更多）。请设置 stems.model=ray</translation>
        </message>
        <message>
            <source>%1 mm are added to every diameter for the fissures of the bark (bark=%2), a convention; the intervals allow for +-%3 mm</source>
            <translation>因树皮裂缝给每个直径加上 %1 mm（bark=%2），这是一种约定；区间计入 +-%3 mm</translation>
        </message>
        <message>
            <source>%1 mm are added to every diameter for the fissures of the bark (bark_relief), a convention; the intervals allow for +-%2 mm</source>
            <translation>因树皮裂缝给每个直径加上 %1 mm（bark_relief），这是一种约定；区间计入 +-%2 mm</translation>
        </message>
        <message>
            <source>diameters are those of the mean bark: a tape over rough bark reads more. The intervals allow for +-%1 mm; set stems.bark where it is known</source>
            <translation>直径是平均树皮处的直径：在粗糙的树皮上围尺读数更大。区间计入 +-%1 mm；如果已知树皮类型，请设置 stems.bark</translation>
        </message>
        <message>
            <source>Check what the stage before has read</source>
            <translation>请检查前一步骤读取的内容</translation>
        </message>
        <message>
            <source>points of a plot</source>
            <translation>样地的点</translation>
        </message>
        <message>
            <source>the cloud is empty</source>
            <translation>点云为空</translation>
        </message>
        <message>
            <source>Look at the ground stage: was any ground found?</source>
            <translation>请查看地面步骤：是否找到地面？</translation>
        </message>
        <message>
            <source>a terrain model below the points</source>
            <translation>点以下的地形模型</translation>
        </message>
        <message>
            <source>none of %1 points has a height above ground</source>
            <translation>%1 个点都没有离地高度</translation>
        </message>
        <message>
            <source>Set slice.height within these heights, or check the ground stage</source>
            <translation>请将 slice.height 设在这些高度之内，或检查地面步骤</translation>
        </message>
        <message>
            <source>no point lies %1 to %2 m above ground; heights run from %3 to %4 m</source>
            <translation>离地 %1 至 %2 m 处没有点；高度范围为 %3 至 %4 m</translation>
        </message>
        <message>
            <source>points at breast height</source>
            <translation>胸高处的点</translation>
        </message>
        <message>
            <source>Check options height and thickness of the slice</source>
            <translation>请检查横切面的选项 height 和 thickness</translation>
        </message>
        <message>
            <source>the slice is empty</source>
            <translation>横切面为空</translation>
        </message>
        <message>
            <source>no point of the slice has a height above ground</source>
            <translation>横切面的点都没有离地高度</translation>
        </message>
        <message>
            <source>circles by height</source>
            <translation>按高度查找圆</translation>
        </message>
        <message>
            <source>a stem table without %1</source>
            <translation>单木表缺少 %1</translation>
        </message>
        <message>
            <source>tree_id, x_m, y_m, dbh_cm</source>
            <translation>列 tree_id、x_m、y_m、dbh_cm</translation>
        </message>
        <message>
            <source>applying edits</source>
            <translation>应用编辑</translation>
        </message>
        <message>
            <source>, %1 of %2 edits of points</source>
            <translation>，%2 项点编辑中的 %1 项</translation>
        </message>
        <message>
            <source>edit %1 (%2): %3</source>
            <translation>第 %1 项编辑（%2）：%3</translation>
        </message>
        <message>
            <source>no stem within %1 m of (%2, %3)</source>
            <translation>(%2, %3) 周围 %1 m 内没有单木</translation>
        </message>
        <message>
            <source>no stem within %1 m of (%2, %3), the nearest stands %4 m away</source>
            <translation>(%2, %3) 周围 %1 m 内没有单木，最近的在 %4 m 处</translation>
        </message>
        <message>
            <source>stems %1 and %2 both stand near (%3, %4)</source>
            <translation>单木 %1 和 %2 都位于 (%3, %4) 附近</translation>
        </message>
        <message>
            <source>the diameter was %1 cm and is now %2 cm: look again</source>
            <translation>直径原为 %1 cm，现为 %2 cm：请再查看</translation>
        </message>
        <message>
            <source>the diameter was %1 cm and is now %2 cm</source>
            <translation>直径原为 %1 cm，现为 %2 cm</translation>
        </message>
        <message>
            <source>stem %1 stands there already (%2 m away)</source>
            <translation>单木 %1 已在该处（相距 %2 m）</translation>
        </message>
        <message>
            <source>stem %1 is named twice</source>
            <translation>单木 %1 出现了两次</translation>
        </message>
        <message>
            <source>no circle of bark about this place in the slice; give dbh_cm</source>
            <translation>横切面中此处周围没有树皮的圆；请给出 dbh_cm</translation>
        </message>
        <message>
            <source>no dbh_cm is given and no slice is connected to fit one</source>
            <translation>没有给出 dbh_cm，也没有连接可供拟合的横切面</translation>
        </message>
        <message>
            <source>no point lies in its selection</source>
            <translation>其选区内没有点</translation>
        </message>
        <message>
            <source>no tree for certain within %1 m of (%2, %3): add it, or make the edit again</source>
            <translation>(%2, %3) 周围 %1 m 内没有可确定的树：请添加，或重做该编辑</translation>
        </message>
        <message>
            <source>no point of its selection meets its condition</source>
            <translation>其选区内没有点满足其条件</translation>
        </message>
        <message>
            <source>edit %1 of points (%2) is not applied: %3</source>
            <translation>第 %1 项点编辑（%2）未应用：%3</translation>
        </message>
        <message>
            <source>accept</source>
            <translation>接受</translation>
        </message>
        <message>
            <source>add</source>
            <translation>添加</translation>
        </message>
        <message>
            <source>delete</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>merge</source>
            <translation>合并</translation>
        </message>
        <message>
            <source>move</source>
            <translation>移动</translation>
        </message>
        <message>
            <source>note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>reject</source>
            <translation>拒绝</translation>
        </message>
        <message>
            <source>resize</source>
            <translation>改直径</translation>
        </message>
        <message>
            <source>split</source>
            <translation>拆分</translation>
        </message>
        <message>
            <source>tilt</source>
            <translation>倾斜</translation>
        </message>
        <message>
            <source>into has %1</source>
            <translation>into 含有 %1</translation>
        </message>
        <message>
            <source>{"at": [x, y], "dbh_cm": ...} for every new stem</source>
            <translation>每株新单木的 {"at": [x, y], "dbh_cm": ...}</translation>
        </message>
        <message>
            <source>tree %1: %2 is not measured: %3</source>
            <translation>树 %1：未测%2：%3</translation>
        </message>
        <message>
            <source>only %1 of %2 sections show a circle of at least %3 deg and %4 points; needed: %5</source>
            <translation>%2 个断面中只有 %1 个显示至少 %3 度、%4 个点的圆；需要 %5 个</translation>
        </message>
        <message>
            <source>passes of the walk disagree by %1 cm. In a part of a cloud they are not brought together: diameters are of all passes as they lie</source>
            <translation>行走的各次经过相差 %1 cm。在点云的一部分中不作合并：直径取自未经调整的各次经过</translation>
        </message>
        <message>
            <source>stems.pool_priors makes it</source>
            <translation>它由 stems.pool_priors 生成</translation>
        </message>
        <message>
            <source>the table of priors has %1 rows</source>
            <translation>先验值表有 %1 行</translation>
        </message>
        <message>
            <source>points lie only %1 times as dense at the terrain as 0.3 to 1.3 m above it (ground that was seen: 10 times and more): the cloud was cut above the ground, or the ground was hardly seen. Breast height of all %2 stems is a guess. Give the cloud with its ground, or set ground.method=normalised if z is the height above ground</source>
            <translation>地形处的点密度只有其上 0.3 至 1.3 m 处的 %1 倍（看到地面时为 10 倍或更多）：点云在地面以上被截断，或几乎没有看到地面。全部 %2 株的胸高只是猜测。请给出带地面的点云；如果 z 是离地高度，请设置 ground.method=normalised</translation>
        </message>
        <message>
            <source>%1 of %2 stems %3: %4</source>
            <translation>%2 株中有 %1 株%3：%4</translation>
        </message>
        <message>
            <source>go on well below the terrain</source>
            <translation>一直延伸到地形以下很深</translation>
        </message>
        <message>
            <source>the terrain is not the ground there, breast height is too high. Set ground.method=normalised if z is the height above ground, else lower ground.max_slope or give the cloud with its ground</source>
            <translation>该处的地形不是地面，胸高偏高。如果 z 是离地高度，请设置 ground.method=normalised，否则请减小 ground.max_slope 或给出带地面的点云</translation>
        </message>
        <message>
            <source>begin in the air and no ground was seen below them</source>
            <translation>悬空开始，其下没有看到地面</translation>
        </message>
        <message>
            <source>breast height is uncertain. Give the cloud with its ground, or scan from more sides</source>
            <translation>胸高不确定。请给出带地面的点云，或从更多方向扫描</translation>
        </message>
        <message>
            <source>do not widen at the lowest points of the cloud, and no ground lies there</source>
            <translation>在点云的最低点处没有变粗，且该处没有地面</translation>
        </message>
        <message>
            <source>heights count from those points. If feet are missing, breast height is too high and the diameter too small. Give the tree with some ground around it</source>
            <translation>高度自这些点起算。如果缺少基部，则胸高偏高，直径偏小。请给出带有周围部分地面的树</translation>
        </message>
        <message>
            <source>breast height counts from where these stems begin in the cloud, which may be above the ground. Give the cloud with its ground, or set ground.method=normalised if z is the height above ground</source>
            <translation>胸高自这些单木在点云中开始处起算，可能高于地面。请给出带地面的点云；如果 z 是离地高度，请设置 ground.method=normalised</translation>
        </message>
        <message>
            <source>breast height hangs on an interpolated terrain. Compare the heights of these feet with the plot</source>
            <translation>胸高取决于内插的地形。请将这些基部的高度与样地比对</translation>
        </message>
        <message>
            <source>stand where no ground was seen within 1 m</source>
            <translation>所在处 1 m 内没有看到地面</translation>
        </message>
        <message>
            <source>stem layer</source>
            <translation>树干层</translation>
        </message>
        <message>
            <source>stem %1 of %2</source>
            <translation>%2 株中的第 %1 株</translation>
        </message>
        <message>
            <source>rays through the candidates</source>
            <translation>穿过候选的射线</translation>
        </message>
        <message>
            <source>points of each tree</source>
            <translation>每株树的点</translation>
        </message>
        <message>
            <source>stem curves and crowns</source>
            <translation>干曲线和树冠</translation>
        </message>
        <message>
            <source>tops, volumes and crowns</source>
            <translation>树梢、材积和树冠</translation>
        </message>
        <message>
            <source>the cloud does not say how wide the beam of its sensor is: a divergence of %1 mrad and %2 mm at the sensor are taken, as of a VLP-32C. Set beam_divergence and beam_aperture, or name the sensor when the scan is read</source>
            <translation>点云没有说明其传感器光束的宽度：采用发散角 %1 mrad 和传感器处 %2 mm，与 VLP-32C 相同。请设置 beam_divergence 和 beam_aperture，或在读取扫描时指定传感器</translation>
        </message>
        <message>
            <source>the cloud does not say how wide the beam of its sensor is: a divergence of %1 mrad and %2 mm at the sensor are taken. Set beam_divergence and beam_aperture, or name the sensor when the scan is read</source>
            <translation>点云没有说明其传感器光束的宽度：采用发散角 %1 mrad 和传感器处 %2 mm。请设置 beam_divergence 和 beam_aperture，或在读取扫描时指定传感器</translation>
        </message>
        <message>
            <source>the maker of %1 does not state its beam: %2 mrad of a similar sensor are taken, and the intervals allow for +-%3 mrad. Set beam_divergence where it is known</source>
            <translation>%1 的厂家没有说明其光束：采用类似传感器的 %2 mrad，区间计入 +-%3 mrad。如果已知，请设置 beam_divergence</translation>
        </message>
        <message>
            <source>at least 0.5 m between them</source>
            <translation>两者至少相差 0.5 m</translation>
        </message>
        <message>
            <source>options search_bottom %1 m and search_top %2 m</source>
            <translation>选项 search_bottom 为 %1 m，search_top 为 %2 m</translation>
        </message>
        <message>
            <source>max_dbh above min_dbh</source>
            <translation>max_dbh 大于 min_dbh</translation>
        </message>
        <message>
            <source>options min_dbh %1 cm and max_dbh %2 cm</source>
            <translation>选项 min_dbh 为 %1 cm，max_dbh 为 %2 cm</translation>
        </message>
        <message>
            <source>no stem found: no point lies %1 to %2 m above ground; set search_bottom and search_top to heights that the cloud has</source>
            <translation>没有找到单木：离地 %1 至 %2 m 处没有点；请将 search_bottom 和 search_top 设为点云所具有的高度</translation>
        </message>
        <message>
            <source>no stem found: %1 points between %2 and %3 m, but no circle of %4 deg among them; lower min_arc or min_dbh, or change the search heights</source>
            <translation>没有找到单木：%2 至 %3 m 之间有 %1 个点，但其中没有达到 %4 度的圆；请减小 min_arc 或 min_dbh，或改变搜索高度</translation>
        </message>
        <message>
            <source>no stem found: %1 circles, none of them at min_sections = %2 heights above one another; lower it, or widen search_bottom to search_top</source>
            <translation>没有找到单木：有 %1 个圆，但没有一处在 min_sections = %2 个高度上重叠；请减小它，或扩大 search_bottom 至 search_top 的范围</translation>
        </message>
        <message>
            <source>no stem found: all %1 candidates were rejected; the table 'rejected' says why</source>
            <translation>没有找到单木：全部 %1 个候选都被拒绝；原因见表“rejected”</translation>
        </message>
        <message>
            <source>%1 stems, %2 to check, %3 candidates rejected</source>
            <translation>%1 株单木，%2 株待查，拒绝 %3 个候选</translation>
        </message>
        <message>
            <source>model is 'ray' but no sensor position is known: the surface distance was used. Give sensor_x, sensor_y, sensor_z, or time with a trajectory</source>
            <translation>model 为“ray”，但没有已知的传感器位置：采用到表面的距离。请给出 sensor_x、sensor_y、sensor_z，或时间和轨迹</translation>
        </message>
        <message>
            <source>points lie %1 % of their range too far from their sensor: stems lie at other places when they are seen from far than from near. Diameters are corrected for it. Where the walk is at fault and not the ranges, distances between stems are wrong by as much: compare with control points</source>
            <translation>点到传感器的距离偏远 %1 %：从远处看到的单木与从近处看到的位置不同。直径已作相应校正。如果误差来自行走路径而非测距，单木间的距离也有同样比例的误差：请与控制点比较</translation>
        </message>
        <message>
            <source>points lie %1 % of their range too near to their sensor: stems lie at other places when they are seen from far than from near. Diameters are corrected for it. Where the walk is at fault and not the ranges, distances between stems are wrong by as much: compare with control points</source>
            <translation>点到传感器的距离偏近 %1 %：从远处看到的单木与从近处看到的位置不同。直径已作相应校正。如果误差来自行走路径而非测距，单木间的距离也有同样比例的误差：请与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too short in the map: stems lie at other places when they are seen from far than from near. Cloud and stems were made to fit the ranges; the trajectory, the terrain and the targets stay as they were. Run SLAM with another preset, or compare with control points</source>
            <translation>点云中的行走路径偏短 %1 %：从远处看到的单木与从近处看到的位置不同。点云与单木已按测距作相应校正；轨迹、地形和标靶保持不变。请用另一预设运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too short in the map of SLAM: %2 cm in 30 m. Cloud and stems were made to fit the ranges; trajectory, terrain and targets were not. Run SLAM with preset=best, or compare with control points</source>
            <translation>SLAM 点云中的行走路径偏短 %1 %：每 30 m 相差 %2 cm。点云与单木已按测距校正；轨迹、地形和标靶未校正。请以 preset=best 运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too short in the map, and distances between stems with it: %2 cm in 30 m, and %3 % in values per hectare. Run SLAM with preset=best, or compare with control points</source>
            <translation>点云中的行走路径偏短 %1 %，单木间的距离也随之偏短：每 30 m 相差 %2 cm，每公顷数值相差 %3 %。请以 preset=best 运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too long in the map: stems lie at other places when they are seen from far than from near. Cloud and stems were made to fit the ranges; the trajectory, the terrain and the targets stay as they were. Run SLAM with another preset, or compare with control points</source>
            <translation>点云中的行走路径偏长 %1 %：从远处看到的单木与从近处看到的位置不同。点云与单木已按测距作相应校正；轨迹、地形和标靶保持不变。请用另一预设运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too long in the map of SLAM: %2 cm in 30 m. Cloud and stems were made to fit the ranges; trajectory, terrain and targets were not. Run SLAM with preset=best, or compare with control points</source>
            <translation>SLAM 点云中的行走路径偏长 %1 %：每 30 m 相差 %2 cm。点云与单木已按测距校正；轨迹、地形和标靶未校正。请以 preset=best 运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>the walk is %1 % too long in the map, and distances between stems with it: %2 cm in 30 m, and %3 % in values per hectare. Run SLAM with preset=best, or compare with control points</source>
            <translation>点云中的行走路径偏长 %1 %，单木间的距离也随之偏长：每 30 m 相差 %2 cm，每公顷数值相差 %3 %。请以 preset=best 运行 SLAM，或与控制点比较</translation>
        </message>
        <message>
            <source>length of the walk</source>
            <translation>行走路径的长度</translation>
        </message>
        <message>
            <source>no stems were measured along rays</source>
            <translation>没有沿射线测定的单木</translation>
        </message>
        <message>
            <source>fit</source>
            <translation>拟合</translation>
        </message>
        <message>
            <source>gather points</source>
            <translation>收集点</translation>
        </message>
        <message>
            <source>measure distances</source>
            <translation>测量距离</translation>
        </message>
        <message>
            <source>passes of the walk disagree by %1 cm: they were brought together by the stems</source>
            <translation>行走的各次经过相差 %1 cm：已由单木使其重合</translation>
        </message>
        <message>
            <source>a point of the outline is no number</source>
            <translation>轮廓的一个点不是数</translation>
        </message>
        <message>
            <source>a point of the tree lies more than 1 km from its stem, or one of both has no place</source>
            <translation>树的一个点距其树干超过 1 km，或两者之一没有位置</translation>
        </message>
        <message>
            <source>the crown</source>
            <translation>树冠</translation>
        </message>
        <message>
            <source>the stem curve</source>
            <translation>干曲线</translation>
        </message>
        <message>
            <source>the volume</source>
            <translation>材积</translation>
        </message>
        <message>
            <source>the cloud ends at the highest points of %1 of %2 trees, where the stems around them are still thick: their heights are lower bounds, without volume. Give the cloud with its tops, or scan from further away</source>
            <translation>%2 株中有 %1 株，点云在其最高点处结束，而周围树干在该处仍很粗：其高度为下限，没有材积。请给出带树梢的点云，或从更远处扫描</translation>
        </message>
        <message>
            <source>the cloud ends at the highest points of %1 of %2 trees: it was cut at z = %3 m; their heights are lower bounds, without volume. Give the cloud with its tops</source>
            <translation>%2 株中有 %1 株，点云在其最高点处结束：点云在 z = %3 m 处被截断；其高度为下限，没有材积。请给出带树梢的点云</translation>
        </message>
        <message>
            <source>the cloud ends at the highest points of %1 of %2 trees: it was cut %3 m above the ground; their heights are lower bounds, without volume. Give the cloud with its tops</source>
            <translation>%2 株中有 %1 株，点云在其最高点处结束：点云在离地 %3 m 处被截断；其高度为下限，没有材积。请给出带树梢的点云</translation>
        </message>
        <message>
            <source>evidence of %1 stems</source>
            <translation>%1 株单木的证据</translation>
        </message>
        <message>
            <source>priors of %1 stems</source>
            <translation>%1 株单木的先验值</translation>
        </message>
        <message>
            <source>%1 points, %2 trees</source>
            <translation>%1 个点，%2 株树</translation>
        </message>
        <message>
            <source>%1 points at %2 m above ground</source>
            <translation>离地 %2 m 处有 %1 个点</translation>
        </message>
    </context>
    <context>
        <name>survey</name>
        <message>
            <source>. Go to (%1, %2), %3 m from the centre at %4 deg from north</source>
            <translation>。请到 (%1, %2)，距中心 %3 m，方位 %4 度</translation>
        </message>
        <message>
            <source>look</source>
            <translation>查看</translation>
        </message>
        <message>
            <source>sign</source>
            <translation>签字</translation>
        </message>
        <message>
            <source>walk again</source>
            <translation>重走</translation>
        </message>
        <message>
            <source>Connect a cloud or a stem table</source>
            <translation>请连接点云或单木表</translation>
        </message>
        <message>
            <source>at least one of them</source>
            <translation>至少其中之一</translation>
        </message>
        <message>
            <source>neither points nor stems are connected</source>
            <translation>点和单木都未连接</translation>
        </message>
        <message>
            <source>Measuring the cells</source>
            <translation>测量各单元</translation>
        </message>
        <message>
            <source>Measuring the stems</source>
            <translation>测量单木</translation>
        </message>
        <message>
            <source>Looking for stems that are not in the table</source>
            <translation>查找表中没有的单木</translation>
        </message>
        <message>
            <source>%1: %2 reasons in %3 m2</source>
            <translation>%1：%3 m2 中有 %2 条理由</translation>
        </message>
        <message>
            <source>level</source>
            <translation>水平</translation>
        </message>
        <message>
            <source>there is no stem table</source>
            <translation>没有单木表</translation>
        </message>
        <message>
            <source>fewer than 5 stems with a lean</source>
            <translation>有倾斜值的单木不足 5 株</translation>
        </message>
        <message>
            <source>the stems lean by %1 deg together, and z is up by gravity to %2 deg: the stand leans, not the frame</source>
            <translation>单木共同倾斜 %1 度，而按重力 z 轴竖直到 %2 度：倾斜的是林分，不是坐标框架</translation>
        </message>
        <message>
            <source>the stems lean by %1 +- %2 deg together, towards %3 deg from north: the frame is tilted, or the whole stand leans. A tilt moves stems by %4 cm at breast height and terrain by %5 cm over 10 m. Level by the stems (level=stems), or check the slope by hand</source>
            <translation>单木共同倾斜 %1 +- %2 度，朝向北偏 %3 度：坐标框架倾斜，或整个林分倾斜。倾斜使单木在胸高处移动 %4 cm，使地形在 10 m 上变化 %5 cm。请按单木整平（level=stems），或实地检查坡度</translation>
        </message>
        <message>
            <source>targets</source>
            <translation>标靶</translation>
        </message>
        <message>
            <source>targets are not connected</source>
            <translation>未连接标靶</translation>
        </message>
        <message>
            <source>none are needed (targets=0)</source>
            <translation>不需要标靶（targets=0）</translation>
        </message>
        <message>
            <source>%1 of %2 targets were found (%3): north of the plot is not known. Say targets=%4 if no more stood there</source>
            <translation>找到 %2 个标靶中的 %1 个（%3）：样地的北方向未知。如果实地只有这些，请设置 targets=%4</translation>
        </message>
        <message>
            <source>%1 of %2 targets were found (%3): origin and north of the plot are not known. Say targets=%4 if no more stood there</source>
            <translation>找到 %2 个标靶中的 %1 个（%3）：样地的原点和北方向未知。如果实地只有这些，请设置 targets=%4</translation>
        </message>
        <message>
            <source>%1 of %2 targets were found: north of the plot is not known. Say targets=%3 if no more stood there</source>
            <translation>找到 %2 个标靶中的 %1 个：样地的北方向未知。如果实地只有这些，请设置 targets=%3</translation>
        </message>
        <message>
            <source>%1 of %2 targets were found: origin and north of the plot are not known. Say targets=%3 if no more stood there</source>
            <translation>找到 %2 个标靶中的 %1 个：样地的原点和北方向未知。如果实地只有这些，请设置 targets=%3</translation>
        </message>
        <message>
            <source>distance of the targets</source>
            <translation>标靶间的距离</translation>
        </message>
        <message>
            <source>the distance by tape is not given</source>
            <translation>没有给出卷尺量得的距离</translation>
        </message>
        <message>
            <source>the targets stand %1 m apart in the map and %2 m by tape (%3 m): the map is bent, or something else was taken for a target</source>
            <translation>标靶在地图中相距 %1 m，卷尺量得 %2 m（%3 m）：地图弯曲，或误将别的东西当作标靶</translation>
        </message>
        <message>
            <source>there are no loop closures or no trajectory</source>
            <translation>没有回环或没有轨迹</translation>
        </message>
        <message>
            <source>none were found, or the poses were given</source>
            <translation>没有找到回环，或位姿是给定的</translation>
        </message>
        <message>
            <source>%1 lie outside of the trajectory</source>
            <translation>%1 个位于轨迹之外</translation>
        </message>
        <message>
            <source>%1 of %2 loop closures disagree with the final trajectory, by up to %3 m and %4 deg: one of them is wrong, or the map is strained. Run slam again without it</source>
            <translation>%2 个回环中有 %1 个与最终轨迹不一致，最大达 %3 m 和 %4 度：其中一个有误，或地图受到拉扯。请去掉它重新运行 slam</translation>
        </message>
        <message>
            <source>ground, density and directions of view</source>
            <translation>地面、密度和观测方向</translation>
        </message>
        <message>
            <source>there is no cloud</source>
            <translation>没有点云</translation>
        </message>
        <message>
            <source>cover</source>
            <translation>覆盖情况</translation>
        </message>
        <message>
            <source>no cell lies in the plot</source>
            <translation>样地中没有单元</translation>
        </message>
        <message>
            <source>ground seen</source>
            <translation>看到的地面</translation>
        </message>
        <message>
            <source>the points have no heights above the ground</source>
            <translation>点没有离地高度</translation>
        </message>
        <message>
            <source>directions of view</source>
            <translation>观测方向</translation>
        </message>
        <message>
            <source>the cloud does not know from where its points were seen</source>
            <translation>点云不含其点的观测位置</translation>
        </message>
        <message>
            <source>%1the ground of %2 % of the plot was never seen (%3 % hold no point at all); the largest hole has %4 m2. Terrain, heights and stems are guesses there</source>
            <translation>%1样地有 %2 % 的地面从未看到（%3 % 完全没有点）；最大的空洞为 %4 m2。该处的地形、高度和单木只是猜测</translation>
        </message>
        <message>
            <source>%1the ground of %2 % of the surveyed area was never seen (%3 % hold no point at all); the largest hole has %4 m2. Terrain, heights and stems are guesses there</source>
            <translation>%1调查区域有 %2 % 的地面从未看到（%3 % 完全没有点）；最大的空洞为 %4 m2。该处的地形、高度和单木只是猜测</translation>
        </message>
        <message>
            <source>%1 % of the plot have fewer ground points than %2 % of the usual %3 per cell of %4 m: seen from afar or through leaves only</source>
            <translation>样地有 %1 % 的地面点少于通常值的 %2 %（每个 %4 m 的单元 %3 个）：只从远处或透过枝叶看到</translation>
        </message>
        <message>
            <source>%1 % of the plot were seen from one side only (directions of view within %2 deg): diameters there rest on one side of the stems</source>
            <translation>样地有 %1 % 只从一侧看到（观测方向在 %2 度以内）：该处的直径只依据树干的一侧</translation>
        </message>
        <message>
            <source>places that were not walked</source>
            <translation>没有走到的地方</translation>
        </message>
        <message>
            <source>there is no trajectory</source>
            <translation>没有轨迹</translation>
        </message>
        <message>
            <source>the plot has no boundary</source>
            <translation>样地没有边界</translation>
        </message>
        <message>
            <source>%1 % of the plot lie farther from the walk than %2 m (%3 m at the rim), up to %4 m, while three quarters of it lie within %5 m: a lane was left out. Walk it</source>
            <translation>样地有 %1 % 距行走路线超过 %2 m（边缘处 %3 m），最远 %4 m，而四分之三在 %5 m 以内：漏走了一条线。请补走</translation>
        </message>
        <message>
            <source>stems of two passes lie %1 cm apart (median of %2 places), more than %3 cm in %4 % of them: passes do not meet. Look for a loop closure that slipped, and run slam again without it</source>
            <translation>两次经过的单木相距 %1 cm（%2 处的中位数），其中 %4 % 超过 %3 cm：各次经过不重合。请查找错误的回环，去掉它重新运行 slam</translation>
        </message>
        <message>
            <source>the ground of two passes lie %1 cm apart (median of %2 places), more than %3 cm in %4 % of them: passes do not meet. Look for a loop closure that slipped, and run slam again without it</source>
            <translation>两次经过的地面相距 %1 cm（%2 处的中位数），其中 %4 % 超过 %3 cm：各次经过不重合。请查找错误的回环，去掉它重新运行 slam</translation>
        </message>
        <message>
            <source>%1 pairs of stems of like diameter stand %2 m apart in the same direction: parts of the walk were mapped beside each other, and trees stand there twice. Run slam again, or walk again</source>
            <translation>%1 对直径相近的单木在同一方向上相距 %2 m：行走的几段被并排成图，树木在该处出现两次。请重新运行 slam，或重走</translation>
        </message>
        <message>
            <source>fewer than 4 stems have enough points on their bark</source>
            <translation>树皮上点数足够的单木不足 4 株</translation>
        </message>
        <message>
            <source>walls</source>
            <translation>树干壁</translation>
        </message>
        <message>
            <source>the points scatter by %1 cm about the bark (median of %2 stems; %3 % above %4 cm): walls are doubled or blurred. Diameters allow for an even blur, not for doubled walls: look at sections of some stems, and measure these in the field</source>
            <translation>点在树皮附近的离散为 %1 cm（%2 株的中位数；%3 % 超过 %4 cm）：树干壁重影或模糊。直径已考虑均匀的模糊，但未考虑重影：请查看若干单木的断面，并到实地量测这些单木</translation>
        </message>
        <message>
            <source>passes</source>
            <translation>各次经过</translation>
        </message>
        <message>
            <source>the cloud does not tell passes apart (no pass, no time)</source>
            <translation>点云不区分各次经过（没有 pass，没有 time）</translation>
        </message>
        <message>
            <source>the ground</source>
            <translation>地面</translation>
        </message>
        <message>
            <source>hardly any place was seen in two passes</source>
            <translation>几乎没有地方被两次经过看到</translation>
        </message>
        <message>
            <source>%1 and %2 more</source>
            <translation>%1 及另外 %2 个</translation>
        </message>
        <message>
            <source>%1 pairs of stems stand in each other (%2): one tree twice, or a fork below breast height</source>
            <translation>%1 对单木互相重叠（%2）：同一株计了两次，或在胸高以下分叉</translation>
        </message>
        <message>
            <source>no ground was seen within 1 m of %1 of %2 stems (%3): their breast height and height rest on terrain that was filled in</source>
            <translation>%2 株中有 %1 株（%3）周围 1 m 内没有看到地面：其胸高和树高依据填补的地形</translation>
        </message>
        <message>
            <source>the tops of %1 of %2 stems were not seen: their heights are lower bounds</source>
            <translation>%2 株中有 %1 株没有看到树梢：其高度为下限</translation>
        </message>
        <message>
            <source>the cloud shows no bark where %1 stems of the table stand (%2): table and map do not belong together there</source>
            <translation>表中 %1 株单木（%2）所在处点云没有树皮：该处的表与地图不相符</translation>
        </message>
        <message>
            <source>%1 trees stand so near the boundary that in or out is in doubt (%2; rule: %3): %4 % of the basal area. Decide them by tape</source>
            <translation>%1 株树离边界太近，在内在外有疑（%2；规则：%3）：占断面积的 %4 %。请用卷尺判定</translation>
        </message>
        <message>
            <source>by the rule %1 %2 trees fall otherwise than in the values of the plot, which count by the centre at breast height: %3. Reject those that are out (stems.edit), and add the others</source>
            <translation>按规则 %1，%2 株树的归属与样地统计值不同，后者按胸高处的中心计：%3。请拒绝在外的（stems.edit），并添加其余的</translation>
        </message>
        <message>
            <source>the table has no stem in the plot</source>
            <translation>表中样地内没有单木</translation>
        </message>
        <message>
            <source>%1 upright round structures have no stem in the table (the thickest about %2 cm): trees may be left out</source>
            <translation>%1 个直立的圆形结构在表中没有单木（最粗约 %2 cm）：可能漏了树</translation>
        </message>
        <message>
            <source>trees on the boundary</source>
            <translation>边界上的树</translation>
        </message>
        <message>
            <source>(%1, %2, %3) with %4 points</source>
            <translation>(%1, %2, %3)，%4 个点</translation>
        </message>
        <message>
            <source>%1 targets were found but no two of them are %2 +- %3 m apart (distances: %4 m)</source>
            <translation>找到 %1 个标靶，但没有两个相距 %2 +- %3 m（距离：%4 m）</translation>
        </message>
        <message>
            <source>%1 targets were found but no two of them are %2 m or more apart (distances: %3 m)</source>
            <translation>找到 %1 个标靶，但没有两个相距 %2 m 或更远（距离：%3 m）</translation>
        </message>
        <message>
            <source>one target at %1 gives the origin; the heading of the map was kept, since it takes two targets to tell north</source>
            <translation>位于 %1 的一个标靶给出原点；地图的方位保持不变，因为需要两个标靶才能得知北方向</translation>
        </message>
        <message>
            <source>there is no trajectory to tell which target is the centre: %1, seen from more positions, was taken for it</source>
            <translation>没有轨迹来判断哪个标靶是中心：取从更多位置看到的 %1</translation>
        </message>
        <message>
            <source>%1 pairs of targets are possible: %2 was taken for the centre and %3 for the north; target_distance would tell</source>
            <translation>可能的标靶对有 %1 个：取 %2 为中心，%3 为北；target_distance 可以确定</translation>
        </message>
        <message>
            <source>edit %1 (%2) changes nothing: its selection holds none of %3 points. The cloud or its axes are not those that it was made with: delete the edit or make it again</source>
            <translation>第 %1 项编辑（%2）没有改变任何内容：其选区不含 %3 个点中的任何一个。点云或其坐标轴与作编辑时不同：请删除该编辑或重做</translation>
        </message>
        <message>
            <source>%1 edits of points</source>
            <translation>%1 项点编辑</translation>
        </message>
        <message>
            <source>Give the points the names of targets (centre, north), or x_m and y_m beside them</source>
            <translation>请以标靶的名称（centre、north）命名各点，或在旁给出 x_m 和 y_m</translation>
        </message>
        <message>
            <source>no control point has both coordinates and a place in the map</source>
            <translation>没有控制点既有坐标又有在地图中的位置</translation>
        </message>
        <message>
            <source>two points, or one and a bearing</source>
            <translation>两个点，或一个点和方位角</translation>
        </message>
        <message>
            <source>Measure a second point, or set bearing</source>
            <translation>请测量第二个点，或设置 bearing</translation>
        </message>
        <message>
            <source>there is one control point ('%1'): it gives no direction</source>
            <translation>只有一个控制点（“%1”）：不能给出方向</translation>
        </message>
        <message>
            <source>Measure a point at the other end of the plot</source>
            <translation>请在样地另一端测量一个点</translation>
        </message>
        <message>
            <source>points more than %1 m apart, or a bearing</source>
            <translation>相距超过 %1 m 的点，或方位角</translation>
        </message>
        <message>
            <source>the control points lie within %1 m of one another in the map: they give no direction</source>
            <translation>控制点在地图中彼此相距不到 %1 m：不能给出方向</translation>
        </message>
        <message>
            <source>Exchange the two columns, or check which point has which name</source>
            <translation>请交换两列，或检查各点的名称是否对应</translation>
        </message>
        <message>
            <source>the control points fit the map only when it is mirrored (residuals %1 m, mirrored %2 m)</source>
            <translation>控制点只有在地图成镜像时才相符（残差 %1 m，镜像时 %2 m）</translation>
        </message>
        <message>
            <source>the easting in easting_m and the northing in northing_m</source>
            <translation>东坐标在 easting_m，北坐标在 northing_m</translation>
        </message>
        <message>
            <source>the bearing differs by %1 deg from the direction of the control points (standard deviation %2 deg) and is not used. Check declination, its sign, and which point is which</source>
            <translation>方位角与控制点的方向相差 %1 度（标准差 %2 度），未采用。请检查磁偏角及其符号，以及各点是否对应</translation>
        </message>
        <message>
            <source>control point '%1' lies %2 m from where the others put it (limit %3 m), but an error of %4 would explain it as well: too few points to tell. Measure them again, or add one</source>
            <translation>控制点“%1”偏离其余各点所定的位置 %2 m（限差 %3 m），但 %4 的误差同样可以解释：点数太少，无法判断。请重新测量，或增加一个</translation>
        </message>
        <message>
            <source>control point '%1' lies %2 m from where the others put it (limit %3 m). Check its coordinates, its name and its place in the map</source>
            <translation>控制点“%1”偏离其余各点所定的位置 %2 m（限差 %3 m）。请检查其坐标、名称和在地图中的位置</translation>
        </message>
        <message>
            <source>control point '%1' lies %2 m from where the others put it (limit %3 m): it is left out. Check its coordinates, its name and its place in the map</source>
            <translation>控制点“%1”偏离其余各点所定的位置 %2 m（限差 %3 m）：已剔除。请检查其坐标、名称和在地图中的位置</translation>
        </message>
        <message>
            <source>the control points have no heights: heights stay those of the plot</source>
            <translation>控制点没有高程：高度保持为样地的高度</translation>
        </message>
        <message>
            <source>the heights of the control points are not used: the map has no height for them</source>
            <translation>未采用控制点的高程：地图没有对应的高度</translation>
        </message>
        <message>
            <source>the height of control point '%1' is %2 m off where the others put it. Check its height, and whether it was measured on the target or on the ground (height_of)</source>
            <translation>控制点“%1”的高程偏离其余各点所定的值 %2 m。请检查其高程，以及是在标靶上还是在地面上测量的（height_of）</translation>
        </message>
        <message>
            <source>the height of control point '%1' is %2 m off where the others put it: it is left out. Check its height, and whether it was measured on the target or on the ground (height_of)</source>
            <translation>控制点“%1”的高程偏离其余各点所定的值 %2 m：已剔除。请检查其高程，以及是在标靶上还是在地面上测量的（height_of）</translation>
        </message>
        <message>
            <source>the residuals of the control heights are %1 times as large as height_sd says</source>
            <translation>控制点高程的残差是 height_sd 所示的 %1 倍</translation>
        </message>
        <message>
            <source>the %1 points with control heights lie on a line: they cannot level the plot, whose level is kept (%2 deg). Measure one to the side, or set level=false</source>
            <translation>有高程的 %1 个控制点在一条直线上：不能用来整平样地，样地的水平保持不变（%2 度）。请在旁侧再测一个，或设置 level=false</translation>
        </message>
        <message>
            <source>the control heights tilt the plot by %1 deg +- %2, more than its level was thought to be off (level_sd %3 deg). They were followed; if a height is wrong, correct it or set level=false</source>
            <translation>控制点高程使样地倾斜 %1 度 +- %2，超过预计的水平偏差（level_sd %3 度）。已采用；如果某个高程有误，请更正，或设置 level=false</translation>
        </message>
        <message>
            <source>Check the heights, and whether they were measured on the target or on the ground (height_of)</source>
            <translation>请检查高程，以及是在标靶上还是在地面上测量的（height_of）</translation>
        </message>
        <message>
            <source>a control height is %1 m off the adjusted plot</source>
            <translation>一个控制点高程偏离平差后的样地 %1 m</translation>
        </message>
        <message>
            <source>residuals of at most %1 m (max_residual)</source>
            <translation>残差至多 %1 m（max_residual）</translation>
        </message>
        <message>
            <source>row %1</source>
            <translation>第 %1 行</translation>
        </message>
        <message>
            <source>Transform them to one zone</source>
            <translation>请将它们转换到同一投影带</translation>
        </message>
        <message>
            <source>all points in one coordinate system</source>
            <translation>所有点在同一坐标系中</translation>
        </message>
        <message>
            <source>the control points '%1' and '%2' are of different zones (%3 %4 and %5)</source>
            <translation>控制点“%1”和“%2”属于不同的投影带（%3 %4 和 %5）</translation>
        </message>
        <message>
            <source>Transform them to one zone, and check that none has its axes exchanged</source>
            <translation>请将它们转换到同一投影带，并检查没有点的坐标轴被交换</translation>
        </message>
        <message>
            <source>all points in one zone</source>
            <translation>所有点在同一投影带中</translation>
        </message>
        <message>
            <source>the point '%1' with easting %2 and northing %3 m lies far outside %4, the others do not (%5 of %6 points)</source>
            <translation>东坐标 %2、北坐标 %3 m 的点“%1”远在 %4 之外，其余的点则不然（%6 个点中的 %5 个）</translation>
        </message>
        <message>
            <source>Exchange the two columns</source>
            <translation>请交换两列</translation>
        </message>
        <message>
            <source>the point '%1' with easting %2 and northing %3 m lies far outside %4; with easting and northing exchanged it lies within</source>
            <translation>东坐标 %2、北坐标 %3 m 的点“%1”远在 %4 之外；交换东坐标和北坐标后在其内</translation>
        </message>
        <message>
            <source>Take the first digits away, or set crs to the system with them (EPSG:4647 for UTM 32)</source>
            <translation>请去掉前几位数字，或将 crs 设为带带号的坐标系（UTM 32 为 EPSG:4647）</translation>
        </message>
        <message>
            <source>eastings without the number of the zone</source>
            <translation>不含带号的东坐标</translation>
        </message>
        <message>
            <source>the point '%1' with easting %2 and northing %3 m lies far outside %4; the zone number %5 stands before its easting</source>
            <translation>东坐标 %2、北坐标 %3 m 的点“%1”远在 %4 之外；其东坐标前带有带号 %5</translation>
        </message>
        <message>
            <source>Check crs and the units of the file (metres)</source>
            <translation>请检查 crs 和文件的单位（米）</translation>
        </message>
        <message>
            <source>the point '%1' with easting %2 and northing %3 m lies far outside %4</source>
            <translation>东坐标 %2、北坐标 %3 m 的点“%1”远在 %4 之外</translation>
        </message>
        <message>
            <source>the latitude in latitude_deg and the longitude in longitude_deg</source>
            <translation>纬度在 latitude_deg，经度在 longitude_deg</translation>
        </message>
        <message>
            <source>the point '%1' with latitude %2 and longitude %3 deg lies far outside %4; with latitude and longitude exchanged it lies within</source>
            <translation>纬度 %2、经度 %3 度的点“%1”远在 %4 之外；交换纬度和经度后在其内</translation>
        </message>
        <message>
            <source>Check crs, and the sign of western longitudes</source>
            <translation>请检查 crs，以及西经的符号</translation>
        </message>
        <message>
            <source>positions where the system is used</source>
            <translation>该坐标系适用范围内的位置</translation>
        </message>
        <message>
            <source>the point '%1' with latitude %2 and longitude %3 deg lies far outside %4</source>
            <translation>纬度 %2、经度 %3 度的点“%1”远在 %4 之外</translation>
        </message>
        <message>
            <source>Choose the system of today (UTM of ETRS89: EPSG:258xx), or transform the points and give easting_m and northing_m</source>
            <translation>请选择现行坐标系（ETRS89 的 UTM：EPSG:258xx），或转换各点并给出 easting_m 和 northing_m</translation>
        </message>
        <message>
            <source>a system on WGS84, ETRS89 or another datum of today</source>
            <translation>基于 WGS84、ETRS89 或其他现行基准的坐标系</translation>
        </message>
        <message>
            <source>latitude and longitude are given for %1, whose datum lies %2 m from that of GNSS receivers</source>
            <translation>为 %1 给出了纬度和经度，而其基准与 GNSS 接收机的基准相差 %2 m</translation>
        </message>
        <message>
            <source>no targets</source>
            <translation>没有标靶</translation>
        </message>
        <message>
            <source>Set crs, for instance crs=EPSG:25832</source>
            <translation>请设置 crs，例如 crs=EPSG:25832</translation>
        </message>
        <message>
            <source>an EPSG code or WKT</source>
            <translation>EPSG 代码或 WKT</translation>
        </message>
        <message>
            <source>the coordinate system of the control points is not given</source>
            <translation>没有给出控制点的坐标系</translation>
        </message>
        <message>
            <source>Rename the columns</source>
            <translation>请重命名各列</translation>
        </message>
        <message>
            <source>easting_m and northing_m, or latitude_deg and longitude_deg</source>
            <translation>easting_m 和 northing_m，或 latitude_deg 和 longitude_deg</translation>
        </message>
        <message>
            <source>the coordinates have the columns %1</source>
            <translation>坐标的列为 %1</translation>
        </message>
        <message>
            <source>Take one of them away, or give it another name and its x_m, y_m</source>
            <translation>请去掉其中一个，或给它另一名称及其 x_m、y_m</translation>
        </message>
        <message>
            <source>each point once</source>
            <translation>每个点一次</translation>
        </message>
        <message>
            <source>the control point '%1' stands in rows %2 and %3</source>
            <translation>控制点“%1”在第 %2 行和第 %3 行出现</translation>
        </message>
        <message>
            <source>control points %1 are not used: no target has that name (%2) and the file has no x_m, y_m for them</source>
            <translation>未采用控制点 %1：没有同名的标靶（%2），文件中也没有它们的 x_m、y_m</translation>
        </message>
        <message>
            <source>control points %1 are not used: their coordinates are missing</source>
            <translation>未采用控制点 %1：缺少其坐标</translation>
        </message>
        <message>
            <source>Are they of different zones, or does one have the zone number before its easting?</source>
            <translation>它们属于不同的投影带，还是其中一个的东坐标前带有带号？</translation>
        </message>
        <message>
            <source>control points '%1' and '%2' are %3 km apart by their coordinates and %4 m in the map</source>
            <translation>控制点“%1”和“%2”按坐标相距 %3 km，在地图中相距 %4 m</translation>
        </message>
        <message>
            <source>points of one plot in one coordinate system</source>
            <translation>同一样地在同一坐标系中的点</translation>
        </message>
        <message>
            <source>the distances between the control points are %1 times those in the map: their coordinates seem to be %2</source>
            <translation>控制点之间的距离是地图中的 %1 倍：其坐标看来以%2为单位</translation>
        </message>
        <message>
            <source>Check the names of the points and their coordinates</source>
            <translation>请检查各点的名称及其坐标</translation>
        </message>
        <message>
            <source>; to '%1' %2 m by coordinates, %3 m in the map</source>
            <translation>；到“%1”按坐标为 %2 m，在地图中为 %3 m</translation>
        </message>
        <message>
            <source>to '%1' %2 m by coordinates, %3 m in the map</source>
            <translation>到“%1”按坐标为 %2 m，在地图中为 %3 m</translation>
        </message>
        <message>
            <source>the distances between the control points do not fit the plot: '%1' is left with %2 m (%3)</source>
            <translation>控制点之间的距离与样地不符：“%1”剩余 %2 m（%3）</translation>
        </message>
        <message>
            <source>the residuals of the control points are %1 times as large as control_sd and map_sd say; the standard errors were raised by this factor</source>
            <translation>控制点的残差是 control_sd 和 map_sd 所示的 %1 倍；标准误差已按此倍数放大</translation>
        </message>
        <message>
            <source>control_sd is open and the control points have %1 redundancies: the standard error of the place (%2 cm) rests on that alone and is wide. State control_sd (or sd_m per point) where the survey of the points tells it</source>
            <translation>未给定 control_sd，而控制点有 %1 个多余观测：位置的标准误差（%2 cm）只依据于此，因而较大。如果控制测量给出了精度，请设置 control_sd（或每点的 sd_m）</translation>
        </message>
        <message>
            <source>control_sd is open and the control points have %1 redundancy: the standard error of the place (%2 cm) rests on that alone and is wide. State control_sd (or sd_m per point) where the survey of the points tells it</source>
            <translation>未给定 control_sd，而控制点有 %1 个多余观测：位置的标准误差（%2 cm）只依据于此，因而较大。如果控制测量给出了精度，请设置 control_sd（或每点的 sd_m）</translation>
        </message>
        <message>
            <source>%1: %2 of %3 control points, residuals %4 cm, turn %5 +- %6 deg, place of the farthest stem +- %7 cm</source>
            <translation>%1：%3 个控制点中的 %2 个，残差 %4 cm，旋转 %5 +- %6 度，最远单木的位置 +- %7 cm</translation>
        </message>
        <message>
            <source>the control points have no redundancy: an error in one of them would not be seen. Measure one more</source>
            <translation>控制点没有多余观测：其中一个的误差无法发现。请再测一个</translation>
        </message>
        <message>
            <source>the standard error of the place reaches %1 m at the edge of the plot: the control points are too near together, or the bearing is too uncertain</source>
            <translation>样地边缘处位置的标准误差达 %1 m：控制点相距太近，或方位角太不确定</translation>
        </message>
        <message>
            <source>the y axis of the plot points %1 deg from grid north. This is right where the north target was not set to the north (survey.frame: north_bearing); else centre and north may be exchanged</source>
            <translation>样地的 y 轴偏离坐标北 %1 度。如果北标靶没有设在正北（survey.frame: north_bearing），这是对的；否则中心和北可能弄反了</translation>
        </message>
        <message>
            <source>only one of easting and northing is given</source>
            <translation>东坐标和北坐标只给出一个</translation>
        </message>
        <message>
            <source>only one of latitude and longitude is given</source>
            <translation>纬度和经度只给出一个</translation>
        </message>
        <message>
            <source>easting, northing and latitude, longitude of the centre are given</source>
            <translation>同时给出了中心的东、北坐标和纬度、经度</translation>
        </message>
        <message>
            <source>one of the two pairs</source>
            <translation>两对中的一对</translation>
        </message>
        <message>
            <source>Put the centre into the file, in a row with the name centre</source>
            <translation>请将中心写入文件，放在名为 centre 的行</translation>
        </message>
        <message>
            <source>a file of control points and coordinates of the centre are given</source>
            <translation>同时给出了控制点文件和中心坐标</translation>
        </message>
        <message>
            <source>Take it from the map sheet or a magnetic model, set declination; or set bearing_kind</source>
            <translation>请从图幅或地磁模型查取，设置 declination；或设置 bearing_kind</translation>
        </message>
        <message>
            <source>a magnetic bearing is given without the declination</source>
            <translation>给出了磁方位角而没有磁偏角</translation>
        </message>
        <message>
            <source>the declination of the place and day, east positive</source>
            <translation>该地当日的磁偏角，东偏为正</translation>
        </message>
        <message>
            <source>the control points ask for a scale of %1 +- %2; neither 1 nor that of the grid (%3) fits. Check the points farthest out, and the range scale of the sensor</source>
            <translation>控制点要求的比例为 %1 +- %2；1 和格网比例（%3）都不符合。请检查最外侧的点，以及传感器的测距比例</translation>
        </message>
        <message>
            <source>the control points ask for a scale of %1 +- %2, which speaks against scale=%3</source>
            <translation>控制点要求的比例为 %1 +- %2，与 scale=%3 不符</translation>
        </message>
        <message>
            <source>the residuals speak for the scale of the grid (%1: projection and height): it is used</source>
            <translation>残差支持格网比例（%1：投影和高程）：采用该比例</translation>
        </message>
        <message>
            <source>a metre in the plot is %1 m on the plane of the coordinate system (projection and height). The scale 1 is used: trees at the edge would move by up to %2 mm (part of position_se_m); scale=grid applies it</source>
            <translation>样地中的一米在坐标系平面上为 %1 m（投影和高程）。采用比例 1：边缘的树木最多会移动 %2 mm（已计入 position_se_m）；scale=grid 采用格网比例</translation>
        </message>
        <message>
            <source>a metre in the plot is %1 m on the plane of the coordinate system (projection and height). The scale 1 is used: trees at the edge would move by up to %2 mm; scale=grid applies it</source>
            <translation>样地中的一米在坐标系平面上为 %1 m（投影和高程）。采用比例 1：边缘的树木最多会移动 %2 mm；scale=grid 采用格网比例</translation>
        </message>
        <message>
            <source>there is no control height</source>
            <translation>没有控制点高程</translation>
        </message>
        <message>
            <source>at least two, or one and a bearing</source>
            <translation>至少两个，或一个和方位角</translation>
        </message>
        <message>
            <source>there is no control point</source>
            <translation>没有控制点</translation>
        </message>
        <message>
            <source>Measure a second point or set bearing</source>
            <translation>请测量第二个点或设置 bearing</translation>
        </message>
        <message>
            <source>the control points are all at one place, so that the turn of the plot is not known</source>
            <translation>控制点都在同一位置，因此样地的旋转未知</translation>
        </message>
        <message>
            <source>two points apart from one another, or one and a bearing</source>
            <translation>两个分开的点，或一个点和方位角</translation>
        </message>
        <message>
            <source>%1: with %2 s and with %3 s between the clocks the track fits alike (median distance %4 and %5 m)</source>
            <translation>%1：时钟相差 %2 s 和 %3 s 时轨迹同样相符（中位距离 %4 和 %5 m）</translation>
        </message>
        <message>
            <source>Set clock_offset and a small clock_window</source>
            <translation>请设置 clock_offset 和较小的 clock_window</translation>
        </message>
        <message>
            <source>a walk whose shape tells the time</source>
            <translation>形状可确定时间的行走路线</translation>
        </message>
        <message>
            <source>at least 2 and %1</source>
            <translation>至少 2 个和 %1 个</translation>
        </message>
        <message>
            <source>the walk has %1 poses, the track %2 fixes</source>
            <translation>行走有 %1 个位姿，轨迹有 %2 个定位点</translation>
        </message>
        <message>
            <source>Set clock_offset, or check that both are of one day</source>
            <translation>请设置 clock_offset，或检查两者是否为同一天</translation>
        </message>
        <message>
            <source>a track that was recorded during the walk</source>
            <translation>行走期间记录的轨迹</translation>
        </message>
        <message>
            <source>the times of the walk go from %1 to %2 s, those of the track from %3 to %4 s: no offset of the clocks brings half of the shorter one over the other</source>
            <translation>行走的时间为 %1 至 %2 s，轨迹的时间为 %3 至 %4 s：没有时钟差能使较短者的一半与另一者重叠</translation>
        </message>
        <message>
            <source>the times of the walk go from %1 to %2 s, those of the track from %3 to %4 s</source>
            <translation>行走的时间为 %1 至 %2 s，轨迹的时间为 %3 至 %4 s</translation>
        </message>
        <message>
            <source>%1 fixes of the track lie within the time of the walk</source>
            <translation>轨迹有 %1 个定位点在行走的时间之内</translation>
        </message>
        <message>
            <source>Check the clocks, or set clock_offset</source>
            <translation>请检查时钟，或设置 clock_offset</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>至少 %1</translation>
        </message>
        <message>
            <source>Read it with its times, or give control points</source>
            <translation>请连同时间读取，或给出控制点</translation>
        </message>
        <message>
            <source>a column time_s</source>
            <translation>列 time_s</translation>
        </message>
        <message>
            <source>the track has no times</source>
            <translation>轨迹没有时间</translation>
        </message>
        <message>
            <source>%1 % of the positions of the track do not follow the walk</source>
            <translation>GNSS 轨迹有 %1 % 的位置不符合行走路径</translation>
        </message>
        <message>
            <source>a track of the walk</source>
            <translation>行走的轨迹</translation>
        </message>
        <message>
            <source>the track has %1 positions with times, the walk %2 poses</source>
            <translation>轨迹有 %1 个带时间的位置，行走有 %2 个位姿</translation>
        </message>
        <message>
            <source>Give control points, or a better track</source>
            <translation>请给出控制点，或更好的轨迹</translation>
        </message>
        <message>
            <source>the walk reaches %1 m and the track scatters by %2 m: the direction of the plot is known to %3 deg only</source>
            <translation>行走范围为 %1 m，轨迹的离散为 %2 m：样地的方向只知道到 %3 度</translation>
        </message>
        <message>
            <source>the track fits the walk with %1 s between the clocks, and with %2 s as well; the first was taken, since more of the recordings overlaps. Check it, or set clock_offset</source>
            <translation>时钟相差 %1 s 时 GNSS 轨迹与行走相符，相差 %2 s 时也相符；采用前者，因为记录重叠更多。请检查，或设置 clock_offset</translation>
        </message>
        <message>
            <source>%1: %2 positions of the track, scatter %3 m, clocks %4 +- %5 s apart, antenna at (%6, %7, %8) m of the sensor, turn %9 +- %10 deg, place +- %11 m</source>
            <translation>%1：GNSS 轨迹的 %2 个位置，离散 %3 m，时钟相差 %4 +- %5 s，天线位于传感器的 (%6, %7, %8) m，旋转 %9 +- %10 度，位置 +- %11 m</translation>
        </message>
        <message>
            <source>heights are those of the track: above the ellipsoid, or above the sea where the receiver gives no height of the geoid</source>
            <translation>高度取自 GNSS 轨迹：为椭球高；接收机没有给出大地水准面高时为海拔高</translation>
        </message>
        <message>
            <source>Export the cloud with times, or take the trajectory away</source>
            <translation>请连同时间导出点云，或去掉轨迹</translation>
        </message>
        <message>
            <source>the points have no times, so that a trajectory cannot be joined to them</source>
            <translation>点没有时间，因此无法与轨迹合并</translation>
        </message>
        <message>
            <source>the time of every point (GPS time in LAS and LAZ, a column time in text)</source>
            <translation>每个点的时间（LAS 和 LAZ 中的 GPS 时间，文本中的 time 列）</translation>
        </message>
        <message>
            <source>Check the unit of its times</source>
            <translation>请检查其时间的单位</translation>
        </message>
        <message>
            <source>less than %1 s</source>
            <translation>少于 %1 s</translation>
        </message>
        <message>
            <source>the trajectory lasts %1 s</source>
            <translation>轨迹历时 %1 s</translation>
        </message>
        <message>
            <source>Give both in metres with z up, and set level=none</source>
            <translation>请以米为单位、z 朝上给出两者，并设置 level=none</translation>
        </message>
        <message>
            <source>a cloud and a path in the same axes</source>
            <translation>坐标轴相同的点云和路径</translation>
        </message>
        <message>
            <source>the cloud was turned or scaled when it was read (%1): the path has the axes of the file</source>
            <translation>点云在读取时被旋转或缩放（%1）：而路径采用文件的坐标轴</translation>
        </message>
        <message>
            <source>Set time_offset to one of them</source>
            <translation>请将 time_offset 设为其中之一</translation>
        </message>
        <message>
            <source>clocks that go together in one way</source>
            <translation>只有一种对应方式的时钟</translation>
        </message>
        <message>
            <source>the times of the points go %1, those of the trajectory %2: offsets of %3 s (%4) and %5 s (%6) both fit</source>
            <translation>点的时间为%1，轨迹的时间为%2：时间差 %3 s（%4）和 %5 s（%6）都相符</translation>
        </message>
        <message>
            <source>the path is in the axes of the plot that the cloud was moved from: it was moved with them</source>
            <translation>路径采用点云平移前的样地坐标轴：已随之一并移动</translation>
        </message>
        <message>
            <source>%1: %2 s were added to the times of the trajectory</source>
            <translation>%1：轨迹的时间加上了 %2 s</translation>
        </message>
        <message>
            <source>Set time_offset=%1 where the path is that of a part of the cloud</source>
            <translation>如果路径只属于点云的一部分，请设置 time_offset=%1</translation>
        </message>
        <message>
            <source>the path of the whole cloud</source>
            <translation>整个点云的路径</translation>
        </message>
        <message>
            <source>the times of the points go %1, those of the trajectory %2: with an offset of %3 s (%4) only %5 % of the points have a pose</source>
            <translation>点的时间为%1，轨迹的时间为%2：时间差为 %3 s（%4）时只有 %5 % 的点有位姿</translation>
        </message>
        <message>
            <source>Set time_offset; it is %1 where both begin at the same moment</source>
            <translation>请设置 time_offset；如果两者同时开始，其值为 %1</translation>
        </message>
        <message>
            <source>a trajectory of the same scan, in GPS time, GPS time less 1e9 s, seconds of the GPS week or Unix time</source>
            <translation>同一扫描的轨迹，采用 GPS 时间、减去 1e9 s 的 GPS 时间、GPS 周内秒或 Unix 时间</translation>
        </message>
        <message>
            <source>the times of the points go %1, those of the trajectory %2: no clocks are known by which they go together</source>
            <translation>点的时间为%1，轨迹的时间为%2：没有已知的时钟能使两者对应</translation>
        </message>
        <message>
            <source>hardly a point is nearer to it than %1 m</source>
            <translation>几乎没有点距它在 %1 m 以内</translation>
        </message>
        <message>
            <source>it is %1 m above the lowest points beneath it</source>
            <translation>它比其下的最低点高 %1 m</translation>
        </message>
        <message>
            <source>the middle of the points is %1 m aside of it</source>
            <translation>点的中心在其旁 %1 m</translation>
        </message>
        <message>
            <source>the path may be moved against the cloud, so that all rays are wrong: at the times of the points %1. Check that both have the same origin and the same heights; raise max_distance where the sensor was carried so</source>
            <translation>路径相对点云可能有移动，以致所有射线都是错的：在各点的时刻，%1。请检查两者的原点和高度是否相同；如果传感器确实如此携带，请增大 max_distance</translation>
        </message>
        <message>
            <source>from this path %1 % of the rays pass through other points, and %2 % with the path moved by about %3 m in x and %4 m in y: path and cloud may not have the same origin, or their clocks differ, so that all rays are wrong. Nothing was changed</source>
            <translation>从此路径出发，%1 % 的射线穿过其他点；将路径在 x 方向移动约 %3 m、在 y 方向移动约 %4 m 后为 %2 %：路径与点云的原点可能不同，或两者的时钟不同，以致所有射线都是错的。未作任何改变</translation>
        </message>
        <message>
            <source>%1 m or less, in the coordinate system of the points</source>
            <translation>%1 m 或更近，在点的坐标系中</translation>
        </message>
        <message>
            <source>Move the path into the coordinates of the cloud, or raise max_distance</source>
            <translation>请将路径移到点云的坐标系中，或增大 max_distance</translation>
        </message>
        <message>
            <source>the path does not run through the cloud: all but the nearest hundredth of the points are %1 m or more from the sensor that measured them (median %2 m)</source>
            <translation>路径不穿过点云：除最近的百分之一外，所有点距测得它们的传感器 %1 m 或更远（中位数 %2 m）</translation>
        </message>
        <message>
            <source>Check axes and time_offset, or take the trajectory away</source>
            <translation>请检查坐标轴和 time_offset，或去掉轨迹</translation>
        </message>
        <message>
            <source>a path in the coordinate system and clock of the points</source>
            <translation>与点的坐标系和时钟相同的路径</translation>
        </message>
        <message>
            <source>the points do not follow the path: they are %1 m from the sensor at their time, and %2 m from where it was at other times</source>
            <translation>点不跟随路径：在其时刻距传感器 %1 m，而距传感器其他时刻的位置 %2 m</translation>
        </message>
        <message>
            <source>the points lie nearer the path (median %1 m, now %2 m) with %3 s more: the clocks may differ, for instance by leap seconds. Nothing was changed; set time_offset=%4 where it is so</source>
            <translation>加上 %3 s 后点离路径更近（中位数 %1 m，现为 %2 m）：时钟可能不同，例如相差闰秒。未作任何改变；如果属实，请设置 time_offset=%4</translation>
        </message>
        <message>
            <source>%1 % of the points have a pose with time_offset=%2: their times go %3, those of the trajectory %4</source>
            <translation>time_offset=%2 时 %1 % 的点有位姿：其时间为%3，轨迹的时间为%4</translation>
        </message>
        <message>
            <source>times that overlap</source>
            <translation>重叠的时间</translation>
        </message>
        <message>
            <source>joining points and path</source>
            <translation>将点与路径合并</translation>
        </message>
        <message>
            <source>%1 of %2 points have their ray, %3 passes</source>
            <translation>%2 个点中有 %1 个有射线，%3 次经过</translation>
        </message>
        <message>
            <source>%1 % of the points have no pose at their time and count without a ray: the trajectory is shorter than the cloud, or has gaps of more than %2 s</source>
            <translation>%1 % 的点在其时刻没有位姿，按无射线计：轨迹比点云短，或有超过 %2 s 的间断</translation>
        </message>
        <message>
            <source>the points had sensor positions: those of the trajectory took their place</source>
            <translation>点原有传感器位置：已由轨迹的位置取代</translation>
        </message>
        <message>
            <source>the points had passes: those of the path took their place</source>
            <translation>点原有经过次序：已由路径的取代</translation>
        </message>
        <message>
            <source>from %1 to %2 s</source>
            <translation> %1 至 %2 s</translation>
        </message>
        <message>
            <source>Export the cloud with times</source>
            <translation>请连同时间导出点云</translation>
        </message>
        <message>
            <source>no point has a time</source>
            <translation>没有点有时间</translation>
        </message>
        <message>
            <source>the time of every point</source>
            <translation>每个点的时间</translation>
        </message>
        <message>
            <source>the cloud has no points</source>
            <translation>点云没有点</translation>
        </message>
        <message>
            <source>Finding the vertical</source>
            <translation>确定竖直方向</translation>
        </message>
        <message>
            <source>Finding the targets</source>
            <translation>查找标靶</translation>
        </message>
        <message>
            <source>Finding the ground at the centre</source>
            <translation>确定中心处的地面</translation>
        </message>
        <message>
            <source>the cloud has no array intensity: targets could not be looked for</source>
            <translation>点云没有数组 intensity：无法查找标靶</translation>
        </message>
        <message>
            <source>%1 of %2 points have an intensity above min_intensity (%3): it does not suit this sensor, targets were not looked for</source>
            <translation>%2 个点中有 %1 个的强度高于 min_intensity（%3）：它不适合此传感器，未查找标靶</translation>
        </message>
        <message>
            <source>there are too few points around the centre target to tell the height of the ground: z is zero at the target</source>
            <translation>中心标靶周围的点太少，无法得知地面高度：以标靶处的 z 为零</translation>
        </message>
        <message>
            <source>Plot axes from two targets %1 m apart, level by gravity (+- %2 deg).</source>
            <translation>样地坐标轴由相距 %1 m 的两个标靶确定，按重力水平（+- %2 度）。</translation>
        </message>
        <message>
            <source>Plot axes from two targets %1 m apart, levelled by %2 stems (tilt %3 +- %4 deg).</source>
            <translation>样地坐标轴由相距 %1 m 的两个标靶确定，按 %2 株单木整平（倾斜 %3 +- %4 度）。</translation>
        </message>
        <message>
            <source>Plot axes from two targets %1 m apart, levelled by the ground (tilt %2 deg).</source>
            <translation>样地坐标轴由相距 %1 m 的两个标靶确定，按地面整平（倾斜 %2 度）。</translation>
        </message>
        <message>
            <source>Plot axes from two targets %1 m apart, not levelled.</source>
            <translation>样地坐标轴由相距 %1 m 的两个标靶确定，未整平。</translation>
        </message>
        <message>
            <source>Map axes kept: no targets were found; level by gravity (+- %1 deg).</source>
            <translation>保持地图坐标轴：没有找到标靶；按重力水平（+- %1 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: no targets were found; levelled by %1 stems (tilt %2 +- %3 deg).</source>
            <translation>保持地图坐标轴：没有找到标靶；按 %1 株单木整平（倾斜 %2 +- %3 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: no targets were found; levelled by the ground (tilt %1 deg).</source>
            <translation>保持地图坐标轴：没有找到标靶；按地面整平（倾斜 %1 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: no targets were found; not levelled.</source>
            <translation>保持地图坐标轴：没有找到标靶；未整平。</translation>
        </message>
        <message>
            <source>Map axes kept: only one target was found; level by gravity (+- %1 deg).</source>
            <translation>保持地图坐标轴：只找到一个标靶；按重力水平（+- %1 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: only one target was found; levelled by %1 stems (tilt %2 +- %3 deg).</source>
            <translation>保持地图坐标轴：只找到一个标靶；按 %1 株单木整平（倾斜 %2 +- %3 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: only one target was found; levelled by the ground (tilt %1 deg).</source>
            <translation>保持地图坐标轴：只找到一个标靶；按地面整平（倾斜 %1 度）。</translation>
        </message>
        <message>
            <source>Map axes kept: only one target was found; not levelled.</source>
            <translation>保持地图坐标轴：只找到一个标靶；未整平。</translation>
        </message>
        <message>
            <source> and %1</source>
            <translation> 和 %1</translation>
        </message>
        <message>
            <source>Leave out %1, or give another shape</source>
            <translation>请去掉 %1，或给出另一种形状</translation>
        </message>
        <message>
            <source>plot option %1 are given and %2</source>
            <translation>给出了样地选项 %1，且 %2</translation>
        </message>
        <message>
            <source>plot option %1 is given and %2</source>
            <translation>给出了样地选项 %1，且 %2</translation>
        </message>
        <message>
            <source>plot options %1 are given and %2</source>
            <translation>给出了样地选项 %1，且 %2</translation>
        </message>
        <message>
            <source>plot options %1 is given and %2</source>
            <translation>给出了样地选项 %1，且 %2</translation>
        </message>
        <message>
            <source>plot options that go together: shape circle with radius, x and y; shape rectangle with width, length, bearing, x and y; shape polygon with vertices; shape none alone</source>
            <translation>互相配合的样地选项：shape 为 circle 时用 radius、x 和 y；为 rectangle 时用 width、length、bearing、x 和 y；为 polygon 时用 vertices；为 none 时不用其他选项</translation>
        </message>
        <message>
            <source>belong to different shapes, a circle and a rectangle</source>
            <translation>它们属于不同的形状，即圆和矩形</translation>
        </message>
        <message>
            <source>the plot has no size</source>
            <translation>样地没有大小</translation>
        </message>
        <message>
            <source>the plot is a %1</source>
            <translation>样地为 %1</translation>
        </message>
        <message>
            <source>shape is none</source>
            <translation>shape 为 none（没有形状）</translation>
        </message>
        <message>
            <source>the plot is a %1 whose vertices are connected</source>
            <translation>样地为 %1，其顶点已连接</translation>
        </message>
        <message>
            <source>Connect the input 'vertices' to a stage io.read_table</source>
            <translation>请将输入“vertices”连接到步骤 io.read_table</translation>
        </message>
        <message>
            <source>a table of x_m and y_m</source>
            <translation>含 x_m 和 y_m 的表</translation>
        </message>
        <message>
            <source>shape is polygon and no vertices are connected</source>
            <translation>shape 为 polygon，但没有连接顶点</translation>
        </message>
        <message>
            <source>the options x and y</source>
            <translation>选项 x 和 y</translation>
        </message>
        <message>
            <source>the origin</source>
            <translation>原点</translation>
        </message>
        <message>
            <source>the centre target</source>
            <translation>中心标靶</translation>
        </message>
        <message>
            <source>the middle of what was scanned</source>
            <translation>扫描范围的中心</translation>
        </message>
        <message>
            <source>option x and y of %1</source>
            <translation>%1 的选项 x 和 y</translation>
        </message>
        <message>
            <source>option y and x of %1</source>
            <translation>%1 的选项 y 和 x</translation>
        </message>
        <message>
            <source>a radius of %1 m</source>
            <translation>半径 %1 m</translation>
        </message>
        <message>
            <source>%1 is assumed for the plot (set plot.width or plot.radius where it is another): </source>
            <translation>样地按%1假定（如果不是，请设置 plot.width 或 plot.radius）：</translation>
        </message>
        <message>
            <source>%1 points, min_target_points is %2</source>
            <translation>%1 个点，min_target_points 为 %2</translation>
        </message>
        <message>
            <source>the target at (%1, %2, %3) is %4 m long as seen from one position and %5 m in the map: the map is bent or doubled there, and its axes are only as good as that</source>
            <translation>位于 (%1, %2, %3) 的标靶从一个位置看长 %4 m，在地图中长 %5 m：地图在该处弯曲或重影，其坐标轴的精度不会更好</translation>
        </message>
        <message>
            <source>not taken for the other target: %1</source>
            <translation>未作为另一个标靶：%1</translation>
        </message>
        <message>
            <source>%1 m long in the map and %2 m as seen from one position: it moves, or the map is bent</source>
            <translation>在地图中长 %1 m，从一个位置看长 %2 m：它在移动，或地图弯曲</translation>
        </message>
        <message>
            <source>%1 m long, target_size is %2 m</source>
            <translation>长 %1 m，target_size 为 %2 m</translation>
        </message>
        <message>
            <source>seen from positions %1 m apart, target_views is %2 m</source>
            <translation>观测位置相距 %1 m，target_views 为 %2 m</translation>
        </message>
        <message>
            <source>Swap them, or set years</source>
            <translation>请交换两者，或设置 years</translation>
        </message>
        <message>
            <source>an earlier and a later survey</source>
            <translation>一次较早和一次较晚的调查</translation>
        </message>
        <message>
            <source>the second survey is not later than the first (dates of the tables)</source>
            <translation>第二次调查不晚于第一次（按表中的日期）</translation>
        </message>
        <message>
            <source>Rows planted evenly look alike from both ends: bring both tables into the same axes (survey.georeference, or the same targets) and set axes=same</source>
            <translation>均匀种植的行从两端看来相同：请使两个表的坐标轴相同（survey.georeference，或相同的标靶），并设置 axes=same</translation>
        </message>
        <message>
            <source>one motion that fits better than all others</source>
            <translation>一个比其他都更相符的移动</translation>
        </message>
        <message>
            <source>two maps of %1 and %2 trees that %3 of their trees bring together, and another turn or shift does the same for %4</source>
            <translation>有 %1 株和 %2 株树的两幅地图由其中 %3 株重合，而另一旋转或平移同样使 %4 株重合</translation>
        </message>
        <message>
            <source>Check that both are of the same plot, unmirrored, in metres; set axes=same where both lie in the same axes, and max_growth or match_distance where much has changed</source>
            <translation>请检查两者是否为同一样地、未成镜像、以米为单位；如果坐标轴相同，请设置 axes=same；如果变化很大，请设置 max_growth 或 match_distance</translation>
        </message>
        <message>
            <source>at least 5 trees, a third of those that both cover, at the same places with like diameters</source>
            <translation>至少 5 株树，占两者都覆盖的三分之一，位置相同且直径相近</translation>
        </message>
        <message>
            <source>two maps of %1 and %2 trees that %3 of their trees bring together</source>
            <translation>有 %1 株和 %2 株树的两幅地图由其中 %3 株重合</translation>
        </message>
        <message>
            <source>the years between the surveys are not known: growth is that of the whole time. Set years</source>
            <translation>两次调查之间的年数未知：生长量是整个时段的。请设置 years</translation>
        </message>
        <message>
            <source>%1 diameters have no interval: assumed_se was taken for them</source>
            <translation>%1 个直径没有区间：采用 assumed_se</translation>
        </message>
        <message>
            <source>only %1 % of the trees that both surveys cover were found again: felling, or one of the surveys missed trees. Growth is that of the trees found again</source>
            <translation>两次调查都覆盖的树木只有 %1 % 被再次找到：有采伐，或其中一次调查漏了树。生长量是再次找到的树木的</translation>
        </message>
        <message>
            <source>%1 of %2 trees are thinner in the second survey by more than their intervals: one survey has a bias, the breast heights differ, or trees were confused</source>
            <translation>%2 株中有 %1 株在第二次调查中变细，且超出其区间：其中一次调查有偏差，胸高不同，或树木弄混</translation>
        </message>
        <message>
            <source>%1 trees were missed by one of the surveys</source>
            <translation>有 %1 株树被其中一次调查漏掉</translation>
        </message>
        <message>
            <source>%1 stems in the first and %2 in the second table</source>
            <translation>第一个表有 %1 株单木，第二个表有 %2 株</translation>
        </message>
        <message>
            <source>stems in both</source>
            <translation>两者都有单木</translation>
        </message>
        <message>
            <source>Bringing the two maps together</source>
            <translation>使两幅地图重合</translation>
        </message>
        <message>
            <source>%1 trees found again (to %2 cm), %3 grew; mean growth %4 cm</source>
            <translation>再次找到 %1 株树（精度 %2 cm），%3 株生长；平均生长 %4 cm</translation>
        </message>
        <message>
            <source>%1 trees found again (to %2 cm), %3 grew; mean growth %4 cm in %5 years</source>
            <translation>再次找到 %1 株树（精度 %2 cm），%3 株生长；%5 年内平均生长 %4 cm</translation>
        </message>
        <message>
            <source>the ground is tilted by %1 deg against the map's z axis, more than max_tilt (%2 deg): the map was not levelled</source>
            <translation>地面相对地图的 z 轴倾斜 %1 度，超过 max_tilt（%2 度）：地图未整平</translation>
        </message>
        <message>
            <source>levelled by the plane of the ground: the slope of the plot cannot be separated from the tilt of the map and was removed with it</source>
            <translation>按地面的平面整平：样地的坡度与地图的倾斜无法区分，已一并去除</translation>
        </message>
        <message>
            <source>Set level to stems, or to auto</source>
            <translation>请将 level 设为 stems 或 auto</translation>
        </message>
        <message>
            <source>a map that was made with an inertial unit (slam.preset best or inertial)</source>
            <translation>用惯性单元生成的地图（slam.preset 为 best 或 inertial）</translation>
        </message>
        <message>
            <source>level is gravity, and nothing tells the direction of gravity in this map</source>
            <translation>level 为 gravity，而此地图的重力方向无从得知</translation>
        </message>
        <message>
            <source>%1 stems were found to level by, min_stems is %2: the ground was taken instead</source>
            <translation>可用于整平的单木只有 %1 株，min_stems 为 %2：改用地面</translation>
        </message>
        <message>
            <source>there was nothing to level by: the map's z axis was kept</source>
            <translation>没有可用于整平的内容：保持地图的 z 轴</translation>
        </message>
        <message>
            <source>Connect trajectory, or set file</source>
            <translation>请连接 trajectory，或设置 file</translation>
        </message>
        <message>
            <source>a GNSS track is given, but no trajectory of the walk</source>
            <translation>给出了 GNSS 轨迹，但没有行走的轨迹</translation>
        </message>
        <message>
            <source>Set file, or easting and northing, or latitude and longitude</source>
            <translation>请设置 file，或 easting 和 northing，或 latitude 和 longitude</translation>
        </message>
        <message>
            <source>control points or the centre</source>
            <translation>控制点或中心</translation>
        </message>
        <message>
            <source>crs or bearing is given, but no place of the plot</source>
            <translation>给出了 crs 或 bearing，但没有样地的位置</translation>
        </message>
        <message>
            <source>no control points, centre coordinates or GNSS track are given: the place of the plot on the earth is not known, and everything stays as it is</source>
            <translation>没有给出控制点、中心坐标或 GNSS 轨迹：样地在地球上的位置未知，一切保持不变</translation>
        </message>
        <message>
            <source>the GNSS track is not used: the control points go before it</source>
            <translation>未采用 GNSS 轨迹：控制点优先</translation>
        </message>
        <message>
            <source>Moving the points</source>
            <translation>移动点</translation>
        </message>
        <message>
            <source>%1 % of the plot (%2, centre (%3, %4)) holds no points: values per hectare are too low there. Move the plot (x, y), make it smaller, or scan the rest</source>
            <translation>样地的 %1 %（%2，中心 (%3, %4)）没有点：该处每公顷的数值偏低。请移动样地（x, y），缩小样地，或扫描其余部分</translation>
        </message>
        <message>
            <source> about %1 (%2, %3)</source>
            <translation>，以%1 (%2, %3) 为中心</translation>
        </message>
        <message>
            <source>, trees from %1 cm</source>
            <translation>，树木自 %1 cm 起</translation>
        </message>
        <message>
            <source>no trajectory is given: the points are as they were</source>
            <translation>没有给出轨迹：点保持不变</translation>
        </message>
    </context>
    <context>
        <name>vtkbridge</name>
        <message>
            <source>array 'array_%1' has %2 values</source>
            <translation>数组“array_%1”有 %2 个值</translation>
        </message>
        <message>
            <source>a %1 is connected</source>
            <translation>连接的是 %1</translation>
        </message>
        <message>
            <source>a missing object is connected</source>
            <translation>连接的对象缺失</translation>
        </message>
        <message>
            <source>Connect io.read_scan</source>
            <translation>请连接 io.read_scan</translation>
        </message>
        <message>
            <source>data without the frames of a scan is connected</source>
            <translation>连接的数据不含扫描的帧</translation>
        </message>
        <message>
            <source>the output of a scan reader</source>
            <translation>读取扫描的步骤的输出</translation>
        </message>
        <message>
            <source>Connect io.read_views</source>
            <translation>请连接 io.read_views</translation>
        </message>
        <message>
            <source>data without the pictures of a camera is connected</source>
            <translation>连接的数据不含相机的图像</translation>
        </message>
        <message>
            <source>the output of a reader of pictures</source>
            <translation>读取图像的步骤的输出</translation>
        </message>
        <message>
            <source>stage '%1': %2</source>
            <translation>步骤“%1”：%2</translation>
        </message>
        <message>
            <source>%1. Get a whole file, or go on with what there is (--accept-partial)</source>
            <translation>%1。请取得完整的文件，或用现有内容继续（--accept-partial）</translation>
        </message>
        <message>
            <source>Skipped: no file is given.</source>
            <translation>已跳过：没有给出文件。</translation>
        </message>
        <message>
            <source>Left out: nothing is written.</source>
            <translation>未执行：不写出任何内容。</translation>
        </message>
        <message>
            <source>stage '%1' gave no %2</source>
            <translation>步骤“%1”没有给出 %2</translation>
        </message>
        <message>
            <source>input '%1' is left out: stage '%2' failed</source>
            <translation>输入“%1”未使用：步骤“%2”失败</translation>
        </message>
        <message>
            <source>all of its inputs failed</source>
            <translation>其所有输入都失败了</translation>
        </message>
        <message>
            <source>cancelled on request</source>
            <translation>应要求取消</translation>
        </message>
        <message>
            <source>reading %1 to see whether its result is known</source>
            <translation>读取 %1 以查看其结果是否已知</translation>
        </message>
        <message>
            <source>a stage that `bole stages` lists</source>
            <translation>`bole stages` 列出的步骤</translation>
        </message>
        <message>
            <source>no stage type is set</source>
            <translation>没有设置步骤类型</translation>
        </message>
        <message>
            <source>this build has no stage '%1'</source>
            <translation>此版本没有步骤“%1”</translation>
        </message>
        <message>
            <source>nothing is connected</source>
            <translation>没有连接任何内容</translation>
        </message>
        <message>
            <source>the stage before gave nothing</source>
            <translation>前一步骤没有给出任何内容</translation>
        </message>
    </context>
</TS>
