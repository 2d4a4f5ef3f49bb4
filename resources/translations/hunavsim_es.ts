<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Behaviour</name>
    <message>
        <source>Regular</source>
        <translation>Regular</translation>
    </message>
    <message>
        <source>Impassive</source>
        <translation>Impasible</translation>
    </message>
    <message>
        <source>Surprised</source>
        <translation>Sorprendido</translation>
    </message>
    <message>
        <source>Scared</source>
        <translation>Asustado</translation>
    </message>
    <message>
        <source>Curious</source>
        <translation>Curioso</translation>
    </message>
    <message>
        <source>Threatening</source>
        <translation>Amenazante</translation>
    </message>
    <message>
        <source>Custom tree</source>
        <translation>Árbol propio</translation>
    </message>
</context>
<context>
    <name>Breakpoint</name>
    <message>
        <source>starts to be ticked</source>
        <translation>empieza a recibir ticks</translation>
    </message>
    <message>
        <source>starts to run</source>
        <translation>empieza a ejecutarse</translation>
    </message>
    <message>
        <source>starts to succeed</source>
        <translation>empieza a tener éxito</translation>
    </message>
    <message>
        <source>starts to fail</source>
        <translation>empieza a fallar</translation>
    </message>
    <message>
        <source>starts to be skipped</source>
        <translation>empieza a omitirse</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Yaml base name</source>
        <translation>Nombre base YAML</translation>
    </message>
    <message>
        <source>Base name of the file; part of the names of tree files</source>
        <translation>Nombre base del archivo; parte de los nombres de los archivos de árbol</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulador</translation>
    </message>
    <message>
        <source>Simulator in which HuNavSim runs the file</source>
        <translation>Simulador en el que HuNavSim ejecuta el archivo</translation>
    </message>
    <message>
        <source>Map name</source>
        <translation>Nombre del mapa</translation>
    </message>
    <message>
        <source>Name of the map, without folder and extension</source>
        <translation>Nombre del mapa, sin carpeta ni extensión</translation>
    </message>
    <message>
        <source>ROS topics</source>
        <translation>Topics de ROS</translation>
    </message>
    <message>
        <source>Publish people on ROS topics</source>
        <translation>Publicar las personas en topics de ROS</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Id of the person; part of the name of the tree file</source>
        <translation>Id de la persona; parte del nombre del archivo de árbol</translation>
    </message>
    <message>
        <source>Walks with</source>
        <translation>Camina con</translation>
    </message>
    <message>
        <source>Group number; people of one group stay together; -1: no group</source>
        <translation>Número de grupo; las personas de un grupo permanecen juntas; -1: sin grupo</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figura</translation>
    </message>
    <message>
        <source>Appearance of the person in the simulator</source>
        <translation>Aspecto de la persona en el simulador</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Vel. máxima</translation>
    </message>
    <message>
        <source>Desired walking speed</source>
        <translation>Velocidad de marcha deseada</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Radius of the circular body; with the model das it is 0.20 m, except for wheelchairs</source>
        <translation>Radio del cuerpo circular; con el modelo das es 0.20 m, excepto en sillas de ruedas</translation>
    </message>
    <message>
        <source>Arrival radius</source>
        <translation>Radio de llegada</translation>
    </message>
    <message>
        <source>Distance within which a goal is reached; 0 counts as 0.1</source>
        <translation>Distancia a la que se alcanza un objetivo; 0 cuenta como 0.1</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Restart the route after the last goal</source>
        <translation>Reiniciar la ruta tras el último objetivo</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Conducta</translation>
    </message>
    <message>
        <source>How the person reacts to the robot</source>
        <translation>Cómo reacciona la persona ante el robot</translation>
    </message>
    <message>
        <source>Sees within</source>
        <translation>Ve hasta</translation>
    </message>
    <message>
        <source>Distance within which the person notices the robot</source>
        <translation>Distancia a la que la persona percibe el robot</translation>
    </message>
    <message>
        <source>Lasts</source>
        <translation>Dura</translation>
    </message>
    <message>
        <source>Duration of the reaction</source>
        <translation>Duración de la reacción</translation>
    </message>
    <message>
        <source>Only once</source>
        <translation>Solo una vez</translation>
    </message>
    <message>
        <source>React only once</source>
        <translation>Reaccionar solo una vez</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Speed during the reaction; absent: `max_vel`, or 2.0 if that is absent too</source>
        <translation>Velocidad durante la reacción; si falta: `max_vel`, o 2.0 si esa también falta</translation>
    </message>
    <message>
        <source>Keeps away</source>
        <translation>Se aleja a</translation>
    </message>
    <message>
        <source>Distance to which the person retreats from the robot</source>
        <translation>Distancia a la que la persona se retira del robot</translation>
    </message>
    <message>
        <source>Stops at</source>
        <translation>Se detiene a</translation>
    </message>
    <message>
        <source>Distance to the robot at which the person stops</source>
        <translation>Distancia al robot a la que la persona se detiene</translation>
    </message>
    <message>
        <source>Blocks at</source>
        <translation>Bloquea a</translation>
    </message>
    <message>
        <source>Distance in front of the robot at which the person stands</source>
        <translation>Distancia delante del robot a la que se coloca la persona</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>Source of the force factors, see below</source>
        <translation>Origen de los factores de fuerza, véase abajo</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Factor of the attractive force of the goal</source>
        <translation>Factor de la fuerza de atracción del objetivo</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstáculos</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of walls and obstacles</source>
        <translation>Factor de la fuerza de repulsión de paredes y obstáculos</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of other people</source>
        <translation>Factor de la fuerza de repulsión de otras personas</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Factor of the repulsive force of the robot while scared; never randomised</source>
        <translation>Factor de la fuerza de repulsión del robot durante el susto; nunca aleatorio</translation>
    </message>
    <message>
        <source>Enters at</source>
        <translation>Entra a los</translation>
    </message>
    <message>
        <source>Time at which the person enters the world</source>
        <translation>Tiempo en que la persona entra en el mundo</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Body type; determines the mass and the symbol on the map</source>
        <translation>Tipo de cuerpo; determina la masa y el símbolo en el mapa</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Mass of the body; absent: 80, 32, 75, 100, 100 by kind</source>
        <translation>Masa del cuerpo; si falta: 80, 32, 75, 100, 100 según el tipo</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Pedestrian model; absent: that of the scenario</source>
        <translation>Modelo de peatones; si falta: el del escenario</translation>
    </message>
    <message>
        <source>Routes</source>
        <translation>Rutas</translation>
    </message>
    <message>
        <source>Paths planned around walls, or straight lines; absent: as in the scenario</source>
        <translation>Caminos planificados alrededor de las paredes, o líneas rectas; si falta: como en el escenario</translation>
    </message>
    <message>
        <source>At the end</source>
        <translation>Al final</translation>
    </message>
    <message>
        <source>What the person does after the last goal of a route that does not repeat</source>
        <translation>Qué hace la persona tras el último objetivo de una ruta que no se repite</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Esperas</translation>
    </message>
    <message>
        <source>Waiting time at each goal of the route</source>
        <translation>Tiempo de espera en cada objetivo de la ruta</translation>
    </message>
    <message>
        <source>Tree file</source>
        <translation>Archivo de árbol</translation>
    </message>
    <message>
        <source>Behaviour tree file, relative to the scenario; several people may use the same one</source>
        <translation>Archivo de árbol de comportamiento, relativo al escenario; varias personas pueden usar el mismo</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Robot type</source>
        <translation>Tipo de robot</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificador</translation>
    </message>
    <message>
        <source>Planner that drives the robot to its goals</source>
        <translation>Planificador que lleva el robot a sus objetivos</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Planner external: the planner program with its arguments, or unix:PATH of a socket; runs only with --allow-code</source>
        <translation>Planificador external: el programa con sus argumentos, o unix:RUTA de un socket; solo se ejecuta con --allow-code</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Parameters of the planner: name and value of each</source>
        <translation>Parámetros del planificador: nombre y valor de cada uno</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Parámetros Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: the parameter file (`nav2_params.yaml`) or the name of a shipped one; a list: several files, of which later ones override earlier ones, and single values in ROS 2 syntax (`FollowPath.max_vel_x:=0.3`)</source>
        <translation>Planificador nav2: el archivo de parámetros (`nav2_params.yaml`) o el nombre de uno incluido; una lista: varios archivos, de los que los posteriores tienen prioridad, y valores sueltos en la sintaxis de ROS 2 (`FollowPath.max_vel_x:=0.3`)</translation>
    </message>
    <message>
        <source>Nav2 tree</source>
        <translation>Árbol de Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: the navigator&apos;s behaviour tree file or the name of a shipped one</source>
        <translation>Planificador nav2: el archivo de árbol del navegador o el nombre de uno incluido</translation>
    </message>
    <message>
        <source>Nav2 branch</source>
        <translation>Rama de Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: Nav2 branch whose defaults and algorithms are used; absent: detected from the parameter file</source>
        <translation>Planificador nav2: rama de Nav2 cuyos valores y algoritmos se usan; si falta: se detecta en el archivo de parámetros</translation>
    </message>
    <message>
        <source>Nav2 topics</source>
        <translation>Topics de Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: topic messages and service calls, separated by `;`, each with a time [s], a name and the message: `12 controller_selector FollowPath2; 20 /pause`</source>
        <translation>Planificador nav2: mensajes de topics y llamadas a servicios, separados por `;`, cada uno con un tiempo [s], un nombre y el mensaje: `12 controller_selector FollowPath2; 20 /pause`</translation>
    </message>
    <message>
        <source>Nav2 values</source>
        <translation>Valores de Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: values that override those of the parameter file, by node and name</source>
        <translation>Planificador nav2: valores que sustituyen a los del archivo de parámetros, por nodo y nombre</translation>
    </message>
    <message>
        <source>Body from Nav2</source>
        <translation>Cuerpo de Nav2</translation>
    </message>
    <message>
        <source>Planner nav2: true: radius or footprint are read from local_costmap in the parameter files</source>
        <translation>Planificador nav2: true: el radio o el contorno se leen de local_costmap en los archivos de parámetros</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Start pose: `x`, `y` and heading `h`</source>
        <translation>Pose inicial: `x`, `y` y orientación `h`</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Goal position: `x` and `y`</source>
        <translation>Posición del objetivo: `x` e `y`</translation>
    </message>
    <message>
        <source>Or route</source>
        <translation>O ruta</translation>
    </message>
    <message>
        <source>Numbers of global goals in order, instead of `goal`</source>
        <translation>Números de objetivos globales en orden, en lugar de `goal`</translation>
    </message>
    <message>
        <source>Distance within which a goal is reached; with `nav2` the navigator decides</source>
        <translation>Distancia a la que se alcanza un objetivo; con `nav2` decide el navegador</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>Empieza a los</translation>
    </message>
    <message>
        <source>Time at which the robot starts</source>
        <translation>Tiempo en que empieza el robot</translation>
    </message>
    <message>
        <source>Radius of the robot&apos;s circular body</source>
        <translation>Radio del cuerpo circular del robot</translation>
    </message>
    <message>
        <source>Mass of the robot</source>
        <translation>Masa del robot</translation>
    </message>
    <message>
        <source>Maximum speed</source>
        <translation>Velocidad máxima</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Maximum acceleration</source>
        <translation>Aceleración máxima</translation>
    </message>
    <message>
        <source>Turn rate</source>
        <translation>Vel. de giro</translation>
    </message>
    <message>
        <source>Maximum turn rate</source>
        <translation>Velocidad de giro máxima</translation>
    </message>
    <message>
        <source>Turn accel.</source>
        <translation>Acel. de giro</translation>
    </message>
    <message>
        <source>Maximum angular acceleration</source>
        <translation>Aceleración angular máxima</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>X coordinates of the footprint&apos;s corners in the robot&apos;s frame; replaces the circular body</source>
        <translation>Coordenadas X de los vértices del contorno en el sistema del robot; sustituye al cuerpo circular</translation>
    </message>
    <message>
        <source>Footprint y</source>
        <translation>Contorno y</translation>
    </message>
    <message>
        <source>Y coordinates of these corners, as many as `footprint_x`</source>
        <translation>Coordenadas Y de estos vértices, tantas como `footprint_x`</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Tracción</translation>
    </message>
    <message>
        <source>Kinematics of the drive</source>
        <translation>Cinemática de la tracción</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Radio de giro</translation>
    </message>
    <message>
        <source>Minimum turning radius of a robot with Ackermann steering</source>
        <translation>Radio de giro mínimo de un robot con dirección Ackermann</translation>
    </message>
    <message>
        <source>Lidar</source>
        <translation>Lidar</translation>
    </message>
    <message>
        <source>Lidar of the robot, keys below; absent: that of the robot type</source>
        <translation>Lidar del robot, claves abajo; si falta: el del tipo de robot</translation>
    </message>
    <message>
        <source>Detector</source>
        <translation>Detector</translation>
    </message>
    <message>
        <source>Detection of people and other robots, keys below</source>
        <translation>Detección de personas y otros robots, claves abajo</translation>
    </message>
    <message>
        <source>Odometry noise</source>
        <translation>Ruido odométrico</translation>
    </message>
    <message>
        <source>Odometry errors, which accumulate; absent: none</source>
        <translation>Errores de odometría, que se acumulan; si falta: ninguno</translation>
    </message>
    <message>
        <source>Localization</source>
        <translation>Localización</translation>
    </message>
    <message>
        <source>Errors and corrections of the localization (AMCL); absent: none</source>
        <translation>Errores y correcciones de la localización (AMCL); si falta: ninguno</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Batería</translation>
    </message>
    <message>
        <source>Battery of the robot; absent: it never runs low</source>
        <translation>Batería del robot; si falta: nunca se agota</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Haces</translation>
    </message>
    <message>
        <source>Number of beams per scan; 0: no lidar; absent, here and below: that of the robot type</source>
        <translation>Número de haces por barrido; 0: sin lidar; si falta, aquí y abajo: el del tipo de robot</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Maximum range</source>
        <translation>Alcance máximo</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frecuencia</translation>
    </message>
    <message>
        <source>Scans per second</source>
        <translation>Barridos por segundo</translation>
    </message>
    <message>
        <source>Angle min</source>
        <translation>Ángulo mín.</translation>
    </message>
    <message>
        <source>Angle of the first beam</source>
        <translation>Ángulo del primer haz</translation>
    </message>
    <message>
        <source>Angle max</source>
        <translation>Ángulo máx.</translation>
    </message>
    <message>
        <source>Angle of the last beam; if it is a full turn after the first, the beams are spaced evenly</source>
        <translation>Ángulo del último haz; si es una vuelta completa después del primero, los haces se reparten por igual</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Position in the robot&apos;s frame: forward</source>
        <translation>Posición en el sistema del robot: hacia delante</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Position in the robot&apos;s frame: to the left</source>
        <translation>Posición en el sistema del robot: hacia la izquierda</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>Orientation in the robot&apos;s frame</source>
        <translation>Orientación en el sistema del robot</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Ruido</translation>
    </message>
    <message>
        <source>Standard deviation of a measured distance</source>
        <translation>Desviación típica de una distancia medida</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Piernas</translation>
    </message>
    <message>
        <source>The lidar detects people as two legs instead of discs</source>
        <translation>El lidar ve a las personas como dos piernas; si no, como discos</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Registrar</translation>
    </message>
    <message>
        <source>Write each scan to `scans.csv`</source>
        <translation>Escribir cada barrido en `scans.csv`</translation>
    </message>
    <message>
        <source>People perception</source>
        <translation>Percepción de personas</translation>
    </message>
    <message>
        <source>Detections of the sensors, or the exact state of all bodies everywhere, which ignores the keys below</source>
        <translation>Detecciones de los sensores, o el estado exacto de todos los cuerpos en todas partes, que ignora las claves de abajo</translation>
    </message>
    <message>
        <source>Maximum distance of a detected body&apos;s centre</source>
        <translation>Distancia máxima del centro de un cuerpo detectado</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Campo</translation>
    </message>
    <message>
        <source>Field of view, half of it to either side</source>
        <translation>Campo de visión, la mitad a cada lado</translation>
    </message>
    <message>
        <source>Detections per second; 0: one per time step</source>
        <translation>Detecciones por segundo; 0: una por paso</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>Latencia</translation>
    </message>
    <message>
        <source>Delay between detection and planner</source>
        <translation>Retardo entre la detección y el planificador</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate</source>
        <translation>Desviación típica de cada coordenada</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Pérdidas</translation>
    </message>
    <message>
        <source>Probability per detection of missing a visible body</source>
        <translation>Probabilidad por detección de no ver un cuerpo visible</translation>
    </message>
    <message>
        <source>Swaps</source>
        <translation>Intercambios</translation>
    </message>
    <message>
        <source>Probability per detection of exchanging the ids of two people who are close</source>
        <translation>Probabilidad por detección de intercambiar los ids de dos personas cercanas</translation>
    </message>
    <message>
        <source>Swap distance</source>
        <translation>Dist. intercambio</translation>
    </message>
    <message>
        <source>Distance below which the ids of two people may be exchanged</source>
        <translation>Distancia por debajo de la cual se pueden intercambiar los ids de dos personas</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Oclusión</translation>
    </message>
    <message>
        <source>Walls and other bodies occlude</source>
        <translation>Las paredes y otros cuerpos ocultan</translation>
    </message>
    <message>
        <source>Hidden share</source>
        <translation>Parte oculta</translation>
    </message>
    <message>
        <source>A body of which others occlude more than this share is not detected</source>
        <translation>Un cuerpo del que otros ocultan más de esta parte no se detecta</translation>
    </message>
    <message>
        <source>Coast time</source>
        <translation>T. sin detección</translation>
    </message>
    <message>
        <source>A track without detection is deleted after this time; until then it is extrapolated with constant velocity</source>
        <translation>Una pista sin detección se borra tras este tiempo; hasta entonces se extrapola con velocidad constante</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Velocidades</translation>
    </message>
    <message>
        <source>Measured, or estimated from positions by a Kalman filter; absent: `filtered` with `noise`, otherwise `measured`</source>
        <translation>Medidas, o estimadas de las posiciones con un filtro de Kalman; si falta: `filtered` con `noise`, si no `measured`</translation>
    </message>
    <message>
        <source>Acceleration noise</source>
        <translation>Ruido de acel.</translation>
    </message>
    <message>
        <source>Kalman filter: power of the acceleration noise of people</source>
        <translation>Filtro de Kalman: potencia del ruido de aceleración de las personas</translation>
    </message>
    <message>
        <source>Alpha1</source>
        <translation>Alfa 1</translation>
    </message>
    <message>
        <source>Variance of the heading caused by rotation</source>
        <translation>Varianza de la orientación causada por la rotación</translation>
    </message>
    <message>
        <source>Alpha2</source>
        <translation>Alfa 2</translation>
    </message>
    <message>
        <source>Variance of the heading caused by translation</source>
        <translation>Varianza de la orientación causada por la traslación</translation>
    </message>
    <message>
        <source>Alpha3</source>
        <translation>Alfa 3</translation>
    </message>
    <message>
        <source>Variance of the distance caused by translation</source>
        <translation>Varianza de la distancia causada por la traslación</translation>
    </message>
    <message>
        <source>Alpha4</source>
        <translation>Alfa 4</translation>
    </message>
    <message>
        <source>Variance of the distance caused by rotation</source>
        <translation>Varianza de la distancia causada por la rotación</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Deriva</translation>
    </message>
    <message>
        <source>Rotation per metre driven forward that odometry does not measure</source>
        <translation>Rotación por metro avanzado que la odometría no mide</translation>
    </message>
    <message>
        <source>Std x</source>
        <translation>Desv. x</translation>
    </message>
    <message>
        <source>Standard deviation of the error in x, in the map</source>
        <translation>Desviación típica del error en x, en el mapa</translation>
    </message>
    <message>
        <source>Std y</source>
        <translation>Desv. y</translation>
    </message>
    <message>
        <source>Standard deviation of the error in y, in the map</source>
        <translation>Desviación típica del error en y, en el mapa</translation>
    </message>
    <message>
        <source>Std yaw</source>
        <translation>Desv. orient.</translation>
    </message>
    <message>
        <source>Standard deviation of the error of the heading</source>
        <translation>Desviación típica del error de la orientación</translation>
    </message>
    <message>
        <source>Correlation time</source>
        <translation>T. correlación</translation>
    </message>
    <message>
        <source>Time constant of the errors; 0: corrections are independent</source>
        <translation>Constante de tiempo de los errores; 0: las correcciones son independientes</translation>
    </message>
    <message>
        <source>Jump rate</source>
        <translation>Tasa de saltos</translation>
    </message>
    <message>
        <source>Mean number of jumps of the estimate per second</source>
        <translation>Número medio de saltos de la estimación por segundo</translation>
    </message>
    <message>
        <source>Jump distance</source>
        <translation>Dist. de salto</translation>
    </message>
    <message>
        <source>Length of a jump</source>
        <translation>Longitud de un salto</translation>
    </message>
    <message>
        <source>Jump yaw</source>
        <translation>Giro de salto</translation>
    </message>
    <message>
        <source>Rotation of a jump, in either direction</source>
        <translation>Rotación de un salto, en cualquier sentido</translation>
    </message>
    <message>
        <source>Corrections of map -&gt; odom per second; 0: only the first one; absent: 2 with an error, otherwise 0</source>
        <translation>Correcciones de map -&gt; odom por segundo; 0: solo la primera; si falta: 2 con un error, si no 0</translation>
    </message>
    <message>
        <source>Start x</source>
        <translation>Inicio x</translation>
    </message>
    <message>
        <source>Error of the initial pose: x</source>
        <translation>Error de la pose inicial: x</translation>
    </message>
    <message>
        <source>Start y</source>
        <translation>Inicio y</translation>
    </message>
    <message>
        <source>Error of the initial pose: y</source>
        <translation>Error de la pose inicial: y</translation>
    </message>
    <message>
        <source>Start yaw</source>
        <translation>Inicio orient.</translation>
    </message>
    <message>
        <source>Error of the initial pose: heading</source>
        <translation>Error de la pose inicial: orientación</translation>
    </message>
    <message>
        <source>Initial pose time</source>
        <translation>T. pose inicial</translation>
    </message>
    <message>
        <source>Time of the initial pose; there is no frame map before</source>
        <translation>Tiempo de la pose inicial; antes no existe el sistema map</translation>
    </message>
    <message>
        <source>Global std</source>
        <translation>Desv. global</translation>
    </message>
    <message>
        <source>Standard deviation of x and y after a global localization</source>
        <translation>Desviación típica de x e y tras una localización global</translation>
    </message>
    <message>
        <source>Global std yaw</source>
        <translation>Desv. global or.</translation>
    </message>
    <message>
        <source>Standard deviation of the heading after a global localization</source>
        <translation>Desviación típica de la orientación tras una localización global</translation>
    </message>
    <message>
        <source>Capacity</source>
        <translation>Capacidad</translation>
    </message>
    <message>
        <source>Stored energy when full; absent: the battery never runs low</source>
        <translation>Energía almacenada con carga completa; si falta: la batería nunca se agota</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>State of charge at the start</source>
        <translation>Estado de carga al inicio</translation>
    </message>
    <message>
        <source>Idle power</source>
        <translation>Potencia parado</translation>
    </message>
    <message>
        <source>Power consumption at standstill</source>
        <translation>Consumo de potencia en reposo</translation>
    </message>
    <message>
        <source>Motion power</source>
        <translation>Pot. movimiento</translation>
    </message>
    <message>
        <source>Additional power consumption at top speed or top turn rate; proportional below</source>
        <translation>Consumo adicional a velocidad o giro máximos; proporcional por debajo</translation>
    </message>
    <message>
        <source>Charge power</source>
        <translation>Pot. de carga</translation>
    </message>
    <message>
        <source>Charging power at a charging dock</source>
        <translation>Potencia de carga en una base de carga</translation>
    </message>
    <message>
        <source>Empty voltage</source>
        <translation>Tensión vacía</translation>
    </message>
    <message>
        <source>Voltage of the empty battery</source>
        <translation>Tensión de la batería vacía</translation>
    </message>
    <message>
        <source>Full voltage</source>
        <translation>Tensión llena</translation>
    </message>
    <message>
        <source>Voltage of the full battery; linear in between</source>
        <translation>Tensión de la batería llena; lineal entre ambas</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Clase</translation>
    </message>
    <message>
        <source>Shape; each shape uses some of the other keys</source>
        <translation>Forma; cada forma usa algunas de las otras claves</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Direction of `length`</source>
        <translation>Dirección de `length`</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Size along the heading</source>
        <translation>Tamaño a lo largo de la orientación</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Size across the heading</source>
        <translation>Tamaño transversal a la orientación</translation>
    </message>
    <message>
        <source>Radius of the circle</source>
        <translation>Radio del círculo</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>X coordinates of the corners</source>
        <translation>Coordenadas X de los vértices</translation>
    </message>
    <message>
        <source>Ys</source>
        <translation>Ys</translation>
    </message>
    <message>
        <source>Y coordinates of the corners, as many as `xs`</source>
        <translation>Coordenadas Y de los vértices, tantas como `xs`</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>From X</source>
        <translation>Desde X</translation>
    </message>
    <message>
        <source>First end</source>
        <translation>Primer extremo</translation>
    </message>
    <message>
        <source>From Y</source>
        <translation>Desde Y</translation>
    </message>
    <message>
        <source>To X</source>
        <translation>Hasta X</translation>
    </message>
    <message>
        <source>Second end</source>
        <translation>Segundo extremo</translation>
    </message>
    <message>
        <source>To Y</source>
        <translation>Hasta Y</translation>
    </message>
    <message>
        <source>Open at start</source>
        <translation>Abierta al inicio</translation>
    </message>
    <message>
        <source>Whether the door is open at the start</source>
        <translation>Si la puerta está abierta al inicio</translation>
    </message>
    <message>
        <source>Toggles at</source>
        <translation>Cambia a los</translation>
    </message>
    <message>
        <source>Times at which the door opens or closes</source>
        <translation>Tiempos en que la puerta se abre o se cierra</translation>
    </message>
    <message>
        <source>Purpose of the area</source>
        <translation>Finalidad del área</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Copia a</translation>
    </message>
    <message>
        <source>Source: the person that is copied</source>
        <translation>Fuente: la persona que se copia</translation>
    </message>
    <message>
        <source>Source: people per second</source>
        <translation>Fuente: personas por segundo</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Source: people are spawned from this time on</source>
        <translation>Fuente: las personas se generan a partir de este tiempo</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Source: no people are spawned after this time; absent: never ends</source>
        <translation>Fuente: después de este tiempo no se generan personas; si falta: sin fin</translation>
    </message>
    <message>
        <source>Max. people</source>
        <translation>Máx. personas</translation>
    </message>
    <message>
        <source>Source: maximum number of people; absent: no limit</source>
        <translation>Fuente: número máximo de personas; si falta: sin límite</translation>
    </message>
    <message>
        <source>Speed factor</source>
        <translation>Factor de vel.</translation>
    </message>
    <message>
        <source>Speed: factor of the walking speed of people inside</source>
        <translation>Velocidad: factor de la velocidad de marcha de las personas que están dentro</translation>
    </message>
    <message>
        <source>Carrying speed</source>
        <translation>Vel. de arrastre</translation>
    </message>
    <message>
        <source>Speed: speed with which people inside are carried, as by a travelator</source>
        <translation>Velocidad: velocidad con que se transporta a las personas que están dentro, como en un pasillo rodante</translation>
    </message>
    <message>
        <source>Carrying direction</source>
        <translation>Dir. de arrastre</translation>
    </message>
    <message>
        <source>Speed: direction in which people inside are carried</source>
        <translation>Velocidad: dirección en que se las transporta</translation>
    </message>
    <message>
        <source>Whether the dock charges robots</source>
        <translation>Si la base carga robots</translation>
    </message>
    <message>
        <source>Centre of a docked robot</source>
        <translation>Centro de un robot acoplado</translation>
    </message>
    <message>
        <source>Heading of a robot that docks forward</source>
        <translation>Orientación de un robot que se acopla hacia delante</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>Ficha</translation>
    </message>
    <message>
        <source>Description of the scenario: what it tests, with its source</source>
        <translation>Descripción del escenario: qué prueba, con su fuente</translation>
    </message>
    <message>
        <source>Map file</source>
        <translation>Archivo de mapa</translation>
    </message>
    <message>
        <source>Map file, relative to the scenario; `none`: open plane; absent: the file of `map` is searched</source>
        <translation>Archivo de mapa, relativo al escenario; `none`: plano abierto; si falta: se busca el archivo de `map`</translation>
    </message>
    <message>
        <source>Map rule</source>
        <translation>Regla del mapa</translation>
    </message>
    <message>
        <source>Nav2 branch whose rule for grey pixels is used</source>
        <translation>Rama de Nav2 cuya regla para píxeles grises se usa</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Random seed; the same seed reproduces the run</source>
        <translation>Semilla aleatoria; la misma semilla reproduce la ejecución</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Time limit; absent: the run ends 1 s after the robot has arrived, at most 120 s; 60 s without a robot that has a goal</source>
        <translation>Límite de tiempo; si falta: la ejecución termina 1 s después de llegar el robot, como máximo a los 120 s; a los 60 s sin un robot que tenga meta</translation>
    </message>
    <message>
        <source>End on contact</source>
        <translation>Fin por contacto</translation>
    </message>
    <message>
        <source>Contacts of a robot on its route that end the run; `any`: with people, robots or walls</source>
        <translation>Contactos de un robot en su ruta que terminan la ejecución; `any`: con personas, robots o paredes</translation>
    </message>
    <message>
        <source>Stuck after</source>
        <translation>Atascado tras</translation>
    </message>
    <message>
        <source>A robot is stuck if it makes no progress for this long; the run ends if no other robot makes progress; 0: never</source>
        <translation>Un robot está atascado si no avanza durante este tiempo; la ejecución termina si ningún otro robot avanza; 0: nunca</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Paso de tiempo</translation>
    </message>
    <message>
        <source>Record every</source>
        <translation>Registrar cada</translation>
    </message>
    <message>
        <source>Time steps from one recorded sample to the next</source>
        <translation>Pasos entre una muestra registrada y la siguiente</translation>
    </message>
    <message>
        <source>Pedestrian model, see `list models`</source>
        <translation>Modelo de peatones, véase `list models`</translation>
    </message>
    <message>
        <source>Model parameters</source>
        <translation>Parám. del modelo</translation>
    </message>
    <message>
        <source>Parameters of models, below the name of each, see `list models --format json`</source>
        <translation>Parámetros de los modelos, bajo el nombre de cada uno, véase `list models --format json`</translation>
    </message>
    <message>
        <source>Paths planned around walls, or straight lines as in HuNavSim</source>
        <translation>Caminos planificados alrededor de las paredes, o líneas rectas como en HuNavSim</translation>
    </message>
    <message>
        <source>Wall force from</source>
        <translation>Fuerza de pared</translation>
    </message>
    <message>
        <source>Wall forces from the nearest points of walls, or from the hits of rays as of a lidar</source>
        <translation>Fuerzas de pared desde los puntos más cercanos de las paredes, o desde los impactos de rayos como los de un lidar</translation>
    </message>
    <message>
        <source>Loop trees</source>
        <translation>Árboles en bucle</translation>
    </message>
    <message>
        <source>Restart a tree that has ended</source>
        <translation>Reiniciar un árbol que ha terminado</translation>
    </message>
    <message>
        <source>Corridor</source>
        <translation>Pasillo</translation>
    </message>
    <message>
        <source>Periodic corridor: people who pass the second x re-enter at the first</source>
        <translation>Pasillo periódico: quienes pasan la segunda x vuelven a entrar por la primera</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Grupos</translation>
    </message>
    <message>
        <source>Names of groups by their numbers</source>
        <translation>Nombres de los grupos por su número</translation>
    </message>
    <message>
        <source>Variation</source>
        <translation>Variación</translation>
    </message>
    <message>
        <source>Variation of people between seeds</source>
        <translation>Variación de las personas entre semillas</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Título</translation>
    </message>
    <message>
        <source>Name of the scenario in lists</source>
        <translation>Nombre del escenario en listas</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familia</translation>
    </message>
    <message>
        <source>Group of scenarios that it belongs to</source>
        <translation>Grupo de escenarios al que pertenece</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>Finalidad</translation>
    </message>
    <message>
        <source>What the scenario tests</source>
        <translation>Qué prueba el escenario</translation>
    </message>
    <message>
        <source>Task of the robot</source>
        <translation>Tarea del robot</translation>
    </message>
    <message>
        <source>What the robot has to do</source>
        <translation>Qué debe hacer el robot</translation>
    </message>
    <message>
        <source>What people do</source>
        <translation>Qué hacen</translation>
    </message>
    <message>
        <source>Expected outcome</source>
        <translation>Resultado esperado</translation>
    </message>
    <message>
        <source>What is expected of a good robot</source>
        <translation>Qué se espera de un buen robot</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Keys of the metrics to read, see `list metrics`; the first one compares planners</source>
        <translation>Claves de las métricas que leer, véase `list metrics`; la primera compara planificadores</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Dificultad</translation>
    </message>
    <message>
        <source>Difficulty for the robot</source>
        <translation>Dificultad para el robot</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>Publication or standard that the scenario is taken from</source>
        <translation>Publicación o norma de la que procede</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>Licencia</translation>
    </message>
    <message>
        <source>Licence of the scenario and its map</source>
        <translation>Licencia del escenario y de su mapa</translation>
    </message>
    <message>
        <source>Expected events</source>
        <translation>Eventos esperados</translation>
    </message>
    <message>
        <source>What happens in a run without robots, see below; `check --certify` tests it</source>
        <translation>Qué ocurre en una ejecución sin robots, véase abajo; `check --certify` lo comprueba</translation>
    </message>
    <message>
        <source>Amount of variation of people between seeds; keys of a quantity take precedence</source>
        <translation>Grado de variación de las personas entre semillas; las claves de una magnitud tienen prioridad</translation>
    </message>
    <message>
        <source>Start time: kind</source>
        <translation>Hora inicio: tipo</translation>
    </message>
    <message>
        <source>Added to the start time; absent: that of the preset</source>
        <translation>Se suma al tiempo de inicio; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>Start time: deviation</source>
        <translation>Hora inicio: desv.</translation>
    </message>
    <message>
        <source>Normal: standard deviation</source>
        <translation>Normal: desviación típica</translation>
    </message>
    <message>
        <source>Start time: half width</source>
        <translation>Hora inicio: semianch.</translation>
    </message>
    <message>
        <source>Uniform: half of the width</source>
        <translation>Uniforme: mitad del ancho</translation>
    </message>
    <message>
        <source>Start time: minimum</source>
        <translation>Hora inicio: mínimo</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Límite inferior</translation>
    </message>
    <message>
        <source>Start time: maximum</source>
        <translation>Hora inicio: máximo</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Límite superior</translation>
    </message>
    <message>
        <source>Start: kind</source>
        <translation>Inicio: tipo</translation>
    </message>
    <message>
        <source>Added to x and y of the start; absent: that of the preset</source>
        <translation>Se suma a x e y del inicio; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>Start: deviation</source>
        <translation>Inicio: desviación</translation>
    </message>
    <message>
        <source>Start: half width</source>
        <translation>Inicio: semiancho</translation>
    </message>
    <message>
        <source>Start: minimum</source>
        <translation>Inicio: mínimo</translation>
    </message>
    <message>
        <source>Start: maximum</source>
        <translation>Inicio: máximo</translation>
    </message>
    <message>
        <source>Heading: kind</source>
        <translation>Orientación: tipo</translation>
    </message>
    <message>
        <source>Added to the heading at the start; absent: that of the preset</source>
        <translation>Se suma a la orientación al inicio; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>Heading: deviation</source>
        <translation>Orientación: desv.</translation>
    </message>
    <message>
        <source>Heading: half width</source>
        <translation>Orientación: semianch.</translation>
    </message>
    <message>
        <source>Heading: minimum</source>
        <translation>Orientación: mínimo</translation>
    </message>
    <message>
        <source>Heading: maximum</source>
        <translation>Orientación: máximo</translation>
    </message>
    <message>
        <source>Speed: kind</source>
        <translation>Velocidad: tipo</translation>
    </message>
    <message>
        <source>Factor of max_vel; absent: that of the preset</source>
        <translation>Factor de max_vel; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>Speed: deviation</source>
        <translation>Velocidad: desviación</translation>
    </message>
    <message>
        <source>Speed: half width</source>
        <translation>Velocidad: semiancho</translation>
    </message>
    <message>
        <source>Speed: minimum</source>
        <translation>Velocidad: mínimo</translation>
    </message>
    <message>
        <source>Speed: maximum</source>
        <translation>Velocidad: máximo</translation>
    </message>
    <message>
        <source>Reaction time: kind</source>
        <translation>Reacción: tipo</translation>
    </message>
    <message>
        <source>Factor of the reaction time; absent: that of the preset</source>
        <translation>Factor del tiempo de reacción; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>Reaction time: deviation</source>
        <translation>Reacción: desviación</translation>
    </message>
    <message>
        <source>Reaction time: half width</source>
        <translation>Reacción: semiancho</translation>
    </message>
    <message>
        <source>Reaction time: minimum</source>
        <translation>Reacción: mínimo</translation>
    </message>
    <message>
        <source>Reaction time: maximum</source>
        <translation>Reacción: máximo</translation>
    </message>
    <message>
        <source>First goal: kind</source>
        <translation>1.er objetivo: tipo</translation>
    </message>
    <message>
        <source>Number of goals of a repeated route that are skipped at first; absent: that of the preset</source>
        <translation>Número de objetivos de una ruta repetida que se omiten al principio; si falta: el del valor preestablecido</translation>
    </message>
    <message>
        <source>First goal: deviation</source>
        <translation>1.er objetivo: desv.</translation>
    </message>
    <message>
        <source>First goal: half width</source>
        <translation>1.er objetivo: semianch.</translation>
    </message>
    <message>
        <source>First goal: minimum</source>
        <translation>1.er objetivo: mínimo</translation>
    </message>
    <message>
        <source>First goal: maximum</source>
        <translation>1.er objetivo: máximo</translation>
    </message>
    <message>
        <source>Start of the measurement: begin, goal, motion, time 5.0 or event contact</source>
        <translation>Inicio de la medición: begin, goal, motion, time 5.0 o event contact</translation>
    </message>
    <message>
        <source>End of the measurement: end, arrival, time 20.0 or event contact</source>
        <translation>Fin de la medición: end, arrival, time 20.0 o event contact</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Frec. de muestreo</translation>
    </message>
    <message>
        <source>Sampling rate; 0: every recorded sample</source>
        <translation>Frecuencia de muestreo; 0: cada muestra registrada</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Name of the experiment in the results</source>
        <translation>Nombre del experimento en los resultados</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Nº de ejecución</translation>
    </message>
    <message>
        <source>Number of the run in the results</source>
        <translation>Número de la ejecución en los resultados</translation>
    </message>
    <message>
        <source>Metrics file</source>
        <translation>Archivo de métricas</translation>
    </message>
    <message>
        <source>File that selects the metrics, relative to the scenario; absent: all metrics</source>
        <translation>Archivo que elige las métricas, relativo al escenario; si falta: todas las métricas</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Umbrales</translation>
    </message>
    <message>
        <source>Thresholds of metrics: name and value of each</source>
        <translation>Umbrales de las métricas: nombre y valor de cada uno</translation>
    </message>
    <message>
        <source>Dynamic window approach (Fox, Burgard &amp; Thrun 1997): scores the arcs that the robot can drive next.</source>
        <translation>Método de la ventana dinámica (Fox, Burgard y Thrun 1997): puntúa los arcos que el robot puede recorrer a continuación.</translation>
    </message>
    <message>
        <source>Linear samples</source>
        <translation>Muestras lineales</translation>
    </message>
    <message>
        <source>Sampled speeds; omnidirectional: the total number of samples is distributed evenly.</source>
        <translation>Velocidades muestreadas; omnidireccional: el número total de muestras se reparte por igual.</translation>
    </message>
    <message>
        <source>Angular samples</source>
        <translation>Muestras angulares</translation>
    </message>
    <message>
        <source>Sampled turn rates for each speed.</source>
        <translation>Velocidades de giro muestreadas para cada velocidad.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Time within which a sampled velocity must be reachable.</source>
        <translation>Tiempo en el que una velocidad muestreada debe poder alcanzarse.</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>Horizonte</translation>
    </message>
    <message>
        <source>Time for which arcs are simulated; longer if braking takes longer.</source>
        <translation>Tiempo que se simulan los arcos; más si frenar requiere más tiempo.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Time between two checks along an arc.</source>
        <translation>Tiempo entre dos comprobaciones a lo largo de un arco.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Minimum distance to walls and people.</source>
        <translation>Distancia mínima a paredes y personas.</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Holgura</translation>
    </message>
    <message>
        <source>Clearance above which more clearance does not improve the score of an arc.</source>
        <translation>Holgura a partir de la cual más holgura no mejora la puntuación de un arco.</translation>
    </message>
    <message>
        <source>Goal weight</source>
        <translation>Peso objetivo</translation>
    </message>
    <message>
        <source>Weight of the remaining path length at the end of an arc.</source>
        <translation>Peso de la longitud de camino restante al final de un arco.</translation>
    </message>
    <message>
        <source>Heading weight</source>
        <translation>Peso orientación</translation>
    </message>
    <message>
        <source>Weight of the remaining rotation at the position where the robot would stop if it braked.</source>
        <translation>Peso de la rotación restante en la posición en que el robot se detendría si frenara.</translation>
    </message>
    <message>
        <source>Clearance weight</source>
        <translation>Peso holgura</translation>
    </message>
    <message>
        <source>Weight of missing clearance along an arc.</source>
        <translation>Peso de la holgura que falta a lo largo de un arco.</translation>
    </message>
    <message>
        <source>Velocity weight</source>
        <translation>Peso velocidad</translation>
    </message>
    <message>
        <source>Weight of the difference to the maximum speed.</source>
        <translation>Peso de la diferencia con la velocidad máxima.</translation>
    </message>
    <message>
        <source>Smoothness weight</source>
        <translation>Peso suavidad</translation>
    </message>
    <message>
        <source>Weight of the difference from the last command.</source>
        <translation>Peso de la diferencia con la última orden.</translation>
    </message>
    <message>
        <source>Slow distance</source>
        <translation>Dist. de frenado</translation>
    </message>
    <message>
        <source>Gap to a person ahead below which the robot slows down.</source>
        <translation>Distancia a una persona delante por debajo de la cual el robot reduce la velocidad.</translation>
    </message>
    <message>
        <source>Slow share</source>
        <translation>Parte lenta</translation>
    </message>
    <message>
        <source>Share of the maximum speed close to a person.</source>
        <translation>Parte de la velocidad máxima cerca de una persona.</translation>
    </message>
    <message>
        <source>Standing speed</source>
        <translation>Vel. de reposo</translation>
    </message>
    <message>
        <source>People below this speed count as standing: the path leads around them.</source>
        <translation>Las personas por debajo de esta velocidad cuentan como quietas: el camino las rodea.</translation>
    </message>
    <message>
        <source>Patience</source>
        <translation>Paciencia</translation>
    </message>
    <message>
        <source>Time without progress after which the robot backs off and tries again.</source>
        <translation>Tiempo sin avance tras el cual el robot retrocede y lo intenta de nuevo.</translation>
    </message>
    <message>
        <source>Reverse distance</source>
        <translation>Dist. marcha atrás</translation>
    </message>
    <message>
        <source>Distance that it backs off.</source>
        <translation>Distancia que retrocede.</translation>
    </message>
    <message>
        <source>An external planner: a program that is called in every time step.</source>
        <translation>Un planificador externo: un programa que se llama en cada paso.</translation>
    </message>
    <message>
        <source>Timeout</source>
        <translation>Tiempo de espera</translation>
    </message>
    <message>
        <source>Maximum response time of the program in the robot&apos;s `command`.</source>
        <translation>Tiempo de respuesta máximo del programa de `command` del robot.</translation>
    </message>
    <message>
        <source>An external planner in a shared library.</source>
        <translation>Un planificador externo en una biblioteca compartida.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Shared library of the planner (hunavsim_planner.h), relative to the scenario; needs permission to run code.</source>
        <translation>Biblioteca compartida del planificador (hunavsim_planner.h), relativa al escenario; necesita permiso para ejecutar código.</translation>
    </message>
    <message>
        <source>Model predictive path integral control (Williams et al. 2017): the weighted mean of many noisy trajectories.</source>
        <translation>Control predictivo por integral de caminos (Williams et al. 2017): la media ponderada de muchas trayectorias con ruido.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>Trajectories sampled in each cycle, rounded up to a multiple of 16.</source>
        <translation>Trayectorias muestreadas en cada ciclo, redondeadas a un múltiplo de 16.</translation>
    </message>
    <message>
        <source>Time steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Time steps of each trajectory.</source>
        <translation>Pasos de cada trayectoria.</translation>
    </message>
    <message>
        <source>Model dt</source>
        <translation>dt del modelo</translation>
    </message>
    <message>
        <source>Duration of a time step of the trajectories.</source>
        <translation>Duración de un paso de las trayectorias.</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>lambda: cost difference that changes the weight of a trajectory by the factor e.</source>
        <translation>lambda: diferencia de coste que cambia el peso de una trayectoria por el factor e.</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>Weight of the control cost: lambda (1 - alpha).</source>
        <translation>Peso del coste de control: lambda (1 - alpha).</translation>
    </message>
    <message>
        <source>Linear noise</source>
        <translation>Ruido lineal</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the forward speed.</source>
        <translation>Desviación típica del ruido de la velocidad de avance.</translation>
    </message>
    <message>
        <source>Angular noise</source>
        <translation>Ruido angular</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the turn rate.</source>
        <translation>Desviación típica del ruido de la velocidad de giro.</translation>
    </message>
    <message>
        <source>Lateral noise</source>
        <translation>Ruido lateral</translation>
    </message>
    <message>
        <source>Standard deviation of the noise on the lateral speed (omnidirectional).</source>
        <translation>Desviación típica del ruido de la velocidad lateral (omnidireccional).</translation>
    </message>
    <message>
        <source>Noise time</source>
        <translation>Tiempo de ruido</translation>
    </message>
    <message>
        <source>Time in which the autocorrelation of the noise decays to 1/e; 0: white noise, as in Nav2.</source>
        <translation>Tiempo en que la autocorrelación del ruido decae a 1/e; 0: ruido blanco, como en Nav2.</translation>
    </message>
    <message>
        <source>Cost of the mean remaining distance, around walls.</source>
        <translation>Coste de la distancia media restante, alrededor de las paredes.</translation>
    </message>
    <message>
        <source>End weight</source>
        <translation>Peso final</translation>
    </message>
    <message>
        <source>Cost of the remaining distance at the end of a trajectory.</source>
        <translation>Coste de la distancia restante al final de una trayectoria.</translation>
    </message>
    <message>
        <source>Cost of a heading away from the path to the goal (not for omnidirectional robots).</source>
        <translation>Coste de una orientación que se aparta del camino al objetivo (no en robots omnidireccionales).</translation>
    </message>
    <message>
        <source>Reverse weight</source>
        <translation>Peso marcha atrás</translation>
    </message>
    <message>
        <source>Cost of the mean reverse speed (not for omnidirectional robots).</source>
        <translation>Coste de la velocidad media marcha atrás (no en robots omnidireccionales).</translation>
    </message>
    <message>
        <source>Stop weight</source>
        <translation>Peso parada</translation>
    </message>
    <message>
        <source>Cost of the squared speed inside the goal region.</source>
        <translation>Coste del cuadrado de la velocidad dentro de la región del objetivo.</translation>
    </message>
    <message>
        <source>Wall weight</source>
        <translation>Peso pared</translation>
    </message>
    <message>
        <source>Cost of contact with a wall, decreasing quadratically to 0 at wall_range.</source>
        <translation>Coste del contacto con una pared, que decrece cuadráticamente hasta 0 en wall_range.</translation>
    </message>
    <message>
        <source>Wall range</source>
        <translation>Alcance pared</translation>
    </message>
    <message>
        <source>Gap to walls beyond which the cost is 0.</source>
        <translation>Distancia a las paredes a partir de la cual el coste es 0.</translation>
    </message>
    <message>
        <source>Person weight</source>
        <translation>Peso persona</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing to 0 at person_range.</source>
        <translation>Coste del contacto con una persona, que decrece hasta 0 en person_range.</translation>
    </message>
    <message>
        <source>Person range</source>
        <translation>Alcance persona</translation>
    </message>
    <message>
        <source>Gap to a person beyond which the cost is 0.</source>
        <translation>Distancia a una persona a partir de la cual el coste es 0.</translation>
    </message>
    <message>
        <source>Person margin</source>
        <translation>Margen persona</translation>
    </message>
    <message>
        <source>A smaller gap to a person counts as a contact.</source>
        <translation>Una distancia menor a una persona cuenta como contacto.</translation>
    </message>
    <message>
        <source>Contact weight</source>
        <translation>Peso contacto</translation>
    </message>
    <message>
        <source>Cost of contact with a person or an obstacle along the whole trajectory.</source>
        <translation>Coste del contacto con una persona o un obstáculo a lo largo de toda la trayectoria.</translation>
    </message>
    <message>
        <source>Cost of accelerating at the limits of the drive along the whole trajectory.</source>
        <translation>Coste de cambiar la velocidad en los límites de la tracción todo el tiempo.</translation>
    </message>
    <message>
        <source>Learned policy in an ONNX file, computed on the CPU by OpenCV.</source>
        <translation>Política aprendida en un archivo ONNX, que OpenCV calcula en la CPU.</translation>
    </message>
    <message>
        <source>ONNX file of a policy that was trained with hunavsim.env, with its options as metadata; relative to the scenario.</source>
        <translation>Archivo ONNX de una política entrenada con hunavsim.env, con sus opciones como metadatos; relativo al escenario.</translation>
    </message>
    <message>
        <source>Optimal reciprocal collision avoidance (ORCA) for the kinematics of the robot (NH-ORCA).</source>
        <translation>Evitación recíproca óptima de colisiones (ORCA) para la cinemática del robot (NH-ORCA).</translation>
    </message>
    <message>
        <source>tau: time for which the selected velocity is free of collisions with people and robots.</source>
        <translation>tau: tiempo durante el cual la velocidad elegida está libre de colisiones con personas y robots.</translation>
    </message>
    <message>
        <source>Wall horizon</source>
        <translation>Horizonte pared</translation>
    </message>
    <message>
        <source>Time for which the selected velocity is free of collisions with walls.</source>
        <translation>Tiempo durante el cual la velocidad elegida está libre de colisiones con paredes.</translation>
    </message>
    <message>
        <source>Tracking error</source>
        <translation>Error seguimiento</translation>
    </message>
    <message>
        <source>epsilon: maximum distance of the robot from the position that results from the selected velocity; less beside people and walls. Its radius is enlarged by this. Not for omnidirectional robots.</source>
        <translation>epsilon: distancia máxima del robot a la posición que resulta de la velocidad elegida; menor junto a personas y paredes. Su radio se amplía en este valor. No en robots omnidireccionales.</translation>
    </message>
    <message>
        <source>Turn time</source>
        <translation>Tiempo de giro</translation>
    </message>
    <message>
        <source>T: time in which the robot turns into the direction of the selected velocity, unless its angular acceleration takes longer.</source>
        <translation>T: tiempo en que el robot gira hacia la dirección de la velocidad elegida, salvo que su aceleración angular requiera más.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Share of the avoidance of a person that the robot takes: 0.5: people take the other half, 1: people do not avoid.</source>
        <translation>Parte de la evitación de una persona que asume el robot: 0.5: las personas asumen la otra mitad, 1: las personas no evitan.</translation>
    </message>
    <message>
        <source>Robot share</source>
        <translation>Parte robot</translation>
    </message>
    <message>
        <source>Share of the avoidance of another robot that the robot takes.</source>
        <translation>Parte de la evitación de otro robot que asume el robot.</translation>
    </message>
    <message>
        <source>Distance to people and robots in addition to both radii.</source>
        <translation>Distancia a personas y robots además de ambos radios.</translation>
    </message>
    <message>
        <source>People and robots farther away are ignored.</source>
        <translation>Se ignoran las personas y los robots más lejanos.</translation>
    </message>
    <message>
        <source>Lookahead</source>
        <translation>Anticipación</translation>
    </message>
    <message>
        <source>Distance along the route to the target point; at least 1.5 turning radii.</source>
        <translation>Distancia a lo largo de la ruta hasta el punto de destino; al menos 1.5 radios de giro.</translation>
    </message>
    <message>
        <source>Side preference</source>
        <translation>Lado preferido</translation>
    </message>
    <message>
        <source>Rotation of the desired velocity to the right if people are in its way.</source>
        <translation>Rotación de la velocidad deseada hacia la derecha si hay personas en su camino.</translation>
    </message>
    <message>
        <source>Pure pursuit of the route (Coulter 1992); slows down for people ahead.</source>
        <translation>Persecución pura de la ruta (Coulter 1992); reduce la velocidad ante personas.</translation>
    </message>
    <message>
        <source>Distance along the path to the target point.</source>
        <translation>Distancia a lo largo del camino hasta el punto de destino.</translation>
    </message>
    <message>
        <source>Stop distance</source>
        <translation>Dist. de parada</translation>
    </message>
    <message>
        <source>Gap to a person ahead at which the robot stops.</source>
        <translation>Distancia a una persona delante a la que el robot se detiene.</translation>
    </message>
    <message>
        <source>Replays recorded velocities and ignores obstacles.</source>
        <translation>Reproduce velocidades grabadas e ignora los obstáculos.</translation>
    </message>
    <message>
        <source>CSV with time,linear,angular and optionally lateral, or the trajectory.csv of a run; relative to the scenario.</source>
        <translation>CSV con time,linear,angular y opcionalmente lateral, o el trajectory.csv de una ejecución; relativo al escenario.</translation>
    </message>
    <message>
        <source>Id of the robot whose velocities are read from a trajectory.csv.</source>
        <translation>Id del robot cuyas velocidades se leen de un trajectory.csv.</translation>
    </message>
    <message>
        <source>Moves like a person of the social force model.</source>
        <translation>Se mueve como una persona del modelo de fuerzas sociales.</translation>
    </message>
    <message>
        <source>Goal factor</source>
        <translation>Factor objetivo</translation>
    </message>
    <message>
        <source>k_g: weight of the attractive force along the route.</source>
        <translation>k_g: peso de la fuerza de atracción a lo largo de la ruta.</translation>
    </message>
    <message>
        <source>Relaxation time</source>
        <translation>T. de relajación</translation>
    </message>
    <message>
        <source>tau: relaxation time of the velocity towards the desired one.</source>
        <translation>tau: tiempo de relajación de la velocidad hacia la deseada.</translation>
    </message>
    <message>
        <source>Obstacle factor</source>
        <translation>Factor obstáculo</translation>
    </message>
    <message>
        <source>k_o: force of a wall in contact with the robot. It turns the robot aside, never back.</source>
        <translation>k_o: fuerza de una pared en contacto con el robot. Desvía el robot, nunca lo empuja hacia atrás.</translation>
    </message>
    <message>
        <source>Obstacle range</source>
        <translation>Alcance obstáculo</translation>
    </message>
    <message>
        <source>sigma: distance over which the force of walls decays to 1/e.</source>
        <translation>sigma: distancia en que la fuerza de las paredes decae a 1/e.</translation>
    </message>
    <message>
        <source>Social factor</source>
        <translation>Factor social</translation>
    </message>
    <message>
        <source>k_s: weight of the forces of people and robots.</source>
        <translation>k_s: peso de las fuerzas de personas y robots.</translation>
    </message>
    <message>
        <source>Lambda</source>
        <translation>Lambda</translation>
    </message>
    <message>
        <source>Weight of the relative velocity in the direction of an interaction.</source>
        <translation>Peso de la velocidad relativa en la dirección de una interacción.</translation>
    </message>
    <message>
        <source>Range of an interaction per length of the interaction vector.</source>
        <translation>Alcance de una interacción por longitud del vector de interacción.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Angular width of the evasion term.</source>
        <translation>Ancho angular del término de evasión.</translation>
    </message>
    <message>
        <source>N prime</source>
        <translation>N prima</translation>
    </message>
    <message>
        <source>Angular width of the deceleration term.</source>
        <translation>Ancho angular del término de deceleración.</translation>
    </message>
    <message>
        <source>Epsilon</source>
        <translation>Épsilon</translation>
    </message>
    <message>
        <source>Bias to one side for people who meet head-on.</source>
        <translation>Sesgo hacia un lado para personas que se encuentran de frente.</translation>
    </message>
    <message>
        <source>Desired speed</source>
        <translation>Vel. deseada</translation>
    </message>
    <message>
        <source>v_0: desired speed, limited by the drive.</source>
        <translation>v_0: velocidad deseada, limitada por la tracción.</translation>
    </message>
    <message>
        <source>T: time in which the robot turns into the direction of the desired velocity, unless its angular acceleration takes longer.</source>
        <translation>T: tiempo en que el robot gira hacia la dirección de la velocidad deseada, salvo que su aceleración angular requiera más.</translation>
    </message>
    <message>
        <source>Gap to a person below which the robot does not approach.</source>
        <translation>Distancia a una persona por debajo de la cual el robot no se acerca.</translation>
    </message>
    <message>
        <source>Slow time</source>
        <translation>Tiempo lento</translation>
    </message>
    <message>
        <source>The approach speed to a person is at most the gap beyond the stop distance divided by this time.</source>
        <translation>La velocidad de acercamiento a una persona es como máximo la distancia más allá de la de parada dividida por este tiempo.</translation>
    </message>
    <message>
        <source>Distance along the route to the attracting point; at least 1.5 turning radii.</source>
        <translation>Distancia a lo largo de la ruta hasta el punto de atracción; al menos 1.5 radios de giro.</translation>
    </message>
    <message>
        <source>MPPI that predicts people, yields to them and avoids groups.</source>
        <translation>MPPI que predice a las personas, les cede el paso y evita los grupos.</translation>
    </message>
    <message>
        <source>Prediction</source>
        <translation>Predicción</translation>
    </message>
    <message>
        <source>Prediction of people: 0: constant velocity, 1: social force model with walls and the robot&apos;s plan.</source>
        <translation>Predicción de personas: 0: velocidad constante, 1: modelo de fuerzas sociales con paredes y el plan del robot.</translation>
    </message>
    <message>
        <source>Intimate weight</source>
        <translation>Peso íntimo</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing linearly to 0 at a gap of 0.45 m.</source>
        <translation>Coste del contacto con una persona, que decrece linealmente hasta 0 a una distancia de 0.45 m.</translation>
    </message>
    <message>
        <source>Personal weight</source>
        <translation>Peso personal</translation>
    </message>
    <message>
        <source>Cost of contact with a person, decreasing quadratically to 0 at a gap of 1.2 m.</source>
        <translation>Coste del contacto con una persona, que decrece cuadráticamente hasta 0 a una distancia de 1.2 m.</translation>
    </message>
    <message>
        <source>Space weight</source>
        <translation>Peso espacio</translation>
    </message>
    <message>
        <source>Cost at the centre of the personal space: a Gaussian that is longer in front of walking people.</source>
        <translation>Coste en el centro del espacio personal: una gaussiana más larga delante de quien camina.</translation>
    </message>
    <message>
        <source>Group weight</source>
        <translation>Peso grupo</translation>
    </message>
    <message>
        <source>Cost at the centre of the space shared by two people who stand face to face.</source>
        <translation>Coste en el centro del espacio compartido por dos personas frente a frente.</translation>
    </message>
    <message>
        <source>Ttc weight</source>
        <translation>Peso ttc</translation>
    </message>
    <message>
        <source>Cost of approaching a person nearby, with the square of ttc_limit / time - 1.</source>
        <translation>Coste de acercarse a una persona próxima, con el cuadrado de ttc_limit / tiempo - 1.</translation>
    </message>
    <message>
        <source>Ttc limit</source>
        <translation>Límite ttc</translation>
    </message>
    <message>
        <source>Time to collision at the current closing speed above which the cost is 0.</source>
        <translation>Tiempo hasta la colisión a la velocidad de acercamiento actual por encima del cual el coste es 0.</translation>
    </message>
    <message>
        <source>Relative speed weight</source>
        <translation>Peso vel. relativa</translation>
    </message>
    <message>
        <source>Cost of the squared relative speed beside a person, decreasing to 0 at a gap of 1.2 m.</source>
        <translation>Coste del cuadrado de la velocidad relativa junto a una persona, que decrece hasta 0 a una distancia de 1.2 m.</translation>
    </message>
    <message>
        <source>Front weight</source>
        <translation>Peso frontal</translation>
    </message>
    <message>
        <source>Cost of a position where a person is about to walk; the robot passes behind people.</source>
        <translation>Coste de una posición por la que una persona está a punto de pasar; el robot pasa por detrás de las personas.</translation>
    </message>
    <message>
        <source>Front time</source>
        <translation>Tiempo frontal</translation>
    </message>
    <message>
        <source>Walking time that this area extends in front of a person.</source>
        <translation>Tiempo de marcha que esta área se extiende delante de una persona.</translation>
    </message>
    <message>
        <source>Legibility weight</source>
        <translation>Peso legibilidad</translation>
    </message>
    <message>
        <source>Cost of not showing early on which side the robot will pass an oncoming person; the beginning of a trajectory has the largest weight.</source>
        <translation>Coste de no mostrar pronto por qué lado pasará el robot a una persona que viene de frente; el comienzo de una trayectoria pesa más.</translation>
    </message>
    <message>
        <source>Patience weight</source>
        <translation>Peso paciencia</translation>
    </message>
    <message>
        <source>Cost of standing in a narrow passage that a person is about to use.</source>
        <translation>Coste de estar en un paso estrecho que una persona está a punto de usar.</translation>
    </message>
    <message>
        <source>Wait distance</source>
        <translation>Dist. de espera</translation>
    </message>
    <message>
        <source>Distance from the narrow passage at which the robot waits.</source>
        <translation>Distancia al paso estrecho a la que el robot espera.</translation>
    </message>
    <message>
        <source>Patience time</source>
        <translation>T. de paciencia</translation>
    </message>
    <message>
        <source>Waiting time after which the robot enters the passage anyway.</source>
        <translation>Tiempo de espera tras el cual el robot entra en el paso de todos modos.</translation>
    </message>
    <message>
        <source>Drives straight to the goal and avoids nothing: a baseline that no test should accept.</source>
        <translation>Va recto al objetivo y no evita nada: una referencia que ninguna prueba debería aceptar.</translation>
    </message>
    <message>
        <source>Manual drive: stands still until the user drives it. Ignores people.</source>
        <translation>Conducción manual: parado hasta que el usuario lo conduce. Ignora a las personas.</translation>
    </message>
    <message>
        <source>Speed share</source>
        <translation>Parte de velocidad</translation>
    </message>
    <message>
        <source>Share of the maximum speed and turn rate that the robot uses at most.</source>
        <translation>Parte de la velocidad y del giro máximos que el robot usa como mucho.</translation>
    </message>
    <message>
        <source>Time after the last command after which the robot stops; 0: it continues.</source>
        <translation>Tiempo tras la última orden después del cual el robot se detiene; 0: continúa.</translation>
    </message>
    <message>
        <source>Driven by the ROS 2 topic /cmd_vel with run --ros2; otherwise it stands still.</source>
        <translation>Lo conduce el topic /cmd_vel de ROS 2 con run --ros2; si no, está parado.</translation>
    </message>
    <message>
        <source>Nav2 without ROS: uses your nav2_params.yaml and navigator tree.</source>
        <translation>Nav2 sin ROS: usa su nav2_params.yaml y el árbol del navegador.</translation>
    </message>
    <message>
        <source>Latency scan</source>
        <translation>Latencia barrido</translation>
    </message>
    <message>
        <source>Time steps from the lidar to the costmaps.</source>
        <translation>Pasos desde el lidar hasta los mapas de costes.</translation>
    </message>
    <message>
        <source>Latency planner</source>
        <translation>Latencia planific.</translation>
    </message>
    <message>
        <source>Time steps from a request to its path.</source>
        <translation>Pasos desde una petición hasta su camino.</translation>
    </message>
    <message>
        <source>Latency command</source>
        <translation>Latencia orden</translation>
    </message>
    <message>
        <source>Time steps from the last server to the wheels.</source>
        <translation>Pasos desde el último servidor hasta las ruedas.</translation>
    </message>
    <message>
        <source>Waypoint tasks</source>
        <translation>Tareas de paso</translation>
    </message>
    <message>
        <source>1: the robot drives to several goals one by one and executes the task of waypoint_follower at each.</source>
        <translation>1: el robot va a varios objetivos uno por uno y ejecuta en cada uno la tarea de waypoint_follower.</translation>
    </message>
    <message>
        <source>Crowd model of this program: social forces whose density, flow and lanes are close to measurements.</source>
        <translation>Modelo de multitudes de este programa: fuerzas sociales cuya densidad, flujo y filas se acercan a las mediciones.</translation>
    </message>
    <message>
        <source>Gaze factor</source>
        <translation>Factor de mirada</translation>
    </message>
    <message>
        <source>Weight of the gaze force: turning back to group members behind.</source>
        <translation>Peso de la fuerza de mirada: girarse hacia los miembros del grupo que van detrás.</translation>
    </message>
    <message>
        <source>Coherence factor</source>
        <translation>Factor coherencia</translation>
    </message>
    <message>
        <source>Weight of the attraction to the centre of the group.</source>
        <translation>Peso de la atracción hacia el centro del grupo.</translation>
    </message>
    <message>
        <source>Repulsion factor</source>
        <translation>Factor repulsión</translation>
    </message>
    <message>
        <source>Weight of the repulsion between group members.</source>
        <translation>Peso de la repulsión entre miembros del grupo.</translation>
    </message>
    <message>
        <source>Time gap</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>T: time gap to the person straight ahead.</source>
        <translation>T: intervalo de tiempo con la persona que va justo delante.</translation>
    </message>
    <message>
        <source>Cap width</source>
        <translation>Ancho frontal</translation>
    </message>
    <message>
        <source>Tangent of the angle from the walking direction that counts as ahead.</source>
        <translation>Tangente del ángulo con la dirección de marcha que cuenta como delante.</translation>
    </message>
    <message>
        <source>Co moving weight</source>
        <translation>Peso co-mov.</translation>
    </message>
    <message>
        <source>Share of the force between people with equal velocities.</source>
        <translation>Parte de la fuerza entre personas con velocidades iguales.</translation>
    </message>
    <message>
        <source>Full weight at</source>
        <translation>Peso pleno a</translation>
    </message>
    <message>
        <source>Relative speed above which the force between people has full weight.</source>
        <translation>Velocidad relativa a partir de la cual la fuerza entre personas tiene peso pleno.</translation>
    </message>
    <message>
        <source>Intent share</source>
        <translation>Parte intención</translation>
    </message>
    <message>
        <source>Share of the desired velocity in the velocity that people react to.</source>
        <translation>Parte de la velocidad deseada en la velocidad a la que reaccionan las personas.</translation>
    </message>
    <message>
        <source>Lane factor</source>
        <translation>Factor de filas</translation>
    </message>
    <message>
        <source>Strength of lane formation in counterflow.</source>
        <translation>Intensidad de la formación de filas en contraflujo.</translation>
    </message>
    <message>
        <source>File share</source>
        <translation>Parte en fila</translation>
    </message>
    <message>
        <source>Share of people with the same walking direction in the lane force.</source>
        <translation>Parte de personas con la misma dirección de marcha en la fuerza de filas.</translation>
    </message>
    <message>
        <source>Crowd scale</source>
        <translation>Escala multitud</translation>
    </message>
    <message>
        <source>Crowding ahead at which the crowd-only terms have half of their effect.</source>
        <translation>Aglomeración delante a la que los términos exclusivos de multitud tienen la mitad de su efecto.</translation>
    </message>
    <message>
        <source>Braking share</source>
        <translation>Parte de frenado</translation>
    </message>
    <message>
        <source>Share of the braking for oncoming people that remains in a crowd.</source>
        <translation>Parte del frenado ante personas de frente que queda en una multitud.</translation>
    </message>
    <message>
        <source>Yield speed</source>
        <translation>Vel. de separación</translation>
    </message>
    <message>
        <source>Speed at which people in contact separate.</source>
        <translation>Velocidad a la que se separan las personas en contacto.</translation>
    </message>
    <message>
        <source>Yield gap</source>
        <translation>Dist. separación</translation>
    </message>
    <message>
        <source>Gap up to which neighbours count as in contact.</source>
        <translation>Distancia hasta la cual los vecinos cuentan como en contacto.</translation>
    </message>
    <message>
        <source>Push back limit</source>
        <translation>Límite empuje</translation>
    </message>
    <message>
        <source>Maximum backward force of walls, as a share of the goal force.</source>
        <translation>Fuerza máxima hacia atrás de las paredes, como parte de la fuerza del objetivo.</translation>
    </message>
    <message>
        <source>Crowd wall share</source>
        <translation>Parte pared</translation>
    </message>
    <message>
        <source>Share of the force of walls beside narrow passages that remains in a crowd.</source>
        <translation>Parte de la fuerza de las paredes junto a pasos estrechos que queda en una multitud.</translation>
    </message>
    <message>
        <source>Mate turn width</source>
        <translation>Ancho compañeros</translation>
    </message>
    <message>
        <source>Angle below which group members side by side evade each other less.</source>
        <translation>Ángulo por debajo del cual los miembros del grupo uno junto a otro se esquivan menos.</translation>
    </message>
    <message>
        <source>Optimal reciprocal collision avoidance (van den Berg et al. 2011): the collision-free velocity closest to the desired one.</source>
        <translation>Evitación recíproca óptima de colisiones (van den Berg et al. 2011): la velocidad sin colisiones más próxima a la deseada.</translation>
    </message>
    <message>
        <source>tau: time for which velocities are free of collisions with people.</source>
        <translation>tau: tiempo durante el cual las velocidades están libres de colisiones con personas.</translation>
    </message>
    <message>
        <source>Obstacle horizon</source>
        <translation>Horizonte obst.</translation>
    </message>
    <message>
        <source>Time for which velocities are free of collisions with walls.</source>
        <translation>Tiempo durante el cual las velocidades están libres de colisiones con paredes.</translation>
    </message>
    <message>
        <source>People farther away are ignored.</source>
        <translation>Se ignoran las personas más lejanas.</translation>
    </message>
    <message>
        <source>Braking time</source>
        <translation>Tiempo de frenado</translation>
    </message>
    <message>
        <source>Time in which people without a goal come to a stop.</source>
        <translation>Tiempo en que se detienen las personas sin objetivo.</translation>
    </message>
    <message>
        <source>Rotation of the desired velocity to the right if the path is not free.</source>
        <translation>Rotación de la velocidad deseada hacia la derecha si el camino no está libre.</translation>
    </message>
    <message>
        <source>The social force model of HuNavSim (Moussaïd et al. 2009, 2010) with its errors corrected.</source>
        <translation>El modelo de fuerzas sociales de HuNavSim (Moussaïd et al. 2009, 2010) con sus errores corregidos.</translation>
    </message>
    <message>
        <source>The social force model of HuNavSim 2.0 unchanged, for comparison with its results.</source>
        <translation>El modelo de fuerzas sociales de HuNavSim 2.0 sin cambios, para comparar con sus resultados.</translation>
    </message>
    <message>
        <source>Generic robot</source>
        <translation>Genérico</translation>
    </message>
    <message>
        <source>Navigation Performance</source>
        <translation>Rendimiento de navegación</translation>
    </message>
    <message>
        <source>Social Behavior</source>
        <translation>Comportamiento social</translation>
    </message>
    <message>
        <source>Motion Analysis</source>
        <translation>Análisis del movimiento</translation>
    </message>
    <message>
        <source>Safety &amp; Collisions</source>
        <translation>Seguridad y colisiones</translation>
    </message>
    <message>
        <source>Social Forces</source>
        <translation>Fuerzas sociales</translation>
    </message>
    <message>
        <source>Danger &amp; Surprise Metrics</source>
        <translation>Métricas de peligro y sorpresa</translation>
    </message>
    <message>
        <source>Time to reach the goal</source>
        <translation>Tiempo hasta el objetivo</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longitud del camino</translation>
    </message>
    <message>
        <source>Cumulative heading changes</source>
        <translation>Cambios de orientación acumulados</translation>
    </message>
    <message>
        <source>Mean distance to the closest person</source>
        <translation>Distancia media a la persona más cercana</translation>
    </message>
    <message>
        <source>Smallest distance to people</source>
        <translation>Distancia mínima a personas</translation>
    </message>
    <message>
        <source>Largest distance to people</source>
        <translation>Distancia máxima a personas</translation>
    </message>
    <message>
        <source>Intrusions into the intimate space</source>
        <translation>Intrusiones en el espacio íntimo</translation>
    </message>
    <message>
        <source>Intrusions into the personal space</source>
        <translation>Intrusiones en el espacio personal</translation>
    </message>
    <message>
        <source>Intrusions into the social space</source>
        <translation>Intrusiones en el espacio social</translation>
    </message>
    <message>
        <source>Intrusions into the intimate space of groups</source>
        <translation>Intrusiones en el espacio íntimo de grupos</translation>
    </message>
    <message>
        <source>Intrusions into the personal space of groups</source>
        <translation>Intrusiones en el espacio personal de grupos</translation>
    </message>
    <message>
        <source>Intrusions into the social space of groups</source>
        <translation>Intrusiones en el espacio social de grupos</translation>
    </message>
    <message>
        <source>Goal reached</source>
        <translation>Objetivo alcanzado</translation>
    </message>
    <message>
        <source>Smallest distance to the goal</source>
        <translation>Distancia mínima al objetivo</translation>
    </message>
    <message>
        <source>Final distance to the goal</source>
        <translation>Distancia final al objetivo</translation>
    </message>
    <message>
        <source>Robot runs into a person</source>
        <translation>El robot choca con una persona</translation>
    </message>
    <message>
        <source>Person runs into the robot</source>
        <translation>Una persona choca con el robot</translation>
    </message>
    <message>
        <source>Time standing still</source>
        <translation>Tiempo parado</translation>
    </message>
    <message>
        <source>Mean speed of the robot</source>
        <translation>Velocidad media del robot</translation>
    </message>
    <message>
        <source>Mean turn rate of the robot</source>
        <translation>Velocidad de giro media del robot</translation>
    </message>
    <message>
        <source>Mean acceleration of the robot</source>
        <translation>Aceleración media del robot</translation>
    </message>
    <message>
        <source>Mean jerk of the robot</source>
        <translation>Sacudida media del robot</translation>
    </message>
    <message>
        <source>Mean speed of people</source>
        <translation>Velocidad media de las personas</translation>
    </message>
    <message>
        <source>Mean speed of the closest person</source>
        <translation>Velocidad media de la persona más cercana</translation>
    </message>
    <message>
        <source>Social force of the robot on people</source>
        <translation>Fuerza social del robot sobre las personas</translation>
    </message>
    <message>
        <source>Social force of people on the robot</source>
        <translation>Fuerza social de las personas sobre el robot</translation>
    </message>
    <message>
        <source>Social work</source>
        <translation>Trabajo social</translation>
    </message>
    <message>
        <source>Obstacle force on the robot</source>
        <translation>Fuerza de obstáculos sobre el robot</translation>
    </message>
    <message>
        <source>Obstacle force on people</source>
        <translation>Fuerza de obstáculos sobre las personas</translation>
    </message>
    <message>
        <source>Danger: fear</source>
        <translation>Peligro: miedo</translation>
    </message>
    <message>
        <source>Danger: panic</source>
        <translation>Peligro: pánico</translation>
    </message>
    <message>
        <source>Surprise: visibility</source>
        <translation>Sorpresa: visibilidad</translation>
    </message>
    <message>
        <source>Surprise: shock</source>
        <translation>Sorpresa: sobresalto</translation>
    </message>
    <message>
        <source>Surprise: reaction</source>
        <translation>Sorpresa: reacción</translation>
    </message>
    <message>
        <source>Smallest clearance</source>
        <translation>Holgura mínima</translation>
    </message>
    <message>
        <source>Mean clearance</source>
        <translation>Holgura media</translation>
    </message>
    <message>
        <source>Time too close to obstacles</source>
        <translation>Tiempo demasiado cerca de obstáculos</translation>
    </message>
    <message>
        <source>Winding around people</source>
        <translation>Vueltas alrededor de personas</translation>
    </message>
    <message>
        <source>Replans of the robot</source>
        <translation>Replanificaciones del robot</translation>
    </message>
    <message>
        <source>Aggregated time to the goals</source>
        <translation>Tiempo agregado hasta los objetivos</translation>
    </message>
    <message>
        <source>Mean distance to the goal while stopped</source>
        <translation>Distancia media al objetivo parado</translation>
    </message>
    <message>
        <source>Density around people</source>
        <translation>Densidad alrededor de las personas</translation>
    </message>
    <message>
        <source>Voronoi density</source>
        <translation>Densidad de Voronoi</translation>
    </message>
    <message>
        <source>Voronoi density, largest sample</source>
        <translation>Densidad de Voronoi, muestra máxima</translation>
    </message>
    <message>
        <source>Specific flow of the crowd</source>
        <translation>Flujo específico de la multitud</translation>
    </message>
    <message>
        <source>Crowd polarisation</source>
        <translation>Polarización de la multitud</translation>
    </message>
    <message>
        <source>Crowd lane order</source>
        <translation>Orden de filas de la multitud</translation>
    </message>
    <message>
        <source>Danger: fear, mean per sample</source>
        <translation>Peligro: miedo, media por muestra</translation>
    </message>
    <message>
        <source>Danger: panic, mean per sample</source>
        <translation>Peligro: pánico, media por muestra</translation>
    </message>
    <message>
        <source>Time facing people</source>
        <translation>Tiempo mirando a personas</translation>
    </message>
    <message>
        <source>Time seen by people</source>
        <translation>Tiempo visto por personas</translation>
    </message>
    <message>
        <source>Time facing people, 60 degrees</source>
        <translation>Tiempo mirando a personas, 60 grados</translation>
    </message>
    <message>
        <source>Time seen by people, 60 degrees</source>
        <translation>Tiempo visto por personas, 60 grados</translation>
    </message>
    <message>
        <source>Direction of the nearest person at the end</source>
        <translation>Dirección de la persona más cercana al final</translation>
    </message>
    <message>
        <source>Distance of the nearest person at the end</source>
        <translation>Distancia de la persona más cercana al final</translation>
    </message>
    <message>
        <source>Speed of the nearest person at the end</source>
        <translation>Velocidad de la persona más cercana al final</translation>
    </message>
    <message>
        <source>People near the robot at the end</source>
        <translation>Personas cerca del robot al final</translation>
    </message>
    <message>
        <source>Line crossings by people</source>
        <translation>Cruces de la línea por personas</translation>
    </message>
    <message>
        <source>Flow through the line</source>
        <translation>Flujo a través de la línea</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space</source>
        <translation>Intrusión en el espacio personal gaussiano</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space, smallest</source>
        <translation>Intrusión en el espacio personal gaussiano, mínima</translation>
    </message>
    <message>
        <source>Intrusion into the Gaussian personal space, largest</source>
        <translation>Intrusión en el espacio personal gaussiano, máxima</translation>
    </message>
    <message>
        <source>Time inside the Gaussian personal space</source>
        <translation>Tiempo en el espacio personal gaussiano</translation>
    </message>
    <message>
        <source>Intrusion into the space of groups</source>
        <translation>Intrusión en el espacio de grupos</translation>
    </message>
    <message>
        <source>Intrusion into the space of groups, largest</source>
        <translation>Intrusión en el espacio de grupos, máxima</translation>
    </message>
    <message>
        <source>Group crossings</source>
        <translation>Cruces de grupos</translation>
    </message>
    <message>
        <source>Disturbance by the robot&apos;s heading</source>
        <translation>Molestia por la orientación del robot</translation>
    </message>
    <message>
        <source>Disturbance by the robot&apos;s heading, largest</source>
        <translation>Molestia por la orientación del robot, máxima</translation>
    </message>
    <message>
        <source>Time hardly moving</source>
        <translation>Tiempo casi sin moverse</translation>
    </message>
    <message>
        <source>Time driving backwards</source>
        <translation>Tiempo marcha atrás</translation>
    </message>
    <message>
        <source>Time rotating in place</source>
        <translation>Tiempo girando en el sitio</translation>
    </message>
    <message>
        <source>Success</source>
        <translation>Éxito</translation>
    </message>
    <message>
        <source>Duration of the record</source>
        <translation>Duración del registro</translation>
    </message>
    <message>
        <source>Robot runs into an obstacle</source>
        <translation>El robot choca con un obstáculo</translation>
    </message>
    <message>
        <source>Success weighted by path length</source>
        <translation>Éxito ponderado por longitud del camino</translation>
    </message>
    <message>
        <source>Success weighted by time</source>
        <translation>Éxito ponderado por tiempo</translation>
    </message>
    <message>
        <source>Path efficiency</source>
        <translation>Eficiencia del camino</translation>
    </message>
    <message>
        <source>Path irregularity</source>
        <translation>Irregularidad del camino</translation>
    </message>
    <message>
        <source>Turning per metre</source>
        <translation>Giro por metro</translation>
    </message>
    <message>
        <source>Mean curvature</source>
        <translation>Curvatura media</translation>
    </message>
    <message>
        <source>Largest curvature</source>
        <translation>Curvatura máxima</translation>
    </message>
    <message>
        <source>Mean roughness</source>
        <translation>Rugosidad media</translation>
    </message>
    <message>
        <source>Smallest time to collision</source>
        <translation>Tiempo mínimo hasta la colisión</translation>
    </message>
    <message>
        <source>Personal space compliance</source>
        <translation>Respeto del espacio personal</translation>
    </message>
    <message>
        <source>Discomfort frequency</source>
        <translation>Frecuencia de incomodidad</translation>
    </message>
    <message>
        <source>Mean distance during discomfort</source>
        <translation>Distancia media durante la incomodidad</translation>
    </message>
    <message>
        <source>Time in personal space</source>
        <translation>Tiempo en el espacio personal</translation>
    </message>
    <message>
        <source>Mean speed in personal space</source>
        <translation>Velocidad media en el espacio personal</translation>
    </message>
    <message>
        <source>Largest speed in intimate space</source>
        <translation>Velocidad máxima en el espacio íntimo</translation>
    </message>
    <message>
        <source>Steps away from the goal</source>
        <translation>Pasos que alejan del objetivo</translation>
    </message>
    <message>
        <source>Time stalled</source>
        <translation>Tiempo detenido</translation>
    </message>
    <message>
        <source>Remaining share of the distance</source>
        <translation>Parte restante de la distancia</translation>
    </message>
    <message>
        <source>Final distance per path length</source>
        <translation>Distancia final por longitud del camino</translation>
    </message>
    <message>
        <source>Mean displacement from the reference</source>
        <translation>Desplazamiento medio de la referencia</translation>
    </message>
    <message>
        <source>Final displacement from the reference</source>
        <translation>Desplazamiento final de la referencia</translation>
    </message>
    <message>
        <source>DTW distance from the reference</source>
        <translation>Distancia DTW a la referencia</translation>
    </message>
    <message>
        <source>Mean distance from the reference path</source>
        <translation>Distancia media al camino de referencia</translation>
    </message>
    <message>
        <source>Responsibility of the robot</source>
        <translation>Responsabilidad del robot</translation>
    </message>
    <message>
        <source>Engagement of the robot</source>
        <translation>Implicación del robot</translation>
    </message>
    <message>
        <source>Social force of the robot on people, mean per sample</source>
        <translation>Fuerza social del robot sobre las personas, media por muestra</translation>
    </message>
    <message>
        <source>Social force of people on the robot, mean per sample</source>
        <translation>Fuerza social de las personas sobre el robot, media por muestra</translation>
    </message>
    <message>
        <source>Social work, mean per sample</source>
        <translation>Trabajo social, media por muestra</translation>
    </message>
    <message>
        <source>Obstacle force on the robot, mean per sample</source>
        <translation>Fuerza de obstáculos sobre el robot, media por muestra</translation>
    </message>
    <message>
        <source>Obstacle force on people, mean per sample</source>
        <translation>Fuerza de obstáculos sobre las personas, media por muestra</translation>
    </message>
    <message>
        <source>Smallest speed of the robot</source>
        <translation>Velocidad mínima del robot</translation>
    </message>
    <message>
        <source>Largest speed of the robot</source>
        <translation>Velocidad máxima del robot</translation>
    </message>
    <message>
        <source>Largest acceleration of the robot</source>
        <translation>Aceleración máxima del robot</translation>
    </message>
    <message>
        <source>Largest jerk of the robot</source>
        <translation>Sacudida máxima del robot</translation>
    </message>
    <message>
        <source>Mean angular acceleration of the robot</source>
        <translation>Aceleración angular media del robot</translation>
    </message>
    <message>
        <source>Motion energy</source>
        <translation>Energía de movimiento</translation>
    </message>
    <message>
        <source>Surprise: visibility, mean per sample</source>
        <translation>Sorpresa: visibilidad, media por muestra</translation>
    </message>
    <message>
        <source>Surprise: shock, mean per sample</source>
        <translation>Sorpresa: sobresalto, media por muestra</translation>
    </message>
    <message>
        <source>Surprise: reaction, mean per sample</source>
        <translation>Sorpresa: reacción, media por muestra</translation>
    </message>
    <message>
        <source>Mean time to collision</source>
        <translation>Tiempo medio hasta la colisión</translation>
    </message>
    <message>
        <source>Time exposed to collisions</source>
        <translation>Tiempo expuesto a colisiones</translation>
    </message>
    <message>
        <source>Time-integrated threat of collisions</source>
        <translation>Amenaza de colisión integrada en el tiempo</translation>
    </message>
    <message>
        <source>Mean passing distance</source>
        <translation>Distancia media de paso</translation>
    </message>
    <message>
        <source>Largest approach speed</source>
        <translation>Velocidad máxima de acercamiento</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Aceleración lateral máxima</translation>
    </message>
    <message>
        <source>Entries into the intimate zone</source>
        <translation>Entradas en la zona íntima</translation>
    </message>
    <message>
        <source>Entries of the robot into the intimate zone</source>
        <translation>Entradas del robot en la zona íntima</translation>
    </message>
    <message>
        <source>Entries of people into the intimate zone</source>
        <translation>Entradas de personas en la zona íntima</translation>
    </message>
    <message>
        <source>Entries into the personal zone</source>
        <translation>Entradas en la zona personal</translation>
    </message>
    <message>
        <source>Entries of the robot into the personal zone</source>
        <translation>Entradas del robot en la zona personal</translation>
    </message>
    <message>
        <source>Entries of people into the personal zone</source>
        <translation>Entradas de personas en la zona personal</translation>
    </message>
    <message>
        <source>so far</source>
        <translation>hasta ahora</translation>
    </message>
    <message>
        <source>per step</source>
        <translation>por paso</translation>
    </message>
    <message>
        <source>count per step</source>
        <translation>cuenta por paso</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Control</translation>
    </message>
    <message>
        <source>Runs the children in order until one fails; resumes at the running child.</source>
        <translation>Ejecuta los hijos en orden hasta que uno falla; continúa en el hijo en ejecución.</translation>
    </message>
    <message>
        <source>Runs the children in order until one succeeds; resumes at the running child.</source>
        <translation>Ejecuta los hijos en orden hasta que uno tiene éxito; continúa en el hijo en ejecución.</translation>
    </message>
    <message>
        <source>A sequence that restarts at the first child in every time step, so that conditions are checked again.</source>
        <translation>Una secuencia que vuelve a empezar por el primer hijo en cada paso, de modo que las condiciones se comprueban de nuevo.</translation>
    </message>
    <message>
        <source>A fallback that restarts at the first child in every time step, so that earlier children take precedence.</source>
        <translation>Una alternativa que vuelve a empezar por el primer hijo en cada paso, de modo que los hijos anteriores tienen prioridad.</translation>
    </message>
    <message>
        <source>A sequence that resumes at the child that failed.</source>
        <translation>Una secuencia que continúa en el hijo que falló.</translation>
    </message>
    <message>
        <source>A sequence that completes at most one child per time step.</source>
        <translation>Una secuencia que completa como máximo un hijo por paso.</translation>
    </message>
    <message>
        <source>A fallback that completes at most one child per time step.</source>
        <translation>Una alternativa que completa como máximo un hijo por paso.</translation>
    </message>
    <message>
        <source>Runs all children in every time step until enough have succeeded or failed.</source>
        <translation>Ejecuta todos los hijos en cada paso hasta que suficientes han tenido éxito o han fallado.</translation>
    </message>
    <message>
        <source>Number of successes after which the node succeeds; negative: counted from all children (-1: all).</source>
        <translation>Número de éxitos tras los que el nodo tiene éxito; negativo: se cuenta desde todos los hijos (-1: todos).</translation>
    </message>
    <message>
        <source>Number of failures after which the node fails; negative: counted from all children (-1: all).</source>
        <translation>Número de fallos tras los que el nodo falla; negativo: se cuenta desde todos los hijos (-1: todos).</translation>
    </message>
    <message>
        <source>Runs all children and ends when all are completed.</source>
        <translation>Ejecuta todos los hijos y termina cuando todos han terminado.</translation>
    </message>
    <message>
        <source>Number of failures after which the node fails.</source>
        <translation>Número de fallos a partir del cual el nodo falla.</translation>
    </message>
    <message>
        <source>The first child is the condition, run once; if it succeeds, the second child is run, otherwise the third.</source>
        <translation>El primer hijo es la condición, que se ejecuta una vez; si tiene éxito se ejecuta el segundo hijo, si no el tercero.</translation>
    </message>
    <message>
        <source>The first child is the condition, run in every time step; while it succeeds, the second child is run, otherwise the third.</source>
        <translation>El primer hijo es la condición, que se ejecuta en cada paso; mientras tiene éxito se ejecuta el segundo hijo, si no el tercero.</translation>
    </message>
    <message>
        <source>Runs the child whose case equals the variable, for any other value the last child.</source>
        <translation>Ejecuta el hijo cuyo caso es igual a la variable; con cualquier otro valor, el último hijo.</translation>
    </message>
    <message>
        <source>Value that is compared.</source>
        <translation>Valor que se compara.</translation>
    </message>
    <message>
        <source>Value for which child 1 is run.</source>
        <translation>Valor con el que se ejecuta el hijo 1.</translation>
    </message>
    <message>
        <source>Value for which child 2 is run.</source>
        <translation>Valor con el que se ejecuta el hijo 2.</translation>
    </message>
    <message>
        <source>Value for which child 3 is run.</source>
        <translation>Valor con el que se ejecuta el hijo 3.</translation>
    </message>
    <message>
        <source>Value for which child 4 is run.</source>
        <translation>Valor con el que se ejecuta el hijo 4.</translation>
    </message>
    <message>
        <source>Value for which child 5 is run.</source>
        <translation>Valor con el que se ejecuta el hijo 5.</translation>
    </message>
    <message>
        <source>Child 6 is run for this value.</source>
        <translation>El hijo 6 se ejecuta con este valor.</translation>
    </message>
    <message>
        <source>Runs all children except the last as a sequence; if it fails, runs the last child.</source>
        <translation>Ejecuta todos los hijos menos el último como secuencia; si falla, ejecuta el último.</translation>
    </message>
    <message>
        <source>The last child is also ticked once when the node is halted.</source>
        <translation>El último hijo también recibe un tick cuando se detiene el nodo.</translation>
    </message>
    <message>
        <source>Decorator</source>
        <translation>Decorador</translation>
    </message>
    <message>
        <source>Inverts success and failure of the child.</source>
        <translation>Invierte el éxito y el fallo del hijo.</translation>
    </message>
    <message>
        <source>Succeeds whatever the result of the child.</source>
        <translation>Tiene éxito sea cual sea el resultado del hijo.</translation>
    </message>
    <message>
        <source>Fails whatever the result of the child.</source>
        <translation>Falla sea cual sea el resultado del hijo.</translation>
    </message>
    <message>
        <source>Repeats the child until it fails.</source>
        <translation>Repite el hijo hasta que falla.</translation>
    </message>
    <message>
        <source>Repeats the child this number of times, or until it fails.</source>
        <translation>Repite el hijo este número de veces, o hasta que falla.</translation>
    </message>
    <message>
        <source>Number of runs; -1: unlimited.</source>
        <translation>Número de repeticiones; -1: sin límite.</translation>
    </message>
    <message>
        <source>Repeats the child until it succeeds.</source>
        <translation>Repite el hijo hasta que tiene éxito.</translation>
    </message>
    <message>
        <source>Runs the child to completion once in the lifetime of the tree.</source>
        <translation>Ejecuta el hijo hasta el final una sola vez en la vida del árbol.</translation>
    </message>
    <message>
        <source>Afterwards: true: skipped, false: returns the same result.</source>
        <translation>Después: true: se omite, false: devuelve el mismo resultado.</translation>
    </message>
    <message>
        <source>Waits before the child is run.</source>
        <translation>Espera antes de ejecutar el hijo.</translation>
    </message>
    <message>
        <source>Duration in simulated time.</source>
        <translation>Duración en tiempo simulado.</translation>
    </message>
    <message>
        <source>Fails when the child takes longer.</source>
        <translation>Falla cuando el hijo tarda más.</translation>
    </message>
    <message>
        <source>Limit in simulated time; 0: none.</source>
        <translation>Límite en tiempo simulado; 0: ninguno.</translation>
    </message>
    <message>
        <source>Runs the child only if a script is true.</source>
        <translation>Ejecuta el hijo solo si un script es verdadero.</translation>
    </message>
    <message>
        <source>Script.</source>
        <translation>Script.</translation>
    </message>
    <message>
        <source>Result if the script is false.</source>
        <translation>Resultado si el script es falso.</translation>
    </message>
    <message>
        <source>Runs the child once for each element of a list.</source>
        <translation>Ejecuta el hijo una vez por cada elemento de una lista.</translation>
    </message>
    <message>
        <source>Elements, separated by &apos;;&apos;.</source>
        <translation>Elementos, separados por &apos;;&apos;.</translation>
    </message>
    <message>
        <source>Result at the end.</source>
        <translation>Resultado al final.</translation>
    </message>
    <message>
        <source>Current element.</source>
        <translation>Elemento actual.</translation>
    </message>
    <message>
        <source>Skips the child unless the blackboard entry was written.</source>
        <translation>Omite el hijo salvo que se haya escrito la entrada de la pizarra.</translation>
    </message>
    <message>
        <source>Blackboard entry.</source>
        <translation>Entrada de la pizarra.</translation>
    </message>
    <message>
        <source>Waits until the blackboard entry is written, then runs the child.</source>
        <translation>Espera a que se escriba la entrada de la pizarra y ejecuta el hijo.</translation>
    </message>
    <message>
        <source>SubTree</source>
        <translation>Subárbol</translation>
    </message>
    <message>
        <source>Runs another tree.</source>
        <translation>Ejecuta otro árbol.</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Succeeds.</source>
        <translation>Tiene éxito.</translation>
    </message>
    <message>
        <source>Fails.</source>
        <translation>Falla.</translation>
    </message>
    <message>
        <source>Writes an entry of the blackboard.</source>
        <translation>Escribe una entrada de la pizarra.</translation>
    </message>
    <message>
        <source>Text, or {key} of the entry that is copied.</source>
        <translation>Texto, o {clave} de la entrada que se copia.</translation>
    </message>
    <message>
        <source>Name of the entry.</source>
        <translation>Nombre de la entrada.</translation>
    </message>
    <message>
        <source>Removes an entry of the blackboard.</source>
        <translation>Quita una entrada de la pizarra.</translation>
    </message>
    <message>
        <source>Runs a script.</source>
        <translation>Ejecuta un script.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Condición</translation>
    </message>
    <message>
        <source>Succeeds if a script is true.</source>
        <translation>Tiene éxito si un script es verdadero.</translation>
    </message>
    <message>
        <source>Waits.</source>
        <translation>Espera.</translation>
    </message>
    <message>
        <source>Succeeds if the entry was written since the last check.</source>
        <translation>Tiene éxito si la entrada se escribió desde la última comprobación.</translation>
    </message>
    <message>
        <source>Walks to another person, slower with decreasing distance, and looks at them from the closest distance.</source>
        <translation>Camina hacia otra persona, más despacio al acercarse, y la mira desde la distancia mínima.</translation>
    </message>
    <message>
        <source>Id of the person.</source>
        <translation>Id de la persona.</translation>
    </message>
    <message>
        <source>Id of the other person.</source>
        <translation>Id de la otra persona.</translation>
    </message>
    <message>
        <source>Time step in HuNavSim; this program uses the simulation&apos;s time step.</source>
        <translation>Paso de tiempo en HuNavSim; este programa usa el paso de la simulación.</translation>
    </message>
    <message>
        <source>Ends after this time; 0: unlimited.</source>
        <translation>Termina tras este tiempo; 0: sin límite.</translation>
    </message>
    <message>
        <source>Distance at which the person stops.</source>
        <translation>Distancia a la que la persona se detiene.</translation>
    </message>
    <message>
        <source>Speed far from the other person.</source>
        <translation>Velocidad lejos de la otra persona.</translation>
    </message>
    <message>
        <source>Follows another person at the person&apos;s own speed, at most max_vel if given, and slower within the closest distance.</source>
        <translation>Sigue a otra persona a su propia velocidad, como máximo max_vel si se indica, y más despacio dentro de la distancia mínima.</translation>
    </message>
    <message>
        <source>Distance within which the person slows down.</source>
        <translation>Distancia dentro de la cual la persona reduce la velocidad.</translation>
    </message>
    <message>
        <source>Maximum speed while following; absent or negative: the person&apos;s own.</source>
        <translation>Velocidad máxima al seguir; si falta o es negativa: la de la propia persona.</translation>
    </message>
    <message>
        <source>Walks to a position in front of another person and faces them.</source>
        <translation>Camina hasta una posición delante de otra persona y se pone frente a ella.</translation>
    </message>
    <message>
        <source>Distance in front of the other person.</source>
        <translation>Distancia delante de la otra persona.</translation>
    </message>
    <message>
        <source>Another person is within the distance and the field of view, and no wall hides them.</source>
        <translation>Otra persona está dentro de la distancia y del campo de visión, y ninguna pared la oculta.</translation>
    </message>
    <message>
        <source>Id of the person who looks.</source>
        <translation>Id de la persona que mira.</translation>
    </message>
    <message>
        <source>Maximum distance of visible people.</source>
        <translation>Distancia máxima de las personas visibles.</translation>
    </message>
    <message>
        <source>Half of the field of view: the angle to each side, pi: all around.</source>
        <translation>Mitad del campo de visión: el ángulo a cada lado, pi: todo alrededor.</translation>
    </message>
    <message>
        <source>Another person is nearer than the threshold.</source>
        <translation>Otra persona está más cerca que el umbral.</translation>
    </message>
    <message>
        <source>Id of the first person.</source>
        <translation>Id de la primera persona.</translation>
    </message>
    <message>
        <source>Distance below which a person is close.</source>
        <translation>Distancia por debajo de la cual una persona está cerca.</translation>
    </message>
    <message>
        <source>Gathers people in a circle around a goal, facing its centre, and keeps them there for the conversation. This node controls the members instead of their own trees.</source>
        <translation>Reúne personas en círculo alrededor de un objetivo, mirando al centro, y las mantiene ahí durante la conversación. Este nodo controla a los miembros en lugar de sus árboles.</translation>
    </message>
    <message>
        <source>Id of the person who gathers the others.</source>
        <translation>Id de la persona que reúne a los demás.</translation>
    </message>
    <message>
        <source>Id of the global goal that is the centre.</source>
        <translation>Id del objetivo global que es el centro.</translation>
    </message>
    <message>
        <source>x of a point, if no goal_id is given.</source>
        <translation>x de un punto, si no se da goal_id.</translation>
    </message>
    <message>
        <source>y of a point, if no goal_id is given.</source>
        <translation>y de un punto, si no se da goal_id.</translation>
    </message>
    <message>
        <source>Duration after all members are in place.</source>
        <translation>Duración desde que todos los miembros están en su sitio.</translation>
    </message>
    <message>
        <source>Ids of the other members, separated by commas.</source>
        <translation>Ids de los otros miembros, separados por comas.</translation>
    </message>
    <message>
        <source>At least this number of other people are near.</source>
        <translation>Al menos este número de personas está cerca.</translation>
    </message>
    <message>
        <source>Distance within which people are near.</source>
        <translation>Distancia a la que las personas están cerca.</translation>
    </message>
    <message>
        <source>Number of other people.</source>
        <translation>Número de otras personas.</translation>
    </message>
    <message>
        <source>All other members of the person&apos;s group are near; fails without a group.</source>
        <translation>Todos los demás miembros del grupo de la persona están cerca; falla sin grupo.</translation>
    </message>
    <message>
        <source>Stands until another person is near, including a person who has not entered yet.</source>
        <translation>Se queda quieta hasta que otra persona está cerca, también una que aún no ha entrado.</translation>
    </message>
    <message>
        <source>Id of the person to wait for.</source>
        <translation>Id de la persona a la que espera.</translation>
    </message>
    <message>
        <source>Fails after this time; 0: unlimited.</source>
        <translation>Falla tras este tiempo; 0: sin límite.</translation>
    </message>
    <message>
        <source>Walks away from another person to the safe distance.</source>
        <translation>Se aleja de otra persona hasta la distancia segura.</translation>
    </message>
    <message>
        <source>Id of the person to flee from.</source>
        <translation>Id de la persona de la que huye.</translation>
    </message>
    <message>
        <source>Distance at which the node ends.</source>
        <translation>Distancia a la que termina el nodo.</translation>
    </message>
    <message>
        <source>Speed while fleeing.</source>
        <translation>Velocidad al huir.</translation>
    </message>
    <message>
        <source>Writes the id of the nearest other person; fails if there is none.</source>
        <translation>Escribe el id de la persona más cercana; falla si no hay ninguna.</translation>
    </message>
    <message>
        <source>Id of the nearest person.</source>
        <translation>Id de la persona más cercana.</translation>
    </message>
    <message>
        <source>Walks to a global goal; the person&apos;s other goals are suspended.</source>
        <translation>Camina a un objetivo global; los demás objetivos de la persona se suspenden.</translation>
    </message>
    <message>
        <source>Id of the global goal.</source>
        <translation>Id del objetivo global.</translation>
    </message>
    <message>
        <source>The goal is reached within this distance plus 0.1 m.</source>
        <translation>El objetivo se alcanza a esta distancia más 0.1 m.</translation>
    </message>
    <message>
        <source>Accepted for existing files; has no effect.</source>
        <translation>Se acepta por los archivos existentes; no tiene efecto.</translation>
    </message>
    <message>
        <source>Removes the current goal from the list; with cyclic goals it is appended at the end. Fails without goals.</source>
        <translation>Quita el objetivo actual de la lista; con objetivos cíclicos se añade al final. Falla sin objetivos.</translation>
    </message>
    <message>
        <source>Appends a global goal to the person&apos;s list; goals set in the first tick replace those of the scenario.</source>
        <translation>Añade un objetivo global a la lista de la persona; los objetivos del primer tick sustituyen a los del escenario.</translation>
    </message>
    <message>
        <source>One time step towards the current goal; without a goal the person comes to rest.</source>
        <translation>Un paso hacia el objetivo actual; sin objetivo la persona se detiene.</translation>
    </message>
    <message>
        <source>The person is within the radius of the current goal, plus 0.1 m; never without a goal.</source>
        <translation>La persona está dentro del radio del objetivo actual, más 0.1 m; nunca sin objetivo.</translation>
    </message>
    <message>
        <source>The person is at a global goal.</source>
        <translation>La persona está en un objetivo global.</translation>
    </message>
    <message>
        <source>Id of any person.</source>
        <translation>Id de cualquier persona.</translation>
    </message>
    <message>
        <source>Maximum distance to the goal.</source>
        <translation>Distancia máxima al objetivo.</translation>
    </message>
    <message>
        <source>Puts the person into a group.</source>
        <translation>Pone a la persona en un grupo.</translation>
    </message>
    <message>
        <source>Number of the group; -1: no group.</source>
        <translation>Número del grupo; -1: sin grupo.</translation>
    </message>
    <message>
        <source>Forms a group with the goals of the main person, whom this node controls; the others follow their own trees. Groups and goals are restored at the end.</source>
        <translation>Forma un grupo con los objetivos de la persona principal, a la que controla este nodo; los demás siguen sus propios árboles. Al final se restauran grupos y objetivos.</translation>
    </message>
    <message>
        <source>Id of the person who leads.</source>
        <translation>Id de la persona que guía.</translation>
    </message>
    <message>
        <source>The robot is within the distance and within 100 degrees to each side, and no wall hides it.</source>
        <translation>El robot está dentro de la distancia y de 100 grados a cada lado, y ninguna pared lo oculta.</translation>
    </message>
    <message>
        <source>Maximum distance at which the robot is visible.</source>
        <translation>Distancia máxima a la que el robot es visible.</translation>
    </message>
    <message>
        <source>Turns in place to a global goal.</source>
        <translation>Gira en el sitio hacia un objetivo global.</translation>
    </message>
    <message>
        <source>Heading error at which the node ends.</source>
        <translation>Error de orientación con el que termina el nodo.</translation>
    </message>
    <message>
        <source>Turns in place to another person.</source>
        <translation>Gira en el sitio hacia otra persona.</translation>
    </message>
    <message>
        <source>Id of the person who turns.</source>
        <translation>Id de la persona que gira.</translation>
    </message>
    <message>
        <source>Id of the person to look at.</source>
        <translation>Id de la persona a la que mira.</translation>
    </message>
    <message>
        <source>Turns in place to the robot.</source>
        <translation>Gira en el sitio hacia el robot.</translation>
    </message>
    <message>
        <source>Waits until another person looks at the person; selects the nearest of several.</source>
        <translation>Espera a que otra persona mire a la persona; elige la más cercana de varias.</translation>
    </message>
    <message>
        <source>Maximum distance of the other person.</source>
        <translation>Distancia máxima de la otra persona.</translation>
    </message>
    <message>
        <source>Maximum angle between the other person&apos;s heading and the line to the person.</source>
        <translation>Ángulo máximo entre la orientación de la otra persona y la línea hacia la persona.</translation>
    </message>
    <message>
        <source>Maximum wait; then the node fails.</source>
        <translation>Espera máxima; después el nodo falla.</translation>
    </message>
    <message>
        <source>Waits until a certain person looks at this one.</source>
        <translation>Espera a que cierta persona mire a esta.</translation>
    </message>
    <message>
        <source>Id of the person who should look.</source>
        <translation>Id de la persona que debe mirar.</translation>
    </message>
    <message>
        <source>Passes the robot ahead on the person&apos;s left or right; fails if there is none ahead.</source>
        <translation>Rebasa al robot que va delante por la izquierda o la derecha de la persona; falla si no hay ninguno delante.</translation>
    </message>
    <message>
        <source>left or right, seen by the person.</source>
        <translation>left o right, vistos por la persona.</translation>
    </message>
    <message>
        <source>Distance to the robot at which the node starts.</source>
        <translation>Distancia al robot a la que empieza el nodo.</translation>
    </message>
    <message>
        <source>Lateral distance to the robot.</source>
        <translation>Distancia lateral al robot.</translation>
    </message>
    <message>
        <source>Walks between random points of an area.</source>
        <translation>Camina entre puntos aleatorios de un área.</translation>
    </message>
    <message>
        <source>Name of the area.</source>
        <translation>Nombre del área.</translation>
    </message>
    <message>
        <source>Walks into the area of kind exit with the shortest path; fails without one.</source>
        <translation>Camina al área de tipo exit con el camino más corto; falla sin ninguna.</translation>
    </message>
    <message>
        <source>Walks to a global goal and stays there for some time.</source>
        <translation>Camina a un objetivo global y se queda ahí un tiempo.</translation>
    </message>
    <message>
        <source>Id of the global goal at the object.</source>
        <translation>Id del objetivo global junto al objeto.</translation>
    </message>
    <message>
        <source>Time at the object.</source>
        <translation>Tiempo junto al objeto.</translation>
    </message>
    <message>
        <source>Selects a random child when it is started and runs it to completion.</source>
        <translation>Elige un hijo al azar al empezar y lo ejecuta hasta el final.</translation>
    </message>
    <message>
        <source>Relative probability of each child; absent: all equal.</source>
        <translation>Probabilidad relativa de cada hijo; si falta: todas iguales.</translation>
    </message>
    <message>
        <source>Succeeds with the given probability, drawn again in every tick, so that the probability over n ticks is 1 - (1 - p)^n.</source>
        <translation>Tiene éxito con la probabilidad dada, sorteada de nuevo en cada tick, de modo que la probabilidad en n ticks es 1 - (1 - p)^n.</translation>
    </message>
    <message>
        <source>Probability per tick.</source>
        <translation>Probabilidad por tick.</translation>
    </message>
    <message>
        <source>Stands and turns to the robot.</source>
        <translation>Se queda quieta y gira hacia el robot.</translation>
    </message>
    <message>
        <source>One time step towards the robot, slower with decreasing distance; looks at it at rest.</source>
        <translation>Un paso hacia el robot, más despacio al acercarse; parada, lo mira.</translation>
    </message>
    <message>
        <source>Speed far from the robot.</source>
        <translation>Velocidad lejos del robot.</translation>
    </message>
    <message>
        <source>Distance to the robot at which the person stops.</source>
        <translation>Distancia al robot a la que la persona se detiene.</translation>
    </message>
    <message>
        <source>One time step away from the robot. With scary_force_factor and without safe_distance: one time step to the goals while the robot repels the person.</source>
        <translation>Un paso alejándose del robot. Con scary_force_factor y sin safe_distance: un paso hacia los objetivos mientras el robot repele a la persona.</translation>
    </message>
    <message>
        <source>Distance to which the person flees.</source>
        <translation>Distancia hasta la que huye la persona.</translation>
    </message>
    <message>
        <source>Strength of the repulsive force of the robot.</source>
        <translation>Intensidad de la fuerza de repulsión del robot.</translation>
    </message>
    <message>
        <source>One time step to the position in front of the robot; faces it there.</source>
        <translation>Un paso hacia la posición delante del robot; ahí se pone frente a él.</translation>
    </message>
    <message>
        <source>Distance in front of the robot; values below 0.5 m are replaced by 1.5 m.</source>
        <translation>Distancia delante del robot; los valores por debajo de 0.5 m se sustituyen por 1.5 m.</translation>
    </message>
    <message>
        <source>Walks to the robot, slower with decreasing distance, and looks at it from the closest distance.</source>
        <translation>Camina hacia el robot, más despacio al acercarse, y lo mira desde la distancia mínima.</translation>
    </message>
    <message>
        <source>Flees from the robot to the safe distance and looks at it from there.</source>
        <translation>Huye del robot hasta la distancia segura y lo mira desde ahí.</translation>
    </message>
    <message>
        <source>Walks to the position in front of the robot and faces it there.</source>
        <translation>Camina hasta la posición delante del robot y ahí se pone frente a él.</translation>
    </message>
    <message>
        <source>The robot is nearer than the threshold.</source>
        <translation>El robot está más cerca que el umbral.</translation>
    </message>
    <message>
        <source>Distance below which the robot is close.</source>
        <translation>Distancia por debajo de la cual el robot está cerca.</translation>
    </message>
    <message>
        <source>The robot&apos;s heading points at the person within 0.3 rad.</source>
        <translation>La orientación del robot apunta a la persona con menos de 0.3 rad de error.</translation>
    </message>
    <message>
        <source>Says a sentence, once.</source>
        <translation>Dice una frase, una vez.</translation>
    </message>
    <message>
        <source>Text of the sentence.</source>
        <translation>Texto de la frase.</translation>
    </message>
    <message>
        <source>Waits until a person nearby is heard; walls block speech. The last speaker is selected.</source>
        <translation>Espera a oír a una persona cercana; las paredes bloquean el habla. Se elige el último hablante.</translation>
    </message>
    <message>
        <source>Maximum distance at which speech is heard.</source>
        <translation>Distancia máxima a la que se oye el habla.</translation>
    </message>
    <message>
        <source>Id of the speaker.</source>
        <translation>Id del hablante.</translation>
    </message>
    <message>
        <source>Waits until a certain person is heard; walls block speech.</source>
        <translation>Espera a oír a cierta persona; las paredes bloquean el habla.</translation>
    </message>
    <message>
        <source>The person stops walking to goals until ResumeMovement; reactions still move the person.</source>
        <translation>La persona deja de caminar a objetivos hasta ResumeMovement; las reacciones aún la mueven.</translation>
    </message>
    <message>
        <source>Ends the effect of StopMovement.</source>
        <translation>Termina el efecto de StopMovement.</translation>
    </message>
    <message>
        <source>Stands still for some time.</source>
        <translation>Se queda quieta un tiempo.</translation>
    </message>
    <message>
        <source>Duration.</source>
        <translation>Duración.</translation>
    </message>
    <message>
        <source>Fails until the delay is over, then runs the child; the delay restarts after each run of the child.</source>
        <translation>Falla hasta que pasa el retardo y luego ejecuta el hijo; el retardo se reinicia tras cada ejecución del hijo.</translation>
    </message>
    <message>
        <source>Time before the child is run.</source>
        <translation>Tiempo antes de ejecutar el hijo.</translation>
    </message>
    <message>
        <source>Adds `ts` in each tick and succeeds when the sum has reached `seconds`; then it restarts, or with only_once succeeds from then on.</source>
        <translation>Suma `ts` en cada tick y tiene éxito cuando la suma alcanza `seconds`; luego vuelve a empezar, o con only_once tiene éxito desde entonces.</translation>
    </message>
    <message>
        <source>Length of the timer.</source>
        <translation>Duración del temporizador.</translation>
    </message>
    <message>
        <source>Added per tick; usually {dt}.</source>
        <translation>Se suma por tick; normalmente {dt}.</translation>
    </message>
    <message>
        <source>The timer stays expired.</source>
        <translation>El temporizador permanece vencido.</translation>
    </message>
    <message>
        <source>Runs the child; after its completion the node fails until the time has passed.</source>
        <translation>Ejecuta el hijo; cuando termina, el nodo falla hasta que pasa el tiempo.</translation>
    </message>
    <message>
        <source>Pause after each run of the child.</source>
        <translation>Pausa tras cada ejecución del hijo.</translation>
    </message>
    <message>
        <source>The simulated time lies in [from, until).</source>
        <translation>El tiempo simulado está en [from, until).</translation>
    </message>
    <message>
        <source>Start of the interval.</source>
        <translation>Inicio del intervalo.</translation>
    </message>
    <message>
        <source>End of the interval.</source>
        <translation>Fin del intervalo.</translation>
    </message>
    <message>
        <source>Joins the queue at a global goal, moves up in it and is served at its head.</source>
        <translation>Se une a la cola en un objetivo global, avanza en ella y se la atiende al frente.</translation>
    </message>
    <message>
        <source>Id of the global goal at the head of the queue.</source>
        <translation>Id del objetivo global al frente de la cola.</translation>
    </message>
    <message>
        <source>Distance to the person in front.</source>
        <translation>Distancia a la persona de delante.</translation>
    </message>
    <message>
        <source>Time at the head of the queue.</source>
        <translation>Tiempo al frente de la cola.</translation>
    </message>
    <message>
        <source>Maximum wait until service; then the node fails; 0: unlimited.</source>
        <translation>Espera máxima hasta ser atendida; después el nodo falla; 0: sin límite.</translation>
    </message>
    <message>
        <source>Stands and looks at an approaching robot until it has passed; fails if no robot approaches.</source>
        <translation>Se queda quieta y mira a un robot que se acerca hasta que ha pasado; falla si no se acerca ninguno.</translation>
    </message>
    <message>
        <source>Maximum distance of the robot.</source>
        <translation>Distancia máxima del robot.</translation>
    </message>
    <message>
        <source>Time after which the node ends if the robot stands still.</source>
        <translation>Tiempo tras el cual termina el nodo si el robot está parado.</translation>
    </message>
    <message>
        <source>Robot interaction</source>
        <translation>Interacción con el robot</translation>
    </message>
    <message>
        <source>Turns to the robot when it is in sight and approaches it</source>
        <translation>Gira hacia el robot cuando lo ve y se acerca a él</translation>
    </message>
    <message>
        <source>Conversation</source>
        <translation>Conversación</translation>
    </message>
    <message>
        <source>Stands together with others at a goal and talks</source>
        <translation>Está con otras personas en un objetivo y habla</translation>
    </message>
    <message>
        <source>With</source>
        <translation>Con</translation>
    </message>
    <message>
        <source>Meets at goal</source>
        <translation>Se reúne en</translation>
    </message>
    <message>
        <source>Closer than</source>
        <translation>Más cerca de</translation>
    </message>
    <message>
        <source>Robot awareness</source>
        <translation>Atención al robot</translation>
    </message>
    <message>
        <source>Stops and looks while the robot is near, then walks on</source>
        <translation>Se detiene y mira mientras el robot está cerca, luego sigue</translation>
    </message>
    <message>
        <source>Stops within</source>
        <translation>Se detiene a</translation>
    </message>
    <message>
        <source>Follow a person</source>
        <translation>Seguir a una persona</translation>
    </message>
    <message>
        <source>Follows another person for some time</source>
        <translation>Sigue a otra persona durante un tiempo</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>Sigue a</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Persona</translation>
    </message>
    <message>
        <source>Starts within</source>
        <translation>Empieza a</translation>
    </message>
    <message>
        <source>Keeps at</source>
        <translation>Se mantiene a</translation>
    </message>
    <message>
        <source>Robot blocking</source>
        <translation>Bloqueo del robot</translation>
    </message>
    <message>
        <source>Steps into the path of the robot and stays there</source>
        <translation>Se pone en el camino del robot y se queda ahí</translation>
    </message>
    <message>
        <source>Stands in front</source>
        <translation>Está delante a</translation>
    </message>
    <message>
        <source>Walk together</source>
        <translation>Caminar juntos</translation>
    </message>
    <message>
        <source>Walks in a group with the nearest person</source>
        <translation>Camina en grupo con la persona más cercana</translation>
    </message>
    <message>
        <source>Answer a call</source>
        <translation>Responder a una llamada</translation>
    </message>
    <message>
        <source>Walks to a person who speaks and starts a conversation</source>
        <translation>Camina hacia una persona que habla y empieza una conversación</translation>
    </message>
    <message>
        <source>Hears within</source>
        <translation>Oye hasta</translation>
    </message>
    <message>
        <source>Listens for</source>
        <translation>Escucha durante</translation>
    </message>
    <message>
        <source>Approaches for</source>
        <translation>Se acerca durante</translation>
    </message>
    <message>
        <source>Talks for</source>
        <translation>Habla durante</translation>
    </message>
    <message>
        <source>Answer a look</source>
        <translation>Responder a una mirada</translation>
    </message>
    <message>
        <source>Looks back at an observer and says something</source>
        <translation>Devuelve la mirada a un observador y dice algo</translation>
    </message>
    <message>
        <source>Looked at by</source>
        <translation>La mira</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>A menos de</translation>
    </message>
    <message>
        <source>Waits for</source>
        <translation>Espera a</translation>
    </message>
    <message>
        <source>Says</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>Greeting</source>
        <translation>Saludo</translation>
    </message>
    <message>
        <source>Turns to the robot or a person in sight and greets</source>
        <translation>Gira hacia el robot o una persona a la vista y saluda</translation>
    </message>
    <message>
        <source>Greets</source>
        <translation>Saluda a</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Protección</translation>
    </message>
    <message>
        <source>Steps between the robot and a person that it approaches</source>
        <translation>Se interpone entre el robot y una persona a la que se acerca</translation>
    </message>
    <message>
        <source>Guards</source>
        <translation>Protege a</translation>
    </message>
    <message>
        <source>Sees the robot</source>
        <translation>Ve el robot</translation>
    </message>
    <message>
        <source>Sees people</source>
        <translation>Ve personas</translation>
    </message>
    <message>
        <source>Robot nearer than</source>
        <translation>Robot a menos de</translation>
    </message>
    <message>
        <source>Blocks for</source>
        <translation>Bloquea durante</translation>
    </message>
</context>
<context>
    <name>EditCommand</name>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Add %1 items</source>
        <translation>Añadir %1 elementos</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Remove %1 items</source>
        <translation>Quitar %1 elementos</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Move %1 items</source>
        <translation>Mover %1 elementos</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Duplicate %1 items</source>
        <translation>Duplicar %1 elementos</translation>
    </message>
    <message>
        <source>Set route of %1</source>
        <translation>Fijar la ruta de %1</translation>
    </message>
    <message>
        <source>Set route of %1 items</source>
        <translation>Fijar la ruta de %1 elementos</translation>
    </message>
    <message>
        <source>Reorder %1</source>
        <translation>Reordenar %1</translation>
    </message>
    <message>
        <source>Reorder %1 items</source>
        <translation>Reordenar %1 elementos</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>Activar %1</translation>
    </message>
    <message>
        <source>Switch on %1 items</source>
        <translation>Activar %1 elementos</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>Desactivar %1</translation>
    </message>
    <message>
        <source>Switch off %1 items</source>
        <translation>Desactivar %1 elementos</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Cambiar el nombre de %1</translation>
    </message>
    <message>
        <source>Renumber goal %1</source>
        <translation>Renumerar el objetivo %1</translation>
    </message>
</context>
<context>
    <name>Entity</name>
    <message>
        <source>%1 goal</source>
        <translation>objetivo de %1</translation>
    </message>
    <message>
        <source>Goal %1</source>
        <translation>Objetivo %1</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>escenario</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>escenarios</translation>
    </message>
    <message>
        <source>person</source>
        <translation>persona</translation>
    </message>
    <message>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>robots</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>goals</source>
        <translation>objetivos</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstáculo</translation>
    </message>
    <message>
        <source>obstacles</source>
        <translation>obstáculos</translation>
    </message>
    <message>
        <source>door</source>
        <translation>puerta</translation>
    </message>
    <message>
        <source>doors</source>
        <translation>puertas</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>areas</source>
        <translation>áreas</translation>
    </message>
    <message>
        <source>dock</source>
        <translation>base de carga</translation>
    </message>
    <message>
        <source>docks</source>
        <translation>bases</translation>
    </message>
    <message>
        <source>box</source>
        <translation>rectángulo</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>círculo</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polígono</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>pared</translation>
    </message>
    <message>
        <source>source</source>
        <translation>fuente</translation>
    </message>
    <message>
        <source>sink</source>
        <translation>sumidero</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>espera</translation>
    </message>
    <message>
        <source>exit</source>
        <translation>salida</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Counter-clockwise from the x axis</source>
        <translation>En sentido antihorario desde el eje x</translation>
    </message>
</context>
<context>
    <name>Force</name>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstáculos</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>Contents</source>
        <translation>Contenido</translation>
    </message>
    <message>
        <source>Installation</source>
        <translation>Instalación</translation>
    </message>
    <message>
        <source>First scenario</source>
        <translation>Primer escenario</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>La ventana</translation>
    </message>
    <message>
        <source>Your own map</source>
        <translation>Su propio mapa</translation>
    </message>
    <message>
        <source>People and groups</source>
        <translation>Personas y grupos</translation>
    </message>
    <message>
        <source>Behaviour trees</source>
        <translation>Árboles de comportamiento</translation>
    </message>
    <message>
        <source>Robots and sensors</source>
        <translation>Robots y sensores</translation>
    </message>
    <message>
        <source>List of robots</source>
        <translation>Lista de robots</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>Planificadores</translation>
    </message>
    <message>
        <source>Pedestrian models</source>
        <translation>Modelos de peatones</translation>
    </message>
    <message>
        <source>Compare planners</source>
        <translation>Comparar planificadores</translation>
    </message>
    <message>
        <source>Sensitivity analysis</source>
        <translation>Análisis de sensibilidad</translation>
    </message>
    <message>
        <source>Parameter tuning</source>
        <translation>Ajuste de parámetros</translation>
    </message>
    <message>
        <source>Share a study</source>
        <translation>Compartir un estudio</translation>
    </message>
    <message>
        <source>Leaderboard</source>
        <translation>Clasificación</translation>
    </message>
    <message>
        <source>Find failures</source>
        <translation>Búsqueda de fallos</translation>
    </message>
    <message>
        <source>Tests on a build server</source>
        <translation>Pruebas en un servidor de compilación</translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation>Nav2</translation>
    </message>
    <message>
        <source>Your own planner</source>
        <translation>Su propio planificador</translation>
    </message>
    <message>
        <source>Python</source>
        <translation>Python</translation>
    </message>
    <message>
        <source>ROS 2 and other simulators</source>
        <translation>ROS 2 y otros simuladores</translation>
    </message>
    <message>
        <source>Recordings and bags</source>
        <translation>Grabaciones y bags</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Nodes of behaviour trees</source>
        <translation>Nodos de los árboles de comportamiento</translation>
    </message>
    <message>
        <source>File formats</source>
        <translation>Formatos de archivo</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Studies on a cluster</source>
        <translation>Estudios en un clúster</translation>
    </message>
    <message>
        <source>List of scenarios</source>
        <translation>Lista de escenarios</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>Solución de problemas</translation>
    </message>
    <message>
        <source>How to cite</source>
        <translation>Cómo citar</translation>
    </message>
    <message>
        <source>Glossary</source>
        <translation>Glosario</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Forces on people</source>
        <translation>Fuerzas sobre personas</translation>
    </message>
    <message>
        <source>Forces on %1</source>
        <translation>Fuerzas sobre %1</translation>
    </message>
    <message>
        <source>Forces on selection</source>
        <translation>Fuerzas sobre la selección</translation>
    </message>
    <message>
        <source>after the first step</source>
        <translation>tras el primer paso</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>sin registrar</translation>
    </message>
    <message>
        <source>Spaces</source>
        <translation>Espacios</translation>
    </message>
    <message>
        <source>Spaces of %1</source>
        <translation>Espacios de %1</translation>
    </message>
    <message>
        <source>Spaces of selection</source>
        <translation>Espacios de la selección</translation>
    </message>
    <message>
        <source>Intimate</source>
        <translation>Íntimo</translation>
    </message>
    <message>
        <source>Personal</source>
        <translation>Personal</translation>
    </message>
    <message>
        <source>Social</source>
        <translation>Social</translation>
    </message>
    <message>
        <source>Gaussian</source>
        <translation>Gaussiano</translation>
    </message>
    <message>
        <source>at 0.6, 0.2</source>
        <translation>a 0.6, 0.2</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Campo de visión</translation>
    </message>
    <message>
        <source>Select a person</source>
        <translation>Seleccione una persona</translation>
    </message>
    <message>
        <source>Seen by %1</source>
        <translation>Vistos por %1</translation>
    </message>
    <message>
        <source>100° to either side</source>
        <translation>100° a cada lado</translation>
    </message>
    <message>
        <source>People per m²</source>
        <translation>Personas por m²</translation>
    </message>
    <message>
        <source>exp(−d²/R²)/πR², R = %1 m</source>
        <translation>exp(−d²/R²)/πR², R = %1 m</translation>
    </message>
    <message>
        <source>Remaining path</source>
        <translation>Camino restante</translation>
    </message>
    <message>
        <source>newest step only</source>
        <translation>solo el paso más reciente</translation>
    </message>
    <message>
        <source>Contacts so far</source>
        <translation>Contactos hasta ahora</translation>
    </message>
    <message>
        <source>Costs of %1</source>
        <translation>Costes de %1</translation>
    </message>
    <message>
        <source>Costs</source>
        <translation>Costes</translation>
    </message>
    <message>
        <source>newest step, Nav2 only</source>
        <translation>paso más reciente, solo Nav2</translation>
    </message>
    <message>
        <source>Inscribed</source>
        <translation>Inscrito</translation>
    </message>
    <message>
        <source>Lethal</source>
        <translation>Letal</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>Filter masks of %1</source>
        <translation>Máscaras de filtro de %1</translation>
    </message>
    <message>
        <source>Filter masks</source>
        <translation>Máscaras de filtro</translation>
    </message>
    <message>
        <source>none; newest step, Nav2 only</source>
        <translation>ninguna; paso más reciente, solo Nav2</translation>
    </message>
    <message>
        <source>Keep out</source>
        <translation>Zona prohibida</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Límite de velocidad</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Conmutación</translation>
    </message>
    <message>
        <source>%1–%2 %</source>
        <translation>%1–%2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Evaluated by %1</source>
        <translation>Evaluadas por %1</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>Descartadas</translation>
    </message>
    <message>
        <source>Lookahead</source>
        <translation>Anticipación</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Elegida</translation>
    </message>
    <message>
        <source>Lidar, %1 m</source>
        <translation>Lidar, %1 m</translation>
    </message>
    <message>
        <source>Detection, velocity</source>
        <translation>Detección, velocidad</translation>
    </message>
    <message>
        <source>Chosen trajectory</source>
        <translation>Trayectoria elegida</translation>
    </message>
    <message>
        <source>Candidate (pale: costly)</source>
        <translation>Candidata (clara: costosa)</translation>
    </message>
    <message>
        <source>Would collide</source>
        <translation>Colisionaría</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Velocidades</translation>
    </message>
    <message>
        <source>People&apos;s paths</source>
        <translation>Caminos de las personas</translation>
    </message>
    <message>
        <source>Below names</source>
        <translation>Bajo los nombres</translation>
    </message>
    <message>
        <source>action and its reason</source>
        <translation>acción y su motivo</translation>
    </message>
    <message>
        <source>lidar: newest only</source>
        <translation>lidar: solo el más reciente</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Caused by robot</source>
        <translation>Causado por el robot</translation>
    </message>
    <message>
        <source>Caused by person</source>
        <translation>Causado por la persona</translation>
    </message>
    <message>
        <source>Caused by both</source>
        <translation>Causado por ambos</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 más</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Move out of the wall</source>
        <translation>Sacar de la pared</translation>
    </message>
    <message>
        <source>Renumber people</source>
        <translation>Renumerar personas</translation>
    </message>
    <message>
        <source>Renumber goals</source>
        <translation>Renumerar objetivos</translation>
    </message>
    <message>
        <source>Remove goal %1 from the route</source>
        <translation>Quitar el objetivo %1 de la ruta</translation>
    </message>
    <message>
        <source>Remove the goal</source>
        <translation>Quitar el objetivo</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar el nombre</translation>
    </message>
    <message>
        <source>Clamp to the range</source>
        <translation>Limitar al intervalo</translation>
    </message>
    <message>
        <source>Add these values</source>
        <translation>Añadir estos valores</translation>
    </message>
    <message>
        <source>Set the start to 0, 0</source>
        <translation>Poner el inicio en 0, 0</translation>
    </message>
    <message>
        <source>Set one wait per goal</source>
        <translation>Poner una espera por objetivo</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>Asignar objetivos…</translation>
    </message>
    <message>
        <source>Use &apos;%1&apos;</source>
        <translation>Usar «%1»</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>Usar el valor predeterminado</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Copiar %1</translation>
    </message>
    <message>
        <source>Set rate to 0.1 /s</source>
        <translation>Poner la tasa a 0.1 /s</translation>
    </message>
    <message>
        <source>Swap the times</source>
        <translation>Intercambiar los tiempos</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Open the wall</source>
        <translation>Abrir la pared</translation>
    </message>
    <message>
        <source>Set to &apos;%1&apos;</source>
        <translation>Poner «%1»</translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation>Usar un plano abierto</translation>
    </message>
    <message>
        <source>Add a robot</source>
        <translation>Añadir un robot</translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation>Usar el cuerpo del archivo de Nav2</translation>
    </message>
    <message>
        <source>Change map</source>
        <translation>Cambiar el mapa</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grupo %1</translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation>Salir del grupo</translation>
    </message>
    <message>
        <source>Join group %1</source>
        <translation>Unirse al grupo %1</translation>
    </message>
    <message>
        <source>Dissolve group %1</source>
        <translation>Disolver el grupo %1</translation>
    </message>
    <message>
        <source>Name group %1</source>
        <translation>Nombrar el grupo %1</translation>
    </message>
    <message>
        <source>Assign goals to %1</source>
        <translation>Asignar objetivos a %1</translation>
    </message>
    <message>
        <source>Assign goals to %1 people</source>
        <translation>Asignar objetivos a %1 personas</translation>
    </message>
    <message>
        <source> (and %1 more)</source>
        <translation> (y %1 más)</translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation>Regenerar el árbol</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>Cambiar %1 de %2</translation>
    </message>
    <message>
        <source>Change blocks</source>
        <translation>Cambiar bloques</translation>
    </message>
    <message>
        <source>Add block %1</source>
        <translation>Añadir el bloque %1</translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation>Copiar la ruta al árbol</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Collapse or expand</source>
        <translation>Plegar o desplegar</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Save table</source>
        <translation>Guardar tabla</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valores separados por comas (*.csv)</translation>
    </message>
    <message>
        <source>LaTeX (*.tex)</source>
        <translation>LaTeX (*.tex)</translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation>Markdown (*.md)</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Copiar tabla</translation>
    </message>
    <message>
        <source>Copy the rows as text that spreadsheets understand</source>
        <translation>Copiar las filas como texto para hojas de cálculo</translation>
    </message>
    <message>
        <source>Save table…</source>
        <translation>Guardar tabla…</translation>
    </message>
    <message>
        <source>Save the rows as CSV, LaTeX or Markdown</source>
        <translation>Guardar las filas como CSV, LaTeX o Markdown</translation>
    </message>
    <message>
        <source>Set behaviour: %1</source>
        <translation>Definir comportamiento: %1</translation>
    </message>
    <message>
        <source>Set the behaviour of the selected people to %1</source>
        <translation>Poner el comportamiento de las personas seleccionadas en %1</translation>
    </message>
    <message>
        <source>&amp;Mix…</source>
        <translation>&amp;Mezcla…</translation>
    </message>
    <message>
        <source>Set the shares of behaviours among the selected people, or among all</source>
        <translation>Repartir los comportamientos entre las personas seleccionadas, o entre todas</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamiento</translation>
    </message>
    <message>
        <source>no goals</source>
        <translation>sin objetivos</translation>
    </message>
    <message>
        <source>subtree</source>
        <translation>subárbol</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>ejecuciones</translation>
    </message>
    <message>
        <source>Conditional breakpoint</source>
        <translation>Punto de interrupción condicional</translation>
    </message>
    <message>
        <source>when it %1</source>
        <translation>cuando %1</translation>
    </message>
    <message>
        <source>, for any person</source>
        <translation>, para cualquier persona</translation>
    </message>
    <message>
        <source>, if %1</source>
        <translation>, si %1</translation>
    </message>
    <message>
        <source>It %1</source>
        <translation>Si %1</translation>
    </message>
    <message>
        <source>Break when</source>
        <translation>Detener cuando</translation>
    </message>
    <message>
        <source>Break for any person when</source>
        <translation>Detener para cualquier persona cuando</translation>
    </message>
    <message>
        <source>Remove breakpoint %1</source>
        <translation>Quitar el punto de interrupción %1</translation>
    </message>
    <message>
        <source>Remove all breakpoints</source>
        <translation>Quitar todos los puntos de interrupción</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (falta)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>A value (%1) or a blackboard entry in braces, such as {id}</source>
        <translation>Un valor (%1) o una entrada de la pizarra entre llaves, como {id}</translation>
    </message>
    <message>
        <source>The nearest person</source>
        <translation>La persona más cercana</translation>
    </message>
    <message>
        <source>A person by name</source>
        <translation>Una persona por su nombre</translation>
    </message>
    <message>
        <source>The robot</source>
        <translation>El robot</translation>
    </message>
    <message>
        <source>Occurs</source>
        <translation>Ocurre</translation>
    </message>
    <message>
        <source>Whenever possible</source>
        <translation>Siempre que sea posible</translation>
    </message>
    <message>
        <source>Only once</source>
        <translation>Solo una vez</translation>
    </message>
    <message>
        <source>At random</source>
        <translation>Al azar</translation>
    </message>
    <message>
        <source>Probability</source>
        <translation>Probabilidad</translation>
    </message>
    <message>
        <source>Probability in each time step in which the block can start</source>
        <translation>Probabilidad en cada paso en que el bloque puede empezar</translation>
    </message>
    <message>
        <source>Enter text</source>
        <translation>Escriba un texto</translation>
    </message>
    <message>
        <source>Select a person to add or remove</source>
        <translation>Seleccione una persona para añadirla o quitarla</translation>
    </message>
    <message>
        <source>unknown node</source>
        <translation>nodo desconocido</translation>
    </message>
    <message>
        <source>no settings</source>
        <translation>sin ajustes</translation>
    </message>
    <message>
        <source>in an included file</source>
        <translation>en un archivo incluido</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Nav2</source>
        <translation>Nav2</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Vértices</translation>
    </message>
    <message>
        <source>x y [m], separated by semicolons</source>
        <translation>x y [m], separados por punto y coma</translation>
    </message>
    <message>
        <source>At least %1 corners x y, separated by semicolons</source>
        <translation>Al menos %1 vértices x y, separados por punto y coma</translation>
    </message>
    <message>
        <source>Thresholds</source>
        <translation>Umbrales</translation>
    </message>
    <message>
        <source>Metric thresholds, such as name=value, name=value</source>
        <translation>Umbrales de métricas, como nombre=valor, nombre=valor</translation>
    </message>
    <message>
        <source>name=number, separated by commas</source>
        <translation>nombre=número, separados por comas</translation>
    </message>
    <message>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <source>omnidirectional</source>
        <translation>omnidireccional</translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation>Ackermann</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>diferencial</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Numbers, separated by commas</source>
        <translation>Números separados por comas</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>Persona %1</translation>
    </message>
    <message>
        <source> · switched off</source>
        <translation> · desactivada</translation>
    </message>
    <message>
        <source>Template of people spawned by %1</source>
        <translation>Plantilla de las personas que genera %1</translation>
    </message>
    <message>
        <source> · stands still</source>
        <translation> · está quieta</translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation> · objetivos %1</translation>
    </message>
    <message>
        <source>Robot · %1</source>
        <translation>Robot · %1</translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation> · hacia %1</translation>
    </message>
    <message>
        <source>all visited</source>
        <translation>todos visitados</translation>
    </message>
    <message>
        <source>%1, reached</source>
        <translation>%1, alcanzado</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Footprint</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Corners x y in the robot frame, such as 0.3 0.2; -0.3 0.2; -0.3 -0.2</source>
        <translation>Vértices x y en el sistema del robot, como 0.3 0.2; -0.3 0.2; -0.3 -0.2</translation>
    </message>
    <message>
        <source>At least three corners x y, separated by semicolons</source>
        <translation>Al menos tres vértices x y, separados por punto y coma</translation>
    </message>
    <message>
        <source>lidar %1 m</source>
        <translation>lidar de %1 m</translation>
    </message>
    <message>
        <source>%1 (default)</source>
        <translation>%1 (predet.)</translation>
    </message>
    <message>
        <source>Futures</source>
        <translation>Futuros</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>until the robot arrives, at most %1 s</source>
        <translation>hasta que llegue el robot, %1 s como máximo</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Mix behaviours</source>
        <translation>Mezclar comportamientos</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>No space for people here</source>
        <translation>Aquí no caben personas</translation>
    </message>
    <message>
        <source>Space for only %1 of %2</source>
        <translation>Solo caben %1 de %2</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Rellenar</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pincel</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Paint map</source>
        <translation>Pintar mapa</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Persona</translation>
    </message>
    <message>
        <source>Dock</source>
        <translation>Base de carga</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Alinear</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Distribuir</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rectángulo</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Door</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>partes</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Another seed generates different people</source>
        <translation>Otra semilla genera otras personas</translation>
    </message>
    <message>
        <source>Mix</source>
        <translation>Mezcla</translation>
    </message>
    <message>
        <source>All ages</source>
        <translation>Todas las edades</translation>
    </message>
    <message>
        <source>Adults</source>
        <translation>Adultos</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>Niños</translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation>Mayores</translation>
    </message>
    <message>
        <source>Wheelchairs</source>
        <translation>Sillas de ruedas</translation>
    </message>
    <message>
        <source>Luggage</source>
        <translation>Equipaje</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Cuerpos</translation>
    </message>
    <message>
        <source>Stand</source>
        <translation>Quietas</translation>
    </message>
    <message>
        <source>Walk to goals</source>
        <translation>Ir a objetivos</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Desplazar</translation>
    </message>
    <message>
        <source>, default %1</source>
        <translation>, %1 por defecto</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Árbol</translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation>No se puede ejecutar: %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>errores</translation>
    </message>
    <message>
        <source>Subtree</source>
        <translation>Subárbol</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En ejecución</translation>
    </message>
    <message>
        <source>Success</source>
        <translation>Éxito</translation>
    </message>
    <message>
        <source>Failure</source>
        <translation>Fallo</translation>
    </message>
    <message>
        <source>not ticked</source>
        <translation>sin tick</translation>
    </message>
    <message>
        <source>An %1</source>
        <translation>Un %1</translation>
    </message>
    <message>
        <source>A %1</source>
        <translation>Un %1</translation>
    </message>
    <message>
        <source>one child</source>
        <translation>un hijo</translation>
    </message>
    <message>
        <source>%1 children</source>
        <translation>%1 hijos</translation>
    </message>
    <message>
        <source>A tree can have only one root</source>
        <translation>Un árbol solo tiene una raíz</translation>
    </message>
    <message>
        <source>The node no longer exists</source>
        <translation>El nodo ya no existe</translation>
    </message>
    <message>
        <source>%1 takes no children</source>
        <translation>%1 no admite hijos</translation>
    </message>
    <message>
        <source>%1 takes one child only</source>
        <translation>%1 solo admite un hijo</translation>
    </message>
    <message>
        <source>%1 takes at most %2 children</source>
        <translation>%1 admite como máximo %2 hijos</translation>
    </message>
    <message>
        <source>A tree needs a root: replace it instead</source>
        <translation>Un árbol necesita una raíz: reemplácela</translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation>Seleccione antes un nodo</translation>
    </message>
    <message>
        <source>Only nodes with the same parent can be wrapped together</source>
        <translation>Solo se pueden envolver juntos nodos con el mismo padre</translation>
    </message>
    <message>
        <source>%1: %2 has %3</source>
        <translation>%1: %2 tiene %3</translation>
    </message>
    <message>
        <source>%1 has no children</source>
        <translation>%1 no tiene hijos</translation>
    </message>
    <message>
        <source>The root already has a tree of its own</source>
        <translation>La raíz ya tiene su propio árbol</translation>
    </message>
    <message>
        <source>Only a SubTree can be inlined</source>
        <translation>Solo se puede integrar un SubTree</translation>
    </message>
    <message>
        <source>%1 has its own blackboard entries</source>
        <translation>%1 tiene entradas propias en la pizarra</translation>
    </message>
    <message>
        <source>%1 has pre- or postconditions</source>
        <translation>%1 tiene pre- o poscondiciones</translation>
    </message>
    <message>
        <source>%1 is in an included file</source>
        <translation>%1 está en un archivo incluido</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 está vacío</translation>
    </message>
    <message>
        <source>%1 contains itself</source>
        <translation>%1 se contiene a sí mismo</translation>
    </message>
    <message>
        <source>The root has no siblings</source>
        <translation>La raíz no tiene hermanos</translation>
    </message>
    <message>
        <source>%1 is the only child</source>
        <translation>%1 es el único hijo</translation>
    </message>
    <message>
        <source>%1 is the first child</source>
        <translation>%1 es el primer hijo</translation>
    </message>
    <message>
        <source>%1 is the last child</source>
        <translation>%1 es el último hijo</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>Map file %1 cannot be used, so there are no walls: %2.</source>
        <translation>El archivo de mapa %1 no se puede usar, por lo que no hay paredes: %2.</translation>
    </message>
    <message>
        <source>The scenario specifies no map, so there are no walls.</source>
        <translation>El escenario no indica ningún mapa, por lo que no hay paredes.</translation>
    </message>
    <message>
        <source>Map file %1 not found, so there are no walls.</source>
        <translation>No se encuentra el archivo de mapa %1, por lo que no hay paredes.</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nuevo</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>reemplazado</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>sin cambios</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>*This part is generated; it is in the HTML pages of the manual.*
</source>
        <translation>*Esta parte se genera; está en las páginas HTML del manual.*
</translation>
    </message>
    <message>
        <source>%1 runs external code (%2) with your permissions.</source>
        <translation>%1 ejecuta código externo (%2) con sus permisos.</translation>
    </message>
    <message>
        <source>Allow for this file</source>
        <translation>Permitir para este archivo</translation>
    </message>
    <message>
        <source>Do not run</source>
        <translation>No ejecutar</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>The displayed run uses %1 of memory and %2 of disk space.</source>
        <translation>La ejecución mostrada usa %1 de memoria y %2 de disco.</translation>
    </message>
    <message>
        <source> The disk is full: the timeline starts at %1.</source>
        <translation> El disco está lleno: la línea de tiempo empieza en %1.</translation>
    </message>
    <message>
        <source>easy</source>
        <translation>fácil</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>hard</source>
        <translation>difícil</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot: %1</translation>
    </message>
    <message>
        <source>People: %1</source>
        <translation>Personas: %1</translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation>Esperado: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Fuente: %1</translation>
    </message>
    <message>
        <source>person</source>
        <translation>persona</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>%1 robots</source>
        <translation>%1 robots</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>ahora mismo</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>hace %1 min</translation>
    </message>
    <message>
        <source>%1 h ago</source>
        <translation>hace %1 h</translation>
    </message>
    <message>
        <source>Yesterday</source>
        <translation>Ayer</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>%1: restart (deletes them), or save as another file</source>
        <translation>%1: reiniciar (los borra) o guardar como otro archivo</translation>
    </message>
    <message>
        <source>the results in %1 have no results.sqlite, which is required to resume</source>
        <translation>los resultados de %1 no tienen results.sqlite, necesario para continuar</translation>
    </message>
    <message>
        <source>the results in %1 belong to another experiment</source>
        <translation>los resultados de %1 son de otro experimento</translation>
    </message>
    <message>
        <source>Planner</source>
        <translation>Planificador</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>escenario</translation>
    </message>
    <message>
        <source>scenarios</source>
        <translation>escenarios</translation>
    </message>
    <message>
        <source>%1 planners</source>
        <translation>%1 planificadores</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>semilla</translation>
    </message>
    <message>
        <source>seeds</source>
        <translation>semillas</translation>
    </message>
    <message>
        <source>run</source>
        <translation>ejecución</translation>
    </message>
    <message>
        <source>Layers
Choose what the map shows</source>
        <translation>Capas
Elegir qué muestra el mapa</translation>
    </message>
    <message>
        <source>&amp;Behaviour</source>
        <translation>&amp;Comportamiento</translation>
    </message>
    <message>
        <source>Select people first</source>
        <translation>Seleccione antes personas</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>No durante una ejecución: Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source>The scenario has no people yet</source>
        <translation>El escenario aún no tiene personas</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation>Siempre visible</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open recen&amp;t</source>
        <translation>Abrir rec&amp;iente</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>Organi&amp;zar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>All &amp;layers</source>
        <translation>Todas &amp;las capas</translation>
    </message>
    <message>
        <source>Trail length</source>
        <translation>Longitud de las estelas</translation>
    </message>
    <message>
        <source>&amp;Scenario</source>
        <translation>E&amp;scenario</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;jecución</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Paste here</source>
        <translation>Pegar aquí</translation>
    </message>
    <message>
        <source>Arrange</source>
        <translation>Organizar</translation>
    </message>
    <message>
        <source>Save the picture of the tree</source>
        <translation>Guardar la imagen del árbol</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>Gráficos vectoriales (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Documento (*.pdf)</translation>
    </message>
    <message>
        <source>Image (*.png)</source>
        <translation>Imagen (*.png)</translation>
    </message>
    <message>
        <source>d MMM</source>
        <comment>format of a date</comment>
        <translation>d MMM</translation>
    </message>
    <message>
        <source>d MMM yyyy</source>
        <comment>format of a date</comment>
        <translation>d MMM yyyy</translation>
    </message>
    <message>
        <source>lidar: not side by side</source>
        <translation>lidar: no en vistas paralelas</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Stop when the node starts to be ticked with this blackboard condition true, for example  id == 2:</source>
        <translation>Detener cuando el nodo empieza a recibir ticks con esta condición de la pizarra cumplida, por ejemplo  id == 2:</translation>
    </message>
    <message>
        <source>A condition becomes true…</source>
        <translation>Se cumple una condición…</translation>
    </message>
    <message>
        <source>Discard the branches?</source>
        <translation>¿Descartar las ramas?</translation>
    </message>
    <message>
        <source>The run and its branches (%1 runs in total) will be discarded.</source>
        <translation>Se descartarán la ejecución y sus ramas (%1 ejecuciones en total).</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Clave</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
</context>
<context>
    <name>Skin</name>
    <message>
        <source>Elegant man</source>
        <translation>Hombre elegante</translation>
    </message>
    <message>
        <source>Casual man</source>
        <translation>Hombre informal</translation>
    </message>
    <message>
        <source>Elegant woman</source>
        <translation>Mujer elegante</translation>
    </message>
    <message>
        <source>Regular man</source>
        <translation>Hombre corriente</translation>
    </message>
    <message>
        <source>Worker man</source>
        <translation>Trabajador</translation>
    </message>
    <message>
        <source>Blue jeans</source>
        <translation>Vaqueros azules</translation>
    </message>
    <message>
        <source>Green t-shirt</source>
        <translation>Camiseta verde</translation>
    </message>
    <message>
        <source>Blue t-shirt</source>
        <translation>Camiseta azul</translation>
    </message>
    <message>
        <source>Red t-shirt</source>
        <translation>Camiseta roja</translation>
    </message>
    <message>
        <source>Random (Isaac Sim)</source>
        <translation>Aleatorio (Isaac Sim)</translation>
    </message>
</context>
<context>
    <name>WhatsThis</name>
    <message>
        <source>Selects items on the map. Click an item, or drag over empty space to select several. Drag the selection to move it, its handles to resize or rotate it. Shift adds to the selection, Alt suspends snapping.</source>
        <translation>Selecciona elementos del mapa. Haga clic en un elemento, o arrastre sobre un espacio vacío para seleccionar varios. Arrastre la selección para moverla y sus tiradores para cambiar su tamaño o girarla. Mayús añade a la selección, Alt suspende el ajuste.</translation>
    </message>
    <message>
        <source>Places a person. Click the position, or press and drag to set the heading. A person walks when it has goals: place them with the goal tool and assign them with the route tool.</source>
        <translation>Coloca una persona. Haga clic en la posición, o pulse y arrastre para fijar la orientación. Una persona camina cuando tiene objetivos: colóquelos con la herramienta de objetivos y asígnelos con la de rutas.</translation>
    </message>
    <message>
        <source>Places people along a line. Drag a line; spacing, width and the mix of behaviours are set in the bar at the top left of the map.</source>
        <translation>Coloca personas a lo largo de una línea. Arrastre una línea; la separación, el ancho y la mezcla de comportamientos se ajustan en la barra de arriba a la izquierda del mapa.</translation>
    </message>
    <message>
        <source>Fills an area with people. Drag a rectangle or click the corners of an area; the number of people and their goals are set in the bar at the top left of the map.</source>
        <translation>Llena un área de personas. Arrastre un rectángulo o haga clic en los vértices de un área; el número de personas y sus objetivos se ajustan en la barra de arriba a la izquierda del mapa.</translation>
    </message>
    <message>
        <source>Places goals. Click free space to add a goal; drag a goal to move it. Several people can share a goal.</source>
        <translation>Coloca objetivos. Haga clic en un espacio libre para añadir un objetivo; arrastre un objetivo para moverlo. Varias personas pueden compartir un objetivo.</translation>
    </message>
    <message>
        <source>Assigns goals to a person or robot. Click the person, then its goals in visiting order, then press Enter.</source>
        <translation>Asigna objetivos a una persona o a un robot. Haga clic en la persona, luego en sus objetivos por orden de visita, y pulse Intro.</translation>
    </message>
    <message>
        <source>Draws a wall as a line of segments. Click each corner; Enter or a double click ends the wall. People and robots cannot cross it.</source>
        <translation>Dibuja una pared como línea de segmentos. Haga clic en cada vértice; Intro o un doble clic terminan la pared. Las personas y los robots no pueden cruzarla.</translation>
    </message>
    <message>
        <source>Draws a rectangular obstacle from corner to corner. Shift makes a square.</source>
        <translation>Dibuja un obstáculo rectangular de esquina a esquina. Mayús hace un cuadrado.</translation>
    </message>
    <message>
        <source>Draws an obstacle with any number of corners. Click each corner; Enter or a click on the first corner closes it.</source>
        <translation>Dibuja un obstáculo con cualquier número de vértices. Haga clic en cada vértice; Intro o un clic en el primer vértice lo cierra.</translation>
    </message>
    <message>
        <source>Draws a round obstacle. Drag from its centre to its edge.</source>
        <translation>Dibuja un obstáculo redondo. Arrastre desde su centro hasta su borde.</translation>
    </message>
    <message>
        <source>Draws a door. Drag from the hinge to the other jamb. The properties set when it opens and closes.</source>
        <translation>Dibuja una puerta. Arrastre desde la bisagra hasta la otra jamba. Las propiedades determinan cuándo se abre y se cierra.</translation>
    </message>
    <message>
        <source>Draws an area, for example a source or sink of people, or a zone with a speed limit. Choose the kind in the bar at the top left of the map.</source>
        <translation>Dibuja un área, por ejemplo una fuente o un sumidero de personas, o una zona con límite de velocidad. Elija el tipo en la barra de arriba a la izquierda del mapa.</translation>
    </message>
    <message>
        <source>Places the robot and its goal. Click the position (drag to set the heading), then click the goal. Shift adds another robot.</source>
        <translation>Coloca el robot y su objetivo. Haga clic en la posición (arrastre para fijar la orientación) y luego en el objetivo. Mayús añade otro robot.</translation>
    </message>
    <message>
        <source>Places a charging dock for robots with Nav2. Click the position of the docked robot and drag to set its heading.</source>
        <translation>Coloca una base de carga para robots con Nav2. Haga clic en la posición del robot acoplado y arrastre para fijar su orientación.</translation>
    </message>
    <message>
        <source>Paints walls, free or unknown space into the cells of the map. Keys 1, 2 and 3 choose the kind, [ and ] the width.</source>
        <translation>Pinta paredes, espacio libre o desconocido en las celdas del mapa. Las teclas 1, 2 y 3 eligen el tipo, [ y ] el ancho.</translation>
    </message>
    <message>
        <source>Measures a distance and an angle. Drag from one point to another; the result is shown in the status bar.</source>
        <translation>Mide una distancia y un ángulo. Arrastre de un punto a otro; el resultado se muestra en la barra de estado.</translation>
    </message>
    <message>
        <source>Removes items. Click them or drag over them. Routes of people are updated. Undo restores everything.</source>
        <translation>Quita elementos. Haga clic en ellos o arrastre por encima. Las rutas de las personas se actualizan. Deshacer lo restaura todo.</translation>
    </message>
    <message>
        <source>Moves the map. With any other tool, drag with the middle button, or hold Space and drag.</source>
        <translation>Desplaza el mapa. Con cualquier otra herramienta, arrastre con el botón central, o mantenga Espacio y arrastre.</translation>
    </message>
    <message>
        <source>Everything in the scenario as a list: people, goals, robots, obstacles and areas. Select entries here or on the map. Double-click a name or press F2 to change it.</source>
        <translation>Todo lo que hay en el escenario como lista: personas, objetivos, robots, obstáculos y áreas. Seleccione entradas aquí o en el mapa. Doble clic en un nombre o F2 para cambiarlo.</translation>
    </message>
    <message>
        <source>The properties of the selected items. A value in the secondary colour is the default; right-click a field to restore it. With nothing selected, the settings of the scenario are shown.</source>
        <translation>Las propiedades de los elementos seleccionados. Un valor en el color secundario es el predeterminado; clic derecho en un campo para restaurarlo. Sin selección se muestran los ajustes del escenario.</translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as an outline. During a run it shows which nodes are active. Click beside a node to set a breakpoint.</source>
        <translation>El árbol de comportamiento de la persona seleccionada como esquema. Durante una ejecución muestra qué nodos están activos. Haga clic junto a un nodo para poner un punto de interrupción.</translation>
    </message>
    <message>
        <source>Errors and warnings of the scenario, checked while you edit. Double-click an entry to go to its place; many entries offer a fix.</source>
        <translation>Errores y advertencias del escenario, comprobados mientras edita. Doble clic en una entrada para ir a su lugar; muchas ofrecen un arreglo.</translation>
    </message>
    <message>
        <source>The metrics of the displayed run, updated while it runs. Select a metric to plot it over time; hover over it to read its definition.</source>
        <translation>Las métricas de la ejecución mostrada, actualizadas mientras se ejecuta. Seleccione una métrica para ver su gráfica en el tiempo; ponga el ratón encima para leer su definición.</translation>
    </message>
    <message>
        <source>What happened in the run: contacts, arrivals, reactions. Click an entry to show that moment.</source>
        <translation>Lo que ocurrió en la ejecución: contactos, llegadas, reacciones. Haga clic en una entrada para mostrar ese momento.</translation>
    </message>
    <message>
        <source>Branches of the run and recorded runs. Check several to compare their metrics and paths.</source>
        <translation>Ramas de la ejecución y ejecuciones grabadas. Marque varias para comparar sus métricas y caminos.</translation>
    </message>
    <message>
        <source>Repeats the rest of the run many times from the displayed moment and shows how often a contact occurs.</source>
        <translation>Repite muchas veces el resto de la ejecución desde el momento mostrado e indica con qué frecuencia hay un contacto.</translation>
    </message>
    <message>
        <source>What the map shows: people, routes, sensor data, costmaps and other layers, each with its opacity.</source>
        <translation>Lo que muestra el mapa: personas, rutas, datos de sensores, mapas de costes y otras capas, cada una con su opacidad.</translation>
    </message>
    <message>
        <source>The Nav2 parameters of the selected robot with defaults and explanations. Search by name, or show only what was changed.</source>
        <translation>Los parámetros de Nav2 del robot seleccionado con valores predeterminados y explicaciones. Busque por nombre, o muestre solo lo que ha cambiado.</translation>
    </message>
    <message>
        <source>The behaviour tree of the selected person as a graph. Drag nodes from the palette, press F8 to use the whole window.</source>
        <translation>El árbol de comportamiento de la persona seleccionada como grafo. Arrastre nodos desde la paleta, pulse F8 para usar toda la ventana.</translation>
    </message>
    <message>
        <source>Open the manual (F1)</source>
        <translation>Abrir el manual (F1)</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>The scenario. The wheel zooms, the middle button or Space and drag move the map. The status bar shows what the mouse does with the active tool. During a run, click a person for details; right-click to push, stop or add people.</source>
        <translation>El escenario. La rueda amplía y reduce, el botón central o Espacio y arrastrar mueven el mapa. La barra de estado dice qué hace el ratón con la herramienta activa. Durante una ejecución, haga clic en una persona para ver los detalles; clic derecho para empujar, detener o añadir personas.</translation>
    </message>
    <message>
        <source>Runs scenarios with several planners and seeds and compares them with confidence intervals in a report. It also shows the results of tune, gate, sensitivity and search.</source>
        <translation>Ejecuta escenarios con varios planificadores y semillas y los compara con intervalos de confianza en un informe. También muestra los resultados de tune, gate, sensitivity y search.</translation>
    </message>
</context>
<context>
    <name>app::CommandPalette</name>
    <message>
        <source>Not available at the moment</source>
        <translation>No disponible en este momento</translation>
    </message>
    <message>
        <source>Type a command or a key</source>
        <translation>Escriba una orden o una tecla</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Buscar una orden</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
</context>
<context>
    <name>app::ContactNotes</name>
    <message>
        <source>Until here %1 could avoid the contact with %2 at %3 s: %4</source>
        <translation>Hasta aquí %1 podía evitar el contacto con %2 a los %3 s: %4</translation>
    </message>
</context>
<context>
    <name>app::CoverPage</name>
    <message>
        <source>Trees</source>
        <translation>Árboles</translation>
    </message>
    <message>
        <source>Never reached</source>
        <translation>Nunca alcanzados</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Árbol</translation>
    </message>
    <message>
        <source>Used by</source>
        <translation>Usado por</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Escenarios</translation>
    </message>
    <message>
        <source>Reached nodes</source>
        <translation>Nodos alcanzados</translation>
    </message>
    <message>
        <source>Unreachable</source>
        <translation>Inalcanzables</translation>
    </message>
    <message>
        <source>Nodes of the behaviour trees of people and of Nav2 that at least one run has executed. Unreachable: the structure of the tree excludes them.</source>
        <translation>Nodos de los árboles de comportamiento de personas y de Nav2 que al menos una ejecución ha ejecutado. Inalcanzables: la estructura del árbol los excluye.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Nodo</translation>
    </message>
    <message>
        <source>All nodes that can be reached were reached.</source>
        <translation>Se alcanzaron todos los nodos que se pueden alcanzar.</translation>
    </message>
    <message>
        <source>No run has executed a node of a behaviour tree.</source>
        <translation>Ninguna ejecución ha ejecutado un nodo de un árbol de comportamiento.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Final</translation>
    </message>
    <message>
        <source>New nodes</source>
        <translation>Nodos nuevos</translation>
    </message>
    <message>
        <source>Double-click a run to play it</source>
        <translation>Doble clic en una ejecución para reproducirla</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>la ejecución %1</translation>
    </message>
    <message>
        <source>Runs that executed nodes which no earlier run had executed. Double-click or Enter plays a run.</source>
        <translation>Ejecuciones que ejecutaron nodos que ninguna anterior había ejecutado. Doble clic o Intro reproducen una ejecución.</translation>
    </message>
</context>
<context>
    <name>app::DiffView</name>
    <message>
        <source>Differences</source>
        <translation>Diferencias</translation>
    </message>
    <message>
        <source>1 equal line</source>
        <translation>1 línea igual</translation>
    </message>
    <message>
        <source>%1 equal lines</source>
        <translation>%1 líneas iguales</translation>
    </message>
</context>
<context>
    <name>app::Docks</name>
    <message>
        <source>&amp;Map only</source>
        <translation>&amp;Solo el mapa</translation>
    </message>
    <message>
        <source>Close all panels; select again to restore them</source>
        <translation>Cerrar todos los paneles; repita para restaurarlos</translation>
    </message>
    <message>
        <source>Tree instead of the map</source>
        <translation>Árbol en lugar del mapa</translation>
    </message>
    <message>
        <source>Show the behaviour tree instead of the map; select again to show the map</source>
        <translation>Mostrar el árbol de comportamiento en lugar del mapa; repita para mostrar el mapa</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>Always visible</source>
        <translation>Siempre visible</translation>
    </message>
    <message>
        <source>Open or close this panel</source>
        <translation>Abrir o cerrar este panel</translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation>Abra antes un escenario</translation>
    </message>
</context>
<context>
    <name>app::DocumentGuard</name>
    <message>
        <source>Export failed: %1.</source>
        <translation>La exportación falló: %1.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Cannot save a copy for crash recovery: %1</source>
        <translation>No se puede guardar una copia de seguridad: %1</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Unsaved changes of an earlier session cannot be read: %1</source>
        <translation>Los cambios sin guardar de una sesión anterior no se pueden leer: %1</translation>
    </message>
    <message>
        <source>an unnamed scenario</source>
        <translation>un escenario sin nombre</translation>
    </message>
    <message>
        <source>The program ended unexpectedly. Unsaved changes to %1 were kept (%2).</source>
        <translation>El programa terminó de forma inesperada. Se conservaron los cambios sin guardar de %1 (%2).</translation>
    </message>
    <message>
        <source>Unsaved changes to %1 were kept when the last session ended (%2).</source>
        <translation>Se conservaron los cambios sin guardar de %1 al terminar la última sesión (%2).</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>%1 was changed by another program. Reloading discards unsaved changes.</source>
        <translation>Otro programa modificó %1. Volver a cargar descarta los cambios sin guardar.</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>Otro programa modificó %1.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Keep mine</source>
        <translation>Conservar lo mío</translation>
    </message>
    <message>
        <source>%1 was moved or deleted by another program. It is still open here.</source>
        <translation>Otro programa movió o borró %1. Aquí sigue abierto.</translation>
    </message>
    <message>
        <source>Save again</source>
        <translation>Guardar de nuevo</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>%1 is also open in another window. The window that saves last overwrites the changes of the other.</source>
        <translation>%1 también está abierto en otra ventana. La última que guarde sobrescribe los cambios de la otra.</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be read. It will not be overwritten.</source>
        <translation>%1 está dañado y no se puede leer. No se sobrescribirá.</translation>
    </message>
    <message>
        <source>%1 is damaged and only partly loaded. It will not be overwritten.</source>
        <translation>%1 está dañado y solo se cargó en parte. No se sobrescribirá.</translation>
    </message>
    <message>
        <source>Choose map…</source>
        <translation>Elegir mapa…</translation>
    </message>
    <message>
        <source>Use open plane</source>
        <translation>Usar un plano abierto</translation>
    </message>
    <message>
        <source>Cannot open a file manager. The files are in %1.</source>
        <translation>No se puede abrir un gestor de archivos. Los archivos están en %1.</translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>Se exportaron %1 a %2.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>files</source>
        <translation>archivos</translation>
    </message>
    <message>
        <source>Show folder</source>
        <translation>Mostrar carpeta</translation>
    </message>
    <message>
        <source>%1 was not saved: %2. Your changes are not lost.</source>
        <translation>%1 no se guardó: %2. No se pierden sus cambios.</translation>
    </message>
    <message>
        <source>The file cannot be opened: %1</source>
        <translation>No se puede abrir el archivo: %1</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>No se puede abrir %1: %2</translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Simulator</source>
        <translation>Simulador</translation>
    </message>
    <message>
        <source>Files to write</source>
        <translation>Archivos que se escribirán</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>&amp;Elegir…</translation>
    </message>
    <message>
        <source>Export folder</source>
        <translation>Carpeta de exportación</translation>
    </message>
    <message>
        <source>For the simulator&apos;s package</source>
        <translation>Para el paquete del simulador</translation>
    </message>
    <message>
        <source>HuNavSim 2.0</source>
        <translation>HuNavSim 2.0</translation>
    </message>
    <message>
        <source>HuNavSim (2024)</source>
        <translation>HuNavSim (2024)</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Corregido</translation>
    </message>
    <message>
        <source>As in HuNavSim 2.0</source>
        <translation>Como en HuNavSim 2.0</translation>
    </message>
    <message>
        <source>Missing trees</source>
        <translation>Árboles que faltan</translation>
    </message>
    <message>
        <source>Launch command</source>
        <translation>Orden de inicio</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>Co&amp;piar</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copiado</translation>
    </message>
    <message>
        <source>HuNavSim folder layout, for any simulator</source>
        <translation>Estructura de carpetas de HuNavSim, para cualquier simulador</translation>
    </message>
    <message>
        <source>For %1</source>
        <translation>Para %1</translation>
    </message>
    <message>
        <source>Files: %1, none replaced</source>
        <translation>Archivos: %1, ninguno reemplazado</translation>
    </message>
    <message>
        <source>Files: %1, replaced: %2</source>
        <translation>Archivos: %1, reemplazados: %2</translation>
    </message>
    <message>
        <source>Nothing is lost</source>
        <translation>No se pierde nada</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Información</translation>
    </message>
</context>
<context>
    <name>app::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Preparing the preview…</source>
        <translation>Preparando la vista previa…</translation>
    </message>
</context>
<context>
    <name>app::FigureCommands</name>
    <message>
        <source>Start a run first: Space</source>
        <translation>Inicie antes una ejecución: Espacio</translation>
    </message>
    <message>
        <source>Copied the map at %1 s as PNG and SVG</source>
        <translation>Se copió el mapa en %1 s como PNG y SVG</translation>
    </message>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation>Se copió la gráfica de «%1» como PNG y SVG</translation>
    </message>
</context>
<context>
    <name>app::FileCommands</name>
    <message>
        <source>Assign tree</source>
        <translation>Asignar árbol</translation>
    </message>
    <message>
        <source>Apply command-line options</source>
        <translation>Aplicar opciones de la línea de órdenes</translation>
    </message>
    <message>
        <source>Add command-line robot</source>
        <translation>Añadir robot de la línea de órdenes</translation>
    </message>
    <message>
        <source>Maps, map images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</source>
        <translation>Mapas, imágenes de mapa (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation>Abrir un escenario o un mapa</translation>
    </message>
    <message>
        <source>New scenario from a map</source>
        <translation>Nuevo escenario a partir de un mapa</translation>
    </message>
    <message>
        <source>Change map</source>
        <translation>Cambiar el mapa</translation>
    </message>
    <message>
        <source>Open run folder</source>
        <translation>Abrir carpeta de ejecución</translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation>%1 (truncado)</translation>
    </message>
    <message>
        <source>Import trajectories</source>
        <translation>Importar trayectorias</translation>
    </message>
    <message>
        <source>Trajectories (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;All files (*)</source>
        <translation>Trayectorias (*.csv *.txt *.tsv *.h5 *.hdf5 *.sqlite *.ndjson *.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>%1 was changed by another program after it was opened; saving overwrites those changes.</source>
        <translation>Otro programa modificó %1 después de abrirlo; al guardar se sobrescriben esos cambios.</translation>
    </message>
    <message>
        <source>%1 has a comment, which is lost when you save.</source>
        <translation>%1 tiene un comentario, que se pierde al guardar.</translation>
    </message>
    <message>
        <source>%1 has %2 comments, which are lost when you save.</source>
        <translation>%1 tiene %2 comentarios, que se pierden al guardar.</translation>
    </message>
    <message>
        <source>Save anyway?</source>
        <translation>¿Guardar de todos modos?</translation>
    </message>
    <message>
        <source>Overwrite the file?</source>
        <translation>¿Sobrescribir el archivo?</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>Guardar el escenario</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml)</source>
        <translation>Escenarios (*.yaml)</translation>
    </message>
    <message>
        <source>This file is a map</source>
        <translation>Este archivo es un mapa</translation>
    </message>
    <message>
        <source>%1 is a map or a map image. Saving the scenario there would overwrite it. Choose another name, such as %2.</source>
        <translation>%1 es un mapa o una imagen de mapa. Guardar ahí el escenario lo sobrescribiría. Elija otro nombre, como %2.</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>File not found</source>
        <translation>Archivo no encontrado</translation>
    </message>
    <message>
        <source>Save the changes to %1 first?</source>
        <translation>¿Guardar antes los cambios de %1?</translation>
    </message>
    <message>
        <source>%1 was moved or deleted. Save it again first?</source>
        <translation>%1 se movió o se borró. ¿Guardarlo de nuevo?</translation>
    </message>
    <message>
        <source>Scenarios, maps, map images, packed studies (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg *.hnv)</source>
        <translation>Escenarios, mapas, imágenes de mapa, estudios empaquetados (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg *.hnv)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Guardado %1</translation>
    </message>
</context>
<context>
    <name>app::GatePage</name>
    <message>
        <source>Base and candidate: means of the runs with a value. Difference candidate − base: mean over the pairs with its interval, which holds at all numbers of pairs; one pair counts at most 10 margins. The scale has 4 margins at both ends; the dotted line is the margin.</source>
        <translation>Base y candidato: medias de las ejecuciones con valor. Diferencia candidato − base: media de los pares con su intervalo, válido para cualquier número de pares; un par cuenta como máximo 10 márgenes. La escala llega a 4 márgenes en ambos extremos; la línea de puntos es el margen.</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pares</translation>
    </message>
    <message>
        <source>There is no pair in which only the candidate failed, and all metrics passed.</source>
        <translation>En ningún par ha fallado solo el candidato, y todas las métricas se superan.</translation>
    </message>
    <message>
        <source>Pairs in which the candidate is worse</source>
        <translation>Pares en los que el candidato es peor</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Candidate</source>
        <translation>Candidato</translation>
    </message>
    <message>
        <source>Double-click a pair to play the run of the candidate</source>
        <translation>Doble clic en un par para reproducir la ejecución del candidato</translation>
    </message>
    <message>
        <source>Runs in which only the candidate fails, then the largest losses by metrics that are not passed. Double-click or Enter plays the run of the candidate, the context menu also that of the base.</source>
        <translation>Ejecuciones en las que solo el candidato no tiene éxito y, después, las mayores pérdidas en las métricas no superadas. Doble clic o Intro reproducen la ejecución del candidato; el menú contextual, también la de la base.</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1, semilla %2</translation>
    </message>
    <message>
        <source>the candidate in %1</source>
        <translation>el candidato en %1</translation>
    </message>
    <message>
        <source>the base in %1</source>
        <translation>la base en %1</translation>
    </message>
    <message>
        <source>Play the candidate</source>
        <translation>Reproducir el candidato</translation>
    </message>
    <message>
        <source>Play the base</source>
        <translation>Reproducir la base</translation>
    </message>
</context>
<context>
    <name>app::GuidedTour</name>
    <message>
        <source>Place a person</source>
        <translation>Coloque una persona</translation>
    </message>
    <message>
        <source>Give the person a goal</source>
        <translation>Dé un objetivo a la persona</translation>
    </message>
    <message>
        <source>Run the simulation</source>
        <translation>Ejecute la simulación</translation>
    </message>
    <message>
        <source>Read a metric</source>
        <translation>Lea una métrica</translation>
    </message>
    <message>
        <source>You have run your first scenario</source>
        <translation>Ha ejecutado su primer escenario</translation>
    </message>
    <message>
        <source>Click on the map where the person should walk to.</source>
        <translation>Haga clic en el mapa donde la persona debe ir.</translation>
    </message>
    <message>
        <source>Press %1 or click the goal tool.</source>
        <translation>Pulse %1 o haga clic en la herramienta de objetivos.</translation>
    </message>
    <message>
        <source>Click the person, then the goal, then press Enter.</source>
        <translation>Haga clic en la persona, luego en el objetivo, y pulse Intro.</translation>
    </message>
    <message>
        <source>The goal is placed; now assign it. Press %1 for the route tool, click the person, then the goal, then press Enter.</source>
        <translation>El objetivo está puesto; ahora asígnelo. Pulse %1 para la herramienta de rutas, haga clic en la persona, luego en el objetivo, y pulse Intro.</translation>
    </message>
    <message>
        <source>Click on the map where the person should start.</source>
        <translation>Haga clic en el mapa donde la persona debe empezar.</translation>
    </message>
    <message>
        <source>Press %1 or click the person tool.</source>
        <translation>Pulse %1 o haga clic en la herramienta de personas.</translation>
    </message>
    <message>
        <source>Press Space, or Play in the tool bar.</source>
        <translation>Pulse Espacio, o Reproducir en la barra de herramientas.</translation>
    </message>
    <message>
        <source>Click Metrics in the status bar at the bottom.</source>
        <translation>Haga clic en Métricas en la barra de estado, abajo.</translation>
    </message>
    <message>
        <source>First scenario in the manual</source>
        <translation>Primer escenario en el manual</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Visita guiada</translation>
    </message>
    <message>
        <source>Tour finished</source>
        <translation>Visita terminada</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Paso %1 de %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Skip tour</source>
        <translation>Omitir la visita</translation>
    </message>
    <message>
        <source>Close the tour</source>
        <translation>Cerrar la visita</translation>
    </message>
    <message>
        <source>End the tour; the scenario stays open</source>
        <translation>Terminar la visita; el escenario sigue abierto</translation>
    </message>
    <message>
        <source>Open the manual</source>
        <translation>Abrir el manual</translation>
    </message>
    <message>
        <source>Place a robot</source>
        <translation>Coloque un robot</translation>
    </message>
    <message>
        <source>Click on the map where the robot should drive to.</source>
        <translation>Haga clic en el mapa donde el robot debe ir.</translation>
    </message>
    <message>
        <source>Click on the map where the robot should start.</source>
        <translation>Haga clic en el mapa donde el robot debe empezar.</translation>
    </message>
    <message>
        <source>The robot needs a goal. Press %1 for the robot tool, click where it should start, then where it should drive to.</source>
        <translation>El robot necesita un objetivo. Pulse %1 para la herramienta de robots, haga clic donde debe empezar y luego donde debe ir.</translation>
    </message>
    <message>
        <source>Press %1 or click the robot tool.</source>
        <translation>Pulse %1 o haga clic en la herramienta de robots.</translation>
    </message>
    <message>
        <source>Person and robot move to their goals …</source>
        <translation>La persona y el robot van hacia sus objetivos …</translation>
    </message>
    <message>
        <source>Click a metric with a value, such as Path length, to plot it over time.</source>
        <translation>Haga clic en una métrica con valor, como Longitud del camino, para ver su gráfica en el tiempo.</translation>
    </message>
    <message>
        <source>Ctrl+R returns to editing, %1 finds every command, F1 opens the manual.</source>
        <translation>Ctrl+R vuelve a la edición, %1 encuentra todas las órdenes, F1 abre el manual.</translation>
    </message>
</context>
<context>
    <name>app::HistoryDialog</name>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory per run</source>
        <translation>Memoria por ejecución</translation>
    </message>
    <message>
        <source>Memory per run
Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation>Memoria por ejecución
Memoria para los pasos de una ejecución que la línea de tiempo puede mostrar. 200 personas necesitan unos 12 MB por minuto.</translation>
    </message>
    <message>
        <source>Older steps are stored in a temporary file until the run is closed. When the disk is full, the oldest are deleted and the timeline starts later.</source>
        <translation>Los pasos más antiguos se guardan en un archivo temporal hasta que se cierra la ejecución. Cuando el disco se llena, se borran los más antiguos y la línea de tiempo empieza más tarde.</translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation>Se aplica a las ejecuciones que se inicien a partir de ahora.</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Memory for runs</source>
        <translation>Memoria para ejecuciones</translation>
    </message>
</context>
<context>
    <name>app::ImageMapDialog</name>
    <message>
        <source>Map from an image</source>
        <translation>Mapa a partir de una imagen</translation>
    </message>
    <message>
        <source> m per pixel</source>
        <translation> m por píxel</translation>
    </message>
    <message>
        <source>Create map</source>
        <translation>Crear mapa</translation>
    </message>
    <message>
        <source>Map scale</source>
        <translation>Escala del mapa</translation>
    </message>
    <message>
        <source>Distance 1 – 2</source>
        <translation>Distancia 1 – 2</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Click two points with a known distance, such as the ends of a wall.</source>
        <translation>Haga clic en dos puntos a una distancia conocida, como los extremos de una pared.</translation>
    </message>
    <message>
        <source>Click the second point.</source>
        <translation>Haga clic en el segundo punto.</translation>
    </message>
    <message>
        <source>Enter the distance between the two points. You can drag them.</source>
        <translation>Escriba la distancia entre los dos puntos. Puede arrastrarlos.</translation>
    </message>
    <message>
        <source>%1 m per pixel is out of range (%2 to %3).</source>
        <translation>%1 m por píxel está fuera del intervalo (%2 a %3).</translation>
    </message>
    <message>
        <source>Position of lower left corner</source>
        <translation>Posición de la esquina inferior izquierda</translation>
    </message>
    <message>
        <source>Position of point 1</source>
        <translation>Posición del punto 1</translation>
    </message>
    <message>
        <source>The map will be %1 × %2 m.</source>
        <translation>El mapa medirá %1 × %2 m.</translation>
    </message>
    <message>
        <source>By two points in the image</source>
        <translation>Por dos puntos de la imagen</translation>
    </message>
    <message>
        <source>By resolution</source>
        <translation>Por resolución</translation>
    </message>
</context>
<context>
    <name>app::KeyMap</name>
    <message>
        <source>%1 is used by fields, lists and tools and cannot be assigned.</source>
        <translation>Los campos, listas y herramientas usan %1; no se puede asignar.</translation>
    </message>
</context>
<context>
    <name>app::KeyRules</name>
    <message>
        <source>While you edit text, the text field handles all keys that it uses; number fields do not use Space. Enter accepts the text, Esc discards it; both return the keyboard focus to the map. Ctrl+Z undoes typing only while an edit is not accepted.</source>
        <translation>Mientras edita un texto, el campo de texto recibe todas las teclas que usa; los campos numéricos no usan Espacio. Intro acepta el texto, Esc lo descarta; ambos devuelven el foco del teclado al mapa. Ctrl+Z deshace lo escrito solo mientras una edición no se ha aceptado.</translation>
    </message>
    <message>
        <source>A list handles the keys that move in it, Space in rows with a check box, and Delete if its rows can be removed. Only in the scenario list does Delete remove the selection on the map.</source>
        <translation>Una lista recibe las teclas que mueven dentro de ella, Espacio en filas con casilla, y Supr si sus filas se pueden quitar. Solo en la lista del escenario Supr quita la selección del mapa.</translation>
    </message>
    <message>
        <source>A click on a button, check box or combo box does not move the keyboard focus. After you reach one with Tab, use Space and the arrow keys.</source>
        <translation>Un clic en un botón, casilla o lista desplegable no mueve el foco del teclado. Tras llegar a uno con Tab, use Espacio y las flechas.</translation>
    </message>
    <message>
        <source>All other keys go to the commands of the window, such as Space to run and pause, then to the map tool. The arrow keys move items only while the map has the focus; while you drive a robot manually, they drive it, as do W, A, S and D.</source>
        <translation>Todas las demás teclas van a las órdenes de la ventana, como Espacio para ejecutar y pausar, y luego a la herramienta del mapa. Las flechas mueven elementos solo cuando el mapa tiene el foco; mientras conduce un robot manualmente, lo conducen, igual que W, A, S y D.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Saved %1</source>
        <translation>Guardado %1</translation>
    </message>
    <message>
        <source>A recorded run cannot be edited: Ctrl+R closes it</source>
        <translation>Una ejecución grabada no se puede editar: Ctrl+R la cierra</translation>
    </message>
    <message>
        <source>Open a scenario first</source>
        <translation>Abra antes un escenario</translation>
    </message>
    <message>
        <source>A recorded run is shown: Ctrl+R closes it</source>
        <translation>Se muestra una ejecución grabada: Ctrl+R la cierra</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>No durante una ejecución: Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source>HuNavSim Desktop</source>
        <translation>HuNavSim Desktop</translation>
    </message>
    <message>
        <source>%1 (recorded run) – HuNavSim Desktop</source>
        <translation>%1 (ejecución grabada) – HuNavSim Desktop</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Ejecución grabada</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Sin guardar</translation>
    </message>
    <message>
        <source>Read only</source>
        <translation>Solo lectura</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Guardado</translation>
    </message>
    <message>
        <source>The options of the command line replace values of %1. Saving writes them to the file.</source>
        <translation>Las opciones de la línea de órdenes sustituyen valores de %1. Al guardar se escriben en el archivo.</translation>
    </message>
    <message>
        <source>Use the values of the file</source>
        <translation>Usar los valores del archivo</translation>
    </message>
    <message>
        <source>About HuNavSim Desktop</source>
        <translation>Acerca de HuNavSim Desktop</translation>
    </message>
    <message>
        <source>&lt;b&gt;HuNavSim Desktop %1&lt;/b&gt;&lt;br&gt;Scenarios for human-aware navigation: draw, simulate, measure.</source>
        <translation>&lt;b&gt;HuNavSim Desktop %1&lt;/b&gt;&lt;br&gt;Escenarios para la navegación consciente de las personas: dibujar, simular, medir.</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
</context>
<context>
    <name>app::ManualViewer</name>
    <message>
        <source>Search the manual</source>
        <translation>Buscar en el manual</translation>
    </message>
    <message>
        <source>HuNavSim Desktop manual</source>
        <translation>Manual de HuNavSim Desktop</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Show the previous page</source>
        <translation>Mostrar la página anterior</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Adelante</translation>
    </message>
    <message>
        <source>Show the next page again</source>
        <translation>Volver a mostrar la página siguiente</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source># Page not found

The manual has no file `%1.md` in `%2`. Reinstall the program, or read the manual on the project&apos;s page.</source>
        <translation># Página no encontrada

El manual no tiene el archivo `%1.md` en `%2`. Reinstale el programa, o lea el manual en la página del proyecto.</translation>
    </message>
</context>
<context>
    <name>app::NoticeBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
</context>
<context>
    <name>app::OutputPage</name>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>no medida</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>superada</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>sin decidir</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrica</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Candidate</source>
        <translation>Candidato</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pares</translation>
    </message>
    <message>
        <source>Pass: %1 is not worse than %2</source>
        <translation>Superado: %1 no es peor que %2</translation>
    </message>
    <message>
        <source>Worse: %1 is worse than %2 in %3</source>
        <translation>Peor: %1 es peor que %2 en %3</translation>
    </message>
    <message>
        <source>Undecided: %1 pairs do not show whether %2 is worse than %3</source>
        <translation>Sin decidir: %1 pares no muestran si %2 es peor que %3</translation>
    </message>
    <message>
        <source>%1 (more than %2)</source>
        <translation>%1 (más de %2)</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Standstill</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Navigation failed</source>
        <translation>Navegación fallida</translation>
    </message>
    <message>
        <source>Time limit</source>
        <translation>Límite de tiempo</translation>
    </message>
    <message>
        <source>Run aborted</source>
        <translation>Ejecución interrumpida</translation>
    </message>
    <message>
        <source>person in front</source>
        <translation>persona delante</translation>
    </message>
    <message>
        <source>person on the left</source>
        <translation>persona a la izquierda</translation>
    </message>
    <message>
        <source>person on the right</source>
        <translation>persona a la derecha</translation>
    </message>
    <message>
        <source>person behind</source>
        <translation>persona detrás</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstáculo</translation>
    </message>
    <message>
        <source>no person near</source>
        <translation>ninguna persona cerca</translation>
    </message>
    <message>
        <source>before the end of the run</source>
        <translation>antes del final de la ejecución</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>standing</source>
        <translation>de pie</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>run</source>
        <translation>ejecución</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>ejecuciones</translation>
    </message>
    <message>
        <source>kind of failure</source>
        <translation>tipo de fallo</translation>
    </message>
    <message>
        <source>kinds of failures</source>
        <translation>tipos de fallos</translation>
    </message>
    <message>
        <source>Contacts that the robot could not have avoided since first sight do not count: %1</source>
        <translation>Contactos que el robot no podía evitar desde la primera vez que vio a la persona, que no cuentan: %1</translation>
    </message>
    <message>
        <source>Runs that could not start: %1</source>
        <translation>Ejecuciones que no pudieron empezar: %1</translation>
    </message>
    <message>
        <source>the confidence interval of %1 is wider than its index</source>
        <translation>el intervalo de confianza de %1 es más ancho que su índice</translation>
    </message>
    <message>
        <source>about %1 points would be needed instead of %2</source>
        <translation>harían falta unos %1 puntos en lugar de %2</translation>
    </message>
    <message>
        <source>the order of %1 and %2 is not certain</source>
        <translation>el orden de %1 y %2 no es seguro</translation>
    </message>
    <message>
        <source>%1 of the variance between points is due to the choice of seeds</source>
        <translation>el %1 de la varianza entre puntos se debe a la elección de semillas</translation>
    </message>
    <message>
        <source>points without a value, which are excluded: %1</source>
        <translation>puntos sin valor, que se excluyen: %1</translation>
    </message>
    <message>
        <source>Confidence interval: %1 to %2</source>
        <translation>Intervalo de confianza: de %1 a %2</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>values</source>
        <translation>valores</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>semilla</translation>
    </message>
    <message>
        <source>seeds</source>
        <translation>semillas</translation>
    </message>
    <message>
        <source>Morris screening: %1 trajectories, %2</source>
        <translation>Cribado de Morris: %1 trayectorias, %2</translation>
    </message>
    <message>
        <source>Sobol indices: %1 base points, %2</source>
        <translation>Índices de Sobol: %1 puntos base, %2</translation>
    </message>
    <message>
        <source>success %1 before, %2 after</source>
        <translation>éxito %1 antes, %2 después</translation>
    </message>
    <message>
        <source>none (before)</source>
        <translation>ninguno (antes)</translation>
    </message>
    <message>
        <source>Improved: %1</source>
        <translation>Mejorado: %1</translation>
    </message>
    <message>
        <source>No improvement found: on new runs the best candidate is not clearly better: %1</source>
        <translation>No se encontró ninguna mejora: en ejecuciones nuevas el mejor candidato no es claramente mejor: %1</translation>
    </message>
    <message>
        <source>No improvement found: none of %1 candidates was better than the current values</source>
        <translation>No se encontró ninguna mejora: ninguno de %1 candidatos fue mejor que los valores actuales</translation>
    </message>
    <message>
        <source>%1 of %2 nodes of behaviour trees were reached in %3</source>
        <translation>Se alcanzaron %1 de %2 nodos de árboles de comportamiento en %3</translation>
    </message>
    <message>
        <source>Nodes that cannot be reached: %1</source>
        <translation>Nodos que no se pueden alcanzar: %1</translation>
    </message>
    <message>
        <source>Nothing tried: the limit of runs (--runs) is too small</source>
        <translation>No se ha probado nada: el límite de ejecuciones (--runs) es demasiado bajo</translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Copied the plot of “%1” as PNG and SVG</source>
        <translation>Se copió la gráfica de «%1» como PNG y SVG</translation>
    </message>
    <message>
        <source>Save plot</source>
        <translation>Guardar gráfica</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Imagen (*.png)</translation>
    </message>
    <message>
        <source>Vector picture (*.svg)</source>
        <translation>Imagen vectorial (*.svg)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved the plot of “%1” to %2</source>
        <translation>Se guardó la gráfica de «%1» en %2</translation>
    </message>
</context>
<context>
    <name>app::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>&amp;General</source>
        <translation>&amp;General</translation>
    </message>
    <message>
        <source>&amp;Files</source>
        <translation>&amp;Archivos</translation>
    </message>
    <message>
        <source>Key&amp;board</source>
        <translation>Te&amp;clado</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Colours of the window</source>
        <translation>Colores de la ventana</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Language of the window</source>
        <translation>Idioma de la ventana</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>Takes effect at the next start.</source>
        <translation>Se usa a partir del próximo inicio.</translation>
    </message>
    <message>
        <source>Animations
Without animations, the map changes immediately</source>
        <translation>Animaciones
Sin ellas, el mapa cambia de inmediato</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Memory for the steps of a run that the timeline can show. 200 people need about 12 MB per minute.</source>
        <translation>Memoria para los pasos de una ejecución que la línea de tiempo puede mostrar. 200 personas necesitan unos 12 MB por minuto.</translation>
    </message>
    <message>
        <source>Applies to runs started from now on.</source>
        <translation>Se aplica a las ejecuciones que se inicien a partir de ahora.</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Números</translation>
    </message>
    <message>
        <source>Numbers have a decimal point (1.5) in every language, as in files. Fields also accept a comma.</source>
        <translation>Los números llevan punto decimal (1.5) en todos los idiomas, como en los archivos. Los campos también aceptan una coma.</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Elegir…</translation>
    </message>
    <message>
        <source>Choose the default folder</source>
        <translation>Elegir la carpeta predeterminada</translation>
    </message>
    <message>
        <source>Default folder</source>
        <translation>Carpeta predeterminada</translation>
    </message>
    <message>
        <source>Where file dialogs start for a scenario that is not saved yet</source>
        <translation>Dónde empiezan los diálogos de archivo para un escenario aún sin guardar</translation>
    </message>
    <message>
        <source>Folder of the last used file</source>
        <translation>Carpeta del último archivo usado</translation>
    </message>
    <message>
        <source>&amp;Default folder</source>
        <translation>Carpeta &amp;predeterminada</translation>
    </message>
    <message>
        <source>Copies of unsaved changes
After a crash, the program offers to restore them</source>
        <translation>Copias de los cambios sin guardar
Tras un fallo, el programa ofrece restaurarlas</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Copy interval</source>
        <translation>Copiar tras</translation>
    </message>
    <message>
        <source>The longest time between a change and its copy</source>
        <translation>El tiempo máximo entre un cambio y su copia</translation>
    </message>
    <message>
        <source>C&amp;opy interval</source>
        <translation>C&amp;opiar tras</translation>
    </message>
    <message>
        <source>The scenario file itself is written only when you save it.</source>
        <translation>El archivo del escenario solo se escribe cuando usted lo guarda.</translation>
    </message>
    <message>
        <source>R&amp;estore defaults</source>
        <translation>&amp;Restaurar valores predeterminados</translation>
    </message>
    <message>
        <source>Restore the defaults of all pages</source>
        <translation>Restaurar los valores predeterminados de todas las páginas</translation>
    </message>
    <message>
        <source>&amp;Animate zooming and fitting</source>
        <translation>A&amp;nimar el zoom y el encuadre</translation>
    </message>
    <message>
        <source>&amp;Keep copies of unsaved changes</source>
        <translation>&amp;Guardar copias de los cambios sin guardar</translation>
    </message>
    <message>
        <source>Follow system</source>
        <translation>Como el escritorio</translation>
    </message>
    <message>
        <source>Memory for runs</source>
        <translation>Memoria para ejecuciones</translation>
    </message>
    <message>
        <source>&amp;Memory for runs</source>
        <translation>&amp;Memoria para ejecuciones</translation>
    </message>
</context>
<context>
    <name>app::RecentRow</name>
    <message>
        <source>File not found</source>
        <translation>Archivo no encontrado</translation>
    </message>
    <message>
        <source>File not found in </source>
        <translation>Archivo no encontrado en </translation>
    </message>
    <message>
        <source>Folder not found: </source>
        <translation>Carpeta no encontrada: </translation>
    </message>
</context>
<context>
    <name>app::RoomDialog</name>
    <message>
        <source>New empty room</source>
        <translation>Nueva sala vacía</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Room with four walls</source>
        <translation>Sala con cuatro paredes</translation>
    </message>
    <message>
        <source>Open plane without a map</source>
        <translation>Plano abierto sin mapa</translation>
    </message>
</context>
<context>
    <name>app::RunExportCommands</name>
    <message>
        <source>Open a scenario or a run first</source>
        <translation>Abra antes un escenario o una ejecución</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>Inicie antes una ejecución: Espacio</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Save film</source>
        <translation>Guardar película</translation>
    </message>
</context>
<context>
    <name>app::RunExportDialog</name>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>Hall zones</source>
        <translation>Zonas de Hall</translation>
    </message>
    <message>
        <source>Gaussian spaces</source>
        <translation>Espacios gaussianos</translation>
    </message>
    <message>
        <source>Velocities</source>
        <translation>Velocidades</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Fuerzas</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>%1 – requires ffmpeg</source>
        <translation>%1 – requiere ffmpeg</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formato</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Time marks</source>
        <translation>Marcas de tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>Superposiciones</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>No se guardó: %1</translation>
    </message>
    <message>
        <source>Stopped. No file was written.</source>
        <translation>Detenido. No se escribió ningún archivo.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>People per m² as colours</source>
        <translation>Personas por m² como colores</translation>
    </message>
    <message>
        <source>Intimate, personal and social zone around each person, after E. T. Hall: 0.45, 1.2 and 3.6 m</source>
        <translation>Zonas íntima, personal y social alrededor de cada persona, según E. T. Hall: 0.45, 1.2 y 3.6 m</translation>
    </message>
    <message>
        <source>Personal space of each person as a Gaussian function, longer in the walking direction</source>
        <translation>Espacio personal de cada persona como función gaussiana, más largo en la dirección de marcha</translation>
    </message>
    <message>
        <source>Velocity of each person and robot as an arrow</source>
        <translation>Velocidad de cada persona y robot como flecha</translation>
    </message>
    <message>
        <source>Forces on each person as arrows</source>
        <translation>Fuerzas sobre cada persona como flechas</translation>
    </message>
    <message>
        <source>Places where people or robots touched</source>
        <translation>Lugares donde se tocaron personas o robots</translation>
    </message>
    <message>
        <source>Marks each trajectory with the time at this interval; 0: no marks</source>
        <translation>Marca el tiempo en cada trayectoria a este intervalo; 0: sin marcas</translation>
    </message>
    <message>
        <source>Height
The lowest value, “automatic”, is the height that the map needs at this width</source>
        <translation>Alto
El valor más bajo, «automático», es el alto que el mapa necesita con este ancho</translation>
    </message>
    <message>
        <source>Names of people and robots</source>
        <translation>Nombres de personas y robots</translation>
    </message>
    <message>
        <source>Recorded runs contain no forces: run the scenario to show them</source>
        <translation>Las ejecuciones grabadas no contienen fuerzas: ejecute el escenario para mostrarlas</translation>
    </message>
    <message>
        <source>Only a run has this: run the scenario first</source>
        <translation>Solo lo tiene una ejecución: ejecute primero el escenario</translation>
    </message>
    <message>
        <source>The picture cannot be drawn: %1</source>
        <translation>No se puede dibujar la imagen: %1</translation>
    </message>
</context>
<context>
    <name>app::RunSharing</name>
    <message>
        <source>Watch this run at %1 (Foxglove: Open connection)</source>
        <translation>Vea esta ejecución en %1 (Foxglove: Open connection)</translation>
    </message>
    <message>
        <source>Copy address</source>
        <translation>Copiar dirección</translation>
    </message>
</context>
<context>
    <name>app::SaveFilmDialog</name>
    <message>
        <source>Save film</source>
        <translation>Guardar película</translation>
    </message>
    <message>
        <source>GIF</source>
        <translation>GIF</translation>
    </message>
    <message>
        <source>MP4 (H.264)</source>
        <translation>MP4 (H.264)</translation>
    </message>
    <message>
        <source>WebP</source>
        <translation>WebP</translation>
    </message>
    <message>
        <source>WebM (VP9)</source>
        <translation>WebM (VP9)</translation>
    </message>
    <message>
        <source>MP4, WebP and WebM require the program ffmpeg, which is not installed: sudo apt install ffmpeg</source>
        <translation>MP4, WebP y WebM requieren el programa ffmpeg, que no está instalado: sudo apt install ffmpeg</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Whole run</source>
        <translation>Ejecución completa</translation>
    </message>
    <message>
        <source>Loop section</source>
        <translation>Sección en bucle</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>fps</source>
        <translation>fps</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Simulated seconds per second of the film</source>
        <translation>Segundos simulados por segundo de la película</translation>
    </message>
    <message>
        <source>Time of the preview</source>
        <translation>Tiempo de la vista previa</translation>
    </message>
    <message>
        <source>Show another frame of the film in the preview</source>
        <translation>Mostrar otro fotograma de la película en la vista previa</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>The end must be after the start</source>
        <translation>El final debe ser posterior al inicio</translation>
    </message>
    <message>
        <source>HD, 1280 × 720</source>
        <translation>HD, 1280 × 720</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>Full HD, 1920 × 1080</translation>
    </message>
    <message>
        <source>From the start to the end of the run</source>
        <translation>Desde el inicio hasta el final de la ejecución</translation>
    </message>
    <message>
        <source>Only the section that the timeline repeats</source>
        <translation>Solo la sección que repite la línea de tiempo</translation>
    </message>
    <message>
        <source>Frames per second of the film; GIF viewers show at most %1</source>
        <translation>Fotogramas por segundo de la película; los visores de GIF muestran como máximo %1</translation>
    </message>
    <message>
        <source>Frames per second of the film</source>
        <translation>Fotogramas por segundo de la película</translation>
    </message>
    <message>
        <source>The film has %1 frames and lasts %2 s</source>
        <translation>La película tiene %1 fotogramas y dura %2 s</translation>
    </message>
    <message>
        <source>Map, 1280 px wide</source>
        <translation>Mapa, 1280 px de ancho</translation>
    </message>
    <message>
        <source>Small map, 640 px wide</source>
        <translation>Mapa pequeño, 640 px de ancho</translation>
    </message>
</context>
<context>
    <name>app::SavePictureDialog</name>
    <message>
        <source>Save picture</source>
        <translation>Guardar imagen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Time of the picture</source>
        <translation>Tiempo de la imagen</translation>
    </message>
    <message>
        <source>Slide, 16 : 9</source>
        <translation>Diapositiva, 16 : 9</translation>
    </message>
    <message>
        <source>PNG – pixel graphics</source>
        <translation>PNG – gráficos de píxeles</translation>
    </message>
    <message>
        <source>SVG – vector graphics</source>
        <translation>SVG – gráficos vectoriales</translation>
    </message>
    <message>
        <source>PDF – vector graphics</source>
        <translation>PDF – gráficos vectoriales</translation>
    </message>
    <message>
        <source>Paper, two columns: 170 mm</source>
        <translation>Artículo, dos columnas: 170 mm</translation>
    </message>
    <message>
        <source>Paper, one column: 85 mm</source>
        <translation>Artículo, una columna: 85 mm</translation>
    </message>
    <message>
        <source>Screen, 1600 × 1000</source>
        <translation>Pantalla, 1600 × 1000</translation>
    </message>
    <message>
        <source>Slide, 1920 × 1080</source>
        <translation>Diapositiva, 1920 × 1080</translation>
    </message>
    <message>
        <source>Paper, two columns: 170 mm, 300 dpi</source>
        <translation>Artículo, dos columnas: 170 mm, 300 ppp</translation>
    </message>
    <message>
        <source>Paper, one column: 85 mm, 300 dpi</source>
        <translation>Artículo, una columna: 85 mm, 300 ppp</translation>
    </message>
</context>
<context>
    <name>app::ScaleView</name>
    <message>
        <source>Map image</source>
        <translation>Imagen del mapa</translation>
    </message>
</context>
<context>
    <name>app::ScenarioGallery</name>
    <message>
        <source>Find a scenario</source>
        <translation>Buscar un escenario</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Escenarios</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familia</translation>
    </message>
    <message>
        <source>Show the scenarios of one family</source>
        <translation>Mostrar los escenarios de una familia</translation>
    </message>
    <message>
        <source>Difficulty</source>
        <translation>Dificultad</translation>
    </message>
    <message>
        <source>Show the scenarios of one difficulty</source>
        <translation>Mostrar los escenarios de una dificultad</translation>
    </message>
    <message>
        <source>No scenario matches the search and the filters.</source>
        <translation>Ningún escenario coincide con la búsqueda y los filtros.</translation>
    </message>
    <message>
        <source>Show all scenarios</source>
        <translation>Mostrar todos los escenarios</translation>
    </message>
    <message>
        <source>Clear the search and the filters</source>
        <translation>Borrar la búsqueda y los filtros</translation>
    </message>
    <message>
        <source>All families</source>
        <translation>Todas las familias</translation>
    </message>
    <message>
        <source>Any difficulty</source>
        <translation>Cualquier dificultad</translation>
    </message>
</context>
<context>
    <name>app::SearchPage</name>
    <message>
        <source>Failures</source>
        <translation>Fallos</translation>
    </message>
    <message>
        <source>No run failed.</source>
        <translation>No falló ninguna ejecución.</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivo de élites</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Found in</source>
        <translation>Encontrado en</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Final</translation>
    </message>
    <message>
        <source>End [s]</source>
        <translation>Fin [s]</translation>
    </message>
    <message>
        <source>Remaining changes</source>
        <translation>Cambios restantes</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetido</translation>
    </message>
    <message>
        <source>Double-click a failure to play it</source>
        <translation>Doble clic en un fallo para reproducirlo</translation>
    </message>
    <message>
        <source>One failure of each kind, with the fewest people and changes that still fail in the same way. Double-click or Enter plays it; its scenario is in the folder failures.</source>
        <translation>Un fallo de cada tipo, con el mínimo de personas y cambios que aún falla del mismo modo. Doble clic o Intro lo reproducen; su escenario está en la carpeta failures.</translation>
    </message>
    <message>
        <source>Worst run</source>
        <translation>Peor ejecución</translation>
    </message>
    <message>
        <source>The run with the worst value of the metric. Double-click or Enter plays it.</source>
        <translation>La ejecución con el peor valor de la métrica. Doble clic o Intro la reproducen.</translation>
    </message>
    <message>
        <source>Worst run: %1 = %2</source>
        <translation>Peor ejecución: %1 = %2</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>The scenario has the same end and metrics, bit for bit</source>
        <translation>El escenario tiene el mismo final y las mismas métricas, bit a bit</translation>
    </message>
    <message>
        <source>The scenario does not reproduce the run</source>
        <translation>El escenario no repite la ejecución</translation>
    </message>
    <message>
        <source>The limit of runs was reached before the scenario was minimal</source>
        <translation>Se alcanzó el límite de ejecuciones antes de que el escenario fuera mínimo</translation>
    </message>
    <message>
        <source>The archive is empty: no run was simulated.</source>
        <translation>El archivo de élites está vacío: no se simuló ninguna ejecución.</translation>
    </message>
    <message>
        <source>The best run in each cell. To the right: %1, upwards: %2; titles are the lower ends of the cells. Darker cells have a better run for the search; a dot marks a failure, and a double-click plays the failure of its kind.</source>
        <translation>La mejor ejecución de cada celda. Hacia la derecha: %1, hacia arriba: %2; los títulos son los extremos inferiores de las celdas. Las celdas más oscuras tienen una ejecución mejor para la búsqueda; un punto marca un fallo, y un doble clic reproduce el fallo de su tipo.</translation>
    </message>
    <message>
        <source>%1, seed %2: %3</source>
        <translation>%1, semilla %2: %3</translation>
    </message>
</context>
<context>
    <name>app::SensitivityPage</name>
    <message>
        <source>μ*–σ plot</source>
        <translation>Plano de μ* y σ</translation>
    </message>
    <message>
        <source>Importance</source>
        <translation>Importancia</translation>
    </message>
    <message>
        <source>No metric varies in this study.</source>
        <translation>En este estudio no varía ninguna métrica.</translation>
    </message>
    <message>
        <source>Uncertain results</source>
        <translation>Resultados inciertos</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrica</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Caso</translation>
    </message>
    <message>
        <source>Scenario and listed values</source>
        <translation>Escenario y valores de listas</translation>
    </message>
    <message>
        <source>μ*: mean size of the change of the metric if the value goes from one end of its range to the other. σ: standard deviation of these changes; on the dashed lines it is 0.1, 0.5 and 1 times μ*. Lines on the bars: bootstrap confidence intervals (%1).</source>
        <translation>μ*: tamaño medio del cambio de la métrica si el valor va de un extremo a otro de su intervalo. σ: desviación típica de estos cambios; en las líneas discontinuas es 0.1, 0.5 y 1 veces μ*. Líneas sobre las barras: intervalos de confianza bootstrap (%1).</translation>
    </message>
    <message>
        <source>Total: share of the variance of the metric that is due to the value and its interactions; first order (dark): due to the value alone. Lines on the bars: bootstrap confidence intervals (%1).</source>
        <translation>Total: parte de la varianza de la métrica que se debe al valor y a sus interacciones; primer orden (oscuro): debida solo al valor. Líneas sobre las barras: intervalos de confianza bootstrap (%1).</translation>
    </message>
    <message>
        <source>Metrics that do not vary: %1</source>
        <translation>Métricas que no varían: %1</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>μ*</source>
        <translation>μ*</translation>
    </message>
    <message>
        <source>μ</source>
        <translation>μ</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>First order</source>
        <translation>Primer orden</translation>
    </message>
    <message>
        <source>Share of the bootstrap resamples in which the value is before the next one</source>
        <translation>Parte de los remuestreos bootstrap en que el valor va antes que el siguiente</translation>
    </message>
    <message>
        <source>does not vary</source>
        <translation>no varía</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>%1: μ* %2, σ %3</source>
        <translation>%1: μ* %2, σ %3</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>All results are certain: points and seeds suffice.</source>
        <translation>Todos los resultados son seguros: bastan los puntos y las semillas.</translation>
    </message>
    <message>
        <source>More points or seeds make these results certain.</source>
        <translation>Con más puntos o semillas, estos resultados serían seguros.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
</context>
<context>
    <name>app::ShortcutsPage</name>
    <message>
        <source>Find a command or a key</source>
        <translation>Buscar una orden o una tecla</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>New keys</source>
        <translation>Teclas nuevas</translation>
    </message>
    <message>
        <source>New keys
Press the keys for the selected command</source>
        <translation>Teclas nuevas
Pulse las teclas para la orden seleccionada</translation>
    </message>
    <message>
        <source>Press keys</source>
        <translation>Pulse las teclas</translation>
    </message>
    <message>
        <source>Give these keys to the selected command</source>
        <translation>Dar estas teclas a la orden seleccionada</translation>
    </message>
    <message>
        <source>Remove the keys of the selected command</source>
        <translation>Quitar las teclas de la orden seleccionada</translation>
    </message>
    <message>
        <source>Restore the default keys of the selected command</source>
        <translation>Restaurar las teclas predeterminadas de la orden seleccionada</translation>
    </message>
    <message>
        <source>Restore the default keys of all commands</source>
        <translation>Restaurar las teclas predeterminadas de todas las órdenes</translation>
    </message>
    <message>
        <source>Select a command to change its keys</source>
        <translation>Seleccione una orden para cambiar sus teclas</translation>
    </message>
    <message>
        <source>Keys for &quot;%1&quot;</source>
        <translation>Teclas de «%1»</translation>
    </message>
    <message>
        <source>This key belongs to the active tool and cannot be changed.</source>
        <translation>Esta tecla pertenece a la herramienta activa y no se puede cambiar.</translation>
    </message>
    <message>
        <source>%1 is used by &quot;%2&quot; (%3). Assigning removes it there.</source>
        <translation>«%2» (%3) usa %1. Al asignarla se quita de ahí.</translation>
    </message>
    <message>
        <source>&amp;Assign</source>
        <translation>&amp;Asignar</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Quitar</translation>
    </message>
    <message>
        <source>&amp;Default</source>
        <translation>&amp;Predeterminada</translation>
    </message>
    <message>
        <source>Restore a&amp;ll defaults</source>
        <translation>Restaurar &amp;todas</translation>
    </message>
</context>
<context>
    <name>app::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>Página de inicio</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Place people and a robot on a map, then press Space to simulate them.</source>
        <translation>Coloque personas y un robot en un mapa y pulse Espacio para simularlos.</translation>
    </message>
    <message>
        <source>Drop a scenario or a map anywhere on this window to open it.</source>
        <translation>Suelte un escenario o un mapa en cualquier lugar de esta ventana para abrirlo.</translation>
    </message>
    <message>
        <source>New from a map</source>
        <translation>Nuevo a partir de un mapa</translation>
    </message>
    <message>
        <source>Nav2 map or floor plan image</source>
        <translation>Mapa de Nav2 o imagen de un plano</translation>
    </message>
    <message>
        <source>New empty room</source>
        <translation>Nueva sala vacía</translation>
    </message>
    <message>
        <source>Four walls, or an open plane</source>
        <translation>Cuatro paredes, o un plano abierto</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Scenario or map</source>
        <translation>Escenario o mapa</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Visita guiada</translation>
    </message>
    <message>
        <source>Your first run in two minutes</source>
        <translation>Su primera ejecución en dos minutos</translation>
    </message>
    <message>
        <source>Watch a recording…</source>
        <translation>Ver una grabación…</translation>
    </message>
    <message>
        <source>Output folder of a run</source>
        <translation>Carpeta de salida de una ejecución</translation>
    </message>
    <message>
        <source>Import trajectories…</source>
        <translation>Importar trayectorias…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>No recent files. Open a scenario on the right, or take the guided tour.</source>
        <translation>No hay archivos recientes. Abra un escenario de la derecha o haga la visita guiada.</translation>
    </message>
    <message>
        <source>CSV, JuPedSim, TrajNet++ and others</source>
        <translation>CSV, JuPedSim, TrajNet++ y otros</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2 after its start</source>
        <translation>%1, %2 después de su inicio</translation>
    </message>
    <message>
        <source>The robot has arrived, %1 · </source>
        <translation>El robot ha llegado, %1 · </translation>
    </message>
    <message>
        <source>Time limit reached, %1 · </source>
        <translation>Límite de tiempo alcanzado, %1 · </translation>
    </message>
    <message>
        <source>The robot collided, %1 · </source>
        <translation>El robot colisionó, %1 · </translation>
    </message>
    <message>
        <source>Navigation failed%1, %2 · </source>
        <translation>La navegación falló%1, %2 · </translation>
    </message>
    <message>
        <source>Navigation succeeded, but not at the goal, %1 · </source>
        <translation>La navegación terminó, pero no en el objetivo, %1 · </translation>
    </message>
    <message>
        <source>The robot is stuck, %1 · </source>
        <translation>El robot está atascado, %1 · </translation>
    </message>
    <message>
        <source>Playing back</source>
        <translation>Reproduciendo</translation>
    </message>
    <message>
        <source>Space pauses · End shows the last step</source>
        <translation>Espacio pausa · Fin muestra el último paso</translation>
    </message>
    <message>
        <source>Playback paused</source>
        <translation>Reproducción en pausa</translation>
    </message>
    <message>
        <source>Space plays from here · Ctrl+R returns to editing</source>
        <translation>Espacio reproduce desde aquí · Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source>Space resumes · End returns to the newest step</source>
        <translation>Espacio continúa · Fin vuelve al paso más reciente</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Ejecución grabada</translation>
    </message>
    <message>
        <source>Space plays and pauses · . and , step · Ctrl+R closes it</source>
        <translation>Espacio reproduce y pausa · . y , avanzan un paso · Ctrl+R la cierra</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En ejecución</translation>
    </message>
    <message>
        <source>Space pauses · Click a person for details</source>
        <translation>Espacio pausa · Clic en una persona para ver detalles</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminada</translation>
    </message>
    <message>
        <source>Space replays · Ctrl+R returns to editing</source>
        <translation>Espacio vuelve a reproducir · Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source>Stopped at %1 · </source>
        <translation>Detenido en %1 · </translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Space resumes · . steps · Ctrl+R returns to editing</source>
        <translation>Espacio continúa · . avanza un paso · Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>Editing</source>
        <translation>Edición</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Click a scenario to open it · Space runs it</source>
        <translation>Haga clic en un escenario para abrirlo · Espacio lo ejecuta</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>fuera</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>pared</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>%1 px/m</source>
        <translation>%1 px/m</translation>
    </message>
    <message>
        <source>Seed %1</source>
        <translation>Semilla %1</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × tiempo real</translation>
    </message>
    <message>
        <source>%1, %2 m · %3</source>
        <translation>%1, %2 m · %3</translation>
    </message>
    <message>
        <source>F8 returns to the map</source>
        <translation>F8 vuelve al mapa</translation>
    </message>
    <message>
        <source>Goal not reached</source>
        <translation>Objetivo no alcanzado</translation>
    </message>
    <message>
        <source>Goal reached</source>
        <translation>Objetivo alcanzado</translation>
    </message>
</context>
<context>
    <name>app::StudyForm</name>
    <message>
        <source>Other parameters, one per line</source>
        <translation>Otros parámetros, uno por línea</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Semillas</translation>
    </message>
    <message>
        <source>Number or list of seeds: 30 or [3, 7, 11]</source>
        <translation>Número o lista de semillas: 30 o [3, 7, 11]</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>from scenario</source>
        <translation>del escenario</translation>
    </message>
    <message>
        <source>Maximum duration of each run [s]; empty: as in the scenario</source>
        <translation>Duración máxima de cada ejecución [s]; vacío: la del escenario</translation>
    </message>
    <message>
        <source>metrics only</source>
        <translation>solo métricas</translation>
    </message>
    <message>
        <source>runs with an error</source>
        <translation>ejecuciones con error</translation>
    </message>
    <message>
        <source>failures only</source>
        <translation>solo fallos</translation>
    </message>
    <message>
        <source>all runs</source>
        <translation>todas las ejecuciones</translation>
    </message>
    <message>
        <source>Keep recordings</source>
        <translation>Conservar grabaciones</translation>
    </message>
    <message>
        <source>Runs whose files are kept in the results folder. Failures are runs with an error and runs whose robot did not succeed.</source>
        <translation>Ejecuciones cuyos archivos se conservan en la carpeta de resultados. Los fallos son ejecuciones con error y aquellas cuyo robot no tuvo éxito.</translation>
    </message>
    <message>
        <source>Other parameters</source>
        <translation>Otros parámetros</translation>
    </message>
    <message>
        <source>A list tests each value. {normal: [mean, deviation, minimum, maximum]}, {uniform: [from, to]} and {choice: […]} are sampled for each seed, equally for all planners.</source>
        <translation>Una lista prueba cada valor. {normal: [media, desviación, mínimo, máximo]}, {uniform: [desde, hasta]} y {choice: […]} se muestrean para cada semilla, igual para todos los planificadores.</translation>
    </message>
    <message>
        <source>Scenarios</source>
        <translation>Escenarios</translation>
    </message>
    <message>
        <source>Add current</source>
        <translation>Añadir actual</translation>
    </message>
    <message>
        <source>Add the open scenario</source>
        <translation>Añadir el escenario abierto</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>Add scenario files</source>
        <translation>Añadir archivos de escenario</translation>
    </message>
    <message>
        <source>Press Delete to remove the selection</source>
        <translation>Pulse Supr para quitar la selección</translation>
    </message>
    <message>
        <source>Save the scenario first</source>
        <translation>Guarde antes el escenario</translation>
    </message>
    <message>
        <source>Planners to compare</source>
        <translation>Planificadores que comparar</translation>
    </message>
    <message>
        <source>Planners</source>
        <translation>Planificadores</translation>
    </message>
    <message>
        <source>Add scenarios</source>
        <translation>Añadir escenarios</translation>
    </message>
    <message>
        <source>Scenarios (*.yaml *.yml)</source>
        <translation>Escenarios (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>No scenarios: add or drop files here</source>
        <translation>No hay escenarios: añada o suelte archivos aquí</translation>
    </message>
    <message>
        <source>Save the open scenario first, or add files</source>
        <translation>Guarde primero el escenario abierto, o añada archivos</translation>
    </message>
</context>
<context>
    <name>app::StudyPanel</name>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Save the experiment as a file; its results are stored beside it</source>
        <translation>Guardar el experimento como archivo; sus resultados se guardan junto a él</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Write a page with tables, confidence intervals, tests and figures</source>
        <translation>Escribir una página con tablas, intervalos de confianza, pruebas y figuras</translation>
    </message>
    <message>
        <source>New study</source>
        <translation>Nuevo estudio</translation>
    </message>
    <message>
        <source>Save the study</source>
        <translation>Guardar el estudio</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Abrir un estudio</translation>
    </message>
    <message>
        <source>Experiments (*.yaml *.yml)</source>
        <translation>Experimentos (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>%1 of %2 finished</source>
        <translation>%1 de %2 terminadas</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>no se puede escribir %1: %2</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Informe</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Delete the results in the folder</source>
        <translation>Borrar los resultados de la carpeta</translation>
    </message>
    <message>
        <source>Its runs start external programs: allow them above the map</source>
        <translation>Sus ejecuciones inician programas externos: permítalos encima del mapa</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Iniciando…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 de %2 ejecuciones</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>, faltan %1</translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation>, %1 fallidas</translation>
    </message>
    <message>
        <source>: stopped, finished runs are kept</source>
        <translation>: detenido, se conservan las ejecuciones terminadas</translation>
    </message>
    <message>
        <source>Run %1 was not recorded, and its experiment can no longer be read</source>
        <translation>La ejecución %1 no se grabó, y su experimento ya no se puede leer</translation>
    </message>
    <message>
        <source>Replaying run %1…</source>
        <translation>Repitiendo la ejecución %1…</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>Escribiendo el informe…</translation>
    </message>
    <message>
        <source>All seeds have the same people: to vary them, set &quot;Variation between seeds&quot; in the properties of the scenario</source>
        <translation>Todas las semillas tienen las mismas personas: para variarlas, ajuste «Variación entre semillas» en las propiedades del escenario</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>Begin a new study of the open scenario</source>
        <translation>Empezar un estudio nuevo del escenario abierto</translation>
    </message>
    <message>
        <source>Save and start</source>
        <translation>Guardar e iniciar</translation>
    </message>
    <message>
        <source>Save the open scenario, then start</source>
        <translation>Guardar el escenario abierto y después iniciar</translation>
    </message>
    <message>
        <source>Start without them</source>
        <translation>Iniciar sin ellos</translation>
    </message>
    <message>
        <source>Run the file as it was last saved</source>
        <translation>Usar el archivo tal como se guardó por última vez</translation>
    </message>
    <message>
        <source>Save %1 before the start: it has unsaved changes</source>
        <translation>Guarde %1 antes de iniciar: tiene cambios sin guardar</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Open an experiment, or the results of tune, gate, sensitivity or search</source>
        <translation>Abrir un experimento o los resultados de tune, gate, sensitivity o search</translation>
    </message>
    <message>
        <source>Results are shown: New begins a study</source>
        <translation>Se muestran resultados: Nuevo empieza un estudio</translation>
    </message>
    <message>
        <source>Studies (*.yaml *.yml tune.json gate.json sensitivity.json archive.json)</source>
        <translation>Estudios (*.yaml *.yml tune.json gate.json sensitivity.json archive.json)</translation>
    </message>
    <message>
        <source>Replaying %1…</source>
        <translation>Repitiendo %1…</translation>
    </message>
    <message>
        <source>%1 has changed since the study ran</source>
        <translation>%1 ha cambiado desde que se ejecutó el estudio</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Informe escrito en %1</translation>
    </message>
</context>
<context>
    <name>app::StudyProcess</name>
    <message>
        <source>The batch process crashed.</source>
        <translation>El proceso de las ejecuciones falló.</translation>
    </message>
</context>
<context>
    <name>app::StudyResults</name>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Choose scenarios and planners on the left, then press Start.
For each seed, all planners run with the same people.</source>
        <translation>Elija escenarios y planificadores a la izquierda y pulse Iniciar.
Para cada semilla, todos los planificadores se ejecutan con las mismas personas.</translation>
    </message>
    <message>
        <source>Runs of the study</source>
        <translation>Ejecuciones del estudio</translation>
    </message>
    <message>
        <source>Double-click a run to play it</source>
        <translation>Doble clic en una ejecución para reproducirla</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Mean of the finished runs [95 % confidence interval]. Bars: the same intervals, on one scale per column. Rates: Wilson; other metrics: bootstrap (BCa). n: runs that have a value, if not all have one. Success: the robot reached its goal in time, without contact with people or obstacles.</source>
        <translation>Media de las ejecuciones terminadas [intervalo de confianza del 95 %]. Barras: los mismos intervalos, con una escala por columna. Tasas: Wilson; otras métricas: bootstrap (BCa). n: ejecuciones que tienen un valor, si no lo tienen todas. Éxito: el robot alcanzó su objetivo a tiempo, sin contacto con personas ni obstáculos.</translation>
    </message>
    <message>
        <source> (n = %1)</source>
        <translation> (n = %1)</translation>
    </message>
</context>
<context>
    <name>app::StudyRunsModel</name>
    <message>
        <source>failed: %1</source>
        <translation>falló: %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Final</translation>
    </message>
</context>
<context>
    <name>app::TreeChoiceDialog</name>
    <message>
        <source>Apply to all %1</source>
        <translation>Aplicar a los %1</translation>
    </message>
    <message>
        <source>Custom trees</source>
        <translation>Árboles propios</translation>
    </message>
    <message>
        <source>Saving would overwrite custom trees</source>
        <translation>Al guardar se sobrescribirían árboles propios</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: the file %2 was changed by another program.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: otro programa modificó el archivo %2.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt;: behaviour or goals changed after this custom tree was written.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt;: el comportamiento o los objetivos cambiaron después de escribir este árbol propio.</translation>
    </message>
    <message>
        <source>Keep the tree in the file</source>
        <translation>Conservar el árbol del archivo</translation>
    </message>
    <message>
        <source>Keep the custom tree</source>
        <translation>Conservar el árbol propio</translation>
    </message>
    <message>
        <source>Replace it with the tree in this window</source>
        <translation>Reemplazarlo por el árbol de esta ventana</translation>
    </message>
    <message>
        <source>Use the generated tree</source>
        <translation>Usar el árbol generado</translation>
    </message>
    <message>
        <source>− in the file   + in this window</source>
        <translation>− en el archivo   + en esta ventana</translation>
    </message>
    <message>
        <source>− custom   + generated</source>
        <translation>− propio   + generado</translation>
    </message>
    <message>
        <source>Hide differences</source>
        <translation>Ocultar diferencias</translation>
    </message>
    <message>
        <source>Show differences (−%1 +%2 lines)</source>
        <translation>Mostrar diferencias (−%1 +%2 líneas)</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>se conserva</translation>
    </message>
    <message>
        <source>replaced</source>
        <translation>reemplazado</translation>
    </message>
</context>
<context>
    <name>app::TreeCommands</name>
    <message>
        <source>Saved %1</source>
        <translation>Guardado %1</translation>
    </message>
</context>
<context>
    <name>app::TunePage</name>
    <message>
        <source>Evaluation</source>
        <translation>Evaluación</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>No candidate was better in the search, so none was evaluated on new runs.</source>
        <translation>Ningún candidato fue mejor en la búsqueda, por lo que no se evaluó ninguno en ejecuciones nuevas.</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrica</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativa</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pares</translation>
    </message>
    <message>
        <source>After − before with 95 % intervals, on runs that the search has not seen, paired by scenario and seed. Pairs in which a run failed are excluded from the objectives.</source>
        <translation>Después − antes con intervalos del 95 %, en ejecuciones que la búsqueda no ha visto, emparejadas por escenario y semilla. Los pares con una ejecución fallida se excluyen de los objetivos.</translation>
    </message>
    <message>
        <source>%1: all seeds have the same results, so its runs are not independent.</source>
        <translation>%1: todas las semillas dan los mismos resultados, por lo que sus ejecuciones no son independientes.</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todos</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>En el archivo</translation>
    </message>
    <message>
        <source>Effect on the score</source>
        <translation>Efecto en la puntuación</translation>
    </message>
    <message>
        <source>Effect on %1</source>
        <translation>Efecto en %1</translation>
    </message>
    <message>
        <source>Effect on the score: what is lost without the change. Effects on metrics: with the change − without it, with 95 % intervals, on runs of the search. Changes that lose nothing when they are reverted together are not in the tuned file.</source>
        <translation>Efecto en la puntuación: lo que se pierde sin el cambio. Efectos en las métricas: con el cambio − sin él, con intervalos del 95 %, en ejecuciones de la búsqueda. Los cambios que no pierden nada al deshacerlos juntos no están en el archivo ajustado.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>de %1 a %2</translation>
    </message>
    <message>
        <source>%1, logarithmic</source>
        <translation>%1, logarítmico</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>sin cambios</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>Candidates on the front</source>
        <translation>Candidatos en el frente</translation>
    </message>
    <message>
        <source>%1 [%]</source>
        <translation>%1 [%]</translation>
    </message>
    <message>
        <source>Changed values</source>
        <translation>Valores cambiados</translation>
    </message>
    <message>
        <source>Pareto-optimal candidates in the runs of the search, relative to the current values. The best of many candidates is selected, so these values are optimistic on average.</source>
        <translation>Candidatos óptimos de Pareto en las ejecuciones de la búsqueda, en relación con los valores actuales. Se elige el mejor de muchos candidatos, por lo que estos valores son optimistas en promedio.</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>elegido</translation>
    </message>
    <message>
        <source>Pareto front</source>
        <translation>Frente de Pareto</translation>
    </message>
    <message>
        <source>The file is unchanged.</source>
        <translation>El archivo no ha cambiado.</translation>
    </message>
    <message>
        <source>From the current file to the tuned one.</source>
        <translation>Del archivo actual al ajustado.</translation>
    </message>
    <message>
        <source>From the current file to the best candidate, which is not used: the tuned file is unchanged.</source>
        <translation>Del archivo actual al mejor candidato, que no se usa: el archivo ajustado no ha cambiado.</translation>
    </message>
</context>
<context>
    <name>app::WindowActions</name>
    <message>
        <source>Show or hide on the map</source>
        <translation>Mostrar u ocultar en el mapa</translation>
    </message>
    <message>
        <source>&amp;Names</source>
        <translation>&amp;Nombres</translation>
    </message>
    <message>
        <source>Rou&amp;tes</source>
        <translation>Ru&amp;tas</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>C&amp;uadrícula</translation>
    </message>
    <message>
        <source>R&amp;ulers</source>
        <translation>Regl&amp;as</translation>
    </message>
    <message>
        <source>Tr&amp;ails</source>
        <translation>&amp;Estelas</translation>
    </message>
    <message>
        <source>Past paths of people in a run</source>
        <translation>Caminos recorridos por las personas en una ejecución</translation>
    </message>
    <message>
        <source>&amp;Personal spaces</source>
        <translation>Espacios &amp;personales</translation>
    </message>
    <message>
        <source>Hall&apos;s zones around selected people; in a run around all if none is selected</source>
        <translation>Zonas de Hall alrededor de las personas seleccionadas; en una ejecución, de todas si no hay selección</translation>
    </message>
    <message>
        <source>For&amp;ces</source>
        <translation>&amp;Fuerzas</translation>
    </message>
    <message>
        <source>Forces on selected people in a run; on all if none is selected</source>
        <translation>Fuerzas sobre las personas seleccionadas en una ejecución; sobre todas si no hay selección</translation>
    </message>
    <message>
        <source>Robot pat&amp;hs</source>
        <translation>Cam&amp;inos de los robots</translation>
    </message>
    <message>
        <source>Paths that robot planners follow in a run</source>
        <translation>Caminos que siguen los planificadores de los robots en una ejecución</translation>
    </message>
    <message>
        <source>Lid&amp;ar scans</source>
        <translation>Barridos &amp;lidar</translation>
    </message>
    <message>
        <source>Lidar scans of robots in a run</source>
        <translation>Barridos lidar de los robots en una ejecución</translation>
    </message>
    <message>
        <source>&amp;Detections</source>
        <translation>&amp;Detecciones</translation>
    </message>
    <message>
        <source>Positions of people and of the robots, as estimated by the robots in a run</source>
        <translation>Posiciones de las personas y de los robots, estimadas por los robots en una ejecución</translation>
    </message>
    <message>
        <source>Candidate tra&amp;jectories</source>
        <translation>&amp;Trayectorias candidatas</translation>
    </message>
    <message>
        <source>Trajectories that robot planners evaluated in a run</source>
        <translation>Trayectorias que evaluaron los planificadores de los robots en una ejecución</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Mapa</translation>
    </message>
    <message>
        <source>&amp;People</source>
        <translation>&amp;Personas</translation>
    </message>
    <message>
        <source>&amp;Robots</source>
        <translation>&amp;Robots</translation>
    </message>
    <message>
        <source>&amp;Goals</source>
        <translation>&amp;Objetivos</translation>
    </message>
    <message>
        <source>&amp;Obstacles and doors</source>
        <translation>O&amp;bstáculos y puertas</translation>
    </message>
    <message>
        <source>&amp;Areas and docks</source>
        <translation>&amp;Áreas y bases de carga</translation>
    </message>
    <message>
        <source>Gro&amp;ups</source>
        <translation>&amp;Grupos</translation>
    </message>
    <message>
        <source>Snap to p&amp;oints</source>
        <translation>Ajustar a p&amp;untos</translation>
    </message>
    <message>
        <source>Snap drawn items to corners, ends and centres of other items</source>
        <translation>Ajustar lo dibujado a vértices, extremos y centros de otros elementos</translation>
    </message>
    <message>
        <source>Snap to &amp;walls</source>
        <translation>Ajustar a par&amp;edes</translation>
    </message>
    <message>
        <source>Snap drawn items to corners and edges of map walls</source>
        <translation>Ajustar lo dibujado a vértices y bordes de las paredes del mapa</translation>
    </message>
    <message>
        <source>Snap to the gr&amp;id</source>
        <translation>A&amp;justar a la cuadrícula</translation>
    </message>
    <message>
        <source>Snap drawn items to a grid of 0.5 m</source>
        <translation>Ajustar lo dibujado a una cuadrícula de 0.5 m</translation>
    </message>
    <message>
        <source>Alignment guides</source>
        <translation>Guías de alineación</translation>
    </message>
    <message>
        <source>Align dragged items with edges, centres and distances of others; Alt suspends this</source>
        <translation>Alinear lo arrastrado con bordes, centros y distancias de otros; Alt lo suspende</translation>
    </message>
    <message>
        <source>&amp;Density of people</source>
        <translation>&amp;Densidad de personas</translation>
    </message>
    <message>
        <source>People per m² as a colour map</source>
        <translation>Personas por m² como mapa de colores</translation>
    </message>
    <message>
        <source>&amp;Field of view</source>
        <translation>Ca&amp;mpo de visión</translation>
    </message>
    <message>
        <source>Area that the selected people see; walls block the view</source>
        <translation>Área que ven las personas seleccionadas; las paredes tapan la vista</translation>
    </message>
    <message>
        <source>&amp;Gaussian spaces</source>
        <translation>Espacios &amp;gaussianos</translation>
    </message>
    <message>
        <source>Gaussian personal space, longer in the walking direction</source>
        <translation>Espacio personal gaussiano, más largo en la dirección de marcha</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Velocidades</translation>
    </message>
    <message>
        <source>Velocity vector of each body</source>
        <translation>Vector de velocidad de cada cuerpo</translation>
    </message>
    <message>
        <source>Peopl&amp;e&apos;s paths</source>
        <translation>Caminos de las per&amp;sonas</translation>
    </message>
    <message>
        <source>Remaining path of each person; newest step only</source>
        <translation>Camino restante de cada persona; solo el paso más reciente</translation>
    </message>
    <message>
        <source>C&amp;ontacts</source>
        <translation>C&amp;ontactos</translation>
    </message>
    <message>
        <source>Where bodies touched, and which body ran into the other</source>
        <translation>Dónde se tocaron los cuerpos, y cuál chocó con el otro</translation>
    </message>
    <message>
        <source>T&amp;houghts</source>
        <translation>Pe&amp;nsamientos</translation>
    </message>
    <message>
        <source>Current action of each person and its reason, below the name</source>
        <translation>Acción actual de cada persona y su motivo, bajo el nombre</translation>
    </message>
    <message>
        <source>&amp;Speech</source>
        <translation>&amp;Habla</translation>
    </message>
    <message>
        <source>What people say, and which people hear it</source>
        <translation>Lo que dicen las personas, y quién lo oye</translation>
    </message>
    <message>
        <source>&amp;Local costmap</source>
        <translation>Mapa de costes lo&amp;cal</translation>
    </message>
    <message>
        <source>Local costmap that the controller of a robot with Nav2 uses</source>
        <translation>Mapa de costes local que usa el controlador de un robot con Nav2</translation>
    </message>
    <message>
        <source>Gl&amp;obal costmap</source>
        <translation>M&amp;apa de costes global</translation>
    </message>
    <message>
        <source>Global costmap that the planner of a robot with Nav2 uses</source>
        <translation>Mapa de costes global que usa el planificador de un robot con Nav2</translation>
    </message>
    <message>
        <source>F&amp;ilter masks</source>
        <translation>Máscaras de &amp;filtro</translation>
    </message>
    <message>
        <source>Keepout zones and speed limits of the costmap filters of a robot with Nav2</source>
        <translation>Zonas prohibidas y límites de velocidad de los filtros de costes de un robot con Nav2</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Escenario</translation>
    </message>
    <message>
        <source>People in a run</source>
        <translation>Personas en una ejecución</translation>
    </message>
    <message>
        <source>Robots in a run</source>
        <translation>Robots en una ejecución</translation>
    </message>
    <message>
        <source>&amp;New open plane</source>
        <translation>&amp;Nuevo plano abierto</translation>
    </message>
    <message>
        <source>Create a scenario without a map</source>
        <translation>Crear un escenario sin mapa</translation>
    </message>
    <message>
        <source>New empty &amp;room…</source>
        <translation>Nueva &amp;sala vacía…</translation>
    </message>
    <message>
        <source>Create a scenario in a room of a given size</source>
        <translation>Crear un escenario en una sala de un tamaño dado</translation>
    </message>
    <message>
        <source>New from a &amp;map…</source>
        <translation>Nuevo a partir de un &amp;mapa…</translation>
    </message>
    <message>
        <source>Create a scenario on a Nav2 map or a map image</source>
        <translation>Crear un escenario sobre un mapa de Nav2 o una imagen de mapa</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a scenario or a map</source>
        <translation>Abrir un escenario o un mapa</translation>
    </message>
    <message>
        <source>Open r&amp;un…</source>
        <translation>Abrir &amp;ejecución…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save the scenario and its behaviour trees</source>
        <translation>Guardar el escenario y sus árboles de comportamiento</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>G&amp;uardar como…</translation>
    </message>
    <message>
        <source>Save the scenario under another name</source>
        <translation>Guardar el escenario con otro nombre</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>E&amp;xportar…</translation>
    </message>
    <message>
        <source>Export scenario, trees and map for another simulator</source>
        <translation>Exportar escenario, árboles y mapa para otro simulador</translation>
    </message>
    <message>
        <source>Save p&amp;icture…</source>
        <translation>Guar&amp;dar imagen…</translation>
    </message>
    <message>
        <source>Save the displayed step of the run, or the start of the scenario, as PNG, SVG or PDF</source>
        <translation>Guardar el paso mostrado de la ejecución, o el inicio del escenario, como PNG, SVG o PDF</translation>
    </message>
    <message>
        <source>Save fi&amp;lm…</source>
        <translation>Guardar pe&amp;lícula…</translation>
    </message>
    <message>
        <source>Save the run as a GIF, MP4 or WebP film</source>
        <translation>Guardar la ejecución como película GIF, MP4 o WebP</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Return to the start page</source>
        <translation>Volver a la página de inicio</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Sali&amp;r</translation>
    </message>
    <message>
        <source>Quit the program</source>
        <translation>Salir del programa</translation>
    </message>
    <message>
        <source>Change &amp;map…</source>
        <translation>Cambiar el &amp;mapa…</translation>
    </message>
    <message>
        <source>Choose another map for the scenario</source>
        <translation>Elegir otro mapa para el escenario</translation>
    </message>
    <message>
        <source>Assign &amp;goals…</source>
        <translation>Asignar ob&amp;jetivos…</translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation>Elegir los objetivos que visitan las personas, y su orden</translation>
    </message>
    <message>
        <source>Scenario &amp;settings</source>
        <translation>Aj&amp;ustes del escenario</translation>
    </message>
    <message>
        <source>Edit seed, duration and other settings of the scenario</source>
        <translation>Editar semilla, duración y otros ajustes del escenario</translation>
    </message>
    <message>
        <source>Watch in &amp;Foxglove</source>
        <translation>Ver en &amp;Foxglove</translation>
    </message>
    <message>
        <source>Publish new runs live at ws://localhost:8765</source>
        <translation>Publicar en vivo las ejecuciones nuevas en ws://localhost:8765</translation>
    </message>
    <message>
        <source>Publish to &amp;ROS 2</source>
        <translation>Pu&amp;blicar en ROS 2</translation>
    </message>
    <message>
        <source>Publish new runs on ROS 2 topics; /cmd_vel, /initialpose and /goal_pose control the first robot</source>
        <translation>Publicar las ejecuciones nuevas en topics de ROS 2; /cmd_vel, /initialpose y /goal_pose controlan el primer robot</translation>
    </message>
    <message>
        <source>Import tra&amp;jectories…</source>
        <translation>Importar &amp;trayectorias…</translation>
    </message>
    <message>
        <source>Show recorded trajectories of people: CSV, JuPedSim, TrajNet++, ETH/UCY and others</source>
        <translation>Mostrar trayectorias grabadas de personas: CSV, JuPedSim, TrajNet++, ETH/UCY y otros</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>Bu&amp;scar una orden…</translation>
    </message>
    <message>
        <source>Search all commands and run one</source>
        <translation>Buscar entre todas las órdenes y ejecutar una</translation>
    </message>
    <message>
        <source>Preference&amp;s…</source>
        <translation>Pre&amp;ferencias…</translation>
    </message>
    <message>
        <source>Theme, folders, copies of unsaved work and keyboard shortcuts</source>
        <translation>Tema, carpetas, copias de los cambios sin guardar y atajos de teclado</translation>
    </message>
    <message>
        <source>&amp;Guided tour</source>
        <translation>Visita &amp;guiada</translation>
    </message>
    <message>
        <source>Place a person, run the simulation and read a metric</source>
        <translation>Colocar una persona, ejecutar la simulación y leer una métrica</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manual</translation>
    </message>
    <message>
        <source>Open the manual page of what has the keyboard focus</source>
        <translation>Abrir la página del manual sobre lo que tiene el foco del teclado</translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation>¿&amp;Qué es esto?</translation>
    </message>
    <message>
        <source>Click anything in the window for an explanation</source>
        <translation>Haga clic en cualquier parte de la ventana para ver una explicación</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>A&amp;tajos de teclado…</translation>
    </message>
    <message>
        <source>Search and change all keyboard shortcuts</source>
        <translation>Buscar y cambiar todos los atajos de teclado</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;Acerca de</translation>
    </message>
    <message>
        <source>Show version information</source>
        <translation>Mostrar información de la versión</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Rehacer el último cambio deshecho</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Copy the selection and remove it</source>
        <translation>Copiar la selección y quitarla</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selection as YAML text</source>
        <translation>Copiar la selección como texto YAML</translation>
    </message>
    <message>
        <source>Copy as figure</source>
        <translation>Copiar como figura</translation>
    </message>
    <message>
        <source>Copy the displayed step of the run as a figure: PNG and SVG</source>
        <translation>Copiar el paso mostrado de la ejecución como figura: PNG y SVG</translation>
    </message>
    <message>
        <source>Copy metric as plot</source>
        <translation>Copiar métrica como gráfica</translation>
    </message>
    <message>
        <source>Copy a plot of the selected metric over time: PNG and SVG</source>
        <translation>Copiar una gráfica de la métrica seleccionada en el tiempo: PNG y SVG</translation>
    </message>
    <message>
        <source>Save metric as plot…</source>
        <translation>Guardar métrica como gráfica…</translation>
    </message>
    <message>
        <source>Save a plot of the selected metric over time: PNG, SVG or PDF</source>
        <translation>Guardar una gráfica de la métrica seleccionada en el tiempo: PNG, SVG o PDF</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Insert the copied items at the mouse pointer</source>
        <translation>Insertar los elementos copiados en el puntero del ratón</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>Dup&amp;licar</translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation>Duplicar la selección</translation>
    </message>
    <message>
        <source>Rena&amp;me</source>
        <translation>Ca&amp;mbiar nombre</translation>
    </message>
    <message>
        <source>Rename the selection; references are updated</source>
        <translation>Cambiar el nombre de la selección; las referencias se actualizan</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Borrar</translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation>Quitar la selección; las rutas se actualizan</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccion&amp;ar todo</translation>
    </message>
    <message>
        <source>Select everything on the map</source>
        <translation>Seleccionar todo lo que hay en el mapa</translation>
    </message>
    <message>
        <source>Select &amp;none</source>
        <translation>Seleccionar &amp;nada</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Borrar la selección</translation>
    </message>
    <message>
        <source>N&amp;ext</source>
        <translation>Si&amp;guiente</translation>
    </message>
    <message>
        <source>Select the next person, or the next item of the selected kind</source>
        <translation>Seleccionar la persona siguiente, o el elemento siguiente del tipo seleccionado</translation>
    </message>
    <message>
        <source>Pre&amp;vious</source>
        <translation>Anteri&amp;or</translation>
    </message>
    <message>
        <source>Select the previous person, or the previous item of the selected kind</source>
        <translation>Seleccionar la persona anterior, o el elemento anterior del tipo seleccionado</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Ampliar</translation>
    </message>
    <message>
        <source>Enlarge the map</source>
        <translation>Ampliar el mapa</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Re&amp;ducir</translation>
    </message>
    <message>
        <source>Reduce the map</source>
        <translation>Reducir el mapa</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>En&amp;cuadrar</translation>
    </message>
    <message>
        <source>Fit the whole map in the window</source>
        <translation>Encuadrar todo el mapa en la ventana</translation>
    </message>
    <message>
        <source>Full scr&amp;een</source>
        <translation>Pantalla co&amp;mpleta</translation>
    </message>
    <message>
        <source>Show only the map</source>
        <translation>Mostrar solo el mapa</translation>
    </message>
    <message>
        <source>Reset the la&amp;yout</source>
        <translation>Restablecer los pan&amp;eles</translation>
    </message>
    <message>
        <source>Restore the default panel layout</source>
        <translation>Restaurar la disposición predeterminada de los paneles</translation>
    </message>
    <message>
        <source>Light or dar&amp;k</source>
        <translation>Claro u &amp;oscuro</translation>
    </message>
    <message>
        <source>Switch between the light and the dark theme</source>
        <translation>Cambiar entre el tema claro y el oscuro</translation>
    </message>
    <message>
        <source>Follow &amp;system theme</source>
        <translation>Segu&amp;ir el tema del sistema</translation>
    </message>
    <message>
        <source>Use the light or dark theme of the desktop</source>
        <translation>Usar el tema claro u oscuro del escritorio</translation>
    </message>
    <message>
        <source>Align &amp;left</source>
        <translation>Alinear a la &amp;izquierda</translation>
    </message>
    <message>
        <source>Align &amp;centres</source>
        <translation>Alinear &amp;centros</translation>
    </message>
    <message>
        <source>Align &amp;right</source>
        <translation>Alinear a la &amp;derecha</translation>
    </message>
    <message>
        <source>Align &amp;tops</source>
        <translation>Alinear &amp;arriba</translation>
    </message>
    <message>
        <source>Align &amp;middles</source>
        <translation>Alinear &amp;medios</translation>
    </message>
    <message>
        <source>Align &amp;bottoms</source>
        <translation>Alinear a&amp;bajo</translation>
    </message>
    <message>
        <source>Align the selected items</source>
        <translation>Alinear los elementos seleccionados</translation>
    </message>
    <message>
        <source>Distribute &amp;horizontally</source>
        <translation>Distribuir en &amp;horizontal</translation>
    </message>
    <message>
        <source>Distribute &amp;vertically</source>
        <translation>Distribuir en &amp;vertical</translation>
    </message>
    <message>
        <source>Set equal gaps between the selected items</source>
        <translation>Igualar los espacios entre los elementos seleccionados</translation>
    </message>
    <message>
        <source>Rotate 15° left	[</source>
        <translation>Girar 15° a la izquierda	[</translation>
    </message>
    <message>
        <source>Rotate 15° right	]</source>
        <translation>Girar 15° a la derecha	]</translation>
    </message>
    <message>
        <source>Rotate 90° left</source>
        <translation>Girar 90° a la izquierda</translation>
    </message>
    <message>
        <source>Rotate 90° right</source>
        <translation>Girar 90° a la derecha</translation>
    </message>
    <message>
        <source>Rotate the selection about its centre</source>
        <translation>Girar la selección alrededor de su centro</translation>
    </message>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>No durante una ejecución: Ctrl+R vuelve a la edición</translation>
    </message>
    <message>
        <source>Select something first</source>
        <translation>Seleccione algo antes</translation>
    </message>
    <message>
        <source>Select exactly one item first</source>
        <translation>Seleccione antes exactamente un elemento</translation>
    </message>
    <message>
        <source>The clipboard contains no items of a scenario</source>
        <translation>El portapapeles no contiene elementos de un escenario</translation>
    </message>
    <message>
        <source>Select at least %1 first</source>
        <translation>Seleccione antes al menos %1</translation>
    </message>
    <message>
        <source>item</source>
        <translation>elemento</translation>
    </message>
    <message>
        <source>items</source>
        <translation>elementos</translation>
    </message>
    <message>
        <source>Open a recorded run or the results of a study: the output folder of a command</source>
        <translation>Abrir una ejecución grabada o los resultados de un estudio: la carpeta de salida de un comando</translation>
    </message>
    <message>
        <source>&amp;Memory for runs…</source>
        <translation>&amp;Memoria para ejecuciones…</translation>
    </message>
    <message>
        <source>Set the memory for the recorded steps of a run</source>
        <translation>Fijar la memoria para los pasos guardados de una ejecución</translation>
    </message>
</context>
<context>
    <name>editor::AreaPage</name>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation>Fuente: aparecen personas</translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation>Sumidero: las personas se van</translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation>Área de espera</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation>Velocidad: escaleras, pasillos rodantes</translation>
    </message>
    <message>
        <source>Spawned people</source>
        <translation>Personas generadas</translation>
    </message>
    <message>
        <source>name of a person</source>
        <translation>nombre de una persona</translation>
    </message>
    <message>
        <source>No person has this name</source>
        <translation>Ninguna persona tiene este nombre</translation>
    </message>
    <message>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <source>person</source>
        <translation>persona</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
</context>
<context>
    <name>editor::AreaTool</name>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Source: people appear</source>
        <translation>Fuente: aparecen personas</translation>
    </message>
    <message>
        <source>Sink: people leave</source>
        <translation>Sumidero: las personas se van</translation>
    </message>
    <message>
        <source>Waiting area</source>
        <translation>Área de espera</translation>
    </message>
    <message>
        <source>Exit</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Speed: stairs, travelators</source>
        <translation>Velocidad: escaleras, pasillos rodantes</translation>
    </message>
    <message>
        <source>Drag an area where people appear, or click its corners · 1 to 5 choose the kind</source>
        <translation>Arrastre un área donde aparecen personas, o haga clic en sus vértices · 1 a 5 eligen el tipo</translation>
    </message>
    <message>
        <source>Drag an area where people leave after their last goal, or click its corners</source>
        <translation>Arrastre un área donde las personas se van tras su último objetivo, o haga clic en sus vértices</translation>
    </message>
    <message>
        <source>Drag a waiting area, or click its corners · trees refer to it by name</source>
        <translation>Arrastre un área de espera, o haga clic en sus vértices · los árboles la citan por su nombre</translation>
    </message>
    <message>
        <source>Drag an exit that people flee to, or click its corners</source>
        <translation>Arrastre una salida hacia la que huyen las personas, o haga clic en sus vértices</translation>
    </message>
    <message>
        <source>Drag stairs, a ramp or a travelator, or click its corners · the properties set factor and carrying speed</source>
        <translation>Arrastre escaleras, una rampa o un pasillo rodante, o haga clic en sus vértices · factor y arrastre están en las propiedades</translation>
    </message>
    <message>
        <source>Add source</source>
        <translation>Añadir fuente</translation>
    </message>
</context>
<context>
    <name>editor::BehaviorMixDialog</name>
    <message>
        <source>Behaviours of %1</source>
        <translation>Comportamientos de %1</translation>
    </message>
</context>
<context>
    <name>editor::BehaviorPanel</name>
    <message>
        <source>Blackboard</source>
        <translation>Pizarra</translation>
    </message>
    <message>
        <source>+ Block…</source>
        <translation>+ Bloque…</translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation>Añadir un bloque de comportamiento</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Load a tree from a file</source>
        <translation>Cargar un árbol de un archivo</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Save the tree to a file</source>
        <translation>Guardar el árbol en un archivo</translation>
    </message>
    <message>
        <source>Template…</source>
        <translation>Plantilla…</translation>
    </message>
    <message>
        <source>Start from the tree of a behaviour</source>
        <translation>Partir del árbol de un comportamiento</translation>
    </message>
    <message>
        <source>Regenerate</source>
        <translation>Regenerar</translation>
    </message>
    <message>
        <source>Generate the tree from behaviour and goals</source>
        <translation>Generar el árbol a partir del comportamiento y los objetivos</translation>
    </message>
    <message>
        <source>Copy route to tree</source>
        <translation>Copiar la ruta al árbol</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Move before the block above</source>
        <translation>Mover delante del bloque anterior</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Move after the block below</source>
        <translation>Mover detrás del bloque siguiente</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the block</source>
        <translation>Quitar el bloque</translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation>Aún no hay personas: pulse P y haga clic en el mapa.</translation>
    </message>
    <message>
        <source>Select a person to see the behaviour tree.</source>
        <translation>Seleccione una persona para ver su árbol de comportamiento.</translation>
    </message>
    <message>
        <source>%1 · generated from behaviour and goals</source>
        <translation>%1 · generado a partir del comportamiento y los objetivos</translation>
    </message>
    <message>
        <source>%1 · with %2</source>
        <translation>%1 · con %2</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloque</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>bloques</translation>
    </message>
    <message>
        <source>Custom tree; not affected by changes to the behaviour</source>
        <translation>Árbol propio; no le afectan los cambios del comportamiento</translation>
    </message>
    <message>
        <source>Load tree %1</source>
        <translation>Cargar el árbol %1</translation>
    </message>
    <message>
        <source>Load a behaviour tree</source>
        <translation>Cargar un árbol de comportamiento</translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml);;All files (*)</source>
        <translation>Árboles de comportamiento (*.xml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Save the behaviour tree</source>
        <translation>Guardar el árbol de comportamiento</translation>
    </message>
    <message>
        <source>Behaviour trees (*.xml)</source>
        <translation>Árboles de comportamiento (*.xml)</translation>
    </message>
    <message>
        <source>Use the tree of %1</source>
        <translation>Usar el árbol de %1</translation>
    </message>
    <message>
        <source>Select a node above to see its ports.</source>
        <translation>Seleccione arriba un nodo para ver sus puertos.</translation>
    </message>
</context>
<context>
    <name>editor::BlackboardView</name>
    <message>
        <source>Blackboard</source>
        <translation>Pizarra</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>The blackboard is available during a run: press Space.</source>
        <translation>La pizarra está disponible durante una ejecución: pulse Espacio.</translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard. &quot;Branch here…&quot; (in the menu Run) replays the run with it.</source>
        <translation>Las ejecuciones grabadas no contienen pizarra. «Crear rama aquí…» (en el menú Ejecución) repite la ejecución con ella.</translation>
    </message>
    <message>
        <source>Recorded runs contain no blackboard.</source>
        <translation>Las ejecuciones grabadas no contienen pizarra.</translation>
    </message>
    <message>
        <source>Not recorded at this time: the blackboard is recorded from the step in which the person is selected.</source>
        <translation>Sin registrar en este momento: la pizarra se registra desde el paso en que se selecciona la persona.</translation>
    </message>
    <message>
        <source>The tree has no entries.</source>
        <translation>El árbol no tiene entradas.</translation>
    </message>
    <message>
        <source>Takes effect in the next step</source>
        <translation>Surte efecto en el paso siguiente</translation>
    </message>
    <message>
        <source>Double-click to change the value</source>
        <translation>Doble clic para cambiar el valor</translation>
    </message>
    <message>
        <source>%1 becomes %2 in the next step, as an input of the run</source>
        <translation>%1 pasa a ser %2 en el paso siguiente, como entrada de la ejecución</translation>
    </message>
</context>
<context>
    <name>editor::BlockDialog</name>
    <message>
        <source>Blocks</source>
        <translation>Bloques</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Add a behaviour block</source>
        <translation>Añadir un bloque de comportamiento</translation>
    </message>
    <message>
        <source>No people yet</source>
        <translation>Aún no hay personas</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Bloque</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Qué hace</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
</context>
<context>
    <name>editor::BoxTool</name>
    <message>
        <source>Drag a box from corner to corner · Shift makes a square</source>
        <translation>Arrastre un rectángulo de esquina a esquina · Mayús hace un cuadrado</translation>
    </message>
</context>
<context>
    <name>editor::BranchCommand</name>
    <message>
        <source>Continue the run from the displayed step with changes: another planner, other positions, another seed; the run itself is kept</source>
        <translation>Continuar la ejecución desde el paso mostrado de otra manera: otro planificador, otras posiciones, otra semilla; la ejecución misma se conserva</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>Inicie antes una ejecución: Espacio</translation>
    </message>
    <message>
        <source>The maximum number of branches is reached: remove one first</source>
        <translation>Se alcanzó el número máximo de ramas: quite antes una</translation>
    </message>
    <message>
        <source>The inputs of this run are unknown, so it cannot be repeated</source>
        <translation>No se conocen las entradas de esta ejecución, por lo que no se puede repetir</translation>
    </message>
    <message>
        <source>A branch starts at an earlier step: go back on the timeline first</source>
        <translation>Una rama empieza en un paso anterior: retroceda antes en la línea de tiempo</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Branch with this change…</source>
        <translation>Crear rama con este cambio…</translation>
    </message>
    <message>
        <source>Continue the run with %1 here</source>
        <translation>Continuar aquí la ejecución con %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>editor::BranchDialog</name>
    <message>
        <source>Branch at %1</source>
        <translation>Rama en %1</translation>
    </message>
    <message>
        <source>From then on</source>
        <translation>A partir de ahí</translation>
    </message>
    <message>
        <source>Branch name</source>
        <translation>Nombre de la rama</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>PATH = VALUE, one per line: robot1.goal_radius = 0.4</source>
        <translation>RUTA = VALOR, uno por línea: robot1.goal_radius = 0.4</translation>
    </message>
    <message>
        <source>Other values</source>
        <translation>Otros valores</translation>
    </message>
    <message>
        <source>Create branch</source>
        <translation>Crear rama</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Planner of %1</source>
        <translation>Planificador de %1</translation>
    </message>
    <message>
        <source>Top speed of %1</source>
        <translation>Velocidad máxima de %1</translation>
    </message>
    <message>
        <source>Move a person</source>
        <translation>Mover una persona</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posiciones</translation>
    </message>
    <message>
        <source>Move a person…</source>
        <translation>Mover una persona…</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>X of %1</source>
        <translation>X de %1</translation>
    </message>
    <message>
        <source>Y of %1</source>
        <translation>Y de %1</translation>
    </message>
    <message>
        <source>Heading of %1</source>
        <translation>Orientación de %1</translation>
    </message>
    <message>
        <source>Leave %1 in place</source>
        <translation>Dejar %1 en su sitio</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>New random seed</source>
        <translation>Nueva semilla aleatoria</translation>
    </message>
    <message>
        <source>The branch repeats the run up to %1 and pauses there.</source>
        <translation>La rama repite la ejecución hasta %1 y se detiene ahí.</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>semilla</translation>
    </message>
    <message>
        <source>No changes yet: the branch will be identical to the displayed run.</source>
        <translation>Aún sin cambios: la rama será idéntica a la ejecución mostrada.</translation>
    </message>
    <message>
        <source>Changes: %1</source>
        <translation>Cambios: %1</translation>
    </message>
</context>
<context>
    <name>editor::BrushTool</name>
    <message>
        <source>%1 · Esc cancels</source>
        <translation>%1 · Esc cancela</translation>
    </message>
    <message>
        <source>Drag to place people along the path; they face its direction</source>
        <translation>Arrastre para colocar personas a lo largo del camino; miran en su dirección</translation>
    </message>
    <message>
        <source>Every</source>
        <translation>Cada</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
</context>
<context>
    <name>editor::CircleTool</name>
    <message>
        <source>Drag from the centre of the circle to its edge</source>
        <translation>Arrastre desde el centro del círculo hasta su borde</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>radio %1 m</translation>
    </message>
</context>
<context>
    <name>editor::CompareTable</name>
    <message>
        <source>Metrics of the runs</source>
        <translation>Métricas de las ejecuciones</translation>
    </message>
    <message>
        <source>Branch from an earlier moment, or add a recorded run. Checked runs are compared with the displayed run.</source>
        <translation>Cree una rama desde un momento anterior, o añada una ejecución grabada. Las ejecuciones marcadas se comparan con la mostrada.</translation>
    </message>
    <message>
        <source>Whole runs</source>
        <translation>Ejecuciones completas</translation>
    </message>
    <message>
        <source>Compare the whole runs, although they differ in length</source>
        <translation>Comparar las ejecuciones completas, aunque difieran en duración</translation>
    </message>
    <message>
        <source>%1 has another scenario</source>
        <translation>%1 tiene otro escenario</translation>
    </message>
    <message>
        <source>%1 diverges at %2</source>
        <translation>%1 se separa en %2</translation>
    </message>
    <message>
        <source>%1 is identical</source>
        <translation>%1 es idéntica</translation>
    </message>
    <message>
        <source>%1 %2 s</source>
        <translation>%1 %2 s</translation>
    </message>
    <message>
        <source>Compared up to %1 s</source>
        <translation>Comparadas hasta %1 s</translation>
    </message>
    <message>
        <source>outcomes over whole runs</source>
        <translation>resultados de ejecuciones completas</translation>
    </message>
    <message>
        <source>Different lengths</source>
        <translation>Duraciones distintas</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrica</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>Comparado</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>ejecución completa</translation>
    </message>
    <message>
        <source>to %1 s</source>
        <translation>hasta %1 s</translation>
    </message>
    <message>
        <source>Pause the run to compare it.</source>
        <translation>Pause la ejecución para compararla.</translation>
    </message>
    <message>
        <source>Comparing the runs…</source>
        <translation>Comparando las ejecuciones…</translation>
    </message>
    <message>
        <source>Start a run to branch from it or to compare it with recorded runs.</source>
        <translation>Inicie una ejecución para ramificarla o compararla con ejecuciones grabadas.</translation>
    </message>
    <message>
        <source>Values of whole runs</source>
        <translation>Valores de las ejecuciones completas</translation>
    </message>
</context>
<context>
    <name>editor::ContactProbabilityPlot</name>
    <message>
        <source>Probability of contact over time</source>
        <translation>Probabilidad de contacto en el tiempo</translation>
    </message>
    <message>
        <source>share of the futures</source>
        <translation>proporción de los futuros</translation>
    </message>
    <message>
        <source>lower limit (95 % CI)</source>
        <translation>límite inferior (IC 95 %)</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>límite superior</translation>
    </message>
</context>
<context>
    <name>editor::CornerDrawingTool</name>
    <message>
        <source>%1 · Backspace removes the last corner · Esc cancels</source>
        <translation>%1 · Retroceso quita el último vértice · Esc cancela</translation>
    </message>
    <message>
        <source>Click the next corner · Enter or double-click finishes · Backspace removes the last corner · Esc cancels</source>
        <translation>Haga clic en el vértice siguiente · Intro o doble clic terminan · Retroceso quita el último vértice · Esc cancela</translation>
    </message>
    <message>
        <source>At least three corners are required</source>
        <translation>Se necesitan al menos tres vértices</translation>
    </message>
    <message>
        <source>The edges cross</source>
        <translation>Los lados se cruzan</translation>
    </message>
    <message>
        <source>Too small</source>
        <translation>Demasiado pequeño</translation>
    </message>
</context>
<context>
    <name>editor::DockPage</name>
    <message>
        <source>Dock</source>
        <translation>Base de carga</translation>
    </message>
    <message>
        <source>Charges robots</source>
        <translation>Carga robots</translation>
    </message>
    <message>
        <source>Parking place</source>
        <translation>Plaza de aparcamiento</translation>
    </message>
</context>
<context>
    <name>editor::DockTool</name>
    <message>
        <source>Drag to set the heading of a docked robot · Esc cancels</source>
        <translation>Arrastre para fijar la orientación del robot acoplado · Esc cancela</translation>
    </message>
    <message>
        <source>Click the position of a docked robot; drag to set its heading</source>
        <translation>Haga clic en la posición de un robot acoplado; arrastre para fijar su orientación</translation>
    </message>
</context>
<context>
    <name>editor::DoorPage</name>
    <message>
        <source>Door</source>
        <translation>Puerta</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>From X</source>
        <translation>Desde X</translation>
    </message>
    <message>
        <source>From Y</source>
        <translation>Desde Y</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>To X</source>
        <translation>Hasta X</translation>
    </message>
    <message>
        <source>To Y</source>
        <translation>Hasta Y</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abierta</translation>
    </message>
    <message>
        <source>seconds, such as 5, 12.5</source>
        <translation>segundos, como 5, 12.5</translation>
    </message>
    <message>
        <source>Times in seconds, ascending, separated by commas</source>
        <translation>Tiempos en segundos, ascendentes, separados por comas</translation>
    </message>
</context>
<context>
    <name>editor::DoorTool</name>
    <message>
        <source>Drag a door from its hinge to the other jamb · Shift: 15° steps</source>
        <translation>Arrastre una puerta desde su bisagra hasta la otra jamba · Mayús: pasos de 15°</translation>
    </message>
</context>
<context>
    <name>editor::EntityFilter</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>editor::EntityModel</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Robots and docks</source>
        <translation>Robots y bases de carga</translation>
    </message>
    <message>
        <source>Obstacles</source>
        <translation>Obstáculos</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>Áreas</translation>
    </message>
    <message>
        <source>%1 in this run; %2 applies at the next start</source>
        <translation>%1 en esta ejecución; %2 se aplica en el próximo inicio</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamiento</translation>
    </message>
</context>
<context>
    <name>editor::EraserTool</name>
    <message>
        <source>Release to remove it · Esc cancels</source>
        <translation>Suelte para quitarlo · Esc cancela</translation>
    </message>
    <message>
        <source>Release to remove %1 items · Esc cancels</source>
        <translation>Suelte para quitar %1 elementos · Esc cancela</translation>
    </message>
    <message>
        <source>Click items to remove them, or drag over them · Click areas to remove them</source>
        <translation>Haga clic en elementos para quitarlos, o arrastre por encima · Haga clic en áreas para quitarlas</translation>
    </message>
</context>
<context>
    <name>editor::EventsPanel</name>
    <message>
        <source>Events</source>
        <translation>Eventos</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>No events yet: press Space to run.</source>
        <translation>Aún no hay eventos: pulse Espacio para ejecutar.</translation>
    </message>
    <message>
        <source>%1 enters</source>
        <translation>%1 entra</translation>
    </message>
    <message>
        <source>%1 leaves</source>
        <translation>%1 se va</translation>
    </message>
    <message>
        <source>%1 reached %2</source>
        <translation>%1 alcanzó %2</translation>
    </message>
    <message>
        <source>%1 has arrived</source>
        <translation>%1 ha llegado</translation>
    </message>
    <message>
        <source>%1 touches %2</source>
        <translation>%1 toca a %2</translation>
    </message>
    <message>
        <source>%1: “%2”</source>
        <translation>%1: «%2»</translation>
    </message>
    <message>
        <source>%1 hears %2</source>
        <translation>%1 oye %2</translation>
    </message>
    <message>
        <source>%1 starts %2</source>
        <translation>%1 empieza %2</translation>
    </message>
    <message>
        <source>%1 ends %2</source>
        <translation>%1 termina %2</translation>
    </message>
    <message>
        <source>%1 joins group %2</source>
        <translation>%1 se une al grupo %2</translation>
    </message>
    <message>
        <source>%1 plans a new path</source>
        <translation>%1 planifica otro camino</translation>
    </message>
    <message>
        <source>%1 is stuck</source>
        <translation>%1 está atascado</translation>
    </message>
    <message>
        <source>%1: navigation succeeded, %2</source>
        <translation>%1: navegación terminada con éxito, %2</translation>
    </message>
    <message>
        <source>%1: navigation failed, %2</source>
        <translation>%1: navegación fallida, %2</translation>
    </message>
    <message>
        <source>Door %2</source>
        <translation>Puerta %2</translation>
    </message>
    <message>
        <source>The run ends: %2</source>
        <translation>La ejecución termina: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 takes a photo at %2</source>
        <translation>%1 hace una foto en %2</translation>
    </message>
    <message>
        <source>%1: battery %2</source>
        <translation>%1: batería %2</translation>
    </message>
</context>
<context>
    <name>editor::ExportablePlot</name>
    <message>
        <source>Copy plot</source>
        <translation>Copiar gráfica</translation>
    </message>
    <message>
        <source>Copy the plot as PNG and SVG</source>
        <translation>Copiar la gráfica como PNG y SVG</translation>
    </message>
    <message>
        <source>Save plot…</source>
        <translation>Guardar gráfica…</translation>
    </message>
    <message>
        <source>Save the plot as PNG, SVG or PDF</source>
        <translation>Guardar la gráfica como PNG, SVG o PDF</translation>
    </message>
</context>
<context>
    <name>editor::FillTool</name>
    <message>
        <source>Drag or click the corners of an area to fill with %1 and %2 goals</source>
        <translation>Arrastre o haga clic en los vértices de un área que llenar con %1 y %2 objetivos</translation>
    </message>
    <message>
        <source>Drag or click the corners of an area to fill with %1</source>
        <translation>Arrastre o haga clic en los vértices de un área que llenar con %1</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
</context>
<context>
    <name>editor::FuturesPanel</name>
    <message>
        <source>seeds,</source>
        <translation>semillas,</translation>
    </message>
    <message>
        <source>long, people ±</source>
        <translation>de duración, personas ±</translation>
    </message>
    <message>
        <source>Number of futures</source>
        <translation>Número de futuros</translation>
    </message>
    <message>
        <source>Number of simulated futures, each with its own seed</source>
        <translation>Número de futuros simulados, cada uno con su semilla</translation>
    </message>
    <message>
        <source>Length of the futures</source>
        <translation>Duración de los futuros</translation>
    </message>
    <message>
        <source>Duration of each future</source>
        <translation>Duración de cada futuro</translation>
    </message>
    <message>
        <source>Velocity uncertainty</source>
        <translation>Incertidumbre de la velocidad</translation>
    </message>
    <message>
        <source>Velocity uncertainty: once a second each walking person is pushed by a random velocity of this standard deviation. 0: only the variation of the scenario applies</source>
        <translation>Incertidumbre de la velocidad: una vez por segundo cada persona que camina recibe una velocidad aleatoria con esta desviación típica. 0: solo se aplica la variación del escenario</translation>
    </message>
    <message>
        <source>Simulate from the displayed step, in the background</source>
        <translation>Simular desde el paso mostrado, en segundo plano</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Simulate futures</source>
        <translation>Simular futuros</translation>
    </message>
    <message>
        <source>Simulates the run from the displayed step with other random values.</source>
        <translation>Simula la ejecución desde el paso mostrado con otros valores aleatorios.</translation>
    </message>
    <message>
        <source>This run cannot be replayed: its inputs are not known.</source>
        <translation>Esta ejecución no se puede repetir: no se conocen sus entradas.</translation>
    </message>
    <message>
        <source>Start a run and pause it to simulate its futures from there.</source>
        <translation>Inicie una ejecución y póngala en pausa para simular desde ahí sus futuros.</translation>
    </message>
    <message>
        <source>%1 futures</source>
        <translation>%1 futuros</translation>
    </message>
    <message>
        <source>%1 of %2 futures so far</source>
        <translation>%1 de %2 futuros hasta ahora</translation>
    </message>
    <message>
        <source>%1 of %2 futures, cancelled</source>
        <translation>%1 de %2 futuros, cancelado</translation>
    </message>
    <message>
        <source>From %1: %2.</source>
        <translation>Desde %1: %2.</translation>
    </message>
    <message>
        <source>No contact in any run (%1, 95 % CI at most %2).</source>
        <translation>Ningún contacto en ninguna ejecución (%1, IC 95 % como máximo %2).</translation>
    </message>
    <message>
        <source>%1 have a contact (%2, 95 % CI %3 to %4).</source>
        <translation>%1 tienen un contacto (%2, IC 95 % %3 a %4).</translation>
    </message>
    <message>
        <source>Median time %1.</source>
        <translation>Tiempo mediano %1.</translation>
    </message>
    <message>
        <source>%1 ended early.</source>
        <translation>%1 terminaron antes.</translation>
    </message>
</context>
<context>
    <name>editor::FuturesProcess</name>
    <message>
        <source>The futures simulation crashed.</source>
        <translation>La simulación de futuros falló.</translation>
    </message>
</context>
<context>
    <name>editor::GoalAssignment</name>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Assign goals</source>
        <translation>Asignar objetivos</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Asignar</translation>
    </message>
    <message>
        <source>Drag goals to add and reorder them. Assign applies the changes; Undo reverts them.</source>
        <translation>Arrastre objetivos para añadirlos y ordenarlos. Asignar aplica los cambios; Deshacer los revierte.</translation>
    </message>
    <message>
        <source>No people yet: press P and drag on the map</source>
        <translation>Aún no hay personas: pulse P y arrastre en el mapa</translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation>Aún no hay objetivos: pulse G y haga clic en el mapa</translation>
    </message>
    <message>
        <source>Add to the end of the route (Return)</source>
        <translation>Añadir al final de la ruta (Intro)</translation>
    </message>
    <message>
        <source>Remove from the route (Del)</source>
        <translation>Quitar de la ruta (Supr)</translation>
    </message>
    <message>
        <source>Earlier (Alt+Up)</source>
        <translation>Antes (Alt+Arriba)</translation>
    </message>
    <message>
        <source>Later (Alt+Down)</source>
        <translation>Después (Alt+Abajo)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Clear the route of the selected people</source>
        <translation>Vaciar la ruta de las personas seleccionadas</translation>
    </message>
    <message>
        <source>Route of %1</source>
        <translation>Ruta de %1</translation>
    </message>
    <message>
        <source>Route of %1 people</source>
        <translation>Ruta de %1 personas</translation>
    </message>
    <message>
        <source>Select people on the left</source>
        <translation>Seleccione personas a la izquierda</translation>
    </message>
    <message>
        <source>These people have different routes. Added goals go to the end of each.</source>
        <translation>Estas personas tienen rutas distintas. Los objetivos añadidos van al final de cada una.</translation>
    </message>
    <message>
        <source>No goals: people stand still. Add goals from the middle list.</source>
        <translation>Sin objetivos: las personas están quietas. Añada objetivos de la lista central.</translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation>Repetir tras el último</translation>
    </message>
</context>
<context>
    <name>editor::GoalList</name>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (falta)</translation>
    </message>
</context>
<context>
    <name>editor::GoalPage</name>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Visited by</source>
        <translation>Visitado por</translation>
    </message>
    <message>
        <source>several goals selected</source>
        <translation>varios objetivos seleccionados</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
</context>
<context>
    <name>editor::GoalTool</name>
    <message>
        <source>Click to place goal %1 · Esc cancels</source>
        <translation>Haga clic para colocar el objetivo %1 · Esc cancela</translation>
    </message>
    <message>
        <source>Click to add a goal · Click or drag a goal to move it</source>
        <translation>Haga clic para añadir un objetivo · Clic o arrastre en un objetivo para moverlo</translation>
    </message>
    <message>
        <source>Move goal %1</source>
        <translation>Mover el objetivo %1</translation>
    </message>
</context>
<context>
    <name>editor::IssuesPanel</name>
    <message>
        <source>Issues</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>aviso</translation>
    </message>
    <message>
        <source>hints</source>
        <translation>avisos</translation>
    </message>
    <message>
        <source>Information: click to show or hide</source>
        <translation>Información: clic para mostrar u ocultar</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>%1: all %2</source>
        <translation>%1: los %2</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Copiar texto</translation>
    </message>
    <message>
        <source>No issues. Press P and click on the map to place a person.</source>
        <translation>Sin problemas. Pulse P y haga clic en el mapa para colocar una persona.</translation>
    </message>
    <message>
        <source>person</source>
        <translation>persona</translation>
    </message>
    <message>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>objetivo</translation>
    </message>
    <message>
        <source>goals</source>
        <translation>objetivos</translation>
    </message>
    <message>
        <source>No issues.</source>
        <translation>Sin problemas.</translation>
    </message>
    <message>
        <source>No issues. A recorded run is shown.</source>
        <translation>Sin problemas. Se muestra una ejecución grabada.</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>robots</translation>
    </message>
    <message>
        <source>No issues: %1.</source>
        <translation>Sin problemas: %1.</translation>
    </message>
</context>
<context>
    <name>editor::KindSwitch</name>
    <message>
        <source>Selected kinds</source>
        <translation>Tipos seleccionados</translation>
    </message>
    <message>
        <source>Show and change the selected items of this kind</source>
        <translation>Mostrar y cambiar los elementos seleccionados de este tipo</translation>
    </message>
</context>
<context>
    <name>editor::LayersPanel</name>
    <message>
        <source>Opacity of %1</source>
        <translation>Opacidad de %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Ocultar %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Mostrar %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>all of %1</source>
        <translation>todo: %1</translation>
    </message>
</context>
<context>
    <name>editor::LegendStrip</name>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
</context>
<context>
    <name>editor::ManualDriveController</name>
    <message>
        <source>&amp;Drive manually</source>
        <translation>&amp;Conducir manualmente</translation>
    </message>
    <message>
        <source>Drive the selected robot with the arrow keys or W A S D; it brakes without a key. Esc returns control to its planner</source>
        <translation>Conducir el robot seleccionado con las flechas o W A S D; frena sin tecla. Esc devuelve el control a su planificador</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Conducir</translation>
    </message>
</context>
<context>
    <name>editor::MapInset</name>
    <message>
        <source>The map around the person</source>
        <translation>El mapa alrededor de la persona</translation>
    </message>
    <message>
        <source>Map around %1</source>
        <translation>Mapa alrededor de %1</translation>
    </message>
</context>
<context>
    <name>editor::MapPaintTool</name>
    <message>
        <source>No map to paint on: start with a room, a map or an image</source>
        <translation>No hay mapa que pintar: empiece con una sala, un mapa o una imagen</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>paredes</translation>
    </message>
    <message>
        <source>free space</source>
        <translation>espacio libre</translation>
    </message>
    <message>
        <source>unknown space</source>
        <translation>espacio desconocido</translation>
    </message>
    <message>
        <source>Drag to paint %1, %2 m wide · 1 wall, 2 free, 3 unknown · [ ] width · Shift: free</source>
        <translation>Arrastre para pintar %1, %2 m de ancho · 1 pared, 2 libre, 3 desconocido · [ ] ancho · Mayús: libre</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Pared</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Espacio libre</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Desconocido</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Pintar</translation>
    </message>
    <message>
        <source>Cell type</source>
        <translation>Tipo de celda</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>Paint the map</source>
        <translation>Pintar el mapa</translation>
    </message>
</context>
<context>
    <name>editor::MapView</name>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
</context>
<context>
    <name>editor::MeasureTool</name>
    <message>
        <source>Drag from one point to another · Shift: 15° steps</source>
        <translation>Arrastre de un punto a otro · Mayús: pasos de 15°</translation>
    </message>
    <message>
        <source>Distance %1 m · angle %2 · Δx %3 m · Δy %4 m</source>
        <translation>Distancia %1 m · ángulo %2 · Δx %3 m · Δy %4 m</translation>
    </message>
</context>
<context>
    <name>editor::MetricPlot</name>
    <message>
        <source>Curve: %1</source>
        <translation>Curva: %1</translation>
    </message>
</context>
<context>
    <name>editor::MetricsDock</name>
    <message>
        <source>Metrics appear when a simulation runs: press Space.</source>
        <translation>Las métricas aparecen cuando se ejecuta una simulación: pulse Espacio.</translation>
    </message>
    <message>
        <source>Metrics of</source>
        <translation>Métricas de</translation>
    </message>
    <message>
        <source>Robot whose metrics are shown</source>
        <translation>Robot cuyas métricas se muestran</translation>
    </message>
    <message>
        <source>%1 needs a robot: press B, then click its start and its goal.</source>
        <translation>%1 necesita un robot: pulse B y haga clic en su inicio y su objetivo.</translation>
    </message>
    <message>
        <source>%1 has no value: %2</source>
        <translation>%1 no tiene valor: %2</translation>
    </message>
</context>
<context>
    <name>editor::MetricsTable</name>
    <message>
        <source>Measured</source>
        <translation>Medidas</translation>
    </message>
    <message>
        <source>Show only the metrics that are measured</source>
        <translation>Mostrar solo las métricas que se miden</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Measure all listed metrics</source>
        <translation>Medir todas las métricas de la lista</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Measure no listed metric</source>
        <translation>No medir ninguna métrica de la lista</translation>
    </message>
    <message>
        <source>Save the choice to the metrics file of the scenario</source>
        <translation>Guardar la elección en el archivo de métricas del escenario</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Métricas</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Métrica</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Since start</source>
        <translation>Desde el inicio</translation>
    </message>
    <message>
        <source>As if %1 were the only person</source>
        <translation>Como si %1 fuera la única persona</translation>
    </message>
    <message>
        <source>No value: %1</source>
        <translation>Sin valor: %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 of %2 metrics are measured</source>
        <translation>Se miden %1 de %2 métricas</translation>
    </message>
    <message>
        <source>Set metrics file</source>
        <translation>Elegir archivo de métricas</translation>
    </message>
    <message>
        <source>Find a metric</source>
        <translation>Buscar una métrica</translation>
    </message>
    <message>
        <source>Save choice</source>
        <translation>Guardar selección</translation>
    </message>
    <message>
        <source>needs a robot</source>
        <translation>necesita un robot</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>The value from the start of the run to the shown time</source>
        <translation>El valor desde el inicio de la ejecución hasta el instante mostrado</translation>
    </message>
    <message>
        <source>The curve of the values per step, or of the values since the start if the metric has none per step</source>
        <translation>La curva de los valores por paso, o de los valores desde el inicio si la métrica no tiene valores por paso</translation>
    </message>
</context>
<context>
    <name>editor::MixButton</name>
    <message>
        <source>Mix of behaviours and seed</source>
        <translation>Mezcla de comportamientos y semilla</translation>
    </message>
</context>
<context>
    <name>editor::Nav2Form</name>
    <message>
        <source>Changed only</source>
        <translation>Solo lo cambiado</translation>
    </message>
    <message>
        <source>Show only values that differ from the file</source>
        <translation>Mostrar solo los valores que difieren del archivo</translation>
    </message>
    <message>
        <source>Reset value</source>
        <translation>Restablecer valor</translation>
    </message>
    <message>
        <source>Reset to the value in the file (Delete)</source>
        <translation>Volver al valor del archivo (Supr)</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>Servidores</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Parámetros de Nav2</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>In the file</source>
        <translation>En el archivo</translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation>Valor de Nav2</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 cambiados</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Como en el archivo</translation>
    </message>
    <message>
        <source>Double-click a value to change it. The scenario keeps the change; the file is only changed by saving it as a new file.</source>
        <translation>Doble clic para cambiar un valor. El escenario conserva el cambio; el archivo solo se cambia al guardarlo como archivo nuevo.</translation>
    </message>
    <message>
        <source>Nav2 default %1</source>
        <translation>Valor de Nav2: %1</translation>
    </message>
    <message>
        <source> · in the file %1</source>
        <translation> · en el archivo %1</translation>
    </message>
    <message>
        <source> · not in the file</source>
        <translation> · no está en el archivo</translation>
    </message>
    <message>
        <source>Find a parameter</source>
        <translation>Buscar un parámetro</translation>
    </message>
    <message>
        <source>Find a Nav2 parameter</source>
        <translation>Buscar un parámetro de Nav2</translation>
    </message>
    <message>
        <source>Applies at the next start</source>
        <translation>Se aplica en el próximo inicio</translation>
    </message>
    <message>
        <source>Changes take effect at the next start. A dot marks values that differ from those of the run.</source>
        <translation>Los cambios se aplican en el próximo inicio. Un punto marca los valores distintos de los de la simulación.</translation>
    </message>
    <message>
        <source> · applies at the next start</source>
        <translation> · se aplica en el próximo inicio</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Show changed and unchanged values</source>
        <translation>Mostrar los valores cambiados y los no cambiados</translation>
    </message>
    <message>
        <source>No changed values</source>
        <translation>No hay valores cambiados</translation>
    </message>
    <message>
        <source>No changed values match the filter</source>
        <translation>Ningún valor cambiado coincide con el filtro</translation>
    </message>
</context>
<context>
    <name>editor::Nav2Panel</name>
    <message>
        <source>No robot is driven by Nav2. Select a robot and choose the planner nav2 in its properties.</source>
        <translation>Ningún robot usa Nav2. Seleccione un robot y elija el planificador nav2 en sus propiedades.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>The robot whose parameters are shown</source>
        <translation>El robot cuyos parámetros se muestran</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Reset all values to those in the file</source>
        <translation>Volver a los valores del archivo</translation>
    </message>
    <message>
        <source>Reset Nav2 parameters</source>
        <translation>Restablecer los parámetros de Nav2</translation>
    </message>
    <message>
        <source>Save as a new file…</source>
        <translation>Guardar como archivo nuevo…</translation>
    </message>
    <message>
        <source>Write the changed values into a copy of the parameter file, with its comments and order, and use that file</source>
        <translation>Escribir los valores cambiados en una copia del archivo de parámetros, con sus comentarios y su orden, y usar ese archivo</translation>
    </message>
    <message>
        <source>Save the Nav2 parameters as a new file</source>
        <translation>Guardar los parámetros de Nav2 como archivo nuevo</translation>
    </message>
    <message>
        <source>Nav2 parameters (*.yaml *.yml)</source>
        <translation>Parámetros de Nav2 (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Save Nav2 parameters</source>
        <translation>Guardar los parámetros de Nav2</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Elegir archivo…</translation>
    </message>
    <message>
        <source>Use another parameter file (nav2_params.yaml)</source>
        <translation>Usar otro archivo de parámetros (nav2_params.yaml)</translation>
    </message>
    <message>
        <source>Choose Nav2 parameters</source>
        <translation>Elegir parámetros de Nav2</translation>
    </message>
</context>
<context>
    <name>editor::NoMatchesPlaceholder</name>
    <message>
        <source>Clear</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Show the whole list</source>
        <translation>Mostrar la lista completa</translation>
    </message>
    <message>
        <source>No matches for &apos;%1&apos;</source>
        <translation>Ningún resultado para «%1»</translation>
    </message>
</context>
<context>
    <name>editor::NodeFields</name>
    <message>
        <source>Name and ports of the node</source>
        <translation>Nombre y puertos del nodo</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Enter applies, Esc cancels</source>
        <translation>Intro aplica, Esc cancela</translation>
    </message>
</context>
<context>
    <name>editor::NodePalette</name>
    <message>
        <source>Search by name or description</source>
        <translation>Buscar por nombre o descripción</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Nodos</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Control</translation>
    </message>
    <message>
        <source>Decorators</source>
        <translation>Decoradores</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Condiciones</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Acciones</translation>
    </message>
    <message>
        <source>Subtrees</source>
        <translation>Subárboles</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Plantillas</translation>
    </message>
    <message>
        <source>Runs the tree %1 with all entries of this tree.</source>
        <translation>Ejecuta el árbol %1 con todas las entradas de este árbol.</translation>
    </message>
    <message>
        <source>Drag a node into the tree, or double-click it to add it to the selected node.</source>
        <translation>Arrastre un nodo al árbol, o haga doble clic en él para añadirlo al nodo seleccionado.</translation>
    </message>
    <message>
        <source>Find a node</source>
        <translation>Buscar un nodo</translation>
    </message>
</context>
<context>
    <name>editor::NumberField</name>
    <message>
        <source>above %1%2</source>
        <translation>más de %1%2</translation>
    </message>
    <message>
        <source>at least %1%2</source>
        <translation>al menos %1%2</translation>
    </message>
    <message>
        <source>at most %1%2</source>
        <translation>como máximo %1%2</translation>
    </message>
    <message>
        <source>above %1, at most %2%3</source>
        <translation>más de %1, como máximo %2%3</translation>
    </message>
    <message>
        <source>%1 to %2%3</source>
        <translation>de %1 a %2%3</translation>
    </message>
    <message>
        <source>Use the default</source>
        <translation>Usar el valor predeterminado</translation>
    </message>
    <message>
        <source>must be %1</source>
        <translation>debe ser %1</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>no es un número</translation>
    </message>
    <message>
        <source>not a number; must be %1</source>
        <translation>no es un número; debe ser %1</translation>
    </message>
</context>
<context>
    <name>editor::ObstaclePage</name>
    <message>
        <source>Obstacle</source>
        <translation>Obstáculo</translation>
    </message>
    <message>
        <source>several shapes</source>
        <translation>varias formas</translation>
    </message>
</context>
<context>
    <name>editor::PanTool</name>
    <message>
        <source>Drag to move the map · Wheel zooms</source>
        <translation>Arrastre para desplazar el mapa · La rueda amplía y reduce</translation>
    </message>
</context>
<context>
    <name>editor::PeopleInteraction</name>
    <message>
        <source>Spawn a person with the same tree and goals here, as an input of the run</source>
        <translation>Generar aquí una persona con el mismo árbol y los mismos objetivos, como entrada de la ejecución</translation>
    </message>
    <message>
        <source>Add a person like</source>
        <translation>Añadir una persona como</translation>
    </message>
    <message>
        <source>Push %1…	Shift+drag</source>
        <translation>Empujar a %1…	Mayús+arrastrar</translation>
    </message>
    <message>
        <source>Then drag an arrow: 1 m is 1 m/s</source>
        <translation>Después arrastre una flecha: 1 m equivale a 1 m/s</translation>
    </message>
    <message>
        <source>Resume %1</source>
        <translation>Reanudar %1</translation>
    </message>
    <message>
        <source>Stop %1</source>
        <translation>Detener %1</translation>
    </message>
    <message>
        <source>The person stops and stands still until resumed</source>
        <translation>La persona se detiene y espera hasta que se la reanude</translation>
    </message>
</context>
<context>
    <name>editor::PersonPage</name>
    <message>
        <source>Pose and body</source>
        <translation>Posición y cuerpo</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Persona</translation>
    </message>
    <message>
        <source>Mix…</source>
        <translation>Mezcla…</translation>
    </message>
    <message>
        <source>Set the shares of behaviours among these people</source>
        <translation>Repartir los comportamientos entre estas personas</translation>
    </message>
    <message>
        <source>Adult</source>
        <translation>Adulto</translation>
    </message>
    <message>
        <source>Child</source>
        <translation>Niño</translation>
    </message>
    <message>
        <source>Elderly</source>
        <translation>Mayores</translation>
    </message>
    <message>
        <source>Wheelchair</source>
        <translation>Silla de ruedas</translation>
    </message>
    <message>
        <source>With luggage</source>
        <translation>Con equipaje</translation>
    </message>
    <message>
        <source>Goals</source>
        <translation>Objetivos</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>Asignar objetivos…</translation>
    </message>
    <message>
        <source>Assign ordered goals to several people (Ctrl+G)</source>
        <translation>Asignar objetivos ordenados a varias personas (Ctrl+G)</translation>
    </message>
    <message>
        <source>different routes</source>
        <translation>rutas distintas</translation>
    </message>
    <message>
        <source>visited in order</source>
        <translation>visitados en orden</translation>
    </message>
    <message>
        <source>Repeat after the last</source>
        <translation>Repetir tras el último</translation>
    </message>
    <message>
        <source>One time in seconds per goal, separated by commas</source>
        <translation>Un tiempo en segundos por objetivo, separados por comas</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predeterminado</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personalizado</translation>
    </message>
    <message>
        <source>Random, by seed</source>
        <translation>Aleatorio, por semilla</translation>
    </message>
    <message>
        <source>Reaction to the robot</source>
        <translation>Reacción al robot</translation>
    </message>
    <message>
        <source>Then continues</source>
        <translation>Luego continúa</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Fuerzas</translation>
    </message>
    <message>
        <source>Show the random values of a run with this seed; the scenario keeps its seed</source>
        <translation>Mostrar los valores aleatorios de una ejecución con esta semilla; el escenario conserva su semilla</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Muestrear</translation>
    </message>
    <message>
        <source>Sample with another seed</source>
        <translation>Muestrear con otra semilla</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semilla</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Store these numbers as custom values</source>
        <translation>Guardar estos números como valores personalizados</translation>
    </message>
    <message>
        <source>Freeze random values</source>
        <translation>Fijar valores aleatorios</translation>
    </message>
    <message>
        <source>Use this seed</source>
        <translation>Usar esta semilla</translation>
    </message>
    <message>
        <source>Set it as the seed of the scenario</source>
        <translation>Ponerla como semilla del escenario</translation>
    </message>
    <message>
        <source>Change seed</source>
        <translation>Cambiar la semilla</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Más</translation>
    </message>
    <message>
        <source>As in scenario</source>
        <translation>Como en el escenario</translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation>Rodeando paredes</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Recto</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Se detiene</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Se va</translation>
    </message>
    <message>
        <source>Starts over</source>
        <translation>Vuelve a empezar</translation>
    </message>
    <message>
        <source>Id of the person; part of the name of the tree file</source>
        <translation>Id de la persona; parte del nombre del archivo de árbol</translation>
    </message>
    <message>
        <source>Change number</source>
        <translation>Cambiar el número</translation>
    </message>
    <message>
        <source>Height z</source>
        <translation>Altura z</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>People in a group stay together while they walk</source>
        <translation>Las personas de un grupo permanecen juntas al caminar</translation>
    </message>
    <message>
        <source>Walks with</source>
        <translation>Camina con</translation>
    </message>
    <message>
        <source>name of the group</source>
        <translation>nombre del grupo</translation>
    </message>
    <message>
        <source>Group name</source>
        <translation>Nombre del grupo</translation>
    </message>
    <message>
        <source>Members</source>
        <translation>Miembros</translation>
    </message>
    <message>
        <source>Dissolve</source>
        <translation>Disolver</translation>
    </message>
    <message>
        <source>Remove all people from the group</source>
        <translation>Quitar a todas las personas del grupo</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>Each other (new group)</source>
        <translation>Entre sí (grupo nuevo)</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>Grupo nuevo</translation>
    </message>
    <message>
        <source>different groups</source>
        <translation>grupos distintos</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspecto</translation>
    </message>
    <message>
        <source>Appearance in the simulator of the scenario</source>
        <translation>Aspecto en el simulador del escenario</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Figura</translation>
    </message>
    <message>
        <source>Elsewhere</source>
        <translation>En otros</translation>
    </message>
    <message>
        <source>Change appearance</source>
        <translation>Cambiar el aspecto</translation>
    </message>
    <message>
        <source>as in Gazebo</source>
        <translation>como en Gazebo</translation>
    </message>
    <message>
        <source>Regenerate tree</source>
        <translation>Regenerar el árbol</translation>
    </message>
    <message>
        <source>Generate the tree from behaviour, reaction and goals; Ctrl+Z restores the custom tree</source>
        <translation>Generar el árbol a partir de comportamiento, reacción y objetivos; Ctrl+Z restaura el árbol propio</translation>
    </message>
    <message>
        <source>Uses a custom tree.</source>
        <translation>Usa un árbol propio.</translation>
    </message>
    <message>
        <source>%1 with custom trees.</source>
        <translation>%1 con árboles propios.</translation>
    </message>
    <message>
        <source>person</source>
        <translation>persona</translation>
    </message>
    <message>
        <source>people</source>
        <translation>personas</translation>
    </message>
    <message>
        <source>Changes made here do not affect it.</source>
        <translation>Los cambios hechos aquí no le afectan.</translation>
    </message>
    <message>
        <source>Changes made here do not affect custom trees.</source>
        <translation>Los cambios hechos aquí no afectan a los árboles propios.</translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect it.</source>
        <translation>Comportamiento, reacción y objetivos no le afectan.</translation>
    </message>
    <message>
        <source>Behaviour, reaction and goals do not affect these trees.</source>
        <translation>Comportamiento, reacción y objetivos no afectan a estos árboles.</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Intensidad</translation>
    </message>
    <message>
        <source>Random strengths depend only on the seed and the person</source>
        <translation>Las intensidades aleatorias solo dependen de la semilla y la persona</translation>
    </message>
    <message>
        <source>Custom values</source>
        <translation>Valores propios</translation>
    </message>
    <message>
        <source>Random, normal</source>
        <translation>Aleatorio, normal</translation>
    </message>
    <message>
        <source>Random, uniform</source>
        <translation>Aleatorio, uniforme</translation>
    </message>
    <message>
        <source>Height of the model in a 3D simulator; not used here</source>
        <translation>Altura del modelo en un simulador 3D; aquí no se usa</translation>
    </message>
    <message>
        <source>one per goal: 2, 0</source>
        <translation>una por meta: 2, 0</translation>
    </message>
</context>
<context>
    <name>editor::PersonTool</name>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation>Arrastre para fijar la orientación · Esc cancela</translation>
    </message>
    <message>
        <source>Click to place a person; drag to set the heading</source>
        <translation>Haga clic para colocar una persona; arrastre para fijar la orientación</translation>
    </message>
</context>
<context>
    <name>editor::PlaybackActions</name>
    <message>
        <source>Step back</source>
        <translation>Paso atrás</translation>
    </message>
    <message>
        <source>Go back one recorded step</source>
        <translation>Retroceder un paso registrado</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>Ejecutar o pausar la simulación</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>One step forward, then pause</source>
        <translation>Avanzar un paso y pausar</translation>
    </message>
    <message>
        <source>Go to newest step</source>
        <translation>Ir al paso más reciente</translation>
    </message>
    <message>
        <source>Show the newest step of the run</source>
        <translation>Mostrar el paso más reciente de la ejecución</translation>
    </message>
    <message>
        <source>&amp;Branch here…</source>
        <translation>Crear &amp;rama aquí…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>Inicie antes una ejecución: Espacio</translation>
    </message>
    <message>
        <source>The newest step is already shown</source>
        <translation>Ya se muestra el paso más reciente</translation>
    </message>
    <message>
        <source>Speed
Simulated seconds per real second</source>
        <translation>Velocidad
Segundos simulados por segundo real</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Return to editing</source>
        <translation>Volver a la edición</translation>
    </message>
    <message>
        <source>End the run; the scenario can be edited again</source>
        <translation>Terminar la ejecución; el escenario se puede editar de nuevo</translation>
    </message>
</context>
<context>
    <name>editor::PolygonTool</name>
    <message>
        <source>Click the corners of an obstacle; click the first one to close it</source>
        <translation>Haga clic en los vértices de un obstáculo; clic en el primero para cerrarlo</translation>
    </message>
</context>
<context>
    <name>editor::PropertyPage</name>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Reset all to their default values</source>
        <translation>Restablecer todos los valores predeterminados</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 cambiados</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Restablecer %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Applies at the next start</source>
        <translation>Se aplica en el próximo inicio</translation>
    </message>
    <message>
        <source>A name starts with a letter and contains only letters, digits and _</source>
        <translation>Un nombre empieza con una letra y solo contiene letras, cifras y _</translation>
    </message>
    <message>
        <source>This name is already in use</source>
        <translation>Este nombre ya está en uso</translation>
    </message>
    <message>
        <source>%1 selected</source>
        <translation>Selección: %1</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>name=value, separated by commas</source>
        <translation>nombre=valor, separados por comas</translation>
    </message>
    <message>
        <source>In the scenario</source>
        <translation>En el escenario</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Sí</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Activo</translation>
    </message>
    <message>
        <source>Off: kept in the file, but not in the run</source>
        <translation>Desactivado: se conserva en el archivo, pero no en la ejecución</translation>
    </message>
</context>
<context>
    <name>editor::PropertyPanel</name>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Restart the run with the current settings</source>
        <translation>Reiniciar la ejecución con los ajustes actuales</translation>
    </message>
    <message>
        <source>Changes take effect at the next start.</source>
        <translation>Los cambios se aplican en el próximo inicio.</translation>
    </message>
    <message>
        <source>A dot marks values that differ from those of the run</source>
        <translation>Un punto marca los valores que difieren de los de la ejecución</translation>
    </message>
    <message>
        <source>Person %1 · %2</source>
        <translation>Persona %1 · %2</translation>
    </message>
    <message>
        <source> · goals %1</source>
        <translation> · objetivos %1</translation>
    </message>
    <message>
        <source>other</source>
        <translation>más</translation>
    </message>
    <message>
        <source>others</source>
        <translation>más</translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>Los cambios se aplican a todos</translation>
    </message>
    <message>
        <source>Changes apply to these, not to %1</source>
        <translation>Los cambios se aplican a estos, no a %1</translation>
    </message>
    <message>
        <source>Scenario · nothing selected</source>
        <translation>Escenario · nada seleccionado</translation>
    </message>
    <message>
        <source>%1 · and %2</source>
        <translation>%1 · y %2</translation>
    </message>
    <message>
        <source>Spawned by a source in this run. To change such people, select the person that the source copies.</source>
        <translation>Generada por una fuente en esta ejecución. Para cambiar a estas personas, seleccione la persona que copia la fuente.</translation>
    </message>
</context>
<context>
    <name>editor::RobotPage</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Parameters that are unknown to the planner or not numbers</source>
        <translation>Parámetros que el planificador no conoce o que no son números</translation>
    </message>
    <message>
        <source>Body and limits</source>
        <translation>Cuerpo y límites</translation>
    </message>
    <message>
        <source>disc with the radius</source>
        <translation>disco con el radio</translation>
    </message>
    <message>
        <source>Differential</source>
        <translation>Diferencial</translation>
    </message>
    <message>
        <source>Omnidirectional</source>
        <translation>Omnidireccional</translation>
    </message>
    <message>
        <source>Ackermann</source>
        <translation>Ackermann</translation>
    </message>
    <message>
        <source>As robot type (default)</source>
        <translation>Como el tipo (predet.)</translation>
    </message>
    <message>
        <source>People perception</source>
        <translation>Percepción de personas</translation>
    </message>
    <message>
        <source>Visible people</source>
        <translation>Personas visibles</translation>
    </message>
    <message>
        <source>All (ground truth)</source>
        <translation>Todas (verdad terreno)</translation>
    </message>
    <message>
        <source>(default)</source>
        <translation>(predet.)</translation>
    </message>
    <message>
        <source>Ground truth</source>
        <translation>Verdad terreno</translation>
    </message>
    <message>
        <source>From positions</source>
        <translation>A partir de posiciones</translation>
    </message>
    <message>
        <source>Lidar</source>
        <translation>Lidar</translation>
    </message>
    <message>
        <source>Odometry errors</source>
        <translation>Errores de odometría</translation>
    </message>
    <message>
        <source>Localisation</source>
        <translation>Localización</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Batería</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Fuentes</translation>
    </message>
    <message>
        <source>Published data</source>
        <translation>Datos publicados</translation>
    </message>
    <message>
        <source>as generic robot</source>
        <translation>como un robot genérico</translation>
    </message>
    <message>
        <source>Nav2 default</source>
        <translation>Valor de Nav2</translation>
    </message>
    <message>
        <source>not published</source>
        <translation>no publicado</translation>
    </message>
    <message>
        <source>Humble</source>
        <translation>Humble</translation>
    </message>
    <message>
        <source>Jazzy</source>
        <translation>Jazzy</translation>
    </message>
    <message>
        <source>Kilted</source>
        <translation>Kilted</translation>
    </message>
    <message>
        <source>Lyrical</source>
        <translation>Lyrical</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>As in the file (default)</source>
        <translation>Como el archivo (predet.)</translation>
    </message>
    <message>
        <source>Nav2 parameters</source>
        <translation>Parámetros de Nav2</translation>
    </message>
    <message>
        <source>Open Nav2 panel</source>
        <translation>Abrir panel Nav2</translation>
    </message>
    <message>
        <source>Use body</source>
        <translation>Usar cuerpo</translation>
    </message>
    <message>
        <source>Use radius or footprint from local_costmap in the file</source>
        <translation>Usar radio o contorno de local_costmap del archivo</translation>
    </message>
    <message>
        <source>Use the body in the Nav2 file</source>
        <translation>Usar el cuerpo del archivo de Nav2</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 cambiados</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Goal X</source>
        <translation>Objetivo X</translation>
    </message>
    <message>
        <source>Goal Y</source>
        <translation>Objetivo Y</translation>
    </message>
    <message>
        <source>Ordered global goals instead of a point</source>
        <translation>Objetivos globales ordenados en lugar de un punto</translation>
    </message>
    <message>
        <source>Or route</source>
        <translation>O ruta</translation>
    </message>
    <message>
        <source>Change robot route</source>
        <translation>Cambiar la ruta del robot</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>está quieto</translation>
    </message>
    <message>
        <source>ends the run</source>
        <translation>termina la ejecución</translation>
    </message>
    <message>
        <source>Choose the parameter file and view or change all parameters</source>
        <translation>Elegir el archivo de parámetros, y ver y cambiar todos los parámetros</translation>
    </message>
</context>
<context>
    <name>editor::RobotPicture</name>
    <message>
        <source>Robot body</source>
        <translation>Cuerpo del robot</translation>
    </message>
    <message>
        <source>%1 long, %2 wide</source>
        <translation>%1 de largo, %2 de ancho</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Conducir</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
</context>
<context>
    <name>editor::RobotTool</name>
    <message>
        <source>Click the goal of the robot · Esc keeps the current goal</source>
        <translation>Haga clic en el objetivo del robot · Esc conserva el objetivo actual</translation>
    </message>
    <message>
        <source>Drag to set the heading · Esc cancels</source>
        <translation>Arrastre para fijar la orientación · Esc cancela</translation>
    </message>
    <message>
        <source>Click to place the robot; drag to set the heading · Shift adds another</source>
        <translation>Haga clic para colocar el robot; arrastre para fijar la orientación · Mayús añade otro</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Colocar %1</translation>
    </message>
    <message>
        <source>Set robot goal</source>
        <translation>Poner el objetivo del robot</translation>
    </message>
</context>
<context>
    <name>editor::RouteEditor</name>
    <message>
        <source>
Click for options, press Delete to remove it</source>
        <translation>
Clic para ver opciones, Supr lo quita</translation>
    </message>
    <message>
        <source>+ Add</source>
        <translation>+ Añadir</translation>
    </message>
    <message>
        <source>Add a goal to the end of the route</source>
        <translation>Añadir un objetivo al final de la ruta</translation>
    </message>
    <message>
        <source>No goals yet: press G and click on the map</source>
        <translation>Aún no hay objetivos: pulse G y haga clic en el mapa</translation>
    </message>
    <message>
        <source>Select goal %1</source>
        <translation>Seleccionar el objetivo %1</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Remove from the route</source>
        <translation>Quitar de la ruta</translation>
    </message>
</context>
<context>
    <name>editor::RouteTool</name>
    <message>
        <source>Click the person or robot that follows the route (Shift adds more)</source>
        <translation>Haga clic en la persona o el robot que sigue la ruta (Mayús añade más)</translation>
    </message>
    <message>
        <source>Click the goals in visiting order</source>
        <translation>Haga clic en los objetivos por orden de visita</translation>
    </message>
    <message>
        <source>Route %1 · Enter applies · Backspace removes the last goal · Esc cancels</source>
        <translation>Ruta %1 · Intro aplica · Retroceso quita el último objetivo · Esc cancela</translation>
    </message>
    <message>
        <source>Nothing is selected: click a person or robot first</source>
        <translation>No hay nada seleccionado: haga clic antes en una persona o un robot</translation>
    </message>
    <message>
        <source>No goal here: click the pin of a goal, or press G to add goals</source>
        <translation>Aquí no hay objetivo: haga clic en el marcador de uno, o pulse G para añadir objetivos</translation>
    </message>
    <message>
        <source>%1 is already the last goal of the route</source>
        <translation>%1 ya es el último objetivo de la ruta</translation>
    </message>
</context>
<context>
    <name>editor::RunEvents</name>
    <message>
        <source>%1 has arrived at %2</source>
        <translation>%1 ha llegado a %2</translation>
    </message>
    <message>
        <source>the goal</source>
        <translation>el objetivo</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>Robot %1</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>Persona %1</translation>
    </message>
    <message>
        <source>%1 touches a wall</source>
        <translation>%1 toca una pared</translation>
    </message>
</context>
<context>
    <name>editor::RunOverlayUpdater</name>
    <message>
        <source>says %1</source>
        <translation>dice %1</translation>
    </message>
    <message>
        <source>hears %1: %2</source>
        <translation>oye a %1: %2</translation>
    </message>
    <message>
        <source>Person %1</source>
        <translation>Persona %1</translation>
    </message>
    <message>
        <source> · to %1</source>
        <translation> · hacia %1</translation>
    </message>
</context>
<context>
    <name>editor::RunStateSection</name>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Objetivo</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Manual drive</source>
        <translation>Conducción manual</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>reacting</source>
        <translation>reaccionando</translation>
    </message>
    <message>
        <source>%1 m, surface to surface</source>
        <translation>%1 m, entre bordes</translation>
    </message>
    <message>
        <source>Distance between the bodies, not their centres, as in the metrics</source>
        <translation>Distancia entre los cuerpos, no entre sus centros, como en las métricas</translation>
    </message>
</context>
<context>
    <name>editor::RunningNodes</name>
    <message>
        <source>Running nodes</source>
        <translation>Nodos en ejecución</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Nodo</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Running for</source>
        <translation>Activo desde hace</translation>
    </message>
    <message>
        <source>Running nodes are listed during a run: press Space.</source>
        <translation>Los nodos en ejecución se muestran durante una ejecución: pulse Espacio.</translation>
    </message>
    <message>
        <source>No node is running at this time.</source>
        <translation>Ningún nodo se ejecuta en este momento.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>editor::RunsPanel</name>
    <message>
        <source>Show this run at the same time step</source>
        <translation>Mostrar esta ejecución en el mismo paso</translation>
    </message>
    <message>
        <source>Remove this run from the list</source>
        <translation>Quitar esta ejecución de la lista</translation>
    </message>
    <message>
        <source>Show up to four compared runs beside the map</source>
        <translation>Mostrar hasta cuatro ejecuciones comparadas junto al mapa</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Branched at</source>
        <translation>Ramificada en</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>Compare with a run folder</source>
        <translation>Comparar con una carpeta de ejecución</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>Press F2 to rename</source>
        <translation>Pulse F2 para cambiar el nombre</translation>
    </message>
    <message>
        <source>%1 (truncated)</source>
        <translation>%1 (truncado)</translation>
    </message>
    <message>
        <source>Branch here…</source>
        <translation>Crear rama aquí…</translation>
    </message>
    <message>
        <source>Add a run…</source>
        <translation>Añadir ejecución…</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Lado a lado</translation>
    </message>
    <message>
        <source>Add a recorded run to compare: the output folder of hunavsim run</source>
        <translation>Añadir una ejecución grabada para comparar: la carpeta de salida de hunavsim run</translation>
    </message>
    <message>
        <source>%1, from %2</source>
        <translation>%1, desde %2</translation>
    </message>
    <message>
        <source>%1 ended at %2 s</source>
        <translation>%1 terminó en %2 s</translation>
    </message>
    <message>
        <source>ended at %1 s</source>
        <translation>terminó en %1 s</translation>
    </message>
</context>
<context>
    <name>editor::ScenarioDocument</name>
    <message>
        <source>Change map</source>
        <translation>Cambiar el mapa</translation>
    </message>
    <message>
        <source>Keep the tree file of %1</source>
        <translation>Conservar el archivo de árbol de %1</translation>
    </message>
    <message>
        <source>Use the generated tree of %1</source>
        <translation>Usar el árbol generado de %1</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
</context>
<context>
    <name>editor::ScenarioPanel</name>
    <message>
        <source>Show on the map</source>
        <translation>Mostrar en el mapa</translation>
    </message>
    <message>
        <source>Centre the map on it</source>
        <translation>Centrar el mapa en él</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Duplicate the selection</source>
        <translation>Duplicar la selección</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Borrar</translation>
    </message>
    <message>
        <source>Remove the selection; routes are updated</source>
        <translation>Quitar la selección; las rutas se actualizan</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Cambiar el nombre</translation>
    </message>
    <message>
        <source>Change the number of the goal</source>
        <translation>Cambiar el número del objetivo</translation>
    </message>
    <message>
        <source>Rename it; references are updated</source>
        <translation>Cambiar su nombre; las referencias se actualizan</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Desactivar</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Keep it in the file, but not in the simulation</source>
        <translation>Conservarlo en el archivo, pero no en la simulación</translation>
    </message>
    <message>
        <source>Include it in the simulation again</source>
        <translation>Incluirlo de nuevo en la simulación</translation>
    </message>
    <message>
        <source>Select all of this kind</source>
        <translation>Seleccionar todos los de este tipo</translation>
    </message>
    <message>
        <source>Select everything of this kind to change it together</source>
        <translation>Seleccionar todo lo de este tipo para cambiarlo a la vez</translation>
    </message>
    <message>
        <source>Behaviour</source>
        <translation>Comportamiento</translation>
    </message>
    <message>
        <source>Assign goals…</source>
        <translation>Asignar objetivos…</translation>
    </message>
    <message>
        <source>Choose the goals that people visit, and their order</source>
        <translation>Elegir los objetivos que visitan las personas, y su orden</translation>
    </message>
    <message>
        <source>Walk as a group</source>
        <translation>Caminar en grupo</translation>
    </message>
    <message>
        <source>Make these people walk together as a group</source>
        <translation>Hacer que estas personas caminen juntas como grupo</translation>
    </message>
    <message>
        <source>A group needs two or more people: select more</source>
        <translation>Un grupo necesita dos o más personas: seleccione más</translation>
    </message>
    <message>
        <source>Walk alone</source>
        <translation>Caminar por separado</translation>
    </message>
    <message>
        <source>Leave the group</source>
        <translation>Salir del grupo</translation>
    </message>
    <message>
        <source>This person is in no group</source>
        <translation>Esta persona no está en ningún grupo</translation>
    </message>
    <message>
        <source>None of these people is in a group</source>
        <translation>Ninguna de estas personas está en un grupo</translation>
    </message>
    <message>
        <source>Filter people, goals, areas</source>
        <translation>Filtrar personas, objetivos, áreas</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Nothing on the map yet.
Press P and click to place a person.</source>
        <translation>Aún no hay nada en el mapa.
Pulse P y haga clic para colocar una persona.</translation>
    </message>
</context>
<context>
    <name>editor::ScrubActions</name>
    <message>
        <source>&amp;Previous contact</source>
        <translation>Contacto &amp;anterior</translation>
    </message>
    <message>
        <source>Show the previous contact</source>
        <translation>Mostrar el contacto anterior</translation>
    </message>
    <message>
        <source>Ne&amp;xt contact</source>
        <translation>Contacto &amp;siguiente</translation>
    </message>
    <message>
        <source>Show the next contact</source>
        <translation>Mostrar el contacto siguiente</translation>
    </message>
    <message>
        <source>Loop a section</source>
        <translation>Repetir una sección</translation>
    </message>
    <message>
        <source>Repeat from A to B; drag the marks on the timeline, or Shift+drag a new section</source>
        <translation>Repetir de A a B; arrastre las marcas de la línea de tiempo, o Mayús+arrastrar para una sección nueva</translation>
    </message>
    <message>
        <source>&amp;Onion skin</source>
        <translation>Pa&amp;pel cebolla</translation>
    </message>
    <message>
        <source>Positions of all people 1, 2 and 3 s before and after</source>
        <translation>Posiciones de todas las personas 1, 2 y 3 s antes y después</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Set the time span of trails in a run</source>
        <translation>Fijar la duración de las estelas en una ejecución</translation>
    </message>
    <message>
        <source>Start a run first: Space</source>
        <translation>Inicie antes una ejecución: Espacio</translation>
    </message>
    <message>
        <source>No contact before the displayed step</source>
        <translation>Ningún contacto antes del paso mostrado</translation>
    </message>
    <message>
        <source>No contact after the displayed step</source>
        <translation>Ningún contacto después del paso mostrado</translation>
    </message>
</context>
<context>
    <name>editor::SearchField</name>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
</context>
<context>
    <name>editor::SelectTool</name>
    <message>
        <source>The robot follows until you release the button</source>
        <translation>El robot le sigue hasta que suelte el botón</translation>
    </message>
    <message>
        <source>Release to branch with the person here</source>
        <translation>Suelte para crear una rama con la persona aquí</translation>
    </message>
    <message>
        <source>Drag an arrow: a longer arrow pushes harder · Esc cancels</source>
        <translation>Arrastre una flecha: una flecha más larga empuja más fuerte · Esc cancela</translation>
    </message>
    <message>
        <source>Click a person for details · Drag a person to branch with another position · Space resumes</source>
        <translation>Clic en una persona para ver detalles · Arrastre una persona para crear una rama con otra posición · Espacio continúa</translation>
    </message>
    <message>
        <source>Click a person for details · Shift+drag to push · Drag a robot to lead it · Space pauses</source>
        <translation>Clic en una persona para ver detalles · Mayús+arrastrar para empujar · Arrastre un robot para guiarlo · Espacio pausa</translation>
    </message>
    <message>
        <source>Click a person for details · Space pauses</source>
        <translation>Clic en una persona para ver detalles · Espacio pausa</translation>
    </message>
    <message>
        <source>Click to select · Drag over empty space to select several</source>
        <translation>Haga clic para seleccionar · Arrastre sobre un espacio vacío para seleccionar varios</translation>
    </message>
    <message>
        <source>Drag to move</source>
        <translation>Arrastre para mover</translation>
    </message>
    <message>
        <source>Drag the round handle to turn</source>
        <translation>Arrastre el tirador redondo para girar</translation>
    </message>
    <message>
        <source>Drag a corner to resize</source>
        <translation>Arrastre una esquina para cambiar el tamaño</translation>
    </message>
    <message>
        <source>Double-click an edge to add a corner</source>
        <translation>Doble clic en un lado para añadir un vértice</translation>
    </message>
    <message>
        <source>Ctrl+D duplicates</source>
        <translation>Ctrl+D duplica</translation>
    </message>
    <message>
        <source>Del removes</source>
        <translation>Supr quita</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Quitar vértice</translation>
    </message>
    <message>
        <source>Add corner</source>
        <translation>Añadir vértice</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>radio %1 m</translation>
    </message>
</context>
<context>
    <name>editor::SettingsPage</name>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>No (default)</source>
        <translation>No (predet.)</translation>
    </message>
    <message>
        <source>With people</source>
        <translation>Con personas</translation>
    </message>
    <message>
        <source>With anything</source>
        <translation>Con cualquier cosa</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>pasos</translation>
    </message>
    <message>
        <source>step</source>
        <translation>paso</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personas</translation>
    </message>
    <message>
        <source>sfm (default)</source>
        <translation>sfm (predet.)</translation>
    </message>
    <message>
        <source>Around walls</source>
        <translation>Rodeando paredes</translation>
    </message>
    <message>
        <source>Straight, as in HuNavSim</source>
        <translation>Recto, como en HuNavSim</translation>
    </message>
    <message>
        <source>Nearest wall points</source>
        <translation>Pared más cercana</translation>
    </message>
    <message>
        <source>Rays, like a lidar</source>
        <translation>Rayos, como un lidar</translation>
    </message>
    <message>
        <source>Start over when done</source>
        <translation>Volver a empezar al terminar</translation>
    </message>
    <message>
        <source>no wrapping</source>
        <translation>sin envolver</translation>
    </message>
    <message>
        <source>Two x values in metres, ascending, separated by a comma</source>
        <translation>Dos valores x en metros, ascendentes, separados por una coma</translation>
    </message>
    <message>
        <source>Variation between seeds</source>
        <translation>Variación entre semillas</translation>
    </message>
    <message>
        <source>None (default)</source>
        <translation>Ninguna (predet.)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Strong</source>
        <translation>Fuerte</translation>
    </message>
    <message>
        <source>Varied quantities</source>
        <translation>Magnitudes variadas</translation>
    </message>
    <message>
        <source>not varied</source>
        <translation>no se varía</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>uniform</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <source>as above</source>
        <translation>como arriba</translation>
    </message>
    <message>
        <source>Scenario card</source>
        <translation>Ficha</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>Fácil</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Difícil</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>no se indica</translation>
    </message>
    <message>
        <source>Model parameters</source>
        <translation>Parámetros del modelo</translation>
    </message>
    <message>
        <source>Parameters that are unknown to the model or not numbers</source>
        <translation>Parámetros que el modelo no conoce o que no son números</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>start</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>end</source>
        <translation>fin</translation>
    </message>
    <message>
        <source>all metrics</source>
        <translation>todas las métricas</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>valores predeterminados</translation>
    </message>
    <message>
        <source>Simulator and map</source>
        <translation>Simulador y mapa</translation>
    </message>
    <message>
        <source>not specified</source>
        <translation>sin especificar</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Worlds</source>
        <translation>Mundos</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automático</translation>
    </message>
    <message>
        <source>humble (default)</source>
        <translation>humble (predet.)</translation>
    </message>
    <message>
        <source>Publish people</source>
        <translation>Publicar personas</translation>
    </message>
</context>
<context>
    <name>editor::SideView</name>
    <message>
        <source>ended at %1 s</source>
        <translation>terminó en %1 s</translation>
    </message>
</context>
<context>
    <name>editor::SimulationRunner</name>
    <message>
        <source>Branch %1</source>
        <translation>Rama %1</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>Ejecución grabada</translation>
    </message>
</context>
<context>
    <name>editor::TextField</name>
    <message>
        <source>Not used: %1</source>
        <translation>No se usa: %1</translation>
    </message>
</context>
<context>
    <name>editor::TextViewer</name>
    <message>
        <source>Text of the file</source>
        <translation>Texto del archivo</translation>
    </message>
    <message>
        <source>Open with…</source>
        <translation>Abrir con…</translation>
    </message>
    <message>
        <source>Open the file with the default application</source>
        <translation>Abrir el archivo con la aplicación predeterminada</translation>
    </message>
    <message>
        <source>%1 is too long to display</source>
        <translation>%1 es demasiado largo para mostrarlo</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>No application is available to open %1</source>
        <translation>No hay ninguna aplicación para abrir %1</translation>
    </message>
</context>
<context>
    <name>editor::TimelineBar</name>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>No longer stored: the disk is full</source>
        <translation>Ya no se conserva: el disco está lleno</translation>
    </message>
</context>
<context>
    <name>editor::ToolManager</name>
    <message>
        <source>Not during a run: Ctrl+R returns to editing</source>
        <translation>No durante una ejecución: Ctrl+R vuelve a la edición</translation>
    </message>
</context>
<context>
    <name>editor::ToolOptionsBar</name>
    <message>
        <source>Tool options</source>
        <translation>Opciones de la herramienta</translation>
    </message>
</context>
<context>
    <name>editor::TreeCanvas</name>
    <message>
        <source>Behaviour tree as a graph</source>
        <translation>Árbol de comportamiento como grafo</translation>
    </message>
    <message>
        <source>Unknown node type; it is kept unchanged.</source>
        <translation>Tipo de nodo desconocido; se conserva sin cambios.</translation>
    </message>
    <message>
        <source>In an included file: read-only here</source>
        <translation>En un archivo incluido: aquí es de solo lectura</translation>
    </message>
</context>
<context>
    <name>editor::TreeEditor</name>
    <message>
        <source>Name of the node</source>
        <translation>Nombre del nodo</translation>
    </message>
    <message>
        <source>Tree of</source>
        <translation>Árbol de</translation>
    </message>
    <message>
        <source>Person whose tree is shown; you can also select a person on the map</source>
        <translation>Persona cuyo árbol se muestra; también puede seleccionar una persona en el mapa</translation>
    </message>
    <message>
        <source>Apply edits to all people with the same tree</source>
        <translation>Aplicar los cambios a todas las personas con el mismo árbol</translation>
    </message>
    <message>
        <source>Assign to…</source>
        <translation>Asignar a…</translation>
    </message>
    <message>
        <source>Assign the same tree to other people</source>
        <translation>Asignar el mismo árbol a otras personas</translation>
    </message>
    <message>
        <source>New tree</source>
        <translation>Árbol nuevo</translation>
    </message>
    <message>
        <source>Start a new tree with an empty Sequence as its root</source>
        <translation>Empezar un árbol nuevo con un Sequence vacío como raíz</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>De izquierda a derecha</translation>
    </message>
    <message>
        <source>Place the root on the left or at the top</source>
        <translation>Poner la raíz a la izquierda o arriba</translation>
    </message>
    <message>
        <source>Use node positions of the file or automatic layout</source>
        <translation>Usar las posiciones del archivo o una disposición automática</translation>
    </message>
    <message>
        <source>Expand all</source>
        <translation>Desplegar todo</translation>
    </message>
    <message>
        <source>Show all nodes or only the branches</source>
        <translation>Mostrar todos los nodos o solo las ramas</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Encuadrar</translation>
    </message>
    <message>
        <source>Fit the whole tree in the window (F)</source>
        <translation>Encuadrar todo el árbol en la ventana (F)</translation>
    </message>
    <message>
        <source>Layout: automatic</source>
        <translation>Disposición: automática</translation>
    </message>
    <message>
        <source>Layout: from file</source>
        <translation>Disposición: del archivo</translation>
    </message>
    <message>
        <source>Top down</source>
        <translation>De arriba abajo</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>En el tiempo</translation>
    </message>
    <message>
        <source>What each node returned in the run</source>
        <translation>Lo que devolvió cada nodo en la ejecución</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En ejecución</translation>
    </message>
    <message>
        <source>The nodes that are running at the displayed step</source>
        <translation>Los nodos que se ejecutan en el paso mostrado</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>Edit the XML file of the tree</source>
        <translation>Editar el archivo XML del árbol</translation>
    </message>
    <message>
        <source>Blackboard</source>
        <translation>Pizarra</translation>
    </message>
    <message>
        <source>Blackboard of the person&apos;s tree at the displayed step</source>
        <translation>Pizarra del árbol de la persona en el paso mostrado</translation>
    </message>
    <message>
        <source>Collapse</source>
        <translation>Plegar</translation>
    </message>
    <message>
        <source>Nothing was picked</source>
        <translation>No se eligió nada</translation>
    </message>
    <message>
        <source>Edits change %1 people</source>
        <translation>Los cambios afectan a %1 personas</translation>
    </message>
    <message>
        <source>Edits change only this person</source>
        <translation>Los cambios solo afectan a esta persona</translation>
    </message>
    <message>
        <source>Edit the XML of %1</source>
        <translation>Editar el XML de %1</translation>
    </message>
    <message>
        <source>No people yet: press P and click on the map.</source>
        <translation>Aún no hay personas: pulse P y haga clic en el mapa.</translation>
    </message>
    <message>
        <source>The node is in an included file, which cannot be edited here</source>
        <translation>El nodo está en un archivo incluido, que no se puede editar aquí</translation>
    </message>
    <message>
        <source>Select a node first</source>
        <translation>Seleccione antes un nodo</translation>
    </message>
    <message>
        <source>%1 nodes</source>
        <translation>%1 nodos</translation>
    </message>
    <message>
        <source>Wrap %2 in %1</source>
        <translation>Envolver %2 en %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>%1 is copied as XML</source>
        <translation>%1 se ha copiado como XML</translation>
    </message>
    <message>
        <source>%1 are copied as XML</source>
        <translation>%1 se han copiado como XML</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>Cortar %1</translation>
    </message>
    <message>
        <source>The clipboard contains no node: copy a node or its XML first</source>
        <translation>El portapapeles no contiene ningún nodo: copie antes un nodo o su XML</translation>
    </message>
    <message>
        <source>Wrap %1 in %2</source>
        <translation>Envolver %1 en %2</translation>
    </message>
    <message>
        <source>Replace %1 with %2</source>
        <translation>Reemplazar %1 por %2</translation>
    </message>
    <message>
        <source>Remove %1, keep children</source>
        <translation>Quitar %1, conservar hijos</translation>
    </message>
    <message>
        <source>Extract %1 as subtree</source>
        <translation>Extraer %1 como subárbol</translation>
    </message>
    <message>
        <source>Inline subtree %1</source>
        <translation>Integrar el subárbol %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Cambiar el nombre de %1</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>Editar %1</translation>
    </message>
    <message>
        <source>Type the name of a node: Enter adds it below the selected one</source>
        <translation>Escriba el nombre de un nodo: Intro lo añade bajo el seleccionado</translation>
    </message>
    <message>
        <source>Click the goal on the map, or in the scenario list</source>
        <translation>Haga clic en el objetivo en el mapa, o en la lista del escenario</translation>
    </message>
    <message>
        <source>Click the person on the map, or in the scenario list</source>
        <translation>Haga clic en la persona en el mapa, o en la lista del escenario</translation>
    </message>
    <message>
        <source>Change %2 of %1</source>
        <translation>Cambiar %2 de %1</translation>
    </message>
    <message>
        <source>Regenerate the tree of %1</source>
        <translation>Regenerar el árbol de %1</translation>
    </message>
    <message>
        <source>Assign the tree of %1 to %2</source>
        <translation>Asignar el árbol de %1 a %2</translation>
    </message>
    <message>
        <source>No other person</source>
        <translation>Ninguna otra persona</translation>
    </message>
    <message>
        <source>Pick %1 on the map</source>
        <translation>Elegir %1 en el mapa</translation>
    </message>
    <message>
        <source>Wrap in</source>
        <translation>Envolver en</translation>
    </message>
    <message>
        <source>Duplicate	Ctrl+D</source>
        <translation>Duplicar	Ctrl+D</translation>
    </message>
    <message>
        <source>Cut	Ctrl+X</source>
        <translation>Cortar	Ctrl+X</translation>
    </message>
    <message>
        <source>Copy as XML	Ctrl+C</source>
        <translation>Copiar como XML	Ctrl+C</translation>
    </message>
    <message>
        <source>Delete	Del</source>
        <translation>Borrar	Supr</translation>
    </message>
    <message>
        <source>Paste	Ctrl+V</source>
        <translation>Pegar	Ctrl+V</translation>
    </message>
    <message>
        <source>Fit	F</source>
        <translation>Encuadrar	F</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Guardar imagen…</translation>
    </message>
    <message>
        <source>Replace with</source>
        <translation>Reemplazar por</translation>
    </message>
    <message>
        <source>Remove, keep children</source>
        <translation>Quitar, conservar hijos</translation>
    </message>
    <message>
        <source>Inline subtree</source>
        <translation>Integrar subárbol</translation>
    </message>
    <message>
        <source>Extract as subtree</source>
        <translation>Extraer como subárbol</translation>
    </message>
    <message>
        <source>Edit ports	Enter</source>
        <translation>Editar puertos	Intro</translation>
    </message>
    <message>
        <source>Add a node…	Ins</source>
        <translation>Añadir un nodo…	Ins</translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation>Cambiar nombre	F2</translation>
    </message>
    <message>
        <source>Earlier	Alt+Left</source>
        <translation>Antes	Alt+Izquierda</translation>
    </message>
    <message>
        <source>Later	Alt+Right</source>
        <translation>Después	Alt+Derecha</translation>
    </message>
    <message>
        <source>Expand	+</source>
        <translation>Desplegar	+</translation>
    </message>
    <message>
        <source>Collapse	-</source>
        <translation>Plegar	-</translation>
    </message>
</context>
<context>
    <name>editor::TreeHistory</name>
    <message>
        <source>What the nodes returned over time</source>
        <translation>Lo que devolvieron los nodos en el tiempo</translation>
    </message>
    <message>
        <source>The run used another tree: run it again to see its nodes here.</source>
        <translation>La ejecución usó otro árbol: ejecútela de nuevo para ver aquí sus nodos.</translation>
    </message>
    <message>
        <source>Run the scenario to see what each node returns over time.</source>
        <translation>Ejecute el escenario para ver lo que devuelve cada nodo en el tiempo.</translation>
    </message>
</context>
<context>
    <name>editor::TreeOutline</name>
    <message>
        <source>Behaviour tree</source>
        <translation>Árbol de comportamiento</translation>
    </message>
</context>
<context>
    <name>editor::TreeText</name>
    <message>
        <source>XML of the tree</source>
        <translation>XML del árbol</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Discard the edit and show the current tree</source>
        <translation>Descartar la edición y mostrar el árbol actual</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
</context>
<context>
    <name>editor::ValueForm</name>
    <message>
        <source>Read %1 from a blackboard entry</source>
        <translation>Leer %1 de una entrada de la pizarra</translation>
    </message>
    <message>
        <source>Enter %1 as a number</source>
        <translation>Introducir %1 como número</translation>
    </message>
    <message>
        <source>Use entry</source>
        <translation>Usar entrada</translation>
    </message>
    <message>
        <source>Use number</source>
        <translation>Usar número</translation>
    </message>
</context>
<context>
    <name>editor::WallTool</name>
    <message>
        <source>Drag a wall, or click its corners one by one · Shift: 15° steps</source>
        <translation>Arrastre una pared, o haga clic en sus vértices uno a uno · Mayús: pasos de 15°</translation>
    </message>
    <message>
        <source>At least two corners are required</source>
        <translation>Se necesitan al menos dos vértices</translation>
    </message>
    <message>
        <source>Too short</source>
        <translation>Demasiado corta</translation>
    </message>
</context>
</TS>
