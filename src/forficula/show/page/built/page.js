/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources b27248a912d550d290f98100aecc047484501d5a74b510ae6471dce765a37d92 */
(()=>{function b(n,e={},...t){let i=document.createElement(n);for(let[s,r]of Object.entries(e))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...t),i}function fs(n,e,t){let i=b("button",{type:"button",title:e,"aria-label":e},n);return i.addEventListener("click",t),i}var Tl=n=>Yh(n,24);function Yh(n,e){let t="http://www.w3.org/2000/svg",i=document.createElementNS(t,"svg");i.setAttribute("viewBox",`0 0 ${e} ${e}`),e!==24&&i.setAttribute("preserveAspectRatio","none"),i.setAttribute("aria-hidden","true");let s=document.createElementNS(t,"path");return s.setAttribute("d",n),i.append(s),i}function vr({colour:n,dash:e,area:t}){let i="http://www.w3.org/2000/svg",s=document.createElementNS(i,"svg");s.setAttribute("viewBox","0 0 24 8"),s.setAttribute("aria-hidden","true"),s.classList.add("sample");let r=document.createElementNS(i,"path");return r.setAttribute("d",t?"M0 0H24V8H0Z":"M0 4H24"),t&&(r.style.fill=n),r.setAttribute("stroke",t?"none":n),r.setAttribute("stroke-dasharray",e.join(" ")),s.append(r),s}var vm=3,Ob=1e4;function ps(n,e){let t=URL.createObjectURL(n);b("a",{href:t,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(t),Ob)}function qn(n){return`${document.title.split(/: | with /)[0]} ${n}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g,"-").replace(/^-+|-+$/g,"")||"plot"}function Cl(n,e,t){let i=b("button",{type:"button","aria-label":`download ${n} of ${e}`,title:`download as ${n}`},n);return i.addEventListener("click",t),i}function ji(n,e,t){let i=()=>ps(new Blob([t().svg],{type:"image/svg+xml"}),`${e()}.svg`);return b("span",{className:"saves"},Cl("PNG",n,async()=>ps(await Ub(t()),`${e()}.png`)),Cl("SVG",n,i))}async function Ub({svg:n,width:e,height:t}){let i=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"}));try{let s=b("img",{width:e,height:t});await new Promise((o,a)=>{s.onload=o,s.onerror=a,s.src=i});let r=b("canvas",{width:vm*e,height:vm*t});return r.getContext("2d").drawImage(s,0,0,r.width,r.height),await new Promise(o=>r.toBlob(o,"image/png"))}finally{URL.revokeObjectURL(i)}}function bm(){for(let n of document.querySelectorAll("figure.drawn")){let[e,t]=[n.querySelector("img"),n.querySelector("source")],i=n.closest("section")?.id??"figure",s=[["PNG",e.src],["SVG",t.srcset]].map(([r,o])=>Cl(r,`the figure ${i}`,()=>ps(Fb(o),`${qn(i)}.${r.toLowerCase()}`)));n.append(b("div",{className:"saves save-foot"},...s))}}function Fb(n){let[e,t]=n.split(","),i=atob(t);return new Blob([Uint8Array.from(i,s=>s.charCodeAt(0))],{type:/:(.*?);/.exec(e)[1]})}function Nt(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function kn(n,e){let t=n.toFixed(e);return(Number(t)===0?0 .toFixed(e):t).replace("-","−")}function Zh(n,e){return n.replace(/\{(\w+)\}/g,(t,i)=>e[i])}function Mt(n){let e=Number(n.toPrecision(4)),t=Math.abs(e);return(t!==0&&(t>=1e5||t<.001)?n.toExponential(2):String(e)).replaceAll("-","−")}var jh={};function Sm(n){jh=n}function wm(n,e){let t=jh[n],i=([,o,a])=>e===0?o===1:e>=a,[s,r]=t.find(i)??(e===0?t[0]:t.at(-1));return{unit:s,factor:r}}function Mm(n){return Object.values(jh).flat().find(([e])=>e===n)[1]}function Gs(n,e){let{unit:t,factor:i}=wm(e,Math.abs(n));return`${Mt(i*n)} ${t}`}function ua(n){return n.unit?{unit:n.unit,factor:1}:wm("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function Ki(n,e){let{unit:t,factor:i}=ua(e),s=Math.ceil(2.7-Math.log10(i*(e.end-e.start)));return`${kn(i*n,Math.min(6,Math.max(0,s)))} ${t}`}var er={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},tr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ig=0,Ed=1,sg=2;var Ga=1,rg=2,Co=3,nr=0,jn=1,zn=2,Cr=0,Ro=1,Td=2,Cd=3,Rd=4,og=5;var Rr=100,ag=101,lg=102,cg=103,ug=104,hg=200,dg=201,fg=202,pg=203,Pd=204,Id=205,mg=206,gg=207,xg=208,_g=209,yg=210,vg=211,bg=212,Sg=213,wg=214,ec=0,tc=1,nc=2,xo=3,ic=4,sc=5,rc=6,oc=7,Lc=0,Mg=1,Ag=2,is=0,Ld=1,Nd=2,Dd=3,kd=4,Od=5,Ud=6,Fd=7;var Bd=300,Pr=301,Po=302,Nc=303,Dc=304,ac=1e3,es=1001,lc=1002,Nn=1003,Eg=1004;var Ha=1005;var Zn=1006,kc=1007;var Cs=1008;var ti=1009,zd=1010,Vd=1011,Io=1012,Oc=1013,ki=1014,Mi=1015,Oi=1016,Uc=1017,Fc=1018,Ir=1020,Gd=35902,Hd=35899,Wd=1021,$d=1022,Ui=1023,bs=1026,Rs=1027,Bc=1028,zc=1029,ir=1030,Vc=1031;var Gc=1033,Wa=33776,$a=33777,Xa=33778,qa=33779,Hc=35840,Wc=35841,$c=35842,Xc=35843,qc=36196,Yc=37492,Zc=37496,jc=37488,Kc=37489,Ya=37490,Jc=37491,Qc=37808,eu=37809,tu=37810,nu=37811,iu=37812,su=37813,ru=37814,ou=37815,au=37816,lu=37817,cu=37818,uu=37819,hu=37820,du=37821,fu=36492,pu=36494,mu=36495,gu=36283,xu=36284,Za=36285,_u=36286;var ba=2300,cc=2301,Jl=2302,_d=2303,yd=2400,vd=2401,bd=2402;var Tg=3200;var yu=0,Cg=1,Ps="",ci="srgb",Sa="srgb-linear",wa="linear",Dt="srgb";var Ql=7680,Xd=7681;var qd=517;var Rg=519,Pg=512,Ig=513,Lg=514,Yd=515,Ng=516,Dg=517,Zd=518,jd=519,kg=35044,ja=35048;var Kd="300 es",Si=2e3,_o=2001;function Bb(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function zb(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ma(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Og(){let n=Ma("canvas");return n.style.display="block",n}var Am={},yo=null;function Jd(...n){let e="THREE."+n.shift();yo?yo("log",e,...n):console.log(e,...n)}function Ug(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=Ug(n);let e="THREE."+n.shift();if(yo)yo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=Ug(n);let e="THREE."+n.shift();if(yo)yo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function _a(...n){let e=n.join(" ");e in Am||(Am[e]=!0,Ke(...n))}function Fg(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Bg={[ec]:ec,[nc]:rc,[ic]:ic,[xo]:sc,[tc]:tc,[rc]:nc,[oc]:oc,[sc]:xo},Di=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Fn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Em=1234567,ya=Math.PI/180,vo=180/Math.PI;function Lo(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Fn[n&255]+Fn[n>>8&255]+Fn[n>>16&255]+Fn[n>>24&255]+"-"+Fn[e&255]+Fn[e>>8&255]+"-"+Fn[e>>16&15|64]+Fn[e>>24&255]+"-"+Fn[t&63|128]+Fn[t>>8&255]+"-"+Fn[t>>16&255]+Fn[t>>24&255]+Fn[i&255]+Fn[i>>8&255]+Fn[i>>16&255]+Fn[i>>24&255]).toLowerCase()}function xt(n,e,t){return Math.max(e,Math.min(t,n))}function Qd(n,e){return(n%e+e)%e}function Vb(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function Gb(n,e,t){return n!==e?(t-n)/(e-n):0}function va(n,e,t){return(1-t)*n+t*e}function Hb(n,e,t,i){return va(n,e,1-Math.exp(-t*i))}function Wb(n,e=1){return e-Math.abs(Qd(n,e*2)-e)}function $b(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function Xb(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function qb(n,e){return n+Math.floor(Math.random()*(e-n+1))}function Yb(n,e){return n+Math.random()*(e-n)}function Zb(n){return n*(.5-Math.random())}function jb(n){n!==void 0&&(Em=n);let e=Em+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function Kb(n){return n*ya}function Jb(n){return n*vo}function Qb(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function eS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function ef(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function tS(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),d=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function tf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function zg(n,e){if(e.constructor===Float32Array)return n;let t=tf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Vg(n,e){if(e.constructor===Float32Array)return n;let t=tf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var nf={DEG2RAD:ya,RAD2DEG:vo,generateUUID:Lo,clamp:xt,euclideanModulo:Qd,mapLinear:Vb,inverseLerp:Gb,lerp:va,damp:Hb,pingpong:Wb,smoothstep:$b,smootherstep:Xb,randInt:qb,randFloat:Yb,randFloatSpread:Zb,seededRandom:jb,degToRad:Kb,radToDeg:Jb,isPowerOfTwo:Qb,ceilPowerOfTwo:eS,floorPowerOfTwo:ef,setQuaternionFromProperEuler:tS,normalize:Vg,denormalize:zg},Je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},hi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(h!==x||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let _=Math.acos(m),w=Math.sin(_);g=Math.sin(g*_)/w,a=Math.sin(a*_)/w,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+x*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*f-c*d,e[t+1]=l*p+u*d+c*h-a*f,e[t+2]=c*p+u*f+a*d-l*h,e[t+3]=u*p-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},H=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Tm.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Tm.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Kh.copy(this).projectOnVector(e),this.sub(Kh)}reflect(e){return this.sub(Kh.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(xt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Kh=new H,Tm=new hi,rt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],x=s[0],m=s[3],g=s[6],_=s[1],w=s[4],S=s[7],A=s[2],M=s[5],y=s[8];return r[0]=o*x+a*_+l*A,r[3]=o*m+a*w+l*M,r[6]=o*g+a*S+l*y,r[1]=c*x+u*_+h*A,r[4]=c*m+u*w+h*M,r[7]=c*g+u*S+h*y,r[2]=d*x+f*_+p*A,r[5]=d*m+f*w+p*M,r[8]=d*g+f*S+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=t*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return e[0]=h*x,e[1]=(s*c-u*i)*x,e[2]=(a*i-s*o)*x,e[3]=d*x,e[4]=(u*t-s*l)*x,e[5]=(s*r-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*r)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return _a("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Jh.makeScale(e,t)),this}rotate(e){return _a("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Jh.makeRotation(-e)),this}translate(e,t){return _a("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Jh.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Jh=new rt,Cm=new rt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Rm=new rt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function nS(){let n={enabled:!0,workingColorSpace:Sa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Dt&&(s.r=vs(s.r),s.g=vs(s.g),s.b=vs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Dt&&(s.r=go(s.r),s.g=go(s.g),s.b=go(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ps?wa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Sa]:{primaries:e,whitePoint:i,transfer:wa,toXYZ:Cm,fromXYZ:Rm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ci},outputColorSpaceConfig:{drawingBufferColorSpace:ci}},[ci]:{primaries:e,whitePoint:i,transfer:Dt,toXYZ:Cm,fromXYZ:Rm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ci}}}),n}var St=nS();function vs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function go(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var to,uc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{to===void 0&&(to=Ma("canvas")),to.width=e.width,to.height=e.height;let s=to.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=to}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ma("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=vs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(vs(t[i]/255)*255):t[i]=vs(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},iS=0,bo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:iS++}),this.uuid=Lo(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Qh(s[o].image)):r.push(Qh(s[o]))}else r=Qh(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Qh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?uc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var sS=0,ed=new H,ei=class n extends Di{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=es,s=es,r=Zn,o=Cs,a=Ui,l=ti,c=n.DEFAULT_ANISOTROPY,u=Ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:sS++}),this.uuid=Lo(),this.name="",this.source=new bo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Je(0,0),this.repeat=new Je(1,1),this.center=new Je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new rt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ed).x}get height(){return this.source.getSize(ed).y}get depth(){return this.source.getSize(ed).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Bd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case ac:e.x=e.x-Math.floor(e.x);break;case es:e.x=e.x<0?0:1;break;case lc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case ac:e.y=e.y-Math.floor(e.y);break;case es:e.y=e.y<0?0:1;break;case lc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Bd;ei.DEFAULT_ANISOTROPY=1;var Gt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let w=(c+1)/2,S=(f+1)/2,A=(g+1)/2,M=(u+d)/4,y=(h+x)/4,v=(p+m)/4;return w>S&&w>A?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=M/i,r=y/i):S>A?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=M/s,r=v/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=v/r),this.set(i,s,r,t),this}let _=Math.sqrt((m-p)*(m-p)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(m-p)/_,this.y=(h-x)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(xt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},hc=class extends Di{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Gt(0,0,e,t),this.scissorTest=!1,this.viewport=new Gt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new bo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},di=class extends hc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Aa=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var dc=class extends ei{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Nn,this.minFilter=Nn,this.wrapR=es,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var dt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m)}set(e,t,i,s,r,o,a,l,c,u,h,d,f,p,x,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/no.setFromMatrixColumn(e,0).length(),r=1/no.setFromMatrixColumn(e,1).length(),o=1/no.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+p*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d+x*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,p=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,p=a*u,x=a*h;t[0]=l*u,t[4]=p*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=p*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+p,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,p=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-p,t[2]=p*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(rS,e,oS)}lookAt(e,t,i){let s=this.elements;return ai.subVectors(e,t),ai.lengthSq()===0&&(ai.z=1),ai.normalize(),Hs.crossVectors(i,ai),Hs.lengthSq()===0&&(Math.abs(i.z)===1?ai.x+=1e-4:ai.z+=1e-4,ai.normalize(),Hs.crossVectors(i,ai)),Hs.normalize(),Rl.crossVectors(ai,Hs),s[0]=Hs.x,s[4]=Rl.x,s[8]=ai.x,s[1]=Hs.y,s[5]=Rl.y,s[9]=ai.y,s[2]=Hs.z,s[6]=Rl.z,s[10]=ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],x=i[6],m=i[10],g=i[14],_=i[3],w=i[7],S=i[11],A=i[15],M=s[0],y=s[4],v=s[8],T=s[12],P=s[1],C=s[5],N=s[9],F=s[13],D=s[2],V=s[6],$=s[10],B=s[14],ne=s[3],Y=s[7],K=s[11],ee=s[15];return r[0]=o*M+a*P+l*D+c*ne,r[4]=o*y+a*C+l*V+c*Y,r[8]=o*v+a*N+l*$+c*K,r[12]=o*T+a*F+l*B+c*ee,r[1]=u*M+h*P+d*D+f*ne,r[5]=u*y+h*C+d*V+f*Y,r[9]=u*v+h*N+d*$+f*K,r[13]=u*T+h*F+d*B+f*ee,r[2]=p*M+x*P+m*D+g*ne,r[6]=p*y+x*C+m*V+g*Y,r[10]=p*v+x*N+m*$+g*K,r[14]=p*T+x*F+m*B+g*ee,r[3]=_*M+w*P+S*D+A*ne,r[7]=_*y+w*C+S*V+A*Y,r[11]=_*v+w*N+S*$+A*K,r[15]=_*T+w*F+S*B+A*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],p=e[3],x=e[7],m=e[11],g=e[15],_=l*f-c*d,w=a*f-c*h,S=a*d-l*h,A=o*f-c*u,M=o*d-l*u,y=o*h-a*u;return t*(x*_-m*w+g*S)-i*(p*_-m*A+g*M)+s*(p*w-x*A+g*y)-r*(p*S-x*M+m*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],p=e[12],x=e[13],m=e[14],g=e[15],_=t*a-i*o,w=t*l-s*o,S=t*c-r*o,A=i*l-s*a,M=i*c-r*a,y=s*c-r*l,v=u*x-h*p,T=u*m-d*p,P=u*g-f*p,C=h*m-d*x,N=h*g-f*x,F=d*g-f*m,D=_*F-w*N+S*C+A*P-M*T+y*v;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return e[0]=(a*F-l*N+c*C)*V,e[1]=(s*N-i*F-r*C)*V,e[2]=(x*y-m*M+g*A)*V,e[3]=(d*M-h*y-f*A)*V,e[4]=(l*P-o*F-c*T)*V,e[5]=(t*F-s*P+r*T)*V,e[6]=(m*S-p*y-g*w)*V,e[7]=(u*y-d*S+f*w)*V,e[8]=(o*N-a*P+c*v)*V,e[9]=(i*P-t*N-r*v)*V,e[10]=(p*M-x*S+g*_)*V,e[11]=(h*S-u*M-f*_)*V,e[12]=(a*T-o*C-l*v)*V,e[13]=(t*C-i*T+s*v)*V,e[14]=(x*w-p*A-m*_)*V,e[15]=(u*A-h*w+d*_)*V,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,x=o*u,m=o*h,g=a*h,_=l*c,w=l*u,S=l*h,A=i.x,M=i.y,y=i.z;return s[0]=(1-(x+g))*A,s[1]=(f+S)*A,s[2]=(p-w)*A,s[3]=0,s[4]=(f-S)*M,s[5]=(1-(d+g))*M,s[6]=(m+_)*M,s[7]=0,s[8]=(p+w)*y,s[9]=(m-_)*y,s[10]=(1-(d+x))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=no.set(s[0],s[1],s[2]).length(),a=no.set(s[4],s[5],s[6]).length(),l=no.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ii.copy(this);let c=1/o,u=1/a,h=1/l;return Ii.elements[0]*=c,Ii.elements[1]*=c,Ii.elements[2]*=c,Ii.elements[4]*=u,Ii.elements[5]*=u,Ii.elements[6]*=u,Ii.elements[8]*=h,Ii.elements[9]*=h,Ii.elements[10]*=h,t.setFromRotationMatrix(Ii),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),d=(t+e)/(t-e),f=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===Si)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===_o)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Si,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),d=-(t+e)/(t-e),f=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===Si)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===_o)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},no=new H,Ii=new dt,rS=new H(0,0,0),oS=new H(1,1,1),Hs=new H,Rl=new H,ai=new H,Pm=new dt,Im=new hi,Ss=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Pm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Pm,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Im.setFromEuler(this),this.setFromQuaternion(Im,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ss.DEFAULT_ORDER="XYZ";var So=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},aS=0,Lm=new H,io=new hi,ms=new dt,Pl=new H,ha=new H,lS=new H,cS=new hi,Nm=new H(1,0,0),Dm=new H(0,1,0),km=new H(0,0,1),Om={type:"added"},uS={type:"removed"},so={type:"childadded",child:null},td={type:"childremoved",child:null},On=class n extends Di{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:aS++}),this.uuid=Lo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new H,t=new Ss,i=new hi,s=new H(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new dt},normalMatrix:{value:new rt}}),this.matrix=new dt,this.matrixWorld=new dt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new So,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return io.setFromAxisAngle(e,t),this.quaternion.multiply(io),this}rotateOnWorldAxis(e,t){return io.setFromAxisAngle(e,t),this.quaternion.premultiply(io),this}rotateX(e){return this.rotateOnAxis(Nm,e)}rotateY(e){return this.rotateOnAxis(Dm,e)}rotateZ(e){return this.rotateOnAxis(km,e)}translateOnAxis(e,t){return Lm.copy(e).applyQuaternion(this.quaternion),this.position.add(Lm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Nm,e)}translateY(e){return this.translateOnAxis(Dm,e)}translateZ(e){return this.translateOnAxis(km,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ms.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Pl.copy(e):Pl.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ha.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ms.lookAt(ha,Pl,this.up):ms.lookAt(Pl,ha,this.up),this.quaternion.setFromRotationMatrix(ms),s&&(ms.extractRotation(s.matrixWorld),io.setFromRotationMatrix(ms),this.quaternion.premultiply(io.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Om),so.child=e,this.dispatchEvent(so),so.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(uS),td.child=e,this.dispatchEvent(td),td.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Om),so.child=e,this.dispatchEvent(so),so.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,e,lS),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ha,cS,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};On.DEFAULT_UP=new H(0,1,0);On.DEFAULT_MATRIX_AUTO_UPDATE=!0;On.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ln=class extends On{constructor(){super(),this.isGroup=!0,this.type="Group"}},hS={type:"move"},wo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new H,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new H),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new H,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new H,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let m=t.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(hS)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ln;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Gg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ws={h:0,s:0,l:0},Il={h:0,s:0,l:0};function nd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var je=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ci){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=St.workingColorSpace){if(e=Qd(e,1),t=xt(t,0,1),i=xt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=nd(o,r,e+1/3),this.g=nd(o,r,e),this.b=nd(o,r,e-1/3)}return St.colorSpaceToWorking(this,s),this}setStyle(e,t=ci){function i(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ci){let i=Gg[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=vs(e.r),this.g=vs(e.g),this.b=vs(e.b),this}copyLinearToSRGB(e){return this.r=go(e.r),this.g=go(e.g),this.b=go(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ci){return St.workingToColorSpace(Bn.copy(this),e),Math.round(xt(Bn.r*255,0,255))*65536+Math.round(xt(Bn.g*255,0,255))*256+Math.round(xt(Bn.b*255,0,255))}getHexString(e=ci){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(Bn.copy(this),t);let i=Bn.r,s=Bn.g,r=Bn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(Bn.copy(this),t),e.r=Bn.r,e.g=Bn.g,e.b=Bn.b,e}getStyle(e=ci){St.workingToColorSpace(Bn.copy(this),e);let t=Bn.r,i=Bn.g,s=Bn.b;return e!==ci?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Ws),this.setHSL(Ws.h+e,Ws.s+t,Ws.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ws),e.getHSL(Il);let i=va(Ws.h,Il.h,t),s=va(Ws.s,Il.s,t),r=va(Ws.l,Il.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Bn=new je;je.NAMES=Gg;var Ea=class extends On{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ss,this.environmentIntensity=1,this.environmentRotation=new Ss,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Li=new H,gs=new H,id=new H,xs=new H,ro=new H,oo=new H,Um=new H,sd=new H,rd=new H,od=new H,ad=new Gt,ld=new Gt,cd=new Gt,Qi=class n{constructor(e=new H,t=new H,i=new H){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Li.subVectors(e,t),s.cross(Li);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Li.subVectors(s,t),gs.subVectors(i,t),id.subVectors(e,t);let o=Li.dot(Li),a=Li.dot(gs),l=Li.dot(id),c=gs.dot(gs),u=gs.dot(id),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,xs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,xs.x),l.addScaledVector(o,xs.y),l.addScaledVector(a,xs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return ad.setScalar(0),ld.setScalar(0),cd.setScalar(0),ad.fromBufferAttribute(e,t),ld.fromBufferAttribute(e,i),cd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(ad,r.x),o.addScaledVector(ld,r.y),o.addScaledVector(cd,r.z),o}static isFrontFacing(e,t,i,s){return Li.subVectors(i,t),gs.subVectors(e,t),Li.cross(gs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Li.subVectors(this.c,this.b),gs.subVectors(this.a,this.b),Li.cross(gs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;ro.subVectors(s,i),oo.subVectors(r,i),sd.subVectors(e,i);let l=ro.dot(sd),c=oo.dot(sd);if(l<=0&&c<=0)return t.copy(i);rd.subVectors(e,s);let u=ro.dot(rd),h=oo.dot(rd);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(ro,o);od.subVectors(e,r);let f=ro.dot(od),p=oo.dot(od);if(p>=0&&f<=p)return t.copy(r);let x=f*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(oo,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return Um.subVectors(r,s),a=(h-u)/(h-u+(f-p)),t.copy(s).addScaledVector(Um,a);let g=1/(m+x+d);return o=x*g,a=d*g,t.copy(i).addScaledVector(ro,o).addScaledVector(oo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ts=class{constructor(e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ni.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ni.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ni.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ni):Ni.fromBufferAttribute(r,o),Ni.applyMatrix4(e.matrixWorld),this.expandByPoint(Ni);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ll.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ll.copy(i.boundingBox)),Ll.applyMatrix4(e.matrixWorld),this.union(Ll)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ni),Ni.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(da),Nl.subVectors(this.max,da),ao.subVectors(e.a,da),lo.subVectors(e.b,da),co.subVectors(e.c,da),$s.subVectors(lo,ao),Xs.subVectors(co,lo),br.subVectors(ao,co);let t=[0,-$s.z,$s.y,0,-Xs.z,Xs.y,0,-br.z,br.y,$s.z,0,-$s.x,Xs.z,0,-Xs.x,br.z,0,-br.x,-$s.y,$s.x,0,-Xs.y,Xs.x,0,-br.y,br.x,0];return!ud(t,ao,lo,co,Nl)||(t=[1,0,0,0,1,0,0,0,1],!ud(t,ao,lo,co,Nl))?!1:(Dl.crossVectors($s,Xs),t=[Dl.x,Dl.y,Dl.z],ud(t,ao,lo,co,Nl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ni).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ni).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_s),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_s=[new H,new H,new H,new H,new H,new H,new H,new H],Ni=new H,Ll=new ts,ao=new H,lo=new H,co=new H,$s=new H,Xs=new H,br=new H,da=new H,Nl=new H,Dl=new H,Sr=new H;function ud(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Sr.fromArray(n,r);let a=s.x*Math.abs(Sr.x)+s.y*Math.abs(Sr.y)+s.z*Math.abs(Sr.z),l=e.dot(Sr),c=t.dot(Sr),u=i.dot(Sr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var xn=new H,kl=new Je,dS=0,un=class extends Di{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:dS++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=kg,this.updateRanges=[],this.gpuType=Mi,this.version=0,this._normalizationScale=e!==void 0?tf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)kl.fromBufferAttribute(this,t),kl.applyMatrix3(e),this.setXY(t,kl.x,kl.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):zg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Vg(e,this.array)}};var Ta=class extends un{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ca=class extends un{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var an=class extends un{constructor(e,t,i){super(new Float32Array(e),t,i)}},fS=new ts,fa=new H,hd=new H,ws=class{constructor(e=new H,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):fS.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;fa.subVectors(e,this.center);let t=fa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(fa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(hd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(fa.copy(e.center).add(hd)),this.expandByPoint(fa.copy(e.center).sub(hd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},pS=0,bi=new dt,dd=new On,uo=new H,li=new ts,pa=new ts,In=new H,bn=class n extends Di{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:pS++}),this.uuid=Lo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Bb(e)?Ca:Ta)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new rt().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return bi.makeRotationFromQuaternion(e),this.applyMatrix4(bi),this}rotateX(e){return bi.makeRotationX(e),this.applyMatrix4(bi),this}rotateY(e){return bi.makeRotationY(e),this.applyMatrix4(bi),this}rotateZ(e){return bi.makeRotationZ(e),this.applyMatrix4(bi),this}translate(e,t,i){return bi.makeTranslation(e,t,i),this.applyMatrix4(bi),this}scale(e,t,i){return bi.makeScale(e,t,i),this.applyMatrix4(bi),this}lookAt(e){return dd.lookAt(e),dd.updateMatrix(),this.applyMatrix4(dd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(uo).negate(),this.translate(uo.x,uo.y,uo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new an(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ts);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new H(-1/0,-1/0,-1/0),new H(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];li.setFromBufferAttribute(r),this.morphTargetsRelative?(In.addVectors(this.boundingBox.min,li.min),this.boundingBox.expandByPoint(In),In.addVectors(this.boundingBox.max,li.max),this.boundingBox.expandByPoint(In)):(this.boundingBox.expandByPoint(li.min),this.boundingBox.expandByPoint(li.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new ws);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new H,1/0);return}if(e){let i=this.boundingSphere.center;if(li.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];pa.setFromBufferAttribute(a),this.morphTargetsRelative?(In.addVectors(li.min,pa.min),li.expandByPoint(In),In.addVectors(li.max,pa.max),li.expandByPoint(In)):(li.expandByPoint(pa.min),li.expandByPoint(pa.max))}li.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)In.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(In));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)In.fromBufferAttribute(a,c),l&&(uo.fromBufferAttribute(e,c),In.add(uo)),s=Math.max(s,i.distanceToSquared(In))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new un(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let T=0;T<i.count;T++)a[T]=new H,l[T]=new H;let u=new H,h=new H,d=new H,f=new Je,p=new Je,x=new Je,m=new H,g=new H;function _(T,P,C){c[T]=c[P]=c[C]=1,u.fromBufferAttribute(i,T),h.fromBufferAttribute(i,P),d.fromBufferAttribute(i,C),f.fromBufferAttribute(r,T),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,C),h.sub(u),d.sub(u),p.sub(f),x.sub(f);let N=1/(p.x*x.y-x.x*p.y);isFinite(N)&&(m.copy(h).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(N),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-x.x).multiplyScalar(N),a[T].add(m),a[P].add(m),a[C].add(m),l[T].add(g),l[P].add(g),l[C].add(g))}let w=this.groups;w.length===0&&(w=[{start:0,count:e.count}]);for(let T=0,P=w.length;T<P;++T){let C=w[T],N=C.start,F=C.count;for(let D=N,V=N+F;D<V;D+=3)_(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let S=new H,A=new H,M=new H,y=new H;function v(T){M.fromBufferAttribute(s,T),y.copy(M);let P=a[T];S.copy(P),S.sub(M.multiplyScalar(M.dot(P))).normalize(),A.crossVectors(y,P);let N=A.dot(l[T])<0?-1:1;o.setXYZW(T,S.x,S.y,S.z,N)}for(let T=0,P=i.count;T<P;++T)c[T]&&v(T);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new un(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new H,r=new H,o=new H,a=new H,l=new H,c=new H,u=new H,h=new H;if(e)for(let d=0,f=e.count;d<f;d+=3){let p=e.getX(d+0),x=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,x),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)In.fromBufferAttribute(e,t),In.normalize(),e.setXYZ(t,In.x,In.y,In.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new un(d,u,h)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var fd=new H,mS=new H,gS=new rt,ui=class{constructor(e=new H(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=fd.subVectors(i,t).cross(mS.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(fd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||gS.getNormalMatrix(e),s=this.coplanarPoint(fd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},xS=0,Ms=class extends Di{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xS++}),this.uuid=Lo(),this.name="",this.type="Material",this.blending=Ro,this.side=nr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Pd,this.blendDst=Id,this.blendEquation=Rr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=xo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Rg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ql,this.stencilZFail=Ql,this.stencilZPass=Ql,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ui().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ys=new H,pd=new H,Ol=new H,Ul=new H,Ys=class{constructor(e=new H,t=new H(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ys)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ys.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ys.copy(this.origin).addScaledVector(this.direction,t),ys.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){pd.copy(e).add(t).multiplyScalar(.5),Ol.copy(t).sub(e).normalize(),Ul.copy(this.origin).sub(pd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ol),a=Ul.dot(this.direction),l=-Ul.dot(Ol),c=Ul.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(pd).addScaledVector(Ol,d),f}intersectSphere(e,t){if(e.radius<0)return null;ys.subVectors(e.center,this.origin);let i=ys.dot(this.direction),s=ys.dot(ys)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,ys)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,p=t.x-o.x,x=t.y-o.y,m=t.z-o.z,g=i.x-o.x,_=i.y-o.y,w=i.z-o.z,S=Math.abs(l),A=Math.abs(c),M=Math.abs(u),y,v,T,P,C,N,F,D,V,$,B,ne;if(S>=A&&S>=M?(T=l,N=h,V=p,ne=g,l>=0?(y=c,v=u,P=d,C=f,F=x,D=m,$=_,B=w):(y=u,v=c,P=f,C=d,F=m,D=x,$=w,B=_)):A>=M?(T=c,N=d,V=x,ne=_,c>=0?(y=u,v=l,P=f,C=h,F=m,D=p,$=w,B=g):(y=l,v=u,P=h,C=f,F=p,D=m,$=g,B=w)):(T=u,N=f,V=m,ne=w,u>=0?(y=l,v=c,P=h,C=d,F=p,D=x,$=g,B=_):(y=c,v=l,P=d,C=h,F=x,D=p,$=_,B=g)),T===0)return null;let Y=y/T,K=v/T,ee=1/T,de=P-Y*N,ce=C-K*N,te=F-Y*V,fe=D-K*V,xe=$-Y*ne,be=B-K*ne,Se=xe*fe-be*te,$e=de*be-ce*xe,ot=te*ce-fe*de;if(s){if(Se<0||$e<0||ot<0)return null}else if((Se<0||$e<0||ot<0)&&(Se>0||$e>0||ot>0))return null;let We=Se+$e+ot;if(We===0)return null;let lt=ee*(Se*N+$e*V+ot*ne);return(We>0?lt<0:lt>0)?null:this.at(lt/We,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},As=class extends Ms{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Lc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Fm=new dt,wr=new Ys,Fl=new ws,Bm=new H,Bl=new H,zl=new H,Vl=new H,md=new H,Gl=new H,zm=new H,Hl=new H,_n=class extends On{constructor(e=new bn,t=new As){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Gl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(md.fromBufferAttribute(h,e),o?Gl.addScaledVector(md,u):Gl.addScaledVector(md.sub(t),u))}t.add(Gl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Fl.copy(i.boundingSphere),Fl.applyMatrix4(r),wr.copy(e.ray).recast(e.near),!(Fl.containsPoint(wr.origin)===!1&&(wr.intersectSphere(Fl,Bm)===null||wr.origin.distanceToSquared(Bm)>(e.far-e.near)**2))&&(Fm.copy(r).invert(),wr.copy(e.ray).applyMatrix4(Fm),!(i.boundingBox!==null&&wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,wr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let S=_,A=w;S<A;S+=3){let M=a.getX(S),y=a.getX(S+1),v=a.getX(S+2);s=Wl(this,g,e,i,c,u,h,M,y,v),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=a.getX(m),w=a.getX(m+1),S=a.getX(m+2);s=Wl(this,o,e,i,c,u,h,_,w,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],_=Math.max(m.start,f.start),w=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let S=_,A=w;S<A;S+=3){let M=S,y=S+1,v=S+2;s=Wl(this,g,e,i,c,u,h,M,y,v),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let _=m,w=m+1,S=m+2;s=Wl(this,o,e,i,c,u,h,_,w,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function _S(n,e,t,i,s,r,o,a){let l;if(e.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===nr,a),l===null)return null;Hl.copy(a),Hl.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Hl);return c<t.near||c>t.far?null:{distance:c,point:Hl.clone(),object:n}}function Wl(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Bl),n.getVertexPosition(l,zl),n.getVertexPosition(c,Vl);let u=_S(n,e,t,i,Bl,zl,Vl,zm);if(u){let h=new H;Qi.getBarycoord(zm,Bl,zl,Vl,h),s&&(u.uv=Qi.getInterpolatedAttribute(s,a,l,c,h,new Je)),r&&(u.uv1=Qi.getInterpolatedAttribute(r,a,l,c,h,new Je)),o&&(u.normal=Qi.getInterpolatedAttribute(o,a,l,c,h,new H),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new H,materialIndex:0};Qi.getNormal(Bl,zl,Vl,d.normal),u.face=d,u.barycoord=h}return u}var Ra=class extends ei{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Nn,u=Nn,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pa=class extends un{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},ho=new dt,Vm=new dt,$l=[],Gm=new ts,yS=new dt,ma=new _n,ga=new ws,fi=class extends _n{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Pa(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,yS)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new ts),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ho),Gm.copy(e.boundingBox).applyMatrix4(ho),this.boundingBox.union(Gm)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new ws),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,ho),ga.copy(e.boundingSphere).applyMatrix4(ho),this.boundingSphere.union(ga)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(ma.geometry=this.geometry,ma.material=this.material,ma.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ga.copy(this.boundingSphere),ga.applyMatrix4(i),e.ray.intersectsSphere(ga)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,ho),Vm.multiplyMatrices(i,ho),ma.matrixWorld=Vm,ma.raycast(e,$l);for(let o=0,a=$l.length;o<a;o++){let l=$l[o];l.instanceId=r,l.object=this,t.push(l)}$l.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Pa(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Ra(new Float32Array(s*this.count),s,this.count,Bc,Mi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Mr=new ws,vS=new Je(.5,.5),Xl=new H,Zs=class{constructor(e=new ui,t=new ui,i=new ui,s=new ui,r=new ui,o=new ui){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Si,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],_=r[12],w=r[13],S=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-_).normalize(),s[1].setComponents(c+o,f+u,g+p,A+_).normalize(),s[2].setComponents(c+a,f+h,g+x,A+w).normalize(),s[3].setComponents(c-a,f-h,g-x,A-w).normalize(),i)s[4].setComponents(l,d,m,S).normalize(),s[5].setComponents(c-l,f-d,g-m,A-S).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-S).normalize(),t===Si)s[5].setComponents(c+l,f+d,g+m,A+S).normalize();else if(t===_o)s[5].setComponents(l,d,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Mr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Mr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Mr)}intersectsSprite(e){Mr.center.set(0,0,0);let t=vS.distanceTo(e.center);return Mr.radius=.7071067811865476+t,Mr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Mr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Xl.x=s.normal.x>0?e.max.x:e.min.x,Xl.y=s.normal.y>0?e.max.y:e.min.y,Xl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Xl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Hm=new dt,fc=class n{constructor(){this.coordinateSystem=Si,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Hm.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Zs),i[s].setFromProjectionMatrix(Hm,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Zs),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var js=class extends Ms{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new je(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},pc=new H,mc=new H,Wm=new dt,xa=new Ys,ql=new ws,gd=new H,$m=new H,gc=class extends On{constructor(e=new bn,t=new js){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)pc.fromBufferAttribute(t,s-1),mc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=pc.distanceTo(mc);e.setAttribute("lineDistance",new an(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ql.copy(i.boundingSphere),ql.applyMatrix4(s),ql.radius+=r,e.ray.intersectsSphere(ql)===!1)return;Wm.copy(s).invert(),xa.copy(e.ray).applyMatrix4(Wm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=u.getX(x),_=u.getX(x+1),w=Yl(this,e,xa,l,g,_,x);w&&t.push(w)}if(this.isLineLoop){let x=u.getX(p-1),m=u.getX(f),g=Yl(this,e,xa,l,x,m,p-1);g&&t.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=c){let g=Yl(this,e,xa,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=Yl(this,e,xa,l,p-1,f,p-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Yl(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(pc.fromBufferAttribute(a,s),mc.fromBufferAttribute(a,r),t.distanceSqToSegment(pc,mc,gd,$m)>i)return;gd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(gd);if(!(c<e.near||c>e.far))return{distance:c,point:$m.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Xm=new H,qm=new H,Ar=class extends gc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)Xm.fromBufferAttribute(t,s),qm.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Xm.distanceTo(qm);e.setAttribute("lineDistance",new an(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ia=class extends ei{constructor(e=[],t=Pr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Es=class extends ei{constructor(e,t,i=ki,s,r,o,a=Nn,l=Nn,c,u=bs,h=1){if(u!==bs&&u!==Rs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new bo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},La=class extends Es{constructor(e,t=ki,i=Pr,s,r,o=Nn,a=Nn,l,c=bs){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Na=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Mo=class n extends bn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new an(c,3)),this.setAttribute("normal",new an(u,3)),this.setAttribute("uv",new an(h,2));function p(x,m,g,_,w,S,A,M,y,v,T){let P=S/y,C=A/v,N=S/2,F=A/2,D=M/2,V=y+1,$=v+1,B=0,ne=0,Y=new H;for(let K=0;K<$;K++){let ee=K*C-F;for(let de=0;de<V;de++){let ce=de*P-N;Y[x]=ce*_,Y[m]=ee*w,Y[g]=D,c.push(Y.x,Y.y,Y.z),Y[x]=0,Y[m]=0,Y[g]=M>0?1:-1,u.push(Y.x,Y.y,Y.z),h.push(de/y),h.push(1-K/v),B+=1}}for(let K=0;K<v;K++)for(let ee=0;ee<y;ee++){let de=d+ee+V*K,ce=d+ee+V*(K+1),te=d+(ee+1)+V*(K+1),fe=d+(ee+1)+V*K;l.push(de,ce,fe),l.push(ce,te,fe),ne+=6}a.addGroup(f,ne,T),f+=ne,d+=B}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var wi=class n extends bn{constructor(e=1,t=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,x=[],m=i/2,g=0;_(),o===!1&&(e>0&&w(!0),t>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new an(h,3)),this.setAttribute("normal",new an(d,3)),this.setAttribute("uv",new an(f,2));function _(){let S=new H,A=new H,M=0,y=(t-e)/i;for(let v=0;v<=r;v++){let T=[],P=v/r,C=P*(t-e)+e;for(let N=0;N<=s;N++){let F=N/s,D=F*l+a,V=Math.sin(D),$=Math.cos(D);A.x=C*V,A.y=-P*i+m,A.z=C*$,h.push(A.x,A.y,A.z),S.set(V,y,$).normalize(),d.push(S.x,S.y,S.z),f.push(F,1-P),T.push(p++)}x.push(T)}for(let v=0;v<s;v++)for(let T=0;T<r;T++){let P=x[T][v],C=x[T+1][v],N=x[T+1][v+1],F=x[T][v+1];(e>0||T!==0)&&(u.push(P,C,F),M+=3),(t>0||T!==r-1)&&(u.push(C,N,F),M+=3)}c.addGroup(g,M,0),g+=M}function w(S){let A=p,M=new Je,y=new H,v=0,T=S===!0?e:t,P=S===!0?1:-1;for(let N=1;N<=s;N++)h.push(0,m*P,0),d.push(0,P,0),f.push(.5,.5),p++;let C=p;for(let N=0;N<=s;N++){let D=N/s*l+a,V=Math.cos(D),$=Math.sin(D);y.x=T*$,y.y=m*P,y.z=T*V,h.push(y.x,y.y,y.z),d.push(0,P,0),M.x=V*.5+.5,M.y=$*.5*P+.5,f.push(M.x,M.y),p++}for(let N=0;N<s;N++){let F=A+N,D=C+N;S===!0?u.push(D,D+1,F):u.push(D+1,D,F),v+=3}c.addGroup(g,v,S===!0?1:2),g+=v}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Er=class n extends wi{constructor(e=1,t=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Da=class n extends bn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],p=[],x=[],m=[];for(let g=0;g<u;g++){let _=g*d-o;for(let w=0;w<c;w++){let S=w*h-r;p.push(S,-_,0),x.push(0,0,1),m.push(w/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let _=0;_<a;_++){let w=_+c*g,S=_+c*(g+1),A=_+1+c*(g+1),M=_+1+c*g;f.push(w,S,M),f.push(S,A,M)}this.setIndex(f),this.setAttribute("position",new an(p,3)),this.setAttribute("normal",new an(x,3)),this.setAttribute("uv",new an(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ao=class n extends bn{constructor(e=1,t=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new H,d=new H,f=[],p=[],x=[],m=[];for(let g=0;g<=i;g++){let _=[],w=g/i,S=o+w*a,A=e*Math.cos(S),M=Math.sqrt(e*e-A*A),y=0;g===0&&o===0?y=.5/t:g===i&&l===Math.PI&&(y=-.5/t);for(let v=0;v<=t;v++){let T=v/t,P=s+T*r;h.x=-M*Math.cos(P),h.y=A,h.z=M*Math.sin(P),p.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),m.push(T+y,1-w),_.push(c++)}u.push(_)}for(let g=0;g<i;g++)for(let _=0;_<t;_++){let w=u[g][_+1],S=u[g][_],A=u[g+1][_],M=u[g+1][_+1];(g!==0||o>0)&&f.push(w,S,M),(g!==i-1||l<Math.PI)&&f.push(S,A,M)}this.setIndex(f),this.setAttribute("position",new an(p,3)),this.setAttribute("normal",new an(x,3)),this.setAttribute("uv",new an(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};function Lr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(Ym(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(Ym(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Vn(n){let e={};for(let t=0;t<n.length;t++){let i=Lr(n[t]);for(let s in i)e[s]=i[s]}return e}function Ym(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function bS(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function sf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Hg={clone:Lr,merge:Vn},SS=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,wS=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ns=class extends Ms{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=SS,this.fragmentShader=wS,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Lr(e.uniforms),this.uniformsGroups=bS(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new je().setHex(s.value);break;case"v2":this.uniforms[i].value=new Je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new H().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Gt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new rt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new dt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},xc=class extends ns{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Ts=class extends Ms{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=yu,this.normalScale=new Je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ss,this.combine=Lc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},_c=class extends Ms{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Tg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},yc=class extends Ms{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function fo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Zl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ks=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break e}o=i,i=0;break t}break n}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},vc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:yd,endingEnd:yd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case vd:r=e,a=2*t-i;break;case bd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case vd:o=e,l=2*i-t;break;case bd:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,_=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,w=(-1-f)*m+(1.5+f)*x+.5*p,S=f*m-f*x;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+_*o[c+A]+w*o[l+A]+S*o[h+A];return r}},bc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Sc=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},wc=class extends Ks{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),x=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*p;return r}let d=a*2,f=e-1;for(let p=0;p!==a;++p){let x=o[c+p],m=o[l+p],g=f*d+p*2,_=h[g],w=h[g+1],S=e*d+p*2,A=u[S],M=u[S+1],y=AS(i,t,_,A,s);r[p]=Wg(y,x,w,M,m)}return r}};function Wg(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function MS(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function AS(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Wg(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=MS(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var pi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=fo(t,this.TimeBufferType),this.values=fo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:fo(e.times,Array),values:fo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Zl(e.settings)&&(i.settings={inTangents:fo(e.settings.inTangents,Array),outTangents:fo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Sc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new bc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new vc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new wc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ba:t=this.InterpolantFactoryMethodDiscrete;break;case cc:t=this.InterpolantFactoryMethodLinear;break;case Jl:t=this.InterpolantFactoryMethodSmooth;break;case _d:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ba;case this.InterpolantFactoryMethodLinear:return cc;case this.InterpolantFactoryMethodSmooth:return Jl;case this.InterpolantFactoryMethodBezier:return _d}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Zl(this.settings)&&(Zm(this.settings.inTangents,e),Zm(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Zl(this.settings)&&(jm(this.settings.inTangents,e),jm(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&zb(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Jl,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let x=t[h+p];if(x!==t[d+p]||x!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Zl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Zm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function jm(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}pi.prototype.ValueTypeName="";pi.prototype.TimeBufferType=Float32Array;pi.prototype.ValueBufferType=Float32Array;pi.prototype.DefaultInterpolation=cc;var Js=class extends pi{constructor(e,t,i){super(e,t,i)}};Js.prototype.ValueTypeName="bool";Js.prototype.ValueBufferType=Array;Js.prototype.DefaultInterpolation=ba;Js.prototype.InterpolantFactoryMethodLinear=void 0;Js.prototype.InterpolantFactoryMethodSmooth=void 0;var Mc=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Mc.prototype.ValueTypeName="color";var Ac=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Ac.prototype.ValueTypeName="number";var Ec=class extends Ks{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)hi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ka=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Ec(this.times,this.values,this.getValueSize(),e)}};ka.prototype.ValueTypeName="quaternion";ka.prototype.InterpolantFactoryMethodSmooth=void 0;var Qs=class extends pi{constructor(e,t,i){super(e,t,i)}};Qs.prototype.ValueTypeName="string";Qs.prototype.ValueBufferType=Array;Qs.prototype.DefaultInterpolation=ba;Qs.prototype.InterpolantFactoryMethodLinear=void 0;Qs.prototype.InterpolantFactoryMethodSmooth=void 0;var Tc=class extends pi{constructor(e,t,i,s){super(e,t,i,s)}};Tc.prototype.ValueTypeName="vector";var Cc=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},$g=new Cc,Rc=class{constructor(e){this.manager=e!==void 0?e:$g,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Rc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Oa=class extends On{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ua=class extends Oa{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(On.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},xd=new dt,Km=new H,Jm=new H,Pc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Je(512,512),this.mapType=ti,this.map=null,this.mapPass=null,this.matrix=new dt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Zs,this._frameExtents=new Je(1,1),this._viewportCount=1,this._viewports=[new Gt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Km.setFromMatrixPosition(e.matrixWorld),t.position.copy(Km),Jm.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Jm),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){xd.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(xd,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===_o||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(xd)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},jl=new H,Kl=new hi,Ji=new H,Fa=class extends On{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new dt,this.projectionMatrix=new dt,this.projectionMatrixInverse=new dt,this.coordinateSystem=Si,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(jl,Kl,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,Ji.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(jl,Kl,Ji),Ji.x===1&&Ji.y===1&&Ji.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(jl,Kl,Ji.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},qs=new H,Qm=new Je,eg=new Je,Yn=class extends Fa{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=vo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(ya*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return vo*2*Math.atan(Math.tan(ya*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){qs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(qs.x,qs.y).multiplyScalar(-e/qs.z),qs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(qs.x,qs.y).multiplyScalar(-e/qs.z)}getViewSize(e,t){return this.getViewBounds(e,Qm,eg),t.subVectors(eg,Qm)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(ya*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ba=class extends Fa{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Sd=class extends Pc{constructor(){super(new Ba(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},za=class extends Oa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(On.DEFAULT_UP),this.updateMatrix(),this.target=new On,this.shadow=new Sd}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var po=-90,mo=1,Eo=class extends On{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(po,mo,e,t);s.layers=this.layers,this.add(s);let r=new Yn(po,mo,e,t);r.layers=this.layers,this.add(r);let o=new Yn(po,mo,e,t);o.layers=this.layers,this.add(o);let a=new Yn(po,mo,e,t);a.layers=this.layers,this.add(a);let l=new Yn(po,mo,e,t);l.layers=this.layers,this.add(l);let c=new Yn(po,mo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Si)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===_o)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Ic=class extends Yn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var rf="\\[\\]\\.:\\/",ES=new RegExp("["+rf+"]","g"),of="[^"+rf+"]",TS="[^"+rf.replace("\\.","")+"]",CS=/((?:WC+[\/:])*)/.source.replace("WC",of),RS=/(WCOD+)?/.source.replace("WCOD",TS),PS=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",of),IS=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",of),LS=new RegExp("^"+CS+RS+PS+IS+"$"),NS=["material","materials","bones","map"],wd=class{constructor(e,t,i){let s=i||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(ES,"")}static parseTrackName(e){let t=LS.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);NS.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=wd;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var eL=new Float32Array(1);var tg=new dt,Tr=class{constructor(e,t,i=0,s=1/0){this.ray=new Ys(e,t),this.near=i,this.far=s,this.camera=null,this.layers=new So,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(e,t){this.ray.set(e,t)}setFromCamera(e,t){t.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(e.x,e.y,.5).unproject(t).sub(this.ray.origin).normalize(),this.camera=t):t.isOrthographicCamera?(this.ray.origin.set(e.x,e.y,t.projectionMatrix.elements[14]).unproject(t),this.ray.direction.set(0,0,-1).transformDirection(t.matrixWorld),this.camera=t):st("Raycaster: Unsupported camera type: "+t.type)}setFromXRController(e){return tg.identity().extractRotation(e.matrixWorld),this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(tg),this}intersectObject(e,t=!0,i=[]){return Md(e,this,i,t),i.sort(ng),i}intersectObjects(e,t=!0,i=[]){for(let s=0,r=e.length;s<r;s++)Md(e[s],this,i,t);return i.sort(ng),i}};function ng(n,e){return n.distance-e.distance}function Md(n,e,t,i){let s=!0;if(n.layers.test(e.layers)&&n.raycast(e,t)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Md(r[o],e,t,!0)}}var To=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=xt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(xt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ad=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Va=class extends Di{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function af(n,e,t,i){let s=DS(i);switch(t){case Wd:return n*e;case Bc:return n*e/s.components*s.byteLength;case zc:return n*e/s.components*s.byteLength;case ir:return n*e*2/s.components*s.byteLength;case Vc:return n*e*2/s.components*s.byteLength;case $d:return n*e*3/s.components*s.byteLength;case Ui:return n*e*4/s.components*s.byteLength;case Gc:return n*e*4/s.components*s.byteLength;case Wa:case $a:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Xa:case qa:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Wc:case Xc:return Math.max(n,16)*Math.max(e,8)/4;case Hc:case $c:return Math.max(n,8)*Math.max(e,8)/2;case qc:case Yc:case jc:case Kc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Zc:case Ya:case Jc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Qc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case eu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case tu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case nu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case iu:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case su:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ru:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case ou:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case au:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case lu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case cu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case uu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case hu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case du:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case fu:case pu:case mu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case gu:case xu:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Za:case _u:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function DS(n){switch(n){case ti:case zd:return{byteLength:1,components:1};case Io:case Vd:case Oi:return{byteLength:2,components:1};case Uc:case Fc:return{byteLength:2,components:4};case ki:case Oc:case Mi:return{byteLength:4,components:1};case Gd:case Hd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function f0(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function OS(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],x=h[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var US=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,FS=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,BS=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,zS=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,VS=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,GS=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,HS=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,WS=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,$S=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,XS=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,qS=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,YS=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ZS=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,jS=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,KS=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,JS=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,QS=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,ew=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,tw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,nw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,iw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,sw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,rw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,ow=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,aw=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,lw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,cw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,uw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,hw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,dw="gl_FragColor = linearToOutputTexel( gl_FragColor );",fw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,pw=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,mw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,gw=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,xw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,_w=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,yw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,bw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Sw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ww=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Mw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Aw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ew=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Tw=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Cw=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Rw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Pw=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Iw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Lw=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Nw=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Dw=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,kw=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Ow=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Uw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Fw=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Bw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,zw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Vw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Hw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ww=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,$w=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Xw=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,qw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Yw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Zw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,jw=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Kw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Jw=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Qw=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,tM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,nM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,iM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,rM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,oM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,aM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,lM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,cM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,uM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,hM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,dM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,fM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,pM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,mM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,gM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,xM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,_M=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,yM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,vM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,bM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,SM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,wM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,MM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,AM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,EM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,TM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,CM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,RM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,PM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,IM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,LM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,NM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,DM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,kM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,OM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,UM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,FM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,BM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,VM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,GM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,HM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,WM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,$M=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,XM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,qM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,YM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,ZM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,KM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,JM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,QM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,e1=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,t1=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,n1=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,i1=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,s1=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,r1=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,o1=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,a1=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,l1=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,c1=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,u1=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,h1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,d1=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,f1=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,p1=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,m1=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,pt={alphahash_fragment:US,alphahash_pars_fragment:FS,alphamap_fragment:BS,alphamap_pars_fragment:zS,alphatest_fragment:VS,alphatest_pars_fragment:GS,aomap_fragment:HS,aomap_pars_fragment:WS,batching_pars_vertex:$S,batching_vertex:XS,begin_vertex:qS,beginnormal_vertex:YS,bsdfs:ZS,iridescence_fragment:jS,bumpmap_pars_fragment:KS,clipping_planes_fragment:JS,clipping_planes_pars_fragment:QS,clipping_planes_pars_vertex:ew,clipping_planes_vertex:tw,color_fragment:nw,color_pars_fragment:iw,color_pars_vertex:sw,color_vertex:rw,common:ow,defaultnormal_vertex:aw,displacementmap_pars_vertex:lw,displacementmap_vertex:cw,emissivemap_fragment:uw,emissivemap_pars_fragment:hw,colorspace_fragment:dw,colorspace_pars_fragment:fw,envmap_fragment:pw,envmap_common_pars_fragment:mw,envmap_pars_fragment:gw,envmap_pars_vertex:xw,envmap_physical_pars_fragment:Cw,envmap_vertex:_w,fog_vertex:yw,fog_pars_vertex:vw,fog_fragment:bw,fog_pars_fragment:Sw,gradientmap_pars_fragment:ww,lightmap_pars_fragment:Mw,lights_lambert_fragment:Aw,lights_lambert_pars_fragment:Ew,lights_pars_begin:Tw,lights_toon_fragment:Rw,lights_toon_pars_fragment:Pw,lights_phong_fragment:Iw,lights_phong_pars_fragment:Lw,lights_physical_fragment:Nw,lights_physical_pars_fragment:Dw,lights_fragment_begin:kw,lights_fragment_maps:Ow,lights_fragment_end:Uw,lightprobes_pars_fragment:Fw,logdepthbuf_fragment:Bw,logdepthbuf_pars_fragment:zw,logdepthbuf_pars_vertex:Vw,logdepthbuf_vertex:Gw,map_fragment:Hw,map_pars_fragment:Ww,map_particle_fragment:$w,map_particle_pars_fragment:Xw,metalnessmap_fragment:qw,metalnessmap_pars_fragment:Yw,morphinstance_vertex:Zw,morphcolor_vertex:jw,morphnormal_vertex:Kw,morphtarget_pars_vertex:Jw,morphtarget_vertex:Qw,normal_fragment_begin:eM,normal_fragment_maps:tM,normal_pars_fragment:nM,normal_pars_vertex:iM,normal_vertex:sM,normalmap_pars_fragment:rM,clearcoat_normal_fragment_begin:oM,clearcoat_normal_fragment_maps:aM,clearcoat_pars_fragment:lM,iridescence_pars_fragment:cM,opaque_fragment:uM,packing:hM,premultiplied_alpha_fragment:dM,project_vertex:fM,dithering_fragment:pM,dithering_pars_fragment:mM,roughnessmap_fragment:gM,roughnessmap_pars_fragment:xM,shadowmap_pars_fragment:_M,shadowmap_pars_vertex:yM,shadowmap_vertex:vM,shadowmask_pars_fragment:bM,skinbase_vertex:SM,skinning_pars_vertex:wM,skinning_vertex:MM,skinnormal_vertex:AM,specularmap_fragment:EM,specularmap_pars_fragment:TM,tonemapping_fragment:CM,tonemapping_pars_fragment:RM,transmission_fragment:PM,transmission_pars_fragment:IM,uv_pars_fragment:LM,uv_pars_vertex:NM,uv_vertex:DM,worldpos_vertex:kM,background_vert:OM,background_frag:UM,backgroundCube_vert:FM,backgroundCube_frag:BM,cube_vert:zM,cube_frag:VM,depth_vert:GM,depth_frag:HM,distance_vert:WM,distance_frag:$M,equirect_vert:XM,equirect_frag:qM,linedashed_vert:YM,linedashed_frag:ZM,meshbasic_vert:jM,meshbasic_frag:KM,meshlambert_vert:JM,meshlambert_frag:QM,meshmatcap_vert:e1,meshmatcap_frag:t1,meshnormal_vert:n1,meshnormal_frag:i1,meshphong_vert:s1,meshphong_frag:r1,meshphysical_vert:o1,meshphysical_frag:a1,meshtoon_vert:l1,meshtoon_frag:c1,points_vert:u1,points_frag:h1,shadow_vert:d1,shadow_frag:f1,sprite_vert:p1,sprite_frag:m1},Ne={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new rt}},envmap:{envMap:{value:null},envMapRotation:{value:new rt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new rt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new rt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new rt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new rt},normalScale:{value:new Je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new rt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new rt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new rt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new rt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0},uvTransform:{value:new rt}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new Je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new rt},alphaMap:{value:null},alphaMapTransform:{value:new rt},alphaTest:{value:0}}},rs={basic:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:Vn([Ne.common,Ne.specularmap,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:Vn([Ne.common,Ne.envmap,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.roughnessmap,Ne.metalnessmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:Vn([Ne.common,Ne.aomap,Ne.lightmap,Ne.emissivemap,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.gradientmap,Ne.fog,Ne.lights,{emissive:{value:new je(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,Ne.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:Vn([Ne.points,Ne.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:Vn([Ne.common,Ne.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:Vn([Ne.common,Ne.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:Vn([Ne.common,Ne.bumpmap,Ne.normalmap,Ne.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:Vn([Ne.sprite,Ne.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new rt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new rt}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:Vn([Ne.common,Ne.displacementmap,{referencePosition:{value:new H},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:Vn([Ne.lights,Ne.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};rs.physical={uniforms:Vn([rs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new rt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new rt},clearcoatNormalScale:{value:new Je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new rt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new rt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new rt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new rt},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new rt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new rt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new rt},transmissionSamplerSize:{value:new Je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new rt},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new rt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new rt},anisotropyVector:{value:new Je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new rt}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var vu={r:0,b:0,g:0},g1=new dt,p0=new rt;p0.set(-1,0,0,0,1,0,0,0,1);function x1(n,e,t,i,s,r){let o=new je(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let S=_.backgroundBlurriness>0;w=e.get(w,S)}return w}function p(_){let w=!1,S=f(_);S===null?m(o,a):S&&S.isColor&&(m(S,1),w=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?t.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let S=f(w);S&&S.isCubeTexture?(c===void 0&&(c=new _n(new Mo(1,1,1),new ns({name:"BackgroundCubeMaterial",uniforms:Lr(rs.backgroundCube.uniforms),vertexShader:rs.backgroundCube.vertexShader,fragmentShader:rs.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,M,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(g1.makeRotationFromEuler(w.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(p0),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,(u!==S||h!==S.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new _n(new Da(2,2),new ns({name:"BackgroundMaterial",uniforms:Lr(rs.background.uniforms),vertexShader:rs.background.vertexShader,fragmentShader:rs.background.fragmentShader,side:nr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Dt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function m(_,w){_.getRGB(vu,sf(n)),t.buffers.color.setClear(vu.r,vu.g,vu.b,w,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,m(o,a)},render:p,addToRenderList:x,dispose:g}}function _1(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(C,N,F,D,V){let $=!1,B=h(C,D,F,N);r!==B&&(r=B,c(r.object)),$=f(C,D,F,V),$&&p(C,D,F,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(C,N,F,D),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(C){return n.bindVertexArray(C)}function u(C){return n.deleteVertexArray(C)}function h(C,N,F,D){let V=D.wireframe===!0,$=i[N.id];$===void 0&&($={},i[N.id]=$);let B=C.isInstancedMesh===!0?C.id:0,ne=$[B];ne===void 0&&(ne={},$[B]=ne);let Y=ne[F.id];Y===void 0&&(Y={},ne[F.id]=Y);let K=Y[V];return K===void 0&&(K=d(l()),Y[V]=K),K}function d(C){let N=[],F=[],D=[];for(let V=0;V<t;V++)N[V]=0,F[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:F,attributeDivisors:D,object:C,attributes:{},index:null}}function f(C,N,F,D){let V=r.attributes,$=N.attributes,B=0,ne=F.getAttributes();for(let Y in ne)if(ne[Y].location>=0){let ee=V[Y],de=$[Y];if(de===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(de=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(de=C.instanceColor)),ee===void 0||ee.attribute!==de||de&&ee.data!==de.data)return!0;B++}return r.attributesNum!==B||r.index!==D}function p(C,N,F,D){let V={},$=N.attributes,B=0,ne=F.getAttributes();for(let Y in ne)if(ne[Y].location>=0){let ee=$[Y];ee===void 0&&(Y==="instanceMatrix"&&C.instanceMatrix&&(ee=C.instanceMatrix),Y==="instanceColor"&&C.instanceColor&&(ee=C.instanceColor));let de={};de.attribute=ee,ee&&ee.data&&(de.data=ee.data),V[Y]=de,B++}r.attributes=V,r.attributesNum=B,r.index=D}function x(){let C=r.newAttributes;for(let N=0,F=C.length;N<F;N++)C[N]=0}function m(C){g(C,0)}function g(C,N){let F=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;F[C]=1,D[C]===0&&(n.enableVertexAttribArray(C),D[C]=1),V[C]!==N&&(n.vertexAttribDivisor(C,N),V[C]=N)}function _(){let C=r.newAttributes,N=r.enabledAttributes;for(let F=0,D=N.length;F<D;F++)N[F]!==C[F]&&(n.disableVertexAttribArray(F),N[F]=0)}function w(C,N,F,D,V,$,B){B===!0?n.vertexAttribIPointer(C,N,F,V,$):n.vertexAttribPointer(C,N,F,D,V,$)}function S(C,N,F,D){x();let V=D.attributes,$=F.getAttributes(),B=N.defaultAttributeValues;for(let ne in $){let Y=$[ne];if(Y.location>=0){let K=V[ne];if(K===void 0&&(ne==="instanceMatrix"&&C.instanceMatrix&&(K=C.instanceMatrix),ne==="instanceColor"&&C.instanceColor&&(K=C.instanceColor)),K!==void 0){let ee=K.normalized,de=K.itemSize,ce=e.get(K);if(ce===void 0)continue;let te=ce.buffer,fe=ce.type,xe=ce.bytesPerElement,be=fe===n.INT||fe===n.UNSIGNED_INT||K.gpuType===Oc;if(K.isInterleavedBufferAttribute){let Se=K.data,$e=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,ot=K.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let We=0;We<Y.locationSize;We++)g(Y.location+We,Se.meshPerAttribute);C.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let We=0;We<Y.locationSize;We++)m(Y.location+We);n.bindBuffer(n.ARRAY_BUFFER,te);for(let We=0;We<Y.locationSize;We++)w(Y.location+We,de/Y.locationSize,fe,ee,$e*xe,(ot+de/Y.locationSize*We)*xe,be)}else{if(K.isInstancedBufferAttribute){for(let Se=0;Se<Y.locationSize;Se++)g(Y.location+Se,K.meshPerAttribute);C.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=K.meshPerAttribute*K.count)}else for(let Se=0;Se<Y.locationSize;Se++)m(Y.location+Se);n.bindBuffer(n.ARRAY_BUFFER,te);for(let Se=0;Se<Y.locationSize;Se++)w(Y.location+Se,de/Y.locationSize,fe,ee,de*xe,de/Y.locationSize*Se*xe,be)}}else if(B!==void 0){let ee=B[ne];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(Y.location,ee);break;case 3:n.vertexAttrib3fv(Y.location,ee);break;case 4:n.vertexAttrib4fv(Y.location,ee);break;default:n.vertexAttrib1fv(Y.location,ee)}}}}_()}function A(){T();for(let C in i){let N=i[C];for(let F in N){let D=N[F];for(let V in D){let $=D[V];for(let B in $)u($[B].object),delete $[B];delete D[V]}}delete i[C]}}function M(C){if(i[C.id]===void 0)return;let N=i[C.id];for(let F in N){let D=N[F];for(let V in D){let $=D[V];for(let B in $)u($[B].object),delete $[B];delete D[V]}}delete i[C.id]}function y(C){for(let N in i){let F=i[N];for(let D in F){let V=F[D];if(V[C.id]===void 0)continue;let $=V[C.id];for(let B in $)u($[B].object),delete $[B];delete V[C.id]}}}function v(C){for(let N in i){let F=i[N],D=C.isInstancedMesh===!0?C.id:0,V=F[D];if(V!==void 0){for(let $ in V){let B=V[$];for(let ne in B)u(B[ne].object),delete B[ne];delete V[$]}delete F[D],Object.keys(F).length===0&&delete i[N]}}}function T(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:T,resetDefaultState:P,dispose:A,releaseStatesOfGeometry:M,releaseStatesOfObject:v,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:m,disableUnusedAttributes:_}}function y1(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function v1(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ui&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let v=y===Oi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ti&&y!==Mi&&!v&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ke("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:S,maxSamples:A,samples:M}}function b1(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ui,a=new rt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let _=r?0:i,w=_*4,S=g.clippingState||null;l.value=S,S=u(p,d,w,f);for(let A=0;A!==w;++A)S[A]=t[A];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,p){let x=h!==null?h.length:0,m=null;if(x!==0){if(m=l.value,p!==!0||m===null){let g=f+x*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(m===null||m.length<g)&&(m=new Float32Array(g));for(let w=0,S=f;w!==x;++w,S+=4)o.copy(h[w]).applyMatrix4(_,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,m}}var Qa=class extends di{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ia(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Mo(5,5,5),r=new ns({name:"CubemapFromEquirect",uniforms:Lr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:Cr});r.uniforms.tEquirect.value=t;let o=new _n(s,r),a=t.minFilter;return t.minFilter===Cs&&(t.minFilter=Zn),new Eo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Xg=256,S1=3,w1=20,m0=256,g0=16,M1=3,A1=new H,E1=new je,Su=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Eo(1,10,null),this._boxMesh=new _n(new Mo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=A1}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(E1));let m=new Eo(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Zg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Yg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Xg,ef(e))}_fromTexture(e,t){e.mapping===Pr||e.mapping===Po?this._setSize(e.image.length===0?Xg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=qg(e,!1,!1),i=Math.log2(e)-S1;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=qg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Pr||e.mapping===Po?(this._cubemapMaterial===null&&(this._cubemapMaterial=Zg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Yg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=T1(),this._integrationMaterial=C1());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/g0);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-M1)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(m0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=R1());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function qg(n,e,t){return new Qa(n,{minFilter:Cs,generateMipmaps:e,type:Oi,colorSpace:Sa,depthBuffer:t})}function el(n,e,t){return new ns({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:jn,blending:Cr,depthTest:!1,depthWrite:!1})}function T1(){return el("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${m0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function C1(){return el("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:g0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function R1(){return el("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${w1}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Yg(){return el("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Zg(){return el("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function P1(n){let e=new WeakMap,t=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Nc||f===Dc)if(e.has(d)){let p=e.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new Qa(p.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Nc||f===Dc,x=f===Pr||f===Po;if(p||x){let m=t.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new Su(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let _=d.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new Su(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===Nc?d.mapping=Pr:f===Dc&&(d.mapping=Po),d}function l(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function I1(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&_a("WebGLRenderer: "+i+" extension not supported."),s}}}function L1(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(e.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(p){let x=p.attributes;for(let m in x)e.update(x[m],n.ARRAY_BUFFER)}function h(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let _=x!==null?x.array.length:m.array.length/3-1,w=m.count>=65535?Ca:Ta,S=new w(Math.ceil(_/3)*6,1),A=S.array;if(x!==null){let y=x.array;g=x.version;for(let v=0,T=0;v<_;v+=3){let P=y[v+0],C=y[v+1],N=y[v+2];A[T++]=P,A[T++]=C,A[T++]=C,A[T++]=N,A[T++]=N,A[T++]=P}}else{g=m.version;for(let y=0,v=0;y<_;y+=3){let T=y+0,P=y+1,C=y+2;A[v++]=T,A[v++]=P,A[v++]=P,A[v++]=C,A[v++]=C,A[v++]=T}}S.version=g;let M=r.get(p);M&&e.remove(M),r.set(p,S)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function N1(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];t.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function D1(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function k1(n,e,t){let i=new WeakMap,s=new Gt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let T=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",T)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;f===!0&&(w=1),p===!0&&(w=2),x===!0&&(w=3);let S=a.attributes.position.count*w,A=1;S>e.maxTextureSize&&(A=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let M=new Float32Array(S*A*4*h),y=new Aa(M,S,A,h);y.type=Mi,y.needsUpdate=!0;let v=w*4;for(let P=0;P<h;P++){let C=m[P],N=g[P],F=_[P],D=S*A*4*P;for(let V=0;V<C.count;V++){let $=V*v;f===!0&&(s.fromBufferAttribute(C,V),M[D+$+0]=s.x,M[D+$+1]=s.y,M[D+$+2]=s.z,M[D+$+3]=0),p===!0&&(s.fromBufferAttribute(N,V),M[D+$+4]=s.x,M[D+$+5]=s.y,M[D+$+6]=s.z,M[D+$+7]=0),x===!0&&(s.fromBufferAttribute(F,V),M[D+$+8]=s.x,M[D+$+9]=s.y,M[D+$+10]=s.z,M[D+$+11]=F.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Je(S,A)},i.set(a,d),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function O1(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var U1={[Ld]:"LINEAR_TONE_MAPPING",[Nd]:"REINHARD_TONE_MAPPING",[Dd]:"CINEON_TONE_MAPPING",[kd]:"ACES_FILMIC_TONE_MAPPING",[Ud]:"AGX_TONE_MAPPING",[Fd]:"NEUTRAL_TONE_MAPPING",[Od]:"CUSTOM_TONE_MAPPING"};function F1(n,e,t,i,s,r){let o=new di(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new bn;u.setAttribute("position",new an([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new an([0,2,0,0,2,0],2));let h=new xc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new _n(u,h),f=new Ba(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,_=null,w=[],S=!1;this.setSize=function(A,M){o.setSize(A,M),a!==null&&a.setSize(A,M),l!==null&&l.setSize(A,M);for(let y=0;y<w.length;y++){let v=w[y];v.setSize&&v.setSize(A,M)}},this.setEffects=function(A){w=A,S=w.length>0&&w[0].isRenderPass===!0;let M=o.width,y=o.height;w.length>0&&a===null&&(a=new di(M,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}),l=new di(M,y,{type:Oi,depthBuffer:!1,stencilBuffer:!1}));let v=s===!0&&w.some(T=>T.needsDepthTexture===!0);v!==(o.depthTexture!==null)&&(v===!0&&c===null&&(c=new Es(M,y),r===!0&&(c.format=Rs,c.type=Ir)),o.dispose(),o.depthTexture=v?c:null,o.resolveDepthBuffer=v,o.storeMultisampledDepthBuffer=v);for(let T=0;T<w.length;T++){let P=w[T];P.setSize&&P.setSize(M,y),v&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(A,M){if(m||A.toneMapping===is&&w.length===0)return!1;if(_=M,M!==null){let y=M.width,v=M.height;(o.width!==y||o.height!==v)&&this.setSize(y,v)}return S===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=is,!0},this.hasRenderPass=function(){return S},this.end=function(A,M){A.toneMapping=g,m=!0;let y=o,v=a;for(let T=0;T<w.length;T++){let P=w[T];P.enabled!==!1&&(P.render(A,v,y,M),P.needsSwap!==!1&&(y=v,v=v===a?l:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,h.defines={},St.getTransfer(p)===Dt&&(h.defines.SRGB_TRANSFER="");let T=U1[x];T&&(h.defines[T]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(_),A.render(d,f),_=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var x0=new ei,_0=new Es(1,1),y0=new La(1),v0=new Aa,b0=new dc,S0=new Ia,jg=[],Kg=[],Jg=new Float32Array(16),Qg=new Float32Array(9),e0=new Float32Array(4);function Do(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=jg[s];if(r===void 0&&(r=new Float32Array(s),jg[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Sn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function wn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Mu(n,e){let t=Kg[e];t===void 0&&(t=new Int32Array(e),Kg[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function B1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function z1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2fv(this.addr,e),wn(t,e)}}function V1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Sn(t,e))return;n.uniform3fv(this.addr,e),wn(t,e)}}function G1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4fv(this.addr,e),wn(t,e)}}function H1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;e0.set(i),n.uniformMatrix2fv(this.addr,!1,e0),wn(t,i)}}function W1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;Qg.set(i),n.uniformMatrix3fv(this.addr,!1,Qg),wn(t,i)}}function $1(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Sn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),wn(t,e)}else{if(Sn(t,i))return;Jg.set(i),n.uniformMatrix4fv(this.addr,!1,Jg),wn(t,i)}}function X1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2iv(this.addr,e),wn(t,e)}}function Y1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3iv(this.addr,e),wn(t,e)}}function Z1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4iv(this.addr,e),wn(t,e)}}function j1(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function K1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Sn(t,e))return;n.uniform2uiv(this.addr,e),wn(t,e)}}function J1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Sn(t,e))return;n.uniform3uiv(this.addr,e),wn(t,e)}}function Q1(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Sn(t,e))return;n.uniform4uiv(this.addr,e),wn(t,e)}}function Au(n){return n.version===0&&(n.compareFunction=jd,n.needsUpdate=!0),n}function eA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Au(_0):r=x0,t.setTexture2D(e||r,s)}function tA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||b0,s)}function nA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Au(y0):r=S0,t.setTextureCube(e||r,s)}function iA(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||v0,s)}function sA(n){switch(n){case 5126:return B1;case 35664:return z1;case 35665:return V1;case 35666:return G1;case 35674:return H1;case 35675:return W1;case 35676:return $1;case 5124:case 35670:return X1;case 35667:case 35671:return q1;case 35668:case 35672:return Y1;case 35669:case 35673:return Z1;case 5125:return j1;case 36294:return K1;case 36295:return J1;case 36296:return Q1;case 35678:case 36198:case 36298:case 36306:case 35682:return eA;case 35679:case 36299:case 36307:return tA;case 35680:case 36300:case 36308:case 36293:return nA;case 36289:case 36303:case 36311:case 36292:return iA}}function rA(n,e){n.uniform1fv(this.addr,e)}function oA(n,e){let t=Do(e,this.size,2);n.uniform2fv(this.addr,t)}function aA(n,e){let t=Do(e,this.size,3);n.uniform3fv(this.addr,t)}function lA(n,e){let t=Do(e,this.size,4);n.uniform4fv(this.addr,t)}function cA(n,e){let t=Do(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function uA(n,e){let t=Do(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function hA(n,e){let t=Do(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function dA(n,e){n.uniform1iv(this.addr,e)}function fA(n,e){n.uniform2iv(this.addr,e)}function pA(n,e){n.uniform3iv(this.addr,e)}function mA(n,e){n.uniform4iv(this.addr,e)}function gA(n,e){n.uniform1uiv(this.addr,e)}function xA(n,e){n.uniform2uiv(this.addr,e)}function _A(n,e){n.uniform3uiv(this.addr,e)}function yA(n,e){n.uniform4uiv(this.addr,e)}function vA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Au(_0):o=x0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function bA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||b0,r[o])}function SA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Au(y0):o=S0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function wA(n,e,t){let i=this.cache,s=e.length,r=Mu(t,s);Sn(i,r)||(n.uniform1iv(this.addr,r),wn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||v0,r[o])}function MA(n){switch(n){case 5126:return rA;case 35664:return oA;case 35665:return aA;case 35666:return lA;case 35674:return cA;case 35675:return uA;case 35676:return hA;case 5124:case 35670:return dA;case 35667:case 35671:return fA;case 35668:case 35672:return pA;case 35669:case 35673:return mA;case 5125:return gA;case 36294:return xA;case 36295:return _A;case 36296:return yA;case 35678:case 36198:case 36298:case 36306:case 35682:return vA;case 35679:case 36299:case 36307:return bA;case 35680:case 36300:case 36308:case 36293:return SA;case 36289:case 36303:case 36311:case 36292:return wA}}var uf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=sA(t.type)}},hf=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=MA(t.type)}},df=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},lf=/(\w+)(\])?(\[|\.)?/g;function t0(n,e){n.seq.push(e),n.map[e.id]=e}function AA(n,e,t){let i=n.name,s=i.length;for(lf.lastIndex=0;;){let r=lf.exec(i),o=lf.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){t0(t,c===void 0?new uf(a,n,e):new hf(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new df(a),t0(t,h)),t=h}}}var No=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);AA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function n0(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var EA=37297,TA=0;function CA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var i0=new rt;function RA(n){St._getMatrix(i0,St.workingColorSpace,n);let e=`mat3( ${i0.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case wa:return[e,"LinearTransferOETF"];case Dt:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function s0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+CA(n.getShaderSource(e),a)}else return r}function PA(n,e){let t=RA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var IA={[Ld]:"Linear",[Nd]:"Reinhard",[Dd]:"Cineon",[kd]:"ACESFilmic",[Ud]:"AgX",[Fd]:"Neutral",[Od]:"Custom"};function LA(n,e){let t=IA[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bu=new H;function NA(){St.getLuminanceCoefficients(bu);let n=bu.x.toFixed(4),e=bu.y.toFixed(4),t=bu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function DA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ja).join(`
`)}function kA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function OA(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ja(n){return n!==""}function r0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function o0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var UA=/^[ \t]*#include +<([\w\d./]+)>/gm;function ff(n){return n.replace(UA,FA)}function FA(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ff(t)}var BA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function a0(n){return n.replace(BA,zA)}function zA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function l0(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var VA={[Ga]:"SHADOWMAP_TYPE_PCF",[Co]:"SHADOWMAP_TYPE_VSM"};function GA(n){return VA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var HA={[Po]:"ENVMAP_MODE_REFRACTION"};function WA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":HA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var $A={[Lc]:"ENVMAP_BLENDING_MULTIPLY",[Mg]:"ENVMAP_BLENDING_MIX",[Ag]:"ENVMAP_BLENDING_ADD"};function XA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":$A[n.combine]||"ENVMAP_BLENDING_NONE"}function qA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=GA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=WA(t),h=XA(t),d=DA(t),f=kA(r),p=s.createProgram(),x,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ja).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ja).join(`
`),m.length>0&&(m+=`
`)):(x=[l0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ja).join(`
`),m=[l0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==is?"#define TONE_MAPPING":"",t.toneMapping!==is?pt.tonemapping_pars_fragment:"",t.toneMapping!==is?LA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,PA("linearToOutputTexel",t.outputColorSpace),NA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ja).join(`
`)),o=ff(o),o=r0(o,t),o=o0(o,t),a=ff(a),a=r0(a,t),a=o0(a,t),o=a0(o),a=a0(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",t.glslVersion===Kd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let _=g+x+o,w=g+m+a,S=n0(s,s.VERTEX_SHADER,_),A=n0(s,s.FRAGMENT_SHADER,w);s.attachShader(p,S),s.attachShader(p,A),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(n.debug.checkShaderErrors){let C=s.getProgramInfoLog(p)||"",N=s.getShaderInfoLog(S)||"",F=s.getShaderInfoLog(A)||"",D=C.trim(),V=N.trim(),$=F.trim(),B=!0,ne=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(B=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,A);else{let Y=s0(s,S,"vertex"),K=s0(s,A,"fragment");st("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+D+`
`+Y+`
`+K)}else D!==""?Ke("WebGLProgram: Program Info Log:",D):(V===""||$==="")&&(ne=!1);ne&&(P.diagnostics={runnable:B,programLog:D,vertexShader:{log:V,prefix:x},fragmentShader:{log:$,prefix:m}})}s.deleteShader(S),s.deleteShader(A),y=new No(s,p),v=OA(s,p)}let y;this.getUniforms=function(){return y===void 0&&M(this),y};let v;this.getAttributes=function(){return v===void 0&&M(this),v};let T=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return T===!1&&(T=s.getProgramParameter(p,EA)),T},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=TA++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=A,this}var YA=0,pf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new mf(e),t.set(e,i)),i}},mf=class{constructor(e){this.id=YA++,this.code=e,this.usedTimes=0}};function ZA(n){return n===ir||n===Ya||n===Za}function jA(n,e,t,i,s,r){let o=new So,a=new pf,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,v,T,P,C,N){let F=P.fog,D=C.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,B=e.get(y.envMap||V,$),ne=d[y.type],Y=i.precision;y.precision!==null&&(Y=i.getMaxPrecision(y.precision),Y!==y.precision&&Ke("WebGLProgram.getParameters:",y.precision,"not supported, using",Y,"instead."));let K=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ee=K!==void 0?K.length:0,de=0;D.morphAttributes.position!==void 0&&(de=1),D.morphAttributes.normal!==void 0&&(de=2),D.morphAttributes.color!==void 0&&(de=3);let ce,te,fe,xe;if(ne){let Pe=rs[ne];ce=Pe.vertexShader,te=Pe.fragmentShader}else{ce=y.vertexShader,te=y.fragmentShader;let Pe=a.getVertexShaderStage(y),ht=a.getFragmentShaderStage(y);a.update(y,Pe,ht),fe=Pe.id,xe=ht.id}let be=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),$e=C.isInstancedMesh===!0,ot=C.isBatchedMesh===!0,We=!!y.map,lt=!!y.matcap,ct=!!B,et=ct&&B.isPMREMTexture===!0,$t=!!y.aoMap,Bt=!!y.lightMap,en=!!y.bumpMap&&y.wireframe===!1,At=!!y.normalMap,dn=!!y.displacementMap,vt=!!y.emissiveMap,we=!!y.metalnessMap,Fe=!!y.roughnessMap,Ze=y.anisotropy>0,z=y.clearcoat>0,pe=y.diffuseRoughness>0,ke=y.dispersion>0,Qe=y.retroreflectivity>0,ye=y.iridescence>0,Et=y.sheen>0,ze=y.transmission>0,Ye=Ze&&!!y.anisotropyMap,k=z&&!!y.clearcoatMap,R=z&&!!y.clearcoatNormalMap,q=z&&!!y.clearcoatRoughnessMap,ue=pe&&!!y.diffuseRoughnessMap,ae=ye&&!!y.iridescenceMap,ve=ye&&!!y.iridescenceThicknessMap,Me=Et&&!!y.sheenColorMap,ie=Et&&!!y.sheenRoughnessMap,re=!!y.specularMap,ge=!!y.specularColorMap,G=!!y.specularIntensityMap,oe=ze&&!!y.transmissionMap,se=ze&&!!y.thicknessMap,Te=!!y.gradientMap,_e=!!y.alphaMap,Ee=y.alphaTest>0,Xe=!!y.alphaHash,nt=!!y.extensions,he=is;y.toneMapped&&(be===null||be.isXRRenderTarget===!0)&&(he=n.toneMapping);let Ve=et?B.isCompressedCubeTexture?B.image[0].mipmaps:B.mipmaps:null,it={shaderID:ne,shaderType:y.type,shaderName:y.name,vertexShader:ce,fragmentShader:te,defines:y.defines,customVertexShaderID:fe,customFragmentShaderID:xe,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Y,batching:ot,batchingColor:ot&&C._colorsTexture!==null,instancing:$e,instancingColor:$e&&C.instanceColor!==null,instancingMorph:$e&&C.morphTexture!==null,outputColorSpace:be===null?n.outputColorSpace:be.isXRRenderTarget===!0?be.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:We,matcap:lt,envMap:ct,envMapMode:ct&&B.mapping,envMapPMREM:et,envMapMaxLod:et?Ve.length-1:null,envMapSize:et?Ve[0].width:null,aoMap:$t,lightMap:Bt,bumpMap:en,normalMap:At,displacementMap:dn,emissiveMap:vt,normalMapObjectSpace:At&&y.normalMapType===Cg,normalMapTangentSpace:At&&y.normalMapType===yu,packedNormalMap:At&&y.normalMapType===yu&&ZA(y.normalMap.format),metalnessMap:we,roughnessMap:Fe,anisotropy:Ze,anisotropyMap:Ye,clearcoat:z,clearcoatMap:k,clearcoatNormalMap:R,clearcoatRoughnessMap:q,diffuseRoughness:pe,diffuseRoughnessMap:ue,dispersion:ke,retroreflection:Qe,iridescence:ye,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:Et,sheenColorMap:Me,sheenRoughnessMap:ie,specularMap:re,specularColorMap:ge,specularIntensityMap:G,transmission:ze,transmissionMap:oe,thicknessMap:se,gradientMap:Te,opaque:y.transparent===!1&&y.blending===Ro&&y.alphaToCoverage===!1,alphaMap:_e,alphaTest:Ee,alphaHash:Xe,combine:y.combine,mapUv:We&&f(y.map.channel),aoMapUv:$t&&f(y.aoMap.channel),lightMapUv:Bt&&f(y.lightMap.channel),bumpMapUv:en&&f(y.bumpMap.channel),normalMapUv:At&&f(y.normalMap.channel),displacementMapUv:dn&&f(y.displacementMap.channel),emissiveMapUv:vt&&f(y.emissiveMap.channel),metalnessMapUv:we&&f(y.metalnessMap.channel),roughnessMapUv:Fe&&f(y.roughnessMap.channel),anisotropyMapUv:Ye&&f(y.anisotropyMap.channel),clearcoatMapUv:k&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:R&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ie&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:ge&&f(y.specularColorMap.channel),specularIntensityMapUv:G&&f(y.specularIntensityMap.channel),transmissionMapUv:oe&&f(y.transmissionMap.channel),thicknessMapUv:se&&f(y.thicknessMap.channel),alphaMapUv:_e&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(At||Ze),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:C.isPoints===!0&&!!D.attributes.uv&&(We||_e),fog:!!F,useFog:y.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&At===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:C.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:de,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:N.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&T.length>0,shadowMapType:n.shadowMap.type,toneMapping:he,decodeVideoTexture:We&&y.map.isVideoTexture===!0&&St.getTransfer(y.map.colorSpace)===Dt,decodeVideoTextureEmissive:vt&&y.emissiveMap.isVideoTexture===!0&&St.getTransfer(y.emissiveMap.colorSpace)===Dt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===zn,flipSided:y.side===jn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:nt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&y.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return it.vertexUv1s=l.has(1),it.vertexUv2s=l.has(2),it.vertexUv3s=l.has(3),l.clear(),it}function x(y){let v=[];if(y.shaderID?v.push(y.shaderID):(v.push(y.customVertexShaderID),v.push(y.customFragmentShaderID)),y.defines!==void 0)for(let T in y.defines)v.push(T),v.push(y.defines[T]);return y.isRawShaderMaterial===!1&&(m(v,y),g(v,y),v.push(n.outputColorSpace)),v.push(y.customProgramCacheKey),v.join()}function m(y,v){y.push(v.precision),y.push(v.outputColorSpace),y.push(v.envMapMode),y.push(v.envMapPMREM),y.push(v.envMapMaxLod),y.push(v.envMapSize),y.push(v.mapUv),y.push(v.alphaMapUv),y.push(v.lightMapUv),y.push(v.aoMapUv),y.push(v.bumpMapUv),y.push(v.normalMapUv),y.push(v.displacementMapUv),y.push(v.emissiveMapUv),y.push(v.metalnessMapUv),y.push(v.roughnessMapUv),y.push(v.anisotropyMapUv),y.push(v.clearcoatMapUv),y.push(v.clearcoatNormalMapUv),y.push(v.clearcoatRoughnessMapUv),y.push(v.diffuseRoughnessMapUv),y.push(v.iridescenceMapUv),y.push(v.iridescenceThicknessMapUv),y.push(v.sheenColorMapUv),y.push(v.sheenRoughnessMapUv),y.push(v.specularMapUv),y.push(v.specularColorMapUv),y.push(v.specularIntensityMapUv),y.push(v.transmissionMapUv),y.push(v.thicknessMapUv),y.push(v.combine),y.push(v.fogExp2),y.push(v.sizeAttenuation),y.push(v.morphTargetsCount),y.push(v.numSunLights),y.push(v.numDirLights),y.push(v.numPointLights),y.push(v.numSpotLights),y.push(v.numSpotLightMaps),y.push(v.numHemiLights),y.push(v.numRectAreaLights),y.push(v.numSunLightShadows),y.push(v.numDirLightShadows),y.push(v.numPointLightShadows),y.push(v.numSpotLightShadows),y.push(v.numSpotLightShadowsWithMaps),y.push(v.numLightProbes),y.push(v.numLightProbeGrids),y.push(v.shadowMapType),y.push(v.toneMapping),y.push(v.numClippingPlanes),y.push(v.numClipIntersection),y.push(v.depthPacking)}function g(y,v){o.disableAll(),v.instancing&&o.enable(0),v.instancingColor&&o.enable(1),v.instancingMorph&&o.enable(2),v.matcap&&o.enable(3),v.envMap&&o.enable(4),v.normalMapObjectSpace&&o.enable(5),v.normalMapTangentSpace&&o.enable(6),v.clearcoat&&o.enable(7),v.iridescence&&o.enable(8),v.alphaTest&&o.enable(9),v.vertexColors&&o.enable(10),v.vertexAlphas&&o.enable(11),v.vertexUv1s&&o.enable(12),v.vertexUv2s&&o.enable(13),v.vertexUv3s&&o.enable(14),v.vertexTangents&&o.enable(15),v.anisotropy&&o.enable(16),v.alphaHash&&o.enable(17),v.batching&&o.enable(18),v.dispersion&&o.enable(19),v.retroreflection&&o.enable(24),v.diffuseRoughness&&o.enable(25),v.batchingColor&&o.enable(20),v.gradientMap&&o.enable(21),v.packedNormalMap&&o.enable(22),v.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),v.fog&&o.enable(0),v.useFog&&o.enable(1),v.flatShading&&o.enable(2),v.logarithmicDepthBuffer&&o.enable(3),v.reversedDepthBuffer&&o.enable(4),v.skinning&&o.enable(5),v.morphTargets&&o.enable(6),v.morphNormals&&o.enable(7),v.morphColors&&o.enable(8),v.premultipliedAlpha&&o.enable(9),v.shadowMapEnabled&&o.enable(10),v.doubleSided&&o.enable(11),v.flipSided&&o.enable(12),v.useDepthPacking&&o.enable(13),v.dithering&&o.enable(14),v.transmission&&o.enable(15),v.sheen&&o.enable(16),v.opaque&&o.enable(17),v.pointsUvs&&o.enable(18),v.decodeVideoTexture&&o.enable(19),v.decodeVideoTextureEmissive&&o.enable(20),v.alphaToCoverage&&o.enable(21),v.numLightProbeGrids>0&&o.enable(22),v.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let v=d[y.type],T;if(v){let P=rs[v];T=Hg.clone(P.uniforms)}else T=y.uniforms;return T}function w(y,v){let T=u.get(v);return T!==void 0?++T.usedTimes:(T=new qA(n,v,y,s),c.push(T),u.set(v,T)),T}function S(y){if(--y.usedTimes===0){let v=c.indexOf(y);c[v]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:S,releaseShaderCache:A,programs:c,dispose:M}}function KA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function JA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function c0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function u0(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let _=n[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=x,_.renderOrder=d.renderOrder,_.z=m,_.group=g),e++,_}function l(d,f,p,x,m,g,_){_.reversedDepth===!0&&(m=-m);let w=a(d,f,p,x,m,g);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):t.push(w)}function c(d,f,p,x,m,g){let _=a(d,f,p,x,m,g);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):t.unshift(_)}function u(d,f){t.length>1&&t.sort(d||JA),i.length>1&&i.sort(f||c0),s.length>1&&s.sort(f||c0)}function h(){for(let d=e,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function QA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new u0,n.set(i,[o])):s>=r.length?(o=new u0,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function eE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new H,color:new je};break;case"SpotLight":t={position:new H,direction:new H,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new H,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new H,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new H,halfWidth:new H,halfHeight:new H};break}return n[e.id]=t,t}}}function tE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var nE=0;function iE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function sE(n){let e=new eE,t=tE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new H);let s=new H,r=new dt,o=new dt;function a(c){let u=0,h=0,d=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,_=0,w=0,S=0,A=0,M=0,y=0,v=0,T=0,P=0;c.sort(iE);for(let N=0,F=c.length;N<F;N++){let D=c[N],V=D.color,$=D.intensity,B=D.distance,ne=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===ir?ne=D.shadow.map.texture:ne=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=V.r*$,h+=V.g*$,d+=V.b*$;else if(D.isLightProbe){for(let Y=0;Y<9;Y++)i.probe[Y].addScaledVector(D.sh.coefficients[Y],$);P++}else if(D.isSunLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize.copy(K.mapSize).multiply(K.getFrameExtents()),i.sunShadow[p]=ee,i.sunShadowMap[p]=ne;let de=K.getViewportCount();for(let ce=0;ce<de;ce++)i.sunShadowMatrix[x+ce]=K.getMatrix(ce),i.sunShadowCascade[x+ce]=K._cascadeData[ce];x+=de,p++}i.sun[f]=Y,f++}else if(D.isDirectionalLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,i.directionalShadow[m]=ee,i.directionalShadowMap[m]=ne,i.directionalShadowMatrix[m]=D.shadow.matrix,A++}i.directional[m]=Y,m++}else if(D.isSpotLight){let Y=e.get(D);Y.position.setFromMatrixPosition(D.matrixWorld),Y.color.copy(V).multiplyScalar($),Y.distance=B,Y.coneCos=Math.cos(D.angle),Y.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Y.decay=D.decay,i.spot[_]=Y;let K=D.shadow;if(D.map&&(i.spotLightMap[v]=D.map,v++,K.updateMatrices(D),D.castShadow&&T++),i.spotLightMatrix[_]=K.matrix,D.castShadow){let ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,i.spotShadow[_]=ee,i.spotShadowMap[_]=ne,y++}_++}else if(D.isRectAreaLight){let Y=e.get(D);Y.color.copy(V).multiplyScalar($),Y.halfWidth.set(D.width*.5,0,0),Y.halfHeight.set(0,D.height*.5,0),i.rectArea[w]=Y,w++}else if(D.isPointLight){let Y=e.get(D);if(Y.color.copy(D.color).multiplyScalar(D.intensity),Y.distance=D.distance,Y.decay=D.decay,D.castShadow){let K=D.shadow,ee=t.get(D);ee.shadowIntensity=K.intensity,ee.shadowBias=K.bias,ee.shadowNormalBias=K.normalBias,ee.shadowRadius=K.radius,ee.shadowMapSize=K.mapSize,ee.shadowCameraNear=K.camera.near,ee.shadowCameraFar=K.camera.far,i.pointShadow[g]=ee,i.pointShadowMap[g]=ne,i.pointShadowMatrix[g]=D.shadow.matrix,M++}i.point[g]=Y,g++}else if(D.isHemisphereLight){let Y=e.get(D);Y.skyColor.copy(D.color).multiplyScalar($),Y.groundColor.copy(D.groundColor).multiplyScalar($),i.hemi[S]=Y,S++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ne.LTC_FLOAT_1,i.rectAreaLTC2=Ne.LTC_FLOAT_2):(i.rectAreaLTC1=Ne.LTC_HALF_1,i.rectAreaLTC2=Ne.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let C=i.hash;(C.sunLength!==f||C.directionalLength!==m||C.pointLength!==g||C.spotLength!==_||C.rectAreaLength!==w||C.hemiLength!==S||C.numSunShadows!==p||C.numDirectionalShadows!==A||C.numPointShadows!==M||C.numSpotShadows!==y||C.numSpotMaps!==v||C.numLightProbes!==P)&&(i.sun.length=f,i.directional.length=m,i.spot.length=_,i.rectArea.length=w,i.point.length=g,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+v-T,i.spotLightMap.length=v,i.numSpotLightShadowsWithMaps=T,i.numLightProbes=P,C.sunLength=f,C.directionalLength=m,C.pointLength=g,C.spotLength=_,C.rectAreaLength=w,C.hemiLength=S,C.numSunShadows=p,C.numDirectionalShadows=A,C.numPointShadows=M,C.numSpotShadows=y,C.numSpotMaps=v,C.numLightProbes=P,i.version=nE++)}function l(c,u){let h=0,d=0,f=0,p=0,x=0,m=0,g=u.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let S=c[_];if(S.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(S.matrixWorld),A.direction.transformDirection(g),h++}else if(S.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(S.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(S.width*.5,0,0),A.halfHeight.set(0,S.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(S.matrixWorld),A.position.applyMatrix4(g),f++}else if(S.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(S.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function h0(n){let e=new sE(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function rE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new h0(n),e.set(s,[a])):r>=o.length?(a=new h0(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var oE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,aE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,lE=[new H(1,0,0),new H(-1,0,0),new H(0,1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1)],cE=[new H(0,-1,0),new H(0,-1,0),new H(0,0,1),new H(0,0,-1),new H(0,-1,0),new H(0,-1,0)],d0=new dt,Ka=new H,cf=new H;function uE(n,e,t){let i=new Zs,s=new Je,r=new Je,o=new Gt,a=new _c,l=new yc,c={},u=t.maxTextureSize,h={[nr]:jn,[jn]:nr,[zn]:zn},d=new ns({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Je},radius:{value:4}},vertexShader:oE,fragmentShader:aE}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new bn;p.setAttribute("position",new un(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new _n(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ga;let g=this.type;this.render=function(M,y,v){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||M.length===0)return;this.type===rg&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ga);let T=n.getRenderTarget(),P=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),N=n.state;N.setBlending(Cr),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let F=g!==this.type;F&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=M.length;D<V;D++){let $=M[D],B=$.shadow;if(B===void 0){Ke("WebGLShadowMap:",$,"has no shadow.");continue}if(B.autoUpdate===!1&&B.needsUpdate===!1)continue;s.copy(B.mapSize);let ne=B.getFrameExtents();s.multiply(ne),r.copy(B.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ne.x),s.x=r.x*ne.x,B.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ne.y),s.y=r.y*ne.y,B.mapSize.y=r.y));let Y=n.state.buffers.depth.getReversed();if(B.camera._reversedDepth=Y,B.map===null||F===!0){if(B.map!==null&&(B.map.depthTexture!==null&&(B.map.depthTexture.dispose(),B.map.depthTexture=null),B.map.dispose()),this.type===Co){if($.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}B.map=new di(s.x,s.y,{format:ir,type:Oi,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),B.map.texture.name=$.name+".shadowMap",B.map.depthTexture=new Es(s.x,s.y,Mi),B.map.depthTexture.name=$.name+".shadowMapDepth",B.map.depthTexture.format=bs,B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Nn,B.map.depthTexture.magFilter=Nn}else $.isPointLight?(B.map=new Qa(s.x),B.map.depthTexture=new La(s.x,ki)):(B.map=new di(s.x,s.y),B.map.depthTexture=new Es(s.x,s.y,ki)),B.map.depthTexture.name=$.name+".shadowMap",B.map.depthTexture.format=bs,this.type===Ga?(B.map.depthTexture.compareFunction=Y?Zd:Yd,B.map.depthTexture.minFilter=Zn,B.map.depthTexture.magFilter=Zn):(B.map.depthTexture.compareFunction=null,B.map.depthTexture.minFilter=Nn,B.map.depthTexture.magFilter=Nn);B.camera.updateProjectionMatrix()}B.map.isWebGLCubeRenderTarget!==!0&&(B.map.width!==s.x||B.map.height!==s.y)&&B.map.setSize(s.x,s.y);let K=B.map.isWebGLCubeRenderTarget?6:B.getViewportCount();$.isPointLight!==!0&&B.updateMatrices($,v);let ee=(B.camera.layers.mask&4294967294)!==0?B.camera.layers:v.layers;for(let de=0;de<K;de++){let ce=B.getCamera(de);if($.isPointLight){let te=B.camera,fe=B.matrix,xe=$.distance||te.far;xe!==te.far&&(te.far=xe,te.updateProjectionMatrix()),Ka.setFromMatrixPosition($.matrixWorld),te.position.copy(Ka),cf.copy(te.position),cf.add(lE[de]),te.up.copy(cE[de]),te.lookAt(cf),te.updateMatrixWorld(),fe.makeTranslation(-Ka.x,-Ka.y,-Ka.z),d0.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),B._frustum.setFromProjectionMatrix(d0,te.coordinateSystem,te.reversedDepth)}if(B.map.isWebGLCubeRenderTarget)n.setRenderTarget(B.map,de),n.clear();else{de===0&&(n.setRenderTarget(B.map),n.clear());let te=B.getViewport(de);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),N.viewport(o)}i=B.getFrustum(de),S(y,v,ce,$,ee,this.type)}B.isPointLightShadow!==!0&&this.type===Co&&_(B,v),B.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(T,P,C)};function _(M,y){let v=e.update(x);d.defines.VSM_SAMPLES!==M.blurSamples&&(d.defines.VSM_SAMPLES=M.blurSamples,f.defines.VSM_SAMPLES=M.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),M.mapPass===null?M.mapPass=new di(s.x,s.y,{format:ir,type:Oi}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),d.uniforms.shadow_pass.value=M.map.depthTexture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(y,null,v,d,x,null),f.uniforms.shadow_pass.value=M.mapPass.texture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(y,null,v,f,x,null)}function w(M,y,v,T){let P=null,C=v.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(C!==void 0)P=C;else if(P=v.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let N=P.uuid,F=y.uuid,D=c[N];D===void 0&&(D={},c[N]=D);let V=D[F];V===void 0&&(V=P.clone(),D[F]=V,y.addEventListener("dispose",A)),P=V}if(P.visible=y.visible,P.wireframe=y.wireframe,T===Co?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:h[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,v.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let N=n.properties.get(P);N.light=v}return P}function S(M,y,v,T,P,C){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&C===Co)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,M.matrixWorld);let D=e.update(M),V=M.material;if(Array.isArray(V)){let $=D.groups;for(let B=0,ne=$.length;B<ne;B++){let Y=$[B],K=V[Y.materialIndex];if(K&&K.visible){let ee=w(M,K,T,C);M.onBeforeShadow(n,M,y,v,D,ee,Y),n.renderBufferDirect(v,null,D,ee,M,Y),M.onAfterShadow(n,M,y,v,D,ee,Y)}}}else if(V.visible){let $=w(M,V,T,C);M.onBeforeShadow(n,M,y,v,D,$,null),n.renderBufferDirect(v,null,D,$,M,null),M.onAfterShadow(n,M,y,v,D,$,null)}}let F=M.children;for(let D=0,V=F.length;D<V;D++)S(F[D],y,v,T,P,C)}function A(M){M.target.removeEventListener("dispose",A);for(let v in c){let T=c[v],P=M.target.uuid;P in T&&(T[P].dispose(),delete T[P])}}}function hE(n,e){function t(){let G=!1,oe=new Gt,se=null,Te=new Gt(0,0,0,0);return{setMask:function(_e){se!==_e&&!G&&(n.colorMask(_e,_e,_e,_e),se=_e)},setLocked:function(_e){G=_e},setClear:function(_e,Ee,Xe,nt,he){he===!0&&(_e*=nt,Ee*=nt,Xe*=nt),oe.set(_e,Ee,Xe,nt),Te.equals(oe)===!1&&(n.clearColor(_e,Ee,Xe,nt),Te.copy(oe))},reset:function(){G=!1,se=null,Te.set(-1,0,0,0)}}}function i(){let G=!1,oe=!1,se=null,Te=null,_e=null;return{setReversed:function(Ee){if(oe!==Ee){let Xe=e.get("EXT_clip_control");Ee?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Ee;let nt=_e;_e=null,this.setClear(nt)}},getReversed:function(){return oe},setTest:function(Ee){Ee?Se(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(Ee){se!==Ee&&!G&&(n.depthMask(Ee),se=Ee)},setFunc:function(Ee){if(oe&&(Ee=Bg[Ee]),Te!==Ee){switch(Ee){case ec:n.depthFunc(n.NEVER);break;case tc:n.depthFunc(n.ALWAYS);break;case nc:n.depthFunc(n.LESS);break;case xo:n.depthFunc(n.LEQUAL);break;case ic:n.depthFunc(n.EQUAL);break;case sc:n.depthFunc(n.GEQUAL);break;case rc:n.depthFunc(n.GREATER);break;case oc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Ee}},setLocked:function(Ee){G=Ee},setClear:function(Ee){_e!==Ee&&(_e=Ee,oe&&(Ee=1-Ee),n.clearDepth(Ee))},reset:function(){G=!1,se=null,Te=null,_e=null,oe=!1}}}function s(){let G=!1,oe=null,se=null,Te=null,_e=null,Ee=null,Xe=null,nt=null,he=null;return{setTest:function(Ve){G||(Ve?Se(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(Ve){oe!==Ve&&!G&&(n.stencilMask(Ve),oe=Ve)},setFunc:function(Ve,it,Pe){(se!==Ve||Te!==it||_e!==Pe)&&(n.stencilFunc(Ve,it,Pe),se=Ve,Te=it,_e=Pe)},setOp:function(Ve,it,Pe){(Ee!==Ve||Xe!==it||nt!==Pe)&&(n.stencilOp(Ve,it,Pe),Ee=Ve,Xe=it,nt=Pe)},setLocked:function(Ve){G=Ve},setClear:function(Ve){he!==Ve&&(n.clearStencil(Ve),he=Ve)},reset:function(){G=!1,oe=null,se=null,Te=null,_e=null,Ee=null,Xe=null,nt=null,he=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,S=null,A=null,M=null,y=null,v=new je(0,0,0),T=0,P=!1,C=null,N=null,F=null,D=null,V=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),B=!1,ne=0,Y=n.getParameter(n.VERSION);Y.indexOf("WebGL")!==-1?(ne=parseFloat(/^WebGL (\d)/.exec(Y)[1]),B=ne>=1):Y.indexOf("OpenGL ES")!==-1&&(ne=parseFloat(/^OpenGL ES (\d)/.exec(Y)[1]),B=ne>=2);let K=null,ee={},de=n.getParameter(n.SCISSOR_BOX),ce=n.getParameter(n.VIEWPORT),te=new Gt().fromArray(de),fe=new Gt().fromArray(ce);function xe(G,oe,se,Te){let _e=new Uint8Array(4),Ee=n.createTexture();n.bindTexture(G,Ee),n.texParameteri(G,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(G,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<se;Xe++)G===n.TEXTURE_3D||G===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(oe+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Ee}let be={};be[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),be[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),be[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),be[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(xo),en(!1),At(Ed),Se(n.CULL_FACE),$t(Cr);function Se(G){u[G]!==!0&&(n.enable(G),u[G]=!0)}function $e(G){u[G]!==!1&&(n.disable(G),u[G]=!1)}function ot(G,oe){return d[G]!==oe?(n.bindFramebuffer(G,oe),d[G]=oe,G===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=oe),G===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(G,oe){let se=p,Te=!1;if(G){se=f.get(oe),se===void 0&&(se=[],f.set(oe,se));let _e=G.textures;if(se.length!==_e.length||se[0]!==n.COLOR_ATTACHMENT0){for(let Ee=0,Xe=_e.length;Ee<Xe;Ee++)se[Ee]=n.COLOR_ATTACHMENT0+Ee;se.length=_e.length,Te=!0}}else se[0]!==n.BACK&&(se[0]=n.BACK,Te=!0);Te&&n.drawBuffers(se)}function lt(G){return x!==G?(n.useProgram(G),x=G,!0):!1}let ct={[Rr]:n.FUNC_ADD,[ag]:n.FUNC_SUBTRACT,[lg]:n.FUNC_REVERSE_SUBTRACT};ct[cg]=n.MIN,ct[ug]=n.MAX;let et={[hg]:n.ZERO,[dg]:n.ONE,[fg]:n.SRC_COLOR,[Pd]:n.SRC_ALPHA,[yg]:n.SRC_ALPHA_SATURATE,[xg]:n.DST_COLOR,[mg]:n.DST_ALPHA,[pg]:n.ONE_MINUS_SRC_COLOR,[Id]:n.ONE_MINUS_SRC_ALPHA,[_g]:n.ONE_MINUS_DST_COLOR,[gg]:n.ONE_MINUS_DST_ALPHA,[vg]:n.CONSTANT_COLOR,[bg]:n.ONE_MINUS_CONSTANT_COLOR,[Sg]:n.CONSTANT_ALPHA,[wg]:n.ONE_MINUS_CONSTANT_ALPHA};function $t(G,oe,se,Te,_e,Ee,Xe,nt,he,Ve){if(G===Cr){m===!0&&($e(n.BLEND),m=!1);return}if(m===!1&&(Se(n.BLEND),m=!0),G!==og){if(G!==g||Ve!==P){if((_!==Rr||A!==Rr)&&(n.blendEquation(n.FUNC_ADD),_=Rr,A=Rr),Ve)switch(G){case Ro:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Td:n.blendFunc(n.ONE,n.ONE);break;case Cd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",G);break}else switch(G){case Ro:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Td:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Cd:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Rd:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",G);break}w=null,S=null,M=null,y=null,v.set(0,0,0),T=0,g=G,P=Ve}return}_e=_e||oe,Ee=Ee||se,Xe=Xe||Te,(oe!==_||_e!==A)&&(n.blendEquationSeparate(ct[oe],ct[_e]),_=oe,A=_e),(se!==w||Te!==S||Ee!==M||Xe!==y)&&(n.blendFuncSeparate(et[se],et[Te],et[Ee],et[Xe]),w=se,S=Te,M=Ee,y=Xe),(nt.equals(v)===!1||he!==T)&&(n.blendColor(nt.r,nt.g,nt.b,he),v.copy(nt),T=he),g=G,P=!1}function Bt(G,oe){G.side===zn?$e(n.CULL_FACE):Se(n.CULL_FACE);let se=G.side===jn;oe&&(se=!se),en(se),G.blending===Ro&&G.transparent===!1?$t(Cr):$t(G.blending,G.blendEquation,G.blendSrc,G.blendDst,G.blendEquationAlpha,G.blendSrcAlpha,G.blendDstAlpha,G.blendColor,G.blendAlpha,G.premultipliedAlpha),o.setFunc(G.depthFunc),o.setTest(G.depthTest),o.setMask(G.depthWrite),r.setMask(G.colorWrite);let Te=G.stencilWrite;a.setTest(Te),Te&&(a.setMask(G.stencilWriteMask),a.setFunc(G.stencilFunc,G.stencilRef,G.stencilFuncMask),a.setOp(G.stencilFail,G.stencilZFail,G.stencilZPass)),vt(G.polygonOffset,G.polygonOffsetFactor,G.polygonOffsetUnits),G.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function en(G){C!==G&&(G?n.frontFace(n.CW):n.frontFace(n.CCW),C=G)}function At(G){G!==ig?(Se(n.CULL_FACE),G!==N&&(G===Ed?n.cullFace(n.BACK):G===sg?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),N=G}function dn(G){G!==F&&(B&&n.lineWidth(G),F=G)}function vt(G,oe,se){G?(Se(n.POLYGON_OFFSET_FILL),(D!==oe||V!==se)&&(D=oe,V=se,o.getReversed()&&(oe=-oe,se=-se),n.polygonOffset(oe,se))):$e(n.POLYGON_OFFSET_FILL)}function we(G){G?Se(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function Fe(G){G===void 0&&(G=n.TEXTURE0+$-1),K!==G&&(n.activeTexture(G),K=G)}function Ze(G,oe,se){se===void 0&&(K===null?se=n.TEXTURE0+$-1:se=K);let Te=ee[se];Te===void 0&&(Te={type:void 0,texture:void 0},ee[se]=Te),(Te.type!==G||Te.texture!==oe)&&(K!==se&&(n.activeTexture(se),K=se),n.bindTexture(G,oe||be[G]),Te.type=G,Te.texture=oe)}function z(){let G=ee[K];G!==void 0&&G.type!==void 0&&(n.bindTexture(G.type,null),G.type=void 0,G.texture=void 0)}function pe(){try{n.compressedTexImage2D(...arguments)}catch(G){st("WebGLState:",G)}}function ke(){try{n.compressedTexImage3D(...arguments)}catch(G){st("WebGLState:",G)}}function Qe(){try{n.texSubImage2D(...arguments)}catch(G){st("WebGLState:",G)}}function ye(){try{n.texSubImage3D(...arguments)}catch(G){st("WebGLState:",G)}}function Et(){try{n.compressedTexSubImage2D(...arguments)}catch(G){st("WebGLState:",G)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(G){st("WebGLState:",G)}}function Ye(){try{n.texStorage2D(...arguments)}catch(G){st("WebGLState:",G)}}function k(){try{n.texStorage3D(...arguments)}catch(G){st("WebGLState:",G)}}function R(){try{n.texImage2D(...arguments)}catch(G){st("WebGLState:",G)}}function q(){try{n.texImage3D(...arguments)}catch(G){st("WebGLState:",G)}}function ue(G){return h[G]!==void 0?h[G]:n.getParameter(G)}function ae(G,oe){h[G]!==oe&&(n.pixelStorei(G,oe),h[G]=oe)}function ve(G){te.equals(G)===!1&&(n.scissor(G.x,G.y,G.z,G.w),te.copy(G))}function Me(G){fe.equals(G)===!1&&(n.viewport(G.x,G.y,G.z,G.w),fe.copy(G))}function ie(G,oe){let se=c.get(oe);se===void 0&&(se=new WeakMap,c.set(oe,se));let Te=se.get(G);Te===void 0&&(Te=n.getUniformBlockIndex(oe,G.name),n.uniformBlockBinding(oe,Te,Te),se.set(G,Te))}function re(G,oe,se){let _e=c.get(oe).get(G);l[_e]!==se&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,se),l[_e]=se)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},K=null,ee={},d={},l={},f=new WeakMap,p=[],x=null,m=!1,g=null,_=null,w=null,S=null,A=null,M=null,y=null,v=new je(0,0,0),T=0,P=!1,C=null,N=null,F=null,D=null,V=null,te.set(0,0,n.canvas.width,n.canvas.height),fe.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:$e,bindFramebuffer:ot,drawBuffers:We,useProgram:lt,setBlending:$t,setMaterial:Bt,setFlipSided:en,setCullFace:At,setLineWidth:dn,setPolygonOffset:vt,setScissorTest:we,activeTexture:Fe,bindTexture:Ze,unbindTexture:z,compressedTexImage2D:pe,compressedTexImage3D:ke,texImage2D:R,texImage3D:q,pixelStorei:ae,getParameter:ue,updateUBOMapping:ie,uniformBlockBinding:re,texStorage2D:Ye,texStorage3D:k,texSubImage2D:Qe,texSubImage3D:ye,compressedTexSubImage2D:Et,compressedTexSubImage3D:ze,scissor:ve,viewport:Me,reset:ge}}function dE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Je,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(k=>p.delete(k)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(k,R){return m?new OffscreenCanvas(k,R):Ma("canvas")}function _(k,R,q){let ue=1,ae=Ye(k);if((ae.width>q||ae.height>q)&&(ue=q/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&k instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&k instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&k instanceof ImageBitmap||typeof VideoFrame<"u"&&k instanceof VideoFrame){let ve=Math.floor(ue*ae.width),Me=Math.floor(ue*ae.height);d===void 0&&(d=g(ve,Me));let ie=R?g(ve,Me):d;return ie.width=ve,ie.height=Me,ie.getContext("2d").drawImage(k,0,0,ve,Me),Ke("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+Me+")."),ie}else return"data"in k&&Ke("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),k;return k}function w(k){return k.generateMipmaps}function S(k){n.generateMipmap(k)}function A(k){return k.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:k.isWebGL3DRenderTarget?n.TEXTURE_3D:k.isWebGLArrayRenderTarget||k.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(k,R,q,ue,ae,ve=!1){if(k!==null){if(n[k]!==void 0)return n[k];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+k+"'")}let Me;ue&&(Me=e.get("EXT_texture_norm16"),Me||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ie=R;if(R===n.RED&&(q===n.FLOAT&&(ie=n.R32F),q===n.HALF_FLOAT&&(ie=n.R16F),q===n.UNSIGNED_BYTE&&(ie=n.R8),q===n.UNSIGNED_SHORT&&Me&&(ie=Me.R16_EXT),q===n.SHORT&&Me&&(ie=Me.R16_SNORM_EXT)),R===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.R8UI),q===n.UNSIGNED_SHORT&&(ie=n.R16UI),q===n.UNSIGNED_INT&&(ie=n.R32UI),q===n.BYTE&&(ie=n.R8I),q===n.SHORT&&(ie=n.R16I),q===n.INT&&(ie=n.R32I)),R===n.RG&&(q===n.FLOAT&&(ie=n.RG32F),q===n.HALF_FLOAT&&(ie=n.RG16F),q===n.UNSIGNED_BYTE&&(ie=n.RG8),q===n.UNSIGNED_SHORT&&Me&&(ie=Me.RG16_EXT),q===n.SHORT&&Me&&(ie=Me.RG16_SNORM_EXT)),R===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RG8UI),q===n.UNSIGNED_SHORT&&(ie=n.RG16UI),q===n.UNSIGNED_INT&&(ie=n.RG32UI),q===n.BYTE&&(ie=n.RG8I),q===n.SHORT&&(ie=n.RG16I),q===n.INT&&(ie=n.RG32I)),R===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ie=n.RGB16UI),q===n.UNSIGNED_INT&&(ie=n.RGB32UI),q===n.BYTE&&(ie=n.RGB8I),q===n.SHORT&&(ie=n.RGB16I),q===n.INT&&(ie=n.RGB32I)),R===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ie=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ie=n.RGBA16UI),q===n.UNSIGNED_INT&&(ie=n.RGBA32UI),q===n.BYTE&&(ie=n.RGBA8I),q===n.SHORT&&(ie=n.RGBA16I),q===n.INT&&(ie=n.RGBA32I)),R===n.RGB&&(q===n.UNSIGNED_SHORT&&Me&&(ie=Me.RGB16_EXT),q===n.SHORT&&Me&&(ie=Me.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ie=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ie=n.R11F_G11F_B10F)),R===n.RGBA){let re=ve?wa:St.getTransfer(ae);q===n.FLOAT&&(ie=n.RGBA32F),q===n.HALF_FLOAT&&(ie=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ie=re===Dt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&Me&&(ie=Me.RGBA16_EXT),q===n.SHORT&&Me&&(ie=Me.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ie=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ie=n.RGB5_A1)}return(ie===n.R16F||ie===n.R32F||ie===n.RG16F||ie===n.RG32F||ie===n.RGBA16F||ie===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ie}function y(k,R){let q;return k?R===null||R===ki||R===Ir?q=n.DEPTH24_STENCIL8:R===Mi?q=n.DEPTH32F_STENCIL8:R===Io&&(q=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):R===null||R===ki||R===Ir?q=n.DEPTH_COMPONENT24:R===Mi?q=n.DEPTH_COMPONENT32F:R===Io&&(q=n.DEPTH_COMPONENT16),q}function v(k,R){return w(k)===!0||k.isFramebufferTexture&&k.minFilter!==Nn&&k.minFilter!==Zn?Math.log2(Math.max(R.width,R.height))+1:k.mipmaps.length>0?k.mipmaps.length:k.isCompressedTexture&&Array.isArray(k.image)?R.mipmaps.length:1}function T(k){let R=new WeakRef(k);i.get(k).__ref=R,p.add(R),x.register(k,R,R)}function P(k){let R=i.get(k).__ref;R!==void 0&&(p.delete(R),x.unregister(R))}function C(k){F(k.target)}function N(k){D(k.target)}function F(k){k.removeEventListener("dispose",C),P(k),$(k),k.isVideoTexture&&u.delete(k),k.isHTMLTexture&&h.delete(k)}function D(k){k.removeEventListener("dispose",N),P(k),ne(k)}function V(){for(let k of p){let R=k.deref();R!==void 0&&(R.isRenderTarget===!0?D(R):F(R))}p.clear(),h.clear()}function $(k){let R=i.get(k);if(R.__webglInit===void 0)return;let q=k.source,ue=f.get(q);if(ue){let ae=ue[R.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&B(k),Object.keys(ue).length===0&&f.delete(q)}i.remove(k)}function B(k){let R=i.get(k);n.deleteTexture(R.__webglTexture);let q=k.source,ue=f.get(q);delete ue[R.__cacheKey],o.memory.textures--}function ne(k){let R=i.get(k);R.__depthDisposeCallback&&R.__depthDisposeCallback();let q=k.depthTexture;if(q&&q.renderTarget===k&&F(q),k.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(R.__webglFramebuffer[ae]))for(let ve=0;ve<R.__webglFramebuffer[ae].length;ve++)n.deleteFramebuffer(R.__webglFramebuffer[ae][ve]);else n.deleteFramebuffer(R.__webglFramebuffer[ae]);R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer[ae])}else{if(Array.isArray(R.__webglFramebuffer))for(let ae=0;ae<R.__webglFramebuffer.length;ae++)n.deleteFramebuffer(R.__webglFramebuffer[ae]);else n.deleteFramebuffer(R.__webglFramebuffer);if(R.__webglDepthbuffer&&n.deleteRenderbuffer(R.__webglDepthbuffer),R.__webglMultisampledFramebuffer&&n.deleteFramebuffer(R.__webglMultisampledFramebuffer),R.__webglColorRenderbuffer)for(let ae=0;ae<R.__webglColorRenderbuffer.length;ae++)R.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(R.__webglColorRenderbuffer[ae]);R.__webglDepthRenderbuffer&&n.deleteRenderbuffer(R.__webglDepthRenderbuffer)}let ue=k.textures;for(let ae=0,ve=ue.length;ae<ve;ae++){let Me=i.get(ue[ae]);Me.__webglTexture&&(n.deleteTexture(Me.__webglTexture),o.memory.textures--),i.remove(ue[ae])}i.remove(k)}let Y=0;function K(){Y=0}function ee(){return Y}function de(k){Y=k}function ce(){let k=Y;return k>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(k+1)+" texture units while this GPU supports only "+s.maxTextures),Y+=1,k}function te(k){let R=[];return R.push(k.wrapS),R.push(k.wrapT),R.push(k.wrapR||0),R.push(k.magFilter),R.push(k.minFilter),R.push(k.anisotropy),R.push(k.internalFormat),R.push(k.format),R.push(k.type),R.push(k.generateMipmaps),R.push(k.mipmapsAutoUpdate),R.push(k.premultiplyAlpha),R.push(k.flipY),R.push(k.unpackAlignment),R.push(k.colorSpace),R.join()}function fe(k,R){let q=i.get(k);if(k.isVideoTexture&&Et(k),k.isRenderTargetTexture===!1&&k.isExternalTexture!==!0&&k.version>0&&q.__version!==k.version){let ue=k.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Bt(q,k,R);return}}else k.isExternalTexture&&(q.__webglTexture=k.sourceTexture?k.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+R)}function xe(k,R){let q=i.get(k);if(k.isRenderTargetTexture===!1&&k.version>0&&q.__version!==k.version){Bt(q,k,R);return}else k.isExternalTexture&&(q.__webglTexture=k.sourceTexture?k.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+R)}function be(k,R){let q=i.get(k);if(k.isRenderTargetTexture===!1&&k.version>0&&q.__version!==k.version){Bt(q,k,R);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+R)}function Se(k,R){let q=i.get(k);if(k.version>0&&q.__version!==k.version){en(q,k,R);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+R)}let $e={[ac]:n.REPEAT,[es]:n.CLAMP_TO_EDGE,[lc]:n.MIRRORED_REPEAT},ot={[Nn]:n.NEAREST,[Eg]:n.NEAREST_MIPMAP_NEAREST,[Ha]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[kc]:n.LINEAR_MIPMAP_NEAREST,[Cs]:n.LINEAR_MIPMAP_LINEAR},We={[Pg]:n.NEVER,[jd]:n.ALWAYS,[Ig]:n.LESS,[Yd]:n.LEQUAL,[Lg]:n.EQUAL,[Zd]:n.GEQUAL,[Ng]:n.GREATER,[Dg]:n.NOTEQUAL};function lt(k,R){if(R.type===Mi&&e.has("OES_texture_float_linear")===!1&&(R.magFilter===Zn||R.magFilter===kc||R.magFilter===Ha||R.magFilter===Cs||R.minFilter===Zn||R.minFilter===kc||R.minFilter===Ha||R.minFilter===Cs)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(k,n.TEXTURE_WRAP_S,$e[R.wrapS]),n.texParameteri(k,n.TEXTURE_WRAP_T,$e[R.wrapT]),(k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY)&&n.texParameteri(k,n.TEXTURE_WRAP_R,$e[R.wrapR]),n.texParameteri(k,n.TEXTURE_MAG_FILTER,ot[R.magFilter]),n.texParameteri(k,n.TEXTURE_MIN_FILTER,ot[R.minFilter]),R.compareFunction&&(n.texParameteri(k,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(k,n.TEXTURE_COMPARE_FUNC,We[R.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(R.magFilter===Nn||R.minFilter!==Ha&&R.minFilter!==Cs||R.type===Mi&&e.has("OES_texture_float_linear")===!1)return;if(R.anisotropy>1||i.get(R).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(k,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(R.anisotropy,s.getMaxAnisotropy())),i.get(R).__currentAnisotropy=R.anisotropy}}}function ct(k,R){let q=!1;k.__webglInit===void 0&&(k.__webglInit=!0,R.addEventListener("dispose",C),T(R));let ue=R.source,ae=f.get(ue);ae===void 0&&(ae={},f.set(ue,ae));let ve=te(R);if(ve!==k.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[ve].usedTimes++;let Me=ae[k.__cacheKey];Me!==void 0&&(ae[k.__cacheKey].usedTimes--,Me.usedTimes===0&&B(R)),k.__cacheKey=ve,k.__webglTexture=ae[ve].texture}return q}function et(k,R,q){return Math.floor(Math.floor(k/q)/R)}function $t(k,R,q,ue){let ve=k.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,R.width,R.height,q,ue,R.data);else{ve.sort((G,oe)=>G.start-oe.start);let Me=0;for(let G=1;G<ve.length;G++){let oe=ve[Me],se=ve[G],Te=oe.start+oe.count,_e=et(se.start,R.width,4),Ee=et(oe.start,R.width,4);se.start<=Te+1&&_e===Ee&&et(se.start+se.count-1,R.width,4)===_e?oe.count=Math.max(oe.count,se.start+se.count-oe.start):(++Me,ve[Me]=se)}ve.length=Me+1;let ie=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,R.width);for(let G=0,oe=ve.length;G<oe;G++){let se=ve[G],Te=Math.floor(se.start/4),_e=Math.ceil(se.count/4),Ee=Te%R.width,Xe=Math.floor(Te/R.width),nt=_e,he=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Ee),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Ee,Xe,nt,he,q,ue,R.data)}k.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ie),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Bt(k,R,q){let ue=n.TEXTURE_2D;(R.isDataArrayTexture||R.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),R.isData3DTexture&&(ue=n.TEXTURE_3D);let ae=ct(k,R),ve=R.source;t.bindTexture(ue,k.__webglTexture,n.TEXTURE0+q);let Me=i.get(ve);if(ve.version!==Me.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&R.image instanceof ImageBitmap)===!1){let he=St.getPrimaries(St.workingColorSpace),Ve=R.colorSpace===Ps?null:St.getPrimaries(R.colorSpace),it=R.colorSpace===Ps||he===Ve?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,it)}t.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment);let re=_(R.image,!1,s.maxTextureSize);re=ze(R,re);let ge=r.convert(R.format,R.colorSpace),G=r.convert(R.type),oe=M(R.internalFormat,ge,G,R.normalized,R.colorSpace,R.isVideoTexture);lt(ue,R);let se,Te=R.mipmaps,_e=R.isVideoTexture!==!0,Ee=Me.__version===void 0||ae===!0,Xe=ve.dataReady,nt=v(R,re);if(R.isDepthTexture)oe=y(R.format===Rs,R.type),Ee&&(_e?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,G,null));else if(R.isDataTexture)if(Te.length>0){_e&&Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,Te[0].width,Te[0].height);for(let he=0,Ve=Te.length;he<Ve;he++)se=Te[he],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,se.width,se.height,ge,G,se.data):t.texImage2D(n.TEXTURE_2D,he,oe,se.width,se.height,0,ge,G,se.data);R.generateMipmaps=!1}else _e?(Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,re.width,re.height),Xe&&$t(R,re,ge,G)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,G,re.data);else if(R.isCompressedTexture)if(R.isCompressedArrayTexture){_e&&Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,oe,Te[0].width,Te[0].height,re.depth);for(let he=0,Ve=Te.length;he<Ve;he++)if(se=Te[he],R.format!==Ui)if(ge!==null)if(_e){if(Xe)if(R.layerUpdates.size>0){let it=af(se.width,se.height,R.format,R.type);for(let Pe of R.layerUpdates){let ht=se.data.subarray(Pe*it/se.data.BYTES_PER_ELEMENT,(Pe+1)*it/se.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,Pe,se.width,se.height,1,ge,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,se.width,se.height,re.depth,ge,se.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,he,oe,se.width,se.height,re.depth,0,se.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,se.width,se.height,re.depth,ge,G,se.data):t.texImage3D(n.TEXTURE_2D_ARRAY,he,oe,se.width,se.height,re.depth,0,ge,G,se.data);R.layerUpdates.size>0&&R.clearLayerUpdates()}else{_e&&Ee&&t.texStorage2D(n.TEXTURE_2D,nt,oe,Te[0].width,Te[0].height);for(let he=0,Ve=Te.length;he<Ve;he++)se=Te[he],R.format!==Ui?ge!==null?_e?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,he,0,0,se.width,se.height,ge,se.data):t.compressedTexImage2D(n.TEXTURE_2D,he,oe,se.width,se.height,0,se.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,se.width,se.height,ge,G,se.data):t.texImage2D(n.TEXTURE_2D,he,oe,se.width,se.height,0,ge,G,se.data)}else if(R.isDataArrayTexture)if(_e){if(Ee&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,oe,re.width,re.height,re.depth),Xe)if(R.layerUpdates.size>0){let he=af(re.width,re.height,R.format,R.type);for(let Ve of R.layerUpdates){let it=re.data.subarray(Ve*he/re.data.BYTES_PER_ELEMENT,(Ve+1)*he/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ve,re.width,re.height,1,ge,G,it)}R.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ge,G,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,ge,G,re.data);else if(R.isData3DTexture)_e?(Ee&&t.texStorage3D(n.TEXTURE_3D,nt,oe,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ge,G,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,ge,G,re.data);else if(R.isFramebufferTexture){if(Ee)if(_e)t.texStorage2D(n.TEXTURE_2D,nt,oe,re.width,re.height);else{let he=re.width,Ve=re.height;for(let it=0;it<nt;it++)t.texImage2D(n.TEXTURE_2D,it,oe,he,Ve,0,ge,G,null),he>>=1,Ve>>=1}}else if(R.isHTMLTexture){if("texElementImage2D"in n){let he=n.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),re.parentNode!==he){he.appendChild(re),h.add(R),he.onpaint=Ve=>{let it=Ve.changedElements;for(let Pe of h)it.includes(Pe.image)&&(Pe.needsUpdate=!0)},he.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let it=n.RGBA,Pe=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,it,Pe,ht,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Ee){let he=Ye(Te[0]);t.texStorage2D(n.TEXTURE_2D,nt,oe,he.width,he.height)}for(let he=0,Ve=Te.length;he<Ve;he++)se=Te[he],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ge,G,se):t.texImage2D(n.TEXTURE_2D,he,oe,ge,G,se);R.generateMipmaps=!1}else if(_e){if(Ee){let he=Ye(re);t.texStorage2D(n.TEXTURE_2D,nt,oe,he.width,he.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,G,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,ge,G,re);w(R)&&R.mipmapsAutoUpdate===!0&&S(ue),Me.__version=ve.version,R.onUpdate&&R.onUpdate(R)}k.__version=R.version}function en(k,R,q){if(R.image.length!==6)return;let ue=ct(k,R),ae=R.source;t.bindTexture(n.TEXTURE_CUBE_MAP,k.__webglTexture,n.TEXTURE0+q);let ve=i.get(ae);if(ae.version!==ve.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let Me=St.getPrimaries(St.workingColorSpace),ie=R.colorSpace===Ps?null:St.getPrimaries(R.colorSpace),re=R.colorSpace===Ps||Me===ie?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,R.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,R.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,R.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ge=R.isCompressedTexture||R.image[0].isCompressedTexture,G=R.image[0]&&R.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!ge&&!G?oe[Pe]=_(R.image[Pe],!0,s.maxCubemapSize):oe[Pe]=G?R.image[Pe].image:R.image[Pe],oe[Pe]=ze(R,oe[Pe]);let se=oe[0],Te=r.convert(R.format,R.colorSpace),_e=r.convert(R.type),Ee=M(R.internalFormat,Te,_e,R.normalized,R.colorSpace),Xe=R.isVideoTexture!==!0,nt=ve.__version===void 0||ue===!0,he=ae.dataReady,Ve=v(R,se);lt(n.TEXTURE_CUBE_MAP,R);let it;if(R.isDepthTexture){if(Ee=y(R.format===Rs,R.type),nt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Ee,se.width,se.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,se.width,se.height,0,Te,_e,null)}else if(ge){Xe&&nt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,se.width,se.height);for(let Pe=0;Pe<6;Pe++){it=oe[Pe].mipmaps;for(let ht=0;ht<it.length;ht++){let Xt=it[ht];R.format!==Ui?Te!==null?Xe?he&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Xt.width,Xt.height,Te,Xt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Ee,Xt.width,Xt.height,0,Xt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Xt.width,Xt.height,Te,_e,Xt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,Ee,Xt.width,Xt.height,0,Te,_e,Xt.data)}}}else{if(it=R.mipmaps,Xe&&nt){it.length>0&&Ve++;let Pe=Ye(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Ve,Ee,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(G){Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Te,_e,oe[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,oe[Pe].width,oe[Pe].height,0,Te,_e,oe[Pe].data);for(let ht=0;ht<it.length;ht++){let Gn=it[ht].image[Pe].image;Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Gn.width,Gn.height,Te,_e,Gn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Ee,Gn.width,Gn.height,0,Te,_e,Gn.data)}}else{Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,_e,oe[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,Te,_e,oe[Pe]);for(let ht=0;ht<it.length;ht++){let Xt=it[ht];Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Te,_e,Xt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,Ee,Te,_e,Xt.image[Pe])}}}w(R)&&R.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ve.__version=ae.version,R.onUpdate&&R.onUpdate(R)}k.__version=R.version}function At(k,R,q,ue,ae,ve){let Me=r.convert(q.format,q.colorSpace),ie=r.convert(q.type),re=M(q.internalFormat,Me,ie,q.normalized,q.colorSpace),ge=i.get(R),G=i.get(q);if(G.__renderTarget=R,!ge.__hasExternalTextures){let oe=Math.max(1,R.width>>ve),se=Math.max(1,R.height>>ve);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,re,oe,se,R.depth,0,Me,ie,null):t.texImage2D(ae,ve,re,oe,se,0,Me,ie,null)}t.bindFramebuffer(n.FRAMEBUFFER,k),ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,ae,G.__webglTexture,0,Qe(R)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,ae,G.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(k,R,q){if(n.bindRenderbuffer(n.RENDERBUFFER,k),R.depthBuffer){let ue=R.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,ve=y(R.stencilBuffer,ae),Me=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;ye(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qe(R),ve,R.width,R.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qe(R),ve,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,ve,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Me,n.RENDERBUFFER,k)}else{let ue=R.textures;for(let ae=0;ae<ue.length;ae++){let ve=ue[ae],Me=r.convert(ve.format,ve.colorSpace),ie=r.convert(ve.type),re=M(ve.internalFormat,Me,ie,ve.normalized,ve.colorSpace);ye(R)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Qe(R),re,R.width,R.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,Qe(R),re,R.width,R.height):n.renderbufferStorage(n.RENDERBUFFER,re,R.width,R.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function vt(k,R,q){let ue=R.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,k),!(R.depthTexture&&R.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(R.depthTexture);ae.__renderTarget=R;let ve=ue?R.depthTexture.image[0]:R.depthTexture.image;(!ae.__webglTexture||ve.width!==R.width||ve.height!==R.height)&&(ve.width=R.width,ve.height=R.height,R.depthTexture.needsUpdate=!0),ue?Se(R.depthTexture,0):fe(R.depthTexture,0);let Me=ae.__webglTexture,ie=Qe(R),re=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ge=R.depthTexture.format===Rs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(R.depthTexture.format===bs)ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,Me,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,Me,0);else if(R.depthTexture.format===Rs)ye(R)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,Me,0,ie):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function we(k){let R=i.get(k),q=k.isWebGLCubeRenderTarget===!0;if(R.__boundDepthTexture!==k.depthTexture){let ue=k.depthTexture;if(R.__depthDisposeCallback&&R.__depthDisposeCallback(),ue){let ae=()=>{delete R.__boundDepthTexture,delete R.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),R.__depthDisposeCallback=ae}R.__boundDepthTexture=ue}if(k.depthTexture&&!R.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)vt(R.__webglFramebuffer[ue],k,ue);else k.texture.mipmaps.length>0?vt(R.__webglFramebuffer[0],k,0):vt(R.__webglFramebuffer,k,0);else if(q){R.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[ue]),R.__webglDepthbuffer[ue]===void 0)R.__webglDepthbuffer[ue]=n.createRenderbuffer(),dn(R.__webglDepthbuffer[ue],k,!1);else{let ae=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=R.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}}else if(k.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,R.__webglFramebuffer),R.__webglDepthbuffer===void 0)R.__webglDepthbuffer=n.createRenderbuffer(),dn(R.__webglDepthbuffer,k,!1);else{let ae=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=R.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fe(k,R,q){let ue=i.get(k);R!==void 0&&At(ue.__webglFramebuffer,k,k.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&we(k)}function Ze(k){let R=k.texture,q=i.get(k),ue=i.get(R);k.addEventListener("dispose",N),T(k);let ae=k.textures,ve=k.isWebGLCubeRenderTarget===!0,Me=ae.length>1;if(Me||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=R.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let ie=0;ie<6;ie++)if(R.mipmaps.length>0){q.__webglFramebuffer[ie]=[];for(let re=0;re<R.mipmaps.length;re++)q.__webglFramebuffer[ie][re]=n.createFramebuffer()}else q.__webglFramebuffer[ie]=n.createFramebuffer()}else{if(R.mipmaps.length>0){q.__webglFramebuffer=[];for(let ie=0;ie<R.mipmaps.length;ie++)q.__webglFramebuffer[ie]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(Me)for(let ie=0,re=ae.length;ie<re;ie++){let ge=i.get(ae[ie]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(k.samples>0&&ye(k)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ie=0;ie<ae.length;ie++){let re=ae[ie];q.__webglColorRenderbuffer[ie]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ie]);let ge=r.convert(re.format,re.colorSpace),G=r.convert(re.type),oe=M(re.internalFormat,ge,G,re.normalized,re.colorSpace,k.isXRRenderTarget===!0),se=Qe(k);n.renderbufferStorageMultisample(n.RENDERBUFFER,se,oe,k.width,k.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ie,n.RENDERBUFFER,q.__webglColorRenderbuffer[ie])}n.bindRenderbuffer(n.RENDERBUFFER,null),k.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),dn(q.__webglDepthRenderbuffer,k,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),lt(n.TEXTURE_CUBE_MAP,R);for(let ie=0;ie<6;ie++)if(R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)At(q.__webglFramebuffer[ie][re],k,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,re);else At(q.__webglFramebuffer[ie],k,R,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ie,0);w(R)?S(n.TEXTURE_CUBE_MAP):R.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let ie=0,re=ae.length;ie<re;ie++){let ge=ae[ie],G=i.get(ge),oe=n.TEXTURE_2D;(k.isWebGL3DRenderTarget||k.isWebGLArrayRenderTarget)&&(oe=k.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,G.__webglTexture),lt(oe,ge),At(q.__webglFramebuffer,k,ge,n.COLOR_ATTACHMENT0+ie,oe,0),w(ge)&&S(oe)}t.unbindTexture()}else{let ie=n.TEXTURE_2D;if((k.isWebGL3DRenderTarget||k.isWebGLArrayRenderTarget)&&(ie=k.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ie,ue.__webglTexture),lt(ie,R),R.mipmaps.length>0)for(let re=0;re<R.mipmaps.length;re++)At(q.__webglFramebuffer[re],k,R,n.COLOR_ATTACHMENT0,ie,re);else At(q.__webglFramebuffer,k,R,n.COLOR_ATTACHMENT0,ie,0);w(R)?S(ie):R.mipmaps.length>0&&n.texParameteri(ie,n.TEXTURE_MAX_LEVEL,R.mipmaps.length-1),t.unbindTexture()}k.depthBuffer&&we(k)}function z(k){let R=k.textures;for(let q=0,ue=R.length;q<ue;q++){let ae=R[q];if(w(ae)&&ae.mipmapsAutoUpdate===!0){let ve=A(k),Me=i.get(ae).__webglTexture;t.bindTexture(ve,Me),S(ve),t.unbindTexture()}}}let pe=[];function ke(k){if(k.samples>0){if(ye(k)===!1){let R=k.textures,q=k.width,ue=k.height,ae=n.COLOR_BUFFER_BIT,ve=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Me=i.get(k),ie=R.length>1;if(ie)for(let ge=0;ge<R.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),k.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let ge=0;ge<R.length;ge++){if(k.resolveDepthBuffer&&(k.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),k.stencilBuffer&&k.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ie){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Me.__webglColorRenderbuffer[ge]);let G=i.get(R[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,G,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,ae,n.NEAREST),l===!0&&(pe.length=0,pe.push(n.COLOR_ATTACHMENT0+ge),k.depthBuffer&&k.storeMultisampledDepthBuffer===!1&&pe.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ie)for(let ge=0;ge<R.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,Me.__webglColorRenderbuffer[ge]);let G=i.get(R[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Me.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,G,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(k.depthBuffer&&k.storeMultisampledDepthBuffer===!1&&l){let R=k.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[R])}}}function Qe(k){return Math.min(s.maxSamples,k.samples)}function ye(k){let R=i.get(k);return k.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&R.__useRenderToTexture!==!1}function Et(k){let R=o.render.frame;u.get(k)!==R&&(u.set(k,R),k.update())}function ze(k,R){let q=k.colorSpace,ue=k.format,ae=k.type;return k.isCompressedTexture===!0||k.isVideoTexture===!0||q!==Sa&&q!==Ps&&(St.getTransfer(q)===Dt?(ue!==Ui||ae!==ti)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",q)),R}function Ye(k){return typeof HTMLImageElement<"u"&&k instanceof HTMLImageElement?(c.width=k.naturalWidth||k.width,c.height=k.naturalHeight||k.height):typeof VideoFrame<"u"&&k instanceof VideoFrame?(c.width=k.displayWidth,c.height=k.displayHeight):(c.width=k.width,c.height=k.height),c}this.allocateTextureUnit=ce,this.resetTextureUnits=K,this.getTextureUnits=ee,this.setTextureUnits=de,this.setTexture2D=fe,this.setTexture2DArray=xe,this.setTexture3D=be,this.setTextureCube=Se,this.rebindTextures=Fe,this.setupRenderTarget=Ze,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=ke,this.setupDepthRenderbuffer=we,this.setupFrameBufferTexture=At,this.useMultisampledRTT=ye,this.dispose=V}function fE(n,e){function t(i,s=Ps){let r,o=St.getTransfer(s);if(i===ti)return n.UNSIGNED_BYTE;if(i===Uc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Fc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Gd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Hd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===zd)return n.BYTE;if(i===Vd)return n.SHORT;if(i===Io)return n.UNSIGNED_SHORT;if(i===Oc)return n.INT;if(i===ki)return n.UNSIGNED_INT;if(i===Mi)return n.FLOAT;if(i===Oi)return n.HALF_FLOAT;if(i===Wd)return n.ALPHA;if(i===$d)return n.RGB;if(i===Ui)return n.RGBA;if(i===bs)return n.DEPTH_COMPONENT;if(i===Rs)return n.DEPTH_STENCIL;if(i===Bc)return n.RED;if(i===zc)return n.RED_INTEGER;if(i===ir)return n.RG;if(i===Vc)return n.RG_INTEGER;if(i===Gc)return n.RGBA_INTEGER;if(i===Wa||i===$a||i===Xa||i===qa)if(o===Dt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Wa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Wa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===$a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Hc||i===Wc||i===$c||i===Xc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Wc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===$c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Xc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===qc||i===Yc||i===Zc||i===jc||i===Kc||i===Ya||i===Jc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===qc||i===Yc)return o===Dt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Zc)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===jc)return r.COMPRESSED_R11_EAC;if(i===Kc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ya)return r.COMPRESSED_RG11_EAC;if(i===Jc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Qc||i===eu||i===tu||i===nu||i===iu||i===su||i===ru||i===ou||i===au||i===lu||i===cu||i===uu||i===hu||i===du)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Qc)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===eu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===tu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===nu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===iu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===su)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ru)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===ou)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===au)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===lu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===cu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===uu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===hu)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===du)return o===Dt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===fu||i===pu||i===mu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===fu)return o===Dt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===pu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===mu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===gu||i===xu||i===Za||i===_u)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===gu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===xu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===_u)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ir?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var pE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,mE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,gf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Na(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ns({vertexShader:pE,fragmentShader:mE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new _n(new Da(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},xf=class extends Di{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new gf,g={},_=t.getContextAttributes(),w=null,S=null,A=[],M=[],y=new Je,v=null,T=null,P=new Yn;P.viewport=new Gt;let C=new Yn;C.viewport=new Gt;let N=[P,C],F=new Ic,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let fe=A[te];return fe===void 0&&(fe=new wo,A[te]=fe),fe.getTargetRaySpace()},this.getControllerGrip=function(te){let fe=A[te];return fe===void 0&&(fe=new wo,A[te]=fe),fe.getGripSpace()},this.getHand=function(te){let fe=A[te];return fe===void 0&&(fe=new wo,A[te]=fe),fe.getHandSpace()};function $(te){let fe=M.indexOf(te.inputSource);if(fe===-1)return;let xe=A[fe];xe!==void 0&&(xe.update(te.inputSource,te.frame,c||o),xe.dispatchEvent({type:te.type,data:te.inputSource}))}function B(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",B),s.removeEventListener("inputsourceschange",ne);for(let te=0;te<A.length;te++){let fe=M[te];fe!==null&&(M[te]=null,A[te].disconnect(fe))}D=null,V=null,m.reset();for(let te in g)delete g[te];if(e.setRenderTarget(w),f=null,d=null,h=null,s=null,S=null,ce.stop(),i.isPresenting=!1,e.setPixelRatio(v),e.setSize(y.width,y.height,!1),T!==null){let te=T.camera;te.fov=T.fov,te.zoom=T.zoom,te.updateProjectionMatrix(),T=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(w=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",B),s.addEventListener("inputsourceschange",ne),_.xrCompatible!==!0&&await t.makeXRCompatible(),v=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,be=null,Se=null;_.depth&&(Se=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=_.stencil?Rs:bs,be=_.stencil?Ir:ki);let $e={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer($e),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),S=new di(d.textureWidth,d.textureHeight,{format:Ui,type:ti,depthTexture:new Es(d.textureWidth,d.textureHeight,be,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xe={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new di(f.framebufferWidth,f.framebufferHeight,{format:Ui,type:ti,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ce.setContext(s),ce.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ne(te){for(let fe=0;fe<te.removed.length;fe++){let xe=te.removed[fe],be=M.indexOf(xe);be>=0&&(M[be]=null,A[be].disconnect(xe))}for(let fe=0;fe<te.added.length;fe++){let xe=te.added[fe],be=M.indexOf(xe);if(be===-1){for(let $e=0;$e<A.length;$e++)if($e>=M.length){M.push(xe),be=$e;break}else if(M[$e]===null){M[$e]=xe,be=$e;break}if(be===-1)break}let Se=A[be];Se&&Se.connect(xe)}}function Y(te,fe){fe===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(fe.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let fe=te.near,xe=te.far;m.texture!==null&&(m.depthNear>0&&(fe=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),F.near=C.near=P.near=fe,F.far=C.far=P.far=xe,(D!==F.near||V!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),D=F.near,V=F.far),F.layers.mask=te.layers.mask|6,P.layers.mask=F.layers.mask&-5,C.layers.mask=F.layers.mask&-3;let be=te.parent,Se=F.cameras;Y(F,be);for(let $e=0;$e<Se.length;$e++)Y(Se[$e],be);F.projectionMatrix.copy(P.projectionMatrix),F.projectionMatrixInverse.copy(P.projectionMatrixInverse),T===null&&te.isPerspectiveCamera&&(T={camera:te,fov:te.fov,zoom:te.zoom}),K(te,F,be)};function K(te,fe,xe){xe===null?te.matrix.copy(fe.matrixWorld):(te.matrix.copy(xe.matrixWorld),te.matrix.invert(),te.matrix.multiply(fe.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(fe.projectionMatrix),te.projectionMatrixInverse.copy(fe.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=vo*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(te){l=te,d!==null&&(d.fixedFoveation=te),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=te)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(te){return g[te]};let ee=null;function de(te,fe){if(u=fe.getViewerPose(c||o),p=fe,u!==null){let xe=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let be=!1;xe.length!==F.cameras.length&&(F.cameras.length=0,be=!0);for(let We=0;We<xe.length;We++){let lt=xe[We],ct=null;if(f!==null)ct=f.getViewport(lt);else{let $t=h.getViewSubImage(d,lt);ct=$t.viewport,We===0&&(e.setRenderTargetTextures(S,$t.colorTexture,$t.depthStencilTexture),e.setRenderTarget(S))}let et=N[We];et===void 0&&(et=new Yn,et.layers.enable(We),et.viewport=new Gt,N[We]=et),et.matrix.fromArray(lt.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(lt.projectionMatrix),et.projectionMatrixInverse.copy(et.projectionMatrix).invert(),et.viewport.set(ct.x,ct.y,ct.width,ct.height),We===0&&(F.matrix.copy(et.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),be===!0&&F.cameras.push(et)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let We=h.getDepthInformation(xe[0]);We&&We.isValid&&We.texture&&m.init(We,s.renderState)}if(Se&&Se.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let We=0;We<xe.length;We++){let lt=xe[We].camera;if(lt){let ct=g[lt];ct||(ct=new Na,g[lt]=ct);let et=h.getCameraImage(lt);ct.sourceTexture=et}}}}for(let xe=0;xe<A.length;xe++){let be=M[xe],Se=A[xe];be!==null&&Se!==void 0&&Se.update(be,fe,c||o)}ee&&ee(te,fe),fe.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:fe}),p=null}let ce=new f0;ce.setAnimationLoop(de),this.setAnimationLoop=function(te){ee=te},this.dispose=function(){}}},gE=new dt,w0=new rt;w0.set(-1,0,0,0,1,0,0,0,1);function xE(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,sf(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,_,w,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,_,w):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===jn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===jn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let _=e.get(g),w=_.envMap,S=_.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(gE.makeRotationFromEuler(S)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(w0),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,_,w){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*_,m.scale.value=w*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,_){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===jn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=_.texture,m.transmissionSamplerSize.value.set(_.width,_.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let _=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(_.matrixWorld),m.nearDistance.value=_.shadow.camera.near,m.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function _E(n,e,t,i){let s={},r={};function o(_,w){let S=w.program;i.uniformBlockBinding(_,S,s[_.id])}function a(_,w){let S=s[_.id];S===void 0&&(p(_),S=l(_),s[_.id]=S,_.addEventListener("dispose",m));let A=w.program;i.updateUBOMapping(_,A);let M=e.render.frame;r[_.id]!==M&&(c(_),r[_.id]=M)}function l(_){let w=n.createBuffer(),S=_.__size,A=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,S,A),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],S=_.uniforms,A=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let M=0,y=S.length;M<y;M++){let v=S[M];if(Array.isArray(v))for(let T=0,P=v.length;T<P;T++)u(v[T],M,T,A);else u(v,M,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,w,S,A){if(d(_,w,S,A)===!0){let M=_.__offset,y=_.value;if(Array.isArray(y)){let v=0;for(let T=0;T<y.length;T++){let P=y[T],C=x(P,!0);h(P,_.__data,v),v+=C.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,_.__data)}}function h(_,w,S){typeof _=="number"||typeof _=="boolean"?w[S]=_:_.isMatrix3?(w[S]=_.elements[0],w[S+1]=_.elements[1],w[S+2]=_.elements[2],w[S+3]=0,w[S+4]=_.elements[3],w[S+5]=_.elements[4],w[S+6]=_.elements[5],w[S+7]=0,w[S+8]=_.elements[6],w[S+9]=_.elements[7],w[S+10]=_.elements[8],w[S+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-S),S):_.toArray(w,S)}function d(_,w,S,A){let M=_.value,y=w+"_"+S;if(Array.isArray(M)){A[y]===void 0&&(A[y]=[]);let v=A[y],T=!1;for(let P=0;P<M.length;P++)f(M[P],v,P)===!0&&(T=!0);return T}return f(M,A,y)}function f(_,w,S){if(w[S]===void 0)return typeof _=="number"||typeof _=="boolean"?w[S]=_:ArrayBuffer.isView(_)?w[S]=_.slice():w[S]=_.clone(),!0;{let A=w[S];if(typeof _=="number"||typeof _=="boolean"){if(A!==_)return w[S]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(A.equals(_)===!1)return A.copy(_),!0}}return!1}function p(_){let w=_.uniforms,S=0,A=16;for(let y=0,v=w.length;y<v;y++){let T=Array.isArray(w[y])?w[y]:[w[y]];for(let P=0,C=T.length;P<C;P++){let N=T[P],F=Array.isArray(N.value)?N.value:[N.value],D=Array.isArray(w[y])||Array.isArray(N.value),V=S;for(let B=0,ne=F.length;B<ne;B++){let Y=F[B],K=x(Y,D),ee=S%A,de=ee%K.boundary,ce=ee+de;S+=de,ce!==0&&A-ce<K.storage&&(S+=A-ce),B===0&&(V=S),S+=K.storage}let $=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new $((S-V)/Float32Array.BYTES_PER_ELEMENT),N.__offset=V}}let M=S%A;return M>0&&(S+=A-M),_.__size=S,_.__cache={},this}function x(_,w){let S={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(S.boundary=4,S.storage=4):_.isVector2?(S.boundary=8,S.storage=8):_.isVector3||_.isColor?(S.boundary=16,S.storage=12):_.isVector4?(S.boundary=16,S.storage=16):_.isMatrix3?(S.boundary=16,S.storage=48):_.isMatrix4?(S.boundary=16,S.storage=64):_.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(S.boundary=16,S.storage=_.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(_){let w=_.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function g(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:g}}var yE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ss=null;function vE(){return ss===null&&(ss=new Ra(yE,16,16,ir,Oi),ss.name="DFG_LUT",ss.minFilter=Zn,ss.magFilter=Zn,ss.wrapS=es,ss.wrapT=es,ss.generateMipmaps=!1,ss.needsUpdate=!0),ss}var wu=class{constructor(e={}){let{canvas:t=Og(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ti}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=f,m=new Set([Gc,Vc,zc]),g=new Set([ti,ki,Io,Ir,Uc,Fc]),_=new Uint32Array(4),w=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},A=null,M=null,y=[],v=[],T=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=is,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,C=!1,N=null,F=null,D=null,V=null;this._outputColorSpace=ci;let $=0,B=0,ne=null,Y=-1,K=null,ee=new Gt,de=new Gt,ce=null,te=new je(0),fe=0,xe=t.width,be=t.height,Se=1,$e=null,ot=null,We=new Gt(0,0,xe,be),lt=new Gt(0,0,xe,be),ct=!1,et=new Zs,$t=new fc,Bt=!1,en=!1,At=new dt,dn=new H,vt=new Gt,we={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Fe=!1;function Ze(){return ne===null?Se:1}let z=i;function pe(L,W){return t.getContext(L,W)}let ke,Qe,ye,Et,ze,Ye,k,R,q,ue,ae,ve,Me,ie,re,ge,G,oe,se,Te,_e,Ee,Xe;try{let L={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Ve,!1),t.addEventListener("webglcontextrestored",it,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),z===null){let W="webgl2";if(z=pe(W,L),z===null)throw pe(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(L){throw t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),st("WebGLRenderer: "+L.message),L}function nt(){ke=new I1(z),ke.init(),_e=new fE(z,ke),Qe=new v1(z,ke,e,_e),ye=new hE(z,ke),Qe.reversedDepthBuffer&&d&&ye.buffers.depth.setReversed(!0),F=z.createFramebuffer(),D=z.createFramebuffer(),V=z.createFramebuffer(),Et=new D1(z),ze=new KA,Ye=new dE(z,ke,ye,ze,Qe,_e,Et),k=new P1(P),R=new OS(z),Ee=new _1(z,R),q=new L1(z,R,Et,Ee),ue=new O1(z,q,R,Ee,Et),oe=new k1(z,Qe,Ye),re=new b1(ze),ae=new jA(P,k,ke,Qe,Ee,re),ve=new xE(P,ze),Me=new QA,ie=new rE(ke),G=new x1(P,k,ye,ue,p,l),ge=new uE(P,ue,Qe),Xe=new _E(z,Et,Qe,ye),se=new y1(z,ke,Et),Te=new N1(z,ke,Et),Et.programs=ae.programs,P.capabilities=Qe,P.extensions=ke,P.properties=ze,P.renderLists=Me,P.shadowMap=ge,P.state=ye,P.info=Et}x!==ti&&(T=new F1(x,t.width,t.height,a,s,r));let he=new xf(P,z);this.xr=he,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let L=ke.get("WEBGL_lose_context");L&&L.loseContext()},this.forceContextRestore=function(){let L=ke.get("WEBGL_lose_context");L&&L.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(L){L!==void 0&&(Se=L,this.setSize(xe,be,!1))},this.getSize=function(L){return L.set(xe,be)},this.setSize=function(L,W,Q=!0){if(he.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=L,be=W,t.width=Math.floor(L*Se),t.height=Math.floor(W*Se),Q===!0&&(t.style.width=L+"px",t.style.height=W+"px"),T!==null&&T.setSize(t.width,t.height),this.setViewport(0,0,L,W)},this.getDrawingBufferSize=function(L){return L.set(xe*Se,be*Se).floor()},this.setDrawingBufferSize=function(L,W,Q){xe=L,be=W,Se=Q,t.width=Math.floor(L*Q),t.height=Math.floor(W*Q),this.setViewport(0,0,L,W)},this.setEffects=function(L){if(x===ti){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(L){for(let W=0;W<L.length;W++)if(L[W].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}T.setEffects(L||[])},this.getCurrentViewport=function(L){return L.copy(ee)},this.getViewport=function(L){return L.copy(We)},this.setViewport=function(L,W,Q,Z){L.isVector4?We.set(L.x,L.y,L.z,L.w):We.set(L,W,Q,Z),ye.viewport(ee.copy(We).multiplyScalar(Ze()).round())},this.getScissor=function(L){return L.copy(lt)},this.setScissor=function(L,W,Q,Z){L.isVector4?lt.set(L.x,L.y,L.z,L.w):lt.set(L,W,Q,Z),ye.scissor(de.copy(lt).multiplyScalar(Ze()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(L){ye.setScissorTest(ct=L)},this.setOpaqueSort=function(L){$e=L},this.setTransparentSort=function(L){ot=L},this.getClearColor=function(L){return L.copy(G.getClearColor())},this.setClearColor=function(){G.setClearColor(...arguments)},this.getClearAlpha=function(){return G.getClearAlpha()},this.setClearAlpha=function(){G.setClearAlpha(...arguments)},this.clear=function(L=!0,W=!0,Q=!0){let Z=0;if(L){let j=!1;if(ne!==null){let Ce=ne.texture.format;j=m.has(Ce)}if(j){let Ce=ne.texture.type,Ie=g.has(Ce),Re=G.getClearColor(),Le=G.getClearAlpha(),He=Re.r,at=Re.g,mt=Re.b;Ie?(_[0]=He,_[1]=at,_[2]=mt,_[3]=Le,z.clearBufferuiv(z.COLOR,0,_)):(w[0]=He,w[1]=at,w[2]=mt,w[3]=Le,z.clearBufferiv(z.COLOR,0,w))}else Z|=z.COLOR_BUFFER_BIT}W&&(Z|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Z|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&z.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(L){L.setRenderer(this),N=L},this.dispose=function(){t.removeEventListener("webglcontextlost",Ve,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),G.dispose(),Me.dispose(),ie.dispose(),Ye.dispose(),ze.dispose(),k.dispose(),ue.dispose(),q.dispose(),Ee.dispose(),Xe.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",wl),he.removeEventListener("sessionend",Hi),ls.stop()};function Ve(L){L.preventDefault(),Jd("WebGLRenderer: Context Lost."),C=!0}function it(){Jd("WebGLRenderer: Context Restored."),C=!1;let L=Et.autoReset,W=ge.enabled,Q=ge.autoUpdate,Z=ge.needsUpdate,j=ge.type;nt(),Et.autoReset=L,ge.enabled=W,ge.autoUpdate=Q,ge.needsUpdate=Z,ge.type=j}function Pe(L){st("WebGLRenderer: A WebGL context could not be created. Reason: ",L.statusMessage)}function ht(L){let W=L.target;W.removeEventListener("dispose",ht),Xt(W)}function Xt(L){Gn(L),ze.remove(L)}function Gn(L){let W=ze.get(L).programs;W!==void 0&&(W.forEach(function(Q){ae.releaseProgram(Q)}),L.isShaderMaterial&&ae.releaseShaderCache(L))}this.renderBufferDirect=function(L,W,Q,Z,j,Ce){W===null&&(W=we);let Ie=j.isMesh&&j.matrixWorld.determinantAffine()<0,Re=ra(L,W,Q,Z,j);ye.setMaterial(Z,Ie);let Le=Q.index,He=1;if(Z.wireframe===!0){if(Le=q.getWireframeAttribute(Q),Le===void 0)return;He=2}let at=Q.drawRange,mt=Q.attributes.position,Ge=at.start*He,gt=(at.start+at.count)*He;Ce!==null&&(Ge=Math.max(Ge,Ce.start*He),gt=Math.min(gt,(Ce.start+Ce.count)*He)),Le!==null?(Ge=Math.max(Ge,0),gt=Math.min(gt,Le.count)):mt!=null&&(Ge=Math.max(Ge,0),gt=Math.min(gt,mt.count));let tn=gt-Ge;if(tn<0||tn===1/0)return;Ee.setup(j,Z,Re,Q,Le);let Ot,Ut=se;if(Le!==null&&(Ot=R.get(Le),Ut=Te,Ut.setIndex(Ot)),j.isMesh)Z.wireframe===!0?(ye.setLineWidth(Z.wireframeLinewidth*Ze()),Ut.setMode(z.LINES)):Ut.setMode(z.TRIANGLES);else if(j.isLine){let vn=Z.linewidth;vn===void 0&&(vn=1),ye.setLineWidth(vn*Ze()),j.isLineSegments?Ut.setMode(z.LINES):j.isLineLoop?Ut.setMode(z.LINE_LOOP):Ut.setMode(z.LINE_STRIP)}else j.isPoints?Ut.setMode(z.POINTS):j.isSprite&&Ut.setMode(z.TRIANGLES);if(j.isBatchedMesh)if(ke.get("WEBGL_multi_draw"))Ut.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let vn=j._multiDrawStarts,Ue=j._multiDrawCounts,fn=j._multiDrawCount,bt=Le?R.get(Le).bytesPerElement:1,us=ze.get(Z).currentProgram.getUniforms();for(let pn=0;pn<fn;pn++)us.setValue(z,"_gl_DrawID",pn),Ut.render(vn[pn]/bt,Ue[pn])}else if(j.isInstancedMesh)Ut.renderInstances(Ge,tn,j.count);else if(Q.isInstancedBufferGeometry){let vn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Ue=Math.min(Q.instanceCount,vn);Ut.renderInstances(Ge,tn,Ue)}else Ut.render(Ge,tn)};function na(L,W,Q,Z){N!==null&&L.isNodeMaterial&&N.setObject(Z,L),Bt===!0&&re.setState(L,Q,!1),L.transparent===!0&&L.side===zn&&L.forceSinglePass===!1?(L.side=jn,L.needsUpdate=!0,Wi(L,W,Z),L.side=nr,L.needsUpdate=!0,Wi(L,W,Z),L.side=zn):Wi(L,W,Z)}this.compile=function(L,W,Q=null){Q===null&&(Q=L),N!==null&&N.renderStart(L,W,Q),M=ie.get(Q),M.init(W),v.push(M),Q.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),L!==Q&&L.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(M.pushLight(j),j.castShadow&&M.pushShadow(j))}),M.setupLights(),N!==null&&N.updateLights(M.state.lightsArray),en=this.localClippingEnabled,Bt=re.init(this.clippingPlanes,en),Bt===!0&&re.setGlobalState(this.clippingPlanes,W),N!==null&&ge.render(M.state.shadowsArray,Q,W);let Z=new Set;return L.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ce=j.material;if(Ce)if(Array.isArray(Ce))for(let Ie=0;Ie<Ce.length;Ie++){let Re=Ce[Ie];na(Re,Q,W,j),Z.add(Re)}else na(Ce,Q,W,j),Z.add(Ce)}),M=v.pop(),N!==null&&N.renderEnd(),Z},this.compileAsync=function(L,W,Q=null){let Z=this.compile(L,W,Q);return new Promise(j=>{function Ce(){if(Z.forEach(function(Ie){let Le=ze.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&Z.delete(Ie)}),Z.size===0){j(L);return}setTimeout(Ce,10)}ke.get("KHR_parallel_shader_compile")!==null?Ce():setTimeout(Ce,10)})};let Wr=null;function Fh(L){Wr&&Wr(L)}function wl(){ls.stop()}function Hi(){ls.start()}let ls=new f0;ls.setAnimationLoop(Fh),typeof self<"u"&&ls.setContext(self),this.setAnimationLoop=function(L){Wr=L,he.setAnimationLoop(L),L===null?ls.stop():ls.start()},he.addEventListener("sessionstart",wl),he.addEventListener("sessionend",Hi),this.render=function(L,W){if(W!==void 0&&W.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(C===!0)return;N!==null&&N.renderStart(L,W);let Q=he.enabled===!0&&he.isPresenting===!0,Z=T!==null&&(ne===null||Q)&&T.begin(P,ne);if(L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(T===null||T.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(W),W=he.getCamera()),L.isScene===!0&&L.onBeforeRender(P,L,W,ne),M=ie.get(L,v.length),M.init(W),M.state.textureUnits=Ye.getTextureUnits(),v.push(M),At.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?$t.setFromArrayCamera(W):et.setFromProjectionMatrix(At,Si,W.reversedDepth),en=this.localClippingEnabled,Bt=re.init(this.clippingPlanes,en),A=Me.get(L,y.length),A.init(),y.push(A),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=P.xr.getDepthSensingMesh();Ie!==null&&cs(Ie,W,-1/0,P.sortObjects)}cs(L,W,0,P.sortObjects),A.finish(),N!==null&&N.updateLights(M.state.lightsArray),P.sortObjects===!0&&A.sort($e,ot),Fe=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,Fe&&G.addToRenderList(A,L),this.info.autoReset===!0&&this.info.reset(),Bt===!0&&re.beginShadows();let j=M.state.shadowsArray;if(ge.render(j,L,W),Bt===!0&&re.endShadows(),(Z&&T.hasRenderPass())===!1){let Ie=A.opaque,Re=A.transmissive;if(M.setupLights(),W.isArrayCamera){let Le=W.cameras;if(Re.length>0)for(let He=0,at=Le.length;He<at;He++){let mt=Le[He];Ci(Ie,Re,L,mt)}Fe&&G.render(L);for(let He=0,at=Le.length;He<at;He++){let mt=Le[He];ia(A,L,mt,mt.viewport)}}else Re.length>0&&Ci(Ie,Re,L,W),Fe&&G.render(L),ia(A,L,W)}ne!==null&&B===0&&(Ye.updateMultisampleRenderTarget(ne),Ye.updateRenderTargetMipmap(ne)),Z&&T.end(P),L.isScene===!0&&L.onAfterRender(P,L,W),Ee.resetDefaultState(),Y=-1,K=null,v.pop(),v.length>0?(M=v[v.length-1],Ye.setTextureUnits(M.state.textureUnits),Bt===!0&&re.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,N!==null&&N.renderEnd()};function cs(L,W,Q,Z){if(L.visible===!1)return;if(L.layers.test(W.layers)){if(L.isGroup)Q=L.renderOrder;else if(L.isLOD)L.autoUpdate===!0&&L.update(W);else if(L.isLight)M.pushLight(L),L.castShadow&&M.pushShadow(L);else if(L.isSprite){let Ie=W.isArrayCamera?$t:et;if(!L.frustumCulled||L.intersectsFrustum(Ie)){Z&&vt.setFromMatrixPosition(L.matrixWorld).applyMatrix4(At);let Re=ue.update(L),Le=L.material;Le.visible&&A.push(L,Re,Le,Q,vt.z,null,W)}}else if(L.isMesh||L.isLine||L.isPoints){let Ie=W.isArrayCamera?$t:et;if(!L.frustumCulled||L.intersectsFrustum(Ie)){let Re=ue.update(L),Le=L.material;if(Z&&(L.boundingSphere!==void 0?(L.boundingSphere===null&&L.computeBoundingSphere(),vt.copy(L.boundingSphere.center)):(Re.boundingSphere===null&&Re.computeBoundingSphere(),vt.copy(Re.boundingSphere.center)),vt.applyMatrix4(L.matrixWorld).applyMatrix4(At)),Array.isArray(Le)){let He=Re.groups;for(let at=0,mt=He.length;at<mt;at++){let Ge=He[at],gt=Le[Ge.materialIndex];gt&&gt.visible&&A.push(L,Re,gt,Q,vt.z,Ge,W)}}else Le.visible&&A.push(L,Re,Le,Q,vt.z,null,W)}}}let Ce=L.children;for(let Ie=0,Re=Ce.length;Ie<Re;Ie++)cs(Ce[Ie],W,Q,Z)}function ia(L,W,Q,Z){let{opaque:j,transmissive:Ce,transparent:Ie}=L;M.setupLightsView(Q),Bt===!0&&re.setGlobalState(P.clippingPlanes,Q),Z&&ye.viewport(ee.copy(Z)),j.length>0&&nn(j,W,Q),Ce.length>0&&nn(Ce,W,Q),Ie.length>0&&nn(Ie,W,Q),ye.buffers.depth.setTest(!0),ye.buffers.depth.setMask(!0),ye.buffers.color.setMask(!0),ye.setPolygonOffset(!1)}function Ci(L,W,Q,Z){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Z.id]===void 0){let Ge=ke.has("EXT_color_buffer_half_float")||ke.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Z.id]=new di(1,1,{generateMipmaps:!0,type:Ge?Oi:ti,minFilter:Cs,samples:Math.max(4,Qe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ce=M.state.transmissionRenderTarget[Z.id],Ie=Z.viewport||ee;Ce.setSize(Ie.z*P.transmissionResolutionScale,Ie.w*P.transmissionResolutionScale);let Re=P.getRenderTarget(),Le=P.getActiveCubeFace(),He=P.getActiveMipmapLevel();P.setRenderTarget(Ce),P.getClearColor(te),fe=P.getClearAlpha(),fe<1&&P.setClearColor(16777215,.5),P.clear(),Fe&&G.render(Q);let at=P.toneMapping;P.toneMapping=is;let mt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),M.setupLightsView(Z),Bt===!0&&re.setGlobalState(P.clippingPlanes,Z),nn(L,Q,Z),Ye.updateMultisampleRenderTarget(Ce),Ye.updateRenderTargetMipmap(Ce),ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let gt=0,tn=W.length;gt<tn;gt++){let Ot=W[gt],{object:Ut,geometry:vn,material:Ue,group:fn}=Ot;if(Ue.side===zn&&Ut.layers.test(Z.layers)){let bt=Ue.side;Ue.side=jn,Ue.needsUpdate=!0,ln(Ut,Q,Z,vn,Ue,fn),Ue.side=bt,Ue.needsUpdate=!0,Ge=!0}}Ge===!0&&(Ye.updateMultisampleRenderTarget(Ce),Ye.updateRenderTargetMipmap(Ce))}P.setRenderTarget(Re,Le,He),P.setClearColor(te,fe),mt!==void 0&&(Z.viewport=mt),P.toneMapping=at}function nn(L,W,Q){let Z=W.isScene===!0?W.overrideMaterial:null;for(let j=0,Ce=L.length;j<Ce;j++){let Ie=L[j],{object:Re,geometry:Le,group:He}=Ie,at=Ie.material;at.allowOverride===!0&&Z!==null&&(at=Z),Re.layers.test(Q.layers)&&ln(Re,W,Q,Le,at,He)}}function ln(L,W,Q,Z,j,Ce){N!==null&&j.isNodeMaterial&&N.setObject(L,j),L.onBeforeRender(P,W,Q,Z,j,Ce),L.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,L.matrixWorld),L.normalMatrix.getNormalMatrix(L.modelViewMatrix),j.onBeforeRender(P,W,Q,Z,L,Ce),j.transparent===!0&&j.side===zn&&j.forceSinglePass===!1?(j.side=jn,j.needsUpdate=!0,P.renderBufferDirect(Q,W,Z,j,L,Ce),j.side=nr,j.needsUpdate=!0,P.renderBufferDirect(Q,W,Z,j,L,Ce),j.side=zn):P.renderBufferDirect(Q,W,Z,j,L,Ce),L.onAfterRender(P,W,Q,Z,j,Ce)}function cn(L){let W=0;for(let Q of L)Q.texture!==null&&W++;return W}function Wi(L,W,Q){W.isScene!==!0&&(W=we);let Z=ze.get(L),j=M.state.lights,Ce=M.state.shadowsArray,Ie=j.state.version,Re=ae.getParameters(L,j.state,Ce,W,Q,M.state.lightProbeGridArray),Le=ae.getProgramCacheKey(Re),He=Z.programs;Z.environment=L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let at=L.isMeshStandardMaterial||L.isMeshLambertMaterial&&!L.envMap||L.isMeshPhongMaterial&&!L.envMap;Z.envMap=k.get(L.envMap||Z.environment,at),Z.envMapRotation=Z.environment!==null&&L.envMap===null?W.environmentRotation:L.envMapRotation,He===void 0&&(L.addEventListener("dispose",ht),He=new Map,Z.programs=He,Z.programVariants=new Map);let mt=He.get(Le);if(mt!==void 0){if(Z.currentProgram===mt&&Z.lightsStateVersion===Ie)return sa(L,Re),mt}else Re.uniforms=ae.getUniforms(L),N!==null&&L.isNodeMaterial&&N.build(L,Q,Re),L.onBeforeCompile(Re,P),mt=ae.acquireProgram(Re,Le),He.set(Le,mt),Z.uniforms=Re.uniforms;let Ge=Z.uniforms;return(!L.isShaderMaterial&&!L.isRawShaderMaterial||L.clipping===!0)&&(Ge.clippingPlanes=re.uniform),sa(L,Re),Z.needsLights=Us(L),Z.lightsStateVersion=Ie,Z.needsLights&&(Ge.ambientLightColor.value=j.state.ambient,Ge.lightProbe.value=j.state.probe,Ge.sunLights.value=j.state.sun,Ge.sunLightShadows.value=j.state.sunShadow,Ge.directionalLights.value=j.state.directional,Ge.directionalLightShadows.value=j.state.directionalShadow,Ge.spotLights.value=j.state.spot,Ge.spotLightShadows.value=j.state.spotShadow,Ge.rectAreaLights.value=j.state.rectArea,Ge.ltc_1.value=j.state.rectAreaLTC1,Ge.ltc_2.value=j.state.rectAreaLTC2,Ge.pointLights.value=j.state.point,Ge.pointLightShadows.value=j.state.pointShadow,Ge.hemisphereLights.value=j.state.hemi,Ge.sunShadowMatrix.value=j.state.sunShadowMatrix,Ge.sunShadowCascade.value=j.state.sunShadowCascade,Ge.directionalShadowMatrix.value=j.state.directionalShadowMatrix,Ge.spotLightMatrix.value=j.state.spotLightMatrix,Ge.spotLightMap.value=j.state.spotLightMap,Ge.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=cn(M.state.lightProbeGridArray),Z.currentProgram=mt,Z.uniformsList=null,mt}function ii(L,W,Q,Z,j){let Ce=ze.get(L),Ie=Ce.currentProgram.id+","+Z+","+j,Re=Ce.programVariants.get(Ie);return Re===void 0?(Re=Wi(L,W,Q),Ce.programVariants.set(Ie,Re)):(Ce.currentProgram=Re,Ce.uniformsList=null,Ce.outputColorSpace=Z,Ce.toneMapping=j),Re}function Os(L){if(L.uniformsList===null){let W=L.currentProgram.getUniforms();L.uniformsList=No.seqWithValue(W.seq,L.uniforms)}return L.uniformsList}function sa(L,W){let Q=ze.get(L);Q.outputColorSpace=W.outputColorSpace,Q.batching=W.batching,Q.batchingColor=W.batchingColor,Q.instancing=W.instancing,Q.instancingColor=W.instancingColor,Q.instancingMorph=W.instancingMorph,Q.skinning=W.skinning,Q.morphTargets=W.morphTargets,Q.morphNormals=W.morphNormals,Q.morphColors=W.morphColors,Q.morphTargetsCount=W.morphTargetsCount,Q.numClippingPlanes=W.numClippingPlanes,Q.numIntersection=W.numClipIntersection,Q.vertexAlphas=W.vertexAlphas,Q.vertexTangents=W.vertexTangents,Q.toneMapping=W.toneMapping}function ra(L,W,Q,Z,j){W.isScene!==!0&&(W=we),Ye.resetTextureUnits();let Ce=W.fog,Ie=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Re=ne===null?P.outputColorSpace:ne.isXRRenderTarget===!0?ne.texture.colorSpace:St.workingColorSpace,Le=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,He=k.get(Z.envMap||Ie,Le),at=Z.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,mt=!!Q.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ge=!!Q.morphAttributes.position,gt=!!Q.morphAttributes.normal,tn=!!Q.morphAttributes.color,Ot=is;Z.toneMapped&&(ne===null||ne.isXRRenderTarget===!0)&&(Ot=P.toneMapping);let Ut=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,vn=Ut!==void 0?Ut.length:0,Ue=ze.get(Z),fn=M.state.lights;if(Bt===!0&&(en===!0||L!==K)){let Ft=L===K&&Z.id===Y;re.setState(Z,L,Ft)}let bt=!1,us=!1;Z.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==fn.state.version||j.isBatchedMesh&&Ue.batching===!1||!j.isBatchedMesh&&Ue.batching===!0||j.isBatchedMesh&&Ue.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&Ue.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&Ue.instancing===!1||!j.isInstancedMesh&&Ue.instancing===!0||j.isSkinnedMesh&&Ue.skinning===!1||!j.isSkinnedMesh&&Ue.skinning===!0||j.isInstancedMesh&&Ue.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&Ue.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&Ue.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&Ue.instancingMorph===!1&&j.morphTexture!==null||Ue.envMap!==He||Z.fog===!0&&Ue.fog!==Ce||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==re.numPlanes||Ue.numIntersection!==re.numIntersection)||Ue.vertexAlphas!==at||Ue.vertexTangents!==mt||Ue.morphTargets!==Ge||Ue.morphNormals!==gt||Ue.morphColors!==tn||Ue.morphTargetsCount!==vn||Ue.numLightProbeGrids!==cn(M.state.lightProbeGridArray)?bt=!0:(Ue.outputColorSpace!==Re||Ue.toneMapping!==Ot)&&(us=!0):(bt=!0,Ue.__version=Z.version);let pn=Ue.currentProgram;(bt===!0||us===!0)&&(pn=us===!0?ii(Z,W,j,Re,Ot):Wi(Z,W,j),N&&Z.isNodeMaterial&&N.onUpdateProgram(Z,pn,Ue));let qr=!1,$i=!1,hs=!1,ft=pn.getUniforms(),sn=Ue.uniforms;if(ye.useProgram(pn.program)&&(qr=!0,$i=!0,hs=!0),Z.id!==Y&&(Y=Z.id,$i=!0),qr||K!==L){ye.buffers.depth.getReversed()&&L.reversedDepth!==!0&&(L._reversedDepth=!0,L.updateProjectionMatrix()),ft.setValue(z,"projectionMatrix",L.projectionMatrix),ft.setValue(z,"viewMatrix",L.matrixWorldInverse);let mn=ft.map.cameraPosition;mn!==void 0&&mn.setValue(z,dn.setFromMatrixPosition(L.matrixWorld)),Qe.logarithmicDepthBuffer&&ft.setValue(z,"logDepthBufFC",2/(Math.log(L.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&ft.setValue(z,"isOrthographic",L.isOrthographicCamera===!0),K!==L&&(K=L,$i=!0,hs=!0)}if(Ue.needsLights&&(fn.state.sunShadowMap.length>0&&ft.setValue(z,"sunShadowMap",fn.state.sunShadowMap,Ye),fn.state.directionalShadowMap.length>0&&ft.setValue(z,"directionalShadowMap",fn.state.directionalShadowMap,Ye),fn.state.spotShadowMap.length>0&&ft.setValue(z,"spotShadowMap",fn.state.spotShadowMap,Ye),fn.state.pointShadowMap.length>0&&ft.setValue(z,"pointShadowMap",fn.state.pointShadowMap,Ye)),j.isSkinnedMesh){ft.setOptional(z,j,"bindMatrix"),ft.setOptional(z,j,"bindMatrixInverse");let Ft=j.skeleton;Ft&&(Ft.boneTexture===null&&Ft.computeBoneTexture(),ft.setValue(z,"boneTexture",Ft.boneTexture,Ye))}j.isBatchedMesh&&(ft.setOptional(z,j,"batchingTexture"),ft.setValue(z,"batchingTexture",j._matricesTexture,Ye),ft.setOptional(z,j,"batchingIdTexture"),ft.setValue(z,"batchingIdTexture",j._indirectTexture,Ye),ft.setOptional(z,j,"batchingColorTexture"),j._colorsTexture!==null&&ft.setValue(z,"batchingColorTexture",j._colorsTexture,Ye));let Hn=Q.morphAttributes;if((Hn.position!==void 0||Hn.normal!==void 0||Hn.color!==void 0)&&oe.update(j,Q,pn),($i||Ue.receiveShadow!==j.receiveShadow)&&(Ue.receiveShadow=j.receiveShadow,ft.setValue(z,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(sn.envMapIntensity.value=W.environmentIntensity),sn.dfgLUT!==void 0&&(sn.dfgLUT.value=vE()),$i){if(ft.setValue(z,"toneMappingExposure",P.toneMappingExposure),Ue.needsLights&&$r(sn,hs),Ce&&Z.fog===!0&&ve.refreshFogUniforms(sn,Ce),ve.refreshMaterialUniforms(sn,Z,Se,be,M.state.transmissionRenderTarget[L.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Ft=S,mn=0;for(let Un of M.state.lightProbeGridArray)Un.texture!==null&&(Ft.textures[mn]=Un.texture,Ft.min[mn]=Un.boundingBox.min,Ft.max[mn]=Un.boundingBox.max,Ft.resolution[mn]=Un.resolution,mn++);for(let Un in Ft)Ft[Un].length=mn;sn.probesSH.value=Ft.textures,sn.probesMin.value=Ft.min,sn.probesMax.value=Ft.max,sn.probesResolution.value=Ft.resolution}No.upload(z,Os(Ue),sn,Ye)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(No.upload(z,Os(Ue),sn,Ye),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&ft.setValue(z,"center",j.center),ft.setValue(z,"modelViewMatrix",j.modelViewMatrix),ft.setValue(z,"normalMatrix",j.normalMatrix),ft.setValue(z,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Ft=Z.uniformsGroups;for(let mn=0,Un=Ft.length;mn<Un;mn++){let Ml=Ft[mn];Xe.update(Ml,pn),Xe.bind(Ml,pn)}}return pn}function $r(L,W){L.ambientLightColor.needsUpdate=W,L.lightProbe.needsUpdate=W,L.sunLights.needsUpdate=W,L.sunLightShadows.needsUpdate=W,L.directionalLights.needsUpdate=W,L.directionalLightShadows.needsUpdate=W,L.pointLights.needsUpdate=W,L.pointLightShadows.needsUpdate=W,L.spotLights.needsUpdate=W,L.spotLightShadows.needsUpdate=W,L.rectAreaLights.needsUpdate=W,L.hemisphereLights.needsUpdate=W}function Us(L){return L.isMeshLambertMaterial||L.isMeshToonMaterial||L.isMeshPhongMaterial||L.isMeshStandardMaterial||L.isShadowMaterial||L.isShaderMaterial&&L.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return B},this.getRenderTarget=function(){return ne},this.setRenderTargetTextures=function(L,W,Q){let Z=ze.get(L);Z.__autoAllocateDepthBuffer=L.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),ze.get(L.texture).__webglTexture=W,ze.get(L.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:Q,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(L,W){let Q=ze.get(L);Q.__webglFramebuffer=W,Q.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(L,W=0,Q=0){ne=L,$=W,B=Q;let Z=null,j=!1,Ce=!1;if(L){let Re=ze.get(L);if(Re.__useDefaultFramebuffer!==void 0){ye.bindFramebuffer(z.FRAMEBUFFER,Re.__webglFramebuffer),ee.copy(L.viewport),de.copy(L.scissor),ce=L.scissorTest,ye.viewport(ee),ye.scissor(de),ye.setScissorTest(ce),Y=-1;return}else if(Re.__webglFramebuffer===void 0)Ye.setupRenderTarget(L);else if(Re.__hasExternalTextures)Ye.rebindTextures(L,ze.get(L.texture).__webglTexture,ze.get(L.depthTexture).__webglTexture);else if(L.depthBuffer){let at=L.depthTexture;if(Re.__boundDepthTexture!==at){if(at!==null&&ze.has(at)&&(L.width!==at.image.width||L.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(L)}}let Le=L.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ce=!0);let He=ze.get(L).__webglFramebuffer;L.isWebGLCubeRenderTarget?(Array.isArray(He[W])?Z=He[W][Q]:Z=He[W],j=!0):L.samples>0&&Ye.useMultisampledRTT(L)===!1?Z=ze.get(L).__webglMultisampledFramebuffer:Array.isArray(He)?Z=He[Q]:Z=He,ee.copy(L.viewport),de.copy(L.scissor),ce=L.scissorTest}else ee.copy(We).multiplyScalar(Se).floor(),de.copy(lt).multiplyScalar(Se).floor(),ce=ct;if(Q!==0&&(Z=F),ye.bindFramebuffer(z.FRAMEBUFFER,Z)&&ye.drawBuffers(L,Z),ye.viewport(ee),ye.scissor(de),ye.setScissorTest(ce),j){let Re=ze.get(L.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+W,Re.__webglTexture,Q)}else if(Ce){let Re=W;for(let Le=0;Le<L.textures.length;Le++){let He=ze.get(L.textures[Le]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+Le,He.__webglTexture,Q,Re)}}else if(L!==null&&Q!==0){let Re=ze.get(L.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Re.__webglTexture,Q)}Y=-1};function Xr(L){let W=ze.get(L);return(W.__readFormat!==L.format||W.__readType!==L.type)&&(W.__readFormat=L.format,W.__readType=L.type,W.__formatReadable=Qe.textureFormatReadable(L.format),W.__typeReadable=Qe.textureTypeReadable(L.type)),W}this.readRenderTargetPixels=function(L,W,Q,Z,j,Ce,Ie,Re=0){if(!(L&&L.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=ze.get(L).__webglFramebuffer;if(L.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){ye.bindFramebuffer(z.FRAMEBUFFER,Le);try{let He=L.textures[Re],at=He.format,mt=He.type;L.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let Ge=Xr(He);if(Ge.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=L.width-Z&&Q>=0&&Q<=L.height-j&&z.readPixels(W,Q,Z,j,_e.convert(at),_e.convert(mt),Ce)}finally{let He=ne!==null?ze.get(ne).__webglFramebuffer:null;ye.bindFramebuffer(z.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(L,W,Q,Z,j,Ce,Ie,Re=0){if(!(L&&L.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=ze.get(L).__webglFramebuffer;if(L.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(W>=0&&W<=L.width-Z&&Q>=0&&Q<=L.height-j){ye.bindFramebuffer(z.FRAMEBUFFER,Le);let He=L.textures[Re],at=He.format,mt=He.type;L.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Re);let Ge=Xr(He);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,gt),z.bufferData(z.PIXEL_PACK_BUFFER,Ce.byteLength,z.STREAM_READ),z.readPixels(W,Q,Z,j,_e.convert(at),_e.convert(mt),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let tn=ne!==null?ze.get(ne).__webglFramebuffer:null;ye.bindFramebuffer(z.FRAMEBUFFER,tn);let Ot=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Fg(z,Ot,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,gt),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Ce),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(gt),z.deleteSync(Ot),Ce}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(L,W=null,Q=0){let Z=Math.pow(2,-Q),j=Math.floor(L.image.width*Z),Ce=Math.floor(L.image.height*Z),Ie=W!==null?W.x:0,Re=W!==null?W.y:0;Ye.setTexture2D(L,0),z.copyTexSubImage2D(z.TEXTURE_2D,Q,0,0,Ie,Re,j,Ce),ye.unbindTexture()},this.copyTextureToTexture=function(L,W,Q=null,Z=null,j=0,Ce=0){let Ie,Re,Le,He,at,mt,Ge,gt,tn,Ot=L.isCompressedTexture?L.mipmaps[Ce]:L.image;if(Q!==null)Ie=Q.max.x-Q.min.x,Re=Q.max.y-Q.min.y,Le=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,at=Q.min.y,mt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-j);Ie=Math.floor(Ot.width*ft),Re=Math.floor(Ot.height*ft),L.isDataArrayTexture?Le=Ot.depth:L.isData3DTexture?Le=Math.floor(Ot.depth*ft):Le=1,He=0,at=0,mt=0}Z!==null?(Ge=Z.x,gt=Z.y,tn=Z.z):(Ge=0,gt=0,tn=0);let Ut=_e.convert(W.format),vn=_e.convert(W.type),Ue;W.isData3DTexture?(Ye.setTexture3D(W,0),Ue=z.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Ye.setTexture2DArray(W,0),Ue=z.TEXTURE_2D_ARRAY):(Ye.setTexture2D(W,0),Ue=z.TEXTURE_2D),ye.activeTexture(z.TEXTURE0),ye.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,W.flipY),ye.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),ye.pixelStorei(z.UNPACK_ALIGNMENT,W.unpackAlignment);let fn=ye.getParameter(z.UNPACK_ROW_LENGTH),bt=ye.getParameter(z.UNPACK_IMAGE_HEIGHT),us=ye.getParameter(z.UNPACK_SKIP_PIXELS),pn=ye.getParameter(z.UNPACK_SKIP_ROWS),qr=ye.getParameter(z.UNPACK_SKIP_IMAGES);ye.pixelStorei(z.UNPACK_ROW_LENGTH,Ot.width),ye.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Ot.height),ye.pixelStorei(z.UNPACK_SKIP_PIXELS,He),ye.pixelStorei(z.UNPACK_SKIP_ROWS,at),ye.pixelStorei(z.UNPACK_SKIP_IMAGES,mt);let $i=L.isDataArrayTexture||L.isData3DTexture,hs=W.isDataArrayTexture||W.isData3DTexture;if(L.isDepthTexture){let ft=ze.get(L),sn=ze.get(W),Hn=ze.get(ft.__renderTarget),Ft=ze.get(sn.__renderTarget);ye.bindFramebuffer(z.READ_FRAMEBUFFER,Hn.__webglFramebuffer),ye.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ft.__webglFramebuffer);for(let mn=0;mn<Le;mn++)$i&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ze.get(L).__webglTexture,j,mt+mn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ze.get(W).__webglTexture,Ce,tn+mn)),z.blitFramebuffer(He,at,He+Ie,at+Re,Ge,gt,Ge+Ie,gt+Re,z.DEPTH_BUFFER_BIT,z.NEAREST);ye.bindFramebuffer(z.READ_FRAMEBUFFER,null),ye.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(j!==0||L.isRenderTargetTexture||ze.has(L)){let ft=ze.get(L),sn=ze.get(W);ye.bindFramebuffer(z.READ_FRAMEBUFFER,D),ye.bindFramebuffer(z.DRAW_FRAMEBUFFER,V);for(let Hn=0;Hn<Le;Hn++)$i?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ft.__webglTexture,j,mt+Hn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ft.__webglTexture,j),hs?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,sn.__webglTexture,Ce,tn+Hn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,sn.__webglTexture,Ce),j!==0?z.blitFramebuffer(He,at,He+Ie,at+Re,Ge,gt,Ge+Ie,gt+Re,z.COLOR_BUFFER_BIT,z.NEAREST):hs?z.copyTexSubImage3D(Ue,Ce,Ge,gt,tn+Hn,He,at,Ie,Re):z.copyTexSubImage2D(Ue,Ce,Ge,gt,He,at,Ie,Re);ye.bindFramebuffer(z.READ_FRAMEBUFFER,null),ye.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else hs?L.isDataTexture||L.isData3DTexture?z.texSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,vn,Ot.data):W.isCompressedArrayTexture?z.compressedTexSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,Ot.data):z.texSubImage3D(Ue,Ce,Ge,gt,tn,Ie,Re,Le,Ut,vn,Ot):L.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Ce,Ge,gt,Ie,Re,Ut,vn,Ot.data):L.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Ce,Ge,gt,Ot.width,Ot.height,Ut,Ot.data):z.texSubImage2D(z.TEXTURE_2D,Ce,Ge,gt,Ie,Re,Ut,vn,Ot);ye.pixelStorei(z.UNPACK_ROW_LENGTH,fn),ye.pixelStorei(z.UNPACK_IMAGE_HEIGHT,bt),ye.pixelStorei(z.UNPACK_SKIP_PIXELS,us),ye.pixelStorei(z.UNPACK_SKIP_ROWS,pn),ye.pixelStorei(z.UNPACK_SKIP_IMAGES,qr),Ce===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&z.generateMipmap(Ue),ye.unbindTexture()},this.initRenderTarget=function(L){ze.get(L).__webglFramebuffer===void 0&&Ye.setupRenderTarget(L)},this.initTexture=function(L){L.isCubeTexture?Ye.setTextureCube(L,0):L.isData3DTexture?Ye.setTexture3D(L,0):L.isDataArrayTexture||L.isCompressedArrayTexture?Ye.setTexture2DArray(L,0):Ye.setTexture2D(L,0),ye.unbindTexture()},this.resetState=function(){$=0,B=0,ne=null,ye.reset(),Ee.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Si}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};function Nr(n){let e=new Ts;if(e.userData.nearer=n,n===0)return e;let t={value:n};return e.onBeforeCompile=i=>{i.uniforms.nearer=t,i.vertexShader=`uniform float nearer;
${i.vertexShader}`.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * nearer, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},e}function ko(n,e,t,i,s,r){let o=n[t]-n[e],a=n[t+1]-n[e+1],l=n[t+2]-n[e+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let x=0;x<3;x++)s[r+12+x]=(n[e+x]+n[t+x])/2;s[r+15]=1}var Eu="#d55e00",Tu="#0072b2",M0=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"],A0=["#735826","#54458a","#35693a","#8c4467","#0b5a8a","#525252"];function T0(n){return A0[n%A0.length]}function tl(n){return M0[n%M0.length]}var bE=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],SE=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],wE=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function yf(n){let e=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function t(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=e[o][a];s[a]=l+(r-o)*(e[o+1][a]-l)}return s}return{at:t,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var Oo=yf(bE),C0=yf(SE),Cu=yf(wE),_f=null;function _t(n){return getComputedStyle(_f??document.documentElement).getPropertyValue(n).trim()}function vf(){let n=document.createElement("div");return n.className="paper",document.body.append(n),_f=n,()=>{_f=null,n.remove()}}function R0(n){let e=vf();try{return n()}finally{e()}}function sr(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}var E0=[[],[8,4],[8,3,2,3],[2,3]],ME=7;function Fi(n){return{colour:_t(`--line-${n%ME}`),dash:E0[n%E0.length]}}var AE=32767,rr=24,EE=5/3*Math.PI,TE=.22,bf=.11,P0=.7,I0=3,L0=1e-6;function N0(n){let e=n.turns.map(l=>({...l,pivot:Kt(l.pivot,Float32Array),axis:Float32Array.from(Kt(l.axis,Int16Array),c=>c/AE),left:l.left&&Kt(l.left,Float32Array)})),t=n.pushes.map(l=>({...l,force:l.force&&Kt(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:Kt(n.time,Float64Array),turns:e,pushes:t,strengthsAt:r,summed:o,largestTurn:a(e),largestPush:a(t)}}function D0({drives:n,strengthsAt:e},t,i){let s=e(t);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function k0(n){let{time:e,turns:t,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...t.map(T=>T.radius)),c=.05*n.mesh.span_m,u=Nr(Math.max(l,c)),h=new fi(new wi(1,1,1,10),u,t.length*rr+i.length),d=new fi(new Er(1,1,16),u,t.length+i.length),f=new Ln;for(let T of[h,d])T.frustumCulled=!1,f.add(T);let p=new Float32Array(3*(rr+2)),[x,m]=[0,0],g=(T,P,C,N,F)=>ko(p,3*P,3*C,N,T.instanceMatrix.array,16*F);function _(T,P){for(let C=0;C<3;C++)p[3*T+C]=P[C]}function w(T,P,C,N){let[F,D]=Dr(e,C),$=(T.left?Sf(T.left,1,F,D)[0]:1)*r(T.shares,N)/o;if(!(Math.abs($)>L0))return;let[B,ne]=T.ends?CE(P,T.ends):[T.pivot,T.axis].map(fe=>Sf(fe,3,F,D)),Y=PE(ne,T),K=RE(ne,Y),ee=EE*Math.min(1.2,Math.abs($))*Math.sign($),de=fe=>B.map((xe,be)=>xe+T.radius*(Math.cos(fe)*Y[be]+Math.sin(fe)*K[be]));for(let fe=0;fe<=rr;fe++)_(fe,de(ee*(fe/rr-.5)));let ce=ee/2;_(rr+1,de(ce+Math.sign($)*P0));let te=bf*T.radius;for(let fe=0;fe<rr;fe++)g(h,fe,fe+1,te,x++);g(d,rr,rr+1,I0*te,m++)}function S(T,P,C,N){let[F,D]=Dr(e,C),V=T.force?Sf(T.force,1,F,D)[0]:r(T.shares,N)/a;if(!(Math.abs(V)>L0))return;let $=TE*n.mesh.span_m*V,B=P.subarray(3*T.point,3*T.point+3),ne=Y=>T.direction.map((K,ee)=>B[ee]+Y*K);_(0,B),_(1,ne($)),_(2,ne($+Math.sign(V)*P0*c)),g(h,0,1,bf*c,x++),g(d,1,2,I0*bf*c,m++)}function A(T){[x,m]=[0,0];let P=s(T),C=n.pointsAt(T);for(let N of t)w(N,C,T,P);for(let N of i)S(N,C,T,P);[h.count,d.count]=[x,m];for(let N of[h,d])N.visible=N.count>0,N.instanceMatrix.needsUpdate=!0}let M=()=>u.color.set(new je(_t("--effort")));function y(){for(let T of[h,d])T.dispose(),T.geometry.dispose()}return{group:f,pose:A,paint:M,count:()=>m,dispose:y}}function Sf(n,e,t,i){if(n.length===e)return Array.from(n);let s=Math.min(t+1,n.length/e-1);return Array.from({length:e},(r,o)=>{let a=n[t*e+o];return a+i*(n[s*e+o]-a)})}function CE(n,[e,t]){let[i,s]=[e,t].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function RE(n,e){return[0,1,2].map(t=>n[(t+1)%3]*e[(t+2)%3]-n[(t+2)%3]*e[(t+1)%3])}function PE(n,e){e.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let t=n[e.side],i=n.map((r,o)=>(o===e.side?1:0)-t*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var Is="tendon energy",Mf=Symbol("readings of single creases");function Kt(n,e){let t=atob(n),i=new Uint8Array(t.length);for(let s=0;s<t.length;s++)i[s]=t.charCodeAt(s);return new e(i.buffer)}function O0({low:n,step:e,steps:t}){return Float32Array.from(Kt(t,Uint16Array),(i,s)=>n[s%n.length]+e[s%n.length]*i)}function Kn(n){let e=Kt(n.time,Float64Array),t=typeof n.points=="string"?Kt(n.points,Float32Array):O0(n.points),i=3*n.pointCount,s={[Is]:{width:n.tendonParts.length,values:Kt(n.tendonEnergy_J,Float32Array)}};for(let _ of n.readings)s[_.name]={width:_.parts.length,values:Kt(_.values,Float32Array)};let{creases:r=null}=n,o=(n.along??[]).map(_=>({..._,key:Symbol(_.name)}));for(let{key:_,values:w}of o)s[_]={width:1,values:Kt(w,Float32Array)};r&&(s[Mf]={width:r.values.low.length,values:O0(r.values)});let a=Int32Array.from(n.between),l=Float64Array.from(n.share),c=new Float32Array(i);function u(_,w=c){return wf(e,t,i,_,w),w}function h(_,w=new Float32Array(3*l.length)){return d(u(_),w)}function d(_,w){for(let S=0;S<l.length;S++){let A=3*a[2*S],M=3*a[2*S+1];for(let y=0;y<3;y++){let v=_[A+y];w[3*S+y]=v+l[S]*(_[M+y]-v)}}return w}function f(_,w,S=new Float32Array(s[_].width)){return wf(e,s[_].values,s[_].width,w,S),S}function p(_,w){let{width:S,values:A}=s[_];return Float32Array.from(e,(M,y)=>A[y*S+w])}let x=Kt(n.restLength_m,Float32Array);function m(_,w){x.length===w.length?w.set(x):wf(e,x,w.length,_,w)}let g=n.efforts&&N0(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,g?.pushes.length?.12*n.span_m:0,...(g?.turns??[]).map(_=>.4*_.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,along:o,creases:r,time:e,start:e[0],end:e[e.length-1],efforts:g,strained:n.built!==null,stressed:!!n.membraneLaw,builtVertices:()=>d(Kt(n.built,Float32Array),new Float32Array(3*l.length)),restLengthsAt:m,pointsAt:u,verticesAt:h,verticesOf:d,valuesAt:f,line:p,stageAt:_=>n.stages.findLast(w=>w.start<=_)??n.stages[0],markAt:_=>n.marks.find(w=>Math.abs(w.time-_)<1e-9)}}function wf(n,e,t,i,s){let[r,o]=Dr(n,i),a=r*t,l=Math.min(r+1,n.length-1)*t;for(let c=0;c<t;c++){let u=e[a+c];s[c]=o===0?u:u+o*(e[l+c]-u)}}function Dr(n,e){if(!(e>n[0]))return[0,0];let t=n.length-1;if(e>=n[t])return[t,0];let i=0,s=t;for(;s-i>1;){let r=i+s>>1;n[r]<=e?i=r:s=r}return[i,(e-n[i])/(n[i+1]-n[i])]}function or(n,e,t){let[i,s]=Dr(n,t);return s===0?e[i]:e[i]+s*(e[i+1]-e[i])}function Ru(){return document.getElementById("engine-program")!==null}async function Uo(n,e){let t=new Blob([Kt(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):e(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),e({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:x=>r.postMessage(x),take:p,end:c};return f;async function p(x,m){let{frame:g}=await l({act:"load",text:x});return e=m,{...f,first:g}}}catch(u){throw c(),u}}var U0={type:"change"},Ef={type:"start"},B0={type:"end"},Pu=new Ys,F0=new ui,IE=Math.cos(70*nf.DEG2RAD),Mn=new H,ni=2*Math.PI,Pt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Af=1e-6,Iu=class extends Va{constructor(e,t=null){super(e,t),this.state=Pt.NONE,this.target=new H,this.cursor=new H,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:er.ROTATE,MIDDLE:er.DOLLY,RIGHT:er.PAN},this.touches={ONE:tr.ROTATE,TWO:tr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new H,this._lastQuaternion=new hi,this._lastTargetPosition=new H,this._quat=new hi().setFromUnitVectors(e.up,new H(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new To,this._sphericalDelta=new To,this._scale=1,this._panOffset=new H,this._rotateStart=new Je,this._rotateEnd=new Je,this._rotateDelta=new Je,this._panStart=new Je,this._panEnd=new Je,this._panDelta=new Je,this._dollyStart=new Je,this._dollyEnd=new Je,this._dollyDelta=new Je,this._dollyDirection=new H,this._mouse=new Je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=NE.bind(this),this._onPointerDown=LE.bind(this),this._onPointerUp=DE.bind(this),this._onContextMenu=VE.bind(this),this._onMouseWheel=UE.bind(this),this._onKeyDown=FE.bind(this),this._onTouchStart=BE.bind(this),this._onTouchMove=zE.bind(this),this._onMouseDown=kE.bind(this),this._onMouseMove=OE.bind(this),this._interceptControlDown=GE.bind(this),this._interceptControlUp=HE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Pt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(U0),this.update(),this.state=Pt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Mn.copy(t).sub(this.target),Mn.applyQuaternion(this._quat),this._spherical.setFromVector3(Mn),this.autoRotate&&this.state===Pt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ni:i>Math.PI&&(i-=ni),s<-Math.PI?s+=ni:s>Math.PI&&(s-=ni),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Mn.setFromSpherical(this._spherical),Mn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Mn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Mn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new H(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new H(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Mn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Pu.origin.copy(this.object.position),Pu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Pu.direction))<IE?this.object.lookAt(this.target):(F0.setFromNormalAndCoplanarPoint(this.object.up,this.target),Pu.intersectPlane(F0,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Af||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Af||this._lastTargetPosition.distanceToSquared(this.target)>Af?(this.dispatchEvent(U0),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ni/60*this.autoRotateSpeed*e:ni/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Mn.setFromMatrixColumn(t,0),Mn.multiplyScalar(-e),this._panOffset.add(Mn)}_panUp(e,t){this.screenSpacePanning===!0?Mn.setFromMatrixColumn(t,1):(Mn.setFromMatrixColumn(t,0),Mn.crossVectors(this.object.up,Mn)),Mn.multiplyScalar(e),this._panOffset.add(Mn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Mn.copy(s).sub(this.target);let r=Mn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ni*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ni*this._rotateDelta.x/t.clientHeight),this._rotateUp(ni*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function LE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function NE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function DE(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(B0),this.state=Pt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function kE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case er.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Pt.DOLLY;break;case er.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}break;case er.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Pt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Pt.PAN}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Ef)}function OE(n){switch(this.state){case Pt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Pt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Pt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function UE(n){this.enabled===!1||this.enableZoom===!1||this.state!==Pt.NONE||(n.preventDefault(),this.dispatchEvent(Ef),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(B0))}function FE(n){this.enabled!==!1&&this._handleKeyDown(n)}function BE(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case tr.ROTATE:if(this.enableRotate===!1){this.state=Pt.NONE;break}this._handleTouchStartRotate(n),this.state=Pt.TOUCH_ROTATE;break;case tr.PAN:if(this.enablePan===!1){this.state=Pt.NONE;break}this._handleTouchStartPan(n),this.state=Pt.TOUCH_PAN;break;default:this.state=Pt.NONE}break;case 2:switch(this.touches.TWO){case tr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Pt.TOUCH_DOLLY_PAN;break;case tr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Pt.TOUCH_DOLLY_ROTATE;break;default:this.state=Pt.NONE}break;default:this.state=Pt.NONE}this.state!==Pt.NONE&&this.dispatchEvent(Ef)}function zE(n){switch(this._trackPointer(n),this.state){case Pt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Pt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Pt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Pt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Pt.NONE}}function VE(n){this.enabled!==!1&&n.preventDefault()}function GE(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function HE(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Tf=120,z0=2,V0=6;function Cf(n,e,t){let i=new WeakMap,s=e.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...e.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=t;if(!i.has(l)){let c=Array.from({length:Tf+1},(u,h)=>t.timeAt(h/Tf));i.set(l,c.map(u=>e.map(h=>n[h].pointsAt(t.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===t.span)return r;let h=o().map(d=>WE(d,l,c,s));return r={key:u,span:t.span,rows:$E(h),whole:G0(h)},r}return function(c,u,h,d){let f=new H().crossVectors(u,c).normalize(),p=[f,new H().crossVectors(c,f),c],{rows:x,whole:m}=a(p,h),g=d?XE(x,t.wayAt(t.time)*Tf):m,[_,w,S,A,M,y]=g,v=[(_-w)/2,(S-A)/2,(M-y)/2],T=Math.max((_+w)/(2*h[0]),(S+A)/(2*h[1])),P=new H;for(let[C,N]of p.entries())P.addScaledVector(N,v[C]);return{target:P,distance:T-v[2]||1}}}function WE(n,e,t,i){let s=new Float64Array(V0).fill(-1/0),r=t.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=e.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,x]=[u(a,h,d),u(l,h,d),u(c,h,d)],[m,g]=[t[0]*x,t[1]*x],_=[f+m,m-f,p+g,g-p,x,-x];for(let w=0;w<V0;w++)_[w]>s[w]&&(s[w]=_[w])}return s.map((h,d)=>h+o[d])}function G0(n){return n.reduce((e,t)=>e.map((i,s)=>Math.max(i,t[s])))}function $E(n){let e=(i,s)=>i.slice(Math.max(0,s-z0),s+z0+1),t=n.map((i,s)=>G0(e(n,s)));return n.map((i,s)=>{let r=e(t,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function XE(n,e){let t=Math.min(n.length-2,Math.max(0,Math.floor(e))),i=Math.min(1,Math.max(0,e-t));return n[t].map((s,r)=>s+i*(n[t+1][r]-s))}var H0=28,qE=1.05,W0=Math.PI/24,YE=1.15,kr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function $0(n,e,t,i,s=ar()){let{size:r,target:o}=ZE(e),a=e.map((A,M)=>M),l=Cf(e,a,t),c=a.map(A=>Cf(e,[A],t)),u=new Yn(H0,1,.02*r,60*r);u.up.set(0,0,1);let h=new Iu(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(A=0){let M=s.oneScale?l:c[A],y=Math.tan(H0*Math.PI/360)/qE;d=M(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let A=u.position.clone().sub(h.target);s.closer=A.length()/d.distance,s.towards.copy(A).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let x=A=>{document.activeElement!==n&&!A.ctrlKey&&A.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function m({towards:A}){s.towards.set(...A).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function g(A,M){let y=s.towards.clone().applyAxisAngle(u.up,A*W0),v=new H().crossVectors(u.up,y).normalize(),T=y.clone().applyAxisAngle(v,-M*W0);s.towards.copy(Math.abs(T.z)<.9999?T:y),p()}function _(A){let M=s.closer*d.distance*YE**-A;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,M))/d.distance,p()}function w(A){Object.assign(s,A),p()}function S(A,M){u.aspect=A,u.updateProjectionMatrix(),h.rotateSpeed=M,h.panSpeed=M,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:m,turn:g,zoom:_,choose:w,resize:S,dispose:()=>h.dispose()}}function ar(){return{towards:new H(...kr[0].towards).normalize(),closer:1,aside:new H,following:!0,oneScale:!0,scale:1}}function ZE(n){let e=new H(1/0,1/0,1/0),t=new H(-1/0,-1/0,-1/0),i=new H;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),e.min(i),t.max(i)}}let s=e.clone().add(t).multiplyScalar(.5);return{target:s,size:t.distanceTo(s)||1}}function Fo(n,e,{clientWidth:t,clientHeight:i}){let{x:s,y:r}=n.project(e);return[(s+1)/2*t,(1-r)/2*i]}var nl=1/0,Rf=1e-4;function X0(n,e,t){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:e.units.length)*Mm(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=t,a=t,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,x)=>p!==nl?n.pointsAt(p,x):x?(x.set(o.points),x):o.points,h={...n,marks:[],efforts:null,stressed:!1,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,x)=>p===nl?n.verticesOf(o.points,x):n.verticesAt(p,x),valuesAt(p,x,m){if(x!==nl)return n.valuesAt(p,x,m);let g=n.readings.findIndex(w=>w.name===p),_=p===Is?o.energies_J:o.readings[g].map(w=>s[g]*w);return m?(m.set(_),m):Float32Array.from(_)},restLengthsAt(p,x){p===nl?x.set(o.restLengths_m):n.restLengthsAt(p,x)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,x=nl)=>x,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!jE(p,a,Rf*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function jE(n,e,t){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,e.points,t)||n.readings.some((s,r)=>i(s,e.readings[r],Rf*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,e.energies_J,Rf*Math.max(...e.energies_J))||i(n.restLengths_m,e.restLengths_m,0)}var KE=16,JE=6;function q0(n,e,t){let{lines:i}=e.creases,[s,r]=[n.canvas,n.cells[0]],o=b("p",{className:"crease-label","aria-hidden":"true",hidden:!0}),a=b("span",{className:"crease-mark","aria-hidden":"true",hidden:!0});r.append(a,o);let l=b("select",{},b("option",{value:""},"none"),...i.map(({name:y},v)=>b("option",{value:String(v)},y))),c=b("output",{"aria-live":"off"}),u=b("span",{},"or point at one in the picture, or touch it"),h=new H,d=null,f=null,p=null;function x(y){return Fo(h.fromArray(n.views[0].shape.vertices,3*y),n.eye.camera,r)}function m(y){let v=s.getBoundingClientRect(),T=[y.clientX-v.left,y.clientY-v.top],[P,C]=[null,KE];for(let[N,{ends:F}]of i.entries()){let D=QE(T,...F.map(x))+g(F);D<C&&([P,C]=[N,D])}return P}let g=y=>h.fromArray(_(y)).distanceTo(n.eye.camera.position)/(1e3*n.eye.size);function _(y){let{vertices:v}=n.views[0].shape;return[0,1,2].map(T=>(v[3*y[0]+T]+v[3*y[1]+T])/2)}function w(y){let{lines:v,columns:T}=e.creases,P=e.valuesAt(Mf,t.clipTime(0));return v[y].columns.map(C=>{let{name:N,unit:F}=T[C],D=F==="°"?`${kn(P[C],1)}°`:`${Mt(Number(P[C].toPrecision(3)))} ${F}`;return`${N} ${D}`}).join(", ")}function S(){let y=f??d;if(o.hidden=a.hidden=y===null,c.textContent=d===null?"":w(d),u.hidden=d!==null,y===null)return;o.textContent=`${i[y].name}: ${w(y)}`;let[v,T]=i[y].ends.map(x),P=Math.hypot(T[0]-v[0],T[1]-v[1]),C=Math.atan2(T[1]-v[1],T[0]-v[0]);a.style.width=`${P.toFixed(1)}px`,a.style.transform=`translate(${v[0].toFixed(1)}px, ${v[1].toFixed(1)}px) rotate(${C.toFixed(4)}rad)`}let A=y=>{y!==f&&(f=y,S())},M=y=>{d=y,l.value=y===null?"":String(y),S()};return n.listen("pointermove",y=>{y.pointerType==="mouse"&&A(y.buttons?null:m(y))}),n.listen("pointerleave",()=>A(null)),n.listen("pointerdown",y=>{p=y.isPrimary?[y.clientX,y.clientY]:null}),n.listen("pointerup",y=>{if(!p||Math.hypot(y.clientX-p[0],y.clientY-p[1])>JE)return;let v=m(y);M(v===d?null:v)}),l.addEventListener("change",()=>M(l.value===""?null:Number(l.value))),n.onDraw(S),b("div",{className:"crease-choice"},b("label",{},`${e.creases.kind} `,l),c,u)}function QE([n,e],[t,i],[s,r]){let[o,a]=[s-t,r-i],l=Math.min(1,Math.max(0,((n-t)*o+(e-i)*a)/(o*o+a*a||1)));return Math.hypot(n-t-l*o,e-i-l*a)}var eT=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],tT="shift with ← → ↑ ↓",nT=[["+ −","nearer, further"],["0","reset the view"]];function Lu(n,e){let i=(n.length===1?n[0].marks:[]).map((r,o)=>[String(o+1),r.name]),s=[...eT,...i,[tT,`turn the ${e}`],...nT].map(([r,o])=>b("tr",{},b("th",{scope:"row"},r),b("td",{},o)));return b("details",{className:"keys"},b("summary",{},"Keys"),b("table",{},b("tbody",{},...s)),b("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var Y0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Z0({key:n,shiftKey:e},t,i,s){if(e&&n in Y0)t.turn(...Y0[n]);else if(s)if(n==="+"||n==="=")t.zoom(1);else if(n==="-"||n==="−")t.zoom(-1);else if(n==="0")t.show(i);else return!1;else return!1;return!0}function j0(n,e,t){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&Z0(i,e,t,!0)&&i.preventDefault()})}function Nu(n,e,t,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){t.pause(),c()}function a(c,u){let{key:h}=c;if(Z0(c,i,s,u))return!0;if(h in r)o(()=>t.step(r[h]));else if(h===" ")t.playing?t.pause():t.play();else if(h==="Home")o(()=>t.seek(t.span.start));else if(h==="End")o(()=>t.seek(t.span.end));else if(u)if(e.length===1&&e[0].marks[Number(h)-1])o(()=>t.seekClip(0,e[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var K0=2.4;function il(n){let e=10**Math.floor(Math.log10(n/K0));return e*[5,2,1].find(t=>t*e<=n/K0)}function J0(n,e){let t=il(n),i=t*Math.ceil(1.25*n/t),s=[],[r,o]=[e.x,e.y].map(c=>t*Math.round(c/t));for(let c=-i;c<=i+t/2;c+=t)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new bn().setAttribute("position",new an(s,3)),l=new Ar(a,new js({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function Pf(n,e,t,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[],r=n.find(({sample:a})=>a==="table"),o=r?`grid on the ${r.text}`:"grid";return b("ul",{className:"legend"},...n.filter(({sample:a})=>a!=="table").map(({sample:a,text:l})=>a==="tendon"?sT(l,e):iT(a,l)),...n.some(({sample:a})=>a==="tendon")?[b("li",{},"slack tendons sag, drawn with their rest length")]:[],b("li",{},`squares of the ${o}: ${Gs(il(t),"m")}`),...s.map(a=>b("li",{},a)))}function iT(n,e){let[t,i]=n.split(" "),s={mountain:{color:Eu},valley:{color:Tu},region:{background:tl(i)}};return b("li",{className:t==="region"?"of-region":""},ex(t==="region"?"panel":t,s[t]??{}),e)}function sT(n,e){return If(n,"0",Oo,`${Mt(e.factor*e.largest_J)} ${e.unit}${e.orMore?" or more":""}`)}function If(n,e,t,i){let s=ex("bar",{background:t.gradient});return b("li",{className:"energy"},`${n}: `,b("span",{className:"whole"},e,s,i))}function Q0(n){let e=b("span"),t=document.createElement("canvas").getContext("2d");t.font="14px system-ui, sans-serif";let i=new Map([...new Set(n)].map(o=>[o,t.measureText(o).width])),s=[...i.keys()].reduce((o,a)=>i.get(a)>i.get(o)?a:o),r=b("span",{className:"room","aria-hidden":"true"},s);return{element:b("span",{className:"roomy"},r,e),say:o=>{e.textContent=o}}}function ex(n,e){let t=b("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(t.style,e),t}function tx(n,e){if(!(e>n*(1+1e-6)))return 0;let[t,i]=[0,e/2];for(let s=0;s<40;s++){let r=(t+i)/2;rT(n,r)<e?t=r:i=r}return(t+i)/2}function rT(n,e){return e===0?n:Math.hypot(n,4*e)/2+n*n*Math.asinh(4*e/(n||1e-12))/(8*e)}function ix(n){let{triangles:e,faces:t,membraneLaw:i}=n.mesh,s=n.builtVertices(),r=Array.from({length:t.length},(h,d)=>nx(s,e,d)),o=new Float32Array(t.reduce((h,d)=>Math.max(h,d),0)+1),a=new Float32Array(t.length);function l(h,d){let{youngs_modulus_Pa:f,poisson_ratio:p}=i;return f/(1-p*p)*((1-p)*h+p*(h+d))}function c(h,d="strain"){o.fill(-1/0);for(let f=0;f<t.length;f++){let[p,x,m]=r[f],g=p*m-x*x;if(g<=1e-9*(p+m)**2)continue;let[_,w,S]=nx(h,e,f),A=(m*_-2*x*w+p*S)/(2*g),M=(_*S-w*w)/g,y=Math.sqrt(Math.max(A*A-M,0)),[v,T]=[(A+y-1)/2,(A-y-1)/2],P=d==="stress"?l(v,T):v;o[t[f]]=Math.max(o[t[f]],P)}for(let f=0;f<t.length;f++)a[f]=Math.max(0,o[t[f]]);return a}function u(h){let d=new Float32Array(s.length),f=0;for(let p of n.time)f=c(n.verticesAt(p,d),h).reduce((x,m)=>Math.max(x,m),f);return f}return{at:c,largest:u}}function nx(n,e,t){let[i,s,r]=[0,1,2].map(c=>3*e[3*t+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var oT=.9,sx=.4,aT=.02,lT=["crease","rim","edge"],lr=12;function Lf(n,e){let{mesh:t}=n,i=new Float32Array(3*t.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...t.tubes.map(T=>T.radius)),[o,a]=[!1,!0].map(T=>uT(t,T)),l=rx(t.tubes.filter(T=>T.kind==="bar"),20,0),c=rx(t.tubes.filter(T=>lT.includes(T.kind)),8,.4*r),u=hT(n,2.4*r),h=fT(t.base),d=n.efforts?k0(n):null,f=n.strained?ix(n):null,p=null,x=pT(t),m=new Ln;m.add(h.object,a.object,l.object,x.object,c.object,u.object,o.object);for(let T of[l,x,c,u])T.object.visible=T.object.count>0;d&&m.add(d.group);let g=cT(o.object,a.object,l.object),_=[0,0,0],w=new je;function S(T){n.verticesAt(T,i),o.pose(i),a.pose(i);for(let C of[l,c,x])C.pose(i);n.valuesAt(Is,T,s);let P=s.map(C=>e>0?C/e:0);u.pose(i,T,C=>sx+(1-sx)*Math.min(1,Math.max(0,P[C])/aT));for(let C=0;C<n.tendons;C++)Oo.at(P[C],_),u.colour(C,w.setRGB(..._,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(T),p&&A()}function A(){let T=f.at(i,p.quantity),P=[0,0,0];for(let C of[o,a])C.colour(N=>w.setRGB(...Cu.at(T[N]/p.largest,P),"srgb"))}function M(T,P){p=f&&T?{quantity:T,largest:P}:null;for(let C of[o,a])C.flat(p!==null),p||C.colour(N=>w.set(tl(t.regions[N])));p&&A()}function y(){for(let T of[l,c,x,h])T.paint();d?.paint(),g.children[0].material.color.set(_t("--shadow"))}function v(){for(let T of[l,c,u,x])T.object.dispose();for(let T of[o,a])T.dispose();d?.dispose(),h.dispose();for(let T of[l,c,u,x])T.object.geometry.dispose()}return{group:m,shadow:g,pose:S,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,colourSheets:M,dispose:v}}function cT(...n){let e=new As({side:zn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:qd,stencilZPass:Xd}),t=new Ln;for(let i of n){let s=i.isInstancedMesh?new fi(i.geometry,e,i.count):new _n(i.geometry,e);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,s.visible=i.visible,t.add(s)}return t.scale.z=1e-5,t}function uT(n,e){let t=n.regions.flatMap((S,A)=>n.solid[S]===e?[A]:[]),i=t.flatMap(S=>n.triangles.slice(3*S,3*S+3)),s=t.length,r=new un(new Float32Array(3*i.length),3).setUsage(ja),o=new un(new Float32Array(3*i.length),3).setUsage(ja),a=new un(new Uint32Array(i.length),1).setUsage(ja);for(let S=0;S<i.length;S++)a.array[S]=S;let l=new bn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new Ts({vertexColors:!0,side:zn,flatShading:!0,transparent:!e,opacity:e?1:oT,depthWrite:e,forceSinglePass:!0});c.onBeforeCompile=S=>{S.fragmentShader=S.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new As({vertexColors:!0,side:zn}),h=new _n(l,c);h.visible=s>0,h.frustumCulled=!1,h.renderOrder=e?0:1;let d=new je;f(S=>d.set(tl(n.regions[S])));function f(S){for(let[A,M]of t.entries()){let y=S(M);for(let v=0;v<3;v++)y.toArray(o.array,9*A+3*v)}o.needsUpdate=!0}let p=S=>{h.material=S?u:c},x=()=>l.dispose();function m(S){for(let A=0;A<i.length;A++)for(let M=0;M<3;M++)r.array[3*A+M]=S[3*i[A]+M];r.needsUpdate=!0}let g=new Float32Array(s),_=Array.from({length:s},(S,A)=>A);function w(S){let A=r.array;for(let M=0;M<s;M++){let y=0;for(let v=0;v<3;v++){let T=9*M+v;y+=((A[T]+A[T+3]+A[T+6])/3-S.getComponent(v))**2}g[M]=y}_.sort((M,y)=>g[y]-g[M]);for(let M=0;M<s;M++)for(let y=0;y<3;y++)a.array[3*M+y]=3*_[M]+y;a.needsUpdate=!0}return{object:h,pose:m,sort:w,colour:f,flat:p,dispose:x}}function rx(n,e,t){let i=new fi(new wi(1,1,1,e),Nr(t),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())ko(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new je(Eu),V:new je(Tu),B:new je(_t("--bar"))};for(let[l,{crease:c,region:u}]of n.entries())i.setColorAt(l,u===void 0?a[c]:new je(T0(u)));n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function hT(n,e){let t=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new fi(new wi(1,1,1,12),Nr(e),t.length*lr);i.frustumCulled=!1;let s=new Float32Array(t.length),r=new Float32Array(3*(lr+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of t.entries()){dT(l,3*f[0],3*f[1],s[d],r);for(let x=0;x<lr;x++)ko(r,3*x,3*x+3,u(d)*p,h,16*(d*lr+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<lr;u++)i.setColorAt(l*lr+u,c)}return{object:i,pose:o,colour:a}}function dT(n,e,t,i,s){let r=[0,1,2].map(d=>n[t+d]-n[e+d]),o=Math.hypot(...r),a=tx(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=lr;d++){let f=d/lr,p=4*a*f*(1-f)/h;for(let x=0;x<3;x++)s[3*d+x]=n[e+x]+f*r[x]+p*u[x]}}function fT({rods:n,radius:e}){let t=new Float32Array(n.flat(2)),i=Nr(0),s=new fi(new wi(1,1,1,16),i,n.length),r=new fi(new Ao(1,16,12),i,2*n.length),o=new Ln;o.visible=n.length>0;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)ko(t,6*l,6*l+3,e,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[e,t[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose()}return{object:o,paint:()=>i.color.set(_t("--base")),dispose:a}}function pT(n){let e=new fi(new Ao(1,16,12),Nr(0),n.joints.length);e.frustumCulled=!1;let t=()=>e.material.color.set(_t("--joint"));t();function i(s){let r=e.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}e.instanceMatrix.needsUpdate=!0}return{object:e,pose:i,paint:t}}var ox="system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";function sl(n,e,t=1,[i,s]=[0,0]){n.save(),n.scale(t,t),n.translate(i,s);for(let r of e)ax(n,r);n.restore()}function ax(n,e){if(e.shapes){n.save(),e.kind==="moved"?n.translate(e.x,e.y):(n.beginPath(),n.rect(e.x,e.y,e.width,e.height),n.clip());for(let t of e.shapes)ax(n,t);n.restore();return}if(n.globalAlpha=e.opacity??1,n.setLineDash(e.dash??[]),n.lineWidth=e.lineWidth??1,e.kind==="text"){n.font=`${e.bold?"bold ":""}${e.size??12}px ${ox}`,n.textAlign={start:"left",middle:"center",end:"right"}[e.anchor??"start"],n.fillStyle=e.fill,n.fillText(e.text,e.x,e.y);return}if(n.beginPath(),e.kind==="rect"&&n.rect(e.x,e.y,e.width,e.height),e.kind==="circle"&&n.arc(e.x,e.y,e.r,0,2*Math.PI),e.kind==="path")for(let t of lx(e.points))for(let[i,s]of t.entries())n[i?"lineTo":"moveTo"](...s);(e.fill||e.scale)&&(n.fillStyle=e.scale?mT(n,e):e.fill,n.fill()),e.stroke&&(n.strokeStyle=e.stroke,n.stroke())}function mT(n,{x:e,width:t,scale:i}){let s=n.createLinearGradient(e,0,e+t,0);for(let[r,o]of i.entries())s.addColorStop(r/(i.length-1),o);return s}function lx(n){let e=[[]];for(let t of n)t?e.at(-1).push(t):e.at(-1).length&&e.push([]);return e.filter(t=>t.length)}function ku(n,e,t,i){let s={count:0},r=[{kind:"rect",x:0,y:0,width:e,height:t,fill:"#ffffff"},...n].map(o=>Du(o,s));return[`<svg xmlns="http://www.w3.org/2000/svg" width="${Vt(e)}" height="${Vt(t)}" viewBox="0 0 ${Vt(e)} ${Vt(t)}" font-family="${ox}">`,`<title>${cx(i)}</title>`,...r,`</svg>
`].join(`
`)}function Du(n,e){if(n.kind==="svg")return`<svg ${`x="${Vt(n.x)}" y="${Vt(n.y)}" width="${Vt(n.width)}" height="${Vt(n.height)}"`} viewBox="${n.viewBox}"${n.stretched?' preserveAspectRatio="none"':""}>${n.content}</svg>`;if(n.scale){let h=`scale${++e.count}`,d=n.scale.map((f,p)=>`<stop offset="${Vt(p/(n.scale.length-1))}" stop-color="${f}"/>`);return`<linearGradient id="${h}">${d.join("")}</linearGradient>${Du({...n,scale:null,fill:`url(#${h})`},e)}`}if(n.kind==="moved")return`<g transform="translate(${Vt(n.x)} ${Vt(n.y)})">${n.shapes.map(h=>Du(h,e)).join(`
`)}</g>`;if(n.kind==="clip"){let h=`clip${++e.count}`;return`${`<clipPath id="${h}"><rect x="${Vt(n.x)}" y="${Vt(n.y)}" width="${Vt(n.width)}" height="${Vt(n.height)}"/></clipPath>`}<g clip-path="url(#${h})">${n.shapes.map(f=>Du(f,e)).join(`
`)}</g>`}let{fill:t="none",stroke:i,lineWidth:s=1,dash:r,opacity:o}=n,a=[`fill="${t}"`];i&&a.push(`stroke="${i}" stroke-width="${Vt(s)}" stroke-linejoin="round"`),r?.length&&a.push(`stroke-dasharray="${r.join(" ")}"`),o!==void 0&&o!==1&&a.push(`opacity="${o}"`);let{x:l,y:c}=n;return n.kind==="rect"?`<rect x="${Vt(l)}" y="${Vt(c)}" width="${Vt(n.width)}" height="${Vt(n.height)}" ${a.join(" ")}/>`:n.kind==="circle"?`<circle cx="${Vt(l)}" cy="${Vt(c)}" r="${Vt(n.r)}" ${a.join(" ")}/>`:n.kind==="path"?`<path d="${lx(n.points).map(d=>`M${d.map(f=>f.map(Vt).join(" ")).join("L")}`).join("")}" ${a.join(" ")}/>`:`<text ${n.turned?`transform="translate(${Vt(l)} ${Vt(c)}) rotate(-90)"`:`x="${Vt(l)}" y="${Vt(c)}"`} font-size="${n.size??12}"${n.bold?' font-weight="bold"':""} text-anchor="${n.anchor??"start"}" ${a.join(" ")}>${cx(n.text)}</text>`}var Vt=n=>String(Number(n.toFixed(2))),cx=n=>n.replace(/[&<>"]/g,e=>`&#${e.charCodeAt(0)};`);var Ou=8,gT=["fill","stroke","stroke-width","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","font-size","font-weight","paint-order","text-anchor"],xT=new Set(["fill","stroke"]);function cr(n,e,t=null){for(let i of n)i.classList.add("paper");try{let i=n.map(c=>c.getBoundingClientRect()),[s,r]=[Math.min(...i.map(c=>c.left))-Ou,Math.min(...i.map(c=>c.top))-Ou],[o,a]=[Math.max(...i.map(c=>c.right))-s+Ou,Math.max(...i.map(c=>c.bottom))-r+Ou],l=n.flatMap(c=>Df(c,s,r,t));return{svg:ku(l,o,a,e),width:o,height:a}}finally{for(let i of n)i.classList.remove("paper")}}function Nf(n){n.classList.add("paper");try{let{left:e,top:t,width:i,height:s}=n.getBoundingClientRect();return{shapes:Df(n,e,t,null),width:i,height:s}}finally{n.classList.remove("paper")}}function Df(n,e,t,i){let s=getComputedStyle(n);if(s.display==="none"||s.visibility==="hidden"||i&&n.matches(i))return[];let r=n.getBoundingClientRect(),o={x:r.left-e,y:r.top-t,width:r.width,height:r.height};if(n.localName==="svg")return[{kind:"svg",...o,viewBox:n.getAttribute("viewBox"),stretched:n.getAttribute("preserveAspectRatio")==="none",content:bT(n)}];let a=[];r.width&&r.height&&a.push(..._T(s,o)),a.push(...yT(s,o));for(let l of n.childNodes)l.nodeType===Node.TEXT_NODE?a.push(...vT(l,s,e,t)):l.nodeType===Node.ELEMENT_NODE&&a.push(...Df(l,e,t,i));return a}function _T(n,e){let t=rl(n.backgroundColor),i=n.borderTopLeftRadius==="50%"&&e.width===e.height,s=[];t.opacity>0&&!i&&s.push({kind:"rect",...e,fill:t.text,opacity:t.opacity});let r=/^linear-gradient\(to right, (.*)\)$/.exec(n.backgroundImage);return r&&s.push({kind:"rect",...e,scale:r[1].match(/rgb\([^)]*\)/g)}),i&&s.push({kind:"circle",x:e.x+e.width/2,y:e.y+e.height/2,r:e.width/2-1,stroke:rl(n.borderTopColor).text,lineWidth:parseFloat(n.borderTopWidth),...t.opacity?{fill:t.text}:{}}),s}function yT(n,{x:e,y:t,width:i,height:s}){if(n.borderTopLeftRadius==="50%")return[];let r={Top:[[e,t],[e+i,t]],Right:[[e+i,t],[e+i,t+s]],Bottom:[[e,t+s],[e+i,t+s]],Left:[[e,t],[e,t+s]]};return Object.entries(r).flatMap(([o,a])=>{let[l,c]=[n[`border${o}Style`],parseFloat(n[`border${o}Width`])];if(l==="none"||!c)return[];let u=rl(n[`border${o}Color`]);return u.opacity?[{kind:"path",points:a,stroke:u.text,lineWidth:c,opacity:u.opacity,...l==="dashed"?{dash:[2*c,c]}:{}}]:[]})}function vT(n,e,t,i){let s=parseFloat(e.fontSize),r={size:s,bold:Number(e.fontWeight)>=600,fill:rl(e.color).text},o=document.createRange(),a=[];for(let{index:l,0:c}of n.data.matchAll(/\S+/g)){o.setStart(n,l),o.setEnd(n,l+c.length);let[u]=o.getClientRects();if(!u)continue;let h=a.at(-1),d=e.writingMode==="horizontal-tb";h&&Math.abs(d?h.box.top-u.top:h.box.left-u.left)<2?(h.words.push(c),h.last=u):a.push({words:[c],box:u,last:u})}return e.writingMode==="horizontal-tb"?a.map(({words:l,box:c})=>({kind:"text",x:c.left-t,y:c.top-i+c.height/2+.35*s,text:l.join(" "),...r})):a.map(({words:l,box:c,last:u})=>({kind:"text",x:(c.left+c.right)/2-t+.35*s,y:(Math.min(c.top,u.top)+Math.max(c.bottom,u.bottom))/2-i,text:l.join(" "),anchor:"middle",turned:!0,...r}))}function bT(n){let e=n.cloneNode(!0),[t,i]=[n,e].map(s=>[...s.querySelectorAll("*")]);for(let[s,r]of t.entries()){let o=getComputedStyle(r),a=i[s];for(let{name:l}of[...a.attributes])/^(aria-|data-|class$|role$|tabindex$|style$)/.test(l)&&a.removeAttribute(l);if(!(r.localName==="g"||r.localName==="title"))for(let l of gT){let c=o.getPropertyValue(l);if(!xT.has(l))a.setAttribute(l,c);else{let{text:u,opacity:h}=c==="none"?{text:"none",opacity:1}:rl(c);a.setAttribute(l,h?u:"none"),h&&h<1&&a.setAttribute(`${l}-opacity`,h)}}}return new XMLSerializer().serializeToString(e).replace(/^<svg[^>]*>|<\/svg>$/g,"")}function rl(n){let e=(n.match(/[\d.]+(?:e-?\d+)?%?/g)??[]).map(Number);return{text:`rgb(${(n.startsWith("color(")?e.slice(0,3).map(i=>255*i):e.slice(0,3)).map(Math.round).join(",")})`,opacity:e[3]??1}}function ux(n,e,t){let i=[];return{add:s=>i.push(ST(s)),bytes:()=>wT(i,n,e,Math.round(100*t))}}function ST(n){let e=new Uint16Array(n.length/4);for(let t=0;t<e.length;t++)e[t]=n[4*t]>>3<<10|n[4*t+1]>>3<<5|n[4*t+2]>>3;return e}function wT(n,e,t,i){let{palette:s,indexOf:r}=AT(n),o=[],a=c=>o.push(c&255,c>>8);o.push(...new TextEncoder().encode("GIF89a")),a(e),a(t),o.push(247,0,0,...s),o.push(33,255,11,...new TextEncoder().encode("NETSCAPE2.0"),3,1,0,0,0);let l=null;for(let c of n){let u=Uint8Array.from(c,(d,f)=>l&&l[f]===d?255:r[d]);o.push(33,249,4,5),a(i),o.push(255,0,44);for(let d of[0,0,e,t])a(d);o.push(0,8);let h=MT(u);for(let d=0;d<h.length;d+=255){let f=Math.min(d+255,h.length);o.push(f-d);for(let p=d;p<f;p++)o.push(h[p])}o.push(0),l=c}return o.push(59),Uint8Array.from(o)}function MT(n){let e=[],[t,i]=[0,0],s=9,r=258,o=new Int32Array(1048576).fill(-1),a=c=>{for(t|=c<<i,i+=s;i>=8;)e.push(t&255),t>>>=8,i-=8};a(256);let l=n[0];for(let c=1;c<n.length;c++){let u=l<<8|n[c];if(o[u]>=0){l=o[u];continue}a(l),r<4096?(o[u]=r,r===1<<s&&s<12&&s++,r++):(a(256),o.fill(-1),[s,r]=[9,258]),l=n[c]}return a(l),a(257),i&&e.push(t&255),e}function AT(n){let e=new Uint32Array(32768);for(let o of n)for(let a=0;a<o.length;a++)e[o[a]]++;let t=[...e.keys()].filter(o=>e[o]),i=[kf(t,e)];for(;i.length<255;){let o=i.reduce((c,u)=>u.spread>c.spread?u:c);if(!o.spread)break;let a=o.colours.sort((c,u)=>Uu(c)[o.channel]-Uu(u)[o.channel]),l=a.length>>1;i.splice(i.indexOf(o),1,kf(a.slice(0,l),e),kf(a.slice(l),e))}let s=new Uint8Array(3*256),r=new Uint8Array(32**3);for(let[o,{colours:a,weight:l}]of i.entries()){for(let c=0;c<3;c++){let u=a.reduce((h,d)=>h+e[d]*Uu(d)[c],0)/l;s[3*o+c]=Math.round(u*255/31)}for(let c of a)r[c]=o}return{palette:s,indexOf:r}}var Uu=n=>[n>>10,n>>5&31,n&31];function kf(n,e){let t=n.reduce((r,o)=>r+e[o],0),i=[0,1,2].map(r=>{let o=n.map(a=>Uu(a)[r]);return o.reduce((a,l)=>Math.max(a,l))-o.reduce((a,l)=>Math.min(a,l))}),s=Math.max(...i);return{colours:n,weight:t,channel:i.indexOf(s),spread:s*s*Math.sqrt(t)}}var Uf=8,hx=12.5,ET=25,TT=.6,[CT,dx,RT]=[640,1280,2400],Of=30,[Bo,PT,fx]=[10,210,24],IT=8,LT=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"];function Bu(n,e,t,i){let r=[fs("PNG","download PNG of the picture",async()=>{let o=b("canvas");await mx(n,()=>n.drawSharp(RT,()=>Fu(o,n,t(),i(),n.canvas.width)));let a=await new Promise(l=>o.toBlob(l,"image/png"));ps(a,`${qn("picture")}.png`)})];if(e.seek&&e.timeAt){r.push(px("GIF","gif",l=>DT(n,e,t,i,l)));let o=LT.find(l=>globalThis.MediaRecorder?.isTypeSupported(l)),a=o?.startsWith("video/mp4")?"MP4":"WebM";o&&HTMLCanvasElement.prototype.captureStream&&r.push(px(a,a.toLowerCase(),l=>kT(n,e,t,i,l,o)))}return b("span",{className:"films",role:"group","aria-label":"save"},...r)}function px(n,e,t){let i=null,s=fs(n,`download a film as ${n}`,async()=>{if(i){i.stopped=!0;return}i={stopped:!1,progress:r=>{s.textContent=`${Math.round(100*r)} %`}};try{let r=await t(i);i.stopped||ps(r,`${qn("motion")}.${e}`)}finally{i=null,s.textContent=n}});return s}async function mx(n,e){let t=vf();n.paint();try{return await e()}finally{t(),n.paint()}}async function gx(n,e,t,i){let s=e.time;e.pause?.(),await mx(n,async()=>{for(let r=t();r!==null;r=t())e.seek(e.timeAt(Math.min(1,r))),await NT(),i(r)}),e.seek(s)}var NT=()=>new Promise(n=>requestAnimationFrame(n));async function DT(n,e,t,i,s){let r=b("canvas"),o=Math.round(Uf*hx),[a,l]=[0,null];return await gx(n,e,()=>s.stopped||a>o?null:a/o,c=>{Fu(r,n,t(),i(),CT),l??=ux(r.width,r.height,1/hx),l.add(r.getContext("2d",{willReadFrequently:!0}).getImageData(0,0,r.width,r.height).data),s.progress(c),a++}),s.stopped?null:new Blob([l.bytes()],{type:"image/gif"})}async function kT(n,e,t,i,s,r){let o=b("canvas");Fu(o,n,t(),i(),dx);let a=new MediaRecorder(o.captureStream(ET),{mimeType:r,videoBitsPerSecond:8e6}),l=[];a.ondataavailable=({data:d})=>l.push(d);let c=new Promise(d=>{a.onstop=d});a.start();let u=performance.now(),h=()=>(performance.now()-u)/1e3;return await gx(n,e,()=>s.stopped||h()>Uf+TT?null:h()/Uf,d=>{Fu(o,n,t(),i(),dx),s.progress(Math.min(1,d))}),a.stop(),await c,new Blob(l,{type:r.split(";")[0]})}function Fu(n,e,t,i,s){let{canvas:r,cells:o}=e,a=s/r.clientWidth,l=Math.round(a*r.clientHeight),c=Math.max(1,a),u=OT(t,i,s/c),h=Math.round(c*u.height),d=[2*Math.round(s/2),2*Math.round((l+h)/2)];(n.width!==d[0]||n.height!==d[1])&&([n.width,n.height]=d);let f=n.getContext("2d",{willReadFrequently:!0});if(f.fillStyle="#ffffff",f.fillRect(0,0,...d),f.drawImage(r,0,0,s,l),o.length>1)for(let p of o)sl(f,Nf(p).shapes,a,[p.offsetLeft,p.offsetTop]);sl(f,u.shapes,c,[0,l/c])}function OT(n,e,t){let i=[{kind:"text",x:Bo,y:20,text:n.text,bold:!0,size:14,fill:"#16191d"}],[s,r]=[n.longest?Math.max(PT,Bo+IT*n.longest+fx):Bo,0];for(let{shapes:o,width:a,height:l}of e.map(Nf))s>Bo&&s+a>t-Bo&&([s,r]=[Bo,r+Of]),i.push({kind:"moved",x:s,y:r+(Of-l)/2,shapes:o}),s+=a+fx;return{shapes:i,height:r+Of}}var UT=[{quantity:null,name:"panels"},{quantity:"strain",name:"strain",text:"largest Green strain of the membrane",value:n=>`${Mt(100*n)} %`},{quantity:"stress",name:"stress",text:"largest stress of the membrane (second Piola-Kirchhoff)",value:(n,e)=>Gs(n,e)}];function Ff(n,e,t){let i=b("li",{className:"energy",hidden:!0});e.append(i);let s=t.find(a=>a.stressed)?.mesh.membraneLaw.unit,o=UT.filter(({quantity:a})=>a!=="stress"||t.every(l=>l.stressed||!l.strained)).map(({quantity:a,name:l,text:c,value:u},h)=>{let d=b("button",{type:"button","aria-pressed":String(h===0)},l);return d.addEventListener("click",()=>{let f=n.colourSheets(a);a&&i.replaceChildren(...If(c,"0",Cu,u(f,s)).childNodes),i.hidden=!a;for(let p of e.querySelectorAll(".of-region"))p.hidden=!!a;for(let p of o)p.setAttribute("aria-pressed",String(p===d))}),d});return b("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",b("span",{},...o))}var FT=new H(0,1,0),Bf=[.86,.78],xx=.1,zf=.004,_x=.035;function yx(n){let e=new As,t=new _n(new wi(zf,zf,xx,10),e),i=new _n(new Er(3*zf,_x,16),e);t.position.y=-_x/2,i.position.y=xx/2;let s=new Ln;s.add(t,i),s.quaternion.setFromUnitVectors(FT,new H(...n));let r=()=>e.color.set(_t("--bar")),[o,a]=[new H,new H];function l(u,h){let d=o.copy(h).project(u).z;a.set(Bf[0],1,d).unproject(u),s.position.set(Bf[0],-1,d).unproject(u),s.scale.setScalar(a.distanceTo(s.position)),s.position.set(...Bf,d).unproject(u)}return{group:s,paint:r,follow:l,dispose:()=>[t,i].forEach(u=>u.geometry.dispose())}}var vx=2,BT=.84,zu=1024,zT=Uint8Array.from({length:zu+1},(n,e)=>{let t=e/zu;return Math.round(255*(t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055))}),Vf=n=>zT[Math.min(zu,Math.max(0,Math.round(zu*n)))];function bx(n){let e=n.getContext("2d"),t=document.createElement("canvas"),i={frame:0,calls:0,triangles:0},s=1,r=[0,0,1,1];return{info:{render:i},setPixelRatio(o){s=o},setSize(o,a){[n.width,n.height]=[Math.floor(o*s),Math.floor(a*s)]},setScissorTest(){},setScissor(){},setViewport(...o){r=o.map(a=>a*s)},clear(){i.frame+=1,e.clearRect(0,0,n.width,n.height)},render(o,a){let[l,c]=[Math.round(r[2]*vx),Math.round(r[3]*vx)];if(l<1||c<1)return;let u=VT(o,a,l,c);[t.width,t.height]=[l,c],t.getContext("2d").putImageData(u,0,0),e.drawImage(t,r[0],n.height-r[1]-r[3],r[2],r[3])},dispose(){},forceContextLoss(){}}}function VT(n,e,t,i){let s=new ImageData(t,i),r={width:t,height:i,colours:new Uint32Array(s.data.buffer),depths:new Float32Array(t*i).fill(1/0)};n.updateMatrixWorld(),e.updateMatrixWorld();let o=GT(n),a=new dt().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),l=[];n.traverseVisible(u=>{u.geometry&&!Gf(u)[0].stencilWrite&&l.push(u)});for(let u of l.filter(h=>h.isLineSegments))qT(u,a,r);let c={projection:a,view:e.matrixWorldInverse,perspective:e.projectionMatrix,position:e.position};for(let u of l.filter(h=>h.isMesh))WT(u,c,o,r);return s}var Gf=({material:n})=>Array.isArray(n)?n:[n];function GT(n){let e={towards:new H(0,0,1),sun:new je(0),sky:new je(0),ground:new je(0)};return n.traverse(t=>{t.isDirectionalLight&&(e.towards.copy(t.position).normalize(),e.sun.copy(t.color).multiplyScalar(t.intensity/Math.PI)),t.isHemisphereLight&&(e.sky.copy(t.color).multiplyScalar(t.intensity/Math.PI),e.ground.copy(t.groundColor).multiplyScalar(t.intensity/Math.PI))}),e}function HT(n,e,t,i,s){if(t.isMeshBasicMaterial){for(let h=0;h<3;h++)s[h]=Vf(e[h]);return}let r=Math.max(0,n.dot(i.towards)),o=.5*n.y+.5,a=t.emissive&&t.emissiveIntensity?t.emissive.toArray().map(h=>h*t.emissiveIntensity):null,[l,c,u]=[i.sun,i.sky,i.ground].map(h=>[h.r,h.g,h.b]);for(let h=0;h<3;h++)s[h]=Vf(e[h]*(r*l[h]+o*c[h]+(1-o)*u[h])+(a?.[h]??0))}function WT(n,e,t,i){let{geometry:s}=n,r=Gf(n),o={start:0,count:s.index?.count??s.attributes.position.count,materialIndex:0},a=Array.isArray(n.material)?s.groups:[o],l=n.isInstancedMesh?n.count:1,[c,u,h]=[new dt,new dt,new je];for(let d=0;d<l;d++){c.copy(n.matrixWorld),h.set(1,1,1),n.isInstancedMesh&&(n.getMatrixAt(d,u),c.multiply(u),n.instanceColor&&n.getColorAt(d,h));for(let f of a)$T(s,f,c,r[f.materialIndex],h,e,t,i)}}function $T(n,{start:e,count:t},i,s,r,o,a,l){let{position:c,normal:u,color:h}=n.attributes,d=u&&!s.flatShading,f=[s.color.r*r.r,s.color.g*r.g,s.color.b*r.b],p=new rt().getNormalMatrix(i),x=s.userData.nearer??0,m=new Map,g=new Gt,_=new H;function w(P){if(m.has(P))return m.get(P);_.fromBufferAttribute(c,P).applyMatrix4(i);let C=_.clone();g.set(_.x,_.y,_.z,1).applyMatrix4(o.projection);let N={place:C,x:(g.x/g.w+1)/2*l.width,y:(1-g.y/g.w)/2*l.height,depth:g.z/g.w,behind:g.w<=0,normal:d?new H().fromBufferAttribute(u,P).applyMatrix3(p).normalize():null};return x&&(_.applyMatrix4(o.view),_.addScaledVector(_.clone().normalize(),-x),g.set(_.x,_.y,_.z,1).applyMatrix4(o.perspective),N.depth=g.z/g.w),m.set(P,N),N}let[S,A,M,y]=[new H,new H,new H,new H],v=[0,0,0],T=[[0,0,0],[0,0,0],[0,0,0]];for(let P=e;P+2<e+t;P+=3){let C=[0,1,2].map(D=>n.index?n.index.getX(P+D):P+D),N=C.map(w);if(N.some(D=>D.behind))continue;S.subVectors(N[1].place,N[0].place),A.subVectors(N[2].place,N[0].place),M.crossVectors(S,A).normalize(),y.subVectors(o.position,N[0].place);let F=M.dot(y)<0;F&&M.negate();for(let D=0;D<3;D++){let V=C[D];for(let $=0;$<3;$++)v[$]=f[$]*(h?h.getComponent(V,$):1)*(F&&h&&!s.isMeshBasicMaterial?BT:1);HT(d?N[D].normal:M,v,s,a,T[D])}XT(N,T,l)}}function XT([n,e,t],i,{width:s,height:r,colours:o,depths:a}){let l=(e.x-n.x)*(t.y-n.y)-(e.y-n.y)*(t.x-n.x);if(Math.abs(l)<1e-9)return;let[c,u]=[Math.max(0,Math.floor(Math.min(n.x,e.x,t.x))),Math.min(s-1,Math.ceil(Math.max(n.x,e.x,t.x)))],[h,d]=[Math.max(0,Math.floor(Math.min(n.y,e.y,t.y))),Math.min(r-1,Math.ceil(Math.max(n.y,e.y,t.y)))],[f,p,x]=i,m=f.every((S,A)=>S===p[A]&&S===x[A]),g=4278190080|f[2]<<16|f[1]<<8|f[0],[_,w]=[(t.y-n.y)/l,(n.y-e.y)/l];for(let S=h;S<=d;S++){let[A,M]=[c+.5-n.x,S+.5-n.y],y=(A*(t.y-n.y)-M*(t.x-n.x))/l,v=(M*(e.x-n.x)-A*(e.y-n.y))/l,T=S*s+c;for(let P=c;P<=u;P++,T++,y+=_,v+=w){let C=1-y-v;if(C<0||y<0||v<0)continue;let N=C*n.depth+y*e.depth+v*t.depth;N>=a[T]||(a[T]=N,o[T]=m?g:4278190080|C*f[2]+y*p[2]+v*x[2]<<16|C*f[1]+y*p[1]+v*x[1]<<8|C*f[0]+y*p[0]+v*x[0])}}}function qT(n,e,{width:t,height:i,colours:s}){let{position:r}=n.geometry.attributes,[o]=Gf(n),[a,l,c]=[o.color.r,o.color.g,o.color.b].map(Vf),u=Math.round(255*o.opacity)<<24|c<<16|l<<8|a,h=[0,1].map(()=>new Gt);for(let d=0;d+1<r.count;d+=2){for(let[m,g]of h.entries())g.set(r.getX(d+m),r.getY(d+m),r.getZ(d+m),1).applyMatrix4(n.matrixWorld).applyMatrix4(e);if(h.some(m=>m.w<=0))continue;let[f,p]=h.map(m=>[(m.x/m.w+1)/2*t,(1-m.y/m.w)/2*i]),x=Math.min(2e4,Math.ceil(Math.max(Math.abs(p[0]-f[0]),Math.abs(p[1]-f[1]))));for(let m=0;m<=x;m++){let[g,_]=[0,1].map(w=>Math.floor(f[w]+m/(x||1)*(p[w]-f[w])));g>=0&&g<t&&_>=0&&_<i&&(s[_*t+g]=u)}}}var Vu=null;function Sx(){let n=Vu;if(Vu=null,n&&!n.renderer.getContext?.().isContextLost())return n;n?.renderer.dispose();let e=b("canvas",{tabIndex:0,role:"img"}),t=e.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});return{renderer:t?new wu({canvas:e,context:t,antialias:!0,alpha:!0,stencil:!0}):bx(e),canvas:e,webgl:t!==null}}function wx(n){if(n.canvas.remove(),n.canvas.className="",!Vu){Vu=n;return}n.renderer.dispose(),n.renderer.forceContextLoss()}var Mx=4096,YT=3.2,ZT=new H(-.45,.75,1),jT=.42*Math.PI,KT=.64*Math.PI,JT=.5,QT=.14;function ol(n,e,t,i,s){let r=Sx(),{renderer:o,canvas:a,webgl:l}=r;a.setAttribute("aria-label",`${i} ${tC}`);let c=new AbortController,u=n.map(()=>b("div",{className:"cell"})),h=n.length>1,d=b("div",{className:h?"stage several":"stage"},a,...u);d.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let f=()=>h?Math.ceil(YT*parseFloat(getComputedStyle(u[0]).fontSize)):0;o.setScissorTest(!0);let p=$0(a,n,e,w,s),x=n.map(B=>nC(B,t(B),p)),m=0,g=!1,_=new Set;function w(){m||(m=requestAnimationFrame(A))}function S(){for(let[B,ne]of x.entries())ne.shape.pose(e.clipTime(B));g=!0}function A(){cancelAnimationFrame(m),m=0,g||S();let B=a.clientHeight,ne=f();o.setScissor(0,0,a.clientWidth,B),o.setViewport(0,0,a.clientWidth,B),o.clear();for(let[Y,K]of x.entries()){p.aim(Y);let ee=u[Y],de=[ee.offsetLeft,B-ee.offsetTop-ee.offsetHeight,ee.offsetWidth,ee.offsetHeight-ne];o.setViewport(...de),o.setScissor(...de),K.light.position.copy(ZT).applyQuaternion(p.camera.quaternion);let ce=p.camera.position.z>K.floor.position.z;K.floor.material.opacity=ce?JT:QT,K.shape.shadow.visible=ce,K.shape.sort(p.camera.position),K.gravity?.follow(p.camera,p.controls.target),o.render(K.scene,p.camera)}p.aim();for(let Y of _)Y()}function M(){for(let B of x)B.floor.material.color.set(_t("--floor")),B.shape.paint(),B.gravity?.paint();w()}function y(){let[B,ne]=[d.clientWidth,d.clientHeight];if(!B||!ne)return;o.setPixelRatio(Math.min(devicePixelRatio,2,Mx/Math.max(B,ne))),o.setSize(B,ne,!1);let Y=u[0].offsetHeight-f();p.resize(u[0].offsetWidth/Y,ne/Y),A()}function v(B,ne){let Y=Math.min(B/d.clientWidth,Mx/Math.max(d.clientWidth,d.clientHeight));o.setPixelRatio(Y),o.setSize(d.clientWidth,d.clientHeight,!1),A();let K=ne();return y(),K}let T=new ResizeObserver(y);T.observe(d);let P=e.onChange(()=>{g=!1,A()}),C=sr(M);N("webglcontextrestored",w),M();function N(B,ne,Y=!1){a.addEventListener(B,ne,{capture:Y,signal:c.signal})}function F(){cancelAnimationFrame(m),c.abort(),P(),C(),T.disconnect(),p.dispose();for(let{shape:B,floor:ne,gravity:Y}of x)B.dispose(),Y?.dispose(),ne.geometry.dispose();wx(r),d.remove()}function D(B){let ne=B?x.reduce((Y,{shape:K})=>Math.max(Y,K.strains?.largest(B)??0),0):0;for(let{shape:Y}of x)Y.colourSheets?.(B,ne||Number.MIN_VALUE);return w(),ne}let V=()=>({...o.info.render,...o.info.memory,programs:o.info.programs?.length??0}),$=l?null:b("p",{className:"note"},eC);return{element:d,note:$,canvas:a,cells:u,eye:p,pose:S,draw:A,drawSharp:v,paint:M,views:x,colourSheets:D,listen:N,onDraw:B=>_.add(B),statistics:V,dispose:F}}var eC="This browser has no WebGL: the processor draws the picture, without shadows and more slowly.",tC="Drag to turn, pinch to zoom; keys are listed below.";function nC(n,e,t){let i=J0(t.size,t.target);i.position.z=n.mesh.table_m??iC(n)-.06*t.size,e.shadow.position.z=i.position.z+.001*t.size;let s=new za("#ffffff",jT),r=new Ea;r.add(e.group,e.shadow,i,s,new Ua("#ffffff","#dde2e8",KT));let o=n.mesh.gravity&&yx(n.mesh.gravity);return o&&r.add(o.group),{shape:e,floor:i,light:s,scene:r,gravity:o}}function iC(n){let e=1/0,t=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=t){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)e=Math.min(e,s[r])}return e}var sC=.3,rC=4,oC=4,Ax=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function Ex(n,e){let t=aC(n,e),i=new Float64Array(t.length);for(let[l,c]of n.entries())lC(c,e.origins[l],t,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?sC:1;for(let l=0;l<i.length;l++){let c=(t[l]-t[0])/(t[t.length-1]-t[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-e.origins[0]<e.end&&l.end-e.origins[0]>e.start,a=n[0].stages.filter(o).length;return{seconds:e.seconds??rC+oC*a,wayAt:l=>or(t,i,l),timeAt:l=>or(i,t,l)}}function aC(n,e){let t=new Set([e.start,e.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-e.origins[i];o>e.start&&o<e.end&&t.add(o)}return Float64Array.from(t).sort()}function lC(n,e,t,i){let s=n.pointsAt(t[0]+e).slice(),r=s.slice();for(let o=1;o<t.length;o++){n.pointsAt(t[o]+e,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}var cC="M7 4.5v15l12-7.5z",uC="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Hf=1e4,hC=.02;function Gu(n,e){let t=b("button",{type:"button",className:"play"}),i=b("input",{type:"range",min:0,max:Hf,step:1,"aria-label":e.span.unit?e.span.name:"time"}),s=b("div",{className:"bands","aria-hidden":"true"}),r=b("div",{className:"ticks","aria-hidden":"true"}),o=b("p",{className:n[0].along.length?"time long":"time"}),a=b("p",{className:"spoken",role:"status"}),l=b("div",{className:"states"}),c=null,u=[];function h(){n.length>1||n[0].marks===c||(c=n[0].marks,u=c.map(m=>fC(m,e)),l.replaceChildren(...u))}h();let d=b("div",{className:"transport"},b("div",{className:"line"},t,b("div",{className:"tracks"},...dC(n[0],e),b("div",{className:"track"},s,i,r))),b("div",{className:"choices"},o,l,...e.span.unit?[]:[pC(e)],...mC(e),a));t.addEventListener("click",()=>e.playing?e.pause():e.play()),i.addEventListener("input",()=>{e.pause(),e.seek(e.momentAt(i.value/Hf))});let f={},p=null,x=0;return e.onChange(()=>{h();let{span:m,stretched:g}=e;(m!==f.span||g!==f.stretched)&&gC(n,e,s,r),f={span:m,stretched:g},i.value=Math.round(Hf*e.shareAt(e.time)),i.setAttribute("aria-valuetext",Tx(n,e));let _=n.length===1?al(n[0],e.clipTime(0)):"",w=n.length===1?_&&` · ${_}`:e.span.label.replace("time",""),S=e.playing&&!e.span.unit?`, ${xC(e.slowness)}`:"";o.textContent=`${Ki(e.time,e.span)}${w}${S}${Cx(n[0],e.clipTime(0)," · ")}`;for(let[A,M]of(c??[]).entries())u[A].setAttribute("aria-pressed",String(Math.abs(M.time-e.clipTime(0))<1e-9));e.playing!==p&&(t.replaceChildren(Tl(e.playing?uC:cC)),t.setAttribute("aria-label",e.playing?"pause":"play"),p=e.playing),clearTimeout(x),e.playing||(x=setTimeout(()=>{a.textContent=Tx(n,e)},600))}),d}function dC(n,e){if(!n.along.length)return[];let t=Yh("",100),i=b("span",{className:"profile-ball"}),s=b("small"),r=c=>100*e.shareAt(c),o=null,a=null;function l(c){let u=n.line(c.key,0),[h,d]=[Math.min(0,...u),Math.max(...u)];o=p=>100-100*(p-h)/(d-h||1);let f=Array.from(u,(p,x)=>`${r(n.time[x]).toFixed(2)} ${o(p).toFixed(2)}`);t.querySelector("path").setAttribute("d",`M${f.join("L")}`),s.textContent=c.name,s.classList.toggle("at-start",u[0]<u.at(-1)),a=c}return e.onChange(()=>{let[c]=n.along;c!==a&&l(c);let u=e.clipTime(0);i.style.left=`${r(u).toFixed(2)}%`,i.style.top=`${o(n.valuesAt(c.key,u)[0]).toFixed(2)}%`}),[b("div",{className:"profile","aria-hidden":"true"},t,i,s)]}function fC(n,e){let t=b("button",{type:"button",className:"state"},b("b",{},n.letter),` ${n.name}`);return t.addEventListener("click",()=>{e.pause(),e.seekClip(0,n.time)}),t}function pC(n){let e=Ax.map(({name:i,value:s})=>b("option",{value:String(s)},i)),t=b("select",{},...e);return t.addEventListener("change",()=>n.setSpeed(t.value==="even"?"even":Number(t.value))),b("label",{},"speed ",t)}function mC(n){if(n.spans.length<2)return[];let e=n.spans.map((i,s)=>b("option",{value:String(s)},i.name)),t=b("select",{},...e);return t.addEventListener("change",()=>n.setSpan(n.spans[Number(t.value)])),n.onChange(()=>{t.value=String(n.spans.indexOf(n.span))}),[b("label",{},"show ",t)]}function gC(n,e,t,i){let{span:s}=e,r=o=>Math.min(1,Math.max(0,e.shareAt(o)));t.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=b("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&t.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let[h,d]=[r(u),i.lastElementChild];if(d&&n.length===1&&h-d.at<hC){d.append(` ${c.letter}`);continue}let f=b("span",{className:"tick",at:h},n.length===1?c.letter:"");f.style.left=`${100*h}%`,n.length>1&&f.style.setProperty("--tick",`var(--line-${o%7})`),i.append(f)}}}function xC(n){return n<1.05?"real time":`${n<10?kn(n,1):Math.round(n)} times slower`}function al(n,e){let t=n.markAt(e);return t?`${t.letter} ${t.name}`:n.stageAt(e).name}function Cx(n,e,t){let i=({name:s,unit:r,key:o})=>`${t}${s} ${Mt(Number(n.valuesAt(o,e)[0].toPrecision(3)))} ${r}`;return n.along.map(i).join("")}function Tx(n,e){let t=n.map((i,s)=>{let r=e.clipTime(s);return`${n.length>1?`${i.name}: `:""}${al(i,r)||e.span.name}${Cx(i,r,", ")}${_C(i,r)}`});return`${Ki(e.time,e.span)}: ${t.join("; ")}`}function _C(n,e){let[t]=n.readings;if(!t)return"";let i=n.markAt(e)?.readings[t.name]?.mean??n.valuesAt(t.name,e),s=t.unit==="deg"?"degrees":t.unit,r=[Math.min(...i),Math.max(...i)].map(a=>kn(a,1)),o=i.length>1;return`, ${t.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function ur(n,e,t,{energy:i,legend:s,text:r,whole:o},a,l=e.length>1||!!a){let c=ol(e,t,x=>Lf(x,i.largest_J),r,a),u=b("div",{className:"picture"},c.element,...c.note?[c.note]:[],Wu(c.eye,l?o:null));e.length===1&&vC(c.cells[0],e[0],t);let h=[Pf(s,i,c.eye.size,e.length>1?o:null)];e.some(x=>x.strained)&&h.unshift(Ff(c,h[0],e)),e.length===1&&e[0].efforts?.drives.length&&bC(h.at(-1),e[0],t),e.length>1&&e.some(x=>x.efforts?.drives.some(m=>m.arrow))&&h.at(-1).append(b("li",{className:"effort"},Px(),"torque or force of a drive, while it acts"));let d=e.length===1&&e[0].creases?[q0(c,e[0],t)]:[];n.replaceChildren(u,Gu(e,t),...d,...h,Lu(e,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`),Rx(n,c,t,()=>yC(e,t));let f=Nu(n,e,t,c.eye,kr[0]);function p(){t.pause(),f(),c.dispose(),n.replaceChildren()}return{stage:c,dispose:p}}function Hu(n,e,t,{energy:i,legend:s,text:r,whole:o},a){let l=ol(e,t,h=>Lf(h,i.largest_J),r,a),c=b("div",{className:"picture"},l.element,...l.note?[l.note]:[],Wu(l.eye,null,!a)),u=[Pf(s,{...i,orMore:!0},l.eye.size,null)];return e.some(h=>h.strained)&&u.unshift(Ff(l,u[0],e)),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),Rx(n,l,t,()=>({text:"",longest:0})),j0(n,l.eye,kr[0]),{stage:l}}function Rx(n,e,t,i){let s=()=>[...n.querySelectorAll(".legend .energy:not([hidden])")];n.querySelector(".views").prepend(Bu(e,t,i,s))}function yC(n,e){let{span:t}=e,[i]=n,s=n.length===1?`${al(i,e.clipTime(0))}, `:"",r=n.length===1?[...i.stages.map(({name:c})=>c),...i.marks.map(({letter:c,name:u})=>`${c} ${u}`)]:[],o=c=>Math.max(0,...c.map(u=>u.length)),a=`${s}${Ki(e.time,t)}`,l=[t.start,t.end].map(c=>Ki(c,t));return{text:a,longest:Math.max(a.length,o(r)+2+o(l))}}function vC(n,e,t){let i=b("p",{className:"now","aria-hidden":"true"});n.append(i),t.onChange(()=>{i.textContent=al(e,t.clipTime(0)),i.hidden=!i.textContent})}function Px(){return b("span",{className:"swatch arrow","aria-hidden":"true"})}function bC(n,e,t){let i=e.efforts.drives.some(o=>o.arrow),s=o=>D0(e.efforts,o,Mt).join("; ")||"no drive acts now",r=Q0(Array.from(e.time,s));n.append(b("li",{className:"effort"},...i?[Px()]:[],r.element)),t.onChange(()=>r.say(s(t.clipTime(0))))}function Wu(n,e,t=!0){let i=kr.map(l=>fs(l.name,`${l.name}: view ${l.text}`,()=>n.show(l))),s=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([l,c,u])=>fs(l,c,()=>n.turn(...u))),r=(l,c,u)=>{let h=fs(l,c,()=>{n.choose({[u]:!n.look[u]}),h.setAttribute("aria-pressed",String(n.look[u]))});return h.setAttribute("aria-pressed",String(n.look[u])),h},o=[...t?[r("follow","follow: keep the picture filled as the structure moves","following")]:[],...e?[r("one scale",`one scale: draw all ${e}s at the same scale`,"oneScale")]:[]],a=[fs("+","nearer",()=>n.zoom(1)),fs("−","further",()=>n.zoom(-1))];return b("div",{className:"views",role:"group","aria-label":"view"},...o.length?[b("span",{},...o)]:[],b("span",{},...i),b("span",{className:"turns"},...s),b("span",{},...a))}var SC=4,wC={deg:.05};function hr(n,e,t,i,s=0,r=!1){let{heading:o,names:a}=e.mesh.parts,l=e.readings.map(w=>({name:w.name,title:w.row,parts:w.parts,text:S=>Wf(S,w.unit),ofState:S=>S.readings[w.name]&&MC(S.readings[w.name],w.unit)})),c=w=>Mt(i.factor*w);e.tendons&&l.push({name:Is,title:`tendon energy (${i.unit})`,parts:e.mesh.tendonParts,text:c,ofState:w=>w.tendonEnergy_J?.map(c)});let u=l.map(()=>a.map(()=>b("td"))),h=b("caption"),d=l.map(w=>w.title),f=a.length>SC,[p,x]=f?[d,a]:[a,d],m=b("tr",{},o?b("th",{scope:"col"},o):b("td"),...p.map(w=>b("th",{scope:"col"},w))),g=x.map((w,S)=>b("tr",{},b("th",{scope:"row"},w),...f?u.map(A=>A[S]):u[S])),_=b("table",{className:"numbers"},h,b("thead",{},m),b("tbody",{},...g));return n.replaceChildren(b("div",{className:"table"},_)),n.classList.add("readout"),t.onChange(()=>{let w=t.clipTime(s),S=e.markAt(w),A=S?`, ${S.name}${S.tendonEnergy_J?" (means)":""}`:"",M=r?`${e.name}: `:"",y=o?`every ${o}`:"all values";h.textContent=`${Nt(`${M}${y}`)} at ${Ki(t.time,t.span)}${A}`;for(let[v,T]of l.entries()){let P=S&&T.ofState(S)||Array.from(e.valuesAt(T.name,w),T.text);for(let[C,N]of T.parts.entries())u[v][N].textContent=P[C]}})}function Wf(n,e){return e==="deg"?kn(n,1):Mt(n)}function MC({mean:n,swing:e},t){return n.map((i,s)=>{let r=e[s]>(wC[t]??.005*Math.abs(i));return`${Wf(i,t)}${r?` ± ${Wf(e[s],t)}`:""}`})}var AC=0;function zo(n=document){let e=new ResizeObserver(t=>{for(let{target:i}of t)if(Ix(i),i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)EC(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let t of n.querySelectorAll(".table"))e.observe(t),t.addEventListener("scroll",()=>Ix(t),{passive:!0})}function Ix(n){let e=Math.abs(n.scrollLeft);n.classList.toggle("more-left",e>1),n.classList.toggle("more-right",e+n.clientWidth<n.scrollWidth-1)}function EC(n){let{caption:e}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!e){let t=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",t.join(", ")||"table")}return e.id||=`caption-${++AC}`,n.setAttribute("aria-labelledby",e.id)}function TC(n,e){let t=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in e&&(t[o.number]=`${o.before}${Nx(e[i],s,r)}${o.after}`);return t.join(`
`)}function Lx({knobs:n},e,t){let{unit:i,factor:s}=n.find(r=>r.key===e);return Nx(t,i,s)}function Nx(n,e,t){return`${Number((t*n).toPrecision(12))} ${e}`}function Dx(n){let e=b("a",{className:"button",download:"design.toml"},"This setting as a design file"),t=b("code"),i=b("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=b("div",{className:"setting"},e,b("pre",{},t),i);function r(o){let a=new TextEncoder().encode(TC(n,o));e.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,t.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var kx=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]],dr=Object.fromEntries(kx.map(([,,n,e])=>[n,e])),$u=n=>b("select",{},...n.map(([e,t])=>b("option",{value:t},e)));function Xu(n,{clicked:e,pressed:t}){let i=kx.map(([r,o,a])=>{let l=b("button",{type:"button",title:`${n} ${o}`,"aria-label":`${n} ${o}`,"data-way":a},r);return l.addEventListener("click",()=>e(a)),l}),s=b("span",{className:"pad",role:"group","aria-label":`${n} in the plane of the picture`},...i);return s.addEventListener("keydown",r=>{!(r.key in dr)||r.shiftKey||r.ctrlKey||r.metaKey||r.altKey||(r.preventDefault(),r.stopPropagation(),t(r.key))}),s}var CC=500,Ox=[["a little",.1],["half",.5],["as strong as its drives",1]];function Ux(n,e,t,i,s){let r=$u(t.map((_,w)=>[_,w]).filter(([,_])=>e.movable[_])),o=b("select",{},...Ox.map(([_,w])=>b("option",{value:w,selected:w===Ox[0][1]},_))),a=b("span",{className:"note",role:"status"}),l=Xu("push",{clicked:g,pressed:m}),c=b("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),u=b("details",{className:"push-keys"},b("summary",{},"Push without a pointer"),b("div",{className:"choices"},b("label",{},"point ",r),b("label",{},"force ",o),l,a),c),h=RC(n,e,()=>Number(r.value),u),d=new Set,f=0;function p(){clearTimeout(f);let[_,w]=[0,1].map(M=>[...d].reduce((y,v)=>y+dr[v][M],0));if(!_&&!w){a.textContent="",s(0,null);return}let{camera:S}=n.eye,A=new H().setFromMatrixColumn(S.matrixWorld,0).multiplyScalar(_);A.addScaledVector(new H().setFromMatrixColumn(S.matrixWorld,1),w).setLength(Number(o.value)*i),a.textContent=`${r.selectedOptions[0].text} pushed with ${Mt(A.length())} N`,s(Number(r.value),A.toArray())}function x(){d.size&&(d.clear(),p())}function m(_){d.has(_)||(d.add(_),p())}function g(_){d.clear(),d.add(_),p(),f=setTimeout(x,CC)}return l.addEventListener("keyup",({key:_})=>{d.delete(_)&&p()}),l.addEventListener("focusout",x),r.addEventListener("change",()=>{x(),h()}),u.addEventListener("toggle",h),u}function RC(n,e,t,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new H;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let[c,u]=Fo(a.fromArray(e.frame.points,3*t()),n.eye.camera,n.canvas);o.setAttribute("cx",c),o.setAttribute("cy",u)}return e.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var PC=22;function qu(n,{points:e,movable:t,between:i=()=>null,moved:s,left:r}){let{canvas:o,eye:a}=n,l=document.createElementNS("http://www.w3.org/2000/svg","line"),c=document.createElementNS("http://www.w3.org/2000/svg","svg");c.classList.add("push"),c.setAttribute("aria-hidden","true"),c.append(l);let u=b("p",{className:"pushed","aria-hidden":"true"});n.element.append(c,u),c.style.display="none";let[h,d]=[new H,new H],f=null,p=null;function x(v){d.set(0,0,0);for(let[T,P]of v)d.addScaledVector(h.fromArray(e(),3*T),P);return d}function m(v){return Fo(x(v),a.camera,o)}function g(v){let T=o.getBoundingClientRect();return[v.clientX-T.left,v.clientY-T.top]}function _([v,T]){let P={place:null,away:PC};for(let C=0;C<t.length;C++){if(!t[C])continue;let N=[[C,1]],[F,D]=m(N),V=Math.hypot(F-v,D-T);V<P.away&&(P={place:N,away:V})}return P.place}let w=([v,T])=>[2*v/o.clientWidth-1,1-2*T/o.clientHeight],S=v=>_(g(v))??i(...w(g(v)));function A(){if(!f)return;let v=m(f);for(let[T,P]of[["x1",v[0]],["y1",v[1]],["x2",p[0]],["y2",p[1]]])l.setAttribute(T,P);c.style.display=""}let M=v=>{f=v.button===0?S(v):null,f&&(a.controls.enabled=!1,o.setPointerCapture(v.pointerId),v.stopImmediatePropagation())};n.listen("pointerdown",M,!0),n.listen("pointermove",v=>{if(!f){o.classList.toggle("grip",S(v)!==null);return}p=g(v);let T=x(f).clone(),P=T.clone().project(a.camera).z;s(f,T,new H(...w(p),P).unproject(a.camera)),A()});let y=()=>{f&&(f=null,a.controls.enabled=!0,c.style.display="none",u.textContent="",r())};return n.listen("pointerup",y),n.listen("pointercancel",y),n.onDraw(A),{say:v=>u.textContent=v}}var IC=.25;function Fx(n,e,t,i,s){let{say:r}=qu(n,{points:()=>e.frame.points,movable:e.movable,moved([[o]],a,l){let c=l.sub(a).multiplyScalar(i/(IC*t)).clampLength(0,i);s(o,c.toArray()),r(`pushed with ${Mt(c.length())} N`)},left:()=>s(0,null)})}var ll=200,LC=20,NC=3;function Bx(n,e,t){let i=n.map(o=>DC(o,e,t)),s=b("button",{type:"button",disabled:!0},`Reset all to ${e}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=b("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function DC(n,e,t){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=LC,u=A=>c?a*(l/a)**A:a+A*(l-a),h=A=>c?Math.log(A/a)/Math.log(l/a):(A-a)/(l-a),d=Math.round(ll*h(n.value)),f=Nt(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=b("input",{type:"range",min:0,max:ll,step:1,"aria-label":f,"aria-description":s}),x=b("output"),m=b("span",{className:"home",title:`in ${e}`,"aria-hidden":"true"});m.style.left=`${100*d/ll}%`,p.dataset.keys="own";let g=n.value;function _(){let A=`${Mt(o*g)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;x.textContent=A,p.setAttribute("aria-valuetext",g===n.value?`${A}, as in ${e}`:A),S.classList.toggle("changed",g!==n.value)}function w(A){g=A,p.value=Math.round(ll*h(g)),_(),t(i,g)}p.addEventListener("input",()=>{let A=Number(p.value);g=A===d?n.value:Number((o*u(A/ll)).toPrecision(NC))/o,_(),t(i,g)});let S=b("label",{className:"slider",title:`${i}: ${s}`},b("span",{className:"name"},f),x,b("span",{className:"rail"},p,m));return p.value=d,_(),{element:S,knob:n,get value(){return g},put:w,reset:()=>w(n.value)}}var kC=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],OC=.2,Yu=1.4,UC="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",FC=1e-15;async function Vo(n,e,t,i,{look:s,pace:r=OC,set:o}={}){let a=JSON.parse(t),l={frame:null,engine:null,pace:r},c=await i(t,v=>M(v)),u=X0(n,a,c.first),h=b("p",{className:"verdict",role:"status"}),d=b("p",{className:"note"}),f=b("p",{className:"time"}),p=b("p",{className:"account"}),x=b("div"),m=b("div"),g=Dx(a),_=Bx(a.knobs,e.kind==="bench"?"the design":"this run",(v,T)=>{c.send({act:"set",values:{[v]:T}}),_.refresh(),g.refresh(_.changes),o?.(v,Lx(a,v,T))}),w=zC(a,c,l,()=>{h.textContent="",d.textContent=""}),S=a.motors.every(v=>v.kind==="torque")?"torques":"drives",A=null;function M(v){if(v.said==="refused"){h.textContent=`The simulator stopped: ${v.why}.`;return}v.said==="frame"&&y(v.frame)}function y(v){l.frame=v,u.show(v),f.textContent=`${Ki(v.time_s,{start:0,end:Math.max(1,v.time_s)})}${VC(v,a.protocol)}`;let T=v.energies_J.reduce((D,V)=>D+V,0),P=v.works_J.reduce((D,V)=>D+V,0),C=[...n.tendons?[`tendon energy ${$f(T)}`]:[],`work of the ${S} ${$f(P)}`];p.textContent=C.join(" · ");let N=v.stageNumber===null?v.ended:null,F=N&&JSON.stringify([N.verdict,...N.stages.map(D=>D.end_s)]);F!==A&&(h.textContent=N?GC(N,e.whole,a.texts.outcome):"",d.textContent=[N?.advice,N&&v.meddled&&UC].filter(Boolean).join(" ")),A=F}return l.element=b("div",{className:"trial"},b("div",{className:"head"},b("div",{className:"choices"},...w),b("div",{className:"live-facts"},f,p),h,d),x,b("div",{className:"hands"},_.element,...o?[]:[g.element]),m),l.begin=()=>{let v=s??{...ar(),following:!1,closer:e.kind==="bench"?Yu:1},{stage:T}=Hu(x,[u.clip],u.clock,{...e,text:`${e.shape}, live.`},v);if(l.stage=T,hr(m,u.clip,u.clock,e.energy),zo(l.element),T){u.movable=a.anchors.bodies.map(N=>N>0);let P=BC(a,n.mesh.span_m),C=(N,F)=>c.send({act:"push",point:N,force:F});Fx(T,u,n.mesh.span_m,P,C),x.querySelector(".picture").after(Ux(T,u,a.anchors.names,P,C))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),e.kind!=="bench"&&w[0].focus({preventScroll:!0})},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:_,design:g,own:a})}function BC({protocol:n,motors:e},t){let i=n.drives.map(({strength:s,torques:r})=>{let o=e[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/t:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function zC({protocol:n},e,t,i){let s=(a,l,c)=>{let u=b("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),e.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(Nt(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=b("select",{},...kC.map(([a,l])=>b("option",{value:l,selected:l===t.pace},a)));return o.addEventListener("change",()=>{t.pace=Number(o.value),e.send({act:"pace",value:t.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),b("label",{},"speed ",o)]}function VC({stage:n,stageNumber:e,running:t,ended:i},{stages:s}){let r=n&&!s[e].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${Gs(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:t?" · no drive acts":" · at rest"}function GC({status:n,verdict:e,transitions:t},i,s){let r=t.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>Zh(s.transition,{did:o.did||o.done,time:Gs(a.time_s,"s"),work:$f(a.work_J)}));return r.length?Zh(s[e==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${Nt(n)}.`}var $f=n=>Gs(Math.abs(n)<FC?0:n,"J");function Zu(n,e,t,i,s=null){if(!n)return null;let r={panel:null,failed:"",start:null},o=document.getElementById("live").textContent,a=b("button",{type:"button",className:"try"},"Try it"),l=b("p",{className:"note"});l.textContent=`Move this ${t.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(b("div",{className:"offer"},a,l));function c(h){r.failed=h,a.disabled=!0;let d="To drag its vertices, open the design in the workbench, with the command forficula open.",f=`A page cannot simulate the motion in time of this ${t.whole}: ${h}.`;if(l.textContent=`${s?`A slider folds this ${t.whole} along its quasi-static path. `:""}${d} ${f}`,!s)return;let p=b("button",{type:"button",className:"try"},"Fold it slowly");p.addEventListener("click",s),a.replaceWith(p)}let u=JSON.parse(o.startsWith('{"refused"')?o:"null");return u!==null?c(u.refused):Ru()||c("this page was written without the engine"),r.start=async()=>{if(!a.disabled){a.disabled=!0,l.setAttribute("role","status"),l.textContent="Starting the simulator …",i();try{r.panel=await Vo(e,t,o,Uo),n.replaceChildren(b("h2",{},"Try it"),r.panel.element),r.panel.begin()}catch(h){c(h.message)}}},a.addEventListener("click",async()=>{await r.start(),r.failed||n.scrollIntoView({block:"start"})}),r}function zx(n){let e=Kn(n.clips[0]),t=Zu(document.getElementById("try"),e,n,()=>{});return t.start(),{clips:[e],trial:t}}var HC=200;function Bi(n,e){let t=new Set,i=e[0].start,s=e[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,Ex(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(_){return h()?u().wayAt(_):(_-s.start)/(s.end-s.start||1)}function f(_){return h()?u().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let w=Math.min((_-a)/1e3,.1);a=_,m(w),l=requestAnimationFrame(x)}for(let w of t)w()}function m(_){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+_/u().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function g(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:e,clipTime:(_,w=i)=>Math.min(n[_].end,Math.max(n[_].start,w+s.origins[_])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:_=>u().wayAt(_),timeAt:_=>u().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=u().wayAt(i),[w,S]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(S-w)*u().seconds/(u().timeAt(S)-u().timeAt(w)||1e-12)},onChange(_){return t.add(_),p(),()=>t.delete(_)},seek:g,seekClip(_,w){(w<s.start+s.origins[_]||w>s.end+s.origins[_])&&(s=e.find(S=>w>=S.start+S.origins[_]&&w<=S.end+S.origins[_])??e[0]),g(w-s.origins[_])},step:_=>g(f(d(i)+_/HC)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,g(i<s.start||i>s.end?s.start:i)},redraw:p}}var WC="uplot",$C="u-hz",XC="u-vt",qC="u-title",YC="u-wrap",ZC="u-under",jC="u-over",KC="u-axis",Fr="u-off",JC="u-select",QC="u-cursor-x",eR="u-cursor-y",tR="u-cursor-pt",nR="u-legend",iR="u-live",sR="u-inline",rR="u-series",oR="u-marker",Vx="u-label",aR="u-value",ul="width",hl="height";var Gx="bottom",Go="left",Xf="right",cp="#000",Hx=cp+"0",qf="mousemove",Wx="mousedown",Yf="mouseup",$x="mouseenter",Xx="mouseleave",qx="dblclick",lR="resize",cR="scroll",Yx="change",eh="dppxchange",up="--",Zo=typeof window<"u",Qf=Zo?document:null,Wo=Zo?window:null,uR=Zo?navigator:null,It,ju;function ep(){let n=devicePixelRatio;It!=n&&(It=n,ju&&np(Yx,ju,ep),ju=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),Br(Yx,ju,ep),Wo.dispatchEvent(new CustomEvent(eh)))}function mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function tp(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function zi(n,e,t,i){let s=Qf.createElement(n);return e!=null&&mi(s,e),t?.insertBefore(s,i),s}function Ai(n,e){return zi("div",n,e)}var Zx=new WeakMap;function os(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Zx.get(n);r!=o&&(n.style.transform=r,Zx.set(n,r),e<0||t<0||e>i||t>s?mi(n,Fr):tp(n,Fr))}var jx=new WeakMap;function Kx(n,e,t){let i=e+t,s=jx.get(n);i!=s&&(jx.set(n,i),n.style.background=e,n.style.borderColor=t)}var Jx=new WeakMap;function Qx(n,e,t,i){let s=e+""+t,r=Jx.get(n);s!=r&&(Jx.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var hp={passive:!0},hR={...hp,capture:!0};function Br(n,e,t,i){e.addEventListener(n,t,i?hR:hp)}function np(n,e,t,i){e.removeEventListener(n,t,hp)}Zo&&ep();function Vi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:gi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function T_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var C_=n=>n!=null,R_=n=>n!=null&&n>0,ih=T_(C_),dR=T_(R_);function fR(n,e,t,i=0,s=!1){let r=s?dR:ih,o=s?R_:C_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ht,l??-Ht]}function sh(n,e,t,i){let s=n_(n),r=n_(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ls:P_,a=s==1?gi:Ei,l=r==1?Ei:gi,c=a(o(En(n))),u=l(o(En(e))),h=$o(t,c),d=$o(t,u);return t==10&&(c<0&&(h=Wt(h,-c)),u<0&&(d=Wt(d,-u))),i||t==2?(n=h*s,e=d*r):(n=D_(n,h),e=rh(e,d)),[n,e]}function dp(n,e,t,i){let s=sh(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var fp=.1,e_={mode:3,pad:fp},fl={pad:0,soft:null,mode:0},pR={min:fl,max:fl};function th(n,e,t,i){return oh(t)?t_(n,e,t):(fl.pad=t,fl.soft=i?0:null,fl.mode=i?3:0,t_(n,e,pR))}function Ct(n,e){return n??e}function mR(n,e,t){for(e=Ct(e,0),t=Ct(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function t_(n,e,t){let i=t.min,s=t.max,r=Ct(i.pad,0),o=Ct(s.pad,0),a=Ct(i.hard,-Ht),l=Ct(s.hard,Ht),c=Ct(i.soft,Ht),u=Ct(s.soft,-Ht),h=Ct(i.mode,0),d=Ct(s.mode,0),f=e-n,p=Ls(f),x=Jn(En(n),En(e)),m=Ls(x),g=En(m-p);(f<1e-24||g>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Ht&&(r=0),d==2&&u!=-Ht&&(o=0)));let _=f||x||1e3,w=Ls(_),S=$o(10,gi(w)),A=_*(f==0?n==0?.1:1:r),M=Wt(D_(n-A,S/10),24),y=n>=c&&(h==1||h==3&&M<=c||h==2&&M>=c)?c:Ht,v=Jn(a,M<y&&n>=y?y:Gi(y,M)),T=_*(f==0?e==0?.1:1:o),P=Wt(rh(e+T,S/10),24),C=e<=u&&(d==1||d==3&&P>=u||d==2&&P<=u)?u:-Ht,N=Gi(l,P>C&&e<=C?C:Jn(C,P));return v==N&&v==0&&(N=100),[v,N]}var gR=new Intl.NumberFormat(Zo?uR.language:"en-US"),pp=n=>gR.format(n),xi=Math,Qu=xi.PI,En=xi.abs,gi=xi.floor,An=xi.round,Ei=xi.ceil,Gi=xi.min,Jn=xi.max,$o=xi.pow,n_=xi.sign,Ls=xi.log10,P_=xi.log2,xR=(n,e=1)=>xi.sinh(n)*e,Zf=(n,e=1)=>xi.asinh(n/e),Ht=1/0;function i_(n){return(Ls((n^n>>31)-(n>>31))|0)+1}function ip(n,e,t){return Gi(Jn(n,e),t)}function I_(n){return typeof n=="function"}function wt(n){return I_(n)?n:()=>n}var _R=()=>{},L_=n=>n,N_=(n,e)=>e,yR=n=>null,s_=n=>!0,r_=(n,e)=>n==e,vR=/\.\d*?(?=9{6,}|0{6,})/gm,zr=n=>{if(O_(n)||pr.has(n))return n;let e=`${n}`,t=e.match(vR);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${zr(s)}e${r}`}return Wt(n,i)};function Or(n,e){return zr(Wt(zr(n/e))*e)}function rh(n,e){return zr(Ei(zr(n/e))*e)}function D_(n,e){return zr(gi(zr(n/e))*e)}function Wt(n,e=0){if(O_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return An(i)/t}var pr=new Map;function k_(n){return((""+n).split(".")[1]||"").length}function ml(n,e,t,i){let s=[],r=i.map(k_);for(let o=e;o<t;o++){let a=En(o),l=Wt($o(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:Wt(u,h);s.push(d),pr.set(d,h)}}return s}var pl={},mp=[],Xo=[null,null],fr=Array.isArray,O_=Number.isInteger,bR=n=>n===void 0;function o_(n){return typeof n=="string"}function oh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function SR(n){return n!=null&&typeof n=="object"}var wR=Object.getPrototypeOf(Uint8Array),U_="__proto__";function qo(n,e=oh){let t;if(fr(n)){let i=n.find(s=>s!=null);if(fr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=qo(n[s],e)}else t=n.slice()}else if(n instanceof wR)t=n.slice();else if(e(n)){t={};for(let i in n)i!=U_&&(t[i]=qo(n[i],e))}else t=n;return t}function yn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=U_&&(oh(n[s])?yn(n[s],qo(i[s])):n[s]=qo(i[s]))}return n}var MR=0,AR=1,ER=2;function TR(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function CR(n,e){if(IR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return LR(o[0])||(o=PR(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:AR,f=[];for(let p=0;p<u.length;p++){let x=u[p],m=r.get(l[p]);x===null?d!=MR&&(h[m]=x,d==ER&&f.push(m)):h[m]=x}TR(h,f,s),i.push(h)}}return i}var RR=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function PR(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function IR(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function LR(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,gi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var F_=["January","February","March","April","May","June","July","August","September","October","November","December"],B_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function z_(n){return n.slice(0,3)}var NR=B_.map(z_),DR=F_.map(z_),kR={MMMM:F_,MMM:DR,WWWW:B_,WWW:NR};function cl(n){return(n<10?"0":"")+n}function OR(n){return(n<10?"00":n<100?"0":"")+n}var UR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>cl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>cl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>cl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>cl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>cl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>OR(n.getMilliseconds())};function gp(n,e){e=e||kR;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?UR[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var FR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function BR(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==FR?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var V_=n=>n%1==0,nh=[1,2,2.5,5],zR=ml(10,-32,0,nh),G_=ml(10,0,32,nh),VR=G_.filter(V_),Ur=zR.concat(G_),xp=`
`,H_="{YYYY}",a_=xp+H_,W_="{M}/{D}",dl=xp+W_,Ku=dl+"/{YY}",$_="{aa}",GR="{h}:{mm}",Ho=GR+$_,l_=xp+Ho,c_=":{ss}",kt=null;function X_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?ml(10,0,3,nh).filter(V_):ml(10,-3,0,nh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,H_,kt,kt,kt,kt,kt,kt,1],[s*28,"{MMM}",a_,kt,kt,kt,kt,kt,1],[s,W_,a_,kt,kt,kt,kt,kt,1],[i,"{h}"+$_,Ku,kt,dl,kt,kt,kt,1],[t,Ho,Ku,kt,dl,kt,kt,kt,1],[e,c_,Ku+" "+Ho,kt,dl+" "+Ho,kt,l_,kt,1],[n,c_+".{fff}",Ku+" "+Ho,kt,dl+" "+Ho,kt,l_,kt,1]];function u(h){return(d,f,p,x,m,g)=>{let _=[],w=m>=o,S=m>=r&&m<o,A=h(p),M=Wt(A*n,3),y=jf(A.getFullYear(),w?0:A.getMonth(),S||w?1:A.getDate()),v=Wt(y*n,3);if(S||w){let T=S?m/r:0,P=w?m/o:0,C=M==v?M:Wt(jf(y.getFullYear()+P,y.getMonth()+T,1)*n,3),N=new Date(An(C/n)),F=N.getFullYear(),D=N.getMonth();for(let V=0;C<=x;V++){let $=jf(F+P*V,D+T*V,1),B=$-h(Wt($*n,3));C=Wt((+$+B)*n,3),C<=x&&_.push(C)}}else{let T=m>=s?s:m,P=gi(p)-gi(M),C=v+P+rh(M-v,T);_.push(C);let N=h(C),F=N.getHours()+N.getMinutes()/t+N.getSeconds()/i,D=m/i,V=d.axes[f]._space,$=g/V;for(;C=Wt(C+m,n==1?0:3),!(C>x);)if(D>1){let B=gi(Wt(F+D,6))%24,K=h(C).getHours()-B;K>1&&(K=-1),C-=K*i,F=(F+D)%24;let ee=_[_.length-1];Wt((C-ee)/m,3)*$>=.7&&_.push(C)}else _.push(C)}return _}}return[l,c,u]}var[HR,WR,$R]=X_(1),[XR,qR,YR]=X_(.001);ml(2,-53,53,[1]);function u_(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function h_(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,h,d,f;return i.map(p=>{let x=n(p),m=x.getFullYear(),g=x.getMonth(),_=x.getDate(),w=x.getHours(),S=x.getMinutes(),A=x.getSeconds(),M=m!=l&&a[2]||g!=c&&a[3]||_!=u&&a[4]||w!=h&&a[5]||S!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=_,h=w,d=S,f=A,M(x)})}}function ZR(n,e){let t=gp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function jf(n,e,t){return new Date(n,e,t)}function d_(n,e){return e(n)}var jR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function f_(n,e){return(t,i,s,r)=>r==null?up:e(n(i))}function KR(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function JR(n,e){return n.series[e].fill(n,e)}var QR={show:!0,live:!0,isolate:!1,mount:_R,markers:{show:!0,width:2,stroke:KR,fill:JR,dash:"solid"},idx:null,idxs:null,values:[]};function e2(n,e){let t=n.cursor.points,i=Ai(),s=t.size(n,e);Jt(i,ul,s),Jt(i,hl,s);let r=s/-2;Jt(i,"marginLeft",r),Jt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Jt(i,"borderWidth",o),i}function t2(n,e){let t=n.series[e].points;return t._fill||t._stroke}function n2(n,e){let t=n.series[e].points;return t._stroke||t._fill}function i2(n,e){return n.series[e].points.size}var Kf=[0,0];function s2(n,e,t){return Kf[0]=e,Kf[1]=t,Kf}function Ju(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Jf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var r2={show:!0,x:!0,y:!0,lock:!1,move:s2,points:{one:!1,show:e2,size:i2,width:0,stroke:n2,fill:t2},bind:{mousedown:Ju,mouseup:Ju,click:Ju,dblclick:Ju,mousemove:Jf,mouseleave:Jf,mouseenter:Jf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},q_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},_p=yn({},q_,{filter:N_}),Y_=yn({},_p,{size:10}),Z_=yn({},q_,{show:!1}),yp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',j_="bold "+yp,K_=1.5,p_={show:!0,scale:"x",stroke:cp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:j_,side:2,grid:_p,ticks:Y_,border:Z_,font:yp,lineGap:K_,rotate:0},o2="Value",a2="Time",m_={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function l2(n,e,t,i,s){return e.map(r=>r==null?"":pp(r))}function c2(n,e,t,i,s,r,o){let a=[],l=pr.get(s)||0;t=o?t:Wt(rh(t,s),l);for(let c=t;c<=i;c=Wt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function sp(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ls:P_,u=gi(c(t));s=$o(l,u),l==10&&(s=Ur[Vi(s,Ur)]);let h=t,d=s*l;l==10&&(d=Ur[Vi(d,Ur)]);do a.push(h),h=h+s,l==10&&!pr.has(h)&&(h=Wt(h,pr.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Ur[Vi(d,Ur)]));while(h<=i);return a}function u2(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?sp(n,e,Jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?sp(n,e,Jn(l,-i),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var J_=/./,h2=/[12357]/,d2=/[125]/,g_=/1/,rp=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function f2(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?J_:l(7,o)-u>=c?h2:l(5,o)-u>=c?d2:g_;if(h==g_){let d=En(l(1,o)-u);if(d<c)return rp(e.slice().reverse(),a.distr,h,Ei(c/d)).reverse()}return rp(e,a.distr,h,1)}function p2(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?rp(e.slice().reverse(),3,J_,Ei(a/c)).reverse():e}function m2(n,e,t,i){return i==null?up:e==null?"":pp(e)}var x_={show:!0,scale:"y",stroke:cp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:j_,side:3,grid:_p,ticks:Y_,border:Z_,font:yp,lineGap:K_,rotate:0};function g2(n,e){let t=3+(n||1)*2;return Wt(t*e,3)}function x2(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var __={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},Q_=(n,e,t,i,s)=>s,y_={show:!0,auto:!0,sorted:0,gaps:Q_,alpha:1,facets:[yn({},__,{scale:"x"}),yn({},__,{scale:"y"})]},v_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Q_,alpha:1,points:{show:x2,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function _2(n,e,t,i,s){return t/10}var ey={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},y2=yn({},ey,{time:!1,ori:1}),b_={};function ty(n,e){let t=b_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(b_[n]=t)),t}var Yo=1,op=2;function Vr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,x=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,h,m,g,d,f,p,x,lh,jo,uh,iy,ry):t(s,l,c,u,h,g,m,f,d,x,p,ch,Ko,Sp,sy,oy)}function vp(n,e){let t=0,i=0,s=Ct(n.bands,mp);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function v2(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ns(n,e,t,i,s,r){return Vr(n,e,(o,a,l,c,u,h,d,f,p,x,m)=>{let g=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?jo:Ko,S,A;_==1?(S=t,A=i):(S=i,A=t);let M=g(h(a[S],c,x,f)),y=g(d(l[S],u,m,p)),v=g(h(a[A],c,x,f)),T=g(d(r==1?u.max:u.min,u,m,p)),P=new Path2D(s);return w(P,v,T),w(P,M,T),w(P,M,y),P})}function ah(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?uh:Sp,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function b2(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function bp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),x=h-s;f=o<=0&&x>=0&&x<l?r(n[x]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function S_(n){return n==0?L_:n==1?An:e=>Or(e,n)}function ny(n){let e=n==0?lh:ch,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Gi(c,a/2,l/2),u=Gi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var lh=(n,e,t)=>{n.moveTo(e,t)},ch=(n,e,t)=>{n.moveTo(t,e)},jo=(n,e,t)=>{n.lineTo(e,t)},Ko=(n,e,t)=>{n.lineTo(t,e)},uh=ny(0),Sp=ny(1),iy=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},sy=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},ry=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},oy=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function ay(n){return(e,t,i,s,r)=>Vr(e,t,(o,a,l,c,u,h,d,f,p,x,m)=>{let{pxRound:g,points:_}=o,w,S;c.ori==0?(w=lh,S=iy):(w=ch,S=sy);let A=Wt(_.width*It,3),M=(_.size-_.width)/2*It,y=Wt(M*2,3),v=new Path2D,T=new Path2D,{left:P,top:C,width:N,height:F}=e.bbox;uh(T,P-y,C-y,N+y*2,F+y*2);let D=V=>{if(l[V]!=null){let $=g(h(a[V],c,x,f)),B=g(d(l[V],u,m,p));w(v,$+M,B),S(v,$,B,M,0,Qu*2)}};if(r)r.forEach(D);else for(let V=i;V<=s;V++)D(V);return{stroke:A>0?v:null,fill:v,clip:T,flags:Yo|op}})}function ly(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var S2=ly(jo),w2=ly(Ko);function cy(n){let e=Ct(n?.alignGaps,0);return(t,i,s,r)=>Vr(t,i,(o,a,l,c,u,h,d,f,p,x,m)=>{[s,r]=ih(l,s,r);let g=o.pxRound,_=F=>g(h(F,c,x,f)),w=F=>g(d(F,u,m,p)),S,A;c.ori==0?(S=jo,A=S2):(S=Ko,A=w2);let M=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},v=y.stroke,T=!1;if(r-s>=x*4){let F=ce=>t.posToVal(ce,c.key,!0),D=null,V=null,$,B,ne,Y=_(a[M==1?s:r]),K=_(a[s]),ee=_(a[r]),de=F(M==1?K+1:ee-1);for(let ce=M==1?s:r;ce>=s&&ce<=r;ce+=M){let te=a[ce],xe=(M==1?te<de:te>de)?Y:_(te),be=l[ce];xe==Y?be!=null?(B=be,D==null?(S(v,xe,w(B)),$=D=V=B):B<D?D=B:B>V&&(V=B)):be===null&&(T=!0):(D!=null&&A(v,Y,w(D),w(V),w($),w(B)),be!=null?(B=be,S(v,xe,w(B)),D=V=$=B):(D=V=null,be===null&&(T=!0)),Y=xe,de=F(Y+M))}D!=null&&D!=V&&ne!=Y&&A(v,Y,w(D),w(V),w($),w(B))}else for(let F=M==1?s:r;F>=s&&F<=r;F+=M){let D=l[F];D===null?T=!0:D!=null&&S(v,_(a[F]),w(D))}let[C,N]=vp(t,i);if(o.fill!=null||C!=0){let F=y.fill=new Path2D(v),D=o.fillTo(t,i,o.min,o.max,C),V=w(D),$=_(a[s]),B=_(a[r]);M==-1&&([B,$]=[$,B]),S(F,B,V),S(F,$,V)}if(!o.spanGaps){let F=[];T&&F.push(...bp(a,l,s,r,M,_,e)),y.gaps=F=o.gaps(t,i,s,r,F),y.clip=ah(F,c.ori,f,p,x,m)}return N!=0&&(y.band=N==2?[Ns(t,i,s,r,v,-1),Ns(t,i,s,r,v,1)]:Ns(t,i,s,r,v,N)),y})}function M2(n){let e=Ct(n.align,1),t=Ct(n.ascDesc,!1),i=Ct(n.alignGaps,0),s=Ct(n.extend,!1);return(r,o,a,l)=>Vr(r,o,(c,u,h,d,f,p,x,m,g,_,w)=>{[a,l]=ih(h,a,l);let S=c.pxRound,{left:A,width:M}=r.bbox,y=K=>S(p(K,d,_,m)),v=K=>S(x(K,f,w,g)),T=d.ori==0?jo:Ko,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Yo},C=P.stroke,N=d.dir*(d.ori==0?1:-1),F=v(h[N==1?a:l]),D=y(u[N==1?a:l]),V=D,$=D;s&&e==-1&&($=A,T(C,$,F)),T(C,D,F);for(let K=N==1?a:l;K>=a&&K<=l;K+=N){let ee=h[K];if(ee==null)continue;let de=y(u[K]),ce=v(ee);e==1?T(C,de,F):T(C,V,ce),T(C,de,ce),F=ce,V=de}let B=V;s&&e==1&&(B=A+M,T(C,B,F));let[ne,Y]=vp(r,o);if(c.fill!=null||ne!=0){let K=P.fill=new Path2D(C),ee=c.fillTo(r,o,c.min,c.max,ne),de=v(ee);T(K,B,de),T(K,$,de)}if(!c.spanGaps){let K=[];K.push(...bp(u,h,a,l,N,y,i));let ee=c.width*It/2,de=t||e==1?ee:-ee,ce=t||e==-1?-ee:ee;K.forEach(te=>{te[0]+=de,te[1]+=ce}),P.gaps=K=c.gaps(r,o,a,l,K),P.clip=ah(K,d.ori,m,g,_,w)}return Y!=0&&(P.band=Y==2?[Ns(r,o,a,l,C,-1),Ns(r,o,a,l,C,1)]:Ns(r,o,a,l,C,Y)),P})}function w_(n,e,t,i,s,r,o=Ht){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=En(n[l]-n[a]);u<c&&(c=u,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function A2(n){n=n||pl;let e=Ct(n.size,[.6,Ht,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=wt(s),o=1-e[0],a=Ct(e[1],Ht),l=Ct(e[2],1),c=Ct(n.disp,pl),u=Ct(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,x,m)=>Vr(f,p,(g,_,w,S,A,M,y,v,T,P,C)=>{let N=g.pxRound,F=t,D=i*It,V=a*It,$=l*It,B,ne;S.ori==0?[B,ne]=r(f,p):[ne,B]=r(f,p);let Y=S.dir*(S.ori==0?1:-1),K=S.ori==0?uh:Sp,ee=S.ori==0?u:(pe,ke,Qe,ye,Et,ze,Ye)=>{u(pe,ke,Qe,Et,ye,Ye,ze)},de=Ct(f.bands,mp).find(pe=>pe.series[0]==p),ce=de!=null?de.dir:0,te=g.fillTo(f,p,g.min,g.max,ce),fe=N(y(te,A,C,T)),xe,be,Se,$e=P,ot=N(g.width*It),We=!1,lt=null,ct=null,et=null,$t=null;h!=null&&(ot==0||d!=null)&&(We=!0,lt=h.values(f,p,x,m),ct=new Map,new Set(lt).forEach(pe=>{pe!=null&&ct.set(pe,new Path2D)}),ot>0&&(et=d.values(f,p,x,m),$t=new Map,new Set(et).forEach(pe=>{pe!=null&&$t.set(pe,new Path2D)})));let{x0:Bt,size:en}=c;if(Bt!=null&&en!=null){F=1,_=Bt.values(f,p,x,m),Bt.unit==2&&(_=_.map(Qe=>f.posToVal(v+Qe*P,S.key,!0)));let pe=en.values(f,p,x,m);en.unit==2?be=pe[0]*P:be=M(pe[0],S,P,v)-M(0,S,P,v),$e=w_(_,w,M,S,P,v,$e),Se=$e-be+D}else $e=w_(_,w,M,S,P,v,$e),Se=$e*o+D,be=$e-Se;Se<1&&(Se=0),ot>=be/2&&(ot=0),Se<5&&(N=L_);let At=Se>0,dn=$e-Se-(At?ot:0);be=N(ip(dn,$,V)),xe=(F==0?be/2:F==Y?0:be)-F*Y*((F==0?D/2:0)+(At?ot/2:0));let vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},we=We?null:new Path2D,Fe=null;if(de!=null)Fe=f.data[de.series[1]];else{let{y0:pe,y1:ke}=c;pe!=null&&ke!=null&&(w=ke.values(f,p,x,m),Fe=pe.values(f,p,x,m))}let Ze=B*be,z=ne*be;for(let pe=Y==1?x:m;pe>=x&&pe<=m;pe+=Y){let ke=w[pe];if(ke==null)continue;if(Fe!=null){let q=Fe[pe]??0;if(ke-q==0)continue;fe=y(q,A,C,T)}let Qe=S.distr!=2||c!=null?_[pe]:pe,ye=M(Qe,S,P,v),Et=y(Ct(ke,te),A,C,T),ze=N(ye-xe),Ye=N(Jn(Et,fe)),k=N(Gi(Et,fe)),R=Ye-k;if(ke!=null){let q=ke<0?z:Ze,ue=ke<0?Ze:z;We?(ot>0&&et[pe]!=null&&K($t.get(et[pe]),ze,k+gi(ot/2),be,Jn(0,R-ot),q,ue),lt[pe]!=null&&K(ct.get(lt[pe]),ze,k+gi(ot/2),be,Jn(0,R-ot),q,ue)):K(we,ze,k+gi(ot/2),be,Jn(0,R-ot),q,ue),ee(f,p,pe,ze-ot/2,k,be+ot,R)}}return ot>0?vt.stroke=We?$t:we:We||(vt._fill=g.width==0?g._fill:g._stroke??g._fill,vt.width=0),vt.fill=We?ct:we,vt})}function E2(n,e){let t=Ct(e?.alignGaps,0);return(i,s,r,o)=>Vr(i,s,(a,l,c,u,h,d,f,p,x,m,g)=>{[r,o]=ih(c,r,o);let _=a.pxRound,w=B=>_(d(B,u,m,p)),S=B=>_(f(B,h,g,x)),A,M,y;u.ori==0?(A=lh,y=jo,M=ry):(A=ch,y=Ko,M=oy);let v=u.dir*(u.ori==0?1:-1),T=w(l[v==1?r:o]),P=T,C=[],N=[];for(let B=v==1?r:o;B>=r&&B<=o;B+=v)if(c[B]!=null){let Y=l[B],K=w(Y);C.push(P=K),N.push(S(c[B]))}let F={stroke:n(C,N,A,y,M,_),fill:null,clip:null,band:null,gaps:null,flags:Yo},D=F.stroke,[V,$]=vp(i,s);if(a.fill!=null||V!=0){let B=F.fill=new Path2D(D),ne=a.fillTo(i,s,a.min,a.max,V),Y=S(ne);y(B,P,Y),y(B,T,Y)}if(!a.spanGaps){let B=[];B.push(...bp(l,c,r,o,v,w,t)),F.gaps=B=a.gaps(i,s,r,o,B),F.clip=ah(B,u.ori,p,x,m,g)}return $!=0&&(F.band=$==2?[Ns(i,s,r,o,D,-1),Ns(i,s,r,o,D,1)]:Ns(i,s,r,o,D,$)),F})}function T2(n){return E2(C2,n)}function C2(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var ap=new Set;function M_(){for(let n of ap)n.syncRect(!0)}Zo&&(Br(lR,Wo,M_),Br(cR,Wo,M_,!0),Br(eh,Wo,()=>{hn.pxRatio=It}));var R2=cy(),P2=ay();function A_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>lp(r,o,e,t))}function I2(n,e){return n.map((t,i)=>i==0?{}:yn({},e,t))}function lp(n,e,t,i){return yn({},e==0?t:i,n)}function uy(n,e,t){return e==null?Xo:[e,t]}var L2=uy;function N2(n,e,t){return e==null?Xo:th(e,t,fp,!0)}function hy(n,e,t,i){return e==null?Xo:sh(e,t,n.scales[i].log,!1)}var D2=hy;function dy(n,e,t,i){return e==null?Xo:dp(e,t,n.scales[i].log,!1)}var k2=dy;function O2(n,e,t,i,s){let r=Jn(i_(n),i_(e)),o=e-n,a=Vi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?pr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function E_(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=An((t=+s)*It))+"px"),[n,e,t]}function U2(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Wt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function hn(n,e,t){let i={mode:Ct(n.mode,1)},s=i.mode;function r(E,I,O,U){let X=I.valToPct(E);return U+O*(I.dir==-1?1-X:X)}function o(E,I,O,U){let X=I.valToPct(E);return U+O*(I.dir==-1?X:1-X)}function a(E,I,O,U){return I.ori==0?r(E,I,O,U):o(E,I,O,U)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ai(WC);if(n.id!=null&&(c.id=n.id),mi(c,n.class),n.title){let E=Ai(qC,c);E.textContent=n.title}let u=zi("canvas"),h=i.ctx=u.getContext("2d"),d=Ai(YC,c);Br("click",d,E=>{E.target===p&&(qt!=jr||Qt!=Kr)&&Dn.click(i,E)},!0);let f=i.under=Ai(ZC,d);d.appendChild(u);let p=i.over=Ai(jC,d);n=qo(n);let x=+Ct(n.pxAlign,1),m=S_(x);(n.plugins||[]).forEach(E=>{E.opts&&(n=E.opts(i,n)||n)});let g=n.ms||.001,_=i.series=s==1?A_(n.series||[],m_,v_,!1):I2(n.series||[null],y_),w=i.axes=A_(n.axes||[],p_,x_,!0),S=i.scales={},A=i.bands=n.bands||[];A.forEach(E=>{E.fill=wt(E.fill||null),E.dir=Ct(E.dir,-1)});let M=s==2?_[1].facets[0].scale:_[0].scale,y={axes:hs,series:gt},v=(n.drawOrder||["axes","series"]).map(E=>y[E]);function T(E){let I=E.distr==3?O=>Ls(O>0?O:E.clamp(i,O,E.min,E.max,E.key)):E.distr==4?O=>Zf(O,E.asinh):E.distr==100?O=>E.fwd(O):O=>O;return O=>{let U=I(O),{_min:X,_max:J}=E,le=J-X;return(U-X)/le}}function P(E){let I=S[E];if(I==null){let O=(n.scales||pl)[E]||pl;if(O.from!=null){P(O.from);let U=yn({},S[O.from],O,{key:E});U.valToPct=T(U),S[E]=U}else{I=S[E]=yn({},E==M?ey:y2,O),I.key=E;let U=I.time,X=I.range,J=fr(X);if((E!=M||s==2&&!U)&&(J&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?e_:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?e_:{mode:1,hard:X[1],soft:X[1]}},J=!1),!J&&oh(X))){let le=X;X=(me,Ae,De)=>Ae==null?Xo:th(Ae,De,le)}I.range=wt(X||(U?L2:E==M?I.distr==3?D2:I.distr==4?k2:uy:I.distr==3?hy:I.distr==4?dy:N2)),I.auto=wt(J?!1:I.auto),I.clamp=wt(I.clamp||_2),I._min=I._max=null,I.valToPct=T(I)}}}P("x"),P("y"),s==1&&_.forEach(E=>{P(E.scale)}),w.forEach(E=>{P(E.scale)});for(let E in n.scales)P(E);let C=S[M],N=C.distr,F,D;C.ori==0?(mi(c,$C),F=r,D=o):(mi(c,XC),F=o,D=r);let V={};for(let E in S){let I=S[E];(I.min!=null||I.max!=null)&&(V[E]={min:I.min,max:I.max},I.min=I.max=null)}let $=n.tzDate||(E=>new Date(An(E/g))),B=n.fmtDate||gp,ne=g==1?$R($):YR($),Y=h_($,u_(g==1?WR:qR,B)),K=f_($,d_(jR,B)),ee=[],de=i.legend=yn({},QR,n.legend),ce=i.cursor=yn({},r2,{drag:{y:s==2}},n.cursor),te=de.show,fe=ce.show,xe=de.markers;de.idxs=ee,xe.width=wt(xe.width),xe.dash=wt(xe.dash),xe.stroke=wt(xe.stroke),xe.fill=wt(xe.fill);let be,Se,$e,ot=[],We=[],lt,ct=!1,et={};if(de.live){let E=_[1]?_[1].values:null;ct=E!=null,lt=ct?E(i,1,0):{_:0};for(let I in lt)et[I]=up}if(te)if(be=zi("table",nR,c),$e=zi("tbody",null,be),de.mount(i,be),ct){Se=zi("thead",null,be,$e);let E=zi("tr",null,Se);zi("th",null,E);for(var $t in lt)zi("th",Vx,E).textContent=$t}else mi(be,sR),de.live&&mi(be,iR);let Bt={show:!0},en={show:!1};function At(E,I){if(I==0&&(ct||!de.live||s==2))return Xo;let O=[],U=zi("tr",rR,$e,$e.childNodes[I]);mi(U,E.class),E.show||mi(U,Fr);let X=zi("th",null,U);if(xe.show){let me=Ai(oR,X);if(I>0){let Ae=xe.width(i,I);Ae&&(me.style.border=Ae+"px "+xe.dash(i,I)+" "+xe.stroke(i,I)),me.style.background=xe.fill(i,I)}}let J=Ai(Vx,X);E.label instanceof HTMLElement?J.appendChild(E.label):J.textContent=E.label,I>0&&(xe.show||(J.style.color=E.width>0?xe.stroke(i,I):xe.fill(i,I)),vt("click",X,me=>{if(ce._lock)return;nt(me);let Ae=_.indexOf(E);if((me.ctrlKey||me.metaKey)!=de.isolate){let De=_.some((Oe,Be)=>Be>0&&Be!=Ae&&Oe.show);_.forEach((Oe,Be)=>{Be>0&&Xi(Be,De?Be==Ae?Bt:en:Bt,!0,gn.setSeries)})}else Xi(Ae,{show:!E.show},!0,gn.setSeries)},!1),it&&vt($x,X,me=>{ce._lock||(nt(me),Xi(_.indexOf(E),Qr,!0,gn.setSeries))},!1));for(var le in lt){let me=zi("td",aR,U);me.textContent="--",O.push(me)}return[U,O]}let dn=new Map;function vt(E,I,O,U=!0){let X=dn.get(I)||{},J=ce.bind[E](i,I,O,U);J&&(Br(E,I,X[E]=J),dn.set(I,X))}function we(E,I,O){let U=dn.get(I)||{};for(let X in U)(E==null||X==E)&&(np(X,I,U[X]),delete U[X]);E==null&&dn.delete(I)}let Fe=0,Ze=0,z=0,pe=0,ke=0,Qe=0,ye=ke,Et=Qe,ze=z,Ye=pe,k=0,R=0,q=0,ue=0;i.bbox={};let ae=!1,ve=!1,Me=!1,ie=!1,re=!1,ge=!1;function G(E,I,O){(O||E!=i.width||I!=i.height)&&oe(E,I),ft(!1),Me=!0,ve=!0,Un()}function oe(E,I){i.width=Fe=z=E,i.height=Ze=pe=I,ke=Qe=0,Ee(),Xe();let O=i.bbox;k=O.left=Or(ke*It,.5),R=O.top=Or(Qe*It,.5),q=O.width=Or(z*It,.5),ue=O.height=Or(pe*It,.5)}let se=3;function Te(){let E=!1,I=0;for(;!E;){I++;let O=qr(I),U=$i(I);E=I==se||O&&U,E||(oe(i.width,i.height),ve=!0)}}function _e({width:E,height:I}){G(E,I)}i.setSize=_e;function Ee(){let E=!1,I=!1,O=!1,U=!1;w.forEach((X,J)=>{if(X.show&&X._show){let{side:le,_size:me}=X,Ae=le%2,De=X.label!=null?X.labelSize:0,Oe=me+De;Oe>0&&(Ae?(z-=Oe,le==3?(ke+=Oe,U=!0):O=!0):(pe-=Oe,le==0?(Qe+=Oe,E=!0):I=!0))}}),Hi[0]=E,Hi[1]=O,Hi[2]=I,Hi[3]=U,z-=Ci[1]+Ci[3],ke+=Ci[3],pe-=Ci[2]+Ci[0],Qe+=Ci[0]}function Xe(){let E=ke+z,I=Qe+pe,O=ke,U=Qe;function X(J,le){switch(J){case 1:return E+=le,E-le;case 2:return I+=le,I-le;case 3:return O-=le,O+le;case 0:return U-=le,U+le}}w.forEach((J,le)=>{if(J.show&&J._show){let me=J.side;J._pos=X(me,J._size),J.label!=null&&(J._lpos=X(me,J.labelSize))}})}if(ce.dataIdx==null){let E=ce.hover,I=E.skip=new Set(E.skip??[]);I.add(void 0);let O=E.prox=wt(E.prox),U=E.bias??=0;ce.dataIdx=(X,J,le,me)=>{if(J==0)return le;let Ae=le,De=O(X,J,le,me)??Ht,Oe=De>=0&&De<Ht,Be=C.ori==0?z:pe,ut=ce.left,Rt=e[0],Tt=e[J];if(I.has(Tt[le])){Ae=null;let yt=null,tt=null,qe;if(U==0||U==-1)for(qe=le;yt==null&&qe-- >0;)I.has(Tt[qe])||(yt=qe);if(U==0||U==1)for(qe=le;tt==null&&qe++<Tt.length;)I.has(Tt[qe])||(tt=qe);if(yt!=null||tt!=null)if(Oe){let Zt=yt==null?-1/0:F(Rt[yt],C,Be,0),rn=tt==null?1/0:F(Rt[tt],C,Be,0),Pn=ut-Zt,zt=rn-ut;Pn<=zt?Pn<=De&&(Ae=yt):zt<=De&&(Ae=tt)}else Ae=tt==null?yt:yt==null?tt:le-yt<=tt-le?yt:tt}else Oe&&En(ut-F(Rt[le],C,Be,0))>De&&(Ae=null);return Ae}}let nt=E=>{ce.event=E};ce.idxs=ee,ce._lock=!1;let he=ce.points;he.show=wt(he.show),he.size=wt(he.size),he.stroke=wt(he.stroke),he.width=wt(he.width),he.fill=wt(he.fill);let Ve=i.focus=yn({},n.focus||{alpha:.3},ce.focus),it=Ve.prox>=0,Pe=it&&he.one,ht=[],Xt=[],Gn=[];function na(E,I){let O=he.show(i,I);if(O instanceof HTMLElement)return mi(O,tR),mi(O,E.class),os(O,-10,-10,z,pe),p.insertBefore(O,ht[I]),O}function Wr(E,I){if(s==1||I>0){let O=s==1&&S[E.scale].time,U=E.value;E.value=O?o_(U)?f_($,d_(U,B)):U||K:U||m2,E.label=E.label||(O?a2:o2)}if(Pe||I>0){E.width=E.width==null?1:E.width,E.paths=E.paths||R2||yR,E.fillTo=wt(E.fillTo||v2),E.pxAlign=+Ct(E.pxAlign,x),E.pxRound=S_(E.pxAlign),E.stroke=wt(E.stroke||null),E.fill=wt(E.fill||null),E._stroke=E._fill=E._paths=E._focus=null;let O=g2(Jn(1,E.width),1),U=E.points=yn({},{size:O,width:Jn(1,O*.2),stroke:E.stroke,space:O*2,paths:P2,_stroke:null,_fill:null},E.points);U.show=wt(U.show),U.filter=wt(U.filter),U.fill=wt(U.fill),U.stroke=wt(U.stroke),U.paths=wt(U.paths),U.pxAlign=E.pxAlign}if(te){let O=At(E,I);ot.splice(I,0,O[0]),We.splice(I,0,O[1]),de.values.push(null)}if(fe){ee.splice(I,0,null);let O=null;Pe?I==0&&(O=na(E,I)):I>0&&(O=na(E,I)),ht.splice(I,0,O),Xt.splice(I,0,0),Gn.splice(I,0,0)}Rn("addSeries",I)}function Fh(E,I){I=I??_.length,E=s==1?lp(E,I,m_,v_):lp(E,I,{},y_),_.splice(I,0,E),Wr(_[I],I)}i.addSeries=Fh;function wl(E){if(_.splice(E,1),te){de.values.splice(E,1),We.splice(E,1);let I=ot.splice(E,1)[0];we(null,I.firstChild),I.remove()}fe&&(ee.splice(E,1),ht.splice(E,1)[0].remove(),Xt.splice(E,1),Gn.splice(E,1)),Rn("delSeries",E)}i.delSeries=wl;let Hi=[!1,!1,!1,!1];function ls(E,I){if(E._show=E.show,E.show){let O=E.side%2,U=S[E.scale];U==null&&(E.scale=O?_[1].scale:M,U=S[E.scale]);let X=U.time;E.size=wt(E.size),E.space=wt(E.space),E.rotate=wt(E.rotate),fr(E.incrs)&&E.incrs.forEach(le=>{!pr.has(le)&&pr.set(le,k_(le))}),E.incrs=wt(E.incrs||(U.distr==2?VR:X?g==1?HR:XR:Ur)),E.splits=wt(E.splits||(X&&U.distr==1?ne:U.distr==3?sp:U.distr==4?u2:c2)),E.stroke=wt(E.stroke),E.grid.stroke=wt(E.grid.stroke),E.ticks.stroke=wt(E.ticks.stroke),E.border.stroke=wt(E.border.stroke);let J=E.values;E.values=fr(J)&&!fr(J[0])?wt(J):X?fr(J)?h_($,u_(J,B)):o_(J)?ZR($,J):J||Y:J||l2,E.filter=wt(E.filter||(U.distr>=3&&U.log==10?f2:U.distr==3&&U.log==2?p2:N_)),E.font=E_(E.font),E.labelFont=E_(E.labelFont),E._size=E.size(i,null,I,0),E._space=E._rotate=E._incrs=E._found=E._splits=E._values=null,E._size>0&&(Hi[I]=!0,E._el=Ai(KC,d))}}function cs(E,I,O,U){let[X,J,le,me]=O,Ae=I%2,De=0;return Ae==0&&(me||J)&&(De=I==0&&!X||I==2&&!le?An(p_.size/3):0),Ae==1&&(X||le)&&(De=I==1&&!J||I==3&&!me?An(x_.size/2):0),De}let ia=i.padding=(n.padding||[cs,cs,cs,cs]).map(E=>wt(Ct(E,cs))),Ci=i._padding=ia.map((E,I)=>E(i,I,Hi,0)),nn,ln=null,cn=null,Wi=s==1?_[0].idxs:null,ii=null,Os=!1;function sa(E,I){if(e=E??[],i.data=i._data=e,s==2){nn=0;for(let O=1;O<_.length;O++)nn+=e[O][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ii=e[0],nn=ii.length;let O=e;if(N==2){O=e.slice();let U=O[0]=Array(nn);for(let X=0;X<nn;X++)U[X]=X}i._data=e=O}if(ft(!0),Rn("setData"),N==2&&(Me=!0),I!==!1){let O=C;O.auto(i,Os)?ra():Bs(M,O.min,O.max),ie=ie||ce.left>=0,ge=!0,Un()}}i.setData=sa;function ra(){Os=!0;let E,I;s==1&&(nn>0?(ln=Wi[0]=0,cn=Wi[1]=nn-1,E=e[0][ln],I=e[0][cn],N==2?(E=ln,I=cn):E==I&&(N==3?[E,I]=sh(E,E,C.log,!1):N==4?[E,I]=dp(E,E,C.log,!1):C.time?I=E+An(86400/g):[E,I]=th(E,I,fp,!0))):(ln=Wi[0]=E=null,cn=Wi[1]=I=null)),Bs(M,E,I)}let $r,Us,Xr,L,W,Q,Z,j,Ce,Ie;function Re(E,I,O,U,X,J){E??=Hx,O??=mp,U??="butt",X??=Hx,J??="round",E!=$r&&(h.strokeStyle=$r=E),X!=Us&&(h.fillStyle=Us=X),I!=Xr&&(h.lineWidth=Xr=I),J!=W&&(h.lineJoin=W=J),U!=Q&&(h.lineCap=Q=U),O!=L&&h.setLineDash(L=O)}function Le(E,I,O,U){I!=Us&&(h.fillStyle=Us=I),E!=Z&&(h.font=Z=E),O!=j&&(h.textAlign=j=O),U!=Ce&&(h.textBaseline=Ce=U)}function He(E,I,O,U,X=0){if(U.length>0&&E.auto(i,Os)&&(I==null||I.min==null)){let J=Ct(ln,0),le=Ct(cn,U.length-1),me=O.min==null?fR(U,J,le,X,E.distr==3):[O.min,O.max];E.min=Gi(E.min,O.min=me[0]),E.max=Jn(E.max,O.max=me[1])}}let at={min:null,max:null};function mt(){for(let U in S){let X=S[U];V[U]==null&&(X.min==null||V[M]!=null&&X.auto(i,Os))&&(V[U]=at)}for(let U in S){let X=S[U];V[U]==null&&X.from!=null&&V[X.from]!=null&&(V[U]=at)}V[M]!=null&&ft(!0);let E={};for(let U in V){let X=V[U];if(X!=null){let J=E[U]=qo(S[U],SR);if(X.min!=null)yn(J,X);else if(U!=M||s==2)if(nn==0&&J.from==null){let le=J.range(i,null,null,U);J.min=le[0],J.max=le[1]}else J.min=Ht,J.max=-Ht}}if(nn>0){_.forEach((U,X)=>{if(s==1){let J=U.scale,le=V[J];if(le==null)return;let me=E[J];if(X==0){let Ae=me.range(i,me.min,me.max,J);me.min=Ae[0],me.max=Ae[1],ln=Vi(me.min,e[0]),cn=Vi(me.max,e[0]),cn-ln>1&&(e[0][ln]<me.min&&ln++,e[0][cn]>me.max&&cn--),U.min=ii[ln],U.max=ii[cn]}else U.show&&U.auto&&He(me,le,U,e[X],U.sorted);U.idxs[0]=ln,U.idxs[1]=cn}else if(X>0&&U.show&&U.auto){let[J,le]=U.facets,me=J.scale,Ae=le.scale,[De,Oe]=e[X],Be=E[me],ut=E[Ae];Be!=null&&He(Be,V[me],J,De,J.sorted),ut!=null&&He(ut,V[Ae],le,Oe,le.sorted),U.min=le.min,U.max=le.max}});for(let U in E){let X=E[U],J=V[U];if(X.from==null&&(J==null||J.min==null)){let le=X.range(i,X.min==Ht?null:X.min,X.max==-Ht?null:X.max,U);X.min=le[0],X.max=le[1]}}}for(let U in E){let X=E[U];if(X.from!=null){let J=E[X.from];if(J.min==null)X.min=X.max=null;else{let le=X.range(i,J.min,J.max,U);X.min=le[0],X.max=le[1]}}}let I={},O=!1;for(let U in E){let X=E[U],J=S[U];if(J.min!=X.min||J.max!=X.max){J.min=X.min,J.max=X.max;let le=J.distr;J._min=le==3?Ls(J.min):le==4?Zf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Ls(J.max):le==4?Zf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,I[U]=O=!0}}if(O){_.forEach((U,X)=>{s==2?X>0&&I.y&&(U._paths=null):I[U.scale]&&(U._paths=null)});for(let U in I)Me=!0,Rn("setScale",U);fe&&ce.left>=0&&(ie=ge=!0)}for(let U in V)V[U]=null}function Ge(E){let I=ip(ln-1,0,nn-1),O=ip(cn+1,0,nn-1);for(;E[I]==null&&I>0;)I--;for(;E[O]==null&&O<nn-1;)O++;return[I,O]}function gt(){if(nn>0){let E=_.some(I=>I._focus)&&Ie!=Ve.alpha;E&&(h.globalAlpha=Ie=Ve.alpha),_.forEach((I,O)=>{if(O>0&&I.show&&(tn(O,!1),tn(O,!0),I._paths==null)){let U=Ie;Ie!=I.alpha&&(h.globalAlpha=Ie=I.alpha);let X=s==2?[0,e[O][0].length-1]:Ge(e[O]);I._paths=I.paths(i,O,X[0],X[1]),Ie!=U&&(h.globalAlpha=Ie=U)}}),_.forEach((I,O)=>{if(O>0&&I.show){let U=Ie;Ie!=I.alpha&&(h.globalAlpha=Ie=I.alpha),I._paths!=null&&Ot(O,!1);{let X=I._paths!=null?I._paths.gaps:null,J=I.points.show(i,O,ln,cn,X),le=I.points.filter(i,O,J,X);(J||le)&&(I.points._paths=I.points.paths(i,O,ln,cn,le),Ot(O,!0))}Ie!=U&&(h.globalAlpha=Ie=U),Rn("drawSeries",O)}}),E&&(h.globalAlpha=Ie=1)}}function tn(E,I){let O=I?_[E].points:_[E];O._stroke=O.stroke(i,E),O._fill=O.fill(i,E)}function Ot(E,I){let O=I?_[E].points:_[E],{stroke:U,fill:X,clip:J,flags:le,_stroke:me=O._stroke,_fill:Ae=O._fill,_width:De=O.width}=O._paths;De=Wt(De*It,3);let Oe=null,Be=De%2/2;I&&Ae==null&&(Ae=De>0?"#fff":me);let ut=O.pxAlign==1&&Be>0;if(ut&&h.translate(Be,Be),!I){let Rt=k-De/2,Tt=R-De/2,yt=q+De,tt=ue+De;Oe=new Path2D,Oe.rect(Rt,Tt,yt,tt)}I?Ue(me,De,O.dash,O.cap,Ae,U,X,le,J):Ut(E,me,De,O.dash,O.cap,Ae,U,X,le,Oe,J),ut&&h.translate(-Be,-Be)}function Ut(E,I,O,U,X,J,le,me,Ae,De,Oe){let Be=!1;Ae!=0&&A.forEach((ut,Rt)=>{if(ut.series[0]==E){let Tt=_[ut.series[1]],yt=e[ut.series[1]],tt=(Tt._paths||pl).band;fr(tt)&&(tt=ut.dir==1?tt[0]:tt[1]);let qe,Zt=null;Tt.show&&tt&&mR(yt,ln,cn)?(Zt=ut.fill(i,Rt)||J,qe=Tt._paths.clip):tt=null,Ue(I,O,U,X,Zt,le,me,Ae,De,Oe,qe,tt),Be=!0}}),Be||Ue(I,O,U,X,J,le,me,Ae,De,Oe)}let vn=Yo|op;function Ue(E,I,O,U,X,J,le,me,Ae,De,Oe,Be){Re(E,I,O,U,X),(Ae||De||Be)&&(h.save(),Ae&&h.clip(Ae),De&&h.clip(De)),Be?(me&vn)==vn?(h.clip(Be),Oe&&h.clip(Oe),bt(X,le),fn(E,J,I)):me&op?(bt(X,le),h.clip(Be),fn(E,J,I)):me&Yo&&(h.save(),h.clip(Be),Oe&&h.clip(Oe),bt(X,le),h.restore(),fn(E,J,I)):(bt(X,le),fn(E,J,I)),(Ae||De||Be)&&h.restore()}function fn(E,I,O){O>0&&(I instanceof Map?I.forEach((U,X)=>{h.strokeStyle=$r=X,h.stroke(U)}):I!=null&&E&&h.stroke(I))}function bt(E,I){I instanceof Map?I.forEach((O,U)=>{h.fillStyle=Us=U,h.fill(O)}):I!=null&&E&&h.fill(I)}function us(E,I,O,U){let X=w[E],J;if(U<=0)J=[0,0];else{let le=X._space=X.space(i,E,I,O,U),me=X._incrs=X.incrs(i,E,I,O,U,le);J=O2(I,O,me,U,le)}return X._found=J}function pn(E,I,O,U,X,J,le,me,Ae,De){let Oe=le%2/2;x==1&&h.translate(Oe,Oe),Re(me,le,Ae,De,me),h.beginPath();let Be,ut,Rt,Tt,yt=X+(U==0||U==3?-J:J);O==0?(ut=X,Tt=yt):(Be=X,Rt=yt);for(let tt=0;tt<E.length;tt++)I[tt]!=null&&(O==0?Be=Rt=E[tt]:ut=Tt=E[tt],h.moveTo(Be,ut),h.lineTo(Rt,Tt));h.stroke(),x==1&&h.translate(-Oe,-Oe)}function qr(E){let I=!0;return w.forEach((O,U)=>{if(!O.show)return;let X=S[O.scale];if(X.min==null){O._show&&(I=!1,O._show=!1,ft(!1));return}else O._show||(I=!1,O._show=!0,ft(!1));let J=O.side,le=J%2,{min:me,max:Ae}=X,[De,Oe]=us(U,me,Ae,le==0?z:pe);if(Oe==0)return;let Be=X.distr==2,ut=O._splits=O.splits(i,U,me,Ae,De,Oe,Be),Rt=X.distr==2?ut.map(qe=>ii[qe]):ut,Tt=X.distr==2?ii[ut[1]]-ii[ut[0]]:De,yt=O._values=O.values(i,O.filter(i,Rt,U,Oe,Tt),U,Oe,Tt);O._rotate=J==2?O.rotate(i,yt,U,Oe):0;let tt=O._size;O._size=Ei(O.size(i,yt,U,E)),tt!=null&&O._size!=tt&&(I=!1)}),I}function $i(E){let I=!0;return ia.forEach((O,U)=>{let X=O(i,U,Hi,E);X!=Ci[U]&&(I=!1),Ci[U]=X}),I}function hs(){for(let E=0;E<w.length;E++){let I=w[E];if(!I.show||!I._show)continue;let O=I.side,U=O%2,X,J,le=I.stroke(i,E),me=O==0||O==3?-1:1,[Ae,De]=I._found;if(I.label!=null){let $n=I.labelGap*me,oi=An((I._lpos+$n)*It);Le(I.labelFont[0],le,"center",O==2?"top":Gx),h.save(),U==1?(X=J=0,h.translate(oi,An(R+ue/2)),h.rotate((O==3?-Qu:Qu)/2)):(X=An(k+q/2),J=oi);let yr=I_(I.label)?I.label(i,E,Ae,De):I.label;h.fillText(yr,X,J),h.restore()}if(De==0)continue;let Oe=S[I.scale],Be=U==0?q:ue,ut=U==0?k:R,Rt=I._splits,Tt=Oe.distr==2?Rt.map($n=>ii[$n]):Rt,yt=Oe.distr==2?ii[Rt[1]]-ii[Rt[0]]:Ae,tt=I.ticks,qe=I.border,Zt=tt.show?tt.size:0,rn=An(Zt*It),Pn=An((I.alignTo==2?I._size-Zt-I.gap:I.gap)*It),zt=I._rotate*-Qu/180,on=m(I._pos*It),si=(rn+Pn)*me,Wn=on+si;J=U==0?Wn:0,X=U==1?Wn:0;let yi=I.font[0],Ri=I.align==1?Go:I.align==2?Xf:zt>0?Go:zt<0?Xf:U==0?"center":O==3?Xf:Go,Yi=zt||U==1?"middle":O==2?"top":Gx;Le(yi,le,Ri,Yi);let ri=I.font[1]*I.lineGap,vi=Rt.map($n=>m(a($n,Oe,Be,ut))),Pi=I._values;for(let $n=0;$n<Pi.length;$n++){let oi=Pi[$n];if(oi!=null){U==0?X=vi[$n]:J=vi[$n],oi=""+oi;let yr=oi.indexOf(`
`)==-1?[oi]:oi.split(/\n/gm);for(let Xn=0;Xn<yr.length;Xn++){let ym=yr[Xn];zt?(h.save(),h.translate(X,J+Xn*ri),h.rotate(zt),h.fillText(ym,0,0),h.restore()):h.fillText(ym,X,J+Xn*ri)}}}tt.show&&pn(vi,tt.filter(i,Tt,E,De,yt),U,O,on,rn,Wt(tt.width*It,3),tt.stroke(i,E),tt.dash,tt.cap);let Zi=I.grid;Zi.show&&pn(vi,Zi.filter(i,Tt,E,De,yt),U,U==0?2:1,U==0?R:k,U==0?ue:q,Wt(Zi.width*It,3),Zi.stroke(i,E),Zi.dash,Zi.cap),qe.show&&pn([on],[1],U==0?1:0,U==0?1:2,U==1?R:k,U==1?ue:q,Wt(qe.width*It,3),qe.stroke(i,E),qe.dash,qe.cap)}Rn("drawAxes")}function ft(E){_.forEach((I,O)=>{O>0&&(I._paths=null,E&&(s==1?(I.min=null,I.max=null):I.facets.forEach(U=>{U.min=null,U.max=null})))})}let sn=!1,Hn=!1,Ft=[];function mn(){Hn=!1;for(let E=0;E<Ft.length;E++)Rn(...Ft[E]);Ft.length=0}function Un(){sn||(RR(tm),sn=!0)}function Ml(E,I=!1){sn=!0,Hn=I,E(i),tm(),I&&Ft.length>0&&queueMicrotask(mn)}i.batch=Ml;function tm(){if(ae&&(mt(),ae=!1),Me&&(Te(),Me=!1),ve){if(Jt(f,Go,ke),Jt(f,"top",Qe),Jt(f,ul,z),Jt(f,hl,pe),Jt(p,Go,ke),Jt(p,"top",Qe),Jt(p,ul,z),Jt(p,hl,pe),Jt(d,ul,Fe),Jt(d,hl,Ze),u.width=An(Fe*It),u.height=An(Ze*It),w.forEach(({_el:E,_show:I,_size:O,_pos:U,side:X})=>{if(E!=null)if(I){let J=X===3||X===0?O:0,le=X%2==1;Jt(E,le?"left":"top",U-J),Jt(E,le?"width":"height",O),Jt(E,le?"top":"left",le?Qe:ke),Jt(E,le?"height":"width",le?pe:z),tp(E,Fr)}else mi(E,Fr)}),$r=Us=Xr=W=Q=Z=j=Ce=L=null,Ie=1,la(!0),ke!=ye||Qe!=Et||z!=ze||pe!=Ye){ft(!1);let E=z/ze,I=pe/Ye;if(fe&&!ie&&ce.left>=0){ce.left*=E,ce.top*=I,Yr&&os(Yr,An(ce.left),0,z,pe),Zr&&os(Zr,0,An(ce.top),z,pe);for(let O=0;O<ht.length;O++){let U=ht[O];U!=null&&(Xt[O]*=E,Gn[O]*=I,os(U,Ei(Xt[O]),Ei(Gn[O]),z,pe))}}if(Yt.show&&!re&&Yt.left>=0&&Yt.width>0){Yt.left*=E,Yt.width*=E,Yt.top*=I,Yt.height*=I;for(let O in Wh)Jt(Jr,O,Yt[O])}ye=ke,Et=Qe,ze=z,Ye=pe}Rn("setSize"),ve=!1}Fe>0&&Ze>0&&(h.clearRect(0,0,u.width,u.height),Rn("drawClear"),v.forEach(E=>E()),Rn("draw")),Yt.show&&re&&(Al(Yt),re=!1),fe&&ie&&(_r(null,!0,!1),ie=!1),de.show&&de.live&&ge&&(Gh(),ge=!1),l||(l=!0,i.status=1,Rn("ready")),Os=!1,sn=!1}i.redraw=(E,I)=>{Me=I||!1,E!==!1?Bs(M,C.min,C.max):Un()};function Bh(E,I){let O=S[E];if(O.from==null){if(nn==0){let U=O.range(i,I.min,I.max,E);I.min=U[0],I.max=U[1]}if(I.min>I.max){let U=I.min;I.min=I.max,I.max=U}if(nn>1&&I.min!=null&&I.max!=null&&I.max-I.min<1e-16)return;E==M&&O.distr==2&&nn>0&&(I.min=Vi(I.min,e[0]),I.max=Vi(I.max,e[0]),I.min==I.max&&I.max++),V[E]=I,ae=!0,Un()}}i.setScale=Bh;let zh,Vh,Yr,Zr,nm,im,jr,Kr,sm,rm,qt,Qt,Fs=!1,Dn=ce.drag,Tn=Dn.x,Cn=Dn.y;fe&&(ce.x&&(zh=Ai(QC,p)),ce.y&&(Vh=Ai(eR,p)),C.ori==0?(Yr=zh,Zr=Vh):(Yr=Vh,Zr=zh),qt=ce.left,Qt=ce.top);let Yt=i.select=yn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Jr=Yt.show?Ai(JC,Yt.over?p:f):null;function Al(E,I){if(Yt.show){for(let O in E)Yt[O]=E[O],O in Wh&&Jt(Jr,O,E[O]);I!==!1&&Rn("setSelect")}}i.setSelect=Al;function Mb(E){if(_[E].show)te&&tp(ot[E],Fr);else if(te&&mi(ot[E],Fr),fe){let O=Pe?ht[0]:ht[E];O!=null&&os(O,-10,-10,z,pe)}}function Bs(E,I,O){Bh(E,{min:I,max:O})}function Xi(E,I,O,U){I.focus!=null&&Rb(E),I.show!=null&&_.forEach((X,J)=>{J>0&&(E==J||E==null)&&(X.show=I.show,Mb(J),s==2?(Bs(X.facets[0].scale,null,null),Bs(X.facets[1].scale,null,null)):Bs(X.scale,null,null),Un())}),O!==!1&&Rn("setSeries",E,I),U&&ca("setSeries",i,E,I)}i.setSeries=Xi;function Ab(E,I){yn(A[E],I)}function Eb(E,I){E.fill=wt(E.fill||null),E.dir=Ct(E.dir,-1),I=I??A.length,A.splice(I,0,E)}function Tb(E){E==null?A.length=0:A.splice(E,1)}i.addBand=Eb,i.setBand=Ab,i.delBand=Tb;function Cb(E,I){_[E].alpha=I,fe&&ht[E]!=null&&(ht[E].style.opacity=I),te&&ot[E]&&(ot[E].style.opacity=I)}let ds,zs,xr,Qr={focus:!0};function Rb(E){if(E!=xr){let I=E==null,O=Ve.alpha!=1;_.forEach((U,X)=>{if(s==1||X>0){let J=I||X==0||X==E;U._focus=I?null:J,O&&Cb(X,J?1:Ve.alpha)}}),xr=E,O&&Un()}}te&&it&&vt(Xx,be,E=>{ce._lock||(nt(E),xr!=null&&Xi(null,Qr,!0,gn.setSeries))});function qi(E,I,O){let U=S[I];O&&(E=E/It-(U.ori==1?Qe:ke));let X=z;U.ori==1&&(X=pe,E=X-E),U.dir==-1&&(E=X-E);let J=U._min,le=U._max,me=E/X,Ae=J+(le-J)*me,De=U.distr;return De==3?$o(10,Ae):De==4?xR(Ae,U.asinh):De==100?U.bwd(Ae):Ae}function Pb(E,I){let O=qi(E,M,I);return Vi(O,e[0],ln,cn)}i.valToIdx=E=>Vi(E,e[0]),i.posToIdx=Pb,i.posToVal=qi,i.valToPos=(E,I,O)=>S[I].ori==0?r(E,S[I],O?q:z,O?k:0):o(E,S[I],O?ue:pe,O?R:0),i.setCursor=(E,I,O)=>{qt=E.left,Qt=E.top,_r(null,I,O)};function om(E,I){Jt(Jr,Go,Yt.left=E),Jt(Jr,ul,Yt.width=I)}function am(E,I){Jt(Jr,"top",Yt.top=E),Jt(Jr,hl,Yt.height=I)}let oa=C.ori==0?om:am,aa=C.ori==1?om:am;function Ib(){if(te&&de.live)for(let E=s==2?1:0;E<_.length;E++){if(E==0&&ct)continue;let I=de.values[E],O=0;for(let U in I)We[E][O++].firstChild.nodeValue=I[U]}}function Gh(E,I){if(E!=null&&(E.idxs?E.idxs.forEach((O,U)=>{ee[U]=O}):bR(E.idx)||ee.fill(E.idx),de.idx=ee[0]),te&&de.live){for(let O=0;O<_.length;O++)(O>0||s==1&&!ct)&&Lb(O,ee[O]);Ib()}ge=!1,I!==!1&&Rn("setLegend")}i.setLegend=Gh;function Lb(E,I){let O=_[E],U=E==0&&N==2?ii:e[E],X;ct?X=O.values(i,E,I)??et:(X=O.value(i,I==null?null:U[I],E,I),X=X==null?et:{_:X}),de.values[E]=X}function _r(E,I,O){sm=qt,rm=Qt,[qt,Qt]=ce.move(i,qt,Qt),ce.left=qt,ce.top=Qt,fe&&(Yr&&os(Yr,An(qt),0,z,pe),Zr&&os(Zr,0,An(Qt),z,pe));let U,X=ln>cn;ds=Ht,zs=null;let J=C.ori==0?z:pe,le=C.ori==1?z:pe;if(qt<0||nn==0||X){U=ce.idx=null;for(let me=0;me<_.length;me++){let Ae=ht[me];Ae!=null&&os(Ae,-10,-10,z,pe)}it&&Xi(null,Qr,!0,E==null&&gn.setSeries),de.live&&(ee.fill(U),ge=!0)}else{let me,Ae,De;s==1&&(me=C.ori==0?qt:Qt,Ae=qi(me,M),U=ce.idx=Vi(Ae,e[0],ln,cn),De=F(e[0][U],C,J,0));let Oe=-10,Be=-10,ut=0,Rt=0,Tt=!0,yt="",tt="";for(let qe=s==2?1:0;qe<_.length;qe++){let Zt=_[qe],rn=ee[qe],Pn=rn==null?null:s==1?e[qe][rn]:e[qe][1][rn],zt=ce.dataIdx(i,qe,U,Ae),on=zt==null?null:s==1?e[qe][zt]:e[qe][1][zt];if(ge=ge||on!=Pn||zt!=rn,ee[qe]=zt,qe>0&&Zt.show){let si=zt==null?-10:zt==U?De:F(s==1?e[0][zt]:e[qe][0][zt],C,J,0),Wn=on==null?-10:D(on,s==1?S[Zt.scale]:S[Zt.facets[1].scale],le,0);if(it&&on!=null){let yi=C.ori==1?qt:Qt,Ri=En(Ve.dist(i,qe,zt,Wn,yi));if(Ri<ds){let Yi=Ve.bias;if(Yi!=0){let ri=qi(yi,Zt.scale),vi=on>=0?1:-1,Pi=ri>=0?1:-1;Pi==vi&&(Pi==1?Yi==1?on>=ri:on<=ri:Yi==1?on<=ri:on>=ri)&&(ds=Ri,zs=qe)}else ds=Ri,zs=qe}}if(ge||Pe){let yi,Ri;C.ori==0?(yi=si,Ri=Wn):(yi=Wn,Ri=si);let Yi,ri,vi,Pi,Zi,$n,oi=!0,yr=he.bbox;if(yr!=null){oi=!1;let Xn=yr(i,qe);vi=Xn.left,Pi=Xn.top,Yi=Xn.width,ri=Xn.height}else vi=yi,Pi=Ri,Yi=ri=he.size(i,qe);if($n=he.fill(i,qe),Zi=he.stroke(i,qe),Pe)qe==zs&&ds<=Ve.prox&&(Oe=vi,Be=Pi,ut=Yi,Rt=ri,Tt=oi,yt=$n,tt=Zi);else{let Xn=ht[qe];Xn!=null&&(Xt[qe]=vi,Gn[qe]=Pi,Qx(Xn,Yi,ri,oi),Kx(Xn,$n,Zi),os(Xn,Ei(vi),Ei(Pi),z,pe))}}}}if(Pe){let qe=Ve.prox,Zt=xr==null?ds<=qe:ds>qe||zs!=xr;if(ge||Zt){let rn=ht[0];rn!=null&&(Xt[0]=Oe,Gn[0]=Be,Qx(rn,ut,Rt,Tt),Kx(rn,yt,tt),os(rn,Ei(Oe),Ei(Be),z,pe))}}}if(Yt.show&&Fs)if(E!=null){let[me,Ae]=gn.scales,[De,Oe]=gn.match,[Be,ut]=E.cursor.sync.scales,Rt=E.cursor.drag;if(Tn=Rt._x,Cn=Rt._y,Tn||Cn){let{left:Tt,top:yt,width:tt,height:qe}=E.select,Zt=E.scales[Be].ori,rn=E.posToVal,Pn,zt,on,si,Wn,yi=me!=null&&De(me,Be),Ri=Ae!=null&&Oe(Ae,ut);yi&&Tn?(Zt==0?(Pn=Tt,zt=tt):(Pn=yt,zt=qe),on=S[me],si=F(rn(Pn,Be),on,J,0),Wn=F(rn(Pn+zt,Be),on,J,0),oa(Gi(si,Wn),En(Wn-si))):oa(0,J),Ri&&Cn?(Zt==1?(Pn=Tt,zt=tt):(Pn=yt,zt=qe),on=S[Ae],si=D(rn(Pn,ut),on,le,0),Wn=D(rn(Pn+zt,ut),on,le,0),aa(Gi(si,Wn),En(Wn-si))):aa(0,le)}else $h()}else{let me=En(sm-nm),Ae=En(rm-im);if(C.ori==1){let ut=me;me=Ae,Ae=ut}Tn=Dn.x&&me>=Dn.dist,Cn=Dn.y&&Ae>=Dn.dist;let De=Dn.uni;De!=null?Tn&&Cn&&(Tn=me>=De,Cn=Ae>=De,!Tn&&!Cn&&(Ae>me?Cn=!0:Tn=!0)):Dn.x&&Dn.y&&(Tn||Cn)&&(Tn=Cn=!0);let Oe,Be;Tn&&(C.ori==0?(Oe=jr,Be=qt):(Oe=Kr,Be=Qt),oa(Gi(Oe,Be),En(Be-Oe)),Cn||aa(0,le)),Cn&&(C.ori==1?(Oe=jr,Be=qt):(Oe=Kr,Be=Qt),aa(Gi(Oe,Be),En(Be-Oe)),Tn||oa(0,J)),!Tn&&!Cn&&(oa(0,0),aa(0,0))}if(Dn._x=Tn,Dn._y=Cn,E==null){if(O){if(_m!=null){let[me,Ae]=gn.scales;gn.values[0]=me!=null?qi(C.ori==0?qt:Qt,me):null,gn.values[1]=Ae!=null?qi(C.ori==1?qt:Qt,Ae):null}ca(qf,i,qt,Qt,z,pe,U)}if(it){let me=O&&gn.setSeries,Ae=Ve.prox;xr==null?ds<=Ae&&Xi(zs,Qr,!0,me):ds>Ae?Xi(null,Qr,!0,me):zs!=xr&&Xi(zs,Qr,!0,me)}}ge&&(de.idx=U,Gh()),I!==!1&&Rn("setCursor")}let Vs=null;Object.defineProperty(i,"rect",{get(){return Vs==null&&la(!1),Vs}});function la(E=!1){E?Vs=null:(Vs=p.getBoundingClientRect(),Rn("syncRect",Vs))}function lm(E,I,O,U,X,J,le){ce._lock||Fs&&E!=null&&E.movementX==0&&E.movementY==0||(Hh(E,I,O,U,X,J,le,!1,E!=null),E!=null?_r(null,!0,!0):_r(I,!0,!1))}function Hh(E,I,O,U,X,J,le,me,Ae){if(Vs==null&&la(!1),nt(E),E!=null)O=E.clientX-Vs.left,U=E.clientY-Vs.top;else{if(O<0||U<0){qt=-10,Qt=-10;return}let[De,Oe]=gn.scales,Be=I.cursor.sync,[ut,Rt]=Be.values,[Tt,yt]=Be.scales,[tt,qe]=gn.match,Zt=I.axes[0].side%2==1,rn=C.ori==0?z:pe,Pn=C.ori==1?z:pe,zt=Zt?J:X,on=Zt?X:J,si=Zt?U:O,Wn=Zt?O:U;if(Tt!=null?O=tt(De,Tt)?a(ut,S[De],rn,0):-10:O=rn*(si/zt),yt!=null?U=qe(Oe,yt)?a(Rt,S[Oe],Pn,0):-10:U=Pn*(Wn/on),C.ori==1){let yi=O;O=U,U=yi}}Ae&&(I==null||I.cursor.event.type==qf)&&((O<=1||O>=z-1)&&(O=Or(O,z)),(U<=1||U>=pe-1)&&(U=Or(U,pe))),me?(nm=O,im=U,[jr,Kr]=ce.move(i,O,U)):(qt=O,Qt=U)}let Wh={width:0,height:0,left:0,top:0};function $h(){Al(Wh,!1)}let cm,um,hm,dm;function fm(E,I,O,U,X,J,le){Fs=!0,Tn=Cn=Dn._x=Dn._y=!1,Hh(E,I,O,U,X,J,le,!0,!1),E!=null&&(vt(Yf,Qf,pm,!1),ca(Wx,i,jr,Kr,z,pe,null));let{left:me,top:Ae,width:De,height:Oe}=Yt;cm=me,um=Ae,hm=De,dm=Oe}function pm(E,I,O,U,X,J,le){Fs=Dn._x=Dn._y=!1,Hh(E,I,O,U,X,J,le,!1,!0);let{left:me,top:Ae,width:De,height:Oe}=Yt,Be=De>0||Oe>0,ut=cm!=me||um!=Ae||hm!=De||dm!=Oe;if(Be&&ut&&Al(Yt),Dn.setScale&&Be&&ut){let Rt=me,Tt=De,yt=Ae,tt=Oe;if(C.ori==1&&(Rt=Ae,Tt=Oe,yt=me,tt=De),Tn&&Bs(M,qi(Rt,M),qi(Rt+Tt,M)),Cn)for(let qe in S){let Zt=S[qe];qe!=M&&Zt.from==null&&Zt.min!=Ht&&Bs(qe,qi(yt+tt,qe),qi(yt,qe))}$h()}else ce.lock&&(ce._lock=!ce._lock,_r(I,!0,E!=null));E!=null&&(we(Yf,Qf),ca(Yf,i,qt,Qt,z,pe,null))}function Nb(E,I,O,U,X,J,le){if(ce._lock)return;nt(E);let me=Fs;if(Fs){let Ae=!0,De=!0,Oe=10,Be,ut;C.ori==0?(Be=Tn,ut=Cn):(Be=Cn,ut=Tn),Be&&ut&&(Ae=qt<=Oe||qt>=z-Oe,De=Qt<=Oe||Qt>=pe-Oe),Be&&Ae&&(qt=qt<jr?0:z),ut&&De&&(Qt=Qt<Kr?0:pe),_r(null,!0,!0),Fs=!1}qt=-10,Qt=-10,ee.fill(null),_r(null,!0,!0),me&&(Fs=me)}function mm(E,I,O,U,X,J,le){ce._lock||(nt(E),ra(),$h(),E!=null&&ca(qx,i,qt,Qt,z,pe,null))}function gm(){w.forEach(U2),G(i.width,i.height,!0)}Br(eh,Wo,gm);let eo={};eo.mousedown=fm,eo.mousemove=lm,eo.mouseup=pm,eo.dblclick=mm,eo.setSeries=(E,I,O,U)=>{let X=gn.match[2];O=X(i,I,O),O!=-1&&Xi(O,U,!0,!1)},fe&&(vt(Wx,p,fm),vt(qf,p,lm),vt($x,p,E=>{nt(E),la(!1)}),vt(Xx,p,Nb),vt(qx,p,mm),ap.add(i),i.syncRect=la);let El=i.hooks=n.hooks||{};function Rn(E,I,O){Hn?Ft.push([E,I,O]):E in El&&El[E].forEach(U=>{U.call(null,i,I,O)})}(n.plugins||[]).forEach(E=>{for(let I in E.hooks)El[I]=(El[I]||[]).concat(E.hooks[I])});let xm=(E,I,O)=>O,gn=yn({key:null,setSeries:!1,filters:{pub:s_,sub:s_},scales:[M,_[1]?_[1].scale:null],match:[r_,r_,xm],values:[null,null]},ce.sync);gn.match.length==2&&gn.match.push(xm),ce.sync=gn;let _m=gn.key,Xh=ty(_m);function ca(E,I,O,U,X,J,le){gn.filters.pub(E,I,O,U,X,J,le)&&Xh.pub(E,I,O,U,X,J,le)}Xh.sub(i);function Db(E,I,O,U,X,J,le){gn.filters.sub(E,I,O,U,X,J,le)&&eo[E](null,I,O,U,X,J,le)}i.pub=Db;function kb(){Xh.unsub(i),ap.delete(i),dn.clear(),np(eh,Wo,gm),c.remove(),be?.remove(),Rn("destroy")}i.destroy=kb;function qh(){Rn("init",n,e),sa(e||n.data,!1),V[M]?Bh(M,V[M]):ra(),re=Yt.show&&(Yt.width>0||Yt.height>0),ie=ge=!0,G(n.width,n.height)}return _.forEach(Wr),w.forEach(ls),t?t instanceof HTMLElement?(t.appendChild(c),qh()):t(i,qh):qh(),i}hn.assign=yn;hn.fmtNum=pp;hn.rangeNum=th;hn.rangeLog=sh;hn.rangeAsinh=dp;hn.orient=Vr;hn.pxRatio=It;hn.join=CR;hn.fmtDate=gp,hn.tzDate=BR;hn.sync=ty;{hn.addGap=b2,hn.clipGaps=ah;let n=hn.paths={points:ay};n.linear=cy,n.stepped=M2,n.bars=A2,n.spline=T2}var F2=20,[B2,fy,hh]=[46,14,4],py=18,dh=26,z2=16,fh=12;function my(n,{name:e,lines:t,word:i="",under:s=()=>[],over:r=()=>[],lookOf:o=Fi}){return R0(()=>{let a=n.data.slice(1).map((m,g)=>o(g)),[l,c]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],u=F2+n.axes[1]._size,h=u+l+fy,d=V2(i,t,a,u,h-fy),f=d.height+8,p=[...s(),...G2(n,l,c),{kind:"clip",x:0,y:0,width:l,height:c,shapes:H2(n,a)},{kind:"path",points:[[0,0],[0,c],[l,c]],stroke:_t("--ink")},...r(),...W2(n,e,l,c,u)],x=f+c+B2;return{svg:ku([...d.shapes,{kind:"moved",x:u,y:f,shapes:p}],h,x,e),width:h,height:x}})}function V2(n,e,t,i,s){let r=document.createElement("canvas").getContext("2d");r.font=`${fh}px system-ui, sans-serif`;let o=[],[a,l]=[i,py-4],c=_t("--ink"),u=(h,d)=>{let f=d+r.measureText(h).width;a>i&&a+f>s&&([a,l]=[i,l+py]);let p=a;return a+=f+z2,p};n&&o.push({kind:"text",x:u(n,0),y:l,text:n,size:fh,fill:c});for(let[h,d]of e.entries()){let f=u(d,dh),{colour:p,dash:x,area:m}=t[h];m?o.push({kind:"rect",x:f,y:l-9,width:dh-6,height:9,fill:p}):o.push({kind:"path",points:[[f,l-4],[f+dh-6,l-4]],stroke:p,lineWidth:1.6,dash:x}),o.push({kind:"text",x:f+dh,y:l,text:d,size:fh,fill:c})}return{shapes:o,height:o.length?l+4:0}}function ph(n,e,t){let{_splits:i,_values:s}=n.axes[e];return i.flatMap((r,o)=>s[o]?[[n.valToPos(r,t),s[o]]]:[])}function G2(n,e,t){let i=(...s)=>({kind:"path",points:s,stroke:_t("--grid")});return[...ph(n,0,"x").map(([s])=>i([s,0],[s,t])),...ph(n,1,"y").map(([s])=>i([0,s],[e,s]))]}function H2(n,e){let[t,...i]=n.data;return i.map((s,r)=>{let{colour:o,dash:a,area:l}=e[r],c=[];for(let d=0;d<t.length;d++)s[d]===null||s[d]===void 0||Number.isNaN(s[d])||c.push([n.valToPos(t[d],"x"),n.valToPos(s[d],"y")]);if(!l||!c.length)return{kind:"path",points:c,stroke:o,lineWidth:1.6,dash:a};let u=n.valToPos(0,"y"),h=[c.at(-1),c[0]].map(([d])=>[d,u]);return{kind:"path",points:[...c,...h],fill:o,stroke:_t("--page"),lineWidth:.5}})}function W2(n,e,t,i,s){let[r,o]=[_t("--ink"),_t("--ink")],a=(c,u,h,d)=>({kind:"text",x:c,y:u,text:h,size:fh,fill:r,...d}),{label:l}=n.axes[0];return[...ph(n,0,"x").flatMap(([c,u])=>[{kind:"path",points:[[c,i],[c,i+hh]],stroke:o},a(c,i+hh+13,u,{anchor:"middle"})]),...ph(n,1,"y").flatMap(([c,u])=>[{kind:"path",points:[[0,c],[-hh,c]],stroke:o},a(-hh-4,c+4,u,{anchor:"end"})]),a(t/2,i+38,typeof l=="function"?l():l,{anchor:"middle"}),a(12-s,i/2,Nt(e),{anchor:"middle",turned:!0})]}var _h=210,$2=64,X2=.02,q2=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...rP(3,20)];function mr(n,e,t,i){let s=e.map(o=>Y2(o,t)),r=e.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>e[u].sharing===o.sharing).flat():null;return j2(o,s[a].map(c=>c.values),l,t,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function Y2(n,e){return n.lines.map(t=>({clip:t.clip,values:t.readings?e[t.clip].line(t.readings,t.part):Kt(t.values,Float32Array)}))}function Z2(n,e,t){let i=[1/0,-1/0];for(let{clip:s,values:r}of n){let o=e[s].time;for(let a=0;a<o.length;a++){let l=o[a]-t.origins[s];l<t.start||l>t.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function mh(n){let[e,...t]=n.lines.map(i=>i.clip);return t.every(i=>i===e)?e??null:null}function j2(n,e,t,i,s){let{element:r,head:o,key:a,place:l}=wp(n,n.owner),c=b("div",{className:"cursor"}),u=n.ball===void 0?null:b("div",{className:"ball"}),h=null,d=null,f=!1,p=[],x=new ResizeObserver(()=>h?.setSize({width:l.clientWidth,height:_h}));function m(){let{word:A}=n,M=xy(n).map((y,v)=>b("li",{},vr(gh(n,v)),y));a.replaceChildren(...A?[b("li",{},A)]:[],...M)}function g(){(s.span!==d||s.stretched!==f)&&(d=s.span,f=s.stretched,h.setData(gy(n,e,i,d),!1),h.setScale("x",{min:d.start,max:d.end}));let A=h.valToPos(s.time,"x").toFixed(2);c.style.transform=`translateX(${A}px)`,u&&(u.style.transform=`translate(${A}px, ${h.valToPos(_(),"y").toFixed(2)}px)`)}function _(){let{clip:A}=n.lines[n.ball];return or(i[A].time,e[n.ball],s.clipTime(A))}function w(){d=s.span,f=s.stretched,h=new hn(Q2(n,t,i,s,l.clientWidth),gy(n,e,i,d),l),h.setScale("x",{min:d.start,max:d.end}),h.over.append(c,...u?[u]:[]),sP(h,s),x.observe(l),h.hooks.setSize=[g];let A=()=>{m(),h.redraw(!1)};p=[s.onChange(g),sr(A)],m();let M=mh(n);o.append(Mp(n,()=>h,{under:()=>yy(h,i,M,s.span),over:()=>vy(h,i,M,s.span)}))}function S(){for(let A of p)A();x.disconnect(),h.destroy()}return{element:r,start:w,dispose:S,get chart(){return h}}}function wp(n,e=null){let t=e?`${Nt(e)}. ${n.text}`:n.text,i=b("div",{className:"chart",role:"img","aria-label":t}),s=b("ul",{className:"key"}),r=b("h2",{},`${Nt(n.title)} (${n.unit})`);e&&r.append(b("small",{},e));let o=b("div",{className:"head"},r);return{element:b("figure",{},o,s,i,b("figcaption",{},n.text)),head:o,key:s,place:i}}function xy({lines:n,word:e}){return n.map(({name:t})=>e?t.slice(e.length+1):t)}function gh({lines:n,stacked:e},t){let{area:i,look:s}=n[t];return i?{colour:i.startsWith("--")?_t(i):i,dash:[],area:!0}:e?{colour:_t("--ink"),dash:[]}:Fi(s??t)}function Mp(n,e,{under:t,over:i}){let s=n.owner?`${n.title}, ${n.owner}`:n.title;return ji(s,()=>qn(s),()=>my(e(),{name:`${n.title} (${n.unit})`,lines:xy(n),word:n.word,under:t,over:i,lookOf:n.stacked?o=>gh(n,o):void 0}))}function gy(n,e,t,i){if(n.stacked)return K2(n,e,t[n.lines[0].clip],i.origins[n.lines[0].clip]+i.start,i);let s=n.lines.map((r,o)=>[Float64Array.from(t[r.clip].time,a=>a-i.origins[r.clip]),e[o]]);return mh(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:hn.join(s)}function K2({lines:n},e,t,i,s){let r=n.map(({since:a},l)=>{let c=a===void 0?0:or(t.time,e[a],i);return Float64Array.from(e[l],u=>u-c)}),o=new Float64Array(t.time.length);for(let a=n.length-1;a>=0;a--)if(n[a].area){for(let l=0;l<o.length;l++)o[l]+=r[a][l];r[a].set(o)}return[Float64Array.from(t.time,a=>a-s.origins[n[0].clip]),...r]}function J2(n){return n.lines.map(({area:e},t)=>({stroke:()=>e?_t("--page"):gh(n,t).colour,...e?{fill:()=>gh(n,t).colour,fillTo:0}:{},width:e?.5:1.6,points:{show:!1}}))}function Q2(n,e,t,i,s){let r=yh(),o=(a,l,c)=>nP(n,...e?Z2(e,t,i.span):[l,c]);return{width:s,height:_h,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...n.stacked?J2(n):Ap(n.lines)],axes:[{...r,...Ep,labelFont:r.font,label:()=>`${i.span.label} (${ua(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?eP(a,i):tP(c,u,h),values:(a,l)=>l.map(c=>c===null?"":_y(c*ua(i.span).factor)),space:56},Tp(n)],hooks:{drawClear:[a=>xh(a,yy(a,t,mh(n),i.span))],draw:[a=>xh(a,vy(a,t,mh(n),i.span))]}}}function eP(n,e){let t=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/$2)),{factor:i}=ua(e.span),s=new Set;for(let r=0;r<=t;r++){let o=e.momentAt(r/t),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(e.shareAt(c)-r/t)<.2/t;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=e.span.start&&r<=e.span.end)}function tP(n,e,t){let i=Math.ceil(n/t-1e-9);return Array.from({length:Math.floor(e/t+1e-9)-i+1},(s,r)=>(i+r)*t)}function Ap(n){return n.map(({look:e},t)=>({stroke:()=>Fi(e??t).colour,dash:Fi(e??t).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var Ep={size:24,gap:3,labelSize:18,labelGap:0};function yh(){return{stroke:()=>_t("--muted"),grid:{stroke:()=>_t("--grid"),width:1},ticks:{stroke:()=>_t("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function Tp(n){return{...yh(),size:(e,t)=>Math.max(48,16+7*Math.max(0,...(t??[]).map(i=>i.length))),gap:3,values:(e,t)=>t.map(i=>i===null?"":_y(i)),...n.unit==="deg"?{incrs:q2,space:26}:{space:30}}}function nP(n,e,t){let[i,s]=iP(e,t)?[e,t]:[Math.min(0,e??0),Math.max(0,t??0)],r=.06*(s-i||1);return[n.unit==="deg"||i!==0?i-r:i,s+2*r]}function iP(n,e){let t=Math.max(Math.abs(n),Math.abs(e));return n*e>0&&Math.min(Math.abs(n),Math.abs(e))>t/2&&e-n>X2*t}function _y(n){let e=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return e.length>7?Mt(n):e.replace("-","−")}function xh(n,e){let{ctx:t,bbox:i}=n;sl(t,e,devicePixelRatio,[i.left/devicePixelRatio,i.top/devicePixelRatio])}function yy(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].stages.filter(o=>o.driven).map(o=>{let[a,l]=[o.start,o.end].map(c=>Math.min(s,Math.max(0,n.valToPos(c-i.origins[t],"x"))));return{kind:"rect",x:a,y:0,width:l-a,height:r,fill:_t("--band")}})}function vy(n,e,t,i){if(t===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e[t].marks.flatMap(o=>{let a=n.valToPos(o.time-i.origins[t],"x");if(a<-1||a>s+1)return[];let l=a>s-16?-1:1;return[{kind:"path",points:[[a,0],[a,r]],stroke:_t("--muted"),dash:[2,3]},{kind:"rect",x:a+(l>0?2:-14),y:1,width:12,height:15,fill:_t("--page")},{kind:"text",x:a+l*8,y:13,text:o.letter,anchor:"middle",bold:!0,fill:_t("--ink")}]})}function sP(n,e){Cp(n,t=>{e.pause(),e.seek(n.posToVal(t.clientX-n.over.getBoundingClientRect().left,"x"))})}function Cp(n,e){n.over.addEventListener("pointerdown",t=>{t.button===0&&(n.over.setPointerCapture(t.pointerId),e(t))}),n.over.addEventListener("pointermove",t=>{n.over.hasPointerCapture(t.pointerId)&&e(t)})}function rP(n,e){return Array.from({length:e-n},(t,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function vh(n,e){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let t=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(t.disconnect(),e.play())},{threshold:.3});t.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>t.disconnect(),{once:!0})}function by(n){let e=n.clips.map(Kn),t=Bi(e,n.spans),i=ur(document.getElementById("player"),e,t,n);Rp(i.stage.cells,e,t,n.energy);let s=mr(document.getElementById("plots"),n.plots,e,t);return vh(document.getElementById("player"),t),{clips:e,clock:t,player:i,plots:s}}function Rp(n,e,t,i){let s=e.map((r,o)=>{let a=b("span",{className:"state-now"}),l=b("b",{},vr(Fi(o)),r.name);return sr(()=>l.replaceChild(vr(Fi(o)),l.firstChild)),n[o].append(l,a),a});t.onChange(()=>{for(let[r,o]of e.entries()){let a=t.clipTime(r),c=[t.time+t.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(oP(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(Is,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${Mt(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function oP(n,e){let t=s=>e==="deg"?`${kn(s,0)}°`:`${Mt(s)} ${e}`,i=[Math.min(...n),Math.max(...n)].map(t);return i[0]===i[1]?i[0]:i.join(" to ")}function Pp(n){return n.energy?Oo:C0}function Sy(n,e){let t=n.at(e).map(s=>Math.round(255*s)),i=.299*t[0]+.587*t[1]+.114*t[2]>118;return{face:`rgb(${t.join(" ")})`,ink:i?"#000":"#fff"}}function Jo({sign:n,pattern:e}){return b("span",{className:`what ${e}`,"aria-hidden":"true"},b("span",{},n))}function bh(n,e){let t=n.scaleOf(e);if(!t)return[];let i=b("span",{className:"bar","aria-hidden":"true"});return i.style.background=Pp(e).gradient,[b("p",{className:"scale"},`${e.title} (${e.unit})`,b("span",{className:"whole"},t.text(t.low),i,t.text(t.high)))]}function Sh(n,e){let{factors:t,quantities:i,words:s}=n,r=t.map(h=>h.values.length),o=new Map;for(let h of e)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return t.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(_=>_.group===h.group):[h]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!f.length)return null;let[p,x]=[f.reduce((_,w)=>Math.min(_,w)),f.reduce((_,w)=>Math.max(_,w))],m=_=>x>p?(_-p)/(x-p):.5,g=aP((h.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>Sy(Pp(h),m(_)),text:_=>as(Number(_.toFixed(g)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:t,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:e.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(t[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${as(f)} ${h.unit}`}}}function aP(n){let e=n.reduce((t,i)=>Math.max(t,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(e||1))))}function as(n){let e=Number(n.toPrecision(3));return(e!==0&&Math.abs(e)<.001?e.toExponential():String(e)).replaceAll("-","−")}var lP="http://www.w3.org/2000/svg";function Lt(n,e,...t){let i=document.createElementNS(lP,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}function Qo({values:n,log:e},t=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...t].filter(d=>typeof d=="number"),r=e&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?cP:wy)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function Ip(n,e,t,i,s=[]){let r=e.unit?`${e.name} (${e.unit})`:e.name,o=Qo({values:n,log:e.log},s),a=.04*(i-t),l=u=>t+a+o.share(u)*(i-t-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?as(u):u]);return{label:r,from:t,to:i,ticks:c,at:l,place:u=>n[u]===null?t+.75*a:l(n[u])}}function wy(n,e){if(!(e>n))return[n];let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5].find(o=>o*i>=t)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=e+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function cP(n,e){if(!(e>n))return[n];let t=e/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(e));s++)for(let r of t){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=e*(1+1e-9)&&i.push(o)}return i.length>1?i:wy(n,e)}function My(n,e,t){let i=[Lt("path",{class:"axis",d:`M${n.from} ${e.to}V${e.from}H${n.to}`})],s=(r,o)=>i.push(Lt("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:e.from+18,"text-anchor":"middle"});for(let[r,o]of e.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:t-8,"text-anchor":"middle"}),s(e.label,{transform:`translate(14 ${(e.from+e.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var wh=300,Ay=30,uP=92,Cy=16,hP=5;function Ry(n,e,{best:t,best_word:i,front:s},r){let a={axes:[...new Set(e.map(n.indexOf).filter(y=>y>=0))],opened:null,hovered:null,best:t,bestWord:i,front:s},l=b("div",{className:"titles"}),c=b("div",{className:"drawn"}),u=b("div",{className:"board"},l,c),h=b("div",{className:"scroll"},u),d=b("p",{className:"note",role:"status"}),f=b("p",{className:"note under"}," "),p=b("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let x=()=>{pP(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),Mh(n,a,c)},m="Press a line to open its run. Move the two handles of an axis to select a range of values.",g=fP(n,a),_=`All ${n.study.noun}s as lines`,w=ji(_,()=>qn(_),()=>cr([u,g],_,".handle")),S=b("div",{className:"head"},b("h2",{},_),w),A=b("section",{className:"lines"},S,b("p",{className:"note"},m),dP(n,a,x),h,g,b("div",{className:"choices"},p,d),f);yP(n,a,c,f,r),n.whenAsked(()=>{Mh(n,a,c),Py(n,a,c),Ey(n,d,p)}),Ey(n,d,p);let M=0;return new ResizeObserver(()=>{h.clientWidth!==M&&(M=h.clientWidth,x())}).observe(h),{element:A,show(y){a.opened=y,Mh(n,a,c)}}}function Ey(n,e,t){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;e.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,t.hidden=n.asked.size===0}function dP(n,e,t){let i=n.columns.map((s,r)=>{let o=b("input",{type:"checkbox",checked:e.axes.includes(r)});return o.addEventListener("change",()=>{e.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:e.axes.includes(a)),o.checked||n.ask(r,0,1),t()}),b("label",{},o,s.name)});return b("details",{},b("summary",{},"Axes"),b("fieldset",{className:"filter"},b("legend",{},"Show an axis of"),...i))}function fP(n,e){let t=(r,o)=>b("li",{},b("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(t("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(t("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),e.front.length&&s.push(t("front","Pareto front")),e.best!==null&&s.push(t("best",e.bestWord)),s.push(t("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(b("li",{},b("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),b("ul",{className:"keys-of-lines"},...s)}function pP(n,e,{board:t,titles:i,place:s,width:r}){let o=e.axes.length,a=Math.max(r,o*uP);t.style.width=`${a}px`,i.replaceChildren(...e.axes.map(c=>mP(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,e.x=c=>(c+.5)*a/o,e.y=c=>wh-Ay-c*(wh-2*Ay);let l=Lt("svg",{width:a,height:wh,viewBox:`0 0 ${a} ${wh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Lt("g",{class:"layers"}));for(let[c,u]of e.axes.entries())l.append(...gP(n.columns[u],e.x(c),e.y));s.replaceChildren(l),Py(n,e,s)}function mP(n){let e=n.unit?` (${n.unit})`:"",t=n.aim?b("small",{},`${n.aim} is best`):"";return b("div",{},`${n.name}${e}`,t)}function gP({scale:n,limits:e},t,i){let s=[Lt("path",{class:"axis",d:`M${t} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of e){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Lt("path",{class:"bound",d:`M${t} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Lt("path",{class:"axis",d:`M${t} ${o}h5`}),Lt("text",{class:"label",x:t+8,y:o,dy:"0.35em"},typeof r=="number"?as(r):r))}return s}function Py(n,e,t){let i=t.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of t.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of e.axes.entries())for(let o of["least","most"]){let a=xP(n,e,t,r,o);a.style.left=`${e.x(s)}px`,t.append(a),a.dataset.handle===i&&a.focus()}}function xP(n,e,t,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${as(c)} ${r.unit}`.trim():String(c??""),h=b("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${e.y(l)}px`;let d=x=>{let[m,g]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(x,0),g),g):n.ask(i,m,Math.max(Math.min(x,1),m))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",x=>{if(!(x.ctrlKey||x.metaKey||x.altKey)){if(x.key in p)d(l+p[x.key]);else if(x.key==="Home")d(0);else if(x.key==="End")d(1);else return;x.preventDefault()}}),h.addEventListener("pointerdown",x=>{x.preventDefault(),h.focus(),Iy(x,m=>d(Lp(e,t,m)))}),h}function Iy(n,e,t=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(e),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),t(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function Lp(n,e,t){let i=t.clientY-e.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function _P(n,e,t){let i="",s=!1;for(let[r,o]of e.axes.entries()){let a=n.columns[o].values[t];a!==null&&(i+=`${s?"L":"M"}${e.x(r).toFixed(1)} ${e.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function Mh(n,e,t){let i=t.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:e.front.filter(n.shown),best:a(e.best),opened:a(e.opened),hovered:a(e.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Lt("path",{class:`line ${u}`,d:h.map(d=>_P(n,e,d)).join("")})))}function yP(n,e,t,i,s){let r=o=>{o!==e.hovered&&(e.hovered=o,t.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,Mh(n,e,t))};t.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(Ty(n,e,t,o))}),t.addEventListener("pointerleave",()=>r(null)),t.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:vP(e,t,o),l=Lp(e,t,o),c=!1;Iy(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>hP;let d=Lp(e,t,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:Ty(n,e,t,h);d!==null&&s(d)})})}function vP(n,e,t){let i=t.clientX-e.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<Cy);return s<0?null:n.axes[s]}function Ty(n,e,t,i){let s=t.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=e.axes.findLastIndex((p,x)=>e.x(x)<=r),[l,c]=[Math.max(0,a),Math.min(e.axes.length-1,a+1)],u=c>l?(r-e.x(l))/(e.x(c)-e.x(l)):0,h=(p,x)=>{let m=n.columns[e.axes[p]],g=m.values[x];return g===null?NaN:e.y(m.scale.share(g))},[d,f]=[null,Cy];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[x,m]=[h(l,p),h(c,p)],g=x+u*(m-x),_=c>l?(m-x)/(e.x(c)-e.x(l)):0,w=Math.abs(o-g)/Math.hypot(1,_)-(n.good(p)?1:0);w<f&&([d,f]=[p,w])}return d}function Ly(n,e){let t=Sh(n,e),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=t.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Qo(c,bP(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...t,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>t.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function bP({limits:n,values:e}){let t=e.filter(r=>typeof r=="number"),[i,s]=[Math.min(...t),Math.max(...t)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var SP=12,[Np,Ds]=[200,76],gl=130;function ky(n,{marginals:e,pairs:t},i){let s=b("div",{className:"marginals"}),r=b("div",{className:"pairs"}),[o,a]=[e,t].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>AP(n,h))),r.replaceChildren(...EP(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[Ny("Single unknowns",s),b("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(Ny("Pairs of unknowns",r),b("p",{className:"note"},"Press a pair to enlarge it."),r),{element:b("section",{className:"agreeing"},...u)}}function Ny(n,e){let t=ji(n,()=>qn(n),()=>cr([e],n));return b("div",{className:"head"},b("h2",{},n),t)}var wP=n=>Array.from({length:n.study.points},(e,t)=>t),Oy=n=>wP(n).filter(e=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[e]).pattern));function MP(n,e,t){let i=e.words.length||SP,s=new Array(i).fill(0);for(let r of t)s[Math.min(i-1,Math.floor(e.share(n.values[r])*i))]+=1/t.length;return s}function AP(n,e){let t=n.columns[e],i=Qo(t),s=Oy(n),r=s.filter(m=>n.good(m)&&n.shown(m)),[o,a]=[s,r].map(m=>MP(t,i,m)),l=Math.max(...o,...r.length?a:[0]),c=Np/o.length,u=(m,g)=>Lt("path",{class:g,d:m.map((_,w)=>`M${w*c+1} ${Ds}v${-_/l*(Ds-4)}h${c-2}V${Ds}z`).join("")}),h=m=>Lt("path",{class:"agree",d:`M0 ${Ds}${m.map((g,_)=>`V${Ds-g/l*(Ds-4)}H${(_+1)*c}`).join("")}V${Ds}`}),d=`${t.name}: ${Dy(t,i,r)}`,f=Lt("svg",{viewBox:`0 0 ${Np} ${Ds}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Lt("path",{class:"axis",d:`M0 ${Ds}H${Np}`})),p=i.words.length?i.words:[0,1].map(m=>as(i.value(m))),x=t.unit?` (${t.unit})`:"";return b("figure",{},b("figcaption",{},`${t.name}${x}`),f,b("div",{className:"ends"},...p.map(m=>b("span",{},m))),b("small",{},Dy(t,i,r)))}function Dy(n,e,t){if(!t.length)return"no sample agrees";if(e.words.length)return e.words.map(r=>`${Math.round(100*t.filter(o=>n.values[o]===r).length/t.length)} % ${r}`).join(", ");let i=t.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>as(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function EP(n,e,t){return e.slice(1).flatMap((i,s)=>e.slice(0,-1).map((r,o)=>o>s?b("span",{}):TP(n,r,i,t)))}function TP(n,e,t,i){let[s,r]=[e,t].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Qo(f)),l=(f,p)=>Lt("path",{class:p,d:f.map(x=>`M${(4+o.share(s.values[x])*(gl-8)).toFixed(1)} ${(gl-4-a.share(r.values[x])*(gl-8)).toFixed(1)}h0`).join("")}),c=Oy(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Lt("svg",{viewBox:`0 0 ${gl} ${gl}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=b("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,b("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(e,t)),d}var[Uy,Dp]=[600,420],Ah={left:76,right:14,top:12,bottom:52},Fy=60,By={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function Eh(n,e,t){let{columns:i,study:s}=n,{quantity:r}=e,o=Array.from({length:s.points},(g,_)=>_),a=n.scaleOf(r),l=Ip(i[e.x].values,i[e.x],Ah.left,Uy-Ah.right,e.cells?.across),c=e.y===null?r.values??o.map(()=>0):i[e.y].values,u=e.y===null?{name:r.title,unit:r.unit}:i[e.y],h=Ip(c,u,Dp-Ah.bottom,Ah.top,e.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Lt("svg",{viewBox:`0 0 ${Uy} ${Dp}`,class:["scatter",o.length>Fy&&"many",e.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});e.cells&&f.append(...PP(e.cells,l,h)),kp(s,e)&&f.append(...IP(s.boundaries,e,l,h)),f.append(...My(l,h,Dp),...Vy(i[e.x],l,h,!0),...e.y===null?[]:Vy(i[e.y],h,l,!1));let p=o.map(g=>[l.place(g),h.place(g)]);e.joined&&f.append(LP(e.front,p,i[e.x].aim));let x=o.length>Fy?6:8,m=o.map(g=>RP(n,e,a,g,p[g],x));return f.append(...(e.ordered?CP(n,e,o):o).map(g=>m[g])),(m[e.current??0]??m[0])?.setAttribute("tabindex","0"),NP(f,m,e.ordered?[...o].sort((g,_)=>p[g][0]-p[_][0]):o,t),{element:b("div",{className:"scroll"},f),points:o}}function CP(n,e,t){let i=s=>(n.shown(s)?0:1e6)+(e.best===s?-1:n.study.verdicts[s]);return[...t].sort((s,r)=>i(r)-i(s))}function RP(n,e,t,i,[s,r],o){let{quantity:a}=e,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Lt("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(e.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Lt("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),e.front?.includes(i)&&u.append(Lt("circle",{r:o+3,class:"front"})),u.append(Lt("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":t.colour(l).face})),h&&u.append(Lt("text",{"text-anchor":"middle",dy:"0.36em"},h)),e.best===i&&u.append(Lt("text",{class:"best","text-anchor":"middle",dy:-o-6},e.bestWord)),u}function PP(n,e,t){let[i,s]=[zy(n.across.map(e.at)),zy(n.upwards.map(t.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Lt("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function kp({boundaries:n},{x:e,y:t}){return!!n&&[e,t].every(i=>[n.x,n.y].includes(i))}function IP({cells:n,lines:e,x:t,y:i},s,r,o){let a=(h,d)=>i===null?[r.at(h),o.from+d*(o.to-o.from)]:s.x===t?[r.at(h),o.at(d)]:[r.at(d),o.at(h)],l=(h,d)=>`M${h.map(([f,p])=>`${f.toFixed(1)} ${p.toFixed(1)}`).join("L")}${d}`,c=n.map(([h,d,f,p])=>l([a(h,d),a(f,d),a(f,p),a(h,p)],"Z")),u=e.map(([h,d,f,p])=>l([a(h,d),a(f,p)],""));return[Lt("path",{class:"cell-outline",d:c.join("")}),Lt("path",{class:"boundary",d:u.join("")})]}function zy(n){let e=n.slice(1).map((s,r)=>(s+n[r])/2),[t,i]=[n[0],n.at(-1)];return[t,...e,i]}function Vy(n,e,t,i){let s=(a,l)=>Lt("path",{class:l,d:i?`M${a} ${t.from}V${t.to}`:`M${t.from} ${a}H${t.to}`}),r=a=>a>=Math.min(e.from,e.to)&&a<=Math.max(e.from,e.to),o=[];typeof n.own=="number"&&r(e.at(n.own))&&o.push(s(e.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=e.at(l);if(!r(c))continue;let u=a===">="?e.from:e.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:t.to,height:t.from-t.to}:{y:h,height:d,x:t.from,width:t.to-t.from};o.push(Lt("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function LP(n,e,t){let i=n.map(r=>e[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>t==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Lt("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function NP(n,e,t,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of e)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in By)e[t[t.indexOf(a)+By[r.key]]]?.focus();else return;r.preventDefault()})}function Gy(n,{plane:e,front:t,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[e.x,e.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:t,best:i,bestWord:s,ordered:!0},f=b("div",{className:"map-place"}),p=b("div",{className:"map-legend"}),x=()=>{let C=d.x===u&&d.y===h;d.cells=C?e.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let N=Eh(n,d,m);f.replaceChildren(N.element),p.replaceChildren(...DP(n,d))},m=C=>{g(C),o(C)};function g(C){d.current=d.opened=C;let N=f.contains(document.activeElement);x(),N&&f.querySelector(`[data-point="${C}"]`)?.focus()}let _=n.columns.map((C,N)=>[N,C.name]),w={across:S("across",_,()=>d.x,C=>M("x","y",C)),upwards:S("upwards",_,()=>d.y,C=>M("y","x",C)),show:S("show",a.map((C,N)=>[N,C.title]),()=>a.indexOf(d.quantity),C=>{d.quantity=a[C]})};function S(C,N,F,D){let V=b("select",{},...N.map(([B,ne])=>b("option",{value:String(B)},ne)));V.value=String(F()),V.addEventListener("change",()=>{D(Number(V.value)),A(),x()});let $=b("label",{},`${C} `,V);return $.dataset.name=C,{element:$,fill:()=>{V.value=String(F())}}}let A=()=>Object.values(w).forEach(C=>C.fill());function M(C,N,F){d[N]===F&&(d[N]=d[C]),d[C]=F}let y=()=>[d.y,d.x].map(C=>n.columns[C].name).join(" over "),v=ji(e.title,()=>qn(y()),()=>cr([f,p],y())),T=b("div",{className:"head"},b("h2",{},e.title),v),P=b("section",{className:"map"},T,b("div",{className:"choices"},...Object.values(w).map(C=>C.element)),f,p);return n.whenAsked(x),x(),{element:P,show:g,over(C,N){[d.x,d.y]=[C,N],A(),x()}}}function DP(n,{quantity:e,front:t,cells:i,x:s,y:r}){let o=bh(n,e),a=e.values?e.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[b("li",{},Jo(u),`${u.word} (${d})`)]:[]});t.length&&l.push(b("li",{},b("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(b("li",{},b("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(b("li",{},b("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(b("li",{},b("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(b("ul",{},...l)),o}var kP=2e4,OP=16,UP=16,FP=12,Hy={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Xy(n,e){let{quantities:t,sampled:i}=n.study,s=n.study.axes.filter(_=>n.sizes[_]>1),[r,o]=s.length>1?s:BP(n.study.factors[s[0]])?[s[0],null]:[null,s[0]??0],a={quantity:t[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=b("div",{className:"map-place"}),c=b("div",{className:"map-legend"}),u=b("p",{className:"note"}),h=()=>{let _=a.y===null&&a.quantity.values&&n.sizes.every((S,A)=>S===1||A===a.x),w=i||_?Eh(n,a,d):GP(n,a,d);l.replaceChildren(w.element),c.replaceChildren(...$P(n,a.quantity,w.points),...kp(n.study,a)?[XP(n.study.boundaries)]:[]),u.textContent=qP(n,a.quantity,w.points)},d=_=>{a.current=a.opened=_,zP(l,_),e(_,a.quantity)},f=VP(n,a,s,h),x=ji("the map",()=>qn(a.quantity.title),()=>cr([l,c],Yy(n,a).split(";")[0])),m=b("div",{className:"head"},b("h2",{},"Map"),x),g=b("section",{className:"map"},m,f.element,l,c,u);return h(),{element:g,show(_){a.current=a.opened=_,i||(a.fixed=n.placesOf(_)),f.fill(),h()}}}function BP(n){return n?.values.some(e=>typeof e=="string"&&e.length>FP)??!1}function zP(n,e){for(let t of n.querySelectorAll("[data-point]")){let i=Number(t.dataset.point)===e;t.setAttribute("aria-selected",String(i)),t.tabIndex=i?0:-1}}function VP(n,e,t,i){let{factors:s,quantities:r,sampled:o}=n.study,a=b("div",{className:"choices"}),l=(h,d,f,p)=>{let x=b("select",{},...d.map(([m,g])=>b("option",{value:String(m)},g)));return x.value=String(f),x.addEventListener("change",()=>{p(Number(x.value)),u(),i(),[...a.querySelectorAll("label")].find(m=>m.dataset.name===h)?.querySelector("select").focus()}),b("label",{},`${h} `,x)},c=(h,d)=>f=>{e[d]===f&&(e[d]=e[h]),e[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(e.quantity),d=>{e.quantity=r[d]})];if(t.length>2){let d=t.map(f=>[f,s[f].name]);h.push(l("across",d,e.x,c("x","y")),l("upwards",d,e.y,c("y","x")))}for(let d of t.filter(f=>!o&&f!==e.x&&f!==e.y)){let f=s[d].texts.map((p,x)=>[x,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,e.fixed[d],p=>{e.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function GP(n,e,t){let{factors:i}=n.study,[s,r]=[e.x,e.y].map(g=>g===null?1:n.sizes[g]),o=e.x===null;if(s*r>kP)return{element:b("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let a=n.scaleOf(e.quantity),l=s<=OP,c=(g,_)=>n.pointAt(e.fixed.map((w,S)=>S===e.x?g:S===e.y?_:w)),u=new Map,h=[],d=[];for(let g=0;g<r;g++){let _=o?g:r-1-g,w=e.y===null?"":o?i[e.y].texts[_]:$y(i[e.y],_),S=b("tr",{},b("th",{scope:"row"},w));for(let A=0;A<s;A++){let M=c(A,_),y=b("td",{tabIndex:-1,role:"gridcell"});HP(y,n,e,a,M,l),u.set(`${A} ${_}`,y),d.push(M),S.append(y)}h.push(S)}if(!o){let g=i[e.x].texts.map((_,w)=>b("th",{scope:"col"},$y(i[e.x],w)));h.push(b("tr",{className:"feet"},b("td"),...g))}let f=b("table",{role:"grid",className:o?"grid list":l?"grid":"grid small","aria-label":Yy(n,e)},b("tbody",{},...h));f.style.setProperty("--columns",s),f.style.setProperty("--rows",r);let p=[...u.values()].find(g=>Number(g.dataset.point)===e.current)??u.get("0 0");p.tabIndex=0,WP(f,u,t,o);let x=b("div",{className:"upwards"},e.y===null||o?"":Wy(i[e.y])),m=b("div",{className:"across"},o?"":Wy(i[e.x]));return{element:b("div",{className:r<6?"axes low":"axes"},x,b("div",{},b("div",{className:"scroll"},f),m)),points:d}}function HP(n,e,t,i,s,r){let{quantity:o}=t,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(t.opened===s));let l=`${e.pointText(s)}: ${o.values?`${o.title} `:""}${e.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=e.word(o.reasons[s]);n.className=`what ${d}`,n.append(b("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function WP(n,e,t,i){let s=new Map([...e].map(([r,o])=>[o,r.split(" ").map(Number)]));n.addEventListener("click",r=>{let o=r.target.closest("[data-point]");o&&t(Number(o.dataset.point))}),n.addEventListener("keydown",r=>{let o=r.target.closest("[data-point]");if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let[a,l]=s.get(o),[c,u]=Hy[r.key]??[0,0],h=i?-u:u,d=Math.max(...[...s.values()].map(([p])=>p)),f={Home:`0 ${l}`,End:`${d} ${l}`}[r.key]??`${a+c} ${l+h}`;if(r.key==="Enter"||r.key===" ")t(Number(o.dataset.point));else{if(!(r.key in Hy)&&r.key!=="Home"&&r.key!=="End")return;e.has(f)&&(o.tabIndex=-1,e.get(f).tabIndex=0,e.get(f).focus())}r.preventDefault()})}function $P(n,e,t){let i=bh(n,e),s=[...qy(e,t)].map(([r,o])=>{let a=n.word(r);return b("li",{},Jo(a),`${a.word} (${o})`)});return s.length&&i.push(b("ul",{},...s)),i}function XP({text:n}){let e=(t,i)=>b("li",{},b("span",{className:`line ${t}`,"aria-hidden":"true"}),i);return b("ul",{},e("boundary",`${n}, a straight line in each cell`),e("cell-outline","side of a cell"))}function qy(n,e){let t=new Map;for(let i of e){let s=n.reasons[i];s!==null&&t.set(s,(t.get(s)??0)+1)}return new Map([...t].sort(([i],[s])=>i-s))}function qP(n,e,t){let i=t.filter(u=>(e.values?.[u]??null)!==null),s=[...qy(e,t)].map(([u,h])=>`${h} ${n.word(u).word}`),r=`${e.title[0].toUpperCase()}${e.title.slice(1)}`,o=`${n.study.noun}s`;if(!i.length)return`${r} of ${t.length} ${o}: ${s.join(", ")||"none"}.`;let a=s.length?` Other ${o}: ${s.join(", ")}.`:"",[l,c]=[Math.min,Math.max].map(u=>YP(n,e,i,u));return`${r}, known for ${i.length} of ${t.length} ${o}: from ${l} to ${c}.${a}`}function YP(n,e,t,i){let s=t.map(a=>e.values[a]).reduce((a,l)=>i(a,l)),r=t.filter(a=>e.values[a]===s),o=r.length>1?`${r.length} ${n.study.noun}s`:n.pointText(r[0]);return`${n.valueText(e,r[0])} (${o})`}function Yy(n,e){let{factors:t}=n.study,i=e.y===null||e.x===null?t[e.x??e.y].name:`${t[e.x].name} across and ${t[e.y].name} upwards`;return`${e.quantity.title} over ${i}; arrows move between cells, enter opens one`}function Wy(n){return n.unit?`${n.name} (${n.unit})`:n.name}function $y(n,e){let t=Math.ceil(n.texts.length/UP);return e%t?"":n.texts[e]}var Zy=2,ZP=20;function Jy(n){let e=document.getElementById("live")?.textContent??null,t=e&&JSON.parse(e),i=b("div",{className:"answer"}),s=b("p",{className:"outcome",role:"status"}),r=b("div"),o=b("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(_,w){if(h+=1,c=_,!t)return[];if(!Ru())return w?[]:[b("p",{className:"note"},`It cannot be simulated here either: ${t.refused}.`)];if(a)x(_);else if(!l){let S=b("button",{type:"button",className:"try"},w?"Try it and refine here":"Simulate it here"),A=b("p",{className:"note"});S.addEventListener("click",()=>f(S,A)),o.replaceChildren(b("div",{className:"offer"},S,A))}return[o]}async function f(_,w){l=_.disabled=!0,w.textContent="Starting the simulator …";try{a=await Vo(Kn(t.bench.clips[0]),t.bench,e,Uo),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),x(c)}catch(S){w.textContent=`It cannot be simulated here: ${S.message}.`}}async function p(_,w){if(await u.catch(()=>null),w!==h)return null;u=a.engine.ask({act:"answer",values:_,search:t.search});let{answer:S}=await u;return w===h?S:null}async function x(_){let w=++h,S=b("button",{type:"button"},"Refine here");S.addEventListener("click",()=>g(_)),r.replaceChildren(),i.replaceChildren(s,...Qy(n,t).length?[S]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(t.points[_]);let A=await p(t.points[_],w);A&&(s.textContent=`${Nt(n.pointText(_))}: ${Ky(t,A)}.`,m(_))}function m(_){a.sliders.set(t.points[_]),a.engine.send({act:"restart",through:!1})}async function g(_){let w=++h,S=KP(n,t,_),A=new Map,M=b("p",{className:"note",role:"status"}),y=S[1].values.map(N=>S[0].values.map(F=>jP(S,F,N))).reverse(),v=y.map((N,F)=>b("tr",{},b("th",{scope:"row"},jy(S[1],S[1].values.length-1-F)),...N.map(({cell:D})=>D))),T=b("tr",{className:"feet"},b("td"),...S[0].values.map((N,F)=>b("th",{scope:"col"},jy(S[0],F)))),P=b("table",{className:"grid"},b("caption",{},QP(S,n.study.sampled)),b("tbody",{},...v,T));r.replaceChildren(b("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},P),M);let C=y.flat();for(let[N,{cell:F,values:D,where:V}]of C.entries()){M.textContent=`${N} of ${C.length} points simulated`;let $=await p({...t.points[_],...D},w);if(!$)return;let{sign:B,pattern:ne}=n.study.words.find(({word:Y})=>Y===$.word)??n.study.other;F.className=`what ${ne}`,F.replaceChildren(b("span",{},B)),F.title=`${V}: ${Ky(t,$)}`,F.setAttribute("aria-label",F.title),A.set($.word,B)}M.textContent=[...A].map(([N,F])=>`${F} ${N}`).join(" · "),m(_)}return{offer:d,get panel(){return a}}}function jP(n,e,t){let i={[n[0].key]:e};n[1].key&&(i[n[1].key]=t);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Mt(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:b("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function Qy(n,e){let t=i=>e.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&t(i))}function KP(n,e,t){let i=Qy(n,e),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=e.knobs.find(m=>m.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:JP(e.points.map(m=>m[l]),t)};let h=n.placesOf(t),d=m=>e.points[n.pointAt(h.map((g,_)=>_===a?m:g))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],x=[];for(let m=f;m<p;m++)for(let g=0;g<Zy;g++)x.push(d(m)+g/Zy*(d(m+1)-d(m)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[...x,d(p)]}};return[o(r),o(s)]}function JP(n,e){let[t,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[e]+r*(i-t)/ZP);return[...new Set(s.map(r=>Math.min(i,Math.max(t,r))))].sort((r,o)=>r-o)}var jy=({key:n,factor:e,unit:t,values:i},s)=>n?`${Mt(e*i[s])} ${t}`:"";function QP([n,e],t){return`${e.key?`${Nt(n.name)} across, ${e.name} upwards`:Nt(n.name)}, ${t?"around it":"at half the steps"}`}function Ky(n,{status:e,least:t}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>t[r]!==null&&t[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${Mt(l*t[o])} ${c}`});return[e,...s].join("; ")}function Th(n){let e=b("h2"),t=b("p",{className:"outcome",role:"status"}),i=b("table",{className:"numbers"}),s=b("section",{className:"facts",id:"point"},e,t,b("div",{className:"table"},i)),r=b("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=b("div"),a=b("div",{className:"more"}),l=b("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=b("section",{className:"run below","aria-label":"plots and numbers of the run that is open"}),u=Jy(n),h={facts:s,element:l,below:c,point:null,playing:null,answers:u,open:p,show:g},d=null,f=ar();function p(w,{play:S=!1,transition:A=null}={}){h.point=w;let M=n.runsOf(w);e.textContent=Nt(`${n.study.noun} ${w+1}`),t.textContent=`${Nt(n.pointText(w))}: ${n.study.statuses[w]}.`,i.replaceChildren(b("caption",{},n.study.numbers??"Values in the table"),b("tbody",{},...sI(n,w))),r.replaceChildren(...M.length>1?M.map(x):M.map(T=>b("b",{},Nt(T.title))));let y=A===null?null:M.find(T=>T.transition===A),v=S?M.find(T=>T.failed):null;M.length?g(y??v??M[0],{play:S}):(m(),o.replaceChildren(b("p",{className:"note"},rI(n,w))),c.replaceChildren()),a.replaceChildren(...n.study.built[w]?u.offer(w,M.length>0):[])}function x(w){let S=b("button",{type:"button"},w.title);return S.dataset.part=w.part,S.addEventListener("click",()=>g(w,{play:!0})),S}function m(){h.playing?.dispose(),h.playing=null}function g(w,{play:S=!1}={}){m();for(let C of r.querySelectorAll("button"))C.setAttribute("aria-pressed",String(C.dataset.part===w.part));let A=d&&d!==w?d:null,M=A?[A,w]:[w],y={player:b("div"),plots:b("div"),readouts:M.map(()=>b("div"))},[v,T]=[oI,aI].map(C=>M.map((N,F)=>C(N,ev(M,n)[F]))),P=w.advice?[b("p",{className:"note"},w.advice)]:[];o.replaceChildren(b("p",{},w.text),_(w),...P,y.player),c.replaceChildren(y.plots,...y.readouts,...v,...T),f.scale=n.largestSpan/w.play.clips[0].span_m,h.playing={run:w,beside:A,...eI(y,w,A,n,f)},zo(c),S&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&h.playing.clock.play()}function _(w){let A=b("button",{type:"button",className:"pin"},d?`unpin ${n.study.noun} ${d.point+1}`:"pin to compare with another");return A.addEventListener("click",()=>{d=d?null:w,g(w),o.querySelector(".pin").focus()}),A}return h}function eI(n,e,t,i,s){let r=t?[t,e]:[e],o=r.map((f,p)=>nI(f,ev(r,i)[p],i)),a=r.map((f,p)=>({...Kn(f.play.clips[0]),...t?{name:o[p]}:{}})),l=Bi(a,t?[iI(a)]:e.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=t?`${Nt(a[0].name)} and ${a[1].name}, side by side with a common clock.`:e.play.text,h=ur(n.player,a,l,{...e.play,energy:c,text:u},s);t&&Rp(h.stage.cells,a,l,c);let d=mr(n.plots,t?tI(r,a):e.play.plots,a,l);n.plots.classList.toggle("paired",t!==null);for(let[f,p]of a.entries())hr(n.readouts[f],p,l,c,f,t!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function tI(n,e){let t=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:e[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(t.flat().map(s=>s.title))].flatMap(s=>t.flat().filter(r=>r.title===s))}function ev(n,{study:e}){if(n.length===1)return[""];let t=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${e.noun} ${i.point+1}${t?`, ${i.title}`:""}`)}function nI(n,e,t){let{factors:i}=t.study,s=t.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${e}: ${s.join(", ")}`}function iI(n){let e=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[t,i]=[Math.min(...n.map((s,r)=>s.start-e[r])),Math.max(...n.map((s,r)=>s.end-e[r]))];return{name:"whole runs",label:"time since the first drive acts",start:t,end:i,origins:e,whole:!0}}function sI(n,e){return n.numbers.map(t=>b("tr",{},b("th",{scope:"row"},t.title),b("td",{},n.valueText(t,e))))}function rI(n,e){return n.study.built[e]?`${n.study.unkept??"This run was not kept, so it cannot be played here."} ${n.study.keeps}`:n.study.unbuilt}function oI(n,e){let t=b("div");return t.innerHTML=n.numbers,b("details",{},b("summary",{},`States of ${e||"this run"}`),t)}function aI(n,e){let t=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return b("details",{},b("summary",{},e?`Commands for ${e}`:"Commands"),b("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),b("pre",{},b("code",{},t.join(`
`))))}function Ch(n,e,t,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=b("p",{className:"note",role:"status"}),a=lI(e,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(e.study.verdicts[d])||!e.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${e.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=b("button",{type:"button","aria-label":`open ${e.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=e.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");uI(s,r,cI(e));let c=b("div",{className:"choices"},a.element,...t?[dI(t,e.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function lI(n,e){let t=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=b("input",{type:"checkbox",checked:!0});return a.addEventListener("change",e),t.set(o,a),[b("label",{},a,Jo(r),`${r.word} (${r.count})`)]});return{element:b("fieldset",{className:"filter"},b("legend",{},`Show ${n.study.noun}s that`),...i),changed:e,shown:()=>new Set([...t].filter(([,r])=>r.checked).map(([r])=>r))}}function cI(n){let{study:e}=n,t=e.statuses.map((r,o)=>o),i=e.factors.map((r,o)=>t.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[t,...i,e.statuses,...s]}function uI(n,e,t){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=b("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=e.map((c,u)=>u).sort((c,u)=>hI(t[s][c],t[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>e[c]))})}i[0].setAttribute("aria-sort","ascending")}function hI(n,e,t){if(n===null||e===null)return(n===null)-(e===null);let i=typeof n=="number"?n-e:String(n).localeCompare(String(e),"en");return t*i}function dI(n,e){let t=b("button",{type:"button",className:"button"},`Download ${e}`);return t.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));b("a",{href:i,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),t}function tv(n){let e=Sh(n.study,n.runs),t=Th(e),i=(a,l=null)=>{t.open(a,{play:!0,transition:l}),Op(t)},s=Xy(e,(a,l)=>i(a,l.transition)),r=n.runs.length?[[s.element,t.facts],[t.element]]:[[s.element],[t.facts,t.element]];document.getElementById("explorer").replaceChildren(b("div",{className:"explorer"},...r.map(a=>b("div",{},...a)),t.below)),Ch(document.getElementById("points"),e,n.csv,a=>{s.show(a),i(a)});let o=fI(e,n.runs);return t.open(o),s.show(o),{model:e,map:s,panel:t,open:i}}function fI(n,e){let t=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...t.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return e.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function Op({facts:n,element:e}){let{top:t}=e.getBoundingClientRect();if(t>=0&&t<.5*innerHeight)return;let i=n.getBoundingClientRect().left===e.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:e).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function nv(n){let{views:e}=n,t=Ly(n.study,n.runs),i=Th(t),s=[],r=(m,g)=>{i.open(m,{play:g});for(let _ of s)_.show?.(m)},o=m=>{r(m,!0),Op(i)},a=Ry(t,e.lines,e,o),l=t.columns.filter(m=>m.aim).length===2,c=Gy(t,{...e,joined:l},o),u=e.pairs?.length?ky(t,e,h):null;s.push(a,c);function h(m,g){c.over(m,g),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=b("div",{className:"explorer"},...d.map(m=>b("div",{},...m)),i.below),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...e.order.map(m=>p[m]));let x=Ch(document.getElementById("points"),t,n.csv,o);return t.whenAsked(x),n.study.points&&r(pI(t,n),!1),{model:t,panel:i,lines:a,plane:c,open:o}}function pI(n,{runs:e,views:t,study:i}){let{best:s}=t,r=e.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function iv(n){let e=new Blob([Kt(n,Uint8Array)]).stream(),t=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(t,r,c);if(s==="f8")return new Float64Array(t,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(t,r,c),h=mI(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function mI(n,e,t){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<t;o++){s[0]=0;for(let a=0;a<e;a++)s[0]+=n[o*e+a],r[a*t+o]=s[0]}return r}var gI="M7 4.5v15l12-7.5z",xI="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",gr=180/Math.PI,Rh=1,sv=10,rv=720;function lv(n,e,t,i){let[s,r]=[n.lowest,n.highest].map(p=>p*gr),o=bI(n),a=vI(n,s,r,o),l=b("button",{type:"button",className:"play"}),c=b("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=b("p",{className:"time"}),h=p=>{e.pause(),e.seek(i(Math.min(r,Math.max(s,p))/gr))},d=()=>e.playing?e.pause():e.play(),f=a.map(({angle:p,name:x})=>{let m=b("button",{type:"button"},b("b",{},ov(p)),` ${x}`);return m.addEventListener("click",()=>h(p)),m});return c.addEventListener("input",()=>h(Number(c.value))),yI(c,()=>t(e.time)*gr,h,d),l.addEventListener("click",d),e.onChange(()=>{let p=t(e.time)*gr;c.value=p,u.textContent=`${ov(p,1)}${av(n,p)}`,c.setAttribute("aria-valuetext",`${kn(p,1)} degrees${av(n,p)}`);for(let[m,g]of a.entries())f[m].setAttribute("aria-pressed",String(Math.abs(g.angle-p)<.005));let x=e.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(Tl(e.playing?xI:gI)),l.setAttribute("aria-label",x)}),b("div",{className:"transport"},b("div",{className:"line"},l,_I(c,s,r,o,a)),b("div",{className:"choices"},u,b("div",{className:"states"},...f)))}function _I(n,e,t,i,s){let r=b("div",{className:"bands","aria-hidden":"true"}),o=b("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(t-e)}%`;for(let[l,c]of i){let u=b("span",{className:"band"});Object.assign(u.style,{left:a(l-e),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=b("span",{className:c?"tick stop":"tick"});u.style.left=a(l-e),o.append(u)}return b("div",{className:"track"},r,n,o)}function yI(n,e,t,i){let s={ArrowLeft:-Rh,ArrowDown:-Rh,ArrowRight:Rh,ArrowUp:Rh},r={PageDown:-sv,PageUp:sv,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)t(Math.round(e()+s[o.key]));else if(o.key in r)t(e()+r[o.key]);else return;o.preventDefault()}})}var ov=(n,e=null)=>`${e===null?kn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):kn(n,e)}°`;function vI(n,e,t,i){if(n.folds){let a=[{angle:e,name:"flat",stop:!0},{angle:t,name:"folded",stop:!0}];return t>e?a:a.slice(0,1)}let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*gr).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...e<0&&t>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:t>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-e)<1e-6||Math.abs(a-t)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function bI(n){let e=a=>cv(n,a).every(({longer:l})=>l<0),[t,i]=[n.lowest*gr,n.highest*gr],s=(a,l)=>{let c=e(a);for(let u=0;u<40;u++){let h=(a+l)/2;e(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=e(t)?null:t;for(let a=1;a<=rv;a++){let[l,c]=[a-1,a].map(u=>t+(i-t)*u/rv);e(l)!==e(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function cv(n,e){let t=n.turn(n.anglesTogether(e/gr));return n.straps.flatMap(i=>n.strapStretches(i,t).map(s=>({longer:s,rest:i.rest})))}function av(n,e){let t=cv(n,e);if(!t.length)return"";let i=t.filter(({longer:a})=>a<0).length,s=Math.max(...t.map(({longer:a})=>a));if(i===t.length)return`, straps slack by ${kn(-1e3*s,1)} mm or more`;let r=Math.max(...t.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${kn(1e3*s,1)} mm (${kn(100*r,1)} %)`;return i?`, ${i} of ${t.length} straps slack, others ${o}`:`, straps ${o}`}function uv(n){let e=b("input",{type:"range",min:0,max:100,step:1,value:0});return e.dataset.keys="own",e.addEventListener("input",()=>n(Number(e.value)/100)),e.setAttribute("aria-valuetext","together"),e.addEventListener("input",()=>{e.setAttribute("aria-valuetext",e.value==="0"?"together":`${e.value} % apart`)}),b("label",{className:"slide"},"take apart ",e)}function hv(n,e,t){let i=n.map((s,r)=>{let o=b("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>t(r,o.checked));let a=b("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,b("label",{},o,a,`${s.name}${e[r]>1?`, ${e[r]}`:""}`)});return b("fieldset",{className:"kinds"},b("legend",{},"show"),...i)}function Up(n,e,t){let i=b("select",{},...e.map((s,r)=>b("option",{value:String(r)},s)));return i.addEventListener("change",()=>t(Number(i.value))),b("label",{},`${n} `,i)}var Ph=28,dv=24;function fv(n,e){return n.ends.map(t=>{let[i,s]=t.map((r,o)=>new H(...r).applyMatrix4(ea(e,n.bodies[o])));return i.distanceTo(s)-n.rest})}var SI=new dt,ea=(n,e)=>e<0?SI:n[e];function Fp(n,e,t,i,s){let r=new H(...n.axis).transformDirection(ea(e,n.bodies[0])),o=new H(...n.up).transformDirection(ea(e,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,w)=>new H(..._).applyMatrix4(ea(e,n.bodies[w])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new H().crossVectors(r,o),f=new H().crossVectors(r,d).multiplyScalar(t),x=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,m=wI(s,x>1e-9?h/x:1);return{points:m.map(([_,w],S)=>l[0].clone().addScaledVector(d,_*x).addScaledVector(f,w*x).addScaledVector(r,u*S/(m.length-1))),wide:r,ends:l}})}function wI({values:n,shape:e},t){let[i,s]=e,r=Math.sqrt(Math.max(0,1-t))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?t/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function pv(n,e,t){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of e){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});gv(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new H(...n.across[c]).transformDirection(ea(t,n.bodies[c]));AI(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function Bp(n,e,t){let i=n.places.map(x=>new H(...x).add(t)),[s,r,o,a]=i,l=ea(e,n.body),[c,u]=[o,a].map(x=>x.clone().sub(t).applyMatrix4(l).add(t)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let x=0;x<=dv;x++)p.push(MI(r,h,c,d,f,x/dv));return[...p,u]}function MI(n,e,t,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(t,a*a*(1+2*o)).addScaledVector(e,s*o*o*a).addScaledVector(i,-s*a*a*o)}function mv(n,e){let t={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new H(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new H().crossVectors(l,s);return Array.from({length:Ph},(u,h)=>{let d=2*Math.PI*h/Ph;return o.clone().addScaledVector(s,Math.cos(d)*e/2).addScaledVector(c,Math.sin(d)*e/2)})});return gv(t,r,[]),t}function gv({triangles:n,edges:e},t,i){let s=t[0].length;for(let r=1;r<t.length;r++){let[o,a]=[t[r-1],t[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&e.push(o[l],a[l])}}for(let r of[t[0],t.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function AI({triangles:n,edges:e},t,i,s,r,o){let a=new H(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new H().crossVectors(i,a),c=(u,h,d)=>t.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<Ph;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/Ph),f=(p,x,m,g)=>n.push(p,x,m,p,m,g);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),e.push(c(h,r,p),c(d,r,p))}}function xv(n,e){let t=e.map(({origin:a,axis:l})=>[new H(...a),new H(...l)]),i=n.map((a,l)=>e.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new dt),r=new dt,o=new H;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=t[d];r.makeRotationAxis(p,l[d]-e[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var EI=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(e=>[-1,0,1].map(t=>[n,e,t]))),TI=new dt;function _v(n,e){let t=n.parts.map(x=>({...x,...x.mesh?CI(x.mesh,e):{}})),i={values:e(n.bows),shape:n.bows.shape},s=xv(n.bodies,n.turns),r=Math.min(...n.joints.map(x=>x.lower)),o=Math.max(...n.joints.map(x=>x.upper)),a=new Float64Array(n.turns.length),l=n.fold&&e(n.fold);function c(x){if(l)return u(x);for(let[m,g]of n.turns.entries())a[m]=g.built;for(let m of n.joints)a[m.turn]=Math.min(m.upper,Math.max(m.lower,x));return a}function u(x){let[m,g]=n.fold.shape,_=o>0?x/o*(m-1):0,w=Math.min(Math.floor(_),Math.max(m-2,0)),S=Math.min(w+1,m-1);for(let A=0;A<g;A++){let M=l[w*g+A];a[A]=M+(_-w)*(l[S*g+A]-M)}return a}let h=(x,m)=>new H(...x.apart).multiplyScalar(m);function d(x,m,g,_=new dt){let w=h(x,g);return _.copy(x.body===null||x.body<0?TI:m[x.body]).multiply(new dt().makeTranslation(w.x,w.y,w.z))}function f(x,m,{apart:g,side:_}){let w=h(x,g);return x.root?mv(Bp(x.root,m,w),x.root.diameter):pv(x.strap,Fp(x.strap,m,_,w,i),m)}function p(x,m,{apart:g,side:_}){let w=[];for(let S of x){if(S.outer){let y=d(S,m,g);for(let v of S.outer)w.push(...v.clone().applyMatrix4(y).toArray());continue}let A=h(S,g),M=S.root?[Bp(S.root,m,A)]:Fp(S.strap,m,_,A,i).map(y=>y.points);for(let y of M)for(let v=0;v<y.length;v+=4)w.push(...y[v].toArray())}return Float64Array.from(w)}return{parts:t,looks:n.looks,joints:n.joints,folds:!!l,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:c,matrixOf:d,bentMesh:f,outline:p,straps:t.filter(x=>x.strap).map(x=>x.strap),strapStretches:fv}}function CI({points:n,triangles:e,stops:t,edges:i},s){let r=s(n),o=s(e),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:t,edges:s(i),outer:RI(r)}}function RI(n){let e=new Set;for(let[t,i,s]of EI){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=t*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}e.add(r)}return Array.from(e,t=>new H().fromArray(n,t))}function yv(n,e){let t=e(n.time),i=e(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Dr(t,a),u=Math.min(l+1,t.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:t,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var PI="#14171a",II=.55,LI=Math.cos(Math.PI/9),NI=.42;function vv(n,e,t,i){let s=n.parts.map(f=>DI(f,n.looks[f.look].colour,i)),r=new Ln;for(let f of s)r.add(f.mesh,f.lines);let o=new Ln,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(t(f));for(let[p,x]of n.parts.entries()){let{mesh:m,lines:g}=s[p],_=!e.hidden.has(x.look);for(let w of[m,g])w.visible=_;_&&(x.places?n.matrixOf(x,a,e.apart,m.matrix):UI(s[p],n.bentMesh(x,a,e)))}}function c(){let f=new je(_t("--accent"));for(let[p,{mesh:x}]of s.entries())for(let m of[x.material].flat())m.emissive.copy(f),m.emissiveIntensity=e.chosen===p?NI:0}function u(f,p){let x=new Tr;x.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:g}of s)g.geometry.boundingSphere===null&&g.geometry.computeBoundingSphere();let[m]=x.intersectObjects(s.map(g=>g.mesh).filter(g=>g.visible),!1);return m?s.findIndex(g=>g.mesh===m.object):null}function h(f){let p=n.parts.findIndex(_=>_.name===f),{mesh:x}=s[p],m=x.geometry.getAttribute("position"),g=new un(m.array.slice(),3);return Array.from(g.applyMatrix4(x.matrix).array)}function d(){for(let{mesh:f,lines:p}of s)f.geometry.dispose(),p.geometry.dispose()}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function DI(n,e,t){let i=(u,h)=>new Ts({color:u,side:zn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?kI(n):new bn,r=n.places?[i(t,!1),i(e,!1)]:i(e,!0),o=new _n(s,r),a=new bn;n.places&&a.setAttribute("position",new un(bv(n.places,n.edges),3));let l=new js({color:PI,transparent:!0,opacity:II}),c=new Ar(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function kI({places:n,corners:e,stops:t}){let i=new bn;return i.setAttribute("position",new un(bv(n,e),3)),i.setAttribute("normal",new un(OI(n,e),3)),i.addGroup(0,3*t,0),i.addGroup(3*t,e.length-3*t,1),i}function bv(n,e){let t=new Float32Array(3*e.length);for(let[i,s]of e.entries())for(let r=0;r<3;r++)t[3*i+r]=n[3*s+r];return t}function OI(n,e){let t=e.length/3,i=new Float64Array(e.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<t;l++){let[c,u,h]=[0,1,2].map(f=>3*e[3*l+f]),d=(f,p,x)=>n[p+x%3]-n[f+x%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[e[3*l+f]].push(l)}let r=Float64Array.from({length:t},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*e.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<e.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[e[l]])if(d===c||a(c,d)>=LI*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function UI({mesh:n,lines:e},{triangles:t,edges:i}){for(let[s,r]of[[n,t],[e,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new un(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var FI=.25,Sv=60,BI=4;async function wv(n){let e=await iv(n.arrays),t=_v(n,e),i={apart:0,side:1,hidden:new Set,chosen:null},s=[zI(t,i),...n.motion?[VI(t,i,yv(n.motion,e))]:[]],r=GI(s),o=document.getElementById("player"),a=WI(o,n,t,i,r),l=jI(t,n,i,a);return a.onPress(l.choose),{model:t,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function zI(n,e){let[t,i]=n.folds?[n.lowest,n.highest]:[n.highest,n.lowest],s=h=>t+h*(i-t),r=h=>(h-t)/(i-t||1),o=Float64Array.from({length:Sv+1},(h,d)=>d/Sv),a=h=>n.anglesTogether(s(h)),l=Mv(n,e,{time:o,anglesAt:a,marks:[],stages:[]}),c=Bi([Av(n,l,a)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);c.setSpeed(FI);let u=lv(n,c,s,r);return{name:n.folds?"along the fold path":"all joints together",clip:l,clock:c,anglesAt:a,control:u}}function VI(n,e,t){let i=Mv(n,e,t),s=Bi([Av(n,i,t.anglesAt)],t.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:t.anglesAt,control:Gu([i],s)}}function Mv(n,e,{time:t,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!e.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:t,start:t[0],end:t[t.length-1],marks:s,stages:r,readings:[],along:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),e),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function Av(n,e,t){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...e,pointsAt:s=>n.outline(i,n.turn(t(s)),{apart:0,side:1})}}function GI(n){let e=n[0],t={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===e)for(let l of i)l()});let s=()=>e.clock.redraw(),r={get time(){return e.clock.time},get playing(){return e.clock.playing},get span(){return t.of!==e.clock.span&&(t={...e.clock.span,of:e.clock.span}),t},clipTime:(a,l)=>e.clock.clipTime(a,l),timeAt:a=>e.clock.timeAt(a),wayAt:a=>e.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>e.clock.seek(a),seekClip:(a,l)=>e.clock.seekClip(a,l),step:a=>e.clock.step(a),play:()=>e.clock.play(),pause:()=>e.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>e.clip.pointsAt(a)},clock:r,sources:n,get now(){return e},anglesAt:a=>e.anglesAt(a),take(a){e.clock.pause(),e=n[a],t={of:null},s()},changed(){t={of:null},s()}}}var Ev="Press a part, or its name in the table, for details.",HI="parts";function WI(n,e,t,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=ol([r],o,()=>l=vv(t,i,s.anglesAt,e.stopColour),e.text),h=Wu(u.eye,null);h.prepend(Bu(u,o,()=>({text:"",longest:0}),()=>[]));let d=b("div",{className:"picture"},u.element,...u.note?[u.note]:[],h),f=b("p",{className:"chosen",role:"status"},Ev),p=b("div",{},a[0].control);return n.replaceChildren(d,f,p,$I(t,i,s,p),XI(t,i,s),qI(e,t,u),Lu([r],HI)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),Nu(n,[r],o,u.eye,kr[0]),{stage:u,shape:l,info:f,repaint:()=>{l.paint(),o.seek(o.time)},onPress:x=>ZI(u,m=>x(l.at(m,u.eye.camera)))}}function $I(n,e,t,i){let s=l=>{Object.assign(e,l),t.changed()},r=t.sources.map(l=>l.name),o=Up("motion",r,l=>{t.take(l),i.replaceChildren(t.now.control)}),a=Up("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return b("div",{className:"choices"},...r.length>1?[o]:[],uv(l=>s({apart:l})),...n.straps.length?[a]:[])}function XI(n,e,t){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return hv(n.looks,i,(s,r)=>{r?e.hidden.delete(s):e.hidden.add(s),t.changed()})}function qI(n,e,t){let i=b("span",{className:"swatch taut","aria-hidden":"true"});return b("ul",{className:"legend"},...e.parts.some(s=>s.stops)?[YI(n.stopColour,"face of a stop")]:[],...e.straps.length?[b("li",{},i,"on the slider: range of taut straps")]:[],b("li",{},`squares of the grid: ${Mt(1e3*il(t.eye.size))} mm`))}function YI(n,e){let t=b("span",{className:"swatch panel","aria-hidden":"true"});return t.style.background=n,b("li",{},t,e)}function ZI({canvas:n,listen:e},t){let i=null;e("pointerdown",s=>{i=s.isPrimary?[s.clientX,s.clientY]:null}),e("pointerup",s=>{if(i===null||Math.hypot(s.clientX-i[0],s.clientY-i[1])>BI)return;let r=n.getBoundingClientRect(),[o,a]=[(s.clientX-r.left)/r.width,(s.clientY-r.top)/r.height];t(new Je(2*o-1,1-2*a))})}function jI(n,e,t,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=b("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(t.chosen===c?null:c)),h});function o(l){t.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?Ev:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}var KI=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],JI=1.35;function zp(n,e,t=[],i=null){let s=e.map(r=>QI(r,t[0],i));n.replaceChildren(...s.map(r=>r.element)),n.classList.add("plots");for(let r of s)r.start();return s}function QI(n,e,t){let[i,s,r]=[n.lines,n.balls,n.marks].map(y=>y.map(e3)),{element:o,head:a,key:l,place:c}=wp(n),u=(s.length?s:[i[0]]).map(y=>b("span",{className:"ball"},s.length&&y.name.length<3?y.name:"")),h=s.map(y=>[y.places[0],y.values[0]]),d=Math.round(JI*_h),f=t3(i),p=f,x=null,m=[];function g(){let y=i.map((T,P)=>b("li",{},vr(Fi(P)),T.name)),v=s.length?`the ${n.along} now`:"moved by the slider";l.replaceChildren(...y,b("li",{},b("span",{className:"ball still"}),v))}function _(){for(let[y,[v,T]]of h.entries()){let[P,C]=[x.valToPos(v,"x"),x.valToPos(T,"y")];u[y].style.transform=`translate(${P.toFixed(2)}px, ${C.toFixed(2)}px)`}}function w(){let y=t.clipTime(0);for(let[v,{places:T,values:P}]of s.entries())h[v]=[T,P].map(C=>or(e.time,C,y));_()}function S(y){p=y,x.setScale("x",{min:y[0],max:y[1]})}function A(y,v,T){if(p!==f){let{places:N,values:F}=i[0],D=F.filter((B,ne)=>N[ne]>=p[0]&&N[ne]<=p[1]),[V,$]=[Math.min(...D),Math.max(...D)];return[V-.25*($-V),$+.25*($-V)]}let P=s.reduce((N,F)=>Math.max(N,F.most),T),C=Math.min(0,v);return[C-.06*(P-C||1),P+.1*(P-C||1)]}function M(){let y=hn.join(i.map(P=>[P.sorted.places,P.sorted.values]));x=new hn(n3({data:n,lines:i,balls:s,marks:r,energyRange:A},c.clientWidth,d),y,c),x.over.append(...u);let v=new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:d}));v.observe(c),x.hooks.setSize=[_],x.hooks.setScale=[_],g();let T=sr(()=>{g(),x.redraw(!1)});a.append(Mp(n,()=>x,{under:()=>[],over:()=>[...Tv(x,n.along==="run"?s:[]),...Cv(x,r)]})),m=[T,()=>v.disconnect(),()=>x.destroy()],n.top&&c.after(i3(f,n.top,S)),s.length?(t.onChange(w),s3(x,s,e,t)):r3(n,i[0],c,(P,C)=>{h[0]=[P,C],_()}),S(f)}return{element:o,start:M,dispose:()=>m.forEach(y=>y()),now:h,get chart(){return x}}}function e3({name:n,places:e,values:t}){let i={name:n,places:Kt(e,Float32Array),values:Kt(t,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function t3(n){let e=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[t,i]=[Math.min(...e),Math.max(...e)];return[t-.03*(i-t),i+.03*(i-t)]}function n3({data:n,lines:e,balls:t,marks:i,energyRange:s},r,o){let a=yh(),l=Tp(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...Ap(e)],axes:[{...a,...Ep,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:KI,space:44},l],hooks:{draw:[c=>xh(c,[...Tv(c,n.along==="run"?t:[]),...Cv(c,i)])]}}}function Tv(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return e.flatMap(({places:r,values:o})=>Array.from(r,(a,l)=>[n.valToPos(a,"x"),n.valToPos(o[l],"y")])).filter(([r,o])=>r>0&&r<t&&o>0&&o<i).map(([r,o])=>({kind:"rect",x:r-.8,y:o-.8,width:1.6,height:1.6,fill:_t("--accent"),opacity:.55}))}function Cv(n,e){let[t,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],s=e.flatMap(({name:r,places:o,values:a})=>{let l=Array.from(o,(f,p)=>[n.valToPos(f,"x"),n.valToPos(a[p],"y")]),[c,u]=l[l.length>>1],h=l.length===1?{kind:"circle",x:c,y:u,r:4.5,fill:_t("--page"),stroke:_t("--ink"),lineWidth:1.4}:{kind:"path",points:l,stroke:_t("--line-2"),lineWidth:7,opacity:.35},d=l.length>1?0:c>t/2?-1:1;return[h,{kind:"text",x:c+12*d,y:u-9,text:r,anchor:["end","middle","start"][d+1],fill:_t("--ink")}]});return[{kind:"clip",x:-6,y:0,width:t+12,height:i+6,shapes:s}]}function i3(n,e,t){let i=[["whole curve",n],["barrier enlarged",e]].map(([s,r],o)=>{let a=b("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));t(r)}),a});return b("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function s3(n,e,t,i){Cp(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of e)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,t.time[c])})}function r3(n,e,t,i){let s=e.places.length-1,r=b("input",{type:"range",min:"0",max:String(s),value:"0"});r.setAttribute("aria-label",`${n.axis} along the curve`);let o=b("output",{"aria-live":"off"}),a=()=>{let l=Number(r.value);i(e.places[l],e.values[l]);let[c,u]=[Mt(e.places[l]),`${Mt(e.values[l])} ${n.unit}`];o.textContent=`${c}°, ${u}`,r.setAttribute("aria-valuetext",`${n.axis} ${c} degrees, energy ${u}`)};r.addEventListener("input",a),t.after(b("div",{className:"slide"},r,o)),a()}function Ih(n,e,t){let i=e.map(({name:l,title:c})=>{let u=b("button",{type:"button",title:`${l}: ${c}`},l);return u.addEventListener("click",()=>t(l)),u}),s=l=>{for(let c of i)c.setAttribute("aria-pressed",String(c.textContent===l))},r=e.map(({name:l,title:c})=>`${l}: ${c}`).join(" · "),o=`how the ${n} moves`;return{element:b("div",{className:"colours modes",role:"group","aria-label":o},b("span",{},...i),b("small",{},r)),mark:s}}function Vp(n){let e=(n.paths??[]).map(c=>({...c,clips:c.clips.map(u=>({...n.clips?.[0],...u}))})),i=[...n.clips?[{...n,name:"motion",title:"in time, as simulated"}]:[],...e].map(o3),s={views:i};if(!i.length)return{...s,curves:zp(document.getElementById("curves"),n.curves)};let r=document.getElementById("player"),o=null,a;s.choose=c=>{o?.leave(),o=c,a=c.show(a)??a,Object.assign(s,c),l.mark(c.name)};let l=Ih(n.whole,i,c=>s.choose(i.find(u=>u.name===c)));if(i.length>1&&r.before(l.element),s.choose(i[0]),n.clips){vh(r,s.clock);let c=i.find(h=>h!==i[0]),u=c&&(()=>{s.choose(c),r.scrollIntoView({block:"start"}),r.querySelector("input[type=range]").focus({preventScroll:!0})});s.trial=Zu(document.getElementById("try"),i[0].clips[0],n,()=>s.clock.pause(),u)}return s}function o3(n){let{name:e,title:t}=n,i=n.clips.map(Kn),s={name:e,title:t,clips:i,clock:null},r=[];return s.show=o=>{let a=u=>document.getElementById(u),l=Bi(i,n.spans);return s.clock&&l.seek(s.clock.time),s.clock=l,s.player=ur(a("player"),i,l,n,o,!1),s.curves=n.curves?zp(a("curves"),n.curves,i,l):[],s.plots=mr(a("plots"),n.plots,i,l),n.notes&&a("player").append(...n.notes.map(u=>b("p",{className:"note"},u))),r=[hr(a("readout"),i[0],l,n.energy),()=>s.player.dispose(),()=>s.plots.dispose(),()=>s.curves.forEach(u=>u.dispose())],s.player.stage?.eye.look},s.leave=()=>r.forEach(o=>o()),s}var Pv={"Content-Type":"application/json"},Rv=19e6;async function Qn(n,e,t){let i=JSON.stringify(e);if(i.length>Rv)return{refused:`need files of at most ${Rv/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:Pv,body:i,signal:t})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:Gp}}}async function Lh(n,e,t,i){let s="",r={};try{let a=(await fetch(n,{method:"POST",headers:Pv,body:JSON.stringify(e),signal:t})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),i(r)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:Gp}}return r.done||r.refused?r:{refused:Gp}}var Gp="the workbench does not answer; is forficula open still running?";var Hp=`forficula ${location.pathname}`;function Lv(n){let e={asked:null,base:null,reply:null,rejected:new Map};e.open=async(r,o,a=!0)=>{let l=r.files[0]?.name||r.design||"the design",c={...r,settings:o};n.says.wait(`Opening ${l}`);let u=n.picture(c,a),h=await Qn("design",{...r,settings:{}}),d=h.refused??await t(c,h,u);return d?(n.says.refuse(`${l} is not opened: ${d}`),n.resume()):e.rejected.clear(),e.reply&&s(e.reply),d};async function t(r,o,a=null){let l=performance.now(),c=new AbortController,u=()=>{Object.assign(e,{asked:r,base:o}),s(h)};n.says.wait("Building",()=>c.abort());let h=o;try{if(Object.keys(r.settings).length&&(h=await Qn("design",r,c.signal)),h.refused)return h.refused;let d=await a3(a??n.picture(r,!1),c.signal);if(d.refused)return d.refused;d.shown&&(u(),n.says.wait("Building"));let f=await Qn("model",r,d.shown?void 0:c.signal);if(f.refused&&!d.shown)return f.refused;d.shown||u(),await n.model(f.refused?{live:f,warnings:[]}:f),n.says.done(`Built in ${((performance.now()-l)/1e3).toFixed(1)} s.`)}catch(d){if(d.name!=="AbortError")throw d;return"building was stopped"}return""}e.change=async(r,o)=>{let{asked:a,rejected:l}=e,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=Iv(f,a.settings)?"":await t({...a,settings:f},e.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`),n.resume()):Iv(u,a.settings)&&n.says.done(""),s(e.reply)},e.slide=async r=>{let o=i(e.asked.settings,Object.entries(r)),a=await Qn("design",{...e.asked,settings:o});return a.refused?n.says.refuse(a.refused):(e.asked={...e.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===e.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){e.reply=r,l3(e.asked),n.reply(e)}return e}function a3(n,e){let t=new Promise((i,s)=>e.addEventListener("abort",()=>s(e.reason)));return Promise.race([n,t])}var Iv=(n,e)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(e).sort());function Nv(){return JSON.parse(sessionStorage.getItem(Hp)??"null")}function l3(n){try{sessionStorage.setItem(Hp,JSON.stringify(n))}catch{sessionStorage.removeItem(Hp)}}function Dv(n){let e=b("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),t=b("button",{type:"button"},"Build this text"),s=b("div",{},b("label",{htmlFor:"file-text"},"The design file"),b("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),e,b("p",{className:"choices"},t));t.addEventListener("click",()=>n(e.value));let r="";return{element:s,show(o){o.text!==r&&(e.value=r=o.text)}}}function Nh(n,e){let t="";for(let i of new TextEncoder().encode(n))t+=String.fromCharCode(i);return`data:${e};base64,${btoa(t)}`}var Wp=40,c3=0;function kv(n,e){let t=`key-${++c3}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=u3(n,t),r=b("button",{type:"button",className:"home",hidden:!0},"undo"),o=b("p",{className:"wrong",id:`${t}-wrong`}),a="",l=b("p",{className:"note",id:`${t}-notes`}),c=b("div",{className:"field"},b("label",{htmlFor:t,title:n.key},i),b("span",{className:"entry"},s,...h3(n,t),r),o,l);s.setAttribute("aria-describedby",`${t}-wrong ${t}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),e(a)}),r.addEventListener("click",()=>{e(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let x=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",x!==null),r.hidden=x===null;let m=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",_=[d.allowed,x===null?m:`was ${x}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(Nt(d.meaning),b("span",{className:"may"},_))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function u3({key:n,value:e,words:t,onlyWords:i,default:s},r){if(i){let l=e?[]:[b("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return b("select",{id:r,"data-key":n},...l,...t.map(c=>b("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(e.length>Wp)return b("textarea",{...o,rows:Math.min(6,Math.ceil(e.length/Wp))});let a=b("input",{...o,type:"text"});return t.length&&a.setAttribute("list",`${r}-words`),a}function h3({words:n,onlyWords:e,value:t},i){return e||!n.length||t.length>Wp?[]:[b("datalist",{id:`${i}-words`},...n.map(s=>b("option",{value:s})))]}var d3=["pattern","tendon"];function Ov(n){let e=b("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),t=b("p",{className:"note",role:"status"}),i=b("div",{className:"sections"}),s=b("section",{className:"keys-of-design","aria-label":"keys of the design"},b("h2",{},"Keys"),b("label",{className:"find",htmlFor:"find-key"},"Find a key",e),t,i),r=new Map,o=[];e.addEventListener("input",a);function a(){let h=e.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let x=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(m=>x.includes(m)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:x}of f.parts)p.hidden=x.every(m=>m.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}t.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(x=>[x.key,x]));f3(h.keys,r)||c(h);for(let x of h.keys)r.get(x.key).show(x,d[x.key],p.get(x.key));for(let x of o)x.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:x})=>x.open).map(({name:x})=>x):d3),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(x=>[x.key,kv(x,m=>n(x.key,m))])),o=[...new Set(h.keys.map(({key:x})=>x.includes(".")?x.split(".")[0]:""))].sort((x,m)=>(m===""?-1:0)-(x===""?-1:0)).map(x=>p3(x,h,r));for(let x of o)x.element.open=d.has(x.name);i.replaceChildren(...o.map(x=>x.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let x of o)x.fields.includes(p)&&(x.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function f3(n,e){let t=[...e.keys()],i=(s,r)=>s.key===r&&s.onlyWords===e.get(r).fact.onlyWords;return n.length===t.length&&n.every((s,r)=>i(s,t[r]))}function p3(n,e,t){let i=e.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>t.get(d)),r=b("summary"),o=e.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=e.keys.find(m=>m.key===`${n}.${f}.name`)?.value,x=b("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:x,fields:[]}),l.push(x)}a.at(-1)?.fields.push(t.get(d)),l.push(t.get(d).element)}let c=o?[b("p",{className:"note"},`${Nt(o).replace(/\.$/,"")}.`)]:[],u=b("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?Nt(n):"Name",...f?[b("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}var m3="http://www.w3.org/2000/svg",g3=Math.PI/180;function xl(n,e,...t){let i=document.createElementNS(m3,n);for(let[s,r]of Object.entries(e))i.setAttribute(s,r);return i.append(...t),i}var _l=({kawasaki:n,maekawa:e})=>n===null||n>g3||(e??0)!==0,$p=n=>_l(n)?"failing":n.maekawa===null?"unknown":"holding",Xp=({kawasaki:n})=>n===null?"odd":`${(n*180/Math.PI).toFixed(n>.17?0:2)}°`;function Uv(){let n=b("img",{alt:"the picture that is traced"}),[e,t,i,s,r]=Array.from({length:5},()=>xl("g",{})),o=xl("svg",{class:"trace-drawing",tabindex:"0",role:"application"},e,t,i,s,r),a=b("div",{className:"trace-sheet"},n,o),c={element:b("div",{className:"trace-stage"},a),drawing:o,image:n,width:1,height:1,zoom:1};return Object.defineProperty(c,"unit",{get:()=>c.width/(o.getBoundingClientRect().width||c.width)}),c.size=(u,h)=>{Object.assign(c,{width:u,height:h,zoom:1}),o.setAttribute("viewBox",`-0.5 -0.5 ${u} ${h}`),a.style.aspectRatio=`${u} / ${h}`,a.style.width="100%"},c.magnify=u=>{c.zoom=Math.min(Math.max(c.zoom*u,1),16),a.style.width=`${100*c.zoom}%`},c.pointOf=({clientX:u,clientY:h})=>{let d=o.getBoundingClientRect();return[(u-d.left)/d.width*c.width-.5,(h-d.top)/d.height*c.height-.5]},c.show=u=>{let{unit:h}=c,{pattern:d,selected:f,conditions:p,doubts:x}=u,m=([v,T],[P,C],N)=>xl("line",{x1:v,y1:T,x2:P,y2:C,class:N}),g=([v,T],P,C)=>xl("circle",{cx:v,cy:T,r:P*h,class:C}),_=([v,T],P,C)=>xl("text",{x:v+8*h,y:T-8*h,"font-size":13*h,class:C},P);e.replaceChildren(...x.lines.map(([v,T])=>m(v,T,"doubtful")),...x.places.map(v=>g(v,9,"doubtful"))),t.replaceChildren(...d.edges.flatMap(([v,T],P)=>{let C=[d.vertices[v],d.vertices[T]],N=f.edge===P?" chosen":"";return[m(...C,`ground${N}`),m(...C,`crease crease-${d.letters[P]}`)]}));let w=new Map(p.map(v=>[v.vertex,$p(v)]));i.replaceChildren(...u.points.map(v=>g(v,2.5,"junction")),...d.vertices.map((v,T)=>g(v,4.5,`vertex ${w.get(T)??""}${f.vertex===T?" chosen":""}`))),s.replaceChildren(...p.filter(_l).map(v=>{let T=v.maekawa?`, |M−V| = ${v.maekawa+2}`:"";return _(d.vertices[v.vertex],`${Xp(v)}${T}`,"condition")}));let{cursor:S,pen:A,aim:M,clicks:y}=u;r.replaceChildren(...y.length>1?y.map((v,T)=>m(v,y[(T+1)%y.length],"measured")):[],...y.map((v,T)=>g(v,6,`click${f.click===T?" chosen":""}`)),...A&&M?[m(A,M.point,"pen")]:[],...A?[g(A,6,"pen")]:[],...M?.what?[g(M.point,9,"aim")]:[],...S?x3(S,14*h,m):[])},c}var x3=([n,e],t,i)=>[i([n-t,e],[n+t,e],"cursor"),i([n,e-t],[n,e+t],"cursor")];var _3=["vertex","creases","alternating sum of sectors (Kawasaki)","|mountains − valleys| (Maekawa)","within 1° and exactly 2"],y3={failing:"no",holding:"yes",unknown:"not known"};function Fv(n){let e=b("summary"),t=b("tbody"),i=b("thead",{},b("tr",{},..._3.map(l=>b("th",{scope:"col"},l)))),s=b("div",{className:"table",tabIndex:0,role:"group","aria-label":"conditions of flat folding"},b("table",{},i,t)),r=b("details",{className:"trace-conditions",open:!0},e,s),o=[];function a(l,c){if(o[0]===l&&o[1]===c)return;o=[l,c];let u=l.filter(_l).length,h=c?"":" Angles are those in the picture until the scale is set.",d=`${l.length} ${l.length===1?"vertex":"vertices"} inside the sheet`;e.textContent=`Flat folding: ${l.length?`${u} of ${d} fail${u===1?"s":""}.`:"no vertices inside the sheet yet."}${h}`,s.hidden=!l.length,t.replaceChildren(...l.map(f=>{let{vertex:p,creases:x,maekawa:m}=f,g=b("button",{type:"button",title:"select this vertex"},String(p));g.addEventListener("click",()=>n(p));let _=f.kawasaki===null,w=x?m===null?"unassigned edges":m+2:"no creases",S=[g,x,_?"never flat: odd number":Xp(f),w,y3[$p(f)]];return b("tr",_l(f)?{className:"failing"}:{},...S.map(A=>b("td",{},typeof A=="number"?String(A):A)))}))}return{element:r,show:a}}var Gr=(n,e)=>Math.hypot(e[0]-n[0],e[1]-n[1]);function ta(n,[e,t]){if(!n)return[e,-t];let[i,s,r]=n.map(([o,a,l])=>o*e+a*t+l);return[i/r,s/r]}function v3([[n,e,t],[i,s,r],[o,a,l]]){let c=n*(s*l-r*a)-e*(i*l-r*o)+t*(i*a-s*o);return[[s*l-r*a,t*a-e*l,e*r-t*s],[r*o-i*l,n*l-t*o,t*i-n*r],[i*a-s*o,e*o-n*a,n*s-e*i]].map(u=>u.map(h=>h/c))}function yl(n,e,t){let i=[e[0]-n[0],e[1]-n[1]],s=i[0]**2+i[1]**2,r=s?((t[0]-n[0])*i[0]+(t[1]-n[1])*i[1])/s:0,o=Dh(n,e,Math.min(Math.max(r,0),1));return{share:r,near:o,distance:Gr(o,t)}}var Dh=(n,e,t)=>[n[0]+t*(e[0]-n[0]),n[1]+t*(e[1]-n[1])];function Bv([n,e],[t,i]){let[s,r]=[[e[0]-n[0],e[1]-n[1]],[i[0]-t[0],i[1]-t[1]]],o=s[0]*r[1]-s[1]*r[0];if(Math.abs(o)<1e-9*Math.hypot(...s)*Math.hypot(...r))return null;let a=[t[0]-n[0],t[1]-n[1]],l=(a[0]*r[1]-a[1]*r[0])/o,c=(a[0]*s[1]-a[1]*s[0])/o;return l>0&&l<1&&c>0&&c<1?[l,c]:null}function qp(n){let e=[0,1].map(o=>n.reduce((a,l)=>a+l[o],0)/n.length),t=([o,a])=>Math.atan2(a-e[1],o-e[0]),i=[...n].sort((o,a)=>t(o)-t(a)),s=i.map(([o,a])=>o+a),r=s.indexOf(Math.min(...s));return[...i.slice(r),...i.slice(0,r)]}function zv(n,e){let t=n?v3(n):[[1,0,0],[0,-1,0],[0,0,1]];return i=>ta(t,e(ta(n,i)))}function Vv([n,e],[t,i]){let s=(t-n)**2+(i-e)**2,[r,o]=[((t-n)**2-(i-e)**2)/s,2*(t-n)*(i-e)/s];return a=>[n+r*(a[0]-n)+o*(a[1]-e),e+o*(a[0]-n)-r*(a[1]-e)]}function Gv([n,e],t){let[i,s]=[Math.cos(t),Math.sin(t)];return r=>[n+i*(r[0]-n)-s*(r[1]-e),e+s*(r[0]-n)+i*(r[1]-e)]}var Hv={vertices:[],edges:[],letters:[]},Hr={M:"mountain",V:"valley",F:"flat",B:"border",C:"cut",U:"unassigned"},kh=({vertices:n,edges:e,letters:t})=>({vertices:[...n],edges:[...e],letters:[...t]}),Wv=([n,e],t,i)=>n===t&&e===i||n===i&&e===t;function ks({vertices:n},e,t){let i=-1;for(let[s,r]of n.entries())Gr(r,e)<=(i<0?t:Gr(n[i],e))&&(i=s);return i}function Oh({vertices:n,edges:e},t,i){let s={number:-1,distance:i};for(let[r,[o,a]]of e.entries()){let l=yl(n[o],n[a],t);l.distance<=s.distance&&(s={number:r,distance:l.distance})}return s.number}function Yp(n,e,t,i){let s=ks(n,t,i);if(s>=0)return{point:n.vertices[s],what:"vertex"};let r=ks({vertices:e},t,i);if(r>=0)return{point:e[r],what:"junction"};let o=Oh(n,t,i/2);if(o<0)return{point:t,what:""};let[a,l]=n.edges[o];return{point:yl(n.vertices[a],n.vertices[l],t).near,what:"crease"}}function vl(n,e,t){let i=ks(n,e,t);if(i>=0)return[n,i];let s=Oh(n,e,t),r=kh(n);r.vertices.push(e);let o=r.vertices.length-1;return s>=0&&$v(r,s,o),[r,o]}function $v(n,e,t){let[i,s]=n.edges[e];n.edges[e]=[i,t],n.edges.push([t,s]),n.letters.push(n.letters[e])}function Zp(n,e,t,i,s){if(e===t)return n;let r=kh(n),o=[r.vertices[e],r.vertices[t]];for(let[c,[u,h]]of[...r.edges.entries()]){if([u,h].some(f=>yl(...o,r.vertices[f]).distance<=s))continue;let d=Bv(o,[r.vertices[u],r.vertices[h]]);!d||ks(r,Dh(...o,d[0]),s)>=0||(r.vertices.push(Dh(...o,d[0])),$v(r,c,r.vertices.length-1))}let a=[...r.vertices.entries()].filter(([c])=>c!==e&&c!==t).map(([c,u])=>({number:c,...yl(...o,u)})).filter(({number:c,share:u,distance:h})=>h<=s&&u>0&&u<1&&Xv(r,c)).sort((c,u)=>c.share-u.share),l=[e,...a.map(({number:c})=>c),t];for(let[c,u]of l.slice(1).entries()){let h=l[c],d=r.edges.findIndex(f=>Wv(f,h,u));d>=0?r.letters[d]=i:(r.edges.push([h,u]),r.letters.push(i))}return r}var Xv=({edges:n},e)=>n.some(t=>t.includes(e));function qv(n,e,t,i){let s={vertices:n.vertices.map((l,c)=>c===e?[1/0,1/0]:l)},r=ks(s,t,i),o=kh(n);if(o.vertices[e]=r<0?t:n.vertices[r],r<0)return o;o.edges=o.edges.map(l=>l.map(c=>c===e?r:c));let a=o.edges.map((l,c)=>l[0]!==l[1]&&o.edges.findIndex(u=>Wv(u,...l))===c);return bl(jp(o,a),[e])}var jp=({vertices:n,edges:e,letters:t},i)=>({vertices:n,edges:e.filter((s,r)=>i[r]),letters:t.filter((s,r)=>i[r])});function bl(n,e){let t=new Set(e),i=jp(n,n.edges.map(o=>!o.some(a=>t.has(a)))),s=[],r=0;for(let o of i.vertices.keys())s.push(t.has(o)?-1:r++);return{vertices:i.vertices.filter((o,a)=>!t.has(a)),edges:i.edges.map(o=>o.map(a=>s[a])),letters:i.letters}}function Yv(n,e){let t=n.edges[e],i=jp(n,n.edges.map((s,r)=>r!==e));return bl(i,t.filter(s=>!Xv(i,s)))}function Zv(n,e,t){let i=kh(n);return i.letters[e]=t,i}function jv(n,e,t){let i=n;for(let s of e)for(let[r,[o,a]]of n.edges.entries()){let l,c;[i,l]=vl(i,s(n.vertices[o]),t),[i,c]=vl(i,s(n.vertices[a]),t),i=Zp(i,l,c,n.letters[r],t)}return i}function Kp({vertices:n,edges:e,letters:t},i){let s=n.map(a=>ta(i,a)),r=n.map(()=>[]);for(let[a,[l,c]]of e.entries())r[l].push({to:s[c],letter:t[a]}),r[c].push({to:s[l],letter:t[a]});let o=[];for(let[a,l]of r.entries()){if(!l.length||l.some(({letter:x})=>x==="B"||x==="C"))continue;let c=l.filter(({letter:x})=>x!=="F"),[u,h]=s[a],d=c.map(({to:x})=>Math.atan2(x[1]-h,x[0]-u)).sort((x,m)=>x-m),f=d.map((x,m)=>(d[m+1]??d[0]+2*Math.PI)-x),p=x=>c.filter(m=>m.letter===x).length;o.push({vertex:a,creases:c.length,kawasaki:c.length%2?null:Math.abs(f.reduce((x,m,g)=>x+(g%2?-m:m),0)),maekawa:p("U")?null:c.length?Math.abs(p("M")-p("V"))-2:0})}return o}function Kv(n){let e={pattern:Hv,before:[],after:[]},t=i=>n(e.pattern=i);return Object.assign(e,{put(i){i!==e.pattern&&(e.before.push(e.pattern),e.after=[],t(i))},undo(){e.before.length&&(e.after.push(e.pattern),t(e.before.pop()))},redo(){e.after.length&&(e.before.push(e.pattern),t(e.after.pop()))},clear(){[e.before,e.after]=[[],[]],t(Hv)}})}var Jv={mouse:9,touch:22,pen:12,keys:9},b3=5,S3=12,Sl=1e-6,_i={vertex:-1,edge:-1,click:-1};function Qv(n,e,t,{show:i,say:s,clicked:r}){let{drawing:o}=n,a=null,l=v=>(Jv[v]??Jv.mouse)*n.unit,c=(v,T)=>Yp(t.pattern,e.points,v,T),u=([v,T])=>[Math.min(Math.max(v,0),n.width-1),Math.min(Math.max(T,0),n.height-1)];function h(v,T){let P=ks(t.pattern,v,T);e.selected={..._i,vertex:P,edge:P<0?Oh(t.pattern,v,T):-1},s(d())}function d(){let{vertex:v,edge:T}=e.selected;return v>=0?`Vertex ${v} is selected.`:T>=0?`Edge ${T} is selected: ${Hr[t.pattern.letters[T]]}.`:""}function f(v,T){let P=t.pattern,[C,N]=[-1,-1];v&&([P,C]=vl(P,v,Sl)),[P,N]=vl(P,T,Sl),v&&C!==N&&(P=Zp(P,C,N,e.letter,n.unit)),t.put(P),e.selected={..._i,vertex:N},s(v?`A ${Hr[e.letter]} edge to vertex ${N} is drawn.`:`Vertex ${N} is drawn.`)}function p(v,T){let P=ks({vertices:e.clicks},v,T);P<0&&e.clicks.length===e.most&&(e.clicks=[]),P<0&&(e.clicks=[...e.clicks,v]),e.selected={..._i,click:P<0?e.clicks.length-1:P},s(`Point ${e.selected.click+1} of ${e.most}.`)}o.addEventListener("pointerdown",v=>{if(a||v.pointerType==="mouse"&&v.button!==0)return;o.setPointerCapture?.(v.pointerId),o.focus({preventScroll:!0});let T=l(v.pointerType),P=n.pointOf(v);e.cursor=null,a={id:v.pointerId,at:P,reach:T,dragging:!1,was:t.pattern},e.tool==="draw"&&([e.pen,e.aim]=[null,c(u(P),T)]),e.tool==="move"&&h(P,T),e.tool==="scale"&&p(c(u(P),T).point,T),a.start=e.aim?.point??P,i()}),o.addEventListener("pointermove",v=>{let T=u(n.pointOf(v)),P=l(v.pointerType);if(!a)return e.aim=e.tool==="move"||e.cursor?null:c(T,P),i();if(v.pointerId===a.id&&(a.dragging||=Gr(T,a.at)>b3*n.unit,!!a.dragging)){if(e.tool==="draw"&&([e.pen,e.aim]=[a.start,c(T,P)]),e.tool==="move"&&e.selected.vertex>=0){let{vertex:C}=e.selected;e.aim=Yp(bl(t.pattern,[C]),e.points,T,P),e.preview={...t.pattern,vertices:t.pattern.vertices.with(C,e.aim.point)}}return e.tool==="scale"&&(e.clicks=e.clicks.with(e.selected.click,c(T,P).point)),i()}}),o.addEventListener("pointerup",v=>{if(v.pointerId!==a?.id)return;let{dragging:T,start:P}=a;a=null,e.tool==="draw"&&e.aim&&f(T?P:null,e.aim.point),e.tool==="move"&&T&&e.selected.vertex>=0&&x(e.selected.vertex,e.aim.point),e.tool==="scale"&&r(),Object.assign(e,{pen:null,aim:null,preview:null}),i()}),o.addEventListener("pointercancel",()=>{a=null,Object.assign(e,{pen:null,aim:null,preview:null}),i()});function x(v,T){let P=t.pattern.vertices.length;t.put(qv(t.pattern,v,T,Sl)),t.pattern.vertices.length<P&&(e.selected=_i),s(t.pattern.vertices.length<P?"Two vertices are one now.":`Vertex ${v} is moved.`)}function m(){let{vertex:v,edge:T,click:P}=e.selected;if(v>=0)t.put(bl(t.pattern,[v]));else if(T>=0)t.put(Yv(t.pattern,T));else if(P>=0)e.clicks=e.clicks.filter((C,N)=>N!==P),r();else return;e.selected=_i,s("Deleted."),i()}function g(v){e.letter=v,e.selected.edge>=0&&t.put(Zv(t.pattern,e.selected.edge,v)),s(e.selected.edge>=0?d():`The next edge is drawn as ${Hr[v]}.`),i()}function _([v,T],P){let{vertex:C,click:N}=e.selected,F=D=>([V,$])=>u([V+v*D*n.unit,$-T*D*n.unit]);e.tool==="move"&&C>=0?x(C,F(P?10:1)(t.pattern.vertices[C])):e.tool==="scale"&&N>=0&&!e.cursor?(e.clicks=e.clicks.with(N,F(P?10:1)(e.clicks[N])),r()):w(F(P?50:5)(e.cursor??[n.width/2,n.height/2]))}function w(v){e.cursor=v,e.aim=c(v,l("keys")),s(`Cursor at ${v.map(T=>T.toFixed(0)).join(", ")} pixels${e.aim.what?`, at a ${e.aim.what}`:""}.`)}function S(v){let{vertices:T}=t.pattern,P=([,D])=>Math.round(D/(S3*n.unit)),C=e.points.filter(D=>ks(t.pattern,D,Sl)<0),N=[...T,...C].sort((D,V)=>P(D)-P(V)||D[0]-V[0]);if(!N.length)return;let F=e.cursor?N.findIndex(D=>Gr(D,e.cursor)<Sl):-1;w(N[(F+(v?1:F<0?0:-1)+N.length)%N.length])}function A(){e.cursor||w([n.width/2,n.height/2]);let{point:v}=e.aim=c(e.cursor,l("keys"));if(e.tool==="move")return h(e.cursor,l("keys"));if(e.tool==="scale")return p(v,l("keys")),r();f(e.pen,v),e.pen=v}function M(){[e.pen,e.aim,e.cursor,e.selected]=[null,null,null,_i],s("")}function y(v){(v?t.redo:t.undo)(),s(v?"Done again.":"Undone.")}return o.addEventListener("keydown",v=>{let{key:T}=v,P=T.toUpperCase(),C=v.ctrlKey||v.metaKey;if(!v.altKey){if(C&&P==="Z")y(v.shiftKey);else if(C&&P==="Y")y(!0);else{if(C)return;if(T in dr)_(dr[T],v.shiftKey);else if(T==="Delete"||T==="Backspace")m();else if(T==="Enter"||T===" ")A();else if(T==="Escape")M();else if(P==="N"||P==="P")S(P==="N");else if(P in Hr)g(P);else return}v.preventDefault(),i()}}),{remove:m,assign:g,again:y}}var w3={draw:"Draw",move:"Select and move",scale:"Set the scale"};function eb(n,e,t,i,s=()=>[]){let r=Object.entries(t).map(([o,a])=>{let l=b("input",{type:"radio",name:e,value:o});return l.addEventListener("change",()=>i(o)),[l,b("label",{},l,...s(o),` ${a}`)]});return{element:b("fieldset",{className:"trace-choice"},b("legend",{},n),...r.map(([,o])=>o)),show:o=>r.forEach(([a])=>a.checked=a.value===o)}}var tb=n=>eb("Tool","trace-tool",w3,n);function nb(n){let e=Object.fromEntries(Object.entries(Hr).map(([t,i])=>[t,`${Nt(i)} (${t})`]));return eb("Edges","trace-kind",e,n,t=>{let i=document.createElementNS("http://www.w3.org/2000/svg","svg"),s=document.createElementNS("http://www.w3.org/2000/svg","line");for(let[r,o]of Object.entries({x1:1,y1:5,x2:29,y2:5,class:`crease crease-${t}`}))s.setAttribute(r,o);return i.setAttribute("viewBox","0 0 30 10"),i.setAttribute("aria-hidden","true"),i.append(s),[i]})}function ib(n){let e=(t,i,s,r)=>{let o=b("input",{type:"range",min:0,max:i,value:s});return o.addEventListener("input",()=>r(o.value)),r(s),b("label",{},`${t} `,o)};return b("div",{className:"choices"},e("Opacity of the picture",100,60,t=>n.style.opacity=t/100),e("Brightness",200,100,t=>n.style.filter=`brightness(${t}%)`))}function Uh(n,{id:e,placeholder:t,button:i,note:s=""},r){let o=b("input",{type:"text",id:e,placeholder:t,size:13,spellcheck:!1}),a=b("button",{type:"button"},i),l=b("span",{},n),c=()=>r(o.value.trim());return a.addEventListener("click",c),o.addEventListener("keydown",({key:h})=>h==="Enter"&&c()),{element:b("div",{className:"trace-entry"},b("label",{htmlFor:e},l,o),a,...s?[b("p",{className:"note"},s)]:[]),input:o,button:a,label:l}}function Ti(n,e,t){let i=b("button",{type:"button",title:e},n);return i.addEventListener("click",t),i}var M3=800,rb=/\.(png|jpe?g)$/i,Jp={lines:[],places:[],words:[]},sb="Click for a vertex, drag for an edge. Keys: arrows lead a cursor or move what is selected (shift: further), N and P lead to the next and the previous vertex or junction, Enter draws from the last point, Escape ends that, letters choose the kind, Delete deletes, ctrl+Z and ctrl+Y undo and redo.",ob=({name:n})=>rb.test(n);function ab(n,e){let t=Uv(),i={tool:"draw",letter:"B",points:[],selected:_i,cursor:null,pen:null,aim:null,preview:null,clicks:[],most:2,scale:null,matrix:null,doubts:Jp,picture:null,conditions:[]},s=Kv(_),r=tb(we=>S(we)),o=nb(we=>h.assign(we)),a=b("p",{className:"note trace-said",role:"status"}),l=b("p",{className:"wrong",role:"alert"}),c=b("div",{className:"notes"}),u=Fv(we=>{S("move"),i.selected={..._i,vertex:we},w(),t.drawing.focus()}),h=Qv(t,i,s,{show:w,say:we=>a.textContent=we,clicked:g}),d=A3(g,we=>{[i.most,i.clicks,i.selected]=[we,[],_i],g(),S("scale")}),f=0,p=0;async function x(we){let Fe=URL.createObjectURL(we);try{await b("img",{src:Fe}).decode()}catch{URL.revokeObjectURL(Fe),M(`${we.name} cannot be displayed: need a PNG or JPEG picture`);return}URL.revokeObjectURL(t.image.src),t.image.src=Fe,await t.image.decode();let Ze={name:we.name,text:await E3(we)};Object.assign(i,{picture:Ze,points:[],doubts:Jp,clicks:[],scale:null,matrix:null,cursor:null}),s.clear(),t.size(t.image.naturalWidth,t.image.naturalHeight),At.hidden=!1,c.replaceChildren(),d.say(""),S("draw"),M(""),a.textContent="Searching for lines to which clicks snap …";let z=await Qn("picture-junctions",m());if(i.picture===Ze){if(z.refused){At.hidden=!0,i.picture=null,M(`${we.name} is not opened: ${z.refused}`);return}i.points=z.points,a.textContent=z.points.length?`Clicks snap to ${z.points.length} junctions of lines and corners.`:`Clicks snap to vertices only: ${z.reason||"no junctions of lines were found"}.`,w()}}let m=()=>({picture:i.picture.text,name:i.picture.name});async function g(){let{clicks:we,most:Fe}=i,Ze=d.text;if([i.scale,i.matrix]=[null,null],d.say(we.length<Fe?`${we.length} of ${Fe} points are clicked.`:Ze?"":d.missing),we.length===Fe&&Ze){let pe={points:Fe===4?qp(we):we,size:Ze,width:t.width,height:t.height},ke=await Qn("picture-scale",pe);if(i.clicks!==we)return;if(ke.refused)d.say(ke.refused,!0);else{[i.scale,i.matrix]=[pe,ke.matrix];let Qe=ke.estimated?` The shorter side is estimated from ${ke.estimated}; give width and height.`:"";d.say(`${Fe===4?`The rectified sheet is ${ke.size}`:`The length is ${ke.size}`}; one pixel is ${ke.pixel}.${Qe}`)}}_()}function _(){let{pattern:we}=s;(i.selected.vertex>=we.vertices.length||i.selected.edge>=we.edges.length)&&(i.selected=_i),i.conditions=Kp(we,i.matrix),clearTimeout(f),$e.checked&&i.scale&&we.edges.length>2&&(f=setTimeout(()=>D(!0),M3)),w()}function w(){o.show(i.letter),r.show(i.tool);let we=i.preview?Kp(i.preview,i.matrix):i.conditions;u.show(we,i.matrix!==null),t.show({...i,pattern:i.preview??s.pattern,conditions:we,clicks:i.tool==="scale"?i.clicks:[]});let{vertex:Fe,edge:Ze,click:z}=i.selected;V.disabled=!s.before.length,$.disabled=!s.after.length,B.disabled=Fe<0&&Ze<0&&z<0;let pe=i.scale&&s.pattern.edges.length>2;for(let ke of[K.button,be,Se])ke.disabled=!pe;xe.disabled=te.disabled=Ze<0,fe.disabled=Fe<0}function S(we){Object.assign(i,{tool:we,pen:null,aim:null,selected:_i}),d.element.hidden=we!=="scale",o.element.hidden=we==="scale",w()}let A=()=>{let{vertices:we,edges:Fe,letters:Ze}=s.pattern;return{scale:i.scale,name:i.picture.name,vertices:we,edges:Fe,letters:Ze}};function M(we){a.textContent="",l.textContent=we&&!we.endsWith(".")?`${we}.`:we;let Fe=/edges_vertices\[(\d+)\]/.exec(we)?.[1];Fe!==void 0&&(i.selected={..._i,edge:Number(Fe)}),w()}async function y(we){let Fe=s.pattern;M(""),a.textContent="Moving the vertices …";let Ze=await Qn("picture-straighten",{...A(),tolerance:we});if(s.pattern!==Fe)return;if(Ze.refused)return void M(Ze.refused);s.put({vertices:Ze.vertices,edges:Ze.edges,letters:Ze.letters});let z=Ze.symmetries.length?`, with ${Ze.symmetries.join(" and ")}`:"";a.textContent=[`Vertices moved by at most ${Ze.largest}: Kawasaki's condition holds at ${Ze.flat} vertices${z}`,...Ze.remarks].join(". ")}async function v(we){let{picture:Fe}=i,Ze=i.clicks.length===4?qp(i.clicks):null;M(""),a.textContent="Tracing …",ee.button.disabled=!0;let z=Ze?Ze.map(([R,q])=>`${R.toFixed(2)},${q.toFixed(2)}`).join(" "):ee.flat.checked?"none":"",pe=await Qn("picture-trace",{...m(),size:we,corners:z});if(ee.button.disabled=!1,i.picture!==Fe)return;if(pe.refused)return void M(pe.refused);let{points:ke,size:Qe}=pe.scale;[i.clicks,i.most]=[ke,ke.length],d.put(ke.length,Qe);let ye=([R,q])=>[pe.vertices[R],pe.vertices[q]],Et=R=>Object.entries(R).map(([q,ue])=>[Number(q),ue]),ze=Et(pe.doubts.edges),Ye=Et(pe.doubts.vertices);i.doubts={lines:ze.map(([R])=>ye(pe.edges[R])),places:[...Ye.map(([R])=>pe.vertices[R]),...pe.doubts.points.map(([R,q])=>[R,q])],words:[...pe.doubts.whole,...ze.map(([R,q])=>`Edge ${R}: ${q}.`),...Ye.map(([R,q])=>`Vertex ${R}: ${q}.`)]},c.replaceChildren(...i.doubts.words.length?[T()]:[]),s.put({vertices:pe.vertices,edges:pe.edges,letters:pe.letters}),await g();let k=i.doubts.words.length;a.textContent=`Traced ${pe.vertices.length} vertices and ${pe.edges.length} edges of a pattern of ${pe.said}; ${k?`${k} doubts are listed below`:"nothing is doubtful"}.`}function T(){let we=Ti("Remove the marks of doubts","the list and the orange marks",()=>{i.doubts=Jp,c.replaceChildren(),w()});return b("details",{open:!0},b("summary",{},"Doubts"),b("ul",{},...i.doubts.words.map(Fe=>b("li",{},Fe))),we)}function P(we){let{vertex:Fe,edge:Ze}=i.selected,z=ke=>ta(i.matrix,s.pattern.vertices[ke]),pe=Ze>=0?s.pattern.edges[Ze].map(z):[z(Fe)];s.put(jv(s.pattern,we(...pe).map(ke=>zv(i.matrix,ke)),2*t.unit))}async function C(we=!1){let Fe=await Qn("picture-pattern",A());return Fe.refused?M(`No pattern yet: ${Fe.refused}`):(l.textContent="",(!we||Fe.remarks.length)&&(a.textContent=[`The pattern is ${Fe.size}`,...Fe.remarks].join(". "))),Fe.refused?null:Fe}async function N(){let we=await C();we&&ps(new Blob([we.fold],{type:"application/json"}),F())}let F=()=>`${i.picture.name.replace(rb,"").replace(/[^\p{L}\p{N}._ -]/gu,"_").slice(0,60)||"picture"}.fold`;async function D(we=!1){let Fe=p+=1,Ze=await C(we);!Ze||Fe!==p||await n({design:"",files:[{name:F(),text:Ze.fold}],unit:""})||(en.append(ct),ot())}let V=Ti("Undo","ctrl+Z",()=>h.again(!1)),$=Ti("Redo","ctrl+Y",()=>h.again(!0)),B=Ti("Delete","what is selected",()=>h.remove()),ne=Ti("Enlarge","the picture and the drawing",()=>We(1.5)),Y=Ti("Reduce","the picture and the drawing",()=>We(1/1.5)),K=Uh("Move vertices by at most ",{id:"trace-tolerance",placeholder:"0.5 mm",button:"Make flat-foldable",note:"The vertices move as little as possible to Kawasaki's condition, and to the symmetries and straight lines that hold within this length."},y),ee=Uh("Width and height of the sheet ",{id:"trace-size",placeholder:"29.7 x 21 cm",button:"Trace automatically"},v);ee.flat=b("input",{type:"checkbox"}),ee.element.append(b("label",{},ee.flat," scan without perspective: the size is that of the pattern")),ee.element.append(b("p",{className:"note"},"Four corners under “Set the scale” are used if they are clicked; otherwise they are searched. The result replaces the drawing; undo restores it."));let de=b("input",{type:"number",id:"trace-copies",min:2,max:60,value:4}),ce=()=>Math.min(Math.max(Math.round(de.valueAsNumber)||2,2),60),te=Ti("Mirror at the selected edge","all edges",()=>P((we,Fe)=>[Vv(we,Fe)])),fe=Ti("Repeat around the selected vertex","all edges, by equal angles of a whole turn",()=>{let we=ce();P(Fe=>Array.from({length:we-1},(Ze,z)=>Gv(Fe,2*Math.PI*(z+1)/we)))}),xe=Ti("Repeat along the selected edge","all edges, by its length",()=>{let we=ce();P(([Fe,Ze],[z,pe])=>Array.from({length:we-1},(ke,Qe)=>([ye,Et])=>[ye+(Qe+1)*(z-Fe),Et+(Qe+1)*(pe-Ze)]))}),be=Ti("Download as FOLD","with the unit and the scale of the picture",N),Se=Ti("Fold it","open the pattern as the design of the workbench",()=>D()),$e=b("input",{type:"checkbox",id:"trace-follow"});$e.addEventListener("change",_);function ot(){ct.isConnected&&e.parentElement!==ct&&ct.append(e)}function We(we){t.magnify(we),w()}let lt=b("input",{type:"file",id:"trace-file",accept:".png,.jpg,.jpeg",className:"spoken"});lt.addEventListener("change",()=>{lt.files.length&&x(lt.files[0]),lt.value=""});let ct=b("div",{className:"trace-side",role:"group","aria-label":"the folded sheet"}),et=(we,...Fe)=>b("fieldset",{className:"trace-group"},b("legend",{},we),...Fe);t.drawing.setAttribute("aria-label",`the drawing over the picture. ${sb}`);let $t=b("div",{className:"trace-groups"},et("Result",b("div",{className:"choices"},Se,be),b("label",{},$e," fold it again after every change")),et("Trace automatically",ee.element),et("Flat-foldability",K.element),et("Symmetric copies",b("div",{className:"choices"},te,fe,xe,b("label",{htmlFor:"trace-copies"},"number in all ",de)))),Bt=b("p",{className:"note"},sb),en=b("div",{className:"trace-panes"},b("div",{},t.element,a,Bt,$t,c,u.element)),At=b("div",{hidden:!0},b("div",{className:"trace-tools"},r.element,o.element,d.element),b("div",{className:"choices"},V,$,B,ne,Y,ib(t.image)),en),dn=b("div",{className:"choices opening"},b("span",{className:"choosing"},lt,b("label",{className:"button",htmlFor:"trace-file"},"Choose a picture …")),b("p",{className:"note"},"A photograph, scan or drawing of a crease pattern (PNG or JPEG, up to 14 MB), or drop it anywhere on the page.")),vt=b("div",{className:"tracing"},dn,l,At);return new ResizeObserver(w).observe(t.drawing),S("draw"),{element:vt,take:x,state:i,history:s,seen:ot}}function A3(n,e){let t={2:["two points and their distance","Distance ","5 cm"],4:["four corners of a rectangle","Width and height ","29.7 x 21 cm"]},i=b("select",{"aria-label":"what is clicked"},...Object.entries(t).map(([l,[c]])=>b("option",{value:l},c))),s=Uh(t[2][1],{id:"trace-length",placeholder:t[2][2],button:"Apply"},n),r=b("p",{className:"note",role:"status"}),o=b("fieldset",{className:"trace-choice"},b("legend",{},"Scale: click in the picture"),i,s.element,r);function a(l){i.value=String(l),s.label.textContent=t[l][1],s.input.placeholder=t[l][2]}return i.addEventListener("change",()=>{a(Number(i.value)),e(Number(i.value))}),{element:o,get text(){return s.input.value.trim()},get missing(){return`Enter ${i.value==="4"?"the width and height":"the distance"}, such as ${t[i.value][2]}.`},put(l,c){a(l),s.input.value=c},say(l,c=!1){r.textContent=l,r.classList.toggle("fails",c)}}}async function E3(n){let e=new FileReader,t=new Promise((i,s)=>Object.assign(e,{onload:i,onerror:s}));return e.readAsDataURL(n),await t,e.result.slice(e.result.indexOf(",")+1)}function lb(n,e,t,i){let s=b("option",{value:""},e),r=n.filter(({name:p})=>p!==e).map(({name:p,shows:x})=>b("option",{value:p,title:x},p)),o=b("select",{id:"which-design"},s,...r),a=b("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf,.png,.jpg,.jpeg",className:"spoken"}),l=b("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),c="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf), or a picture to trace (.png, .jpg), can be dropped anywhere on the page.",u=b("label",{className:"button",htmlFor:"which-files"},"Open files …"),h=b("div",{className:"opening choices"},b("label",{htmlFor:"which-design"},"design ",o),b("span",{className:"choosing"},a,u),b("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",l),b("p",{className:"note"},c));o.addEventListener("change",()=>t({design:o.value,files:[],unit:""})),a.addEventListener("change",async()=>{a.files.length&&await f([...a.files]),a.value=""}),l.addEventListener("change",()=>{d&&t({design:"",files:d,unit:l.value.trim()})});let d=null;async function f(p){let x=p.find(ob);if(x){await i(x);return}let m=await Promise.all(p.map(async g=>({name:g.name,text:await g.text()})));d=T3(m),await t({design:"",files:d,unit:l.value.trim()})}return C3(f),{element:h,show({design:p,files:x}){o.querySelector(".sent")?.remove(),x.length&&o.append(b("option",{value:x[0].name,className:"sent"},x[0].name)),o.value=x.length?x[0].name:p,d=x.length?x:null}}}function T3(n){let e=n.filter(({name:i})=>/\.toml$/i.test(i)),t=e.find(({name:i})=>!e.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[t,...n.filter(i=>i!==t)]}function C3(n){let{body:e}=document,t=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),e.classList.add("dropping"))};e.addEventListener("dragenter",t),e.addEventListener("dragover",t),e.addEventListener("dragleave",i=>{i.relatedTarget||e.classList.remove("dropping")}),e.addEventListener("drop",i=>{e.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function cb(n,{button:e,text:t,title:i},s){let r=b("button",{type:"button",className:"try"},e),o=b("button",{type:"button",hidden:!0},"Stop"),a=b("p",{className:"note",role:"status"},t),l=b("div"),c=b("div",{className:"results"},b("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let x=s(),m=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let g=!1;try{let _=await Lh(n,x,h.signal,w=>{w.doing&&(a.textContent=`${w.doing} …`)});_.refused?a.textContent=`No result: ${_.refused}.`:f(_.done,x,(performance.now()-m)/1e3),g=!_.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,g&&p()}function f(x,m,g){u=JSON.stringify(m),a.textContent=`Done in ${g.toFixed(g<10?1:0)} s.`;let _=b("a",{href:x,target:"_blank",rel:"noopener"},"Open in a new window"),w=b("iframe",{src:x,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(b("p",{},_),w)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var R3=1500;function ub(){let n=b("p",{role:"status"}),e=b("p",{className:"wrong",role:"alert"}),t=b("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;t.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),t.hidden=!0,n.textContent=o,e.textContent=a}return{element:b("div",{className:"says"},n,t,e),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>t.hidden=!1,R3))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function hb(){let n=b("a",{className:"button"},"Download the design"),e=b("code"),t=b("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},e);return{element:b("div",{className:"taking"},n,t),show(i){n.href=Nh(i.text,"application/toml"),n.download=`${i.name}.toml`,e.textContent=i.command}}}function db(n){let e=b("div"),t=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===t)return;t=r,e.querySelector("img")||e.replaceChildren(b("p",{className:"note",role:"status"},"Drawing …"));let o=await Qn("pattern",s);if(t!==r)return;if(o.refused){e.replaceChildren(b("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=b("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>b("a",{className:"button",download:h,href:d},u),c=Nh(o.fold,"application/json");e.replaceChildren(b("figure",{className:"drawn"},a),b("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:e,seen:i}}function fb(n){let e={},t=0;function i(){if(clearTimeout(t),!Object.keys(e).length)return;let s=e;return e={},n(s)}return{put(s,r){e[s]=r,clearTimeout(t),t=setTimeout(i,250)},hand:i}}function pb(n,e){let t=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=b("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=b("div",{className:"tabs",role:"tablist","aria-label":e},...t),s=0;function r(o){s=o;for(let[a,l]of t.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:t.length-1};o in a&&(r((a[o]+t.length)%t.length),t[s].focus())}),{element:b("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>t[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}var mb=.02;function gb(n,{moving:e,shape:t,names:i,asked:s,held:r}){let o=b("p",{className:"note",role:"status"}),a=b("button",{type:"button","aria-pressed":"false",title:"drag panels as well; otherwise dragging a panel turns the picture"},"drag panels");a.addEventListener("click",()=>a.setAttribute("aria-pressed",String(a.getAttribute("aria-pressed")!=="true")));let l=null,c=!1,u=!0,h=!0;async function d(){if(c||!l)return;let{place:M,target:y}=l,v={...s(),weights:Object.fromEntries(M),target:y,begins:u};l=null,u=!1,c=!0;let T=await Qn("drag",v);c=!1,h||f(T),d()}function f(M){let y=M.refused?`Not dragged: ${M.refused}.`:M.text;M.points&&(e.hold(Kt(M.points,Float32Array)),r(!0)),g.say(y),o.textContent=y}function p(M,y){h&&(u=!0),h=!1,l={place:M,target:y.toArray()},d()}function x(){h=!0,l=null,e.hold(null),r(!1)}function m(M,y){if(a.getAttribute("aria-pressed")!=="true")return null;let v=new Tr;v.setFromCamera(new Je(M,y),n.eye.camera);let{mesh:T}=e,P=null,C=[new H,new H,new H],N=new H,{vertices:F}=n.views[0].shape;for(let V=0;V<T.triangles.length;V+=3){let $=T.triangles.slice(V,V+3);for(let[ne,Y]of $.entries())C[ne].fromArray(F,3*Y);if(!v.ray.intersectTriangle(...C,!1,N))continue;let B=N.distanceTo(v.ray.origin);(!P||B<P.away)&&(P={away:B,numbers:$,shares:Qi.getBarycoord(N,...C,new H).toArray()})}if(!P)return null;let D=new Map;for(let[V,$]of P.numbers.entries())for(let[B,ne]of[[T.between[2*$],1-T.share[$]],[T.between[2*$+1],T.share[$]]])ne&&D.set(B,(D.get(B)??0)+ne*P.shares[V]);return[...D]}let g=qu(n,{points:t,movable:i.map(M=>M!==null),between:m,moved:(M,y,v)=>p(M,v),left:x}),_=P3(n,t,i,p,x),w=b("p",{className:"note"},"Drag a vertex: the package computes the equilibrium with the springs of the creases, and the force that holds it."),S=b("div",{className:"drag"},w,o,_.element);return n.element.parentElement.querySelector(".views").prepend(b("span",{className:"panels"},a)),{element:S,end:_.end}}function P3(n,e,t,i,s){let r=$u(t.map((f,p)=>[f,p]).filter(([f])=>f!==null)),o=Xu("drag",{clicked:u,pressed:u}),a=b("button",{type:"button"},"Release"),l=b("p",{className:"note"},"On these buttons, every arrow key drags the vertex by 2 % of the structure's size. It stays there until it is released."),c=null;function u(f){let[p,x]=dr[f],m=Number(r.value);c??=new H().fromArray(e(),3*m);let{camera:g,size:_}=n.eye;c.addScaledVector(new H().setFromMatrixColumn(g.matrixWorld,0),mb*_*p),c.addScaledVector(new H().setFromMatrixColumn(g.matrixWorld,1),mb*_*x),i([[m,1]],c)}function h(){c=null,s()}return r.addEventListener("change",h),a.addEventListener("click",h),{element:b("details",{className:"push-keys"},b("summary",{},"Drag without a pointer"),b("div",{className:"choices"},b("label",{},"point ",r),o,a),l),end:h}}function xb(n){let e=new Set,t={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of e)o()})}return{get time(){return i},span:t,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>t.start+o*(t.end-t.start),wayAt:o=>(o-t.start)/(t.end-t.start||1),onChange(o){return e.add(o),r(),()=>e.delete(o)},seek(o){i=Math.min(t.end,Math.max(t.start,o)),r()}}}var Qp=100;function _b(){let n=b("p",{className:"note",role:"status"}),[e,t,i,s]=["","notes","",""].map(p=>b("div",{className:p})),r=b("div",{className:"folding"},n,e,t,i,s),o={element:r,whole:"structure",share:0,complete:!1,clock:null,path:null},a=null,l=null,c=null;Object.defineProperty(o,"look",{get:()=>c?.look}),o.show=(p,{fresh:x=!1,look:m,begins:g}={})=>{o.leave(),x&&(o.share=0);let _=l=Object.assign(new AbortController,{wanted:p}),w=performance.now(),S=null;return new Promise(A=>{let M=y=>{y.picture&&(S=y.picture,o.whole=S.whole,g?.(),(x||!c?.grow)&&h(S,m),a=p,o.complete=!1,n.textContent="Computing the fold path …",A({shown:!0})),y.path&&d(S,y.path,_),y.done&&(n.textContent=L3(o.path,(performance.now()-w)/1e3))};Lh("fold",{...p,share:x?null:o.share},_.signal,M).then(({refused:y})=>{A({refused:y}),!(!y||l!==_)&&(S&&c?.grow&&h(S,m),S&&(n.textContent=`No fold path is shown: ${y}.`))},()=>A({refused:"building was stopped"}))})},o.shows=p=>c!==null&&JSON.stringify(a)===JSON.stringify(p),o.leave=()=>{l?.abort(),l=null},o.resume=()=>{!l||l.wanted===a||(o.leave(),a&&!o.complete&&o.show(a))},o.clear=()=>{o.leave(),u(),a=null};function u(){if(!c)return;let{look:p}=c;c.dispose(),c=null,o.clock=o.path=null;for(let x of[e,t,i,s])x.replaceChildren();return p}function h(p,x){let m=u()??x??ar(),g=Kn(p.clips[0]),{stage:_}=Hu(e,[g],xb(g),{...p,text:`${p.shape}, as built.`},{...m,following:!1});e.setAttribute("aria-label",`the ${p.whole} as built`),c={clip:()=>g,look:_?.eye.look??m,dispose:()=>_?.dispose()}}function d(p,x,m){let g=Kn({...p.clips[0],...x.clips[0]});o.path=x,c?.mine===m&&c.largest===x.energy.largest_J?c.grow(g,x):f(g,x,m,p.points),x.complete&&c.complete(x),o.complete=x.complete}function f(p,x,m,g){let _=e.contains(document.activeElement),w=c?.clip(),S=u()??ar(),A=I3(p);w?.mesh.pointCount===p.mesh.pointCount&&A.lend(w);let M=Bi([A],x.spans);M.seek(Qp*o.share);let y=ur(e,[A],M,x,S,!1);y.stage?.eye.aim(),A.lend(null);let v=null,T=()=>{o.share!==M.time/Qp&&v?.end(),o.share=M.time/Qp},P=[()=>y.dispose(),M.onChange(T)];c={mine:m,clip:A.now,look:y.stage?.eye.look??S,largest:x.energy.largest_J,dispose:()=>P.forEach(C=>C()),grow(C){A.replace(C),M.redraw()},complete({plots:C,notes:N,energy:F,spans:D}){M.setSpan({...D[0]}),t.replaceChildren(...N.map(B=>b("p",{className:"note"},B)));let V=B=>{r.classList.toggle("pulled",B),M.redraw()};if(y.stage){let B=()=>A.pointsAt(M.clipTime(0));v=gb(y.stage,{moving:A,shape:B,names:g,asked:()=>({...a,share:o.share}),held:V}),(e.querySelector(".crease-choice")??e.querySelector(".transport")).after(v.element)}let $=mr(i,C,[A],M);P.push(()=>$.dispose(),hr(s,A,M,F))}},Object.assign(o,{clock:M,stage:y.stage,moving:A,path:x}),_&&e.querySelector("input[type=range]").focus({preventScroll:!0})}return o}function I3(n){let e=n,t=null,i=null,s={now:()=>e,replace:r=>e=r,lend:r=>t=r,hold:r=>i=r,pointsAt(r,o){return i?o?(o.set(i),o):i:(t??e).pointsAt(r,o)},verticesAt:(r,o)=>i?e.verticesOf(i,o):e.verticesAt(r,o)};return new Proxy(s,{get:(r,o)=>s[o]??e[o]})}function L3(n,e){let t=`${e.toFixed(e<10?1:0)} s`;return n.reached?`The fold path was computed in ${t}.`:`The fold path was computed in ${t}; it does not reach its goal.`}var N3=[{name:"live",title:"simulated in time"},{name:"fold",title:"slowly along its path"}];function vb(n,e,t){let i=b("div"),s=_b(),r={element:i,fold:s,panel:null,whole:"structure",refused:"",engine:null},o="live",a=null,l,c;function u(){let g=r.panel?.stage?.eye.look;l=g?{...g,closer:g.closer/Yu}:s.look??l,c=r.panel?.pace??c}function h(){u(),r.panel?.leave(),r.panel=null}r.begin=async(g,_)=>{if(!_&&r.panel)return{};let w=await s.show(g,{fresh:_,look:l,begins:h});return w.shown&&(r.whole=s.whole,i.contains(s.element)||i.replaceChildren(s.element)),w},r.resume=()=>s.resume(),r.show=async g=>{a=g,r.whole=a.bench?.whole??s.whole,r.refused=a.live.refused??"",!r.refused&&o==="live"?await d():await f()};async function d(){let{bench:g,live:_,warnings:w}=a;u();try{let S=await Vo(Kn(g.clips[0]),g,JSON.stringify(_),x,{look:D3(l),pace:c,set:e});h(),s.clear(),i.replaceChildren(p(),S.element,...yb(w)),S.begin(),r.panel=S}catch(S){r.engine?.end(),r.engine=null,r.refused=S.message,await f()}}async function f(){h(),i.replaceChildren(...r.refused?[]:[p()],s.element,...r.refused?[m()]:[],...yb(a.warnings)),s.shows(n())||await s.show(n(),{look:l})}function p(){let g=Ih(r.whole,N3,async _=>{_!==o&&(o=_,await(_==="live"?d():f()),[...i.querySelectorAll(".modes button")].find(w=>w.textContent===o)?.focus())});return g.mark(o),g.element}async function x(g,_){return r.engine?r.engine.take(g,_):(r.engine=await Uo(g,_),r.engine)}function m(){let g=b("p",{className:"note"},`The motion in time is not simulated in this page: ${r.refused}. The package simulates it.`),_=b("button",{type:"button"},"Run it");return _.addEventListener("click",t),b("div",{className:"offer"},_,g)}return r}var D3=n=>n&&{...n,following:!1,closer:Yu*n.closer};function yb(n){if(!n.length)return[];let e=t=>`${t.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[b("h2",{},"What to know"),b("ul",{className:"warnings"},...n.map(t=>b("li",{},e(t))))]}var k3={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function bb(n){let e=ub(),t=Promise.resolve(),i=m=>t=t.then(m).catch(g=>e.refuse(g.message)),s=Lv({says:e,reply:f,picture:(m,g)=>h.wing.begin(m,g),model:p,resume:()=>h.wing.resume()}),r=fb(m=>i(()=>s.slide(m))),o=null,a=m=>(o=m,i(()=>o===m&&s.open(m,{}))),l=m=>(o=m,i(async()=>{if(o!==m)return"a later design is opened";let{asked:g}=s,_=g?.files[0]?.name===m.files[0].name,w=_?g.settings:{},S=await s.open(m,w,!_);return S&&Object.keys(w).length?s.open(m,{}):S})),c=lb(n.designs,n.opened,a,m=>(h.tabs.choose("trace"),h.tracing.take(m))),u=Ov((m,g)=>{r.hand(),i(()=>s.change(m,g))}),h=U3(s,r,a,l),d=hb();function f({asked:m,base:g,reply:_,rejected:w}){document.title=`${_.title}: workbench`,document.querySelector("h1").textContent=_.title,c.show(m),u.show(_,m.settings,g);for(let[S,{text:A,why:M}]of w)u.reject(S,A,M);h.file.show(_),d.show(_),h.tabs.seen()}async function p(m){await h.wing.show(m),h.tabs.name("wing",Nt(h.wing.whole))}let x=b("div",{className:"masthead"},c.element,d.element,e.element);return document.getElementById("workbench").append(x,u.element,h.tabs.element),h.tabs.choose("wing"),await i(()=>O3(s,n)),Object.assign(s,{wing:h.wing,tracing:h.tracing,idle:()=>t})}async function O3(n,e){let t=Nv();t&&!await n.open({design:t.design,files:t.files,unit:t.unit},t.settings)||await n.open({design:"",files:[],unit:""},e.settings)}function U3(n,e,t,i){let s=()=>n.asked,r=Object.fromEntries(Object.entries(k3).map(([d,f])=>[d,cb(d,f,s)])),o=vb(s,e.put,()=>{h.choose("run"),r.run.find()}),a=db(s),l=Dv(d=>t({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:d}],unit:""})),c=b("div",{},o.element),u=ab(i,o.element),h=pb([{name:"wing",title:"Structure",element:c,seen:()=>o.element.parentElement!==c&&c.append(o.element)},{name:"sheet",title:"Pattern",...a},{name:"trace",title:"Trace",element:u.element,seen:u.seen},{name:"landscape",title:"Landscape",...r.landscape},{name:"run",title:"Run",...r.run},{name:"file",title:"File",element:l.element}],"views of the design");return{tabs:h,wing:o,file:l,tracing:u}}var F3={run:Vp,compare:by,curves:Vp,study:tv,goals:nv,parts:wv,bench:zx,workbench:bb},em=JSON.parse(document.getElementById("data").textContent);Sm(em.reading_units);function Sb(n){let e=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(b("p",{className:"note",role:"alert"},e)),n}function wb(n){window.forficula=n}try{let n=F3[em.kind](em);n instanceof Promise?n.then(wb,Sb):wb(n)}catch(n){Sb(n)}bm();zo();})();
