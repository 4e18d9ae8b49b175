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
            <source>Edit points</source>
            <translation>编辑点</translation>
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
            <translation>胸高横切面</translation>
        </message>
        <message>
            <source>Find the plot frame</source>
            <translation>确定样地坐标系</translation>
        </message>
        <message>
            <source>Plot boundary and minimum diameter</source>
            <translation>样地边界与起测胸径</translation>
        </message>
        <message>
            <source>Compute plot values</source>
            <translation>计算样地指标</translation>
        </message>
        <message>
            <source>Join points and trajectory</source>
            <translation>连接点云与轨迹</translation>
        </message>
        <message>
            <source>Read views</source>
            <translation>读取视图</translation>
        </message>
        <message>
            <source>Calibrate a camera</source>
            <translation>标定相机</translation>
        </message>
            <message>
            <source>Estimate camera poses</source>
            <translation>估计相机位姿</translation>
        </message>
        <message>
            <source>Fuse depth images</source>
            <translation>融合深度图</translation>
        </message>
        <message>
            <source>Train a radiance field</source>
            <translation>训练辐射场</translation>
        </message>
        <message>
            <source>Render a view of a field</source>
            <translation>渲染辐射场视图</translation>
        </message>
        <message>
            <source>Match views (multi-view stereo)</source>
            <translation>匹配视图（多视立体）</translation>
        </message>
        <message>
            <source>Separate the plant</source>
            <translation>分离植株</translation>
        </message>
        <message>
            <source>Measure the plant</source>
            <translation>测量植株</translation>
        </message>
        <message>
            <source>Edit the plant</source>
            <translation>编辑植株</translation>
        </message>
        <message>
            <source>Write the seedling</source>
            <translation>写出幼苗结果</translation>
        </message>
        <message>
            <source>Georeference the plot</source>
            <translation>样地地理定位</translation>
        </message>
        <message>
            <source>Check the map</source>
            <translation>检查地图</translation>
        </message>
        <message>
            <source>Compare two surveys</source>
            <translation>比较两次调查</translation>
        </message>
        <message>
            <source>Write the growth</source>
            <translation>写出生长量</translation>
        </message>
        <message>
            <source>Read runs</source>
            <translation>读取运行结果</translation>
        </message>
        <message>
            <source>Compare runs</source>
            <translation>比较运行结果</translation>
        </message>
        <message>
            <source>Write the comparison</source>
            <translation>输出比较报告</translation>
        </message>
        <message>
            <source>Sample a known stand</source>
            <translation>在已知林分中抽样</translation>
        </message>
        <message>
            <source>Write the sample plots</source>
            <translation>输出样圆抽样结果</translation>
        </message>
        <message>
            <source>Resect the sensor</source>
            <translation>传感器后方交会</translation>
        </message>
        <message>
            <source>Navigate a recorded track</source>
            <translation>解算记录的航迹</translation>
        </message>
        <message>
            <source>Plan guidance lines</source>
            <translation>规划导航线</translation>
        </message>
        <message>
            <source>Edit loop closures</source>
            <translation>编辑回环</translation>
        </message>
        <message>
            <source>Evaluate rows</source>
            <translation>评价行</translation>
        </message>
        <message>
            <source>Cut a cloud into tiles</source>
            <translation>将点云切成分块</translation>
        </message>
        <message>
            <source>Read a raster</source>
            <translation>读取栅格</translation>
        </message>
        <message>
            <source>Write a tile</source>
            <translation>写出分块</translation>
        </message>
        <message>
            <source>Evidence of the stems</source>
            <translation>树干的证据</translation>
        </message>
        <message>
            <source>Pool the priors</source>
            <translation>汇总先验</translation>
        </message>
        <message>
            <source>Renumber trees</source>
            <translation>重新编号树木</translation>
        </message>
        <message>
            <source>Make a film</source>
            <translation>制作影片</translation>
        </message>
