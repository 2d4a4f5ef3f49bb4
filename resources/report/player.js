(function () {
  "use strict";
  var box = document.querySelector(".player");
  var data = document.getElementById("replays");
  if (!box || !data) { return; }
  var runs = JSON.parse(data.textContent);
  var canvas = box.querySelector("canvas"), pen = canvas.getContext("2d");
  var slider = box.querySelector("input[type=range]"), button = box.querySelector(".toggle");
  var clock = box.querySelector("output"), title = box.querySelector("header b");
  var about = box.querySelector("header span"), choice = box.querySelector("header select");
  var speed = box.querySelector(".controls select"), list = box.querySelector(".events");
  var run = null, now = 0, playing = false, before = 0, colors = {};

  // Places are differences from sample to sample, in cm and 1/100 rad.
  function unpack(source) {
    source.bodies.forEach(function (body) {
      body.stays.forEach(function (stay) {
        var sum = [0, 0, 0];
        stay.at = [];
        for (var k = 0; k < stay.d.length; k += 3) {
          sum = [sum[0] + stay.d[k], sum[1] + stay.d[k + 1], sum[2] + stay.d[k + 2]];
          stay.at.push(sum);
        }
        delete stay.d;
      });
    });
    source.ready = true;
  }
  function turn(angle) { return Math.atan2(Math.sin(angle), Math.cos(angle)); }
  function poseOf(body, sample) {
    var whole = Math.floor(sample), share = sample - whole;
    for (var k = 0; k < body.stays.length; k += 1) {
      var stay = body.stays[k], at = whole - stay.from;
      if (at >= 0 && at < stay.at.length) {
        var a = stay.at[at], b = stay.at[Math.min(at + 1, stay.at.length - 1)];
        return [(a[0] + share * (b[0] - a[0])) / 100, (a[1] + share * (b[1] - a[1])) / 100,
          a[2] / 100 + share * turn((b[2] - a[2]) / 100)];
      }
    }
    return null;
  }
  function readColors() {
    var style = getComputedStyle(document.documentElement);
    ["panel", "ground", "rule", "wall", "solid", "edge", "ink", "dim", "accent", "robot", "front",
      "hot", "p1", "p2", "p3", "p4", "p5", "p6", "p7"].forEach(function (name) {
      colors[name] = style.getPropertyValue("--" + name).trim();
    });
  }
  function outlines(all) {
    pen.beginPath();
    all.forEach(function (points) {
      for (var k = 0; k < points.length; k += 2) {
        pen[k ? "lineTo" : "moveTo"](points[k] / 100, points[k + 1] / 100);
      }
      pen.closePath();
    });
  }
  function person(body, pose, pixel) {
    var r = Math.max(body.r / 100, 5 * pixel);
    pen.save();
    pen.translate(pose[0], pose[1]);
    pen.rotate(pose[2]);
    pen.fillStyle = colors["p" + (body.look >= 1 && body.look <= 7 ? body.look : 1)];
    pen.strokeStyle = colors.ink;
    pen.lineWidth = pixel;
    pen.beginPath();
    pen.ellipse(0, 0, 0.6 * r, r, 0, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
    pen.beginPath();
    pen.moveTo(0.45 * r, 0.22 * r);
    pen.lineTo(0.88 * r, 0);
    pen.lineTo(0.45 * r, -0.22 * r);
    pen.fillStyle = colors.ink;
    pen.fill();
    pen.beginPath();
    pen.arc(0, 0, 0.42 * r, 0, 2 * Math.PI);
    pen.fillStyle = colors.ground;
    pen.fill();
    pen.stroke();
    pen.restore();
  }
  function machine(body, pose, pixel) {
    var r = body.r / 100;
    pen.save();
    pen.translate(pose[0], pose[1]);
    pen.rotate(pose[2]);
    pen.fillStyle = colors.robot;
    if (body.shape) {
      outlines([body.shape]);
    } else {
      pen.beginPath();
      pen.arc(0, 0, r, 0, 2 * Math.PI);
    }
    pen.fill();
    pen.beginPath();
    pen.arc(0, 0, 0.72 * r, -0.6, 0.6);
    pen.strokeStyle = colors.front;
    pen.lineWidth = Math.max(0.2 * r, 2 * pixel);
    pen.stroke();
    pen.restore();
  }
  function trail(body, pixel, sample) {
    pen.beginPath();
    var isOpen = false;
    body.stays.forEach(function (stay) {
      isOpen = false;
      for (var k = 0; k < stay.at.length && stay.from + k <= sample; k += 1) {
        pen[isOpen ? "lineTo" : "moveTo"](stay.at[k][0] / 100, stay.at[k][1] / 100);
        isOpen = true;
      }
    });
    pen.strokeStyle = colors.accent;
    pen.lineWidth = 2 * pixel;
    pen.stroke();
  }
  function contactsNear(time) {
    return run.events.filter(function (event) {
      return event[1] === "contact" && event[0] <= time && event[0] > time - 1.0;
    });
  }
  function draw() {
    var b = run.box, width = (b[2] - b[0]) / 100, height = (b[3] - b[1]) / 100;
    var space = canvas.clientWidth || 720;
    var tall = Math.max(160, Math.min(space * height / width, 520));
    var dense = window.devicePixelRatio || 1;
    canvas.style.height = tall + "px";
    if (canvas.width !== Math.round(space * dense) || canvas.height !== Math.round(tall * dense)) {
      canvas.width = Math.round(space * dense);
      canvas.height = Math.round(tall * dense);
    }
    var scale = Math.min(space / width, tall / height);
    pen.setTransform(dense, 0, 0, dense, 0, 0);
    pen.fillStyle = colors.panel;
    pen.fillRect(0, 0, space, tall);
    pen.translate(0.5 * (space - width * scale), 0.5 * (tall + height * scale));
    pen.scale(scale, -scale);
    pen.translate(-b[0] / 100, -b[1] / 100);
    var pixel = 1 / scale, sample = now / run.dt;
    pen.fillStyle = colors.ground;
    pen.fillRect(b[0] / 100, b[1] / 100, width, height);
    outlines(run.shapes);
    pen.fillStyle = colors.solid;
    pen.fill("evenodd");
    pen.strokeStyle = colors.edge;
    pen.lineWidth = pixel;
    pen.stroke();
    outlines(run.walls);
    pen.fillStyle = colors.wall;
    pen.fill("evenodd");
    run.goals.forEach(function (goal) {
      pen.beginPath();
      pen.arc(goal[0] / 100, goal[1] / 100, (goal[2] ? 6 : 2.5) * pixel, 0, 2 * Math.PI);
      pen.strokeStyle = goal[2] ? colors.accent : colors.dim;
      pen.lineWidth = (goal[2] ? 2 : 1) * pixel;
      pen.stroke();
    });
    var touched = {};
    contactsNear(now).forEach(function (event) { touched[event[2]] = touched[event[3]] = true; });
    run.bodies.forEach(function (body) { if (body.id < 0) { trail(body, pixel, sample); } });
    run.bodies.forEach(function (body) {
      var pose = poseOf(body, sample);
      if (!pose) { return; }
      if (touched[body.id]) {
        pen.beginPath();
        pen.arc(pose[0], pose[1], body.r / 100 + 6 * pixel, 0, 2 * Math.PI);
        pen.strokeStyle = colors.hot;
        pen.lineWidth = 3 * pixel;
        pen.stroke();
      }
      (body.id < 0 ? machine : person)(body, pose, pixel);
    });
    clock.textContent = now.toFixed(1) + " / " + lastTime().toFixed(1) + " s";
    slider.value = String(now);
    Array.prototype.forEach.call(list.children, function (item, k) {
      item.classList.toggle("now", run.events[k][0] <= now && run.events[k][0] > now - 1.0);
    });
  }
  function lastTime() { return Math.max(0, (run.samples - 1) * run.dt); }
  function nameOf(id) {
    var found = run.bodies.filter(function (body) { return body.id === id; })[0];
    return found ? found.name : String(id);
  }
  function eventText(event) {
    var text = event[0].toFixed(1) + " s  " + event[1];
    if (event[2] !== null) { text += " " + nameOf(event[2]); }
    if (event[3] !== null) { text += ", " + nameOf(event[3]); }
    return event[4] ? text + " (" + event[4] + ")" : text;
  }
  function told(source) {
    return source.about + (source.outcome ? ": " + source.outcome : "");
  }
  function addRuns(label, isFailed) {
    var group = document.createElement("optgroup");
    group.label = label;
    runs.forEach(function (source, place) {
      if (Boolean(source.outcome) !== isFailed) { return; }
      var option = document.createElement("option");
      option.value = String(place);
      option.textContent = source.title + ", " + told(source);
      group.appendChild(option);
    });
    if (group.children.length) { choice.appendChild(group); }
  }
  function show(place) {
    run = runs[place];
    if (!run.ready) { unpack(run); }
    choice.value = String(place);
    now = 0;
    slider.max = String(lastTime());
    slider.step = "any";
    title.textContent = run.title;
    about.textContent = told(run);
    list.textContent = "";
    run.events.forEach(function (event) {
      var item = document.createElement("li");
      item.textContent = eventText(event);
      item.addEventListener("click", function () { now = Math.min(event[0], lastTime()); draw(); });
      list.appendChild(item);
    });
    draw();
  }
  function play(on) {
    playing = on;
    button.textContent = on ? "Pause" : "Play";
    if (on) {
      if (now >= lastTime()) { now = 0; }
      before = 0;
      requestAnimationFrame(tick);
    }
  }
  function tick(stamp) {
    if (!playing) { return; }
    if (before) { now += (stamp - before) / 1000 * parseFloat(speed.value); }
    before = stamp;
    if (now >= lastTime()) { now = lastTime(); play(false); }
    draw();
    if (playing) { requestAnimationFrame(tick); }
  }
  button.addEventListener("click", function () { play(!playing); });
  choice.addEventListener("change", function () {
    play(false);
    show(parseInt(choice.value, 10));
  });
  slider.addEventListener("input", function () { now = parseFloat(slider.value); draw(); });
  window.addEventListener("resize", function () { draw(); });
  document.addEventListener("themechange", function () { readColors(); if (run) { draw(); } });
  document.querySelectorAll("button.play").forEach(function (each) {
    each.addEventListener("click", function () {
      show(parseInt(each.getAttribute("data-replay"), 10));
      box.scrollIntoView({behavior: "smooth", block: "center"});
      play(true);
    });
  });
  readColors();
  addRuns("Without success", true);
  addRuns("With success", false);
  box.classList.toggle("single", runs.length < 2);
  show(parseInt(choice.value, 10));
}());
