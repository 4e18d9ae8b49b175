<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>lessons</name>
        <message>
            <source>Why tangent edges inflate trees</source>
            <translation>切线边缘为何使胸径偏大</translation>
        </message>
        <message>
            <source>How the width of a laser beam changes the diameter of a tree, and what helps against it.</source>
            <translation>激光束的宽度如何改变树的直径,以及怎样应对。</translation>
        </message>
        <message>
            <source>1. The question</source>
            <translation>1. 问题</translation>
        </message>
        <message>
            <source>A laser beam is not a line. In this simulated plot it leaves the sensor about 1 cm wide and opens by 3 mrad. At the edge of a stem half of the beam may pass by. The part that hits the bark still sends light back, and the scanner puts the point in the direction of the middle of the beam: beside the tree.</source>
            <translation>激光束不是一条线。在这块模拟样地中,光束离开传感器时约宽 1 cm,发散角为 3 mrad。在树干边缘,光束可能有一半从旁边射过。射中树皮的部分仍会返回光,而扫描仪把点放在光束中心的方向上:落在树干之外。</translation>
        </message>
        <message>
            <source>Select trees in the table and look at the slice. Zoom with the wheel.</source>
            <translation>在表中选择树木,观察横切面。用滚轮缩放。</translation>
        </message>
        <message>
            <source>How wide is the beam at 5 m? It is 0.95 cm wide at the sensor and opens by 3 mrad.</source>
            <translation>光束在 5 m 处有多宽?它在传感器处宽 0.95 cm,发散角为 3 mrad。</translation>
        </message>
        <message>
            <source>That is as much as a thin tree.</source>
            <translation>这相当于一棵细树的直径。</translation>
        </message>
        <message>
            <source>Over 5 m, 3 mrad add 500 cm x 0.003.</source>
            <translation>3 mrad 的发散在 5 m 处增加 500 cm × 0.003。</translation>
        </message>
        <message>
            <source>Yes, the outermost points lie clearly outside the circle.</source>
            <translation>能,最外侧的点明显在圆外。</translation>
        </message>
        <message>
            <source>Those are noise: the ranges of this sensor scatter by 2 to 3 cm on all sides.</source>
            <translation>那是噪声:该传感器的测距在各个方向都有 2 到 3 cm 的离散。</translation>
        </message>
        <message>
            <source>No, the noise of the ranges is larger than the shift.</source>
            <translation>不能,测距噪声大于这一偏移。</translation>
        </message>
        <message>
            <source>Half a beam width is 1 cm, the noise 2 to 3 cm. Noise disappears when many points are averaged. A shift that all edges share does not.</source>
            <translation>半个光束宽约 1 cm,噪声为 2 到 3 cm。许多点平均后噪声消失,而所有边缘共有的偏移不会消失。</translation>
        </message>
        <message>
            <source>No, there is no shift.</source>
            <translation>不能,根本没有偏移。</translation>
        </message>
        <message>
            <source>There is one. Step 3 shows it as the mean of all trees.</source>
            <translation>有偏移。第 3 步将以所有树的平均值显示它。</translation>
        </message>
        <message>
            <source>Can you see on a single stem that its edges lie outside?</source>
            <translation>在单株树上能看出边缘点落在外面吗?</translation>
        </message>
        <message>
            <source>2. What the program does about it</source>
            <translation>2. 程序如何处理</translation>
        </message>
        <message>
            <source>The panel Field check compares the stems with the true trees. The bias contains a convention of about -0.3 cm: a tape lies on the ridges of the bark, and the program gives the mean bark. Look at how the bias changes in the next steps.</source>
            <translation>“实测检核”面板把单木与真实的树相比较。偏差中约有 -0.3 cm 属于约定:围尺量在树皮的突起上,而程序给出树皮的平均位置。请观察后面各步中偏差的变化。</translation>
        </message>
        <message>
            <source>Bias of the diameters</source>
            <translation>胸径偏差</translation>
        </message>
        <message>
            <source>RMSE of the diameters</source>
            <translation>胸径 RMSE</translation>
        </message>
        <message>
            <source>How many stems are matched with a true tree? Read the panel Field check.</source>
            <translation>有多少株单木与真实的树匹配?请看“实测检核”面板。</translation>
        </message>
        <message>
            <source>The bias is the mean over these trees.</source>
            <translation>偏差是这些树的平均值。</translation>
        </message>
        <message>
            <source>The number stands above the map of the panel.</source>
            <translation>该数字在面板的平面图上方。</translation>
        </message>
        <message>
            <source>The program ignores the points at the edges.</source>
            <translation>程序忽略了边缘的点。</translation>
        </message>
        <message>
            <source>It uses rays up to 95 % of the radius. Step 5 shows what happens without the edges.</source>
            <translation>它使用直到半径 95 % 处的射线。第 5 步说明没有边缘会怎样。</translation>
        </message>
        <message>
            <source>The fit knows the width of the beam.</source>
            <translation>拟合知道光束的宽度。</translation>
        </message>
        <message>
            <source>For every ray it predicts the mean range of the bark that the whole beam lights, and compares this with the measured range.</source>
            <translation>对每条射线,它预测整个光束照亮的树皮的平均距离,并与测得的距离比较。</translation>
        </message>
        <message>
            <source>Errors to the left and to the right cancel.</source>
            <translation>左右两侧的误差互相抵消。</translation>
        </message>
        <message>
            <source>Both edges lie outside. They move the circle apart on both sides.</source>
            <translation>两侧的边缘都在外面,它们使圆向两侧扩大。</translation>
        </message>
        <message>
            <source>Why are the trees not inflated here?</source>
            <translation>为什么这里的树没有偏大?</translation>
        </message>
        <message>
            <source>3. Take that knowledge away</source>
            <translation>3. 去掉这一知识</translation>
        </message>
        <message>
            <source>Set divergence and aperture of the beam to 0 in the options of Measure stems, and run. Now the fit assumes that beams are lines. Nothing in the forest has changed.</source>
            <translation>在“测定单木”的参数中把光束的发散角和孔径设为 0,然后运行。现在拟合假定光束是一条线。森林没有任何变化。</translation>
        </message>
        <message>
            <source>Bias with the beam known</source>
            <translation>已知光束时的偏差</translation>
        </message>
        <message>
            <source>By how much is the bias larger than in step 2?</source>
            <translation>偏差比第 2 步大多少?</translation>
        </message>
        <message>
            <source>All trees have grown by this much on average.</source>
            <translation>平均而言所有的树都变粗了这么多。</translation>
        </message>
        <message>
            <source>Subtract the first number from the second; mind the signs.</source>
            <translation>用第二个数减去第一个数,注意正负号。</translation>
        </message>
        <message>
            <source>By how much does the basal area of a tree of 25 cm change with this diameter?</source>
            <translation>对于直径 25 cm 的树,断面积因此改变多少?</translation>
        </message>
        <message>
            <source>The area goes with the square of the diameter. In the yearly growth of such a tree the share is far larger.</source>
            <translation>面积与直径的平方成正比。与这样一棵树的年生长量相比,所占比例大得多。</translation>
        </message>
        <message>
            <source>Square the ratio of the diameters.</source>
            <translation>计算直径之比的平方。</translation>
        </message>
        <message>
            <source>4. What does not help: robust weights</source>
            <translation>4. 无济于事的方法:稳健权重</translation>
        </message>
        <message>
            <source>Set the beam back and the model to surface. The fit then uses the distance of the points from the bark, and gives outliers less weight. The options of the beam turn grey: rest the mouse on one to read why.</source>
            <translation>恢复光束参数,并将模型设为“表面”。此时拟合使用点到树皮的距离,并降低离群点的权重。光束参数变灰:将鼠标停在上面可以看到原因。</translation>
        </message>
        <message>
            <source>Bias with beams as lines</source>
            <translation>光束当作直线时的偏差</translation>
        </message>
        <message>
            <source>This model knows nothing of the beam. The points at the edges pull the circle outwards, and robust weights do not stop them.</source>
            <translation>该模型不知道光束的宽度。边缘的点把圆向外拉,稳健权重不能阻止。</translation>
        </message>
        <message>
            <source>Subtract the bias with the beam known; mind the signs.</source>
            <translation>减去已知光束时的偏差,注意正负号。</translation>
        </message>
        <message>
            <source>The weights are too weak.</source>
            <translation>权重太弱。</translation>
        </message>
        <message>
            <source>Stronger weights would take good points at the edges too.</source>
            <translation>更强的权重也会去掉边缘处的好点。</translation>
        </message>
        <message>
            <source>A bias that all edges share is no outlier.</source>
            <translation>所有边缘共有的偏差不是离群值。</translation>
        </message>
        <message>
            <source>A robust fit looks for the few that differ from the many. Here the many are shifted.</source>
            <translation>稳健拟合寻找与多数不同的少数。这里是多数发生了偏移。</translation>
        </message>
        <message>
            <source>There are too few points.</source>
            <translation>点太少。</translation>
        </message>
        <message>
            <source>More points have the same shift. They only make the wrong mean more certain.</source>
            <translation>更多的点有同样的偏移,只会使错误的平均值更确定。</translation>
        </message>
        <message>
            <source>Why is the bias not gone?</source>
            <translation>为什么偏差没有消失?</translation>
        </message>
        <message>
            <source>5. What does not help: no edges</source>
            <translation>5. 无济于事的方法:去掉边缘</translation>
        </message>
        <message>
            <source>Set the model back, the beam to 0 again, and the ray gate to 0.6. The fit uses only the middle 60 % of each stem.</source>
            <translation>恢复模型,再次将光束设为 0,并将射线阈值设为 0.6。拟合只使用每株树干中间的 60 %。</translation>
        </message>
        <message>
            <source>RMSE with all points and beams as lines</source>
            <translation>使用全部点、光束当作直线时的 RMSE</translation>
        </message>
        <message>
            <source>How many times larger is the RMSE than with all points?</source>
            <translation>RMSE 是使用全部点时的几倍?</translation>
        </message>
        <message>
            <source>Diameters scatter more, and a tree may be lost.</source>
            <translation>直径更加离散,还可能丢失一棵树。</translation>
        </message>
        <message>
            <source>Divide the last number by the first.</source>
            <translation>用最后一个数除以第一个数。</translation>
        </message>
        <message>
            <source>Where the stem ends to the left and to the right.</source>
            <translation>树干左右两侧止于何处。</translation>
        </message>
        <message>
            <source>The middle of an arc is nearly flat: small noise gives a large change of the radius.</source>
            <translation>圆弧的中部几乎是平的:很小的噪声就会使半径变化很大。</translation>
        </message>
        <message>
            <source>Enough points for an average.</source>
            <translation>足够求平均的点。</translation>
        </message>
        <message>
            <source>Most points lie in the middle. Their number is not the problem.</source>
            <translation>大多数点在中部,数量不是问题。</translation>
        </message>
        <message>
            <source>The far side of the stem.</source>
            <translation>树干的背面。</translation>
        </message>
        <message>
            <source>No scan from one side sees it, with the edges or without.</source>
            <translation>无论有无边缘,单侧扫描都看不到背面。</translation>
        </message>
        <message>
            <source>What is missing without the edges?</source>
            <translation>没有边缘时缺少什么?</translation>
        </message>
        <message>
            <source>6. What remains</source>
            <translation>6. 留下的问题</translation>
        </message>
        <message>
            <source>Set everything back. The options say 3 mrad because the data sheet of the sensor does.</source>
            <translation>恢复所有参数。参数为 3 mrad,是因为传感器的数据手册这样写。</translation>
        </message>
        <message>
            <source>Look at the scatter of the points about the circle.</source>
            <translation>观察点在圆周围的离散。</translation>
        </message>
        <message>
            <source>The scatter is the noise of the ranges. It hides the shift, as in step 1.</source>
            <translation>离散是测距噪声,它掩盖了偏移,见第 1 步。</translation>
        </message>
        <message>
            <source>Tape twenty stems of all sizes and check whether the error depends on the diameter.</source>
            <translation>用围尺量二十株各种大小的树,检查误差是否随直径变化。</translation>
        </message>
        <message>
            <source>A beam that is assumed too narrow adds the same to thin and thick stems. An error that grows with the diameter has another cause.</source>
            <translation>假定过窄的光束对粗细树干增加同样的量。随直径增大的误差另有原因。</translation>
        </message>
        <message>
            <source>Scan one stem a hundred times.</source>
            <translation>把一株树扫描一百次。</translation>
        </message>
        <message>
            <source>All scans have the same beam, and the same shift.</source>
            <translation>所有扫描的光束相同,偏移也相同。</translation>
        </message>
        <message>
            <source>How do you find out in your own forest whether the beam of your scanner is as wide as assumed?</source>
            <translation>如何在自己的林分中检验扫描仪的光束是否与假定的一样宽?</translation>
        </message>
        <message>
            <source>Plants and gaps in a row</source>
            <translation>行中的植株与缺株</translation>
        </message>
        <message>
            <source>How a gap in a row is counted that no sensor sees, and when the count is wrong.</source>
            <translation>传感器看不到的缺株如何计数,以及何时计错。</translation>
        </message>
        <message>
            <source>1. Two rows with gaps</source>
            <translation>1. 有缺株的两行</translation>
        </message>
        <message>
            <source>A simulated robot stands before two rows of young trees and scans for half a second. Every row was planted with eight trees, 1.2 m apart. Some have died. Select a row in the panel Rows and look at its plants.</source>
            <translation>模拟机器人停在两行幼树前,扫描半秒。每行种了八棵树,株距 1.2 m。其中一些已经死亡。在“种植行”面板中选择一行,查看其植株。</translation>
        </message>
        <message>
            <source>How many living trees were found in row 1?</source>
            <translation>第 1 行找到多少棵活树?</translation>
        </message>
        <message>
            <source>Eight were planted in this row.</source>
            <translation>这一行种了八棵。</translation>
        </message>
        <message>
            <source>The panel Rows has a line for each row.</source>
            <translation>“种植行”面板中每行植株占一行。</translation>
        </message>
        <message>
            <source>How many trees are missing in both rows together?</source>
            <translation>两行一共缺多少棵?</translation>
        </message>
        <message>
            <source>Found and missing trees make sixteen, as planted.</source>
            <translation>找到的与缺失的合计十六棵,与种植数相同。</translation>
        </message>
        <message>
            <source>Add the missing plants of both rows.</source>
            <translation>把两行的缺株数相加。</translation>
        </message>
        <message>
            <source>2. A gap is a multiple of the spacing</source>
            <translation>2. 缺口是株距的倍数</translation>
        </message>
        <message>
            <source>Nobody has seen the missing trees. The program divides the distance between two neighbours by the spacing and rounds. A distance of two spacings is one missing tree.</source>
            <translation>谁也没有看到缺失的树。程序把相邻两株的距离除以株距并取整。两倍株距的距离就是缺一棵。</translation>
        </message>
        <message>
            <source>Row 2, tree 3: x</source>
            <translation>第 2 行第 3 棵:x</translation>
        </message>
        <message>
            <source>Row 2, tree 6: x</source>
            <translation>第 2 行第 6 棵:x</translation>
        </message>
        <message>
            <source>Spacing that was found</source>
            <translation>求得的株距</translation>
        </message>
        <message>
            <source>How many trees are missing between trees 3 and 6 of row 2? Divide their distance by the spacing and round.</source>
            <translation>第 2 行第 3 棵与第 6 棵之间缺几棵?用距离除以株距并取整。</translation>
        </message>
        <message>
            <source>Three spacings are two missing trees.</source>
            <translation>三倍株距即缺两棵。</translation>
        </message>
        <message>
            <source>A distance of two spacings is one missing tree, not two.</source>
            <translation>两倍株距是缺一棵,不是两棵。</translation>
        </message>
        <message>
            <source>Often, since 5 cm is much.</source>
            <translation>经常,因为 5 cm 很大。</translation>
        </message>
        <message>
            <source>A distance must be wrong by half a spacing, 60 cm, before it is rounded to another number.</source>
            <translation>距离须偏差半个株距,即 60 cm,取整才会变为另一个数。</translation>
        </message>
        <message>
            <source>When the places scatter by a few decimetres.</source>
            <translation>当位置离散达几分米时。</translation>
        </message>
        <message>
            <source>The distance must be wrong by 60 cm. With 5 cm this does not happen, with 30 cm it happens now and then.</source>
            <translation>距离须偏差 60 cm。标准差为 5 cm 时不会发生,30 cm 时偶尔会发生。</translation>
        </message>
        <message>
            <source>Never, since the program rounds.</source>
            <translation>从不,因为程序会取整。</translation>
        </message>
        <message>
            <source>Rounding helps up to half a spacing only.</source>
            <translation>取整只在半个株距以内有效。</translation>
        </message>
        <message>
            <source>The trees were planted with a standard deviation of 5 cm. When would two spacings be taken for three?</source>
            <translation>种植位置的标准差为 5 cm。什么情况下两倍株距会被当作三倍?</translation>
        </message>
        <message>
            <source>3. Whose spacing?</source>
            <translation>3. 谁的株距?</translation>
        </message>
        <message>
            <source>The spacing is the median of the distances between neighbours, or what you give. Set it to 1.2 m and run.</source>
            <translation>株距是相邻距离的中位数,或者由您给定。将它设为 1.2 m 并运行。</translation>
        </message>
        <message>
            <source>Trees in rows</source>
            <translation>行中的树</translation>
        </message>
        <message>
            <source>Missing trees</source>
            <translation>缺失的树</translation>
        </message>
        <message>
            <source>How many trees are missing in row 2 now?</source>
            <translation>现在第 2 行缺几棵?</translation>
        </message>
        <message>
            <source>The spacing that was found was good enough, since many neighbours live.</source>
            <translation>求得的株距已足够好,因为许多相邻的树都活着。</translation>
        </message>
        <message>
            <source>The program reports a gap between all neighbours.</source>
            <translation>程序在所有相邻树之间报告缺株。</translation>
        </message>
        <message>
            <source>It does not know the spacing. It sees equal distances, as in a row without gaps.</source>
            <translation>它不知道株距,只看到相等的距离,就像没有缺株的行。</translation>
        </message>
        <message>
            <source>The spacing comes out double, and no gap is reported.</source>
            <translation>株距变为两倍,不报告任何缺株。</translation>
        </message>
        <message>
            <source>Give the spacing wherever you know it: it stands in the planting plan.</source>
            <translation>只要知道株距就应给定:它写在种植计划中。</translation>
        </message>
        <message>
            <source>The run fails.</source>
            <translation>运行失败。</translation>
        </message>
        <message>
            <source>It gives a result that looks good. That is the danger.</source>
            <translation>它给出看似正确的结果,这正是危险所在。</translation>
        </message>
        <message>
            <source>Every second tree of a row has died. What happens if the spacing is found from the row?</source>
            <translation>某行的树每隔一棵死亡一棵。如果由该行求株距,会怎样?</translation>
        </message>
        <message>
            <source>4. What is not seen is no gap</source>
            <translation>4. 没看到的不是缺株</translation>
        </message>
        <message>
            <source>A tree far away has fewer points. Let clusters count as plants only from 30 points on: set the smallest number of points of Cluster into plants to 30.</source>
            <translation>远处的树点较少。只有达到 30 个点的点簇才算植株:将“植株聚类”的最少点数设为 30。</translation>
        </message>
        <message>
            <source>Trees in rows before</source>
            <translation>之前行中的树</translation>
        </message>
        <message>
            <source>How many missing trees does the run report now?</source>
            <translation>现在运行报告缺几棵?</translation>
        </message>
        <message>
            <source>The trees in rows are fewer, and the number of gaps is that of before.</source>
            <translation>行中的树变少了,而缺株数与之前相同。</translation>
        </message>
        <message>
            <source>It was the last of its row: the row now ends before it.</source>
            <translation>它是该行最后一棵:该行现在在它之前结束。</translation>
        </message>
        <message>
            <source>A gap lies between two trees. Beyond the last tree nothing says that one should stand there.</source>
            <translation>缺株位于两棵树之间。最后一棵树之外,没有任何依据说明应有一棵树。</translation>
        </message>
        <message>
            <source>The program knows that it lives.</source>
            <translation>程序知道它还活着。</translation>
        </message>
        <message>
            <source>It knows the points only. The tree has too few of them.</source>
            <translation>它只知道点,而这棵树的点太少。</translation>
        </message>
        <message>
            <source>Another tree took its number.</source>
            <translation>另一棵树取了它的编号。</translation>
        </message>
        <message>
            <source>Numbers follow the places along the row.</source>
            <translation>编号按行中的位置排列。</translation>
        </message>
        <message>
            <source>Why is the tree that was lost not reported as missing?</source>
            <translation>为什么丢失的树没有报告为缺株?</translation>
        </message>
        <message>
            <source>5. The less is seen, the fewer gaps</source>
            <translation>5. 看到的越少,缺株越少</translation>
        </message>
        <message>
            <source>Raise the smallest number of points to 40.</source>
            <translation>将最少点数提高到 40。</translation>
        </message>
        <message>
            <source>Rows</source>
            <translation>行数</translation>
        </message>
        <message>
            <source>How many trees have been lost since step 3?</source>
            <translation>自第 3 步以来丢失了多少棵树?</translation>
        </message>
        <message>
            <source>Some of them were clusters with too few points. The others are left in too short a row to be one.</source>
            <translation>其中一些是点数过少的点簇,其余的所在行太短,已不成一行。</translation>
        </message>
        <message>
            <source>Step 4 shows the number of step 3.</source>
            <translation>第 4 步显示了第 3 步的数字。</translation>
        </message>
        <message>
            <source>The spacing to a millimetre.</source>
            <translation>精确到毫米的株距。</translation>
        </message>
        <message>
            <source>The spacing matters, but a millimetre changes no count.</source>
            <translation>株距重要,但一毫米不会改变计数。</translation>
        </message>
        <message>
            <source>The number of trees and rows that were seen.</source>
            <translation>看到的树和行的数量。</translation>
        </message>
        <message>
            <source>Few gaps may mean a good stand or a sensor that saw little of it.</source>
            <translation>缺株少可能意味着林分良好,也可能是传感器看到得少。</translation>
        </message>
        <message>
            <source>The number of points of the scan.</source>
            <translation>扫描的点数。</translation>
        </message>
        <message>
            <source>Most of them lie on the ground and near the sensor.</source>
            <translation>大多数点在地面上和传感器附近。</translation>
        </message>
        <message>
            <source>Which number must a report name beside the number of gaps?</source>
            <translation>报告在缺株数旁边必须给出哪个数字?</translation>
        </message>
        <message>
            <source>6. The longest gap</source>
            <translation>6. 最长的缺口</translation>
        </message>
        <message>
            <source>A gap longer than the longest gap of Find plant rows ends the row. Set the points back to 5, the spacing to auto and the longest gap to 1.</source>
            <translation>长度超过“识别种植行”中最大连续缺株数的缺口使行结束。将点数恢复为 5,株距恢复为自动,最大连续缺株数设为 1。</translation>
        </message>
        <message>
            <source>How many living trees stand in no row now? Compare with step 3, or count the strays in the view.</source>
            <translation>现在有多少棵活树不属于任何行?与第 3 步比较,或数视图中的离散株。</translation>
        </message>
        <message>
            <source>Row 2 breaks at its gap of two trees, and what is left behind it is too short.</source>
            <translation>第 2 行在缺两棵处断开,其后剩下的部分太短。</translation>
        </message>
        <message>
            <source>Subtract the trees in rows from those of step 3.</source>
            <translation>用第 3 步的树数减去行中的树数。</translation>
        </message>
        <message>
            <source>A small one: rows break at every gap.</source>
            <translation>较小的值:行在每个缺口处断开。</translation>
        </message>
        <message>
            <source>That suits a vineyard with paths across the rows. In this forest it would lose living trees.</source>
            <translation>这适合有横向通道的葡萄园。在这片幼林中会丢失活树。</translation>
        </message>
        <message>
            <source>A large one: several neighbours may have died.</source>
            <translation>较大的值:相邻几棵可能都已死亡。</translation>
        </message>
        <message>
            <source>A row should go on across all gaps that death makes.</source>
            <translation>行应当跨过死亡造成的所有缺口。</translation>
        </message>
        <message>
            <source>It does not matter.</source>
            <translation>无关紧要。</translation>
        </message>
        <message>
            <source>Your run has just lost trees by it.</source>
            <translation>您的运行刚刚因此丢失了树。</translation>
        </message>
        <message>
            <source>Which value suits a young forest where a third of the trees has died?</source>
            <translation>三分之一的树已死亡的幼林适合用哪个值?</translation>
        </message>
        <message>
            <source>How sure is the direction of a row</source>
            <translation>行的方向有多可靠</translation>
        </message>
        <message>
            <source>Three errors of a plant row that a LiDAR on a robot finds: the centres of its plants, the heading of the sensor, and the planting itself.</source>
            <translation>机器人激光雷达所求植株行的三种误差:植株中心、传感器航向和种植本身。</translation>
        </message>
        <message>
            <source>1. Two rows of tubes</source>
            <translation>1. 两行管子</translation>
        </message>
        <message>
            <source>A simulated robot stands before two rows of four tubes each. The tubes have leaves. Where they stand is known, so every direction can be compared with the truth: the line through the true places of the four tubes.</source>
            <translation>模拟机器人停在两行管子前,每行四根。管子上有叶片。它们的位置已知,因此每个方向都可以与真值比较:通过四根管子真实位置的直线。</translation>
        </message>
        <message>
            <source>The centre of a tube is the axis behind the side that the sensor sees.</source>
            <translation>管子的中心是传感器所见一侧背后的轴线。</translation>
        </message>
        <message>
            <source>Mean error of the angle</source>
            <translation>角度平均误差</translation>
        </message>
        <message>
            <source>Largest error of the angle</source>
            <translation>角度最大误差</translation>
        </message>
        <message>
            <source>What is the angle of row 1? Read the panel Rows.</source>
            <translation>第 1 行的角度是多少?请看“种植行”面板。</translation>
        </message>
        <message>
            <source>It is counted from east to north.</source>
            <translation>角度从东向北计算。</translation>
        </message>
        <message>
            <source>The angle stands in the line of row 1; mind the sign.</source>
            <translation>角度在第 1 行所在的那一行,注意正负号。</translation>
        </message>
        <message>
            <source>2. The centres</source>
            <translation>2. 中心</translation>
        </message>
        <message>
            <source>Set the centre of Find trunk centres to mean: the mean of the points of the trunk. It moves where a leaf hangs, and it lies before the axis, because nobody sees the back of a tube.</source>
            <translation>将“提取树干中心”的中心设为“平均值”:树干点的平均值。有叶片处它会移动,而且位于轴线之前,因为谁也看不到管子的背面。</translation>
        </message>
        <message>
            <source>Mean error with the axis</source>
            <translation>使用轴线时的平均误差</translation>
        </message>
        <message>
            <source>How many times larger is the mean error now?</source>
            <translation>现在的平均误差是之前的几倍?</translation>
        </message>
        <message>
            <source>Leaves move single centres, and each of them turns the line.</source>
            <translation>叶片使个别中心移动,每一个都会转动直线。</translation>
        </message>
        <message>
            <source>Divide the second number by the first.</source>
            <translation>用第二个数除以第一个数。</translation>
        </message>
        <message>
            <source>The direction of the row.</source>
            <translation>行的方向。</translation>
        </message>
        <message>
            <source>All centres move alike, so the line through them does not turn.</source>
            <translation>所有中心同样移动,通过它们的直线并不转动。</translation>
        </message>
        <message>
            <source>The place of the row.</source>
            <translation>行的位置。</translation>
        </message>
        <message>
            <source>The line moves towards the sensor as a whole.</source>
            <translation>直线整体移向传感器。</translation>
        </message>
        <message>
            <source>Nothing.</source>
            <translation>什么也不改变。</translation>
        </message>
        <message>
            <source>A row that lies nearer is another row for a robot.</source>
            <translation>对机器人来说,更近的行就是另一个位置。</translation>
        </message>
        <message>
            <source>All centres lie too near by about the same length. What does this part of the error change?</source>
            <translation>所有中心都偏近大致相同的距离。这部分误差改变什么?</translation>
        </message>
        <message>
            <source>3. The heading</source>
            <translation>3. 航向</translation>
        </message>
        <message>
            <source>The frame knows directions only from the sensor. Three marks of known place give its position and heading. They are good to 1 cm and lie 3 to 6 m apart. Set the centre back to face.</source>
            <translation>一帧数据的方向只来自传感器。三个位置已知的标志给出它的位置和航向。标志精度为 1 cm,相距 3 到 6 m。将中心恢复为“轴心”。</translation>
        </message>
        <message>
            <source>Standard error of the heading</source>
            <translation>航向标准误</translation>
        </message>
        <message>
            <source>Which angle is 1 cm over 4 m?</source>
            <translation>4 m 上的 1 cm 对应多大角度?</translation>
        </message>
        <message>
            <source>The standard error of the heading is of this size.</source>
            <translation>航向标准误正是这个量级。</translation>
        </message>
        <message>
            <source>1 cm over 4 m is 0.0025 rad; a radian has 57.3 deg.</source>
            <translation>4 m 上的 1 cm 为 0.0025 rad,1 弧度为 57.3 deg。</translation>
        </message>
        <message>
            <source>Which one is wrong.</source>
            <translation>哪一个错了。</translation>
        </message>
        <message>
            <source>Each of the three can be the wrong one: the distances between them fit no pair better.</source>
            <translation>三个都可能是错的:它们之间的距离不能说明是哪一个。</translation>
        </message>
        <message>
            <source>That one is wrong, but not which.</source>
            <translation>有一个错了,但不知是哪个。</translation>
        </message>
        <message>
            <source>A fourth mark would tell: three of the four then agree.</source>
            <translation>第四个标志可以说明:那时四个中有三个一致。</translation>
        </message>
        <message>
            <source>Nothing at all.</source>
            <translation>什么也不能。</translation>
        </message>
        <message>
            <source>The distances between the marks are known. They do not fit any more.</source>
            <translation>标志之间的距离已知,它们不再吻合。</translation>
        </message>
        <message>
            <source>One of three marks is wrong by 25 cm. What do the marks tell?</source>
            <translation>三个标志中有一个偏差 25 cm。标志能说明什么?</translation>
        </message>
        <message>
            <source>4. The true heading</source>
            <translation>4. 真实航向</translation>
        </message>
        <message>
            <source>The same scan with the true pose of the sensor in place of the marks. Compare the angles of both rows.</source>
            <translation>同一扫描,用传感器的真实位姿代替标志。比较两行的角度。</translation>
        </message>
        <message>
            <source>Row 1 with the marks</source>
            <translation>第 1 行,用标志</translation>
        </message>
        <message>
            <source>Row 1</source>
            <translation>第 1 行</translation>
        </message>
        <message>
            <source>Row 2 with the marks</source>
            <translation>第 2 行,用标志</translation>
        </message>
        <message>
            <source>Row 2</source>
            <translation>第 2 行</translation>
        </message>
        <message>
            <source>By how much does row 1 turn?</source>
            <translation>第 1 行转动了多少?</translation>
        </message>
        <message>
            <source>Row 2 turns by the same angle.</source>
            <translation>第 2 行转动同样的角度。</translation>
        </message>
        <message>
            <source>Subtract the angle with the marks.</source>
            <translation>减去用标志求得的角度。</translation>
        </message>
        <message>
            <source>It makes the rows crooked.</source>
            <translation>使行变弯。</translation>
        </message>
        <message>
            <source>Every point turns by the same angle about the sensor. A line stays a line.</source>
            <translation>每个点都绕传感器转过同样的角度,直线仍是直线。</translation>
        </message>
        <message>
            <source>It turns the whole field.</source>
            <translation>使整块田转动。</translation>
        </message>
        <message>
            <source>Both rows have turned alike.</source>
            <translation>两行转动相同。</translation>
        </message>
        <message>
            <source>It changes the spacing.</source>
            <translation>改变株距。</translation>
        </message>
        <message>
            <source>Distances do not change when everything turns.</source>
            <translation>整体转动时距离不变。</translation>
        </message>
        <message>
            <source>What does an error of the heading do to a field?</source>
            <translation>航向误差对整块田有何影响?</translation>
        </message>
        <message>
            <source>5. An interval that looks wrong</source>
            <translation>5. 看似错误的区间</translation>
        </message>
        <message>
            <source>Back to the marks. The direction of row 1 is within a tenth of a degree of the truth. Look at its 95 % interval.</source>
            <translation>回到标志。第 1 行的方向与真值相差不到十分之一度。请看它的 95 % 置信区间。</translation>
        </message>
        <message>
            <source>Interval from</source>
            <translation>区间从</translation>
        </message>
        <message>
            <source>to</source>
            <translation>到</translation>
        </message>
        <message>
            <source>How wide is the interval?</source>
            <translation>区间有多宽?</translation>
        </message>
        <message>
            <source>Is it wrong? The next step takes the true places of the tubes.</source>
            <translation>它错了吗?下一步采用管子的真实位置。</translation>
        </message>
        <message>
            <source>Subtract the lower end from the upper one; mind the signs.</source>
            <translation>用上限减去下限,注意正负号。</translation>
        </message>
        <message>
            <source>6. The planting</source>
            <translation>6. 种植</translation>
        </message>
        <message>
            <source>The true places of the tubes, without any sensor. Four tubes stand a few centimetres beside their line.</source>
            <translation>管子的真实位置,不经任何传感器。四根管子偏离直线几厘米。</translation>
        </message>
        <message>
            <source>Standard error as found by the sensor</source>
            <translation>传感器求得的标准误</translation>
        </message>
        <message>
            <source>Standard error as planted</source>
            <translation>按种植位置的标准误</translation>
        </message>
        <message>
            <source>Length of row 1</source>
            <translation>第 1 行长度</translation>
        </message>
        <message>
            <source>The standard error falls about with the length times the root of the number of plants, so with the power 1.5 of the length. How long must a row with this spacing be for 0.5 deg?</source>
            <translation>标准误大致随长度与株数平方根的乘积下降,即随长度的 1.5 次方下降。株距相同时,行要多长才能达到 0.5 deg?</translation>
        </message>
        <message>
            <source>Short rows have no exact direction, whatever the sensor.</source>
            <translation>无论用什么传感器,短行都没有精确的方向。</translation>
        </message>
        <message>
            <source>Divide the standard error by 0.5, take this to the power 2/3, and multiply by the length.</source>
            <translation>用标准误除以 0.5,取 2/3 次方,再乘以长度。</translation>
        </message>
        <message>
            <source>How well the line through these tubes was found.</source>
            <translation>通过这些管子的直线求得有多准。</translation>
        </message>
        <message>
            <source>The robot drives along what stands there.</source>
            <translation>机器人沿着实际立在那里的管子行驶。</translation>
        </message>
        <message>
            <source>How exactly the row was planted.</source>
            <translation>行种得有多准。</translation>
        </message>
        <message>
            <source>That counts for a planter that sets the next row parallel to this one.</source>
            <translation>这对要种植平行下一行的种植机才重要。</translation>
        </message>
        <message>
            <source>Which of the two errors counts for a robot that drives along the row?</source>
            <translation>对沿行行驶的机器人,哪种误差更重要?</translation>
        </message>
        <message>
            <source>Why sample plots differ from the stand</source>
            <translation>样圆为何与林分不同</translation>
        </message>
        <message>
            <source>How the size of a sample plot, the edge of the stand and a careless distance change what a plot says.</source>
            <translation>样圆大小、林分边缘和粗心的距离测量如何改变样圆的结果。</translation>
        </message>
        <message>
            <source>1. A stand of which you know every tree</source>
            <translation>1. 每棵树都已知的林分</translation>
        </message>
        <message>
            <source>A simulated hectare, 100 m x 100 m. The run lays 2000 plots of each size into it at random and compares them with the truth. Simulating the stand takes half a minute.</source>
            <translation>模拟的一公顷林分,100 m × 100 m。运行时随机布设每种大小 2000 个样圆,并与真值比较。模拟林分需要半分钟。</translation>
        </message>
        <message>
            <source>This pipeline has no stems to show in the views: its numbers stand here and in the report.</source>
            <translation>该处理流程没有可在视图中显示的单木:数字显示在这里和报告中。</translation>
        </message>
        <message>
            <source>True basal area per hectare</source>
            <translation>真实每公顷断面积</translation>
        </message>
        <message>
            <source>A plot of 200 m2 holds 20 trees. How many stems per hectare does it say?</source>
            <translation>200 m2 的样圆中有 20 棵树。它表示每公顷多少株?</translation>
        </message>
        <message>
            <source>One hectare has 10 000 m2.</source>
            <translation>一公顷为 10 000 m2。</translation>
        </message>
        <message>
            <source>Divide by the area of the plot, multiply by 10 000 m2.</source>
            <translation>除以样圆面积,再乘以 10 000 m2。</translation>
        </message>
        <message>
            <source>2. One plot scatters</source>
            <translation>2. 单个样圆的离散</translation>
        </message>
        <message>
            <source>The standard deviation of single plots that fit into the stand as a whole, in percent of the truth.</source>
            <translation>完全位于林分内的单个样圆的标准差,以真值的百分比表示。</translation>
        </message>
        <message>
            <source>Radius 4 m</source>
            <translation>半径 4 m</translation>
        </message>
        <message>
            <source>Radius 8 m</source>
            <translation>半径 8 m</translation>
        </message>
        <message>
            <source>Radius 12.62 m</source>
            <translation>半径 12.62 m</translation>
        </message>
        <message>
            <source>Radius 15 m</source>
            <translation>半径 15 m</translation>
        </message>
        <message>
            <source>Radius 4 m, trees at random</source>
            <translation>半径 4 m,树木随机分布</translation>
        </message>
        <message>
            <source>Radius 15 m, trees at random</source>
            <translation>半径 15 m,树木随机分布</translation>
        </message>
        <message>
            <source>How many plots of 4 m have together the area of one plot of 12.62 m?</source>
            <translation>多少个 4 m 样圆的总面积等于一个 12.62 m 样圆?</translation>
        </message>
        <message>
            <source>The mean of so many scatters less by the root of this number.</source>
            <translation>这么多样圆的平均值的离散按该数的平方根减小。</translation>
        </message>
        <message>
            <source>Areas go with the square of the radius.</source>
            <translation>面积与半径的平方成正比。</translation>
        </message>
        <message>
            <source>How large is the standard deviation of the mean of 12 plots of 8 m?</source>
            <translation>12 个 8 m 样圆平均值的标准差是多少?</translation>
        </message>
        <message>
            <source>Compare it with the mean of 5 plots of 12.62 m, which take about a day too.</source>
            <translation>将它与 5 个 12.62 m 样圆的平均值比较,后者也需要约一天。</translation>
        </message>
        <message>
            <source>Divide the standard deviation of one plot by the root of 12.</source>
            <translation>用单个样圆的标准差除以 12 的平方根。</translation>
        </message>
        <message>
            <source>And of the mean of 5 plots of 12.62 m?</source>
            <translation>5 个 12.62 m 样圆平均值的标准差呢?</translation>
        </message>
        <message>
            <source>Now you can decide which day of work gives the more certain mean.</source>
            <translation>现在可以判断哪一天的工作得到更可靠的平均值。</translation>
        </message>
        <message>
            <source>Divide the standard deviation of one plot by the root of 5.</source>
            <translation>用单个样圆的标准差除以 5 的平方根。</translation>
        </message>
        <message>
            <source>3. The edge of the stand</source>
            <translation>3. 林分边缘</translation>
        </message>
        <message>
            <source>Plots at random places reach beyond the edge, and there are no trees there. Ignore divides by the whole area. Inside takes plots only where they fit in. Area divides by the part inside. Mirage mirrors the plot at the edge.</source>
            <translation>随机位置的样圆会超出边缘,而那里没有树。ignore 除以全部面积;inside 只取完全在内的样圆;area 除以位于林分内的部分;mirage 在边缘处镜像样圆。</translation>
        </message>
        <message>
            <source>Bias of ignore, 15 m</source>
            <translation>ignore 的偏差,15 m</translation>
        </message>
        <message>
            <source>Bias of inside, 15 m</source>
            <translation>inside 的偏差,15 m</translation>
        </message>
        <message>
            <source>Bias of area, 15 m</source>
            <translation>area 的偏差,15 m</translation>
        </message>
        <message>
            <source>Bias of mirage, 15 m</source>
            <translation>mirage 的偏差,15 m</translation>
        </message>
        <message>
            <source>The mean share of a circle of radius r outside a square of side a is about 8 r / (3 pi a). How much is it for 15 m and 100 m?</source>
            <translation>半径 r 的圆位于边长 a 的正方形之外的平均比例约为 8 r / (3 pi a)。15 m 与 100 m 时是多少?</translation>
        </message>
        <message>
            <source>The bias of ignore is of this size, with a minus.</source>
            <translation>ignore 的偏差正是这个量级,符号为负。</translation>
        </message>
        <message>
            <source>Put 15 and 100 into the formula and multiply by 100.</source>
            <translation>将 15 和 100 代入公式,再乘以 100。</translation>
        </message>
        <message>
            <source>Mirage</source>
            <translation>mirage</translation>
        </message>
        <message>
            <source>Trees in the mirror image count a second time. This makes up for the area that is missing.</source>
            <translation>镜像中的树再计一次,弥补了缺少的面积。</translation>
        </message>
        <message>
            <source>Inside</source>
            <translation>inside</translation>
        </message>
        <message>
            <source>No area is missing, but trees near the edge are in fewer plots than the others.</source>
            <translation>面积没有缺少,但靠近边缘的树所在的样圆比其他树少。</translation>
        </message>
        <message>
            <source>Area</source>
            <translation>area</translation>
        </message>
        <message>
            <source>It divides by the part inside, so trees at the edge count as they should on average.</source>
            <translation>它除以位于林分内的部分,因此边缘的树平均而言计数适当。</translation>
        </message>
        <message>
            <source>Trees at the edge are often thicker than the others. Which treatment then gives too low a mean?</source>
            <translation>边缘的树往往比其他树粗。那么哪种处理会使平均值偏低?</translation>
        </message>
        <message>
            <source>4. Bias or chance?</source>
            <translation>4. 偏差还是偶然?</translation>
        </message>
        <message>
            <source>A small bias may be chance. Its standard error says how much chance there is. Set the number of plots to 20000 and run.</source>
            <translation>很小的偏差可能出于偶然。其标准误说明偶然有多大。将样圆数设为 20000 并运行。</translation>
        </message>
        <message>
            <source>Mirage, 4 m: bias with 2000 plots</source>
            <translation>mirage,4 m:2000 个样圆的偏差</translation>
        </message>
        <message>
            <source>Its standard error</source>
            <translation>其标准误</translation>
        </message>
        <message>
            <source>Mirage, 4 m: bias with 20000 plots</source>
            <translation>mirage,4 m:20000 个样圆的偏差</translation>
        </message>
        <message>
            <source>Standard error with 20000 plots</source>
            <translation>20000 个样圆的标准误</translation>
        </message>
        <message>
            <source>By which factor has the standard error become smaller?</source>
            <translation>标准误缩小到几分之一?</translation>
        </message>
        <message>
            <source>Ten times as many plots give the root of ten.</source>
            <translation>样圆数增加到十倍,得到十的平方根。</translation>
        </message>
        <message>
            <source>Divide the old standard error by the new one.</source>
            <translation>用旧的标准误除以新的标准误。</translation>
        </message>
        <message>
            <source>The method is biased.</source>
            <translation>该方法有偏。</translation>
        </message>
        <message>
            <source>Chance alone gives such a value in one of three cases.</source>
            <translation>仅凭偶然,三次中就有一次出现这样的值。</translation>
        </message>
        <message>
            <source>It may be chance: more plots would tell.</source>
            <translation>可能是偶然:更多样圆可以说明。</translation>
        </message>
        <message>
            <source>Only a bias of more than two standard errors is worth an explanation.</source>
            <translation>只有超过两倍标准误的偏差才值得解释。</translation>
        </message>
        <message>
            <source>A bias is as large as its standard error. What do you conclude?</source>
            <translation>偏差与其标准误一样大。您得出什么结论?</translation>
        </message>
        <message>
            <source>5. Ten centimetres at the boundary</source>
            <translation>5. 边界上的十厘米</translation>
        </message>
        <message>
            <source>A tree counts when its centre lies within the radius. Who measures to the nearer side of the bark reads half a diameter too little, about 10 cm. Set the constant error of the distance to -0.1 m and the plots to 2000.</source>
            <translation>树的中心位于半径之内时才计入。量到树皮近侧的人少读半个直径,约 10 cm。将距离系统误差设为 -0.1 m,样圆数设为 2000。</translation>
        </message>
        <message>
            <source>Mirage, 4 m: bias before</source>
            <translation>mirage,4 m:之前的偏差</translation>
        </message>
        <message>
            <source>Mirage, 4 m: bias</source>
            <translation>mirage,4 m:偏差</translation>
        </message>
        <message>
            <source>Which share of the area of a plot of 4 m is the ring of 10 cm around it?</source>
            <translation>4 m 样圆外侧 10 cm 的环占其面积的多少?</translation>
        </message>
        <message>
            <source>The bias grows by about this share.</source>
            <translation>偏差大约增加这么多。</translation>
        </message>
        <message>
            <source>Compare the circles of 4.1 m and 4 m.</source>
            <translation>比较 4.1 m 和 4 m 的圆。</translation>
        </message>
        <message>
            <source>By how much has the bias of the plots of 4 m grown?</source>
            <translation>4 m 样圆的偏差增加了多少?</translation>
        </message>
        <message>
            <source>Small plots have much boundary for their area. That is why their boundary trees need a tape.</source>
            <translation>小样圆相对面积而言边界长,因此其边界树需要用尺量。</translation>
        </message>
        <message>
            <source>Subtract the bias before.</source>
            <translation>减去之前的偏差。</translation>
        </message>
        <message>
            <source>6. Your own stand</source>
            <translation>6. 您自己的林分</translation>
        </message>
        <message>
            <source>Any list with x_m, y_m and dbh_cm serves as a stand, for instance the stems.csv of your own survey of 32 m x 32 m.</source>
            <translation>任何含有 x_m, y_m 和 dbh_cm 的列表都可作为林分,例如您自己 32 m × 32 m 调查的 stems.csv。</translation>
        </message>
        <message>
            <source>How they scatter at small distances.</source>
            <translation>它们在小距离上的离散。</translation>
        </message>
        <message>
            <source>The truth is now that of 0.1 ha. How this tenth of a hectare differs from the next it does not tell.</source>
            <translation>此时的真值是这 0.1 ha 的真值。它不能说明这十分之一公顷与下一个有何不同。</translation>
        </message>
        <message>
            <source>How well they give the whole forest.</source>
            <translation>它们对整片森林的代表性。</translation>
        </message>
        <message>
            <source>Beyond the survey nothing is known.</source>
            <translation>调查之外一无所知。</translation>
        </message>
        <message>
            <source>Nothing, since the survey has errors.</source>
            <translation>什么也不能,因为调查有误差。</translation>
        </message>
        <message>
            <source>Its errors are those of single diameters. They are small against the scatter of plots.</source>
            <translation>其误差是单株直径的误差,与样圆的离散相比很小。</translation>
        </message>
        <message>
            <source>What does such a survey tell about plots of 8 m in it?</source>
            <translation>这样的调查能说明其中 8 m 样圆的什么?</translation>
        </message>
    </context>
</TS>