</context>
    <context>
        <name>stage help</name>
        <message>
            <source>Keeps the points that a person gave to a tree, to no tree, to the ground or to noise: to_tree, to_no_tree, to_ground and to_noise, each with author, time and reason. Points are selected by an outline drawn over a view, a box or the stroke of a brush, never by their numbers, so that the same edits hold for a cloud that was thinned or read again. ground.model leaves points of noise out and takes those given to the ground for ground; stems.measure gives points to trees before it measures heights, crowns and volumes; stems.edit does so for trees that a person added. Diameters do not follow from points given to a tree.</source>
            <translation>保存人工判定的点：归于某株树(to_tree)、不属于任何树(to_no_tree)、归于地面(to_ground)或噪声(to_noise)，各带作者、时间和理由。点由在视图上绘制的轮廓、立方框或画笔轨迹选取，从不按点号，因此同样的编辑也适用于抽稀或重新读入的点云。ground.model 剔除噪声点，并把归于地面的点当作地面；stems.measure 在测定树高、树冠和材积之前把点归于单木；stems.edit 对人工添加的单木同样处理。胸径不随归于单木的点改变。</translation>
        </message>
        <message>
            <source>Compares stems and trajectory with a reference. Stems are matched one to one (Hungarian method) within distance and diameter gates; rejected stems take no part. Reports completeness and correctness, mean and covariance of the position error, and bias and RMSE of the diameters, overall, by diameter class and, where a plot is connected, by distance from its centre. Reports the absolute and relative error of the trajectory. Without a reference the tables are empty. Columns of a field list with other headings are guessed and the guess is reported.</source>
            <translation>将单木和轨迹与参考数据比较:在距离和直径阈值内用匈牙利法做一对一匹配,给出完整率和正确率、位置误差的均值与协方差、直径的偏差与 RMSE;既给出总体结果,也按径阶给出,连接样地时还按到样地中心的距离给出;被拒绝的单木不参与;另给出轨迹的绝对误差和相对误差。没有参考数据时各表为空。外业清单的列名不同时,按标题猜测并予以说明。</translation>
        </message>
        <message>
            <source>Converts latitude and longitude of a table to metres of a plane or back: Gauss-Krueger zones of 3 and 6 degrees, UTM, or any transverse Mercator plane, with the exact projection. The definition of the plane stays with the table, so exports contain it.</source>
            <translation>将表中的纬度和经度换算为平面坐标(米),或反向换算:支持 3 度和 6 度高斯-克吕格带、UTM 以及任意横轴墨卡托平面,采用严密投影。平面的定义随表保存,因此导出的文件也包含它。</translation>
        </message>
        <message>
            <source>Separates ground from vegetation, makes a terrain model (DEM) and gives every point its height above it. The lowest groups of points of small cells are taken into a triangulation step by step; then a robust plane is fitted to the band of ground points around each cell, so that the model runs through the middle of the band and not along its lower edge or the top of the grass. Cells without ground points are interpolated and marked in dem_filled; further than fill_distance from any ground point the model has no value and points there have no height (NaN).</source>
            <translation>区分地面与植被,建立地形模型(DEM),并给出每个点的离地高度。先从小格网中最低的点组逐步加密三角网;再在每个格网周围的地面点带上稳健拟合平面,使模型位于点带中间,而不是其下缘或草丛顶部。没有地面点的格网由插值得到,并在 dem_filled 中标出;与任何地面点的距离超过 fill_distance 处,模型没有值,该处的点也没有高度(NaN)。</translation>
        </message>
        <message>
            <source>Computes stem density, basal area, mean diameters, heights and stem volume of a plot, with 95 % intervals, by diameter class too. Heights of stems whose top was not seen come from a height curve (Näslund); volumes come from the stem curves, else from diameter and height. Where too few tops were seen, heights and volumes are left out. Without a plot there are no values per hectare. Values without the stems that are to be checked stand beside those with them.</source>
            <translation>计算样地的株数密度、断面积、平均直径、树高和树干材积及其 95 % 区间,并按径阶给出。树梢未被扫描到的单木,其树高取自树高曲线(Näslund);材积取自干曲线,没有干曲线时由直径和树高计算。扫描到的树梢太少时,不给出树高和材积。没有样地时,不给出每公顷的数值。不含待检查树干的数值与包含它们的数值并列给出。</translation>
        </message>
        <message>
            <source>Reads a point cloud. Its format is recognised by the content of the file, not by its name. Coordinates are given in metres with z up; large ones are kept exactly, as offsets from an origin. Fields of the file become arrays with Bole&apos;s names (intensity, time, ring, return_number, classification, red, ...); other fields keep their names. Points whose coordinates are not numbers are dropped and counted. A file that is cut off gives the points it holds. The stage looks at the cloud and reports its kind, its density at breast height, the common lean of its stems, repeated points, and an axis or a unit that do not fit what stands in it.</source>
            <translation>读取点云。文件格式按内容识别,而不是按文件名。坐标以米为单位,z 向上;大坐标以相对原点的偏移精确保存。文件的字段变为 Bole 命名的数组(intensity、time、ring、return_number、classification、red 等);其他字段保留原名。坐标不是数字的点被剔除并计数。文件不完整时,读取其中已有的点。本阶段还查看点云,并报告其类型、胸高处的点密度、树干的共同倾斜、重复的点,以及与其中树木不相符的坐标轴或单位。</translation>
        </message>
        <message>
            <source>Opens the recording of a spinning LiDAR and gives it frame by frame. Frames are decoded when they are needed, so that long recordings take little memory. Every return keeps its ring and its own time. Packets that are lost, damaged or out of order are counted. A recording that is cut off is read as far as it goes.</source>
            <translation>打开旋转式激光雷达的记录,并逐帧提供数据。各帧在需要时才解码,因此很长的记录也只占用很少内存。每个回波保留其线号和各自的时间。丢失、损坏或乱序的数据包会被计数。记录中断时,读到中断处为止。</translation>
        </message>
        <message>
            <source>Reads a table, for instance reference trees measured in the field. Columns of numbers become numbers, and empty cells are missing values. A line that does not fit the header is an error that names the line.</source>
            <translation>读取表格,例如样地实测的参考树木。数字列变为数值,空单元格为缺失值。与表头不符的行视为错误,错误信息指出该行。</translation>
        </message>
        <message>
            <source>Reads the positions of a GNSS receiver: NMEA 0183 sentences (GGA, RMC, VTG, GST, HDT), also between binary messages; CSV with time_s and latitude_deg, longitude_deg or x_m, y_m; or columns of numbers such as UTM coordinates. Sentences with a wrong or missing checksum or unreadable fields, positions without a fix, gaps and steps back in time are counted and skipped.</source>
            <translation>读取 GNSS 接收机的位置:NMEA 0183 语句(GGA、RMC、VTG、GST、HDT),也可夹在二进制消息之间;含 time_s 以及 latitude_deg、longitude_deg 或 x_m、y_m 的 CSV;或数字列,例如 UTM 坐标。校验和错误或缺失、字段无法读取的语句,未定位的位置,以及时间间断和时间倒退,都会被计数并跳过。</translation>
        </message>
        <message>
            <source>Reads the trajectory of a sensor: TUM and KITTI poses, text with a line that names its columns (GeoSLAM ZEB, HDMapping and MANDEYE, CSV), and SBET. Quaternions are normalised. KITTI poses have no times and get 0, 1, 2, ... A line that cannot be used is an error that names the line.</source>
            <translation>读取传感器的轨迹:TUM 和 KITTI 位姿、带列名行的文本(GeoSLAM ZEB、HDMapping 和 MANDEYE、CSV)以及 SBET。四元数会被归一化。KITTI 位姿没有时间,依次记为 0、1、2 等。无法使用的行视为错误,错误信息指出该行。</translation>
        </message>
        <message>
            <source>Writes what a survey has found into the output folder: stems.csv and the other tables, survey.xlsx, trajectory.tum, plot_values.csv, diameter_classes.csv, height_curve.csv, tree_values.csv, loops.csv, odometry.csv, cloud.las, dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, the stems as solids (OBJ, PLY, VTP), the figures, tally.html to take into the plot, and report.html, one page that holds everything: what was surveyed and whether it may be signed, values of the plot, trees to look at, the stem table with plan, slices and a 3-D view, figures, comparison with a reference, and how it was made with every option and the time and memory of each stage. Inputs that are not connected are left out.</source>
            <translation>将调查结果写入输出文件夹:stems.csv 及其他表格、survey.xlsx、trajectory.tum、plot_values.csv、diameter_classes.csv、height_curve.csv、tree_values.csv、loops.csv、odometry.csv、cloud.las、dem.tif、slope.tif、chm.tif、plot.gpkg、stems.geojson、单木实体模型(OBJ、PLY、VTP)、图件、带到样地填写的 tally.html,以及 report.html:一个包含全部内容的页面,有调查对象、可否签字、样地指标、需要查看的树木、单木表及其平面图、横切面和三维视图、图件、与参考数据的比较,以及处理过程,列出每个步骤的全部参数、耗时和内存。未连接的输入将被省略。</translation>
        </message>
        <message>
            <source>Writes plant rows into the output folder: rows.csv, plants.csv with the missing plants, strays.csv, rows.gpkg with guidance lines, A-B lines, plants and strays, rows.geojson and ab_lines.geojson, the row map as PNG, SVG and PDF, edits.csv where a person changed something, and report.html with the tables and the map.</source>
            <translation>将种植行写入输出文件夹:rows.csv,含缺株的 plants.csv,strays.csv,含引导线、A-B 线、植株和离群植株的 rows.gpkg,rows.geojson 和 ab_lines.geojson,种植行图(PNG、SVG 和 PDF),有人工更改时还有 edits.csv,以及含表格和图的 report.html。</translation>
        </message>
        <message>
            <source>Writes the errors of a steering test by speed, pass and fix, the log, the tuning, and the error curves as PNG, SVG and PDF into the output folder, and report.html, one page with the tables and curves. Inputs that are not connected are left out.</source>
            <translation>将导航试验的误差(按速度、行程和定位点)、日志、参数整定结果和误差曲线(PNG、SVG 和 PDF)写入输出文件夹,并写出 report.html:一个含表格和曲线的页面。未连接的输入将被省略。</translation>
        </message>
        <message>
            <source>Applies the edits of a person: move (the ends), add, delete, split, merge, renumber and note, each with author, time and reason. The inputs do not change. The edits are kept in the pipeline and applied after every run, by place. Rows whose plants changed are measured again. An edit that no longer fits is a conflict: it changes nothing and is listed.</source>
            <translation>应用人工编辑:move(移动两端)、add、delete、split、merge、renumber 和 note,每条编辑都带有作者、时间和原因。输入不会改变。编辑保存在流程中,每次运行后按位置重新应用。植株有变化的行会重新测定。不再适用的编辑为冲突:它不作任何更改,并会列出。</translation>
        </message>
        <message>
            <source>Finds plant rows in a table of stems: any number of rows, straight or curved, with gaps, in several blocks of different direction. Stems that fit no row are strays. Plants are numbered along their row and missing plants are listed. Rows are numbered block by block, from left to right looking along the rows. A column row_id fixes the assignment. The direction of a row is the angle of its least-squares line with due east.</source>
            <translation>在单木表中查找种植行:行数不限,可直可弯,可有缺口,可分为方向不同的多个地块。不属于任何行的单木为离群植株。植株沿行编号,缺株会列出。种植行逐块编号,沿行的方向看从左到右。row_id 列可固定归属。行的方向是其最小二乘直线与正东方向的夹角。</translation>
        </message>
        <message>
            <source>Finds rows whose canopy hides the trunks (vines, fruit walls, hedges) as peaks of the point profile across the rows. The direction is given, or the one with the sharpest profile is taken. Along each row every piece gives a point in the middle of the canopy, and the window follows the row, so the row may bend. rows.from_stems makes rows and guidance lines of the points. The points must be canopy only: remove the ground with rows.region or rows.remove_ground.</source>
            <translation>查找冠层遮住树干的行(葡萄、篱壁式果树、树篱):取横跨各行的点云剖面的峰值。方向由参数给定,或取剖面最清晰的方向。沿每一行,每一段给出冠层中央的一个点,窗口随行移动,因此行可以弯曲。rows.from_stems 由这些点生成种植行和引导线。输入点必须只含冠层:请先用 rows.region 或 rows.remove_ground 去除地面。</translation>
        </message>
        <message>
            <source>Turns a frame by the attitude of the sensor: Rz(yaw) Ry(pitch) Rx(roll). With a table of attitudes every point is turned by the attitude at its own time, otherwise the frame has one attitude.</source>
            <translation>按传感器的姿态旋转一帧:Rz(yaw) Ry(pitch) Rx(roll)。给出姿态表时,每个点按其自身时刻的姿态旋转;否则整帧使用同一姿态。</translation>
        </message>
        <message>
            <source>Mean shift in plan. Points that converge to the same place are one plant. The column plant numbers the plants; 0 is no plant.</source>
            <translation>平面上的均值漂移。收敛到同一处的点属于同一植株。plant 列为植株编号;0 表示不属于任何植株。</translation>
        </message>
        <message>
            <source>Moves plant centres from the axes of the frame to navigation axes, x east and y north, with the position and yaw of the sensor.</source>
            <translation>用传感器的位置和航向角,将植株中心从帧坐标系变换到导航坐标系(x 向东,y 向北)。</translation>
        </message>
        <message>
            <source>Removes points that have too few neighbours within a radius.</source>
            <translation>去除在给定半径内邻点过少的点。</translation>
        </message>
        <message>
            <source>Keeps the points inside a box (pass-through filter).</source>
            <translation>保留长方体内的点(直通滤波)。</translation>
        </message>
        <message>
            <source>Removes the ground with a ray ground filter. In narrow sectors around the sensor, in order of range, a point is ground when it rises less than the local slope above the last ground point and stays within the general slope.</source>
            <translation>用射线地面滤波去除地面。在传感器周围的窄扇区内,按距离由近到远:若一点比上一个地面点的升高不超过局部坡度,且不超出总体坡度,则为地面点。</translation>
        </message>
        <message>
            <source>Cuts every plant into horizontal layers and keeps those that are no wider than a trunk, so that leaves and branches do not move the centre. The mean of the trunk points in plan is the centre of the plant. The sensor sees one side only, so this centre lies too near by most of a radius; centre=face corrects that.</source>
            <translation>将每株植株切成水平层,只保留宽度不超过树干的层,使枝叶不会移动中心。树干点的平面均值即为植株中心。传感器只看到一侧,因此该中心偏近,偏差约为半径的大部分;centre=face 可对此进行改正。</translation>
        </message>
        <message>
            <source>Replaces the points of each voxel by their centroid.</source>
            <translation>用每个体素内各点的重心代替这些点。</translation>
        </message>
        <message>
            <source>Estimates the trajectory of the sensor from the frames, and from the inertial unit where the recording has one, and maps all returns with it. Each frame is de-skewed and registered against a local map of keyframes. Loop closures correct the drift in a pose graph, and a final adjustment fits the whole trajectory to the whole map. A preset sets the options that differ between published systems. With a given trajectory only the map is made.</source>
            <translation>由各帧估计传感器的轨迹,记录中有惯性单元时也用它,并用它将所有回波建成地图。每一帧先校正运动畸变,再与由关键帧组成的局部地图配准。回环在位姿图中改正漂移,最终平差使整条轨迹与整个地图相符。预设决定各公开系统之间不同的参数。给定轨迹时只建图。</translation>
        </message>
        <message>
            <source>Finds the passes of a log along a line and its neighbours. Measures straight-line and adjacent-row errors by pass and by speed. Where the true positions are known, from a reference receiver or a simulation, the error of the receiver is separated from that of the controller.</source>
            <translation>在日志中找出沿一条线及其相邻线的各次行程,按行程和速度测定直线误差和邻行误差。真实位置已知时(来自参考接收机或模拟),将接收机的误差与控制器的误差分开。</translation>
        </message>
        <message>
            <source>Drives a simulated tractor along a line, turns, and drives the neighbouring line back, at several speeds. Simulated are a receiver with noise, drift, jumps and outages, the position-velocity Kalman filter, the preview PID with the published gains, and a bicycle model with lag, limits and slip. The log holds the navigated and the true positions.</source>
            <translation>模拟拖拉机沿一条线行驶、掉头,再沿相邻线驶回,并以多个速度进行。模拟内容包括:带有噪声、漂移、跳变和失锁的接收机,位置-速度卡尔曼滤波,采用已发表增益的预瞄 PID,以及带有滞后、限幅和侧滑的自行车模型。日志包含导航位置和真实位置。</translation>
        </message>
        <message>
            <source>The tuning procedure of the paper by trial: reduce the preview distance to a slight oscillation and add one metre, raise P to a slight oscillation, raise D until it stops, raise I while nothing oscillates.</source>
            <translation>论文中的试验整定方法:减小预瞄距离直至轻微振荡,再加一米;增大 P 直至轻微振荡;增大 D 直至振荡消失;在不振荡的前提下增大 I。</translation>
        </message>
        <message>
            <source>Applies the edits of a person: add, delete, move, resize, set_height, split, merge, accept, reject, note, set_species and tilt, each with author, time and reason. The inputs do not change. The edits are kept in the pipeline and applied again after every run, by place. An edit that no longer fits is a conflict: it changes nothing and is listed. Where a plot is connected, its trees get the ids from 1 on and the others follow.</source>
            <translation>应用人工决定:add、delete、move、resize、set_height、split、merge、accept、reject、note、set_species 和 tilt,每条都带有作者、时间和原因。输入不会改变;编辑保存在流程中,每次运行后按位置重新应用。不再适用的编辑为冲突:它不作任何更改,并会列出。连接样地时,样地内的树从 1 开始编号,其余的排在后面。</translation>
        </message>
        <message>
            <source>Finds stems between ground and crowns and measures their diameter at breast height with a 95 % interval. Circles are searched at several heights by a randomised search and linked into axes; a tapered cylinder is fitted jointly to the sections around breast height with Tukey weights of capped scale, with offsets per pass and view whose spread is estimated over all stems. Where sensor positions are known, the error along the ray is fitted, with a beam of finite width and a range offset that all stems share, else the distance from the surface (model); candidates that rays pass through are rejected. Passes of the walk that disagree by a centimetre or more are first brought together by the stems, and a walk that SLAM made too short or too long is made to fit the ranges: points and stems lie where they would if it had its length. Every point gets the id of its tree.</source>
            <translation>在地面与树冠之间查找单木,并测定其胸径及 95 % 区间。在多个高度上用随机搜索查找圆,并连接成树干轴线;再对胸高附近的各断面联合拟合一个带削度的圆柱,采用尺度有上限的 Tukey 权,并为每趟、每个视角设偏移,其离散程度由全部单木估计。传感器位置已知时,拟合沿射线的误差,顾及光束宽度和所有单木共有的测距偏移;否则拟合到树干表面的距离(model);被射线穿过的候选会被拒绝。行走各趟之间相差一厘米或更多时,先借助单木将其对齐;SLAM 得出的行走路径过短或过长时,按测距校正:点与单木位于路径长度正确时应在的位置。每个点都得到所属树木的编号。</translation>
        </message>
        <message>
            <source>Cuts the layer of points around breast height, by height above ground, for the stem measurement and for pictures of the sections.</source>
            <translation>按离地高度截取胸高附近的点层,用于单木测定和断面图。</translation>
        </message>
        <message>
            <source>Moves a map into the axes of the plot: x east, y north, z up, origin on the ground below the centre target. The vertical comes from the stems (or the ground), origin and heading from two retro-reflective targets that are found by their strong returns: small, dense, seen from positions far apart. The target nearest to the start of the walk is the centre. Without targets the map is levelled and otherwise left as it is.</source>
            <translation>将地图变换到样地坐标系:x 向东,y 向北,z 向上,原点位于中心标靶下方的地面。铅垂方向由单木(或地面)确定,原点和方位由两个反光标靶确定;标靶按强回波查找:小而密,并从相距较远的位置都能看到。离行走起点最近的标靶为中心。没有标靶时,只将地图调平,其余不变。</translation>
        </message>
        <message>
            <source>Sets the boundary of the plot and the minimum diameter for all stages that count trees. A tree counts when its centre at breast height lies inside (the boundary counts as inside) and its diameter reaches min_dbh. Areas are horizontal. Options that contradict one another are refused. A plot of which more than a tenth holds no points is reported.</source>
            <translation>为所有统计树木的步骤设定样地边界和起测胸径。树木在胸高处的中心位于边界内(边界上也算在内),且胸径达到 min_dbh 时,才计入。面积为水平面积。相互矛盾的选项会被拒绝。样地中超过十分之一的面积没有点时会给出提示。</translation>
        </message>
        <message>
            <source>Joins a cloud that another program mapped with the path of its sensor: every point gets the place of the sensor at its time, its range and its pass, so that stems are measured along the rays. The clocks of the two are recognised (GPS time, GPS time less 1e9 s, seconds of the GPS week, Unix time), and the offset is reported. Clocks that do not go together for certain, and a path that does not run through the cloud, are refused. Without a trajectory the points stay as they are.</source>
            <translation>把其他程序生成的点云与传感器的路径连接起来:每个点得到其时刻的传感器位置、距离和所属的趟次,从而可沿射线测量单木。自动识别两者的时钟(GPS 时间、减去 1e9 秒的 GPS 时间、GPS 周内秒、Unix 时间),并报告时间差。时钟不能确定对应、或路径不穿过点云时会被拒绝。没有轨迹时点云保持不变。</translation>
        </message>
        <message>
            <source>Opens the pictures of a colour camera or an RGB-D camera. Images are decoded when they are needed, so that long sequences take little memory. The layout of the folder is found by the names of its files. Images that are missing, damaged or of another size than their camera are left out and counted. Depth becomes metres; pixels without depth are 0. Poses, the camera and the printed mat are read where the folder has them.</source>
            <translation>打开彩色相机或 RGB-D 相机的图像。图像在需要时才解码,因此长序列占用内存很少。文件夹的格式由其中的文件名判断。缺失、损坏或尺寸与相机不符的图像会被舍去并计数。深度换算为米;没有深度的像素为 0。文件夹中有位姿、相机和印刷垫板时一并读取。</translation>
        </message>
        <message>
            <source>Fits focal lengths, principal point and distortion to pictures of a chessboard or a ChArUco board (Zhang's method). Views that do not fit the others are left out. Depth images of the same views give the place of the depth camera and the bias of its depth, by the planes of the board; pictures of the depth camera (infrared) give its intrinsics too. Writes camera.json, which io.read_views takes, and residuals.svg.</source>
            <translation>用棋盘格或 ChArUco 板的图片拟合焦距、主点和畸变(张氏标定法)。与其余视图不符的视图会被舍去。同一视图的深度图像借助标定板平面给出深度相机的位置和深度偏差;深度相机的图片(红外)还可给出其内参。写出 camera.json(供 io.read_views 使用)和 residuals.svg。</translation>
        </message>
            <message>
            <source>Finds the pose of the camera for every view. Features are matched with neighbouring views and around loops, and screened by ratio, by their neighbours' motion and by depth. Bundle adjustment fits poses and points to pixels, depths and the corners of a ChArUco board, which gives axes and scale. Without a board the axes are those of the first view and the scale is that of the depth. Views that cannot be connected are reported as lost.</source>
            <translation>求出每个视图的相机位姿。特征与相邻视图以及绕行回环上的视图匹配,并按比值、邻近匹配的运动和深度筛选。光束法平差使位姿和点符合像素、深度以及给出坐标轴和尺度的 ChArUco 标定板角点。没有标定板时,坐标轴取第一个视图,尺度取自深度。无法连接的视图会作为丢失报告。</translation>
        </message>
        <message>
            <source>Fuses the depth images of all views into truncated signed distances on small voxels, and gives the surface as coloured points with normals, and as a mesh where asked. The region is found from the views. This is the start of plant.field, and the baseline to compare it with.</source>
            <translation>将所有视图的深度图融合为小体素上的截断有符号距离，给出带法向的彩色表面点，需要时生成网格。区域由视图确定。这是 plant.field 的起点，也是与之比较的基准。</translation>
        </message>
        <message>
            <source>Learns density and colour of the plant from the colour and depth of all views by volume rendering, tests the field on views that were kept back, and makes a fine coloured cloud of it: points where half of the light of a ray is stopped, kept where several views agree. Finishing early keeps the best field so far.</source>
            <translation>通过体渲染，从所有视图的颜色和深度学习植株的密度和颜色，用保留的视图检验辐射场，并由它生成精细的彩色点云：光线的一半被阻挡之处，且多个视图一致的点。提前结束时保留目前最好的辐射场。</translation>
        </message>
        <message>
            <source>Renders a trained field from a pose: one of the poses connected, or that of the first view. Gives colours (0 to 1) and depth as rasters whose rows run upwards.</source>
            <translation>从一个位姿渲染训练好的辐射场：所连接的位姿之一，或第一个视图的位姿。给出颜色（0 到 1）和深度栅格，其行自下而上。</translation>
        </message>
        <message>
            <source>Finds the depth of each view from its colour and that of its neighbours by PatchMatch stereo, and keeps the points on which several views agree. This is the baseline without a depth camera and without a field.</source>
            <translation>用 PatchMatch 立体匹配，由每个视图及其相邻视图的颜色求深度，保留多个视图一致的点。这是没有深度相机、也没有辐射场时的基准。</translation>
        </message>
        <message>
            <source>Divides the cloud of a potted plant into plant, pot, soil, mat and floaters. The table is the lowest level surface, the pot a body of revolution on it, the soil the surface inside of its rim; the plant is what grows out of the soil, with the parts that a gap separates from it.</source>
            <translation>把盆栽植株的点云分为植株、花盆、土壤、标定垫和漂浮点。桌面是最低的水平面，花盆是其上的回转体，土壤是盆沿以内的表面；植株是从土壤中长出的部分，包括被间隙隔开的部分。</translation>
        </message>
        <message>
            <source>Measures height, breadth and stem of a separated plant, each with a 95 % interval. Height is the highest point above the soil at the stem, breadth the rectangle of least area around the plant in plan; both are corrected for the noise of the points. The diameter of the stem comes from its edges in the pictures: a tapered, bowed cylinder is fitted to them, with the point spread of each picture. Leaves, internodes, branches and the whole main stem are followed in the points from the foot upwards; leaves that touch or are hidden are marked for a check.</source>
            <translation>测量已分离植株的高度、冠幅和茎，各带 95 % 区间。高度是最高点到茎处土壤的距离，冠幅是俯视图中包围植株的最小面积矩形；两者均按点的噪声校正。茎直径由图像中的茎边缘得到：考虑每幅图像的点扩散，拟合一个渐细、弯曲的圆柱。叶片、节间、分枝和整条主茎从茎基部起在点云中向上追踪；相互接触或被遮挡的叶片标记为待检查。</translation>
        </message>
        <message>
            <source>Applies the edits of a person to a measured plant: set_base, set_stem_height, assign (points near a place, in a box or behind an outline become another part, for instance a leaf that is cut off), set_value, accept, reject and note. The plant is measured anew where its points, its base or the height of measurement changed. The inputs do not change; an edit that no longer fits is a conflict, which changes nothing and is listed.</source>
            <translation>把人对已测植株的编辑加以应用：set_base、set_stem_height、assign（某处附近、框内或轮廓线后的点归为另一部分，例如剪去的叶片）、set_value、accept、reject 和 note。点、茎基或测量高度改变时重新测量植株。输入不变；不再适用的编辑是冲突，不作任何改变，并列出。</translation>
        </message>
        <message>
            <source>Writes what was measured of a seedling into the output folder: traits.csv and the other tables, plant.xlsx, trajectory.tum (camera to world), cloud.ply (the plant), scene.ply (all points with their parts), field.json (how well the field shows views that were held out), figures, and report.html. Inputs that are not connected are left out.</source>
            <translation>将幼苗的测量结果写入输出文件夹:traits.csv 及其他表格、plant.xlsx、trajectory.tum(相机到世界)、cloud.ply(植株)、scene.ply(全部点及其部位)、field.json(辐射场对留出视图的再现程度)、插图和 report.html。未连接的输入会被略去。</translation>
        </message>
        <message>
            <source>Gives the plot its place on the earth: from control points with projected or geodetic coordinates, or from the coordinates of the centre and a bearing, or from the track of a GNSS receiver that was carried on the walk (the offset of the clocks and the lever arm are estimated). Turn and shift are adjusted by least squares, the level by control heights; residuals, standard errors and a test for blunders are reported. Stems and targets get easting and northing, stems also the standard error of their position. Reports write their files in the coordinate system. Points that do not carry a place (too few, exchanged axes, other zones, distances that do not fit) are refused. Without control points and centre everything stays as it is.</source>
            <translation>确定样地在地球上的位置:由具有投影或大地坐标的控制点,或由中心坐标和方位角,或由行走时携带的 GNSS 接收机轨迹(同时求定时钟差和天线偏移)。旋转和平移按最小二乘平差,水平按控制高程整平;报告残差、标准差和粗差检验。单木和标靶得到东、北坐标,单木还得到点位标准差。报告按该坐标系写出文件。不能确定位置的控制点(点数不足、坐标轴互换、不同分带、距离不符)会被拒绝。没有控制点和中心坐标时,一切保持不变。</translation>
        </message>
        <message>
            <source>Writes what a survey has found into the output folder: stems.csv and the other tables, survey.xlsx, trajectory.tum, plot_values.csv, diameter_classes.csv, height_curve.csv, tree_values.csv, loops.csv, odometry.csv, cloud.las, dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, check.json and check.html with the check of the map, the stems as solids (OBJ, PLY, VTP), the figures, tally.html to take into the plot, and report.html, one page that holds everything: what was surveyed and whether it may be signed, values of the plot, trees to look at, the stem table with plan, slices and a 3-D view, figures, comparison with a reference, and how it was made with every option and the time and memory of each stage. Inputs that are not connected are left out.</source>
            <translation>将调查结果写入输出文件夹:stems.csv 及其他表格、survey.xlsx、trajectory.tum、plot_values.csv、diameter_classes.csv、height_curve.csv、tree_values.csv、loops.csv、odometry.csv、cloud.las、dem.tif、slope.tif、chm.tif、plot.gpkg,check.json 与 check.html(地图检查)、stems.geojson、单木实体模型(OBJ、PLY、VTP)、图件、带到样地填写的 tally.html,以及 report.html:一个包含全部内容的页面,有调查对象、可否签字、样地指标、需要查看的树木、单木表及其平面图、横切面和三维视图、图件、与参考数据的比较,以及处理过程,列出每个步骤的全部参数、耗时和内存。未连接的输入将被省略。</translation>
        </message>
        <message>
            <source>Checks a surveyed plot before somebody signs it: ground never seen, density and directions of view in every cell, places that were not walked, surfaces of different passes, scatter about the bark, loop closures against the final trajectory, common lean of the stems, targets, trees on the boundary, stems in each other, stems without ground or points, heights without tops, and upright structures without a stem. The verdict is sign, look or walk again, with the reasons and where to go. What an input is missing for is listed as not judged.</source>
            <translation>在签字之前检查整块样地:从未看到的地面,每个单元的点密度与观测方向,没有走到的地方,各次经过的表面是否重合,点相对树皮的离散,回环与最终轨迹是否一致,单木的共同倾斜,靶标,边界木,相互重叠的单木,没有地面或没有点的单木,没有看到树梢的树高,以及没有对应单木的直立结构。结论为签字,查看或重走,并给出理由和应去的地点。因缺少输入而无法判断的内容列为未判断。</translation>
        </message>
        <message>
            <source>Brings two surveys of one plot together by the places and diameters of their stems, whatever the axes of the two, and tells what became of every tree: growth of its diameter with a 95 % interval, ingrowth, trees that are gone, and trees that one of the two missed, told apart by where they stand, how thick they are, whether their neighbours were found again and what the other survey rejected there. Maps that do not go together, or in more than one way, are refused.</source>
            <translation>根据单木的位置和胸径把同一样地的两次调查合到一起,不论两者采用什么坐标系,并说明每株树的变化:胸径生长量及其 95 % 区间,进界木,消失的树,以及某一次调查漏掉的树。区分的依据是树的位置,粗细,邻近的树是否再次找到,以及另一次调查在该处剔除了什么。不能合到一起或有多种合法的地图会被拒绝。</translation>
        </message>
        <message>
            <source>Writes the comparison of two surveys of one plot into the output folder: growth.csv with every tree, growth_values.csv with the values of the stand, the map of what grew, came and went and the growth over the diameter as PNG, SVG and PDF, and report.html with all of it.</source>
            <translation>把同一样地两次调查的比较写入输出文件夹:growth.csv(每株树),growth_values.csv(林分数值),变化分布图和生长量图(PNG,SVG,PDF),以及包含全部内容的 report.html。</translation>
        </message>
        <message>
            <source>Writes what a survey has found into the output folder: stems.csv and the other tables, plot.csv with the boundary, reference_trees.csv and reference_trajectory.tum that it was compared with, survey.xlsx, trajectory.tum, plot_values.csv, diameter_classes.csv, height_curve.csv, tree_values.csv, loops.csv, odometry.csv, cloud.las, dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, the stems as solids (OBJ, PLY, VTP), the figures, tally.html to take into the plot, and report.html, one page that holds everything: what was surveyed and whether it may be signed, values of the plot, trees to look at, the stem table with plan, slices and a 3-D view, figures, comparison with a reference, and how it was made with every option and the time and memory of each stage. Inputs that are not connected are left out.</source>
            <translation>将调查结果写入输出文件夹:stems.csv 及其他表格、plot.csv(样地边界)、reference_trees.csv 和 reference_trajectory.tum(所用的参考数据)、survey.xlsx、trajectory.tum、plot_values.csv、diameter_classes.csv、height_curve.csv、tree_values.csv、loops.csv、odometry.csv、cloud.las、dem.tif、slope.tif、chm.tif、plot.gpkg、stems.geojson、单木实体模型(OBJ、PLY、VTP)、图件、带到样地填写的 tally.html,以及 report.html:一个包含全部内容的页面,有调查对象、可否签字、样地指标、需要查看的树木、单木表及其平面图、横切面和三维视图、图件、与参考数据的比较,以及处理过程,列出每个步骤的全部参数、耗时和内存。未连接的输入将被省略。</translation>
        </message>
        <message>
            <source>Evaluate rows</source>
            <translation>评价种植行</translation>
        </message>
        <message>
            <source>Compares plant rows with reference rows. Plants that stand within match_distance of one another are the same; a row is right when 90 % of its plants are those of one reference row. Gives the error of each row's direction against the least-squares line through its reference plants, and the share of rows, plants and gaps found.</source>
            <translation>将种植行与参考行比较。相距不超过 match_distance 的植株视为同一株；一行中 90 % 的植株属于同一参考行时，该行为正确。给出每行方向相对于参考植株最小二乘直线的误差，以及找到的行、植株和缺株的比例。</translation>
        </message>
        <message>
            <source>Reads the output folders of bole run or bole survey, to compare them: stem tables, trajectories, boundaries, the reference that each was compared with, and how each was made (preset, options, scan). A folder needs stems.csv; what else is missing or damaged is reported.</source>
            <translation>读取 bole run 或 bole survey 的输出文件夹以便比较：单木表、轨迹、样地边界、各自所用的参考数据，以及生成方式（预设、选项、扫描）。文件夹中必须有 stems.csv；其他缺失或损坏的内容会予以说明。</translation>
        </message>
        <message>
            <source>Compares two or more runs with a reference and with each other. Stems are matched as by evaluation.plot. Gives for each run, and for the runs of one system together, found, missed and extra trees, mean and covariance of the position error, RMSE in x and y, BIAS, relBIAS, RMSE and relRMSE of the diameters, and ATE and RPE of the trajectory; for each two runs of a plot their differences. Runs whose stems agree share a plot. Lists that do not agree (other axes, other units, another plot) are reported and never pooled. Without a reference the runs are compared with each other only.</source>
            <translation>将两次或多次运行与参考数据比较，并相互比较。单木按 evaluation.plot 的方法匹配。对每次运行以及同一系统的全部运行，给出找到、漏测和多余的树木，位置误差的均值和协方差，x、y 方向的 RMSE，胸径的 BIAS、relBIAS、RMSE 和 relRMSE，以及轨迹的 ATE 和 RPE；并给出同一样地每两次运行之间的差异。单木一致的运行视为同一样地。不一致的列表（坐标系、单位或样地不同）会予以说明，且不合并统计。没有参考数据时，各次运行只相互比较。</translation>
        </message>
        <message>
            <source>Writes a comparison of runs into the output folder: runs.csv, positions.csv and diameters.csv (tables 2 and 3 of the paper on improved LOAM, with its published figures beside), detection.csv, trajectories.csv, pairs.csv, compared_trees.csv, comparison.json, report.html, and the figures: paths on the cloud, slices side by side, path and map with their loop closures, map of positions, position errors, diameters and their errors by class, pooled and for each plot.</source>
            <translation>将运行的比较写入输出文件夹：runs.csv、positions.csv 和 diameters.csv（改进 LOAM 论文的表 2 和表 3，旁列论文数值）、detection.csv、trajectories.csv、pairs.csv、compared_trees.csv、comparison.json、report.html，以及插图：点云上的轨迹、并列的横切面、带回环的轨迹与地图、位置图、位置误差、胸径及各径阶的胸径误差，既有合并的，也有逐个样地的。</translation>
        </message>
        <message>
            <source>Converts latitude and longitude of a table to metres of a plane or back: Gauss-Krueger zones of 3 and 6 degrees, UTM, or any transverse Mercator plane, with the exact projection. The definition of the plane stays with the table, so exports contain it. A table that has metres and no degrees stays as it is.</source>
            <translation>将表中的经纬度转换为平面坐标（米）或反之：3 度和 6 度高斯-克吕格带、UTM 或任意横轴墨卡托平面，使用精确投影。平面的定义随表保存，因此导出文件中也包含它。只有米制坐标而没有经纬度的表保持不变。</translation>
        </message>
        <message>
            <source>Lays many circular sample plots of several sizes at random into a stand whose trees are all known, and compares what they say with the truth: bias and scatter of stems and basal area per hectare. Four ways to treat the edge of the stand stand side by side: ignored, plots that fit in only, the area inside, and mirrored plots (mirage).</source>
            <translation>在所有树木已知的林分中随机布设多种大小的圆形样地，并将其结果与真值比较：每公顷株数和断面积的偏差与离散程度。林分边缘的四种处理方法并列给出：忽略、仅布设完整样地、按林内面积、镜像样地（mirage）。</translation>
        </message>
        <message>
            <source>Writes plant rows into the output folder: rows.csv, plants.csv with the missing plants, strays.csv, rows.gpkg with guidance lines, A-B lines, plants and strays, rows.geojson and ab_lines.geojson, the row map as PNG, SVG and PDF, edits.csv where a person changed something, sensor_pose.csv and sensor_marks.csv where the sensor was resected, row_matches.csv where the rows were evaluated, and report.html with the tables and figures. With the steps of a frame it draws them on one sheet, with reference plants the rows beside and over theirs.</source>
            <translation>将植株行写入输出文件夹：rows.csv、含缺株的 plants.csv、strays.csv、含导航线、A-B 线、植株和行外植株的 rows.gpkg、rows.geojson 和 ab_lines.geojson、行图（PNG、SVG 和 PDF）、有人修改时的 edits.csv、对传感器作后方交会时的 sensor_pose.csv 和 sensor_marks.csv、评价种植行时的 row_matches.csv，以及含表和图的 report.html。有单帧各步骤的结果时，将其绘在一张图上；有参考植株时，将种植行与参考行并列和叠加绘出。</translation>
        </message>
        <message>
            <source>Writes what sample plots say about a known stand: tables by size and treatment of the edge, a row per plot, curves of bias and scatter, and report.html.</source>
            <translation>输出样地在已知林分中的结果：按大小和边缘处理方法汇总的表、每个样地一行的表、偏差和离散程度曲线，以及 report.html。</translation>
        </message>
        <message>
            <source>Writes the errors of a steering test by speed, pass and fix, the log, the tuning, guidance lines (also as GeoJSON), and the error curves as PNG, SVG and PDF into the output folder, and report.html, one page with the tables and curves. Errors stand beside those that the paper published. Inputs that are not connected are left out.</source>
            <translation>将导航试验的误差（按速度、行程和定位点）、日志、整定结果、导航线（另存为 GeoJSON）以及误差曲线（PNG、SVG 和 PDF）写入输出文件夹，并生成 report.html，一页包含所有表和曲线。误差与论文发表的误差并列。未连接的输入略去。</translation>
        </message>
        <message>
            <source>Moves plant centres from the axes of the frame to navigation axes, x east and y north, with the position and yaw of the sensor: by hand, or from rows.resect, whose standard error of the heading then counts in the directions of rows.</source>
            <translation>将植株中心从帧坐标轴移到导航坐标轴（x 向东，y 向北），使用传感器的位置和航向：手动给出，或来自 rows.resect；后者的航向标准误差计入各行的方向。</translation>
        </message>
        <message>
            <source>Finds position and heading of the sensor from marks of known position that the frame shows, with covariance and residuals. Give the places where an antenna stood (E, F, G) and where the levelled frame shows it. Marks that were mixed up, swapped axes and weak geometry are refused with the reason.</source>
            <translation>由帧中可见的已知位置标志求传感器的位置和航向，并给出协方差和残差。请给出天线所在的各点（E、F、G）以及它在调平后的帧中的位置。标志弄混、坐标轴互换和几何条件过弱时会说明原因并拒绝。</translation>
        </message>
        <message>
            <source>Brings recorded fixes from the antenna to the control point (lever arm and attitude) and filters them with the position-velocity Kalman filter that also steers the simulated tractor. The noise of each fix is that of the receiver or of its fix quality. Poor fixes, gaps, jumps and times that run back are counted and reported.</source>
            <translation>将记录的定位点从天线归算到控制点（杆臂和姿态），并用与模拟拖拉机相同的位置-速度卡尔曼滤波器滤波。每个定位点的噪声取自接收机或其定位质量。质量差的点、间断、跳变和倒退的时间都会计数并报告。</translation>
        </message>
        <message>
            <source>Lays parallel guidance lines through a field from A, B and the width of the implement, and headlands at their ends. With a boundary the lines fill the field and the headland runs along it.</source>
            <translation>由 A、B 两点和机具宽度在田块中布设平行导航线，并在其两端布设地头。给出边界时，导航线布满田块，地头沿边界分布。</translation>
        </message>
        <message>
            <source>Writes what a survey has found into the output folder: stems.csv and the other tables, plot.csv with the boundary, reference_trees.csv and reference_trajectory.tum that it was compared with, survey.xlsx, trajectory.tum, plot_values.csv, diameter_classes.csv, height_curve.csv, tree_values.csv, loops.csv, odometry.csv, loop_candidates.csv, pose_graph.csv, cloud.laz, dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, trajectory_global.csv and stems_global.vtp where the plot was georeferenced, check.json and check.html with the check of the map, the stems as solids (OBJ, PLY, VTP), the figures, tally.html to take into the plot, and report.html, one page that holds everything: what was surveyed and whether it may be signed, values of the plot, trees to look at, the stem table with plan, slices and a 3-D view, figures, comparison with a reference, and how it was made with every option and the time and memory of each stage. Inputs that are not connected are left out.</source>
            <translation>将调查结果写入输出文件夹:stems.csv 及其他表格、plot.csv(样地边界)、reference_trees.csv 和 reference_trajectory.tum(所用的参考数据)、survey.xlsx、trajectory.tum、plot_values.csv、diameter_classes.csv、height_curve.csv、tree_values.csv、loops.csv、odometry.csv、loop_candidates.csv、pose_graph.csv、cloud.laz、dem.tif、slope.tif、chm.tif、plot.gpkg、stems.geojson、样地已定位时的 trajectory_global.csv 和 stems_global.vtp、check.json 与 check.html(地图检查)、单木实体模型(OBJ、PLY、VTP)、图件、带到样地填写的 tally.html,以及 report.html:一个包含全部内容的页面,有调查对象、可否签字、样地指标、需要查看的树木、单木表及其平面图、横切面和三维视图、图件、与参考数据的比较,以及处理过程,列出每个步骤的全部参数、耗时和内存。未连接的输入将被省略。</translation>
        </message>
        <message>
            <source>Applies what a person decided about loop closures: accept one that was refused, or strike one out, by the frames of the scan, each with author, time and reason. The pose graph is solved again with the odometry as it was, and trajectory and map move with it: no frame is read again. The final adjustment is carried along, not repeated. A loop accepted by hand is held whatever the others say. The edits are kept in the pipeline and applied after every run. An edit that no longer fits is a conflict: it changes nothing and is listed. Without edits everything passes through unchanged.</source>
            <translation>应用人员对回环的决定:接受被拒绝的回环,或剔除错误的回环;以扫描的帧指明,每项带作者、时间和理由。里程计保持不变,重新求解位姿图,轨迹和地图随之移动,不再读取任何帧。最终平差随之移动,不重新计算。人工接受的回环始终保留,不论其他回环如何。编辑保存在处理流程中,每次运行后都会应用。不再适用的编辑视为冲突:不作任何改变,并列出。没有编辑时一切原样通过。</translation>
        </message>
        <message>
            <source>Separates ground from vegetation, makes a terrain model (DEM) and gives every point its height above it. The lowest groups of points of small cells are taken into a triangulation step by step; then a robust plane is fitted to the band of ground points around each cell, so that the model runs through the middle of the band and not along its lower edge or the top of the grass. Cells without ground points are interpolated and marked in dem_filled; further than fill_distance from any ground point the model has no value and points there have no height (NaN). Where a terrain is connected, heights are counted from that.</source>
            <translation>将地面与植被分离,生成地形模型(DEM),并给出每个点的离地高度。小单元中最低的点组逐步加入三角网;随后在每个单元周围的地面点带中稳健拟合平面,使模型穿过点带中部,而不是沿其下缘或草顶。没有地面点的单元经插值得到,并在 dem_filled 中标记;离任何地面点超过 fill_distance 处模型没有值,那里的点没有高度(NaN)。连接了地形时,高度从该地形算起。</translation>
        </message>
        <message>
            <source>Cuts a cloud of any size into overlapping files, one for each tile, and writes them with a list, tiles.csv, into the output folder. Points keep all their fields and their order. Each file says where the whole cloud begins and how dense it is, so that terrain and stems of a tile are searched in the same cells as in the whole.</source>
            <translation>将任意大小的点云切成相互重叠的文件,每个分块一个,并连同清单 tiles.csv 写入输出文件夹。点保留全部字段和顺序。每个文件记录整个点云从何处开始、有多密,使分块中的地形和树干在与整体相同的单元中查找。</translation>
        </message>
        <message>
            <source>Reads a raster, for instance a terrain model that was made before. Cells without a value are missing values.</source>
            <translation>读取栅格,例如先前生成的地形模型。没有值的单元为缺失值。</translation>
        </message>
        <message>
            <source>Writes the results of one tile of a cloud as files that fit those of the tiles beside it: tables of all stems that were measured, also in the buffer, terrain and points of the core alone.</source>
            <translation>将点云一个分块的结果写成与相邻分块相接的文件:所有测得树干的表(包括缓冲区内的),以及仅限核心区的地形和点。</translation>
        </message>
        <message>
            <source>The first look of stems.measure, with the same options: finds stems and gives for each what it says about the errors that all stems share (spread of passes and views, range offset, length of the walk, noise of the ranges, blur of the map). Run it on parts of a cloud, and pool the rows of all parts with stems.pool_priors.</source>
            <translation>stems.measure 的第一步,选项相同:查找树干,并给出每株对所有树干共有误差(各趟与各视角的离散、测距偏移、行走路径长度、测距噪声、地图模糊)的信息。对点云的各部分运行,再用 stems.pool_priors 汇总各部分的行。</translation>
        </message>
        <message>
            <source>Puts together what stems say in several parts of a cloud: the mean spread of passes and views that their evidence allows, the mean range offset, how much the walk is too short, the middle noise and the middle blur. stems.measure takes the row in place of what it would learn from its own stems.</source>
            <translation>汇总点云若干部分中树干给出的信息:证据所允许的各趟与各视角离散均值、平均测距偏移、行走路径偏短的比例、噪声中位数和地图模糊中位数。stems.measure 用这一行代替从自身树干学到的值。</translation>
        </message>
        <message>
            <source>Gives the points of a part of a cloud the tree ids of the whole: the table says which number each tree of the part gets. Points of trees that it does not list belong to no tree.</source>
            <translation>给点云一部分的点赋予整体的树号:表中说明该部分每株树得到的编号。未列出的树的点不属于任何树。</translation>
        </message>
        <message>
            <source>Draws a flight of the camera through a survey, along the walk or through bookmarked views, as frames flythrough/frame_00001.png and so on, and as flythrough.mp4 where ffmpeg is installed. The same inputs give the same frames.</source>
            <translation>绘制相机穿行调查成果的过程:沿行走路径或经过书签视图,写出各帧 flythrough/frame_00001.png 等;装有 ffmpeg 时还写出 flythrough.mp4。相同的输入得到相同的画面。</translation>
        </message>
</context>
</TS>
