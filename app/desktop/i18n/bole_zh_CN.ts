<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
    <context>
        <name>QObject</name>
        <message>
            <source>%1 (%2)</source>
            <translation>%1(%2)</translation>
        </message>
        <message>
            <source>%1 or %2</source>
            <translation>%1 或 %2</translation>
        </message>
        <message>
            <source>, </source>
            <comment>formats</comment>
            <translation>、</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1:%2</translation>
        </message>
        <message>
            <source>%1 stems</source>
            <translation>%1 株单木</translation>
        </message>
        <message>
            <source>ATE %1 cm</source>
            <translation>绝对轨迹误差 %1 cm</translation>
        </message>
        <message>
            <source>DBH bias %1 cm</source>
            <translation>胸径偏差 %1 cm</translation>
        </message>
        <message>
            <source>path of %1 m</source>
            <translation>路径长 %1 m</translation>
        </message>
        <message>
            <source>waiting</source>
            <translation>等待中</translation>
        </message>
        <message>
            <source>running</source>
            <translation>运行中</translation>
        </message>
        <message>
            <source>done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>ended early</source>
            <translation>提前结束</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>失败</translation>
        </message>
        <message>
            <source>cancelled</source>
            <translation>已取消</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 秒</translation>
        </message>
        <message>
            <source>%1:%2 min</source>
            <translation>%1:%2 分</translation>
        </message>
        <message>
            <source>%1:%2:%3 h</source>
            <translation>%1:%2:%3 时</translation>
        </message>
        <message>
            <source>on</source>
            <translation>开</translation>
        </message>
        <message>
            <source>off</source>
            <translation>关</translation>
        </message>
        <message>
            <source>on or off</source>
            <translation>开或关</translation>
        </message>
        <message>
            <source>text</source>
            <translation>文本</translation>
        </message>
        <message>
            <source>one of %1</source>
            <translation>可选 %1</translation>
        </message>
        <message>
            <source>a whole number from %1 to %2</source>
            <translation>%1 至 %2 的整数</translation>
        </message>
        <message>
            <source>a number from %1 to %2</source>
            <translation>%1 至 %2 的数值</translation>
        </message>
        <message>
            <source>%1, or %2</source>
            <translation>%1,或 %2</translation>
        </message>
        <message>
            <source>add stem</source>
            <translation>添加单木</translation>
        </message>
        <message>
            <source>delete stem</source>
            <translation>删除单木</translation>
        </message>
        <message>
            <source>move stem</source>
            <translation>移动单木</translation>
        </message>
        <message>
            <source>change diameter</source>
            <translation>修改胸径</translation>
        </message>
        <message>
            <source>change height</source>
            <translation>修改树高</translation>
        </message>
        <message>
            <source>split stem</source>
            <translation>拆分单木</translation>
        </message>
        <message>
            <source>merge stems</source>
            <translation>合并单木</translation>
        </message>
        <message>
            <source>accept stem</source>
            <translation>接受单木</translation>
        </message>
        <message>
            <source>reject stem</source>
            <translation>拒绝单木</translation>
        </message>
        <message>
            <source>note on stem</source>
            <translation>单木备注</translation>
        </message>
        <message>
            <source>set species</source>
            <translation>设置树种</translation>
        </message>
        <message>
            <source>tilt stem</source>
            <translation>倾斜单木</translation>
        </message>
        <message>
            <source>take back decisions (%1)</source>
            <translation>撤回决定 (%1)</translation>
        </message>
        <message>
            <source>change row</source>
            <translation>修改行</translation>
        </message>
        <message>
            <source>change plant</source>
            <translation>修改植株</translation>
        </message>
        <message>
            <source>decide loop closure</source>
            <translation>判定回环</translation>
        </message>
        <message>
            <source>points to a tree</source>
            <translation>点归于单木</translation>
        </message>
        <message>
            <source>points to no tree</source>
            <translation>点不属于任何树</translation>
        </message>
        <message>
            <source>points to the ground</source>
            <translation>点归于地面</translation>
        </message>
        <message>
            <source>points to noise</source>
            <translation>点归于噪声</translation>
        </message>
        <message>
            <source>%1 m</source>
            <translation>%1 米</translation>
        </message>
        <message>
            <source>%1 km</source>
            <translation>%1 千米</translation>
        </message>
        <message>
            <source>Thinned to %1 of %2 points: more would take more than the memory for them.</source>
            <translation>抽稀为 %2 个点中的 %1 个:再多将超出用于点的内存。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::ChartView</name>
        <message>
            <source>Run the pipeline to see its stems.</source>
            <translation>运行流程后可见单木。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CompareWindow</name>
        <message>
            <source>All numbers</source>
            <translation>全部数值</translation>
        </message>
        <message>
            <source>Runs %1 and %2 - Bole</source>
            <translation>运行 %1 与 %2 - Bole</translation>
        </message>
        <message>
            <source>Cameras linked</source>
            <translation>联动相机</translation>
        </message>
        <message>
            <source>Run %1: %2</source>
            <translation>运行 %1:%2</translation>
        </message>
        <message>
            <source>No reference path: give the file of one to see the error along the path.</source>
            <translation>没有参考轨迹:指定参考轨迹文件后可查看沿路径的误差。</translation>
        </message>
        <message>
            <source>Stage</source>
            <translation>步骤</translation>
        </message>
        <message>
            <source>Number</source>
            <translation>编号</translation>
        </message>
        <message>
            <source>Run %1</source>
            <translation>运行 %1</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>差值</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>option</source>
            <translation>参数</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FieldCheck</name>
        <message>
            <source>Load field measurements…</source>
            <translation>载入样地实测数据…</translation>
        </message>
        <message>
            <source>field measurements</source>
            <translation>样地实测数据</translation>
        </message>
        <message>
            <source>Add a stem here, fitted to the points</source>
            <translation>在此处添加单木(按点云拟合)</translation>
        </message>
        <message>
            <source>No field measurements yet.</source>
            <translation>尚无样地实测数据。</translation>
        </message>
        <message>
            <source>%1 matched, %2 missed, %3 false</source>
            <translation>匹配 %1 株,漏检 %2 株,误检 %3 株</translation>
        </message>
        <message>
            <source>diameters: bias %1 cm, RMSE %2 cm</source>
            <translation>胸径:偏差 %1 cm,均方根误差 %2 cm</translation>
        </message>
        <message>
            <source>Field check</source>
            <translation>实测检核</translation>
        </message>
        <message>
            <source>Load field measurements</source>
            <translation>载入样地实测数据</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt)</source>
            <translation>表格 (*.csv *.txt)</translation>
        </message>
        <message>
            <source>Select a tree that was missed.</source>
            <translation>请选择一株漏检的树。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FieldListDialog</name>
        <message>
            <source>East</source>
            <translation>东坐标</translation>
        </message>
        <message>
            <source>North</source>
            <translation>北坐标</translation>
        </message>
        <message>
            <source>Diameter at breast height</source>
            <translation>胸径</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>树高</translation>
        </message>
        <message>
            <source>Tree number</source>
            <translation>树号</translation>
        </message>
        <message>
            <source>Species</source>
            <translation>树种</translation>
        </message>
        <message>
            <source>Azimuth from the centre</source>
            <translation>自样地中心的方位角</translation>
        </message>
        <message>
            <source>Distance from the centre</source>
            <translation>至样地中心的距离</translation>
        </message>
        <message>
            <source>Columns of %1</source>
            <translation>%1 的列</translation>
        </message>
        <message numerus="yes">
            <source>%n tree(s) in the list. Which column is what?</source>
            <translation>
                <numerusform>清单中有 %n 株树。各列分别是什么?</numerusform>
            </translation>
        </message>
        <message>
            <source>The list has the axes of the map</source>
            <translation>清单与树干图坐标系相同</translation>
        </message>
        <message>
            <source>Shift the map onto the list</source>
            <translation>平移树干图以对准清单</translation>
        </message>
        <message>
            <source>Shift and turn the map onto the list</source>
            <translation>平移并旋转树干图以对准清单</translation>
        </message>
        <message>
            <source>Origin and north are unknown: search</source>
            <translation>原点和北方向未知:自动搜索</translation>
        </message>
        <message>
            <source>(none)</source>
            <translation>(无)</translation>
        </message>
        <message>
            <source>Trees need a place: east and north, or azimuth and distance.</source>
            <translation>树木需要位置:东坐标和北坐标,或方位角和距离。</translation>
        </message>
        <message>
            <source>Trees need a diameter.</source>
            <translation>树木需要胸径。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FigureDialog</name>
        <message>
            <source>Save…</source>
            <translation>保存…</translation>
        </message>
        <message>
            <source>Export a figure</source>
            <translation>导出图件</translation>
        </message>
        <message>
            <source> mm</source>
            <translation> 毫米</translation>
        </message>
        <message>
            <source>Width of a figure across the page; small charts take half of it</source>
            <translation>通栏图件的宽度;小图表占其一半</translation>
        </message>
        <message>
            <source> dpi</source>
            <translation> dpi</translation>
        </message>
        <message>
            <source>Pixels per inch of a PNG, and of the picture in a map</source>
            <translation>PNG 以及地图中影像每英寸的像素数</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>图件</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>宽度</translation>
        </message>
        <message>
            <source>Resolution</source>
            <translation>分辨率</translation>
        </message>
        <message>
            <source>Format</source>
            <translation>格式</translation>
        </message>
        <message>
            <source>Save figure</source>
            <translation>保存图件</translation>
        </message>
        <message>
            <source>%1 x %2 mm, %3 x %4 pixels as PNG</source>
            <translation>%1 x %2 毫米,PNG 为 %3 x %4 像素</translation>
        </message>
        <message>
            <source>; the first of %1 pages</source>
            <translation>;共 %1 页中的第一页</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FrameBar</name>
        <message>
            <source>One frame back (,)</source>
            <translation>后退一帧 (,)</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>播放</translation>
        </message>
        <message>
            <source>One frame on (.)</source>
            <translation>前进一帧 (.)</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::HistoryPanel</name>
        <message>
            <source>Edit</source>
            <translation>编辑</translation>
        </message>
        <message>
            <source>By</source>
            <translation>编辑者</translation>
        </message>
        <message>
            <source>At</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>运行</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Changed options</source>
            <translation>更改的参数</translation>
        </message>
        <message>
            <source>Show again</source>
            <translation>重新显示</translation>
        </message>
        <message>
            <source>Take its options</source>
            <translation>采用其参数</translation>
        </message>
        <message>
            <source>Compare two</source>
            <translation>比较两次运行</translation>
        </message>
        <message>
            <source>Shows what this run gave, from the cache</source>
            <translation>从缓存中显示该次运行的结果</translation>
        </message>
        <message>
            <source>Sets the options of the document to those of this run; can be undone</source>
            <translation>将流程参数设为该次运行的参数;可撤销</translation>
        </message>
        <message>
            <source>Opens two chosen runs side by side</source>
            <translation>并排打开所选的两次运行</translation>
        </message>
        <message>
            <source>As opened</source>
            <translation>打开时的状态</translation>
        </message>
        <message>
            <source> (ended early)</source>
            <translation>(提前结束)</translation>
        </message>
        <message>
            <source>options of run %1</source>
            <translation>运行 %1 的参数</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::JobsPanel</name>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Keep result</source>
            <translation>保留当前结果</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>运行</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>进度</translation>
        </message>
        <message>
            <source>Elapsed</source>
            <translation>已用时间</translation>
        </message>
        <message>
            <source>Left</source>
            <translation>剩余时间</translation>
        </message>
        <message>
            <source>Ends the run and throws its work away; a waiting run is taken off the list</source>
            <translation>结束运行并放弃其结果;等待中的运行将从列表中移除</translation>
        </message>
        <message>
            <source>Ends the stage in work with what it has; the stages after it run on that</source>
            <translation>以当前结果结束正在运行的步骤;后续步骤在此基础上继续</translation>
        </message>
        <message>
            <source>%1 of %2  %3: %4</source>
            <translation>%1 / %2  %3:%4</translation>
        </message>
        <message>
            <source>%1 in this stage</source>
            <translation>本步骤 %1</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::LogPanel</name>
        <message>
            <source>Copy</source>
            <translation>复制</translation>
        </message>
        <message>
            <source>All</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Errors</source>
            <translation>错误</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>搜索</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::MainWindow</name>
        <message>
            <source>Saved: %1</source>
            <translation>已保存：%1</translation>
        </message>
        <message>
            <source>Bole</source>
            <translation>Bole</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>文件(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>编辑(&amp;E)</translation>
        </message>
        <message>
            <source>&amp;Run</source>
            <translation>运行(&amp;R)</translation>
        </message>
        <message>
            <source>&amp;Stem</source>
            <translation>单木(&amp;S)</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>视图(&amp;V)</translation>
        </message>
        <message>
            <source>&amp;Tools</source>
            <translation>工具(&amp;T)</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>帮助(&amp;H)</translation>
        </message>
        <message>
            <source>Filter: words, or conditions such as dbh_cm &gt; 20 quality = poor</source>
            <translation>筛选:关键词,或条件,如 dbh_cm &gt; 20 quality = poor</translation>
        </message>
        <message>
            <source>Pipeline</source>
            <translation>处理流程</translation>
        </message>
        <message>
            <source>Options</source>
            <translation>参数</translation>
        </message>
        <message>
            <source>Stems</source>
            <translation>单木</translation>
        </message>
        <message>
            <source>Chart</source>
            <translation>图表</translation>
        </message>
        <message>
            <source>Log</source>
            <translation>日志</translation>
        </message>
        <message>
            <source>Slice</source>
            <translation>横切面</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>纵剖面</translation>
        </message>
        <message>
            <source>Changes were not saved</source>
            <translation>更改未保存</translation>
        </message>
        <message>
            <source>A run is under way</source>
            <translation>正在运行</translation>
        </message>
        <message>
            <source>Cancel the run and close?</source>
            <translation>取消运行并关闭?</translation>
        </message>
        <message>
            <source>Changes are not saved</source>
            <translation>更改尚未保存</translation>
        </message>
        <message>
            <source>Save the changes to the pipeline?</source>
            <translation>要将更改保存到流程文件吗?</translation>
        </message>
        <message>
            <source>Open…</source>
            <translation>打开…</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>Pipelines, clouds, scans</source>
            <translation>流程、点云、扫描数据</translation>
        </message>
        <message>
            <source>Save pipeline</source>
            <translation>保存流程</translation>
        </message>
        <message>
            <source>Save pipeline as…</source>
            <translation>流程另存为…</translation>
        </message>
        <message>
            <source>Export survey and report…</source>
            <translation>导出调查成果和报告…</translation>
        </message>
        <message>
            <source>Export survey and report</source>
            <translation>导出调查成果和报告</translation>
        </message>
        <message>
            <source>Open report</source>
            <translation>打开报告</translation>
        </message>
        <message>
            <source>Quit</source>
            <translation>退出</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>撤销</translation>
        </message>
        <message>
            <source>Redo</source>
            <translation>重做</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>语言</translation>
        </message>
        <message>
            <source>Save layout…</source>
            <translation>保存布局…</translation>
        </message>
        <message>
            <source>Save layout</source>
            <translation>保存布局</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>名称</translation>
        </message>
        <message>
            <source>Delete layout</source>
            <translation>删除布局</translation>
        </message>
        <message>
            <source>Panels</source>
            <translation>面板</translation>
        </message>
        <message>
            <source>Layouts</source>
            <translation>布局</translation>
        </message>
        <message>
            <source>Mode</source>
            <translation>模式</translation>
        </message>
        <message>
            <source>From scans to a stem map</source>
            <translation>从扫描到单木分布图</translation>
        </message>
        <message>
            <source>Open a scan, a point cloud or a pipeline…</source>
            <translation>打开扫描数据、点云或处理流程…</translation>
        </message>
        <message>
            <source>or drop a file on this window</source>
            <translation>或将文件拖放到此窗口</translation>
        </message>
        <message>
            <source>Open recent</source>
            <translation>最近打开</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>运行</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>快捷键</translation>
        </message>
        <message>
            <source>Search keys</source>
            <translation>搜索快捷键</translation>
        </message>
        <message>
            <source>Action</source>
            <translation>操作</translation>
        </message>
        <message>
            <source>Key</source>
            <translation>按键</translation>
        </message>
        <message>
            <source>About Bole</source>
            <translation>关于 Bole</translation>
        </message>
        <message>
            <source>&lt;b&gt;Bole %1&lt;/b&gt;&lt;p&gt;Raw LiDAR scans of forests in, a survey that a forester can sign out. Free software under the GPL, version 3 or later.</source>
            <translation>&lt;b&gt;Bole %1&lt;/b&gt;&lt;p&gt;输入森林原始激光雷达扫描数据,输出林业人员可以签字确认的调查成果。自由软件,遵循 GPL 第 3 版或更新版本。</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>主题</translation>
        </message>
        <message>
            <source>As the system</source>
            <translation>跟随系统</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>浅色</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>深色</translation>
        </message>
        <message>
            <source>Pipelines</source>
            <translation>流程</translation>
        </message>
        <message>
            <source>The program ended before changes to %1 were saved. Restore them?</source>
            <translation>程序在保存对 %1 的更改之前退出。要恢复这些更改吗?</translation>
        </message>
        <message>
            <source>Open folder…</source>
            <translation>打开文件夹…</translation>
        </message>
        <message>
            <source>Open a folder with a scan or with views…</source>
            <translation>打开含扫描或视图的文件夹…</translation>
        </message>
        <message>
            <source>All commands…</source>
            <translation>所有命令…</translation>
        </message>
        <message>
            <source>Open a folder…</source>
            <translation>打开文件夹…</translation>
        </message>
        <message>
            <source>Try the sample plot</source>
            <translation>试用示例样地</translation>
        </message>
        <message>
            <source>&lt;b&gt;%1&lt;/b&gt; has changes of %2 that were not saved.</source>
            <translation>&lt;b&gt;%1&lt;/b&gt; 有 %2 的更改未保存。</translation>
        </message>
        <message>
            <source>Restore</source>
            <translation>恢复</translation>
        </message>
        <message>
            <source>Discard</source>
            <translation>放弃</translation>
        </message>
        <message>
            <source>Recent files</source>
            <translation>最近的文件</translation>
        </message>
        <message>
            <source>File</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Stem</source>
            <translation>单木</translation>
        </message>
        <message>
            <source>View</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>测量</translation>
        </message>
        <message>
            <source>Lessons</source>
            <translation>课程</translation>
        </message>
        <message>
            <source>Memory for points on disk</source>
            <translation>磁盘点云的内存</translation>
        </message>
        <message>
            <source>%1 MiB</source>
            <translation>%1 MiB</translation>
        </message>
        <message>
            <source>%1 GiB</source>
            <translation>%1 GiB</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::MeasurePanel</name>
        <message>
            <source>Delete</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>Export CSV…</source>
            <translation>导出 CSV…</translation>
        </message>
        <message>
            <source>Measurement</source>
            <translation>量测</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>数值</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>Double click: look at it. F2: rename.</source>
            <translation>双击:查看。F2:重命名。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::MeasureTool</name>
        <message>
            <source>Point</source>
            <translation>点</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>角度</translation>
        </message>
        <message>
            <source>Ring</source>
            <translation>直径环</translation>
        </message>
        <message>
            <source>Click a point.</source>
            <translation>请点击一个点。</translation>
        </message>
        <message>
            <source>Click where the distance begins.</source>
            <translation>请点击距离起点。</translation>
        </message>
        <message>
            <source>Click where it ends.</source>
            <translation>请点击终点。</translation>
        </message>
        <message>
            <source>Click a point on the first arm.</source>
            <translation>请点击第一条边上的点。</translation>
        </message>
        <message>
            <source>Click the corner.</source>
            <translation>请点击顶点。</translation>
        </message>
        <message>
            <source>Click a point on the second arm.</source>
            <translation>请点击第二条边上的点。</translation>
        </message>
        <message>
            <source>Click point %1 of 3 on the bark; with Shift the ring is not fitted to the points around.</source>
            <translation>请在树皮上点击第 %1 个点(共 3 个);按住 Shift 则圆环不按周围点拟合。</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>量测</translation>
        </message>
        <message>
            <source>Export measurements</source>
            <translation>导出量测</translation>
        </message>
        <message>
            <source>Tables (*.csv)</source>
            <translation>表格 (*.csv)</translation>
        </message>
        <message>
            <source>Measure a point</source>
            <translation>量测点</translation>
        </message>
        <message>
            <source>Measure a distance</source>
            <translation>量测距离</translation>
        </message>
        <message>
            <source>Measure an angle</source>
            <translation>量测角度</translation>
        </message>
        <message>
            <source>Measure a diameter by three points</source>
            <translation>三点量测直径</translation>
        </message>
        <message>
            <source>End measuring or drawing</source>
            <translation>结束量测或绘制</translation>
        </message>
        <message>
            <source>There is no point here. Click one that is drawn.</source>
            <translation>此处没有点。请点击已显示的点。</translation>
        </message>
        <message>
            <source>The three points lie on one line. Click them around the stem.</source>
            <translation>三点共线。请环绕树干点击。</translation>
        </message>
        <message>
            <source>measure</source>
            <translation>量测</translation>
        </message>
        <message>
            <source>delete a measurement</source>
            <translation>删除量测</translation>
        </message>
        <message>
            <source>rename a measurement</source>
            <translation>重命名量测</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::NovelView</name>
        <message>
            <source>Show the trained field</source>
            <translation>显示训练好的辐射场</translation>
        </message>
        <message>
            <source>Run a pipeline that trains a field first.</source>
            <translation>请先运行训练辐射场的处理流程。</translation>
        </message>
        <message>
            <source>Renders the field from where you look, instead of the points</source>
            <translation>从当前视点渲染辐射场以代替点</translation>
        </message>
        <message>
            <source>The field is shown in perspective. Parallel views show the points.</source>
            <translation>辐射场以透视方式显示。平行视图显示点。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PipelinePanel</name>
        <message>
            <source>Stage</source>
            <translation>步骤</translation>
        </message>
        <message>
            <source>3-D</source>
            <translation>三维</translation>
        </message>
        <message>
            <source>Cut</source>
            <translation>切面</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>What the 3-D view shows: a click on an eye hides the outputs of a stage</source>
            <translation>三维视图显示的内容:点击眼睛图标可隐藏该步骤的输出</translation>
        </message>
        <message>
            <source>What slice and profile show</source>
            <translation>横切面和纵剖面显示的内容</translation>
        </message>
        <message>
            <source>add %1</source>
            <translation>添加 %1</translation>
        </message>
        <message>
            <source>delete %1</source>
            <translation>删除 %1</translation>
        </message>
        <message>
            <source>rename %1</source>
            <translation>重命名 %1</translation>
        </message>
        <message>
            <source>copy %1</source>
            <translation>复制 %1</translation>
        </message>
        <message>
            <source>Rename stage…</source>
            <translation>重命名步骤…</translation>
        </message>
        <message>
            <source>Rename stage</source>
            <translation>重命名步骤</translation>
        </message>
        <message>
            <source>Name of the stage</source>
            <translation>步骤名称</translation>
        </message>
        <message>
            <source>Copy stage and what follows</source>
            <translation>复制此步骤及后续步骤</translation>
        </message>
        <message>
            <source>Delete stage</source>
            <translation>删除步骤</translation>
        </message>
        <message>
            <source>Add stage behind</source>
            <translation>在其后添加步骤</translation>
        </message>
        <message>
            <source>Select a stage first.</source>
            <translation>请先选择一个步骤。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlantEditor</name>
        <message>
            <source>There is no point here. Click one that is drawn.</source>
            <translation>此处没有点。请点击画出的点。</translation>
        </message>
        <message>
            <source>Run a pipeline first that measures a plant and takes edits.</source>
            <translation>请先运行测量植株并接受编辑的处理流程。</translation>
        </message>
        <message>
            <source>Plant</source>
            <translation>植株</translation>
        </message>
        <message>
            <source>Set the base of the stem by a click</source>
            <translation>点击设定茎基</translation>
        </message>
        <message>
            <source>Click</source>
            <translation>点击</translation>
        </message>
        <message>
            <source>Handles of base and height of measurement</source>
            <translation>茎基和测量高度的手柄</translation>
        </message>
        <message>
            <source>Handles</source>
            <translation>手柄</translation>
        </message>
        <message>
            <source>Cut off what an outline goes around</source>
            <translation>切除轮廓线所围的点</translation>
        </message>
        <message>
            <source>Outline</source>
            <translation>轮廓线</translation>
        </message>
        <message>
            <source>Cut off what lies in the clip box</source>
            <translation>切除裁剪框内的点</translation>
        </message>
        <message>
            <source>Clip box</source>
            <translation>裁剪框</translation>
        </message>
        <message>
            <source>Measure a plant and set a clip box around the points first.</source>
            <translation>请先测量植株并在这些点周围设置裁剪框。</translation>
        </message>
        <message>
            <source>Accept the plant</source>
            <translation>接受植株</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>接受</translation>
        </message>
        <message>
            <source>Reject the plant</source>
            <translation>拒绝植株</translation>
        </message>
        <message>
            <source>Reject</source>
            <translation>拒绝</translation>
        </message>
        <message>
            <source>Give a measured value…</source>
            <translation>给出实测值…</translation>
        </message>
        <message>
            <source>Value…</source>
            <translation>数值…</translation>
        </message>
        <message>
            <source>Note on the plant…</source>
            <translation>为植株添加备注…</translation>
        </message>
        <message>
            <source>Note…</source>
            <translation>备注…</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>高度</translation>
        </message>
        <message>
            <source>Breadth, length</source>
            <translation>冠幅长</translation>
        </message>
        <message>
            <source>Breadth, width</source>
            <translation>冠幅宽</translation>
        </message>
        <message>
            <source>Diameter of the stem</source>
            <translation>茎直径</translation>
        </message>
        <message>
            <source>Trait</source>
            <translation>性状</translation>
        </message>
        <message>
            <source>What was measured by hand</source>
            <translation>手工测量的性状</translation>
        </message>
        <message>
            <source>Value in mm</source>
            <translation>数值 (mm)</translation>
        </message>
        <message>
            <source>Click the foot of the stem, where it leaves the soil.</source>
            <translation>请点击茎离开土壤处。</translation>
        </message>
        <message>
            <source>Draw around the points with the left mouse button. Escape ends it.</source>
            <translation>按住鼠标左键围住这些点。按 Escape 结束。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlantForm</name>
        <message>
            <source>What the points become that are outlined or lie in the clip box</source>
            <translation>轮廓线内或裁剪框内的点归为什么</translation>
        </message>
        <message>
            <source>not of the plant</source>
            <translation>不属于植株</translation>
        </message>
        <message>
            <source>noise</source>
            <translation>噪声</translation>
        </message>
        <message>
            <source>of the plant</source>
            <translation>属于植株</translation>
        </message>
        <message>
            <source>Points are</source>
            <translation>点归为</translation>
        </message>
        <message>
            <source>Plant</source>
            <translation>植株</translation>
        </message>
        <message>
            <source>%1 of the place where the stem leaves the soil</source>
            <translation>茎离开土壤处的 %1 坐标</translation>
        </message>
        <message>
            <source>Base of the stem</source>
            <translation>茎基</translation>
        </message>
        <message>
            <source>Height above the soil at which the diameter of the stem is measured</source>
            <translation>测量茎直径处距土壤的高度</translation>
        </message>
        <message>
            <source>Measure again</source>
            <translation>重新测量</translation>
        </message>
        <message>
            <source>Takes base and height over and measures the plant again</source>
            <translation>采用茎基和高度并重新测量植株</translation>
        </message>
        <message>
            <source>Stem measured at</source>
            <translation>茎测量高度</translation>
        </message>
        <message>
            <source>State: %1</source>
            <translation>状态:%1</translation>
        </message>
        <message numerus="yes">
            <source>%n edit(s)</source>
            <translation>
                <numerusform>%n 项编辑</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n no longer fit</source>
            <translation>
                <numerusform>%n 项不再适用</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlotMap</name>
        <message>
            <source>Load field measurements and run to see which trees were found.</source>
            <translation>载入样地实测数据并运行,即可查看哪些树木被检出。</translation>
        </message>
        <message>
            <source>%1 matched</source>
            <translation>匹配 %1</translation>
        </message>
        <message>
            <source>%1 missed</source>
            <translation>漏检 %1</translation>
        </message>
        <message>
            <source>%1 false</source>
            <translation>误检 %1</translation>
        </message>
        <message>
            <source>Stem %1, %2 cm</source>
            <translation>单木 %1,%2 cm</translation>
        </message>
        <message>
            <source>Field tree %1, %2 cm</source>
            <translation>实测树 %1,%2 cm</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::ProfileView</name>
        <message>
            <source>Select a stem or a row of plants to see its profile.</source>
            <translation>选择一株单木或一行植株以查看其纵剖面。</translation>
        </message>
        <message>
            <source>Select a stem to see its profile.</source>
            <translation>选择一株单木以查看其纵剖面。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PropertiesPanel</name>
        <message>
            <source>Apply at once</source>
            <translation>立即应用</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>应用</translation>
        </message>
        <message>
            <source>Reset</source>
            <translation>还原</translation>
        </message>
        <message>
            <source>Defaults</source>
            <translation>默认值</translation>
        </message>
        <message>
            <source>Search options</source>
            <translation>搜索参数</translation>
        </message>
        <message>
            <source>Basic</source>
            <translation>基本</translation>
        </message>
        <message>
            <source>Advanced</source>
            <translation>高级</translation>
        </message>
        <message>
            <source>Expert</source>
            <translation>专家</translation>
        </message>
        <message>
            <source>Changes go into the pipeline as they are made, else with Apply</source>
            <translation>更改立即写入流程;否则点击“应用”后写入</translation>
        </message>
        <message>
            <source>Throws away what was not applied</source>
            <translation>放弃尚未应用的更改</translation>
        </message>
        <message>
            <source>All options of this stage as they come with the program</source>
            <translation>将此步骤的所有参数恢复为程序默认值</translation>
        </message>
        <message>
            <source>%1; default %2</source>
            <translation>%1;默认 %2</translation>
        </message>
        <message>
            <source>This stage has no options.</source>
            <translation>此步骤没有参数。</translation>
        </message>
        <message>
            <source>No option here: see another tier or search.</source>
            <translation>此级别没有参数:请选择其他级别或搜索。</translation>
        </message>
        <message>
            <source>This stage runs when its file is given.</source>
            <translation>指定文件后此步骤才会运行。</translation>
        </message>
        <message>
            <source>Takes the changes into the pipeline</source>
            <translation>将更改写入流程</translation>
        </message>
        <message>
            <source>Nothing to apply: changes are taken at once</source>
            <translation>无需应用:更改会立即生效</translation>
        </message>
        <message>
            <source>Nothing to apply: no option was changed</source>
            <translation>无需应用:没有参数被更改</translation>
        </message>
        <message>
            <source>options of %1</source>
            <translation>%1 的参数</translation>
        </message>
        <message>
            <source>defaults of %1</source>
            <translation>%1 的默认值</translation>
        </message>
        <message>
            <source>Browse…</source>
            <translation>浏览…</translation>
        </message>
        <message>
            <source>Add folder</source>
            <translation>添加文件夹</translation>
        </message>
        <message>
            <source>Open file</source>
            <translation>打开文件</translation>
        </message>
        <message>
            <source> or </source>
            <translation> 或 </translation>
        </message>
        <message>
            <source>Counts only while &apos;%1&apos; is empty.</source>
            <translation>仅当“%1”为空时有效。</translation>
        </message>
        <message>
            <source>Counts only when &apos;%1&apos; is given.</source>
            <translation>仅当给出“%1”时有效。</translation>
        </message>
        <message>
            <source>Counts only when &apos;%1&apos; is %2.</source>
            <translation>仅当“%1”为 %2 时有效。</translation>
        </message>
        <message>
            <source>Counts only when &apos;%1&apos; is not %2.</source>
            <translation>仅当“%1”不为 %2 时有效。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::RowEditor</name>
        <message>
            <source>Rows</source>
            <translation>种植行</translation>
        </message>
        <message>
            <source>Add a row by two clicks</source>
            <translation>点击两次添加种植行</translation>
        </message>
        <message>
            <source>Delete the selected row</source>
            <translation>删除所选种植行</translation>
        </message>
        <message>
            <source>Split the selected row at a click</source>
            <translation>在点击处拆分所选种植行</translation>
        </message>
        <message>
            <source>Merge the selected row with another</source>
            <translation>将所选种植行与另一行合并</translation>
        </message>
        <message>
            <source>Renumber the selected row…</source>
            <translation>重新编号所选种植行…</translation>
        </message>
        <message>
            <source>Renumber</source>
            <translation>重新编号</translation>
        </message>
        <message>
            <source>New id of the row</source>
            <translation>种植行的新编号</translation>
        </message>
        <message>
            <source>Note on the selected row…</source>
            <translation>为所选种植行添加备注…</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>Click where the row begins.</source>
            <translation>请点击种植行起点。</translation>
        </message>
        <message>
            <source>Click where the row is to be split.</source>
            <translation>请点击拆分位置。</translation>
        </message>
        <message>
            <source>Click the other row.</source>
            <translation>请点击另一行。</translation>
        </message>
        <message>
            <source>Click where the row ends.</source>
            <translation>请点击种植行终点。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::SamplePlot</name>
        <message>
            <source>Open sample plot</source>
            <translation>打开示例样地</translation>
        </message>
        <message>
            <source>Making the sample plot: %1</source>
            <translation>正在生成示例样地:%1</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::SliceView</name>
        <message>
            <source>Draw a circle about the points of the new tree. The circle that fits them is taken.</source>
            <translation>在新单木的点周围画一个圆。将采用拟合这些点的圆。</translation>
        </message>
        <message>
            <source>New tree: draw a circle about its points</source>
            <translation>新单木：在其点周围画一个圆</translation>
        </message>
        <message>
            <source>Select a stem first: a new tree is drawn in the slice about it.</source>
            <translation>请先选择一株单木:新树在其横切面中绘制。</translation>
        </message>
        <message>
            <source> m</source>
            <translation> m</translation>
        </message>
        <message>
            <source> m high</source>
            <translation> m 高</translation>
        </message>
        <message>
            <source>Height of the cut above ground</source>
            <translation>横切面离地高度</translation>
        </message>
        <message>
            <source> m thick</source>
            <translation> m 厚</translation>
        </message>
        <message>
            <source>Thickness of the cut</source>
            <translation>横切面厚度</translation>
        </message>
        <message>
            <source>Diameters are those at breast height: set the height of the cut to %1 m to edit one.</source>
            <translation>直径指胸高处的直径:请将横切面高度设为 %1 m 后再编辑。</translation>
        </message>
        <message>
            <source>Select a stem to see its slice.</source>
            <translation>选择一株单木以查看其横切面。</translation>
        </message>
        <message>
            <source>Tree %1   %2</source>
            <translation>单木 %1   %2</translation>
        </message>
        <message>
            <source>DBH %1 cm</source>
            <translation>胸径 %1 cm</translation>
        </message>
        <message>
            <source>95 %: %1 to %2</source>
            <translation>95%：%1 至 %2</translation>
        </message>
        <message>
            <source>arc %1°</source>
            <translation>弧段 %1°</translation>
        </message>
        <message>
            <source>fit %1 cm   spread %2 cm   arc %3°</source>
            <translation>拟合 %1 cm   离散 %2 cm   弧段 %3°</translation>
        </message>
        <message>
            <source>drawn %1 cm, no fit here</source>
            <translation>所画 %1 cm，此处无法拟合</translation>
        </message>
        <message>
            <source>here %1 cm</source>
            <translation>此处 %1 cm</translation>
        </message>
        <message>
            <source>spread here %1 cm</source>
            <translation>此处离散 %1 cm</translation>
        </message>
        <message>
            <source>no circle fits the points here</source>
            <translation>此处的点拟合不出圆</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StemHandles</name>
        <message>
            <source>Handles on the stem in the 3-D view</source>
            <translation>三维视图中的树干控制点</translation>
        </message>
        <message>
            <source>Drag the middle, the rim, the lean or the top. The points correct the circle; with Shift it stays as it was drawn.</source>
            <translation>拖动中心、边缘、倾斜或树顶。点会修正圆;按住 Shift 则保持所画的圆。</translation>
        </message>
        <message>
            <source>Drag the middle, the rim, the lean or the top of the stem.</source>
            <translation>拖动树干的中心、边缘、倾斜或树顶。</translation>
        </message>
        <message>
            <source>drawn %1</source>
            <translation>所画 %1</translation>
        </message>
        <message>
            <source>fit %1</source>
            <translation>拟合 %1</translation>
        </message>
        <message>
            <source>no circle fits the points here</source>
            <translation>此处没有与点拟合的圆</translation>
        </message>
        <message>
            <source>leans %1°</source>
            <translation>倾斜 %1°</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StemReview</name>
        <message>
            <source>Next doubtful stem</source>
            <translation>下一株存疑单木</translation>
        </message>
        <message>
            <source>Previous doubtful stem</source>
            <translation>上一株存疑单木</translation>
        </message>
        <message>
            <source>Zoom to the selected stem</source>
            <translation>缩放至所选单木</translation>
        </message>
        <message>
            <source>Every stem is accepted, rejected or edited.</source>
            <translation>所有单木均已接受、拒绝或编辑。</translation>
        </message>
        <message numerus="yes">
            <source>%n stem(s) not decided yet</source>
            <translation>
                <numerusform>还有 %n 株单木未决定</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::ViewPanel</name>
        <message>
            <source>Not drawn: nothing tells where north is in this cloud. The axes of its file or sensor are not those of a plot or of a coordinate system.</source>
            <translation>不绘制:此点云未说明北在何方。其文件或传感器的坐标轴既不是样地坐标轴,也不是坐标系的坐标轴。</translation>
        </message>
        <message>
            <source>The array of the cloud that gives points their colour</source>
            <translation>决定点颜色的点云属性</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>颜色</translation>
        </message>
        <message>
            <source>Takes the first colour of the map</source>
            <translation>取色带的起始颜色</translation>
        </message>
        <message>
            <source>Takes the last colour of the map</source>
            <translation>取色带的末尾颜色</translation>
        </message>
        <message>
            <source>Auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>The range of the middle 96 % of the values</source>
            <translation>中间 96 % 数值的范围</translation>
        </message>
        <message>
            <source>Range</source>
            <translation>范围</translation>
        </message>
        <message>
            <source>Size of a point on the screen</source>
            <translation>点在屏幕上的大小</translation>
        </message>
        <message>
            <source> px</source>
            <translation> 像素</translation>
        </message>
        <message>
            <source>Point size</source>
            <translation>点大小</translation>
        </message>
        <message>
            <source>Heights above ground that are drawn; drag the middle to move the layer</source>
            <translation>显示的离地高度;拖动中部可移动高度层</translation>
        </message>
        <message>
            <source> m</source>
            <translation> m</translation>
        </message>
        <message>
            <source>All</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>Draws all heights</source>
            <translation>显示全部高度</translation>
        </message>
        <message>
            <source>Heights</source>
            <translation>高度</translation>
        </message>
        <message>
            <source>Clip box</source>
            <translation>裁剪框</translation>
        </message>
        <message>
            <source>Draws only what lies within a box</source>
            <translation>仅显示框内的点</translation>
        </message>
        <message>
            <source>Handles</source>
            <translation>控制柄</translation>
        </message>
        <message>
            <source>Drag the faces of the box in the view</source>
            <translation>在视图中拖动框的各面</translation>
        </message>
        <message>
            <source>Reset</source>
            <translation>还原</translation>
        </message>
        <message>
            <source>The box around the whole cloud</source>
            <translation>包围整个点云的框</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>z</source>
            <translation>z</translation>
        </message>
        <message>
            <source>Eye-dome shading</source>
            <translation>眼穹光照(EDL)</translation>
        </message>
        <message>
            <source>Darkens hollows when the view rests: shapes stand out</source>
            <translation>视图静止时加深凹处,使形状更清晰</translation>
        </message>
        <message>
            <source>Grid</source>
            <translation>格网</translation>
        </message>
        <message>
            <source>A grid in metres at the foot of the cloud</source>
            <translation>点云底部的米制格网</translation>
        </message>
        <message>
            <source>Legend</source>
            <translation>图例</translation>
        </message>
        <message>
            <source>What the colours mean</source>
            <translation>颜色的含义</translation>
        </message>
        <message>
            <source>Scale bar</source>
            <translation>比例尺</translation>
        </message>
        <message>
            <source>In metres; holds everywhere in parallel projection</source>
            <translation>以米为单位;平行投影时处处有效</translation>
        </message>
        <message>
            <source>North arrow</source>
            <translation>指北针</translation>
        </message>
        <message>
            <source>Where the axes of the plot are known</source>
            <translation>样地坐标轴已知时显示</translation>
        </message>
        <message>
            <source>Minimum height above ground that is drawn</source>
            <translation>显示的最小离地高度</translation>
        </message>
        <message>
            <source>Maximum height above ground that is drawn</source>
            <translation>显示的最大离地高度</translation>
        </message>
        <message>
            <source>Minimum x</source>
            <translation>最小 x</translation>
        </message>
        <message>
            <source>Maximum x</source>
            <translation>最大 x</translation>
        </message>
        <message>
            <source>Minimum y</source>
            <translation>最小 y</translation>
        </message>
        <message>
            <source>Maximum y</source>
            <translation>最大 y</translation>
        </message>
        <message>
            <source>Minimum z</source>
            <translation>最小 z</translation>
        </message>
        <message>
            <source>Maximum z</source>
            <translation>最大 z</translation>
        </message>
        <message>
            <source>Tree numbers</source>
            <translation>树号</translation>
        </message>
        <message>
            <source>With symbols for the quality of the diameter and what was decided</source>
            <translation>用符号表示胸径质量和审核结果</translation>
        </message>
        <message>
            <source>The colours of numbers; the legend shows them</source>
            <translation>数值的颜色;图例显示其含义</translation>
        </message>
        <message>
            <source>Usual</source>
            <translation>默认</translation>
        </message>
        <message>
            <source>Green to yellow (viridis)</source>
            <translation>绿至黄 (viridis)</translation>
        </message>
        <message>
            <source>Blue to yellow (cividis)</source>
            <translation>蓝至黄 (cividis)</translation>
        </message>
        <message>
            <source>Rainbow (turbo)</source>
            <translation>彩虹 (turbo)</translation>
        </message>
        <message>
            <source>Grey</source>
            <translation>灰度</translation>
        </message>
        <message>
            <source>Blue to red (diverging)</source>
            <translation>蓝至红 (发散)</translation>
        </message>
        <message>
            <source>Colour map</source>
            <translation>色带</translation>
        </message>
        <message>
            <source>Terrain with contour lines</source>
            <translation>地形与等高线</translation>
        </message>
        <message>
            <source>The terrain model as a surface, with the tints of the report; holes stay open. Over a map that follows the terrain, the contour lines alone</source>
            <translation>以曲面显示地形模型,配色与报告一致;空缺处不填补。底图贴合地形时只显示等高线</translation>
        </message>
        <message>
            <source>Map behind</source>
            <translation>底图</translation>
        </message>
        <message>
            <source>Opacity of the map; less lets the background through</source>
            <translation>底图的不透明度;数值越小,背景越明显</translation>
        </message>
        <message>
            <source>Map on the terrain</source>
            <translation>底图贴合地形</translation>
        </message>
        <message>
            <source>The map follows hills and hollows. Otherwise it is flat, at the foot of the cloud</source>
            <translation>底图随地形起伏;否则平放在点云底部</translation>
        </message>
        <message>
            <source>The survey has no terrain model yet.</source>
            <translation>该调查数据还没有地形模型。</translation>
        </message>
        <message>
            <source> %</source>
            <translation> %</translation>
        </message>
        <message>
            <source>The picture of the place below the survey</source>
            <translation>调查数据下方的当地图像</translation>
        </message>
        <message>
            <source>Open a map first: File &gt; Map behind the survey.</source>
            <translation>请先打开底图:文件 &gt; 调查数据下方的底图。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::WalkPanel</name>
        <message>
            <source>frame %1 of %2</source>
            <translation>第 %1 帧,共 %2 帧</translation>
        </message>
        <message>
            <source>   %1 frames/s   %2 left</source>
            <translation>   %1 帧/秒   剩余 %2</translation>
        </message>
        <message numerus="yes">
            <source>%n loop(s), %1 refused</source>
            <translation>
                <numerusform>%n 个回环,拒绝 %1 个</numerusform>
            </translation>
        </message>
        <message>
            <source>   not placed</source>
            <translation>   未定位</translation>
        </message>
        <message>
            <source>frame %1 of %2   %3 s   %4 points</source>
            <translation>第 %1 帧,共 %2 帧   %3 秒   %4 个点</translation>
        </message>
        <message>
            <source>   at %1, %2, %3 m</source>
            <translation>   位于 %1, %2, %3 m</translation>
        </message>
        <message>
            <source>   not on the path</source>
            <translation>   不在路径上</translation>
        </message>
        <message>
            <source>   sensor axes</source>
            <translation>   传感器坐标系</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Workbench</name>
        <message>
            <source>Pipeline graph</source>
            <translation>流程图</translation>
        </message>
        <message>
            <source>Pipeline as a graph</source>
            <translation>以流程图显示处理流程</translation>
        </message>
        <message>
            <source>Whole graph</source>
            <translation>显示整个流程图</translation>
        </message>
        <message>
            <source>Save the graph</source>
            <translation>保存流程图</translation>
        </message>
        <message>
            <source>Save the graph as a picture…</source>
            <translation>将流程图存为图片…</translation>
        </message>
        <message>
            <source>Pictures (*.svg *.png)</source>
            <translation>图片 (*.svg *.png)</translation>
        </message>
        <message>
            <source>Decision</source>
            <translation>决定</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>By</source>
            <translation>由</translation>
        </message>
        <message>
            <source>At</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Reason</source>
            <translation>原因</translation>
        </message>
        <message>
            <source>Decisions</source>
            <translation>决定列表</translation>
        </message>
        <message>
            <source>Outcome</source>
            <translation>处理结果</translation>
        </message>
        <message>
            <source>not run yet</source>
            <translation>尚未运行</translation>
        </message>
        <message>
            <source>applied</source>
            <translation>已应用</translation>
        </message>
        <message>
            <source>does not fit</source>
            <translation>不再适用</translation>
        </message>
        <message>
            <source>Choose decisions in the list.</source>
            <translation>请先在列表中选择决定。</translation>
        </message>
        <message>
            <source>Take back the chosen decisions</source>
            <translation>撤回所选决定</translation>
        </message>
        <message>
            <source>Go to its place</source>
            <translation>转到其位置</translation>
        </message>
        <message>
            <source>This decision has no place.</source>
            <translation>此决定没有位置。</translation>
        </message>
        <message>
            <source>No stem stands there any more.</source>
            <translation>那里已没有树干。</translation>
        </message>
        <message>
            <source>While a field is trained its curve is shown here.</source>
            <translation>训练辐射场时，此处显示其曲线。</translation>
        </message>
        <message>
            <source>Training</source>
            <translation>训练</translation>
        </message>
        <message>
            <source>Wrote %1</source>
            <translation>已写入 %1</translation>
        </message>
        <message>
            <source>Export a figure…</source>
            <translation>导出图件…</translation>
        </message>
        <message>
            <source>History</source>
            <translation>历史记录</translation>
        </message>
        <message>
            <source>The result of the run could not be fetched again: %1</source>
            <translation>无法重新取得该次运行的结果:%1</translation>
        </message>
        <message>
            <source>Run</source>
            <translation>运行</translation>
        </message>
        <message>
            <source>Run without writing files</source>
            <translation>仅计算,不写文件</translation>
        </message>
        <message>
            <source>Keep result</source>
            <translation>保留当前结果</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Jobs</source>
            <translation>任务</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>胸径</translation>
        </message>
        <message>
            <source>Diameter at breast height in cm</source>
            <translation>胸径(cm)</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>树高</translation>
        </message>
        <message>
            <source>Height of the tree in m</source>
            <translation>树高(m)</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>Set diameter…</source>
            <translation>设定胸径…</translation>
        </message>
        <message>
            <source>Set height…</source>
            <translation>设定树高…</translation>
        </message>
        <message>
            <source>Set species…</source>
            <translation>设定树种…</translation>
        </message>
        <message>
            <source>Species</source>
            <translation>树种</translation>
        </message>
        <message>
            <source>Species of the tree</source>
            <translation>该树的树种</translation>
        </message>
        <message>
            <source>Accept</source>
            <translation>接受</translation>
        </message>
        <message>
            <source>Reject</source>
            <translation>拒绝</translation>
        </message>
        <message>
            <source>Note…</source>
            <translation>备注…</translation>
        </message>
        <message>
            <source>Delete</source>
            <translation>删除</translation>
        </message>
        <message>
            <source>Add a tree by a circle</source>
            <translation>画圆添加单木</translation>
        </message>
        <message>
            <source>Colour points by</source>
            <translation>点云着色依据</translation>
        </message>
        <message>
            <source>Whole survey</source>
            <translation>全景</translation>
        </message>
        <message>
            <source>From above</source>
            <translation>俯视</translation>
        </message>
        <message>
            <source>From the south</source>
            <translation>自南向北</translation>
        </message>
        <message>
            <source>From the west</source>
            <translation>自西向东</translation>
        </message>
        <message>
            <source>From the east</source>
            <translation>自东向西</translation>
        </message>
        <message>
            <source>Parallel projection</source>
            <translation>平行投影</translation>
        </message>
        <message>
            <source>Eye-dome shading</source>
            <translation>眼穹光照(EDL)</translation>
        </message>
        <message>
            <source>Grid in metres</source>
            <translation>米制格网</translation>
        </message>
        <message>
            <source>Clip box</source>
            <translation>裁剪框</translation>
        </message>
        <message>
            <source>Clip box around everything</source>
            <translation>裁剪框包含全部点</translation>
        </message>
        <message>
            <source>All heights</source>
            <translation>全部高度</translation>
        </message>
        <message>
            <source>Larger points</source>
            <translation>放大点</translation>
        </message>
        <message>
            <source>Smaller points</source>
            <translation>缩小点</translation>
        </message>
        <message>
            <source>Look of the view…</source>
            <translation>视图外观…</translation>
        </message>
        <message>
            <source>View</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>Survey</source>
            <translation>调查</translation>
        </message>
        <message>
            <source>Walk</source>
            <translation>行走路径</translation>
        </message>
        <message>
            <source>Next frame</source>
            <translation>下一帧</translation>
        </message>
        <message>
            <source>Previous frame</source>
            <translation>上一帧</translation>
        </message>
        <message>
            <source>Next keyframe</source>
            <translation>下一关键帧</translation>
        </message>
        <message>
            <source>Previous keyframe</source>
            <translation>上一关键帧</translation>
        </message>
        <message>
            <source>Whole walk</source>
            <translation>整条路径</translation>
        </message>
        <message>
            <source>Changes are not kept until they are saved: %1</source>
            <translation>更改在保存之前不受保护:%1</translation>
        </message>
        <message>
            <source>Run the pipeline first.</source>
            <translation>请先运行流程。</translation>
        </message>
        <message>
            <source>Select a stem first.</source>
            <translation>请先选择一株单木。</translation>
        </message>
        <message>
            <source>Select a row first.</source>
            <translation>请先选择一行。</translation>
        </message>
        <message>
            <source>No run is under way.</source>
            <translation>当前没有运行。</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>Open a scan, a point cloud, views or a pipeline first.</source>
            <translation>请先打开扫描、点云、视图或处理流程。</translation>
        </message>
        <message>
            <source>Copy rows for a spreadsheet</source>
            <translation>复制行到电子表格</translation>
        </message>
        <message>
            <source>Worst first</source>
            <translation>最差的在前</translation>
        </message>
        <message>
            <source>Sorts the table by how little the diameters can be trusted</source>
            <translation>按胸径的不可信程度排序</translation>
        </message>
        <message>
            <source>Columns</source>
            <translation>列</translation>
        </message>
        <message>
            <source>From the north</source>
            <translation>从北面</translation>
        </message>
        <message>
            <source>Save as picture</source>
            <translation>存为图像</translation>
        </message>
        <message>
            <source>Pictures (*.png *.jpg *.tif)</source>
            <translation>图像 (*.png *.jpg *.tif)</translation>
        </message>
        <message>
            <source> px</source>
            <translation> px</translation>
        </message>
        <message>
            <source>Transparent background</source>
            <translation>透明背景</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>宽度</translation>
        </message>
        <message>
            <source>Save as picture…</source>
            <translation>存为图像…</translation>
        </message>
        <message>
            <source>Open a scan or a point cloud first.</source>
            <translation>请先打开扫描或点云。</translation>
        </message>
        <message>
            <source>Terrain with contour lines</source>
            <translation>地形与等高线</translation>
        </message>
        <message>
            <source>The survey has no terrain model yet.</source>
            <translation>该调查数据还没有地形模型。</translation>
        </message>
        <message>
            <source>Tree numbers</source>
            <translation>树号</translation>
        </message>
        <message>
            <source>Cancelled. What is shown stays as it was.</source>
            <translation>已取消。显示内容保持不变。</translation>
        </message>
        <message>
            <source>Lessons</source>
            <translation>课程</translation>
        </message>
        <message>
            <source>Show the panel of lessons</source>
            <translation>显示课程面板</translation>
        </message>
        <message>
            <source>Open a lesson first.</source>
            <translation>请先打开一个课程。</translation>
        </message>
        <message>
            <source>Next step</source>
            <translation>下一步</translation>
        </message>
        <message>
            <source>First do what this step of the lesson needs; the last step has no next one.</source>
            <translation>请先完成课程本步的要求;最后一步之后没有下一步。</translation>
        </message>
        <message>
            <source>Step back</source>
            <translation>上一步</translation>
        </message>
        <message>
            <source>Show me</source>
            <translation>演示</translation>
        </message>
        <message>
            <source>Does for you what the step needs</source>
            <translation>替您完成本步的要求</translation>
        </message>
        <message>
            <source>Begin again</source>
            <translation>重新开始</translation>
        </message>
        <message>
            <source>From the first step; your answers are forgotten</source>
            <translation>从第一步开始;答案将被清除</translation>
        </message>
        <message>
            <source>All lessons</source>
            <translation>全部课程</translation>
        </message>
        <message>
            <source>Leaves this lesson; it goes on here later</source>
            <translation>离开本课程;以后从这里继续</translation>
        </message>
        <message>
            <source>Lesson</source>
            <translation>课程</translation>
        </message>
        <message>
            <source>%1: set '%2' to %3</source>
            <translation>%1:将“%2”设为 %3</translation>
        </message>
        <message>
            <source>Open the data of this step (Show me)</source>
            <translation>打开本步的数据(演示)</translation>
        </message>
        <message>
            <source>Run (Shift+F5), and wait until the run has ended</source>
            <translation>运行 (Shift+F5),等待运行结束</translation>
        </message>
        <message>
            <source>Select a tree in the table</source>
            <translation>在表中选择一棵树</translation>
        </message>
        <message>
            <source>Correct a result by hand</source>
            <translation>手工修正一个结果</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PicturePanel</name>
        <message>
            <source>Points</source>
            <translation>点</translation>
        </message>
        <message>
            <source>Stem edges</source>
            <translation>茎缘</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>彩色</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>深度</translation>
        </message>
        <message>
            <source>Depth − cloud</source>
            <translation>深度 − 点云</translation>
        </message>
        <message>
            <source>Depth − cloud: measured depth minus the depth of the cloud as this view sees it</source>
            <translation>深度 − 点云:实测深度减去此视图所见点云的深度</translation>
        </message>
        <message>
            <source>Points of the cloud that this view sees, at the pixels where they should be</source>
            <translation>此视图可见的点云点,绘于其应在的像素处</translation>
        </message>
        <message>
            <source>Edges of the stem as they were measured in this picture</source>
            <translation>在此图像中测得的茎的边缘</translation>
        </message>
        <message>
            <source>Matches with another view: green were kept, red were refused</source>
            <translation>与另一视图的匹配:绿色为保留,红色为剔除</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>适应窗口</translation>
        </message>
        <message>
            <source>Show the whole picture (double click)</source>
            <translation>显示整幅图像(双击)</translation>
        </message>
        <message>
            <source>There are no views in this pipeline.</source>
            <translation>此处理流程中没有视图。</translation>
        </message>
        <message>
            <source>No matches</source>
            <translation>不显示匹配</translation>
        </message>
        <message>
            <source>This view has no depth image.</source>
            <translation>此视图没有深度图像。</translation>
        </message>
        <message>
            <source>There is no cloud yet, or this view has no pose: run the pipeline.</source>
            <translation>尚无点云,或此视图没有位姿:请运行处理流程。</translation>
        </message>
        <message>
            <source>depth (m)</source>
            <translation>深度 (m)</translation>
        </message>
        <message>
            <source>measured − cloud (mm)</source>
            <translation>实测 − 点云 (mm)</translation>
        </message>
        <message>
            <source>view %1 of %2</source>
            <translation>视图 %1 / %2</translation>
        </message>
        <message>
            <source>%1 points of the cloud seen</source>
            <translation>可见点云点 %1 个</translation>
        </message>
        <message>
            <source>pixel %1, %2</source>
            <translation>像素 %1, %2</translation>
        </message>
        <message>
            <source>colour %1, %2, %3</source>
            <translation>颜色 %1, %2, %3</translation>
        </message>
        <message>
            <source>depth %1 m</source>
            <translation>深度 %1 m</translation>
        </message>
        <message>
            <source>no depth</source>
            <translation>无深度</translation>
        </message>
        <message>
            <source>%1 mm from the cloud</source>
            <translation>与点云相差 %1 mm</translation>
        </message>
        <message>
            <source>%1 and %2: %3 kept, %4 refused</source>
            <translation>%1 与 %2:保留 %3,剔除 %4</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Pictures</name>
        <message>
            <source>Views</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>Picture</source>
            <translation>图像</translation>
        </message>
        <message>
            <source>Open a folder of views first.</source>
            <translation>请先打开视图文件夹。</translation>
        </message>
        <message>
            <source>Next view</source>
            <translation>下一视图</translation>
        </message>
        <message>
            <source>Previous view</source>
            <translation>上一视图</translation>
        </message>
        <message>
            <source>Whole picture</source>
            <translation>整幅图像</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StageStates</name>
        <message>
            <source>running</source>
            <translation>运行中</translation>
        </message>
        <message>
            <source>done</source>
            <translation>完成</translation>
        </message>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n 条警告</numerusform>
            </translation>
        </message>
        <message>
            <source>failed</source>
            <translation>失败</translation>
        </message>
        <message>
            <source>out of date</source>
            <translation>已过期</translation>
        </message>
        <message>
            <source>cannot run</source>
            <translation>无法运行</translation>
        </message>
        <message>
            <source>skipped</source>
            <translation>已跳过</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 秒</translation>
        </message>
        <message>
            <source>Took %1.</source>
            <translation>用时 %1。</translation>
        </message>
        <message>
            <source>This stage runs when its file is given.</source>
            <translation>指定文件后此步骤才会运行。</translation>
        </message>
        <message>
            <source>Something that this stage depends on was changed since it ran. Run the pipeline.</source>
            <translation>此步骤运行之后,它所依赖的内容已更改。请重新运行处理流程。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StageGraph</name>
        <message>
            <source>point cloud</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>table</source>
            <translation>表格</translation>
        </message>
        <message>
            <source>raster</source>
            <translation>栅格</translation>
        </message>
        <message>
            <source>trajectory</source>
            <translation>轨迹</translation>
        </message>
        <message>
            <source>frames</source>
            <translation>帧</translation>
        </message>
        <message>
            <source>views</source>
            <translation>视图</translation>
        </message>
        <message numerus="yes">
            <source>%n array(s)</source>
            <translation>
                <numerusform>%n 个数组</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>adds %n array(s)</source>
            <translation>
                <numerusform>新增 %n 个数组</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::GraphView</name>
        <message>
            <source>Pipeline graph</source>
            <translation>流程图</translation>
        </message>
        <message>
            <source>needs %1</source>
            <translation>缺少 %1</translation>
        </message>
        <message>
            <source>not run</source>
            <translation>未运行</translation>
        </message>
        <message>
            <source>The required input %1 is not connected.</source>
            <translation>必需的输入 %1 未连接。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Traits</name>
        <message>
            <source>Edits</source>
            <translation>编辑</translation>
        </message>
        <message>
            <source>Draw traits on the plant</source>
            <translation>在植株上绘出性状</translation>
        </message>
        <message>
            <source>Traits</source>
            <translation>性状</translation>
        </message>
        <message>
            <source>Leaves</source>
            <translation>叶片</translation>
        </message>
        <message>
            <source>Internodes</source>
            <translation>节间</translation>
        </message>
        <message>
            <source>Sections of the stem</source>
            <translation>茎的截面</translation>
        </message>
        <message>
            <source>Stem measured by: %1</source>
            <translation>茎的测量方法:%1</translation>
        </message>
        <message>
            <source>The scale is not known: sizes are relative.</source>
            <translation>尺度未知:大小为相对值。</translation>
        </message>
    </context>
<context>
        <name>bole::desktop::LoopEditor</name>
        <message>
            <source>Loop closures</source>
            <translation>回环</translation>
        </message>
        <message>
            <source>Show the loop closures</source>
            <translation>显示回环</translation>
        </message>
        <message>
            <source>Accept the selected loop closure</source>
            <translation>接受所选回环</translation>
        </message>
        <message>
            <source>Strike the selected loop closure out</source>
            <translation>剔除所选回环</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FlythroughDialog</name>
        <message>
            <source>Flythrough</source>
            <translation>漫游影片</translation>
        </message>
        <message>
            <source>Along the walk</source>
            <translation>沿行走路径</translation>
        </message>
        <message>
            <source>Through the %1 bookmarked views</source>
            <translation>经过 %1 个书签视图</translation>
        </message>
        <message>
            <source> s</source>
            <translation> 秒</translation>
        </message>
        <message>
            <source> frames per second</source>
            <translation> 帧/秒</translation>
        </message>
        <message>
            <source>Fitted stems</source>
            <translation>拟合的树干</translation>
        </message>
        <message>
            <source>Video (MP4)</source>
            <translation>视频 (MP4)</translation>
        </message>
        <message>
            <source>The program ffmpeg is not installed: frames are written as PNG files.</source>
            <translation>未安装 ffmpeg 程序:各帧写为 PNG 文件。</translation>
        </message>
        <message>
            <source>Course</source>
            <translation>路线</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>时长</translation>
        </message>
        <message>
            <source>Rate</source>
            <translation>帧率</translation>
        </message>
        <message>
            <source>Size of a frame</source>
            <translation>画面尺寸</translation>
        </message>
        <message>
            <source>Make the film…</source>
            <translation>制作影片…</translation>
        </message>
        <message>
            <source>Folder of the film</source>
            <translation>影片文件夹</translation>
        </message>
        <message>
            <source>The survey has no walk.</source>
            <translation>该调查没有行走路径。</translation>
        </message>
        <message>
            <source>Bookmark two views or more (Ctrl+B).</source>
            <translation>请至少收藏两个视图 (Ctrl+B)。</translation>
        </message>
        <message numerus="yes">
            <source>%n frame(s) as PNG files</source>
            <translation>
                <numerusform>%n 帧 PNG 图像</numerusform>
            </translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Flythrough…</source>
            <translation>漫游影片…</translation>
        </message>
        <message>
            <source>Open a scan or a point cloud first.</source>
            <translation>请先打开扫描数据或点云。</translation>
        </message>
        <message>
            <source>Clouds beside the survey</source>
            <translation>调查数据旁的点云</translation>
        </message>
        <message>
            <source>As the 3-D view shows them: place, colours, opacity, size of points</source>
            <translation>与三维视图所示相同:位置、颜色、不透明度、点的大小</translation>
        </message>
        <message>
            <source>The 3-D view shows no cloud beside the survey.</source>
            <translation>三维视图中没有显示调查数据旁的点云。</translation>
        </message>
        <message>
            <source>Map behind the survey</source>
            <translation>调查数据下方的底图</translation>
        </message>
        <message>
            <source>As the 3-D view shows it: flat or on the terrain, and its opacity</source>
            <translation>与三维视图所示相同:平放或贴合地形,以及不透明度</translation>
        </message>
        <message>
            <source>The 3-D view shows no map behind the survey.</source>
            <translation>三维视图中没有显示底图。</translation>
        </message>
        <message>
            <source>Terrain with contour lines</source>
            <translation>地形与等高线</translation>
        </message>
        <message>
            <source>As the 3-D view shows it: over a map that follows it the contour lines alone</source>
            <translation>与三维视图所示相同:在贴合地形的底图上只画等高线</translation>
        </message>
        <message>
            <source>The 3-D view shows no terrain.</source>
            <translation>三维视图中没有显示地形。</translation>
        </message>
        <message>
            <source>With %1</source>
            <translation>包含 %1</translation>
        </message>
        <message>
            <source>Of clouds that are shown from the disk the film has the coarse points.</source>
            <translation>从磁盘显示的点云在影片中只有粗略的点。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::SectionTool</name>
        <message>
            <source>There is no point here. Click one that is drawn.</source>
            <translation>这里没有点。请点击已绘制的点。</translation>
        </message>
        <message>
            <source>Click where the section begins, on the left.</source>
            <translation>点击剖面的起点(左侧)。</translation>
        </message>
        <message>
            <source>Click where the section ends.</source>
            <translation>点击剖面的终点。</translation>
        </message>
        <message>
            <source>The line is too short. Click its end again.</source>
            <translation>剖面线太短。请重新点击终点。</translation>
        </message>
        <message>
            <source>The path ends here.</source>
            <translation>路径到此结束。</translation>
        </message>
        <message>
            <source> m wide</source>
            <translation> m 宽</translation>
        </message>
        <message>
            <source>Width of the section: points up to half of it before and behind the line</source>
            <translation>剖面宽度:剖面线前后各取其一半的点</translation>
        </message>
        <message>
            <source> m long</source>
            <translation> m 长</translation>
        </message>
        <message>
            <source>Length of the line</source>
            <translation>剖面线长度</translation>
        </message>
        <message>
            <source>Cross-section</source>
            <translation>剖面</translation>
        </message>
        <message>
            <source>Draw a cross-section first.</source>
            <translation>请先绘制剖面。</translation>
        </message>
        <message>
            <source>The survey has no walk.</source>
            <translation>该调查没有行走路径。</translation>
        </message>
        <message>
            <source>Open a scan or a point cloud first.</source>
            <translation>请先打开扫描数据或点云。</translation>
        </message>
        <message>
            <source>Draw a cross-section</source>
            <translation>绘制剖面</translation>
        </message>
        <message>
            <source>Next section</source>
            <translation>下一个剖面</translation>
        </message>
        <message>
            <source>Previous section</source>
            <translation>上一个剖面</translation>
        </message>
        <message>
            <source>Sections across the walk</source>
            <translation>横穿行走路径的剖面</translation>
        </message>
        <message>
            <source>Sections across the selected row</source>
            <translation>横穿所选种植行的剖面</translation>
        </message>
        <message>
            <source>Section along the selected row</source>
            <translation>沿所选种植行的剖面</translation>
        </message>
        <message>
            <source>Whole section</source>
            <translation>显示整个剖面</translation>
        </message>
        <message>
            <source>Save the section…</source>
            <translation>保存剖面…</translation>
        </message>
        <message>
            <source>Save the section</source>
            <translation>保存剖面</translation>
        </message>
        <message>
            <source>Figures (*.png *.svg *.pdf)</source>
            <translation>图形 (*.png *.svg *.pdf)</translation>
        </message>
        <message>
            <source>Wrote %1</source>
            <translation>已写入 %1</translation>
        </message>
        <message>
            <source>Remove the section</source>
            <translation>移除剖面</translation>
        </message>
        <message>
            <source>%1 m of %2 m</source>
            <translation>%1 m,共 %2 m</translation>
        </message>
        <message>
            <source>(%1, %2) to (%3, %4)</source>
            <translation>(%1, %2) 至 (%3, %4)</translation>
        </message>
        <message>
            <source>%1 of %2 points</source>
            <translation>%1 / %2 个点</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::SectionView</name>
        <message>
            <source>Draw a line in the 3-D view (key X): the points along it are shown here from the side.</source>
            <translation>在三维视图中画一条线(X 键):线两侧的点在此从侧面显示。</translation>
        </message>
    </context>
    <context>
        <name>Arrays</name>
        <message>
            <source>height above ground</source>
            <translation>离地高度</translation>
        </message>
        <message>
            <source>tree id</source>
            <translation>树号</translation>
        </message>
        <message>
            <source>z</source>
            <translation>z</translation>
        </message>
        <message>
            <source>photo</source>
            <translation>照片颜色</translation>
        </message>
        <message>
            <source>intensity</source>
            <translation>强度</translation>
        </message>
        <message>
            <source>time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>range</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>ring</source>
            <translation>激光通道</translation>
        </message>
        <message>
            <source>pass</source>
            <translation>行走遍次</translation>
        </message>
        <message>
            <source>keyframe</source>
            <translation>关键帧</translation>
        </message>
        <message>
            <source>sensor x</source>
            <translation>传感器 x</translation>
        </message>
        <message>
            <source>sensor y</source>
            <translation>传感器 y</translation>
        </message>
        <message>
            <source>sensor z</source>
            <translation>传感器 z</translation>
        </message>
        <message>
            <source>stem</source>
            <translation>树干</translation>
        </message>
        <message>
            <source>plant</source>
            <translation>植株</translation>
        </message>
        <message>
            <source>part</source>
            <translation>部位</translation>
        </message>
        <message>
            <source>classification</source>
            <translation>分类</translation>
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
            <source>scan angle</source>
            <translation>扫描角</translation>
        </message>
        <message>
            <source>user data</source>
            <translation>用户数据</translation>
        </message>
        <message>
            <source>point source id</source>
            <translation>点源编号</translation>
        </message>
        <message>
            <source>red</source>
            <translation>红</translation>
        </message>
        <message>
            <source>green</source>
            <translation>绿</translation>
        </message>
        <message>
            <source>blue</source>
            <translation>蓝</translation>
        </message>
        <message>
            <source>near infrared</source>
            <translation>近红外</translation>
        </message>
    </context>
    <context>
        <name>Columns</name>
        <message>
            <source>Tree</source>
            <translation>树号</translation>
        </message>
        <message>
            <source>Number of the tree; the same in every file</source>
            <translation>树的编号,在所有文件中相同</translation>
        </message>
        <message>
            <source>x</source>
            <translation>x</translation>
        </message>
        <message>
            <source>Position at breast height</source>
            <translation>胸高处的位置</translation>
        </message>
        <message>
            <source>y</source>
            <translation>y</translation>
        </message>
        <message>
            <source>Ground z</source>
            <translation>地面高程</translation>
        </message>
        <message>
            <source>Height of the ground at the stem</source>
            <translation>树干处的地面高程</translation>
        </message>
        <message>
            <source>DBH</source>
            <translation>胸径</translation>
        </message>
        <message>
            <source>Diameter at breast height</source>
            <translation>胸高处的直径</translation>
        </message>
        <message>
            <source>DBH from</source>
            <translation>胸径下限</translation>
        </message>
        <message>
            <source>Lower end of the 95 % interval of the diameter</source>
            <translation>胸径 95 % 置信区间的下限</translation>
        </message>
        <message>
            <source>DBH to</source>
            <translation>胸径上限</translation>
        </message>
        <message>
            <source>Upper end of the 95 % interval of the diameter</source>
            <translation>胸径 95 % 置信区间的上限</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>树高</translation>
        </message>
        <message>
            <source>Height of the tree; empty where the top was not seen</source>
            <translation>树高;未观测到树顶时为空</translation>
        </message>
        <message>
            <source>Height at least</source>
            <translation>树高至少</translation>
        </message>
        <message>
            <source>Highest point of the tree that was seen</source>
            <translation>观测到的最高点</translation>
        </message>
        <message>
            <source>Top seen</source>
            <translation>见到树顶</translation>
        </message>
        <message>
            <source>1 where the top of the tree was seen</source>
            <translation>观测到树顶时为 1</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>树顶</translation>
        </message>
        <message>
            <source>Whether the top that was found is trusted</source>
            <translation>找到的树顶是否可信</translation>
        </message>
        <message>
            <source>Lean</source>
            <translation>倾斜</translation>
        </message>
        <message>
            <source>Angle between the stem and the vertical</source>
            <translation>树干与铅垂线的夹角</translation>
        </message>
        <message>
            <source>Lean towards</source>
            <translation>倾斜方向</translation>
        </message>
        <message>
            <source>Direction of the lean, clockwise from north</source>
            <translation>倾斜的方向,自北顺时针</translation>
        </message>
        <message>
            <source>Taper</source>
            <translation>尖削度</translation>
        </message>
        <message>
            <source>Decrease of the diameter per metre of height</source>
            <translation>每升高一米直径的减小量</translation>
        </message>
        <message>
            <source>Arc seen</source>
            <translation>可见弧</translation>
        </message>
        <message>
            <source>How much of the circumference was seen</source>
            <translation>观测到的圆周角度</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>经过次数</translation>
        </message>
        <message>
            <source>Stretches of the walk that saw the stem</source>
            <translation>观测到该树干的路段数</translation>
        </message>
        <message>
            <source>Pass spread</source>
            <translation>各次偏差</translation>
        </message>
        <message>
            <source>Distance between the positions from different passes</source>
            <translation>各次经过所得位置之间的距离</translation>
        </message>
        <message>
            <source>Residual</source>
            <translation>残差</translation>
        </message>
        <message>
            <source>Standard deviation of the points from the fitted stem</source>
            <translation>点到拟合树干的标准差</translation>
        </message>
        <message>
            <source>Wall</source>
            <translation>点层厚度</translation>
        </message>
        <message>
            <source>Thickness of the layer of points on the bark</source>
            <translation>树皮上点层的厚度</translation>
        </message>
        <message>
            <source>DBH by girth</source>
            <translation>围径</translation>
        </message>
        <message>
            <source>Diameter of a circle with the girth of the section</source>
            <translation>与断面周长相同的圆的直径</translation>
        </message>
        <message>
            <source>Ovality</source>
            <translation>椭圆度</translation>
        </message>
        <message>
            <source>Difference of the axes of the section, of their mean</source>
            <translation>断面两轴之差与其均值之比</translation>
        </message>
        <message>
            <source>Base x</source>
            <translation>基部 x</translation>
        </message>
        <message>
            <source>Position of the stem at the ground</source>
            <translation>树干在地面处的位置</translation>
        </message>
        <message>
            <source>Base y</source>
            <translation>基部 y</translation>
        </message>
        <message>
            <source>Crown base</source>
            <translation>枝下高</translation>
        </message>
        <message>
            <source>Height of the lowest branches</source>
            <translation>最低枝条的高度</translation>
        </message>
        <message>
            <source>Crown area</source>
            <translation>冠幅面积</translation>
        </message>
        <message>
            <source>Area of the crown seen from above</source>
            <translation>树冠的俯视面积</translation>
        </message>
        <message>
            <source>Volume</source>
            <translation>材积</translation>
        </message>
        <message>
            <source>Volume of the stem</source>
            <translation>树干的材积</translation>
        </message>
        <message>
            <source>Volume by</source>
            <translation>材积方法</translation>
        </message>
        <message>
            <source>How the volume was computed</source>
            <translation>材积的计算方法</translation>
        </message>
        <message>
            <source>Fork</source>
            <translation>分叉高</translation>
        </message>
        <message>
            <source>Height at which the stem forks</source>
            <translation>树干分叉处的高度</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>点数</translation>
        </message>
        <message>
            <source>Points that the fit uses</source>
            <translation>拟合所用的点数</translation>
        </message>
        <message>
            <source>Sections</source>
            <translation>断面数</translation>
        </message>
        <message>
            <source>Sections that the fit uses</source>
            <translation>拟合所用的断面数</translation>
        </message>
        <message>
            <source>Quality</source>
            <translation>质量</translation>
        </message>
        <message>
            <source>good, fair or poor: how far the diameter can be trusted</source>
            <translation>good(良)、fair(中)或 poor(差):胸径的可信程度</translation>
        </message>
        <message>
            <source>Reasons</source>
            <translation>原因</translation>
        </message>
        <message>
            <source>What lowers the quality</source>
            <translation>降低质量的原因</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>auto, check, accepted, rejected or edited</source>
            <translation>auto(自动)、check(待查)、accepted(已接受)、rejected(已拒绝)或 edited(已编辑)</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>What a person wrote</source>
            <translation>人工填写的备注</translation>
        </message>
        <message>
            <source>Counted</source>
            <translation>计入样地</translation>
        </message>
        <message>
            <source>1: the values of the plot rest on this tree</source>
            <translation>1：样地统计值以这棵树为依据</translation>
        </message>
        <message>
            <source>Species</source>
            <translation>树种</translation>
        </message>
        <message>
            <source>Species of the tree</source>
            <translation>树木的树种</translation>
        </message>
        <message>
            <source>Easting</source>
            <translation>东坐标</translation>
        </message>
        <message>
            <source>In the coordinate system of the plot</source>
            <translation>样地坐标系中的坐标</translation>
        </message>
        <message>
            <source>Northing</source>
            <translation>北坐标</translation>
        </message>
        <message>
            <source>Position error</source>
            <translation>位置误差</translation>
        </message>
        <message>
            <source>Standard error of the position</source>
            <translation>位置的标准误差</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudAlignPage</name>
        <message>
            <source>the survey</source>
            <translation>调查数据</translation>
        </message>
        <message>
            <source>With scale</source>
            <translation>含比例</translation>
        </message>
        <message>
            <source>The pairs give the scale too. Surveys by laser have none to give: leave it off</source>
            <translation>点对同时给出比例。激光测量本身没有比例误差：一般不勾选</translation>
        </message>
        <message>
            <source>Move by the pairs</source>
            <translation>按点对移动</translation>
        </message>
        <message>
            <source>Pair</source>
            <translation>点对</translation>
        </message>
        <message>
            <source>Onto</source>
            <translation>对齐到</translation>
        </message>
        <message>
            <source>Residual</source>
            <translation>残差</translation>
        </message>
        <message>
            <source>Pairs without a tick do not count; their residual is shown all the same. The largest is bold.</source>
            <translation>未勾选的点对不参与计算，但仍显示其残差。最大的残差用粗体。</translation>
        </message>
        <message>
            <source>Pick pairs</source>
            <translation>选取点对</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>清空</translation>
        </message>
        <message>
            <source>Fine registration</source>
            <translation>精配准</translation>
        </message>
        <message>
            <source>What the cloud is fitted to; it stays where it is</source>
            <translation>点云所配准到的对象；它保持不动</translation>
        </message>
        <message>
            <source>How far apart the same place in both may be at the start</source>
            <translation>开始时同一位置在两者中最多相距多远</translation>
        </message>
        <message>
            <source> m</source>
            <translation> 米</translation>
        </message>
        <message>
            <source>Look within</source>
            <translation>搜索范围</translation>
        </message>
        <message>
            <source>Fit finely</source>
            <translation>精配准</translation>
        </message>
        <message>
            <source>removed</source>
            <translation>已移除</translation>
        </message>
        <message>
            <source>%1 m</source>
            <translation>%1 米</translation>
        </message>
        <message>
            <source>%1 pairs, RMS %2 m</source>
            <translation>%1 个点对，RMS %2 米</translation>
        </message>
        <message>
            <source>scale %1</source>
            <translation>比例 %1</translation>
        </message>
        <message>
            <source>The %1 points lie on a line: the turn about it is not known. Pick one beside it.</source>
            <translation>这 %1 个点在一条直线上：绕该直线的转角无法确定。请在直线旁再选一个点。</translation>
        </message>
        <message>
            <source>%1 of at least 3 pairs</source>
            <translation>已有 %1 个点对，至少需要 3 个</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudDifferencePage</name>
        <message>
            <source>From the surface</source>
            <translation>到表面</translation>
        </message>
        <message>
            <source>What the distances are measured from</source>
            <translation>距离从哪里量起</translation>
        </message>
        <message>
            <source>Points with nothing nearer than this are counted apart, and grey</source>
            <translation>在此范围内没有邻点的点单独计数，显示为灰色</translation>
        </message>
        <message>
            <source> m</source>
            <translation> 米</translation>
        </message>
        <message>
            <source>From the plane through the points about the nearest one, so that the distance between the points of the other cloud counts less</source>
            <translation>到最近点周围各点所成平面的距离，使另一点云的点间距影响更小</translation>
        </message>
        <message>
            <source>From</source>
            <translation>相对于</translation>
        </message>
        <message>
            <source>Look within</source>
            <translation>搜索范围</translation>
        </message>
        <message>
            <source>Measure distances</source>
            <translation>测量距离</translation>
        </message>
        <message>
            <source>Save…</source>
            <translation>保存…</translation>
        </message>
        <message>
            <source>by distance (unsigned)</source>
            <translation>按距离 (无符号)</translation>
        </message>
        <message>
            <source>by height difference (signed)</source>
            <translation>按高差 (有符号)</translation>
        </message>
        <message>
            <source>A height difference is positive where the cloud is higher</source>
            <translation>点云较高处高差为正</translation>
        </message>
        <message>
            <source>The last colour stands for this and more</source>
            <translation>最后一种颜色表示此值及更大的值</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>颜色</translation>
        </message>
        <message>
            <source>Colours up to</source>
            <translation>颜色上限</translation>
        </message>
        <message>
            <source>Measured for the places that the clouds have; moving one of them ends it.</source>
            <translation>按各点云当前的位置测量；移动其中任何一个后结果失效。</translation>
        </message>
        <message>
            <source>%1 m</source>
            <translation>%1 米</translation>
        </message>
        <message>
            <source>more than %1 m</source>
            <translation>超过 %1 米</translation>
        </message>
        <message>
            <source>From the surface of %1, %2 points:</source>
            <translation>到%1的表面，%2 个点：</translation>
        </message>
        <message>
            <source>From %1, %2 points:</source>
            <translation>相对于%1，%2 个点：</translation>
        </message>
        <message>
            <source>median %1, 95 % below %2, maximum %3</source>
            <translation>中位数 %1，95 % 小于 %2，最大 %3</translation>
        </message>
        <message>
            <source>%1 points (%2 %) have nothing within %3 m.</source>
            <translation>%1 个点（%2 %）在 %3 米内没有邻点。</translation>
        </message>
        <message>
            <source>Export histogram…</source>
            <translation>导出直方图…</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudJobs</name>
        <message>
            <source>%1 has too many points for View &gt; Memory for points on disk: those about %2 m apart were used.</source>
            <translation>%1 的点太多，超出“视图 &gt; 磁盘点云的内存”：使用间距约 %2 m 的点。</translation>
        </message>
        <message>
            <source>%1 has too many points for View &gt; Memory for points on disk: within %2 m all were used, farther away those about %3 m apart.</source>
            <translation>%1 的点太多，超出“视图 &gt; 磁盘点云的内存”：%2 m 以内使用全部点，更远处使用间距约 %3 m 的点。</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 毫米</translation>
        </message>
        <message>
            <source>A cloud was moved, removed or read again meanwhile: the result was dropped.</source>
            <translation>期间有点云被移动、移除或重新读取：结果已舍弃。</translation>
        </message>
        <message>
            <source>Cancelled: nothing was changed.</source>
            <translation>已取消：没有任何改动。</translation>
        </message>
        <message>
            <source>%1 is shown from the disk: its coarse points are used.</source>
            <translation>%1 是从磁盘显示的：只使用其粗略点。</translation>
        </message>
        <message>
            <source>the survey</source>
            <translation>调查数据</translation>
        </message>
        <message>
            <source>Fitting %1</source>
            <translation>正在配准 %1</translation>
        </message>
        <message>
            <source>fine registration of %1</source>
            <translation>精配准 %1</translation>
        </message>
        <message>
            <source>RMS %1, overlap %2 % within %3 m, %4 of %5 points compared</source>
            <translation>RMS %1，重叠 %2 %（%3 米以内），比较了 %5 个点中的 %4 个</translation>
        </message>
        <message>
            <source>The cloud was left where it was.</source>
            <translation>点云保持原位。</translation>
        </message>
        <message>
            <source>Fitted: %1. Before: RMS %2, overlap %3 %. Moved by %4 m and %5°.</source>
            <translation>已配准：%1。之前：RMS %2，重叠 %3 %。移动了 %4 米、%5°。</translation>
        </message>
        <message>
            <source>Too few points have a partner near them. Move the cloud nearer by pairs of points, or look farther.</source>
            <translation>附近有对应点的点太少。请先用点对把点云移近，或加大搜索范围。</translation>
        </message>
        <message>
            <source>It did not come to rest (%1).</source>
            <translation>未能收敛（%1）。</translation>
        </message>
        <message>
            <source>Nothing fits better than where it is: RMS %1, overlap %2 %.</source>
            <translation>没有比当前更好的位置：RMS %1，重叠 %2 %。</translation>
        </message>
        <message>
            <source>The points do not hold the cloud: it could slide along (%1, %2, %3).</source>
            <translation>这些点固定不住点云：它可沿 (%1, %2, %3) 滑动。</translation>
        </message>
        <message>
            <source>The points do not hold the cloud: it could turn about (%1, %2, %3).</source>
            <translation>这些点固定不住点云：它可绕 (%1, %2, %3) 转动。</translation>
        </message>
        <message>
            <source>Measuring distances of %1</source>
            <translation>正在测量 %1 的距离</translation>
        </message>
        <message>
            <source>Writing %1</source>
            <translation>正在写入 %1</translation>
        </message>
        <message>
            <source>The cloud was written to %1</source>
            <translation>点云已写入 %1</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudLookPage</name>
        <message>
            <source>Height (z)</source>
            <translation>高程 (z)</translation>
        </message>
        <message>
            <source>Distance</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>Height difference</source>
            <translation>高差</translation>
        </message>
        <message>
            <source>One colour keeps clouds apart. Numbers that colour the survey too have the same scale.</source>
            <translation>单一颜色便于区分各点云。与调查数据按同一数值着色时,色标相同。</translation>
        </message>
        <message>
            <source>Another colour for the cloud</source>
            <translation>为点云另选颜色</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>颜色</translation>
        </message>
        <message>
            <source>Size of a point on the screen</source>
            <translation>点在屏幕上的大小</translation>
        </message>
        <message>
            <source> px</source>
            <translation> 像素</translation>
        </message>
        <message>
            <source>as the survey</source>
            <translation>与调查数据相同</translation>
        </message>
        <message>
            <source>Point size</source>
            <translation>点大小</translation>
        </message>
        <message>
            <source>Opacity</source>
            <translation>不透明度</translation>
        </message>
        <message>
            <source>How little shines through the points of the cloud in the 3-D view</source>
            <translation>三维视图中点云各点不透光的程度</translation>
        </message>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>One colour</source>
            <translation>单一颜色</translation>
        </message>
        <message>
            <source>Colour of the cloud</source>
            <translation>点云颜色</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudPairs</name>
        <message>
            <source>Click a point of %1, or the point that it belongs to.</source>
            <translation>点击 %1 的一个点，或它所对应的点。</translation>
        </message>
        <message>
            <source>Click where this point of %1 belongs: in the survey or another cloud.</source>
            <translation>点击 %1 的这个点应在的位置：在调查数据或另一点云中。</translation>
        </message>
        <message>
            <source>Click the point of %1 that belongs there.</source>
            <translation>点击 %1 中属于该处的点。</translation>
        </message>
        <message>
            <source>There is no point here. Click one that is drawn.</source>
            <translation>此处没有点。请点击已显示的点。</translation>
        </message>
        <message>
            <source>Both points are of %1: the second one takes the place of the first.</source>
            <translation>两个点都属于 %1：以第二个点代替第一个点。</translation>
        </message>
        <message>
            <source>Neither point is of %1: the second one takes the place of the first.</source>
            <translation>两个点都不属于 %1：以第二个点代替第一个点。</translation>
        </message>
        <message>
            <source>move %1 by pairs of points</source>
            <translation>按点对移动 %1</translation>
        </message>
        <message>
            <source>%1 was moved by %2 pairs of points: RMS %3 m</source>
            <translation>%1 已按 %2 个点对移动：RMS %3 米</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudPanel</name>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Clouds</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>Cloud</source>
            <translation>点云</translation>
        </message>
        <message>
            <source>Points</source>
            <translation>点数</translation>
        </message>
        <message>
            <source>Ticked clouds are drawn. Space: tick. Double click: zoom to it.</source>
            <translation>显示已勾选的点云。空格键:勾选。双击:缩放至该点云。</translation>
        </message>
        <message>
            <source>Add…</source>
            <translation>添加…</translation>
        </message>
        <message>
            <source>Zoom to</source>
            <translation>缩放至</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>not read</source>
            <translation>未读取</translation>
        </message>
        <message>
            <source>This cloud lies %1 from the survey, too far to be drawn with it.</source>
            <translation>该点云距调查数据 %1,太远,无法一同显示。</translation>
        </message>
        <message>
            <source>This cloud lies %1 from the survey.</source>
            <translation>该点云距调查数据 %1。</translation>
        </message>
        <message>
            <source>Shown from the disk: what is near comes in full.</source>
            <translation>自磁盘显示:近处的点将全部载入。</translation>
        </message>
        <message>
            <source>Clouds to look at beside the survey. They are drawn, measured by clicks and cut, and never enter a computation.</source>
            <translation>与调查数据一同查看的点云。可显示、点击量测和剖切,但从不参与计算。</translation>
        </message>
        <message>
            <source>Choose its file…</source>
            <translation>选择其文件…</translation>
        </message>
        <message>
            <source>Move here</source>
            <translation>移到此处</translation>
        </message>
        <message>
            <source>The file where it lies now; place and look of the cloud stay</source>
            <translation>文件现在所在的位置;点云的位置和外观保持不变</translation>
        </message>
        <message>
            <source>Where is %1?</source>
            <translation>%1 在哪里?</translation>
        </message>
        <message>
            <source>Point clouds</source>
            <translation>点云文件</translation>
        </message>
        <message>
            <source>All files</source>
            <translation>所有文件</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>Look</source>
            <translation>外观</translation>
        </message>
        <message>
            <source>Align</source>
            <translation>对齐</translation>
        </message>
        <message>
            <source>Distances</source>
            <translation>距离</translation>
        </message>
        <message>
            <source>Shown at scale %1: lengths in this cloud are not those of its file.</source>
            <translation>以比例 %1 显示：此点云中的长度与文件中的不同。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CloudPlacePage</name>
        <message>
            <source> m</source>
            <translation> 米</translation>
        </message>
        <message>
            <source>Shift x</source>
            <translation>平移 x</translation>
        </message>
        <message>
            <source>Shift y</source>
            <translation>平移 y</translation>
        </message>
        <message>
            <source>Shift z</source>
            <translation>平移 z</translation>
        </message>
        <message>
            <source>By how much the cloud is moved; its file stays as it is</source>
            <translation>点云移动的距离;文件保持不变</translation>
        </message>
        <message>
            <source>Counter-clockwise about the vertical through the middle of the cloud</source>
            <translation>绕过点云中心的铅垂线逆时针旋转</translation>
        </message>
        <message>
            <source>About the x axis through the middle of the cloud: what is north rises</source>
            <translation>绕过点云中心的 x 轴：北侧升高</translation>
        </message>
        <message>
            <source>About the y axis through the middle of the cloud: what is east sinks</source>
            <translation>绕过点云中心的 y 轴：东侧下降</translation>
        </message>
        <message>
            <source>How much larger the cloud is shown than its file has it</source>
            <translation>点云显示得比文件中大多少倍</translation>
        </message>
        <message>
            <source>Turn</source>
            <translation>旋转</translation>
        </message>
        <message>
            <source>Tilt x</source>
            <translation>倾角 x</translation>
        </message>
        <message>
            <source>Tilt y</source>
            <translation>倾角 y</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>比例</translation>
        </message>
        <message>
            <source>Not to scale: what is measured in this cloud is %1 times as large as in its file.</source>
            <translation>比例不为一：在此点云中量得的长度是文件中的 %1 倍。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Clouds</name>
        <message>
            <source>move cloud %1</source>
            <translation>移动点云 %1</translation>
        </message>
        <message>
            <source>Select a cloud in the panel Clouds first.</source>
            <translation>请先在“点云”面板中选择一个点云。</translation>
        </message>
        <message>
            <source>Add a cloud to look at…</source>
            <translation>添加对照点云…</translation>
        </message>
        <message>
            <source>Another point cloud beside the survey: drawn, measured and cut, never computed with</source>
            <translation>与调查数据一同查看的另一点云:可显示、量测和剖切,从不参与计算</translation>
        </message>
        <message>
            <source>Show the cloud</source>
            <translation>显示点云</translation>
        </message>
        <message>
            <source>Zoom to the cloud</source>
            <translation>缩放至点云</translation>
        </message>
        <message>
            <source>Select a cloud that is drawn first.</source>
            <translation>请先选择一个已显示的点云。</translation>
        </message>
        <message>
            <source>Move the cloud to the survey</source>
            <translation>将点云移到调查数据处</translation>
        </message>
        <message>
            <source>By the coordinate system where both have one, else centre onto centre; its numbers can be changed afterwards</source>
            <translation>两者都有坐标系时按坐标系移动,否则中心对中心;之后可修改数值</translation>
        </message>
        <message>
            <source>Remove the cloud</source>
            <translation>移除点云</translation>
        </message>
        <message>
            <source>From the list; its file stays</source>
            <translation>从列表中移除;文件保留</translation>
        </message>
        <message>
            <source>Cancel the reading</source>
            <translation>取消读取</translation>
        </message>
        <message>
            <source>No cloud is being read.</source>
            <translation>没有正在读取的点云。</translation>
        </message>
        <message>
            <source>Add a cloud to look at</source>
            <translation>添加对照点云</translation>
        </message>
        <message>
            <source>Point clouds</source>
            <translation>点云文件</translation>
        </message>
        <message>
            <source>All files</source>
            <translation>所有文件</translation>
        </message>
        <message>
            <source>Reading %1</source>
            <translation>正在读取 %1</translation>
        </message>
        <message>
            <source>Reading %1: %2 %</source>
            <translation>正在读取 %1:%2 %</translation>
        </message>
        <message>
            <source>add cloud %1</source>
            <translation>添加点云 %1</translation>
        </message>
        <message>
            <source>Its reading was cancelled.</source>
            <translation>读取已取消。</translation>
        </message>
        <message>
            <source>%1 lies %2 from the survey. &quot;Move here&quot; in the panel Clouds moves it there.</source>
            <translation>%1 距调查数据 %2。点击“点云”面板中的“移到此处”可将其移来。</translation>
        </message>
        <message>
            <source>remove cloud %1</source>
            <translation>移除点云 %1</translation>
        </message>
        <message>
            <source>%1 was moved by the place of the survey in their coordinate system: %2, %3, %4 m</source>
            <translation>已按调查数据在共同坐标系中的位置移动 %1:%2, %3, %4 米</translation>
        </message>
        <message>
            <source>%1 was moved centre onto centre: %2, %3, %4 m</source>
            <translation>已将 %1 中心对中心移动:%2, %3, %4 米</translation>
        </message>
        <message>
            <source>Clouds in slice and profile</source>
            <translation>在横切面和纵剖面中显示点云</translation>
        </message>
        <message>
            <source>The points of the clouds that are drawn, in their colours, beside those of the survey</source>
            <translation>把已显示点云的点以各自颜色画在调查数据的点旁</translation>
        </message>
        <message>
            <source>Select a cloud that was read, and wait until other work on clouds has ended.</source>
            <translation>请选择一个已读取的点云，并等待其他点云作业结束。</translation>
        </message>
        <message>
            <source>Pick pairs of points</source>
            <translation>选取点对</translation>
        </message>
        <message>
            <source>Click a point of the cloud and the point of the survey, or of another cloud, that it belongs to; three pairs or more</source>
            <translation>点击点云中的一个点，以及它在调查数据或另一点云中所对应的点；至少三个点对</translation>
        </message>
        <message>
            <source>Remove the pair of points</source>
            <translation>移除点对</translation>
        </message>
        <message>
            <source>Select a pair of points in the panel Clouds first.</source>
            <translation>请先在“点云”面板中选择一个点对。</translation>
        </message>
        <message>
            <source>From the list; the cloud stays where it is</source>
            <translation>仅从列表中移除；点云保持原位</translation>
        </message>
        <message>
            <source>Remove all pairs of points</source>
            <translation>移除所有点对</translation>
        </message>
        <message>
            <source>There is no pair of points.</source>
            <translation>没有点对。</translation>
        </message>
        <message>
            <source>Move the cloud by the pairs of points</source>
            <translation>按点对移动点云</translation>
        </message>
        <message>
            <source>Pick three pairs of points or more that are not on a line.</source>
            <translation>请选取至少三个不在一条直线上的点对。</translation>
        </message>
        <message>
            <source>Least squares over the ticked pairs; one step that can be undone</source>
            <translation>对勾选的点对作最小二乘；为一个可撤销的步骤</translation>
        </message>
        <message>
            <source>Fit the cloud finely</source>
            <translation>精配准点云</translation>
        </message>
        <message>
            <source>From a place that is roughly right: moves and turns the cloud until its points lie on the surfaces of the other one. It stays where it is when they do not come to fit</source>
            <translation>从大致正确的位置开始：移动并转动点云，直到其点落在另一点云的表面上。配准不成时保持原位</translation>
        </message>
        <message>
            <source>Measure the distances of the cloud</source>
            <translation>测量点云的距离</translation>
        </message>
        <message>
            <source>How far each point of the cloud lies from the nearest point of the survey or of another cloud; the points are coloured by it</source>
            <translation>点云的每个点到调查数据或另一点云最近点的距离；点按距离着色</translation>
        </message>
        <message>
            <source>Save the cloud as it is shown…</source>
            <translation>按显示保存点云…</translation>
        </message>
        <message>
            <source>Where it is placed, with the distances that were measured; its file stays as it is</source>
            <translation>按其所在位置保存，并带上测得的距离；原文件不变</translation>
        </message>
        <message>
            <source>Cancel the work on clouds</source>
            <translation>取消点云作业</translation>
        </message>
        <message>
            <source>No work on clouds is under way.</source>
            <translation>没有正在进行的点云作业。</translation>
        </message>
        <message>
            <source>Clouds stay as they are</source>
            <translation>点云保持不变</translation>
        </message>
        <message>
            <source>Save the cloud as it is shown</source>
            <translation>按显示保存点云</translation>
        </message>
        <message>
            <source>Point clouds (*.laz *.las *.ply *.csv *.xyz)</source>
            <translation>点云 (*.laz *.las *.ply *.csv *.xyz)</translation>
        </message>
        <message>
            <source>the survey</source>
            <translation>调查数据</translation>
        </message>
        <message>
            <source>height difference (m)</source>
            <translation>高差 (米)</translation>
        </message>
        <message>
            <source>distance (m)</source>
            <translation>距离 (米)</translation>
        </message>
        <message>
            <source>Export the histogram of the distances…</source>
            <translation>导出距离直方图…</translation>
        </message>
        <message>
            <source>Measure the distances of the cloud first.</source>
            <translation>请先测量点云的距离。</translation>
        </message>
        <message>
            <source>As PNG, SVG or PDF, of the size that you choose</source>
            <translation>PNG、SVG 或 PDF,尺寸由您选定</translation>
        </message>
        <message>
            <source>Height differences of %1</source>
            <translation>%1 的高差</translation>
        </message>
        <message>
            <source>Distances of %1</source>
            <translation>%1 的距离</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::CommandPalette</name>
        <message>
            <source>Type a few letters of what you want to do</source>
            <translation>输入想做的事的几个字</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FirstLook</name>
        <message>
            <source>%1 × %2 × %3 m</source>
            <translation>%1 × %2 × %3 m</translation>
        </message>
        <message>
            <source>%1 points</source>
            <translation>%1 个点</translation>
        </message>
        <message>
            <source>a single tree</source>
            <translation>单株树</translation>
        </message>
        <message>
            <source>flown, no stems seen</source>
            <translation>机载,未见树干</translation>
        </message>
        <message>
            <source>about %1 stems</source>
            <translation>约 %1 株</translation>
        </message>
        <message>
            <source>no coordinate system</source>
            <translation>无坐标系</translation>
        </message>
        <message>
            <source>%1 frames</source>
            <translation>%1 帧</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>%1 rings</source>
            <translation>%1 线</translation>
        </message>
        <message>
            <source>with inertial unit</source>
            <translation>有惯性单元</translation>
        </message>
        <message>
            <source>no inertial unit</source>
            <translation>无惯性单元</translation>
        </message>
        <message>
            <source>shown from the disk</source>
            <translation>从磁盘显示</translation>
        </message>
        <message>
            <source>The points take more than the memory for them (%1 MiB): the window shows the cloud from the disk and loads what is seen. A run reads all %2 points, about %3 GiB. Where that is too much, run the pipeline in tiles: bole campaign.</source>
            <translation>点所需内存超过为其设定的内存(%1 MiB):窗口从磁盘显示点云,只加载看到的部分。运行会读取全部 %2 个点,约 %3 GiB。若太大,请分块运行处理流程:bole campaign。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::NextStep</name>
        <message>
            <source>Cancel the run</source>
            <translation>取消运行</translation>
        </message>
        <message>
            <source>Measure the stems</source>
            <translation>测量单木</translation>
        </message>
        <message>
            <source>Find the rows</source>
            <translation>查找植株行</translation>
        </message>
        <message>
            <source>Measure the plant</source>
            <translation>测量植株</translation>
        </message>
        <message>
            <source>Run the pipeline</source>
            <translation>运行处理流程</translation>
        </message>
        <message>
            <source>Open the report</source>
            <translation>打开报告</translation>
        </message>
        <message>
            <source>Write survey and report</source>
            <translation>输出调查结果和报告</translation>
        </message>
        <message numerus="yes">
            <source>%n stem(s)</source>
            <translation>
                <numerusform>%n 株单木</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n doubtful</source>
            <translation>
                <numerusform>%n 株可疑</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n decided</source>
            <translation>
                <numerusform>%n 株已定</numerusform>
            </translation>
        </message>
        <message>
            <source>Look at the next doubtful stem</source>
            <translation>查看下一株可疑单木</translation>
        </message>
        <message>
            <source>larger than the memory for points: an index is built once, %1 %</source>
            <translation>超过点的内存:正在建立一次性索引,%1 %</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::TableModel</name>
        <message>
            <source>Column %1 in files and filters</source>
            <translation>文件和筛选中的列名:%1</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::TablePanel</name>
        <message>
            <source>All columns in their usual order</source>
            <translation>全部列,按默认顺序</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Bookmarks</name>
        <message>
            <source>Bookmark this view…</source>
            <translation>将此视图加入书签…</translation>
        </message>
        <message>
            <source>Bookmark</source>
            <translation>书签</translation>
        </message>
        <message>
            <source>Name of the view</source>
            <translation>视图名称</translation>
        </message>
        <message>
            <source>View %1</source>
            <translation>视图 %1</translation>
        </message>
        <message>
            <source>Bookmarked views</source>
            <translation>书签视图</translation>
        </message>
        <message>
            <source>Delete bookmark</source>
            <translation>删除书签</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::ControlTable</name>
        <message>
            <source>Point</source>
            <translation>点</translation>
        </message>
        <message>
            <source>Easting (m)</source>
            <translation>东坐标 (m)</translation>
        </message>
        <message>
            <source>Northing (m)</source>
            <translation>北坐标 (m)</translation>
        </message>
        <message>
            <source>Height (m)</source>
            <translation>高程 (m)</translation>
        </message>
        <message>
            <source>x in the plot (m)</source>
            <translation>样地 x (m)</translation>
        </message>
        <message>
            <source>y in the plot (m)</source>
            <translation>样地 y (m)</translation>
        </message>
        <message>
            <source>Residual east (cm)</source>
            <translation>东向残差 (cm)</translation>
        </message>
        <message>
            <source>north (cm)</source>
            <translation>北向 (cm)</translation>
        </message>
        <message>
            <source>up (cm)</source>
            <translation>高程 (cm)</translation>
        </message>
        <message>
            <source>Off the others (cm)</source>
            <translation>与其他点之差 (cm)</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>备注</translation>
        </message>
        <message>
            <source>Name of a target of the plot (centre, north), or any name where x and y are given</source>
            <translation>样地标靶的名称(centre、north);给出 x、y 时可为任意名称</translation>
        </message>
        <message>
            <source>In the coordinate system above</source>
            <translation>采用上方的坐标系</translation>
        </message>
        <message>
            <source>Optional; three or more heights level the plot</source>
            <translation>可选;三个及以上高程可将样地调平</translation>
        </message>
        <message>
            <source>Place of the point in the plot, where it is not a target</source>
            <translation>点在样地中的位置(该点不是标靶时)</translation>
        </message>
        <message>
            <source>Given minus adjusted</source>
            <translation>给定值减平差值</translation>
        </message>
        <message>
            <source>Distance from where the other points put this one, and the limit for a good point</source>
            <translation>与其他点推算位置的距离,以及合格点的限值</translation>
        </message>
        <message>
            <source>What the adjustment says of the point</source>
            <translation>平差对该点的说明</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>已剔除</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlaceForm</name>
        <message>
            <source>Place on the earth</source>
            <translation>地理位置</translation>
        </message>
        <message>
            <source>Projected coordinate system of the points and of all exports: an EPSG code or WKT</source>
            <translation>控制点和所有导出结果的投影坐标系:EPSG 代码或 WKT</translation>
        </message>
        <message>
            <source>Give the plot this place</source>
            <translation>应用到样地</translation>
        </message>
        <message>
            <source>Coordinate system</source>
            <translation>坐标系</translation>
        </message>
        <message>
            <source>Add a point</source>
            <translation>添加点</translation>
        </message>
        <message>
            <source>Ctrl+V in the table pastes rows of a spreadsheet</source>
            <translation>在表中按 Ctrl+V 可粘贴电子表格的行</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>The selected points</source>
            <translation>所选的点</translation>
        </message>
        <message>
            <source>From a file…</source>
            <translation>从文件…</translation>
        </message>
        <message>
            <source>A table with name, easting_m, northing_m, height_m</source>
            <translation>含 name、easting_m、northing_m、height_m 的表格</translation>
        </message>
        <message>
            <source>Control points</source>
            <translation>控制点</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt)</source>
            <translation>表格 (*.csv *.txt)</translation>
        </message>
        <message>
            <source>Centre and compass…</source>
            <translation>中心与罗盘…</translation>
        </message>
        <message>
            <source>One point and a bearing instead: the options of the stage</source>
            <translation>改用一个点和一个方位角:见该步骤的参数</translation>
        </message>
        <message>
            <source>Place on the earth…</source>
            <translation>地理位置…</translation>
        </message>
        <message>
            <source>Open a pipeline with a stage that georeferences.</source>
            <translation>请先打开含地理配准步骤的处理流程。</translation>
        </message>
        <message>
            <source>Control points, their coordinate system and the residuals</source>
            <translation>控制点、坐标系与残差</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlanMap</name>
        <message>
            <source>Plan map</source>
            <translation>平面图</translation>
        </message>
        <message>
            <source>Open a scan or a point cloud first.</source>
            <translation>请先打开扫描或点云。</translation>
        </message>
        <message>
            <source>From above, north up, with tree numbers; drag to move</source>
            <translation>俯视,北向上,显示树号;拖动平移</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlotBoundary</name>
        <message>
            <source>Move the plot boundary</source>
            <translation>移动样地边界</translation>
        </message>
        <message>
            <source>Run a pipeline with a stage that gives the plot its boundary.</source>
            <translation>请先运行含样地边界步骤的处理流程。</translation>
        </message>
        <message>
            <source>Drag its centre; shape and size are options of the stage</source>
            <translation>拖动其中心;形状和大小是该步骤的参数</translation>
        </message>
        <message>
            <source>Drag the centre of the plot.</source>
            <translation>拖动样地的中心。</translation>
        </message>
        <message>
            <source>move the plot boundary</source>
            <translation>移动样地边界</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PointEditor</name>
        <message>
            <source>Edit points</source>
            <translation>编辑点</translation>
        </message>
        <message>
            <source>Run a pipeline first that has points and a stage that takes edits of them.</source>
            <translation>请先运行一个含有点云和点编辑步骤的处理流程。</translation>
        </message>
        <message>
            <source>Select points first.</source>
            <translation>请先选择点。</translation>
        </message>
        <message>
            <source>Select points with a brush</source>
            <translation>用画笔选择点</translation>
        </message>
        <message>
            <source>Brush</source>
            <translation>画笔</translation>
        </message>
        <message>
            <source>Paint over points with the left mouse button. Enter applies, Escape ends.</source>
            <translation>按住鼠标左键涂过点。Enter 应用,Esc 结束。</translation>
        </message>
        <message>
            <source>Select points with a polygon</source>
            <translation>用多边形选择点</translation>
        </message>
        <message>
            <source>Polygon</source>
            <translation>多边形</translation>
        </message>
        <message>
            <source>Click the corners, or draw around the points. All that is seen within is selected, at any depth; in the cross-section as deep as it is wide.</source>
            <translation>单击各拐点,或绕点画线。选中其中所见的全部点,不论远近;在横断面中只选断面宽度内的点。</translation>
        </message>
        <message>
            <source>Select points with a box</source>
            <translation>用立方框选择点</translation>
        </message>
        <message>
            <source>Box</source>
            <translation>立方框</translation>
        </message>
        <message>
            <source>Click its middle; sizes and turn stand in the form.</source>
            <translation>单击其中心;尺寸和转角在面板中设置。</translation>
        </message>
        <message>
            <source>Apply to the selected points</source>
            <translation>应用于所选的点</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>应用</translation>
        </message>
        <message>
            <source>Drop the selection of points</source>
            <translation>放弃所选的点</translation>
        </message>
        <message>
            <source>Drop</source>
            <translation>放弃</translation>
        </message>
        <message>
            <source>Click corners or draw around the points. Enter applies, Escape ends.</source>
            <translation>单击各顶点或围绕点绘制。Enter 应用,Esc 结束。</translation>
        </message>
        <message>
            <source>Click the middle of the box. Enter applies, Escape ends.</source>
            <translation>单击立方框的中心。Enter 应用,Esc 结束。</translation>
        </message>
        <message>
            <source>The outline crosses itself: draw it again.</source>
            <translation>轮廓自相交,请重新绘制。</translation>
        </message>
        <message>
            <source>Points selected: %1</source>
            <translation>已选点数:%1</translation>
        </message>
        <message>
            <source>new tree of points</source>
            <translation>由点新建单木</translation>
        </message>
        <message>
            <source>Points given: %1</source>
            <translation>已归属点数:%1</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PointPanel</name>
        <message>
            <source>Selected tree</source>
            <translation>所选单木</translation>
        </message>
        <message>
            <source>New tree</source>
            <translation>新单木</translation>
        </message>
        <message>
            <source>No tree</source>
            <translation>不属于任何树</translation>
        </message>
        <message>
            <source>Ground</source>
            <translation>地面</translation>
        </message>
        <message>
            <source>Noise</source>
            <translation>噪声</translation>
        </message>
        <message>
            <source>What the selected points become. A new tree stands where the points hold a stem.</source>
            <translation>所选点的归属。新单木位于这些点中树干所在处。</translation>
        </message>
        <message>
            <source>Points become</source>
            <translation>点归于</translation>
        </message>
        <message>
            <source>All points</source>
            <translation>所有点</translation>
        </message>
        <message>
            <source>Points of no tree</source>
            <translation>不属于任何树的点</translation>
        </message>
        <message>
            <source>Points of the selected tree</source>
            <translation>所选单木的点</translation>
        </message>
        <message>
            <source>Which of the selected points change. Ground and noise take all.</source>
            <translation>所选的点中哪些改变。归于地面和噪声时全部改变。</translation>
        </message>
        <message>
            <source>Only</source>
            <translation>仅限</translation>
        </message>
        <message>
            <source>Points so near the stroke of the brush are selected</source>
            <translation>与画笔轨迹的距离不超过此值的点被选中</translation>
        </message>
        <message>
            <source>Radius of the brush</source>
            <translation>画笔半径</translation>
        </message>
        <message>
            <source>Size of the box: x, y and z before it is turned</source>
            <translation>立方框的尺寸:旋转前的 x、y、z</translation>
        </message>
        <message>
            <source>Size of the box</source>
            <translation>立方框尺寸</translation>
        </message>
        <message>
            <source>Turns the box about the vertical, anti-clockwise seen from above</source>
            <translation>立方框绕铅垂轴旋转,俯视为逆时针</translation>
        </message>
        <message>
            <source>Turn of the box</source>
            <translation>立方框转角</translation>
        </message>
        <message>
            <source> m</source>
            <translation> m</translation>
        </message>
        <message>
            <source>Brush, draw around or click points in the 3-D view.</source>
            <translation>在三维视图中涂画、围绕绘制或单击点。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::LessonGuide</name>
        <message>
            <source>Cancelled.</source>
            <translation>已取消。</translation>
        </message>
        <message>
            <source>This could not be done: %1</source>
            <translation>未能完成:%1</translation>
        </message>
        <message>
            <source>Do this yourself: %1</source>
            <translation>请自己完成:%1</translation>
        </message>
        <message>
            <source>First do what the step needs: the answer comes from your own run.</source>
            <translation>请先完成本步的要求:答案来自您自己的运行。</translation>
        </message>
        <message>
            <source>'%1' is not a number. Type one such as 12.3, without its unit.</source>
            <translation>“%1”不是数字。请输入如 12.3 的数字,不带单位。</translation>
        </message>
        <message>
            <source>Not %1.</source>
            <translation>不是 %1。</translation>
        </message>
        <message>
            <source>Right: %1.</source>
            <translation>正确:%1。</translation>
        </message>
        <message>
            <source>Your run does not give the answer: %1</source>
            <translation>您的运行没有给出答案:%1</translation>
        </message>
        <message>
            <source>Choose an answer first.</source>
            <translation>请先选择一个答案。</translation>
        </message>
        <message>
            <source>Right.</source>
            <translation>正确。</translation>
        </message>
        <message>
            <source>No.</source>
            <translation>不对。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::LessonPanel</name>
        <message>
            <source>About %1 minutes. %2 of %3 questions answered rightly.</source>
            <translation>约 %1 分钟。%3 题中答对 %2 题。</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Step %1 of %2; %3 of %4 questions</source>
            <translation>第 %1 步,共 %2 步;答对 %3 题,共 %4 题</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::QuestionView</name>
        <message>
            <source>Check answer</source>
            <translation>检查答案</translation>
        </message>
        <message>
            <source>You answered this rightly.</source>
            <translation>此题已答对。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::Fly</name>
        <message>
            <source>Fly through the plot</source>
            <translation>在样地中飞行</translation>
        </message>
        <message>
            <source>Open a scan or a point cloud first.</source>
            <translation>请先打开扫描或点云。</translation>
        </message>
        <message>
            <source>W A S D or the arrow keys move, the mouse looks around, the wheel sets the speed; Esc ends</source>
            <translation>W A S D 或方向键移动,鼠标转动视线,滚轮调节速度;Esc 结束</translation>
        </message>
        <message>
            <source>ahead, left, back, right</source>
            <translation>前、左、后、右</translation>
        </message>
        <message>
            <source>the same</source>
            <translation>同上</translation>
        </message>
        <message>
            <source>up, down</source>
            <translation>上、下</translation>
        </message>
        <message>
            <source>Page Up, Page Down</source>
            <translation>Page Up、Page Down</translation>
        </message>
        <message>
            <source>look around</source>
            <translation>环视</translation>
        </message>
        <message>
            <source>move the mouse</source>
            <translation>移动鼠标</translation>
        </message>
        <message>
            <source>faster, slower</source>
            <translation>加速、减速</translation>
        </message>
        <message>
            <source>wheel</source>
            <translation>滚轮</translation>
        </message>
        <message>
            <source>end</source>
            <translation>结束</translation>
        </message>
        <message>
            <source>Esc, click</source>
            <translation>Esc、单击</translation>
        </message>
        <message>
            <source>W A S D or arrow keys move at %1 m/s, mouse looks, wheel sets the speed, Esc ends.</source>
            <translation>W A S D 或方向键以 %1 m/s 移动,鼠标环视,滚轮调速,Esc 结束。</translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::MapBehind</name>
        <message>
            <source>Map behind the survey…</source>
            <translation>调查数据下方的底图…</translation>
        </message>
        <message>
            <source>A picture of the place, such as an orthophoto, below the survey</source>
            <translation>调查数据下方显示当地的图像，例如正射影像</translation>
        </message>
        <message>
            <source>Map behind the survey</source>
            <translation>调查数据下方的底图</translation>
        </message>
        <message>
            <source>Open a map first: File &gt; Map behind the survey.</source>
            <translation>请先打开底图:文件 &gt; 调查数据下方的底图。</translation>
        </message>
        <message>
            <source>Remove the map</source>
            <translation>移除底图</translation>
        </message>
        <message>
            <source>Pictures with a place on the earth</source>
            <translation>带有地理位置的图像</translation>
        </message>
        <message>
            <source>All files</source>
            <translation>所有文件</translation>
        </message>
        <message>
            <source>The map is kept. It is shown with the survey.</source>
            <translation>底图已保留,将与调查数据一起显示。</translation>
        </message>
        <message>
            <source>%1 lies behind the survey; its pixels are %2 m.</source>
            <translation>%1 已置于调查数据下方,像元大小为 %2 m。</translation>
        </message>
        <message>
            <source>It names no coordinate system and was taken to have that of the survey.</source>
            <translation>它没有注明坐标系,按调查数据的坐标系处理。</translation>
        </message>
        <message>
            <source>The survey names no coordinate system and was taken to have that of the picture.</source>
            <translation>调查数据没有注明坐标系,按图像的坐标系处理。</translation>
        </message>
        <message>
            <source>The survey has no place on the earth yet. The map is kept and is shown once it has one: give it control points (Tools &gt; Place on the earth).</source>
            <translation>调查数据还没有地理位置。底图已保留,待调查数据有了位置后显示:请给出控制点(工具 &gt; 地理位置)。</translation>
        </message>
    </context>
</TS>
