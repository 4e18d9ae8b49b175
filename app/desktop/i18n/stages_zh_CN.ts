<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>stages</name>
        <message>
            <source>Find hedge rows</source>
            <translation>查找树篱行</translation>
        </message>
        <message>
            <source>Evaluate a plot</source>
            <translation>评价样地</translation>
        </message>
        <message>
            <source>Project positions</source>
            <translation>投影坐标</translation>
        </message>
        <message>
            <source>Model the ground</source>
            <translation>构建地面模型</translation>
        </message>
        <message>
            <source>Read a point cloud</source>
            <translation>读取点云</translation>
        </message>
        <message>
            <source>Read a scan</source>
            <translation>读取扫描数据</translation>
        </message>
        <message>
            <source>Read a table</source>
            <translation>读取表格</translation>
        </message>
        <message>
            <source>Read a track</source>
            <translation>读取航迹</translation>
        </message>
        <message>
            <source>Read a trajectory</source>
            <translation>读取轨迹</translation>
        </message>
        <message>
            <source>Write the report</source>
            <translation>生成报告</translation>
        </message>
        <message>
            <source>Write the rows</source>
            <translation>输出种植行</translation>
        </message>
        <message>
            <source>Write the steering test</source>
            <translation>输出导航试验报告</translation>
        </message>
        <message>
            <source>Edit rows</source>
            <translation>编辑种植行</translation>
        </message>
        <message>
            <source>Find plant rows</source>
            <translation>识别种植行</translation>
        </message>
        <message>
            <source>Level a frame</source>
            <translation>单帧调平</translation>
        </message>
        <message>
            <source>Cluster into plants</source>
            <translation>植株聚类</translation>
        </message>
        <message>
            <source>Place stems on the map</source>
            <translation>将树干置于地图</translation>
        </message>
        <message>
            <source>Drop lone points</source>
            <translation>剔除孤立点</translation>
        </message>
        <message>
            <source>Cut a region</source>
            <translation>裁剪区域</translation>
        </message>
        <message>
            <source>Remove the ground</source>
            <translation>去除地面</translation>
        </message>
        <message>
            <source>Find trunk centres</source>
            <translation>提取树干中心</translation>
        </message>
        <message>
            <source>Thin by voxels</source>
            <translation>体素抽稀</translation>
        </message>
        <message>
            <source>Simultaneous localization and mapping</source>
            <translation>同步定位与建图(SLAM)</translation>
        </message>
        <message>
            <source>Measure steering errors</source>
            <translation>测定导航误差</translation>
        </message>
        <message>
            <source>Simulate a steering test</source>
            <translation>模拟导航试验</translation>
        </message>
        <message>
            <source>Tune the steering</source>
            <translation>导航参数整定</translation>
        </message>
        <message>
            <source>Edit stems</source>
            <translation>编辑单木</translation>
        </message>
        <message>
            <source>Measure stems</source>
            <translation>测定单木</translation>
        </message>
        <message>
            <source>Breast-height slice</source>
            <translation>胸高切片</translation>
        </message>
        <message>
            <source>Find the plot frame</source>
            <translation>确定样地坐标系</translation>
        </message>
        <message>
            <source>Plot boundary and minimum diameter</source>
            <translation>界定计入的树木</translation>
        </message>
    </context>
</TS>
