<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
    <context>
        <name>bole::desktop::FieldListDialog</name>
        <message numerus="yes">
            <source>%n tree(s) in the list. Which column is what?</source>
            <translation>
                <numerusform>%n tree in the list. Which column is what?</numerusform>
                <numerusform>%n trees in the list. Which column is what?</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::FlythroughDialog</name>
        <message numerus="yes">
            <source>%n frame(s) as PNG files</source>
            <translation>
                <numerusform>%n frame as a PNG file</numerusform>
                <numerusform>%n frames as PNG files</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::NextStep</name>
        <message numerus="yes">
            <source>%n stem(s)</source>
            <translation>
                <numerusform>%n stem</numerusform>
                <numerusform>%n stems</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n doubtful</source>
            <translation>
                <numerusform>%n doubtful</numerusform>
                <numerusform>%n doubtful</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n decided</source>
            <translation>
                <numerusform>%n decided</numerusform>
                <numerusform>%n decided</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::PlantForm</name>
        <message numerus="yes">
            <source>%n edit(s)</source>
            <translation>
                <numerusform>%n edit</numerusform>
                <numerusform>%n edits</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n no longer fit</source>
            <translation>
                <numerusform>%n no longer fits</numerusform>
                <numerusform>%n no longer fit</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StemReview</name>
        <message numerus="yes">
            <source>%n stem(s) not decided yet</source>
            <translation>
                <numerusform>%n stem not decided yet</numerusform>
                <numerusform>%n stems not decided yet</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::WalkPanel</name>
        <message numerus="yes">
            <source>%n loop(s), %1 refused</source>
            <translation>
                <numerusform>%n loop, %1 refused</numerusform>
                <numerusform>%n loops, %1 refused</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StageGraph</name>
        <message numerus="yes">
            <source>%n array(s)</source>
            <translation>
                <numerusform>%n array</numerusform>
                <numerusform>%n arrays</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>adds %n array(s)</source>
            <translation>
                <numerusform>adds %n array</numerusform>
                <numerusform>adds %n arrays</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>bole::desktop::StageStates</name>
        <message numerus="yes">
            <source>%n warning(s)</source>
            <translation>
                <numerusform>%n warning</numerusform>
                <numerusform>%n warnings</numerusform>
            </translation>
        </message>
    </context>
</TS>
