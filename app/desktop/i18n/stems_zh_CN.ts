<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>stems</name>
        <message>
            <source>good</source>
            <translation>良好</translation>
        </message>
        <message>
            <source>fair</source>
            <translation>一般</translation>
        </message>
        <message>
            <source>poor</source>
            <translation>较差</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>check</source>
            <translation>待查</translation>
        </message>
        <message>
            <source>accepted</source>
            <translation>已接受</translation>
        </message>
        <message>
            <source>rejected</source>
            <translation>已拒绝</translation>
        </message>
        <message>
            <source>edited</source>
            <translation>已编辑</translation>
        </message>
        <message>
            <source>seen</source>
            <translation>可见</translation>
        </message>
        <message>
            <source>only the lower stem is in the cloud</source>
            <translation>点云中只有树干下部</translation>
        </message>
        <message>
            <source>few points at the top</source>
            <translation>树顶点数少</translation>
        </message>
        <message>
            <source>the highest point stands far beside the stem</source>
            <translation>最高点远离树干</translation>
        </message>
        <message>
            <source>another tree reaches over the top</source>
            <translation>另一株树盖过树顶</translation>
        </message>
        <message>
            <source>the top may be that of another tree</source>
            <translation>树顶可能属于另一株树</translation>
        </message>
        <message>
            <source>the tree stands at the edge of the cloud</source>
            <translation>该树位于点云边缘</translation>
        </message>
        <message>
            <source>the sensor could not see higher</source>
            <translation>传感器看不到更高处</translation>
        </message>
        <message>
            <source>the cloud ends there</source>
            <translation>点云到此为止</translation>
        </message>
        <message>
            <source>the stem ends without a tip or a crown</source>
            <translation>树干在此终止,没有树梢或树冠</translation>
        </message>
        <message>
            <source>given by hand</source>
            <translation>人工给定</translation>
        </message>
        <message>
            <source>only %1 deg of the bark seen</source>
            <translation>仅看到树皮的 %1 度</translation>
        </message>
        <message>
            <source>%1 deg of the bark seen and no sensor positions: the diameter may be biased</source>
            <translation>看到树皮的 %1 度且没有传感器位置:直径可能有偏差</translation>
        </message>
        <message>
            <source>wide interval: +-%1 cm</source>
            <translation>置信区间宽:+-%1 cm</translation>
        </message>
        <message>
            <source>few points: %1 on the bark, %2 in each section</source>
            <translation>点数少:树皮上 %1 个,每个断面 %2 个</translation>
        </message>
        <message>
            <source>breast height hidden: extrapolated from %1 to %2 m</source>
            <translation>胸高处被遮挡:由 %1 至 %2 m 外推</translation>
        </message>
        <message>
            <source>breast height hidden: interpolated between %1 and %2 m</source>
            <translation>胸高处被遮挡:在 %1 与 %2 m 之间内插</translation>
        </message>
        <message>
            <source>only %1 sections</source>
            <translation>仅 %1 个断面</translation>
        </message>
        <message>
            <source>%1 % of the points lie inside</source>
            <translation>%1 % 的点位于圆内</translation>
        </message>
        <message>
            <source>on %1 deg of the bark the points lie inside the circle</source>
            <translation>在树皮的 %1 度范围内,点位于圆内</translation>
        </message>
        <message>
            <source>the bark hardly stands out: %1 times as dense as beside it</source>
            <translation>树皮不明显:密度仅为旁边的 %1 倍</translation>
        </message>
        <message>
            <source>rough or blurred bark: %1 cm</source>
            <translation>树皮粗糙或模糊:%1 cm</translation>
        </message>
        <message>
            <source>passes disagree by %1 cm</source>
            <translation>各次经过相差 %1 cm</translation>
        </message>
        <message>
            <source>seen on %1 deg and fitted as narrowing by %2 cm per metre, as stems seldom do: taper and diameter may be mistaken for one another</source>
            <translation>只看到 %1 度，拟合结果每米变细 %2 厘米，树干很少如此：尖削度和直径可能被混淆</translation>
        </message>
        <message>
            <source>narrows by %1 cm per metre at breast height: a root flare, a buttress, or a bank that stands above the terrain</source>
            <translation>胸高处每米变细 %1 厘米：根部膨大、板根，或高出地面模型的土坎</translation>
        </message>
        <message>
            <source>wider above than below</source>
            <translation>上粗下细</translation>
        </message>
        <message>
            <source>%1 % of the rays pass through</source>
            <translation>%1 % 的射线穿过</translation>
        </message>
        <message>
            <source>leans %1 deg</source>
            <translation>倾斜 %1 度</translation>
        </message>
        <message>
            <source>forks at about %1 m: counted once</source>
            <translation>约 %1 m 处分叉:计为一株</translation>
        </message>
        <message>
            <source>goes on %1 m below the terrain: the ground is wrong here, %2 m is not breast height</source>
            <translation>伸入地形面以下 %1 m:此处地面有误,%2 m 不是胸高</translation>
        </message>
        <message>
            <source>begins %1 m above a terrain that was not seen here: breast height is uncertain</source>
            <translation>起于此处未见地面之上 %1 m:胸高不确定</translation>
        </message>
        <message>
            <source>no ground seen within %1 m: the terrain is interpolated here</source>
            <translation>%1 m 内未见地面:此处地形为内插</translation>
        </message>
        <message>
            <source>begins at the lowest points of the cloud and does not widen there: its foot may be missing</source>
            <translation>从点云最低处开始,且在该处没有变粗:树干基部可能缺失</translation>
        </message>
        <message>
            <source>ends %1 m above ground: a stump, a post, a person?</source>
            <translation>在离地 %1 m 处终止:树桩、立柱还是人?</translation>
        </message>
        <message>
            <source>added by hand</source>
            <translation>人工添加</translation>
        </message>
        <message>
            <source>added by hand, circle fitted to the slice</source>
            <translation>人工添加,圆按横切面拟合</translation>
        </message>
        <message>
            <source>split from %1 by hand</source>
            <translation>由 %1 人工拆分</translation>
        </message>
        <message>
            <source>not round: points scatter by %1 cm, more than on other stems: a tape may read %2 cm more</source>
            <translation>断面不圆:点的离散为 %1 cm,大于其他树干:围尺读数可能多 %2 cm</translation>
        </message>
    </context>
</TS>
