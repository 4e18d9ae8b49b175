<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>figures</name>
        <message>
            <source>Distances between plants</source>
            <translation>株距</translation>
        </message>
        <message>
            <source>Along the row (m)</source>
            <translation>沿行 (m)</translation>
        </message>
        <message>
            <source>Distance to the next plant (m)</source>
            <translation>到下一株的距离 (m)</translation>
        </message>
        <message>
            <source>Select a row of plants</source>
            <translation>请选择一行植株</translation>
        </message>
        <message>
            <source>median %1 m   distances %2   gaps %3</source>
            <translation>中位数 %1 m   间距 %2   缺株 %3</translation>
        </message>
        <message>
            <source>Diameters</source>
            <translation>胸径分布</translation>
        </message>
        <message>
            <source>Height over diameter</source>
            <translation>树高-胸径</translation>
        </message>
        <message>
            <source>Estimated over field</source>
            <translation>估测值-实测值</translation>
        </message>
        <message>
            <source>DBH (cm)</source>
            <translation>胸径 (cm)</translation>
        </message>
        <message>
            <source>Stems</source>
            <translation>株数</translation>
        </message>
        <message>
            <source>Height (m)</source>
            <translation>树高 (m)</translation>
        </message>
        <message>
            <source>Field DBH (cm)</source>
            <translation>实测胸径 (cm)</translation>
        </message>
        <message>
            <source>Estimated DBH (cm)</source>
            <translation>估计胸径 (cm)</translation>
        </message>
        <message>
            <source>No diameters yet</source>
            <translation>尚无胸径</translation>
        </message>
        <message>
            <source>No heights yet</source>
            <translation>尚无树高</translation>
        </message>
        <message>
            <source>No field measurements are matched</source>
            <translation>没有匹配的实测数据</translation>
        </message>
        <message>
            <source>n %1   bias %2 cm   RMSE %3 cm</source>
            <translation>n %1   偏差 %2 cm   RMSE %3 cm</translation>
        </message>
        <message>
            <source>no points at this height</source>
            <translation>此高度没有点</translation>
        </message>
        <message>
            <source>Along the line (m)</source>
            <translation>沿剖面线 (m)</translation>
        </message>
        <message>
            <source>Across (m)</source>
            <translation>横向 (m)</translation>
        </message>
        <message>
            <source>Height above ground (m)</source>
            <translation>离地高度 (m)</translation>
        </message>
        <message>
            <source>Distance walked (m)</source>
            <translation>路程 (m)</translation>
        </message>
        <message>
            <source>Error (cm)</source>
            <translation>误差 (cm)</translation>
        </message>
        <message>
            <source>error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>horizontal</source>
            <translation>水平</translation>
        </message>
        <message>
            <source>vertical</source>
            <translation>垂直</translation>
        </message>
        <message>
            <source>at the centre</source>
            <translation>视图中心处</translation>
        </message>
        <message>
            <source>at the centre, grid %1 m</source>
            <translation>视图中心处，格网 %1 m</translation>
        </message>
        <message>
            <source>grid %1 m</source>
            <translation>格网 %1 m</translation>
        </message>
        <message>
            <source>at the centre, contour lines %1 m</source>
            <translation>视图中心处，等高距 %1 m</translation>
        </message>
        <message>
            <source>at the centre, grid %1 m, contour lines %2 m</source>
            <translation>视图中心处，格网 %1 m，等高距 %2 m</translation>
        </message>
        <message>
            <source>grid %1 m, contour lines %2 m</source>
            <translation>格网 %1 m，等高距 %2 m</translation>
        </message>
        <message>
            <source>contour lines %1 m</source>
            <translation>等高距 %1 m</translation>
        </message>
        <message>
            <source>height above ground (m)</source>
            <translation>离地高度 (m)</translation>
        </message>
        <message>
            <source>intensity</source>
            <translation>强度</translation>
        </message>
        <message>
            <source>time (s)</source>
            <translation>时间 (s)</translation>
        </message>
        <message>
            <source>range (m)</source>
            <translation>距离 (m)</translation>
        </message>
        <message>
            <source>ring</source>
            <translation>激光通道</translation>
        </message>
        <message>
            <source>scan angle (°)</source>
            <translation>扫描角 (°)</translation>
        </message>
        <message>
            <source>return number</source>
            <translation>回波序号</translation>
        </message>
        <message>
            <source>number of returns</source>
            <translation>回波数</translation>
        </message>
        <message>
            <source>a colour for each tree id</source>
            <translation>每个单木一种颜色</translation>
        </message>
        <message>
            <source>a colour for each pass</source>
            <translation>每个行走遍次一种颜色</translation>
        </message>
        <message>
            <source>a colour for each keyframe</source>
            <translation>每个关键帧一种颜色</translation>
        </message>
        <message>
            <source>a colour for each classification</source>
            <translation>每个分类一种颜色</translation>
        </message>
        <message>
            <source>a colour for each point source id</source>
            <translation>每个点源一种颜色</translation>
        </message>
        <message>
            <source>a colour for each stem</source>
            <translation>每个树干一种颜色</translation>
        </message>
        <message>
            <source>a colour for each plant</source>
            <translation>每个植株一种颜色</translation>
        </message>
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
            <source>accepted</source>
            <translation>已接受</translation>
        </message>
        <message>
            <source>rejected</source>
            <translation>已拒绝</translation>
        </message>
        <message>
            <source>Distance (m), unsigned</source>
            <translation>距离 (m),无符号</translation>
        </message>
        <message>
            <source>Distance from surface (m), unsigned</source>
            <translation>到表面的距离 (m),无符号</translation>
        </message>
        <message>
            <source>Height difference (m), signed: + is higher</source>
            <translation>高差 (m),有符号:+ 为更高</translation>
        </message>
        <message>
            <source>Points (%)</source>
            <translation>点 (%)</translation>
        </message>
        <message>
            <source>median %1 m</source>
            <translation>中位数 %1 m</translation>
        </message>
        <message>
            <source>median beyond %1 m</source>
            <translation>中位数超过 %1 m</translation>
        </message>
        <message>
            <source>%1 % below %2 m</source>
            <translation>%1 % 小于 %2 m</translation>
        </message>
        <message>
            <source>%1 % reach beyond %2 m</source>
            <translation>%1 % 分位数超过 %2 m</translation>
        </message>
        <message>
            <source>%1 % from %2 to %3 m</source>
            <translation>%1 % 在 %2 至 %3 m 之间</translation>
        </message>
        <message>
            <source>%1 % below %2 m, not drawn</source>
            <translation>%1 % 小于 %2 m,未画出</translation>
        </message>
        <message>
            <source>&lt; %1 % below %2 m, not drawn</source>
            <translation>不足 %1 % 小于 %2 m,未画出</translation>
        </message>
        <message>
            <source>%1 % above %2 m, not drawn</source>
            <translation>%1 % 大于 %2 m,未画出</translation>
        </message>
        <message>
            <source>&lt; %1 % above %2 m, not drawn</source>
            <translation>不足 %1 % 大于 %2 m,未画出</translation>
        </message>
        <message>
            <source>%1 % have nothing within %2 m</source>
            <translation>%1 % 在 %2 m 内没有对应点</translation>
        </message>
        <message>
            <source>&lt; %1 % have nothing within %2 m</source>
            <translation>不足 %1 % 在 %2 m 内没有对应点</translation>
        </message>
        <message>
            <source>No point has anything within %1 m</source>
            <translation>在 %1 m 内没有点有对应点</translation>
        </message>
    </context>
</TS>
