/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources 56b1dcb6e038fa02b90a7c95c9e9b652751158f19c9d7185f3a8e3b3ea027745 */
(()=>{function S(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function fl(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function lr({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}var Lp=3,pv=1e4;function cr(n,t){let e=URL.createObjectURL(n);S("a",{href:e,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(e),pv)}function Xn(n){return`${document.title.split(/: | with /)[0]} ${n}`.toLowerCase().normalize("NFKD").replace(/[^a-z0-9.]+/g,"-").replace(/^-+|-+$/g,"")||"plot"}function $i(n,t,e){let i=(o,a)=>{let l=S("button",{type:"button","aria-label":`download ${o} of ${n}`,title:`download as ${o}`},o);return l.addEventListener("click",a),l},s=()=>cr(new Blob([e().svg],{type:"image/svg+xml"}),`${t()}.svg`);return S("span",{className:"saves"},i("PNG",async()=>cr(await mv(e()),`${t()}.png`)),i("SVG",s))}async function mv({svg:n,width:t,height:e}){let i=URL.createObjectURL(new Blob([n],{type:"image/svg+xml"}));try{let s=S("img",{width:t,height:e});await new Promise((o,a)=>{s.onload=o,s.onerror=a,s.src=i});let r=S("canvas",{width:Lp*t,height:Lp*e});return r.getContext("2d").drawImage(s,0,0,r.width,r.height),await new Promise(o=>r.toBlob(o,"image/png"))}finally{URL.revokeObjectURL(i)}}function Np(){for(let n of document.querySelectorAll("figure.drawn")){let[t,e]=[n.querySelector("img"),n.querySelector("source")],i=n.closest("section")?.id??"figure",s=[["PNG",t.src],["SVG",e.srcset]].map(([r,o])=>{let a=`download ${r} of the figure ${i}`,l=S("button",{type:"button","aria-label":a,title:`download as ${r}`},r);return l.addEventListener("click",()=>cr(gv(o),`${Xn(i)}.${r.toLowerCase()}`)),l});n.append(S("div",{className:"saves save-foot"},...s))}}function gv(n){let[t,e]=n.split(","),i=atob(e);return new Blob([Uint8Array.from(i,s=>s.charCodeAt(0))],{type:/:(.*?);/.exec(t)[1]})}function Oe(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function qn(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function bh(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}function Ee(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}var Sh={};function Dp(n){Sh=n}function Op(n,t){let e=Sh[n],[i,s]=e.find(([,,r])=>t>=r||t===0)??e.at(-1);return{unit:i,factor:s}}function Up(n){return Object.values(Sh).flat().find(([t])=>t===n)[1]}function Os(n,t){let{unit:e,factor:i}=Op(t,Math.abs(n));return`${Ee(i*n)} ${e}`}function Qo(n){return Op("s",Math.max(Math.abs(n.start),Math.abs(n.end)))}function ls(n,t){let{unit:e,factor:i}=Qo(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${qn(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var Ys={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Zs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},mm=0,jh=1,gm=2;var Na=1,xm=2,mo=3,Ks=0,Kn=1,Bn=2,gr=0,go=1,Qh=2,td=3,ed=4,_m=5;var xr=100,ym=101,vm=102,bm=103,Sm=104,Mm=200,wm=201,Am=202,Em=203,nd=204,id=205,Tm=206,Cm=207,Rm=208,Pm=209,Im=210,Lm=211,Nm=212,Dm=213,Om=214,Bl=0,zl=1,Vl=2,io=3,Gl=4,Hl=5,Wl=6,$l=7,xc=0,Um=1,Fm=2,Ji=0,sd=1,rd=2,od=3,ad=4,ld=5,cd=6,ud=7;var hd=300,_r=301,xo=302,_c=303,yc=304,Xl=1e3,qi=1001,ql=1002,In=1003,km=1004;var Da=1005;var Zn=1006,vc=1007;var bs=1008;var Qn=1009,dd=1010,fd=1011,_o=1012,bc=1013,Li=1014,bi=1015,Ni=1016,Sc=1017,Mc=1018,yr=1020,pd=35902,md=35899,gd=1021,xd=1022,Di=1023,ms=1026,Ss=1027,wc=1028,Ac=1029,Js=1030,Ec=1031;var Tc=1033,Oa=33776,Ua=33777,Fa=33778,ka=33779,Cc=35840,Rc=35841,Pc=35842,Ic=35843,Lc=36196,Nc=37492,Dc=37496,Oc=37488,Uc=37489,Ba=37490,Fc=37491,kc=37808,Bc=37809,zc=37810,Vc=37811,Gc=37812,Hc=37813,Wc=37814,$c=37815,Xc=37816,qc=37817,Yc=37818,Zc=37819,Kc=37820,Jc=37821,jc=36492,Qc=36494,tu=36495,eu=36283,nu=36284,za=36285,iu=36286;var ua=2300,Yl=2301,Fl=2302,Wh=2303,$h=2400,Xh=2401,qh=2402;var Bm=3200;var su=0,zm=1,Ms="",li="srgb",ha="srgb-linear",da="linear",Te="srgb";var kl=7680,_d=7681;var yd=517;var Vm=519,Gm=512,Hm=513,Wm=514,vd=515,$m=516,Xm=517,bd=518,Sd=519,qm=35044,Va=35048;var Md="300 es",vi=2e3,so=2001;function xv(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function _v(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function fa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ym(){let n=fa("canvas");return n.style.display="block",n}var Fp={},ro=null;function wd(...n){let t="THREE."+n.shift();ro?ro("log",t,...n):console.log(t,...n)}function Zm(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=Zm(n);let t="THREE."+n.shift();if(ro)ro("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Qt(...n){n=Zm(n);let t="THREE."+n.shift();if(ro)ro("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function aa(...n){let t=n.join(" ");t in Fp||(Fp[t]=!0,qt(...n))}function Km(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Jm={[Bl]:Bl,[Vl]:Wl,[Gl]:Gl,[io]:Hl,[zl]:zl,[Wl]:Vl,[$l]:$l,[Hl]:io},Ii=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],kp=1234567,la=Math.PI/180,oo=180/Math.PI;function yo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]).toLowerCase()}function pe(n,t,e){return Math.max(t,Math.min(e,n))}function Ad(n,t){return(n%t+t)%t}function yv(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function vv(n,t,e){return n!==t?(e-n)/(t-n):0}function ca(n,t,e){return(1-e)*n+e*t}function bv(n,t,e,i){return ca(n,t,1-Math.exp(-e*i))}function Sv(n,t=1){return t-Math.abs(Ad(n,t*2)-t)}function Mv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function wv(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function Av(n,t){return n+Math.floor(Math.random()*(t-n+1))}function Ev(n,t){return n+Math.random()*(t-n)}function Tv(n){return n*(.5-Math.random())}function Cv(n){n!==void 0&&(kp=n);let t=kp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function Rv(n){return n*la}function Pv(n){return n*oo}function Iv(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Lv(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Ed(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Nv(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),u=o((t+i)/2),h=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*u,l*h,l*d,a*c);break;case"YZY":n.set(l*d,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*d,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Td(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function jm(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Qm(n,t){if(t.constructor===Float32Array)return n;let e=Td(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Cd={DEG2RAD:la,RAD2DEG:oo,generateUUID:yo,clamp:pe,euclideanModulo:Ad,mapLinear:yv,inverseLerp:vv,lerp:ca,damp:bv,pingpong:Sv,smoothstep:Mv,smootherstep:wv,randInt:Av,randFloat:Ev,randFloatSpread:Tv,seededRandom:Cv,degToRad:Rv,radToDeg:Pv,isPowerOfTwo:Iv,ceilPowerOfTwo:Lv,floorPowerOfTwo:Ed,setQuaternionFromProperEuler:Nv,normalize:Qm,denormalize:jm},Zt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(pe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ui=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(h!==_||l!==d||c!==f||u!==p){let m=l*d+c*f+u*p+h*_;m<0&&(d=-d,f=-f,p=-p,_=-_,m=-m);let g=1-a;if(m<.9995){let x=Math.acos(m),b=Math.sin(x);g=Math.sin(g*x)/b,a=Math.sin(a*x)/b,l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a}else{l=l*g+d*a,c=c*g+f*a,u=u*g+p*a,h=h*g+_*a;let x=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=x,c*=x,u*=x,h*=x}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+u*h+l*f-c*d,t[e+1]=l*p+u*d+c*h-a*f,t[e+2]=c*p+u*f+a*d-l*h,t[e+3]=u*p-a*h-l*d-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),d=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"YXZ":this._x=d*u*h+c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"ZXY":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h-d*f*p;break;case"ZYX":this._x=d*u*h-c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h+d*f*p;break;case"YZX":this._x=d*u*h+c*f*p,this._y=c*f*h+d*u*p,this._z=c*u*p-d*f*h,this._w=c*u*h-d*f*p;break;case"XZY":this._x=d*u*h-c*f*p,this._y=c*f*h-d*u*p,this._z=c*u*p+d*f*h,this._w=c*u*h+d*f*p;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(pe(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,e=Math.sin(e*c)/u,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},G=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Bp.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Bp.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this.z=pe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this.z=pe(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Mh.copy(this).projectOnVector(t),this.sub(Mh)}reflect(t){return this.sub(Mh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(pe(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Mh=new G,Bp=new ui,te=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],p=i[8],_=s[0],m=s[3],g=s[6],x=s[1],b=s[4],v=s[7],A=s[2],E=s[5],y=s[8];return r[0]=o*_+a*x+l*A,r[3]=o*m+a*b+l*E,r[6]=o*g+a*v+l*y,r[1]=c*_+u*x+h*A,r[4]=c*m+u*b+h*E,r[7]=c*g+u*v+h*y,r[2]=d*_+f*x+p*A,r[5]=d*m+f*b+p*E,r[8]=d*g+f*v+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,p=e*h+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return t[0]=h*_,t[1]=(s*c-u*i)*_,t[2]=(a*i-s*o)*_,t[3]=d*_,t[4]=(u*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=f*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return aa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(wh.makeScale(t,e)),this}rotate(t){return aa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(wh.makeRotation(-t)),this}translate(t,e){return aa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(wh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},wh=new te,zp=new te().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Vp=new te().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Dv(){let n={enabled:!0,workingColorSpace:ha,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Te&&(s.r=ps(s.r),s.g=ps(s.g),s.b=ps(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Te&&(s.r=no(s.r),s.g=no(s.g),s.b=no(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ms?da:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ha]:{primaries:t,whitePoint:i,transfer:da,toXYZ:zp,fromXYZ:Vp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:li},outputColorSpaceConfig:{drawingBufferColorSpace:li}},[li]:{primaries:t,whitePoint:i,transfer:Te,toXYZ:zp,fromXYZ:Vp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:li}}}),n}var xe=Dv();function ps(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function no(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Gr,Zl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Gr===void 0&&(Gr=fa("canvas")),Gr.width=t.width,Gr.height=t.height;let s=Gr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Gr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=fa("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ps(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ps(e[i]/255)*255):e[i]=ps(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},Ov=0,ao=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ov++}),this.uuid=yo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Ah(s[o].image)):r.push(Ah(s[o]))}else r=Ah(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Ah(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Zl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var Uv=0,Eh=new G,jn=class n extends Ii{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=qi,s=qi,r=Zn,o=bs,a=Di,l=Qn,c=n.DEFAULT_ANISOTROPY,u=Ms){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Uv++}),this.uuid=yo(),this.name="",this.source=new ao(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Zt(0,0),this.repeat=new Zt(1,1),this.center=new Zt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new te,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Eh).x}get height(){return this.source.getSize(Eh).y}get depth(){return this.source.getSize(Eh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==hd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Xl:t.x=t.x-Math.floor(t.x);break;case qi:t.x=t.x<0?0:1;break;case ql:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Xl:t.y=t.y-Math.floor(t.y);break;case qi:t.y=t.y<0?0:1;break;case ql:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};jn.DEFAULT_IMAGE=null;jn.DEFAULT_MAPPING=hd;jn.DEFAULT_ANISOTROPY=1;var ke=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],p=l[9],_=l[2],m=l[6],g=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-_)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+_)<.1&&Math.abs(p+m)<.1&&Math.abs(c+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(c+1)/2,v=(f+1)/2,A=(g+1)/2,E=(u+d)/4,y=(h+_)/4,w=(p+m)/4;return b>v&&b>A?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=E/i,r=y/i):v>A?v<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),i=E/s,r=w/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=y/r,s=w/r),this.set(i,s,r,e),this}let x=Math.sqrt((m-p)*(m-p)+(h-_)*(h-_)+(d-u)*(d-u));return Math.abs(x)<.001&&(x=1),this.x=(m-p)/x,this.y=(h-_)/x,this.z=(d-u)/x,this.w=Math.acos((c+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=pe(this.x,t.x,e.x),this.y=pe(this.y,t.y,e.y),this.z=pe(this.z,t.z,e.z),this.w=pe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=pe(this.x,t,e),this.y=pe(this.y,t,e),this.z=pe(this.z,t,e),this.w=pe(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pe(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Kl=class extends Ii{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new ke(0,0,t,e),this.scissorTest=!1,this.viewport=new ke(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new jn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new ao(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},hi=class extends Kl{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},pa=class extends jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Jl=class extends jn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=In,this.minFilter=In,this.wrapR=qi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ae=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m)}set(t,e,i,s,r,o,a,l,c,u,h,d,f,p,_,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=h,g[14]=d,g[3]=f,g[7]=p,g[11]=_,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Hr.setFromMatrixColumn(t,0).length(),r=1/Hr.setFromMatrixColumn(t,1).length(),o=1/Hr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=f+p*c,e[5]=d-_*c,e[9]=-a*l,e[2]=_-d*c,e[6]=p+f*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d+_*a,e[4]=p*a-f,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=f*a-p,e[6]=_+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*u,f=l*h,p=c*u,_=c*h;e[0]=d-_*a,e[4]=-o*h,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*u,e[9]=_-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*u,f=o*h,p=a*u,_=a*h;e[0]=l*u,e[4]=p*c-f,e[8]=d*c+_,e[1]=l*h,e[5]=_*c+d,e[9]=f*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=_-d*h,e[8]=p*h+f,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=f*h+p,e[10]=d-_*h}else if(t.order==="XZY"){let d=o*l,f=o*c,p=a*l,_=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=d*h+_,e[5]=o*u,e[9]=f*h-p,e[2]=p*h-f,e[6]=a*u,e[10]=_*h+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Fv,t,kv)}lookAt(t,e,i){let s=this.elements;return oi.subVectors(t,e),oi.lengthSq()===0&&(oi.z=1),oi.normalize(),Us.crossVectors(i,oi),Us.lengthSq()===0&&(Math.abs(i.z)===1?oi.x+=1e-4:oi.z+=1e-4,oi.normalize(),Us.crossVectors(i,oi)),Us.normalize(),pl.crossVectors(oi,Us),s[0]=Us.x,s[4]=pl.x,s[8]=oi.x,s[1]=Us.y,s[5]=pl.y,s[9]=oi.y,s[2]=Us.z,s[6]=pl.z,s[10]=oi.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],p=i[2],_=i[6],m=i[10],g=i[14],x=i[3],b=i[7],v=i[11],A=i[15],E=s[0],y=s[4],w=s[8],I=s[12],L=s[1],P=s[5],N=s[9],k=s[13],D=s[2],V=s[6],X=s[10],W=s[14],ot=s[3],Z=s[7],Q=s[11],it=s[15];return r[0]=o*E+a*L+l*D+c*ot,r[4]=o*y+a*P+l*V+c*Z,r[8]=o*w+a*N+l*X+c*Q,r[12]=o*I+a*k+l*W+c*it,r[1]=u*E+h*L+d*D+f*ot,r[5]=u*y+h*P+d*V+f*Z,r[9]=u*w+h*N+d*X+f*Q,r[13]=u*I+h*k+d*W+f*it,r[2]=p*E+_*L+m*D+g*ot,r[6]=p*y+_*P+m*V+g*Z,r[10]=p*w+_*N+m*X+g*Q,r[14]=p*I+_*k+m*W+g*it,r[3]=x*E+b*L+v*D+A*ot,r[7]=x*y+b*P+v*V+A*Z,r[11]=x*w+b*N+v*X+A*Q,r[15]=x*I+b*k+v*W+A*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],d=t[10],f=t[14],p=t[3],_=t[7],m=t[11],g=t[15],x=l*f-c*d,b=a*f-c*h,v=a*d-l*h,A=o*f-c*u,E=o*d-l*u,y=o*h-a*u;return e*(_*x-m*b+g*v)-i*(p*x-m*A+g*E)+s*(p*b-_*A+g*y)-r*(p*v-_*E+m*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],u=t[10];return e*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],d=t[10],f=t[11],p=t[12],_=t[13],m=t[14],g=t[15],x=e*a-i*o,b=e*l-s*o,v=e*c-r*o,A=i*l-s*a,E=i*c-r*a,y=s*c-r*l,w=u*_-h*p,I=u*m-d*p,L=u*g-f*p,P=h*m-d*_,N=h*g-f*_,k=d*g-f*m,D=x*k-b*N+v*P+A*L-E*I+y*w;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return t[0]=(a*k-l*N+c*P)*V,t[1]=(s*N-i*k-r*P)*V,t[2]=(_*y-m*E+g*A)*V,t[3]=(d*E-h*y-f*A)*V,t[4]=(l*L-o*k-c*I)*V,t[5]=(e*k-s*L+r*I)*V,t[6]=(m*v-p*y-g*b)*V,t[7]=(u*y-d*v+f*b)*V,t[8]=(o*N-a*L+c*w)*V,t[9]=(i*L-e*N-r*w)*V,t[10]=(p*E-_*v+g*x)*V,t[11]=(h*v-u*E-f*x)*V,t[12]=(a*I-o*P-l*w)*V,t[13]=(e*P-i*I+s*w)*V,t[14]=(_*b-p*A-m*x)*V,t[15]=(u*A-h*b+d*x)*V,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,p=r*h,_=o*u,m=o*h,g=a*h,x=l*c,b=l*u,v=l*h,A=i.x,E=i.y,y=i.z;return s[0]=(1-(_+g))*A,s[1]=(f+v)*A,s[2]=(p-b)*A,s[3]=0,s[4]=(f-v)*E,s[5]=(1-(d+g))*E,s[6]=(m+x)*E,s[7]=0,s[8]=(p+b)*y,s[9]=(m-x)*y,s[10]=(1-(d+_))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Hr.set(s[0],s[1],s[2]).length(),a=Hr.set(s[4],s[5],s[6]).length(),l=Hr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ci.copy(this);let c=1/o,u=1/a,h=1/l;return Ci.elements[0]*=c,Ci.elements[1]*=c,Ci.elements[2]*=c,Ci.elements[4]*=u,Ci.elements[5]*=u,Ci.elements[6]*=u,Ci.elements[8]*=h,Ci.elements[9]*=h,Ci.elements[10]*=h,e.setFromRotationMatrix(Ci),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2*r/(e-t),h=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,_;if(l)p=r/(o-r),_=o*r/(o-r);else if(a===vi)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===so)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=vi,l=!1){let c=this.elements,u=2/(e-t),h=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,_;if(l)p=1/(o-r),_=o/(o-r);else if(a===vi)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===so)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Hr=new G,Ci=new ae,Fv=new G(0,0,0),kv=new G(1,1,1),Us=new G,pl=new G,oi=new G,Gp=new ae,Hp=new ui,gs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(pe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-pe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(pe(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-pe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(pe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-pe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Gp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Gp,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Hp.setFromEuler(this),this.setFromQuaternion(Hp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};gs.DEFAULT_ORDER="XYZ";var lo=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Bv=0,Wp=new G,Wr=new ui,cs=new ae,ml=new G,ta=new G,zv=new G,Vv=new ui,$p=new G(1,0,0),Xp=new G(0,1,0),qp=new G(0,0,1),Yp={type:"added"},Gv={type:"removed"},$r={type:"childadded",child:null},Th={type:"childremoved",child:null},Nn=class n extends Ii{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Bv++}),this.uuid=yo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new G,e=new gs,i=new ui,s=new G(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ae},normalMatrix:{value:new te}}),this.matrix=new ae,this.matrixWorld=new ae,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new lo,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.multiply(Wr),this}rotateOnWorldAxis(t,e){return Wr.setFromAxisAngle(t,e),this.quaternion.premultiply(Wr),this}rotateX(t){return this.rotateOnAxis($p,t)}rotateY(t){return this.rotateOnAxis(Xp,t)}rotateZ(t){return this.rotateOnAxis(qp,t)}translateOnAxis(t,e){return Wp.copy(t).applyQuaternion(this.quaternion),this.position.add(Wp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis($p,t)}translateY(t){return this.translateOnAxis(Xp,t)}translateZ(t){return this.translateOnAxis(qp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(cs.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ml.copy(t):ml.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?cs.lookAt(ta,ml,this.up):cs.lookAt(ml,ta,this.up),this.quaternion.setFromRotationMatrix(cs),s&&(cs.extractRotation(s.matrixWorld),Wr.setFromRotationMatrix(cs),this.quaternion.premultiply(Wr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Yp),$r.child=t,this.dispatchEvent($r),$r.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Gv),Th.child=t,this.dispatchEvent(Th),Th.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),cs.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),cs.multiply(t.parent.matrixWorld)),t.applyMatrix4(cs),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Yp),$r.child=t,this.dispatchEvent($r),$r.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,t,zv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ta,Vv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Nn.DEFAULT_UP=new G(0,1,0);Nn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Nn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var kn=class extends Nn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Hv={type:"move"},co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new kn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new kn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new G,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new G),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new kn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new G,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new G,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),g=this._getHandJoint(c,_);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,p=.005;c.inputState.pinching&&d>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Hv)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new kn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},tg={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Fs={h:0,s:0,l:0},gl={h:0,s:0,l:0};function Ch(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Xt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=li){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,xe.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=xe.workingColorSpace){return this.r=t,this.g=e,this.b=i,xe.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=xe.workingColorSpace){if(t=Ad(t,1),e=pe(e,0,1),i=pe(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Ch(o,r,t+1/3),this.g=Ch(o,r,t),this.b=Ch(o,r,t-1/3)}return xe.colorSpaceToWorking(this,s),this}setStyle(t,e=li){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=li){let i=tg[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ps(t.r),this.g=ps(t.g),this.b=ps(t.b),this}copyLinearToSRGB(t){return this.r=no(t.r),this.g=no(t.g),this.b=no(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=li){return xe.workingToColorSpace(Fn.copy(this),t),Math.round(pe(Fn.r*255,0,255))*65536+Math.round(pe(Fn.g*255,0,255))*256+Math.round(pe(Fn.b*255,0,255))}getHexString(t=li){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=xe.workingColorSpace){xe.workingToColorSpace(Fn.copy(this),e);let i=Fn.r,s=Fn.g,r=Fn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=xe.workingColorSpace){return xe.workingToColorSpace(Fn.copy(this),e),t.r=Fn.r,t.g=Fn.g,t.b=Fn.b,t}getStyle(t=li){xe.workingToColorSpace(Fn.copy(this),t);let e=Fn.r,i=Fn.g,s=Fn.b;return t!==li?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Fs),this.setHSL(Fs.h+t,Fs.s+e,Fs.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Fs),t.getHSL(gl);let i=ca(Fs.h,gl.h,e),s=ca(Fs.s,gl.s,e),r=ca(Fs.l,gl.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Fn=new Xt;Xt.NAMES=tg;var ma=class extends Nn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new gs,this.environmentIntensity=1,this.environmentRotation=new gs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ri=new G,us=new G,Rh=new G,hs=new G,Xr=new G,qr=new G,Zp=new G,Ph=new G,Ih=new G,Lh=new G,Nh=new ke,Dh=new ke,Oh=new ke,Vs=class n{constructor(t=new G,e=new G,i=new G){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ri.subVectors(t,e),s.cross(Ri);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ri.subVectors(s,e),us.subVectors(i,e),Rh.subVectors(t,e);let o=Ri.dot(Ri),a=Ri.dot(us),l=Ri.dot(Rh),c=us.dot(us),u=us.dot(Rh),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,p=(o*u-a*l)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,hs)===null?!1:hs.x>=0&&hs.y>=0&&hs.x+hs.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,hs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,hs.x),l.addScaledVector(o,hs.y),l.addScaledVector(a,hs.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Nh.setScalar(0),Dh.setScalar(0),Oh.setScalar(0),Nh.fromBufferAttribute(t,e),Dh.fromBufferAttribute(t,i),Oh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Nh,r.x),o.addScaledVector(Dh,r.y),o.addScaledVector(Oh,r.z),o}static isFrontFacing(t,e,i,s){return Ri.subVectors(i,e),us.subVectors(t,e),Ri.cross(us).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ri.subVectors(this.c,this.b),us.subVectors(this.a,this.b),Ri.cross(us).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Xr.subVectors(s,i),qr.subVectors(r,i),Ph.subVectors(t,i);let l=Xr.dot(Ph),c=qr.dot(Ph);if(l<=0&&c<=0)return e.copy(i);Ih.subVectors(t,s);let u=Xr.dot(Ih),h=qr.dot(Ih);if(u>=0&&h<=u)return e.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),e.copy(i).addScaledVector(Xr,o);Lh.subVectors(t,r);let f=Xr.dot(Lh),p=qr.dot(Lh);if(p>=0&&f<=p)return e.copy(r);let _=f*c-l*p;if(_<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(qr,a);let m=u*p-f*h;if(m<=0&&h-u>=0&&f-p>=0)return Zp.subVectors(r,s),a=(h-u)/(h-u+(f-p)),e.copy(s).addScaledVector(Zp,a);let g=1/(m+_+d);return o=_*g,a=d*g,e.copy(i).addScaledVector(Xr,o).addScaledVector(qr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Yi=class{constructor(t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pi):Pi.fromBufferAttribute(r,o),Pi.applyMatrix4(t.matrixWorld),this.expandByPoint(Pi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),xl.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),xl.copy(i.boundingBox)),xl.applyMatrix4(t.matrixWorld),this.union(xl)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pi),Pi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ea),_l.subVectors(this.max,ea),Yr.subVectors(t.a,ea),Zr.subVectors(t.b,ea),Kr.subVectors(t.c,ea),ks.subVectors(Zr,Yr),Bs.subVectors(Kr,Zr),ur.subVectors(Yr,Kr);let e=[0,-ks.z,ks.y,0,-Bs.z,Bs.y,0,-ur.z,ur.y,ks.z,0,-ks.x,Bs.z,0,-Bs.x,ur.z,0,-ur.x,-ks.y,ks.x,0,-Bs.y,Bs.x,0,-ur.y,ur.x,0];return!Uh(e,Yr,Zr,Kr,_l)||(e=[1,0,0,0,1,0,0,0,1],!Uh(e,Yr,Zr,Kr,_l))?!1:(yl.crossVectors(ks,Bs),e=[yl.x,yl.y,yl.z],Uh(e,Yr,Zr,Kr,_l))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ds[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ds[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ds[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ds[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ds[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ds[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ds[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ds[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ds),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ds=[new G,new G,new G,new G,new G,new G,new G,new G],Pi=new G,xl=new Yi,Yr=new G,Zr=new G,Kr=new G,ks=new G,Bs=new G,ur=new G,ea=new G,_l=new G,yl=new G,hr=new G;function Uh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){hr.fromArray(n,r);let a=s.x*Math.abs(hr.x)+s.y*Math.abs(hr.y)+s.z*Math.abs(hr.z),l=t.dot(hr),c=e.dot(hr),u=i.dot(hr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var mn=new G,vl=new Zt,Wv=0,an=class extends Ii{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Wv++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=qm,this.updateRanges=[],this.gpuType=bi,this.version=0,this._normalizationScale=t!==void 0?Td(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)vl.fromBufferAttribute(this,e),vl.applyMatrix3(t),this.setXY(e,vl.x,vl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix3(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyMatrix4(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.applyNormalMatrix(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)mn.fromBufferAttribute(this,e),mn.transformDirection(t),this.setXYZ(e,mn.x,mn.y,mn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):jm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Qm(t,this.array)}};var ga=class extends an{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var xa=class extends an{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var nn=class extends an{constructor(t,e,i){super(new Float32Array(t),e,i)}},$v=new Yi,na=new G,Fh=new G,xs=class{constructor(t=new G,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):$v.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;na.subVectors(t,this.center);let e=na.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(na,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Fh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(na.copy(t.center).add(Fh)),this.expandByPoint(na.copy(t.center).sub(Fh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Xv=0,yi=new ae,kh=new Nn,Jr=new G,ai=new Yi,ia=new Yi,Pn=new G,yn=class n extends Ii{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Xv++}),this.uuid=yo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(xv(t)?xa:ga)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new te().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return yi.makeRotationFromQuaternion(t),this.applyMatrix4(yi),this}rotateX(t){return yi.makeRotationX(t),this.applyMatrix4(yi),this}rotateY(t){return yi.makeRotationY(t),this.applyMatrix4(yi),this}rotateZ(t){return yi.makeRotationZ(t),this.applyMatrix4(yi),this}translate(t,e,i){return yi.makeTranslation(t,e,i),this.applyMatrix4(yi),this}scale(t,e,i){return yi.makeScale(t,e,i),this.applyMatrix4(yi),this}lookAt(t){return kh.lookAt(t),kh.updateMatrix(),this.applyMatrix4(kh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jr).negate(),this.translate(Jr.x,Jr.y,Jr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new nn(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Yi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new G(-1/0,-1/0,-1/0),new G(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ai.setFromBufferAttribute(r),this.morphTargetsRelative?(Pn.addVectors(this.boundingBox.min,ai.min),this.boundingBox.expandByPoint(Pn),Pn.addVectors(this.boundingBox.max,ai.max),this.boundingBox.expandByPoint(Pn)):(this.boundingBox.expandByPoint(ai.min),this.boundingBox.expandByPoint(ai.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new G,1/0);return}if(t){let i=this.boundingSphere.center;if(ai.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];ia.setFromBufferAttribute(a),this.morphTargetsRelative?(Pn.addVectors(ai.min,ia.min),ai.expandByPoint(Pn),Pn.addVectors(ai.max,ia.max),ai.expandByPoint(Pn)):(ai.expandByPoint(ia.min),ai.expandByPoint(ia.max))}ai.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Pn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Pn));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Pn.fromBufferAttribute(a,c),l&&(Jr.fromBufferAttribute(t,c),Pn.add(Jr)),s=Math.max(s,i.distanceToSquared(Pn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new an(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new G,l[I]=new G;let u=new G,h=new G,d=new G,f=new Zt,p=new Zt,_=new Zt,m=new G,g=new G;function x(I,L,P){c[I]=c[L]=c[P]=1,u.fromBufferAttribute(i,I),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,P),f.fromBufferAttribute(r,I),p.fromBufferAttribute(r,L),_.fromBufferAttribute(r,P),h.sub(u),d.sub(u),p.sub(f),_.sub(f);let N=1/(p.x*_.y-_.x*p.y);isFinite(N)&&(m.copy(h).multiplyScalar(_.y).addScaledVector(d,-p.y).multiplyScalar(N),g.copy(d).multiplyScalar(p.x).addScaledVector(h,-_.x).multiplyScalar(N),a[I].add(m),a[L].add(m),a[P].add(m),l[I].add(g),l[L].add(g),l[P].add(g))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let I=0,L=b.length;I<L;++I){let P=b[I],N=P.start,k=P.count;for(let D=N,V=N+k;D<V;D+=3)x(t.getX(D+0),t.getX(D+1),t.getX(D+2))}let v=new G,A=new G,E=new G,y=new G;function w(I){E.fromBufferAttribute(s,I),y.copy(E);let L=a[I];v.copy(L),v.sub(E.multiplyScalar(E.dot(L))).normalize(),A.crossVectors(y,L);let N=A.dot(l[I])<0?-1:1;o.setXYZW(I,v.x,v.y,v.z,N)}for(let I=0,L=i.count;I<L;++I)c[I]&&w(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new an(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new G,r=new G,o=new G,a=new G,l=new G,c=new G,u=new G,h=new G;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),_=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Pn.fromBufferAttribute(t,e),Pn.normalize(),t.setXYZ(e,Pn.x,Pn.y,Pn.z)}toNonIndexed(){function t(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,p=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?f=l[_]*a.data.stride+a.offset:f=l[_]*u;for(let g=0;g<u;g++)d[p++]=c[f++]}return new an(d,u,h)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=t(d,i);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(e))}let r=t.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Bh=new G,qv=new G,Yv=new te,ci=class{constructor(t=new G(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Bh.subVectors(i,e).cross(qv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Bh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Yv.getNormalMatrix(t),s=this.coplanarPoint(Bh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Zv=0,_s=class extends Ii{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Zv++}),this.uuid=yo(),this.name="",this.type="Material",this.blending=go,this.side=Ks,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=nd,this.blendDst=id,this.blendEquation=xr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Xt(0,0,0),this.blendAlpha=0,this.depthFunc=io,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Vm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=kl,this.stencilZFail=kl,this.stencilZPass=kl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Xt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ci().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Zt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Zt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var fs=new G,zh=new G,bl=new G,Sl=new G,Gs=class{constructor(t=new G,e=new G(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,fs)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=fs.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(fs.copy(this.origin).addScaledVector(this.direction,e),fs.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){zh.copy(t).add(e).multiplyScalar(.5),bl.copy(e).sub(t).normalize(),Sl.copy(this.origin).sub(zh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(bl),a=Sl.dot(this.direction),l=-Sl.dot(bl),c=Sl.lengthSq(),u=Math.abs(1-o*o),h,d,f,p;if(u>0)if(h=o*l-a,d=o*a-l,p=r*u,h>=0)if(d>=-p)if(d<=p){let _=1/u;h*=_,d*=_,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-p?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=p?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(zh).addScaledVector(bl,d),f}intersectSphere(t,e){if(t.radius<0)return null;fs.subVectors(t.center,this.origin);let i=fs.dot(this.direction),s=fs.dot(fs)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),u>=0?(r=(t.min.y-d.y)*u,o=(t.max.y-d.y)*u):(r=(t.max.y-d.y)*u,o=(t.min.y-d.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-d.z)*h,l=(t.max.z-d.z)*h):(a=(t.max.z-d.z)*h,l=(t.min.z-d.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,fs)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,_=e.y-o.y,m=e.z-o.z,g=i.x-o.x,x=i.y-o.y,b=i.z-o.z,v=Math.abs(l),A=Math.abs(c),E=Math.abs(u),y,w,I,L,P,N,k,D,V,X,W,ot;if(v>=A&&v>=E?(I=l,N=h,V=p,ot=g,l>=0?(y=c,w=u,L=d,P=f,k=_,D=m,X=x,W=b):(y=u,w=c,L=f,P=d,k=m,D=_,X=b,W=x)):A>=E?(I=c,N=d,V=_,ot=x,c>=0?(y=u,w=l,L=f,P=h,k=m,D=p,X=b,W=g):(y=l,w=u,L=h,P=f,k=p,D=m,X=g,W=b)):(I=u,N=f,V=m,ot=b,u>=0?(y=l,w=c,L=h,P=d,k=p,D=_,X=g,W=x):(y=c,w=l,L=d,P=h,k=_,D=p,X=x,W=g)),I===0)return null;let Z=y/I,Q=w/I,it=1/I,ft=L-Z*N,dt=P-Q*N,tt=k-Z*V,ht=D-Q*V,gt=X-Z*ot,St=W-Q*ot,Mt=gt*ht-St*tt,Ht=ft*St-dt*gt,se=tt*dt-ht*ft;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let he=it*(Mt*N+Ht*V+se*ot);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},pr=class extends _s{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gs,this.combine=xc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Kp=new ae,dr=new Gs,Ml=new xs,Jp=new G,wl=new G,Al=new G,El=new G,Vh=new G,Tl=new G,jp=new G,Cl=new G,Dn=class extends Nn{constructor(t=new yn,e=new pr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Tl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Vh.fromBufferAttribute(h,t),o?Tl.addScaledVector(Vh,u):Tl.addScaledVector(Vh.sub(e),u))}e.add(Tl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ml.copy(i.boundingSphere),Ml.applyMatrix4(r),dr.copy(t.ray).recast(t.near),!(Ml.containsPoint(dr.origin)===!1&&(dr.intersectSphere(Ml,Jp)===null||dr.origin.distanceToSquared(Jp)>(t.far-t.near)**2))&&(Kp.copy(r).invert(),dr.copy(t.ray).applyMatrix4(Kp),!(i.boundingBox!==null&&dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,dr)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),b=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=b;v<A;v+=3){let E=a.getX(v),y=a.getX(v+1),w=a.getX(v+2);s=Rl(this,g,t,i,c,u,h,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=a.getX(m),b=a.getX(m+1),v=a.getX(m+2);s=Rl(this,o,t,i,c,u,h,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,_=d.length;p<_;p++){let m=d[p],g=o[m.materialIndex],x=Math.max(m.start,f.start),b=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let v=x,A=b;v<A;v+=3){let E=v,y=v+1,w=v+2;s=Rl(this,g,t,i,c,u,h,E,y,w),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(l.count,f.start+f.count);for(let m=p,g=_;m<g;m+=3){let x=m,b=m+1,v=m+2;s=Rl(this,o,t,i,c,u,h,x,b,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function Kv(n,t,e,i,s,r,o,a){let l;if(t.side===Kn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ks,a),l===null)return null;Cl.copy(a),Cl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Cl);return c<e.near||c>e.far?null:{distance:c,point:Cl.clone(),object:n}}function Rl(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,wl),n.getVertexPosition(l,Al),n.getVertexPosition(c,El);let u=Kv(n,t,e,i,wl,Al,El,jp);if(u){let h=new G;Vs.getBarycoord(jp,wl,Al,El,h),s&&(u.uv=Vs.getInterpolatedAttribute(s,a,l,c,h,new Zt)),r&&(u.uv1=Vs.getInterpolatedAttribute(r,a,l,c,h,new Zt)),o&&(u.normal=Vs.getInterpolatedAttribute(o,a,l,c,h,new G),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new G,materialIndex:0};Vs.getNormal(wl,Al,El,d.normal),u.face=d,u.barycoord=h}return u}var _a=class extends jn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=In,u=In,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ya=class extends an{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},jr=new ae,Qp=new ae,Pl=[],tm=new Yi,Jv=new ae,sa=new Dn,ra=new xs,di=class extends Dn{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ya(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Jv)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Yi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,jr),tm.copy(t.boundingBox).applyMatrix4(jr),this.boundingBox.union(tm)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new xs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,jr),ra.copy(t.boundingSphere).applyMatrix4(jr),this.boundingSphere.union(ra)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(sa.geometry=this.geometry,sa.material=this.material,sa.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ra.copy(this.boundingSphere),ra.applyMatrix4(i),t.ray.intersectsSphere(ra)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,jr),Qp.multiplyMatrices(i,jr),sa.matrixWorld=Qp,sa.raycast(t,Pl);for(let o=0,a=Pl.length;o<a;o++){let l=Pl[o];l.instanceId=r,l.object=this,e.push(l)}Pl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new ya(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new _a(new Float32Array(s*this.count),s,this.count,wc,bi));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},fr=new xs,jv=new Zt(.5,.5),Il=new G,Hs=class{constructor(t=new ci,e=new ci,i=new ci,s=new ci,r=new ci,o=new ci){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=vi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],p=r[8],_=r[9],m=r[10],g=r[11],x=r[12],b=r[13],v=r[14],A=r[15];if(s[0].setComponents(c-o,f-u,g-p,A-x).normalize(),s[1].setComponents(c+o,f+u,g+p,A+x).normalize(),s[2].setComponents(c+a,f+h,g+_,A+b).normalize(),s[3].setComponents(c-a,f-h,g-_,A-b).normalize(),i)s[4].setComponents(l,d,m,v).normalize(),s[5].setComponents(c-l,f-d,g-m,A-v).normalize();else if(s[4].setComponents(c-l,f-d,g-m,A-v).normalize(),e===vi)s[5].setComponents(c+l,f+d,g+m,A+v).normalize();else if(e===so)s[5].setComponents(l,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),fr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),fr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(fr)}intersectsSprite(t){fr.center.set(0,0,0);let e=jv.distanceTo(t.center);return fr.radius=.7071067811865476+e,fr.applyMatrix4(t.matrixWorld),this.intersectsSphere(fr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Il.x=s.normal.x>0?t.max.x:t.min.x,Il.y=s.normal.y>0?t.max.y:t.min.y,Il.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Il)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},em=new ae,jl=class n{constructor(){this.coordinateSystem=vi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];em.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Hs),i[s].setFromProjectionMatrix(em,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Hs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Ws=class extends _s{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ql=new G,tc=new G,nm=new ae,oa=new Gs,Ll=new xs,Gh=new G,im=new G,ec=class extends Nn{constructor(t=new yn,e=new Ws){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ql.fromBufferAttribute(e,s-1),tc.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ql.distanceTo(tc);t.setAttribute("lineDistance",new nn(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ll.copy(i.boundingSphere),Ll.applyMatrix4(s),Ll.radius+=r,t.ray.intersectsSphere(Ll)===!1)return;nm.copy(s).invert(),oa.copy(t.ray).applyMatrix4(nm);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,d=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=u.getX(_),x=u.getX(_+1),b=Nl(this,t,oa,l,g,x,_);b&&e.push(b)}if(this.isLineLoop){let _=u.getX(p-1),m=u.getX(f),g=Nl(this,t,oa,l,_,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let _=f,m=p-1;_<m;_+=c){let g=Nl(this,t,oa,l,_,_+1,_);g&&e.push(g)}if(this.isLineLoop){let _=Nl(this,t,oa,l,p-1,f,p-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Nl(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ql.fromBufferAttribute(a,s),tc.fromBufferAttribute(a,r),e.distanceSqToSegment(Ql,tc,Gh,im)>i)return;Gh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Gh);if(!(c<t.near||c>t.far))return{distance:c,point:im.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var sm=new G,rm=new G,mr=class extends ec{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)sm.fromBufferAttribute(e,s),rm.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+sm.distanceTo(rm);t.setAttribute("lineDistance",new nn(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var va=class extends jn{constructor(t=[],e=_r,i,s,r,o,a,l,c,u){super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var ys=class extends jn{constructor(t,e,i=Li,s,r,o,a=In,l=In,c,u=ms,h=1){if(u!==ms&&u!==Ss)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:h};super(d,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ao(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ba=class extends ys{constructor(t,e=Li,i=_r,s,r,o=In,a=In,l,c=ms){let u={width:t,height:t,depth:1},h=[u,u,u,u,u,u];super(t,t,e,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Sa=class extends jn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},uo=class n extends yn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new nn(c,3)),this.setAttribute("normal",new nn(u,3)),this.setAttribute("uv",new nn(h,2));function p(_,m,g,x,b,v,A,E,y,w,I){let L=v/y,P=A/w,N=v/2,k=A/2,D=E/2,V=y+1,X=w+1,W=0,ot=0,Z=new G;for(let Q=0;Q<X;Q++){let it=Q*P-k;for(let ft=0;ft<V;ft++){let dt=ft*L-N;Z[_]=dt*x,Z[m]=it*b,Z[g]=D,c.push(Z.x,Z.y,Z.z),Z[_]=0,Z[m]=0,Z[g]=E>0?1:-1,u.push(Z.x,Z.y,Z.z),h.push(ft/y),h.push(1-Q/w),W+=1}}for(let Q=0;Q<w;Q++)for(let it=0;it<y;it++){let ft=d+it+V*Q,dt=d+it+V*(Q+1),tt=d+(it+1)+V*(Q+1),ht=d+(it+1)+V*Q;l.push(ft,dt,ht),l.push(dt,tt,ht),ot+=6}a.addGroup(f,ot,I),f+=ot,d+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Zi=class n extends yn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],p=0,_=[],m=i/2,g=0;x(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(u),this.setAttribute("position",new nn(h,3)),this.setAttribute("normal",new nn(d,3)),this.setAttribute("uv",new nn(f,2));function x(){let v=new G,A=new G,E=0,y=(e-t)/i;for(let w=0;w<=r;w++){let I=[],L=w/r,P=L*(e-t)+t;for(let N=0;N<=s;N++){let k=N/s,D=k*l+a,V=Math.sin(D),X=Math.cos(D);A.x=P*V,A.y=-L*i+m,A.z=P*X,h.push(A.x,A.y,A.z),v.set(V,y,X).normalize(),d.push(v.x,v.y,v.z),f.push(k,1-L),I.push(p++)}_.push(I)}for(let w=0;w<s;w++)for(let I=0;I<r;I++){let L=_[I][w],P=_[I+1][w],N=_[I+1][w+1],k=_[I][w+1];(t>0||I!==0)&&(u.push(L,P,k),E+=3),(e>0||I!==r-1)&&(u.push(P,N,k),E+=3)}c.addGroup(g,E,0),g+=E}function b(v){let A=p,E=new Zt,y=new G,w=0,I=v===!0?t:e,L=v===!0?1:-1;for(let N=1;N<=s;N++)h.push(0,m*L,0),d.push(0,L,0),f.push(.5,.5),p++;let P=p;for(let N=0;N<=s;N++){let D=N/s*l+a,V=Math.cos(D),X=Math.sin(D);y.x=I*X,y.y=m*L,y.z=I*V,h.push(y.x,y.y,y.z),d.push(0,L,0),E.x=V*.5+.5,E.y=X*.5*L+.5,f.push(E.x,E.y),p++}for(let N=0;N<s;N++){let k=A+N,D=P+N;v===!0?u.push(D,D+1,k):u.push(D+1,D,k),w+=3}c.addGroup(g,w,v===!0?1:2),g+=w}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ma=class n extends Zi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var wa=class n extends yn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,d=e/l,f=[],p=[],_=[],m=[];for(let g=0;g<u;g++){let x=g*d-o;for(let b=0;b<c;b++){let v=b*h-r;p.push(v,-x,0),_.push(0,0,1),m.push(b/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let b=x+c*g,v=x+c*(g+1),A=x+1+c*(g+1),E=x+1+c*g;f.push(b,v,E),f.push(v,A,E)}this.setIndex(f),this.setAttribute("position",new nn(p,3)),this.setAttribute("normal",new nn(_,3)),this.setAttribute("uv",new nn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ho=class n extends yn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new G,d=new G,f=[],p=[],_=[],m=[];for(let g=0;g<=i;g++){let x=[],b=g/i,v=o+b*a,A=t*Math.cos(v),E=Math.sqrt(t*t-A*A),y=0;g===0&&o===0?y=.5/e:g===i&&l===Math.PI&&(y=-.5/e);for(let w=0;w<=e;w++){let I=w/e,L=s+I*r;h.x=-E*Math.cos(L),h.y=A,h.z=E*Math.sin(L),p.push(h.x,h.y,h.z),d.copy(h).normalize(),_.push(d.x,d.y,d.z),m.push(I+y,1-b),x.push(c++)}u.push(x)}for(let g=0;g<i;g++)for(let x=0;x<e;x++){let b=u[g][x+1],v=u[g][x],A=u[g+1][x],E=u[g+1][x+1];(g!==0||o>0)&&f.push(b,v,E),(g!==i-1||l<Math.PI)&&f.push(v,A,E)}this.setIndex(f),this.setAttribute("position",new nn(p,3)),this.setAttribute("normal",new nn(_,3)),this.setAttribute("uv",new nn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function vr(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(om(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(om(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function zn(n){let t={};for(let e=0;e<n.length;e++){let i=vr(n[e]);for(let s in i)t[s]=i[s]}return t}function om(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Qv(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Rd(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:xe.workingColorSpace}var eg={clone:vr,merge:zn},tb=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,eb=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ki=class extends _s{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tb,this.fragmentShader=eb,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=vr(t.uniforms),this.uniformsGroups=Qv(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Zt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new G().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ke().fromArray(s.value);break;case"m3":this.uniforms[i].value=new te().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ae().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},nc=class extends Ki{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var vs=class extends _s{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Xt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=su,this.normalScale=new Zt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new gs,this.combine=xc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},ic=class extends _s{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Bm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},sc=class extends _s{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Qr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Dl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var $s=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},rc=class extends $s{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:$h,endingEnd:$h}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Xh:r=t,a=2*e-i;break;case qh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Xh:o=t,l=2*i-e;break;case qh:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,u=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),_=p*p,m=_*p,g=-d*m+2*d*_-d*p,x=(1+d)*m+(-1.5-2*d)*_+(-.5+d)*p+1,b=(-1-f)*m+(1.5+f)*_+.5*p,v=f*m-f*_;for(let A=0;A!==a;++A)r[A]=g*o[u+A]+x*o[c+A]+b*o[l+A]+v*o[h+A];return r}},oc=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=(i-e)/(s-e),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},ac=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},lc=class extends $s{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-e)/(s-e),_=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let _=o[c+p],m=o[l+p],g=f*d+p*2,x=h[g],b=h[g+1],v=t*d+p*2,A=u[v],E=u[v+1],y=ib(i,e,x,A,s);r[p]=ng(y,_,b,E,m)}return r}};function ng(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function nb(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function ib(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=ng(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=nb(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var fi=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Qr(e,this.TimeBufferType),this.values=Qr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Qr(t.times,Array),values:Qr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Dl(t.settings)&&(i.settings={inTangents:Qr(t.settings.inTangents,Array),outTangents:Qr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new ac(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new oc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new rc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new lc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case ua:e=this.InterpolantFactoryMethodDiscrete;break;case Yl:e=this.InterpolantFactoryMethodLinear;break;case Fl:e=this.InterpolantFactoryMethodSmooth;break;case Wh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ua;case this.InterpolantFactoryMethodLinear:return Yl;case this.InterpolantFactoryMethodSmooth:return Fl;case this.InterpolantFactoryMethodBezier:return Wh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Dl(this.settings)&&(am(this.settings.inTangents,t),am(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Dl(this.settings)&&(lm(this.settings.inTangents,t),lm(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Qt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Qt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&_v(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Fl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],u=t[a+1];if(c!==u&&(a!==1||c!==t[0]))if(s)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let p=0;p!==i;++p){let _=e[h+p];if(_!==e[d+p]||_!==e[f+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[h+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Dl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function am(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function lm(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}fi.prototype.ValueTypeName="";fi.prototype.TimeBufferType=Float32Array;fi.prototype.ValueBufferType=Float32Array;fi.prototype.DefaultInterpolation=Yl;var Xs=class extends fi{constructor(t,e,i){super(t,e,i)}};Xs.prototype.ValueTypeName="bool";Xs.prototype.ValueBufferType=Array;Xs.prototype.DefaultInterpolation=ua;Xs.prototype.InterpolantFactoryMethodLinear=void 0;Xs.prototype.InterpolantFactoryMethodSmooth=void 0;var cc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};cc.prototype.ValueTypeName="color";var uc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};uc.prototype.ValueTypeName="number";var hc=class extends $s{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let u=c+a;c!==u;c+=4)ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Aa=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new hc(this.times,this.values,this.getValueSize(),t)}};Aa.prototype.ValueTypeName="quaternion";Aa.prototype.InterpolantFactoryMethodSmooth=void 0;var qs=class extends fi{constructor(t,e,i){super(t,e,i)}};qs.prototype.ValueTypeName="string";qs.prototype.ValueBufferType=Array;qs.prototype.DefaultInterpolation=ua;qs.prototype.InterpolantFactoryMethodLinear=void 0;qs.prototype.InterpolantFactoryMethodSmooth=void 0;var dc=class extends fi{constructor(t,e,i,s){super(t,e,i,s)}};dc.prototype.ValueTypeName="vector";var fc=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],p=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ig=new fc,pc=class{constructor(t){this.manager=t!==void 0?t:ig,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};pc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ea=class extends Nn{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Xt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},Ta=class extends Ea{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Xt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Hh=new ae,cm=new G,um=new G,mc=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Zt(512,512),this.mapType=Qn,this.map=null,this.mapPass=null,this.matrix=new ae,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Hs,this._frameExtents=new Zt(1,1),this._viewportCount=1,this._viewports=[new ke(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;cm.setFromMatrixPosition(t.matrixWorld),e.position.copy(cm),um.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(um),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Hh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Hh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===so||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Hh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Ol=new G,Ul=new ui,Xi=new G,Ca=class extends Nn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ae,this.projectionMatrix=new ae,this.projectionMatrixInverse=new ae,this.coordinateSystem=vi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Ol,Ul,Xi),Xi.x===1&&Xi.y===1&&Xi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Ul,Xi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Ol,Ul,Xi),Xi.x===1&&Xi.y===1&&Xi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Ol,Ul,Xi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},zs=new G,hm=new Zt,dm=new Zt,Yn=class extends Ca{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=oo*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(la*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return oo*2*Math.atan(Math.tan(la*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){zs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(zs.x,zs.y).multiplyScalar(-t/zs.z),zs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(zs.x,zs.y).multiplyScalar(-t/zs.z)}getViewSize(t,e){return this.getViewBounds(t,hm,dm),e.subVectors(dm,hm)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(la*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Ra=class extends Ca{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Yh=class extends mc{constructor(){super(new Ra(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Pa=class extends Ea{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Nn.DEFAULT_UP),this.updateMatrix(),this.target=new Nn,this.shadow=new Yh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var to=-90,eo=1,fo=class extends Nn{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Yn(to,eo,t,e);s.layers=this.layers,this.add(s);let r=new Yn(to,eo,t,e);r.layers=this.layers,this.add(r);let o=new Yn(to,eo,t,e);o.layers=this.layers,this.add(o);let a=new Yn(to,eo,t,e);a.layers=this.layers,this.add(a);let l=new Yn(to,eo,t,e);l.layers=this.layers,this.add(l);let c=new Yn(to,eo,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===vi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===so)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,u),t.setRenderTarget(h,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},gc=class extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Pd="\\[\\]\\.:\\/",sb=new RegExp("["+Pd+"]","g"),Id="[^"+Pd+"]",rb="[^"+Pd.replace("\\.","")+"]",ob=/((?:WC+[\/:])*)/.source.replace("WC",Id),ab=/(WCOD+)?/.source.replace("WCOD",rb),lb=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Id),cb=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Id),ub=new RegExp("^"+ob+ab+lb+cb+"$"),hb=["material","materials","bones","map"],Zh=class{constructor(t,e,i){let s=i||Xe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Xe=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(sb,"")}static parseTrackName(t){let e=ub.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);hb.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let u=0;u<t.length;u++)if(t[u].name===c){c=u;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xe.Composite=Zh;Xe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xe.prototype.GetterByBindingType=[Xe.prototype._getValue_direct,Xe.prototype._getValue_array,Xe.prototype._getValue_arrayElement,Xe.prototype._getValue_toArray];Xe.prototype.SetterByBindingTypeAndVersioning=[[Xe.prototype._setValue_direct,Xe.prototype._setValue_direct_setNeedsUpdate,Xe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_array,Xe.prototype._setValue_array_setNeedsUpdate,Xe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_arrayElement,Xe.prototype._setValue_arrayElement_setNeedsUpdate,Xe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xe.prototype._setValue_fromArray,Xe.prototype._setValue_fromArray_setNeedsUpdate,Xe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var nI=new Float32Array(1);var fm=new ae,Ia=class{constructor(t,e,i=0,s=1/0){this.ray=new Gs(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new lo,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Qt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return fm.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(fm),this}intersectObject(t,e=!0,i=[]){return Kh(t,this,i,e),i.sort(pm),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)Kh(t[s],this,i,e);return i.sort(pm),i}};function pm(n,t){return n.distance-t.distance}function Kh(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)Kh(r[o],t,e,!0)}}var po=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=pe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(pe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Jh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var La=class extends Ii{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ld(n,t,e,i){let s=db(i);switch(e){case gd:return n*t;case wc:return n*t/s.components*s.byteLength;case Ac:return n*t/s.components*s.byteLength;case Js:return n*t*2/s.components*s.byteLength;case Ec:return n*t*2/s.components*s.byteLength;case xd:return n*t*3/s.components*s.byteLength;case Di:return n*t*4/s.components*s.byteLength;case Tc:return n*t*4/s.components*s.byteLength;case Oa:case Ua:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Fa:case ka:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Rc:case Ic:return Math.max(n,16)*Math.max(t,8)/4;case Cc:case Pc:return Math.max(n,8)*Math.max(t,8)/2;case Lc:case Nc:case Oc:case Uc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Dc:case Ba:case Fc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case kc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Bc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case zc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Vc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Gc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Hc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Wc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case $c:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Xc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case qc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Yc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Zc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Kc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Jc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case jc:case Qc:case tu:return Math.ceil(n/4)*Math.ceil(t/4)*16;case eu:case nu:return Math.ceil(n/4)*Math.ceil(t/4)*8;case za:case iu:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function db(n){switch(n){case Qn:case dd:return{byteLength:1,components:1};case _o:case fd:case Ni:return{byteLength:2,components:1};case Sc:case Mc:return{byteLength:2,components:4};case Li:case bc:case bi:return{byteLength:4,components:1};case pd:case md:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ag(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function pb(n){let t=new WeakMap;function e(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<h.length;f++){let p=h[d],_=h[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++d,h[d]=_)}h.length=d+1;for(let f=0,p=h.length;f<p;f++){let _=h[f];n.bufferSubData(c,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var mb=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,gb=`#ifdef USE_ALPHAHASH
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
#endif`,xb=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,_b=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,yb=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,vb=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,bb=`#ifdef USE_AOMAP
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
#endif`,Sb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Mb=`#ifdef USE_BATCHING
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
#endif`,wb=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Ab=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Eb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Tb=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Cb=`#ifdef USE_IRIDESCENCE
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
#endif`,Rb=`#ifdef USE_BUMPMAP
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
#endif`,Pb=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Ib=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Lb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Nb=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Db=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Ob=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Ub=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Fb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,kb=`#define PI 3.141592653589793
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
} // validated`,Bb=`vec3 transformedNormal = objectNormal;
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
#endif`,zb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Vb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Gb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Hb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Wb="gl_FragColor = linearToOutputTexel( gl_FragColor );",$b=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Xb=`#ifdef USE_ENVMAP
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
#endif`,qb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Yb=`#ifdef USE_ENVMAP
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
#endif`,Zb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Kb=`#ifdef USE_ENVMAP
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
#endif`,Jb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,jb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Qb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,tS=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,eS=`#ifdef USE_GRADIENTMAP
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
}`,nS=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,iS=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,sS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,rS=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,oS=`#ifdef USE_ENVMAP
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
#endif`,aS=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,lS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,cS=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,uS=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,hS=`PhysicalMaterial material;
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
#endif`,dS=`uniform sampler2D dfgLUT;
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
}`,fS=`
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
#endif`,pS=`#if defined( RE_IndirectDiffuse )
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
#endif`,mS=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,gS=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,xS=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,_S=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,yS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,vS=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,bS=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,SS=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,MS=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,wS=`#if defined( USE_POINTS_UV )
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
#endif`,AS=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ES=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,TS=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,CS=`#if defined( USE_MORPHCOLORS )
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
#endif`,RS=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,PS=`#ifdef USE_MORPHTARGETS
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
#endif`,IS=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,LS=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,NS=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,DS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,OS=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,US=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,FS=`#ifdef USE_NORMALMAP
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
#endif`,kS=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,BS=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,zS=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,VS=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,GS=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,HS=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,WS=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$S=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,XS=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,qS=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,YS=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ZS=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,KS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,JS=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,jS=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,QS=`float getShadowMask() {
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
}`,tM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,eM=`#ifdef USE_SKINNING
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
#endif`,nM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,iM=`#ifdef USE_SKINNING
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
#endif`,sM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,rM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,oM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,aM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,lM=`#ifdef USE_TRANSMISSION
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
#endif`,cM=`#ifdef USE_TRANSMISSION
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
#endif`,uM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,hM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,pM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,mM=`uniform sampler2D t2D;
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
}`,gM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xM=`uniform float backgroundBlurriness;
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
}`,_M=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,yM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vM=`#include <common>
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
}`,bM=`#if DEPTH_PACKING == 3200
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
}`,SM=`#define DISTANCE
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
}`,MM=`#define DISTANCE
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
}`,wM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,AM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,EM=`uniform float scale;
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
}`,TM=`uniform vec3 diffuse;
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
}`,CM=`#include <common>
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
}`,RM=`uniform vec3 diffuse;
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
}`,PM=`#define LAMBERT
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
}`,IM=`#define LAMBERT
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
}`,LM=`#define MATCAP
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
}`,NM=`#define MATCAP
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
}`,DM=`#define NORMAL
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
}`,OM=`#define NORMAL
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
}`,UM=`#define PHONG
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
}`,FM=`#define PHONG
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
}`,kM=`#define STANDARD
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
}`,BM=`#define STANDARD
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
}`,zM=`#define TOON
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
}`,VM=`#define TOON
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
}`,GM=`uniform float size;
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
}`,HM=`uniform vec3 diffuse;
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
}`,WM=`#include <common>
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
}`,$M=`uniform vec3 color;
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
}`,XM=`uniform float rotation;
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
}`,qM=`uniform vec3 diffuse;
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
}`,ue={alphahash_fragment:mb,alphahash_pars_fragment:gb,alphamap_fragment:xb,alphamap_pars_fragment:_b,alphatest_fragment:yb,alphatest_pars_fragment:vb,aomap_fragment:bb,aomap_pars_fragment:Sb,batching_pars_vertex:Mb,batching_vertex:wb,begin_vertex:Ab,beginnormal_vertex:Eb,bsdfs:Tb,iridescence_fragment:Cb,bumpmap_pars_fragment:Rb,clipping_planes_fragment:Pb,clipping_planes_pars_fragment:Ib,clipping_planes_pars_vertex:Lb,clipping_planes_vertex:Nb,color_fragment:Db,color_pars_fragment:Ob,color_pars_vertex:Ub,color_vertex:Fb,common:kb,defaultnormal_vertex:Bb,displacementmap_pars_vertex:zb,displacementmap_vertex:Vb,emissivemap_fragment:Gb,emissivemap_pars_fragment:Hb,colorspace_fragment:Wb,colorspace_pars_fragment:$b,envmap_fragment:Xb,envmap_common_pars_fragment:qb,envmap_pars_fragment:Yb,envmap_pars_vertex:Zb,envmap_physical_pars_fragment:oS,envmap_vertex:Kb,fog_vertex:Jb,fog_pars_vertex:jb,fog_fragment:Qb,fog_pars_fragment:tS,gradientmap_pars_fragment:eS,lightmap_pars_fragment:nS,lights_lambert_fragment:iS,lights_lambert_pars_fragment:sS,lights_pars_begin:rS,lights_toon_fragment:aS,lights_toon_pars_fragment:lS,lights_phong_fragment:cS,lights_phong_pars_fragment:uS,lights_physical_fragment:hS,lights_physical_pars_fragment:dS,lights_fragment_begin:fS,lights_fragment_maps:pS,lights_fragment_end:mS,lightprobes_pars_fragment:gS,logdepthbuf_fragment:xS,logdepthbuf_pars_fragment:_S,logdepthbuf_pars_vertex:yS,logdepthbuf_vertex:vS,map_fragment:bS,map_pars_fragment:SS,map_particle_fragment:MS,map_particle_pars_fragment:wS,metalnessmap_fragment:AS,metalnessmap_pars_fragment:ES,morphinstance_vertex:TS,morphcolor_vertex:CS,morphnormal_vertex:RS,morphtarget_pars_vertex:PS,morphtarget_vertex:IS,normal_fragment_begin:LS,normal_fragment_maps:NS,normal_pars_fragment:DS,normal_pars_vertex:OS,normal_vertex:US,normalmap_pars_fragment:FS,clearcoat_normal_fragment_begin:kS,clearcoat_normal_fragment_maps:BS,clearcoat_pars_fragment:zS,iridescence_pars_fragment:VS,opaque_fragment:GS,packing:HS,premultiplied_alpha_fragment:WS,project_vertex:$S,dithering_fragment:XS,dithering_pars_fragment:qS,roughnessmap_fragment:YS,roughnessmap_pars_fragment:ZS,shadowmap_pars_fragment:KS,shadowmap_pars_vertex:JS,shadowmap_vertex:jS,shadowmask_pars_fragment:QS,skinbase_vertex:tM,skinning_pars_vertex:eM,skinning_vertex:nM,skinnormal_vertex:iM,specularmap_fragment:sM,specularmap_pars_fragment:rM,tonemapping_fragment:oM,tonemapping_pars_fragment:aM,transmission_fragment:lM,transmission_pars_fragment:cM,uv_pars_fragment:uM,uv_pars_vertex:hM,uv_vertex:dM,worldpos_vertex:fM,background_vert:pM,background_frag:mM,backgroundCube_vert:gM,backgroundCube_frag:xM,cube_vert:_M,cube_frag:yM,depth_vert:vM,depth_frag:bM,distance_vert:SM,distance_frag:MM,equirect_vert:wM,equirect_frag:AM,linedashed_vert:EM,linedashed_frag:TM,meshbasic_vert:CM,meshbasic_frag:RM,meshlambert_vert:PM,meshlambert_frag:IM,meshmatcap_vert:LM,meshmatcap_frag:NM,meshnormal_vert:DM,meshnormal_frag:OM,meshphong_vert:UM,meshphong_frag:FM,meshphysical_vert:kM,meshphysical_frag:BM,meshtoon_vert:zM,meshtoon_frag:VM,points_vert:GM,points_frag:HM,shadow_vert:WM,shadow_frag:$M,sprite_vert:XM,sprite_frag:qM},Lt={common:{diffuse:{value:new Xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new te}},envmap:{envMap:{value:null},envMapRotation:{value:new te},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new te}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new te}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new te},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new te},normalScale:{value:new Zt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new te},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new te}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new te}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new te}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0},uvTransform:{value:new te}},sprite:{diffuse:{value:new Xt(16777215)},opacity:{value:1},center:{value:new Zt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new te},alphaMap:{value:null},alphaMapTransform:{value:new te},alphaTest:{value:0}}},Qi={basic:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ue.meshbasic_vert,fragmentShader:ue.meshbasic_frag},lambert:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Xt(0)},envMapIntensity:{value:1}}]),vertexShader:ue.meshlambert_vert,fragmentShader:ue.meshlambert_frag},phong:{uniforms:zn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Xt(0)},specular:{value:new Xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ue.meshphong_vert,fragmentShader:ue.meshphong_frag},standard:{uniforms:zn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag},toon:{uniforms:zn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Xt(0)}}]),vertexShader:ue.meshtoon_vert,fragmentShader:ue.meshtoon_frag},matcap:{uniforms:zn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ue.meshmatcap_vert,fragmentShader:ue.meshmatcap_frag},points:{uniforms:zn([Lt.points,Lt.fog]),vertexShader:ue.points_vert,fragmentShader:ue.points_frag},dashed:{uniforms:zn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ue.linedashed_vert,fragmentShader:ue.linedashed_frag},depth:{uniforms:zn([Lt.common,Lt.displacementmap]),vertexShader:ue.depth_vert,fragmentShader:ue.depth_frag},normal:{uniforms:zn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ue.meshnormal_vert,fragmentShader:ue.meshnormal_frag},sprite:{uniforms:zn([Lt.sprite,Lt.fog]),vertexShader:ue.sprite_vert,fragmentShader:ue.sprite_frag},background:{uniforms:{uvTransform:{value:new te},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ue.background_vert,fragmentShader:ue.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new te}},vertexShader:ue.backgroundCube_vert,fragmentShader:ue.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ue.cube_vert,fragmentShader:ue.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ue.equirect_vert,fragmentShader:ue.equirect_frag},distance:{uniforms:zn([Lt.common,Lt.displacementmap,{referencePosition:{value:new G},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ue.distance_vert,fragmentShader:ue.distance_frag},shadow:{uniforms:zn([Lt.lights,Lt.fog,{color:{value:new Xt(0)},opacity:{value:1}}]),vertexShader:ue.shadow_vert,fragmentShader:ue.shadow_frag}};Qi.physical={uniforms:zn([Qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new te},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new te},clearcoatNormalScale:{value:new Zt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new te},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new te},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new te},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new te},sheen:{value:0},sheenColor:{value:new Xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new te},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new te},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new te},transmissionSamplerSize:{value:new Zt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new te},attenuationDistance:{value:0},attenuationColor:{value:new Xt(0)},specularColor:{value:new Xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new te},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new te},anisotropyVector:{value:new Zt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new te}}]),vertexShader:ue.meshphysical_vert,fragmentShader:ue.meshphysical_frag};var ru={r:0,b:0,g:0},YM=new ae,Eg=new te;Eg.set(-1,0,0,0,1,0,0,0,1);function ZM(n,t,e,i,s,r){let o=new Xt(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(x){let b=x.isScene===!0?x.background:null;if(b&&b.isTexture){let v=x.backgroundBlurriness>0;b=t.get(b,v)}return b}function p(x){let b=!1,v=f(x);v===null?m(o,a):v&&v.isColor&&(m(v,1),b=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,b){let v=f(b);v&&v.isCubeTexture?(c===void 0&&(c=new Dn(new uo(1,1,1),new Ki({name:"BackgroundCubeMaterial",uniforms:vr(Qi.backgroundCube.uniforms),vertexShader:Qi.backgroundCube.vertexShader,fragmentShader:Qi.backgroundCube.fragmentShader,side:Kn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(YM.makeRotationFromEuler(b.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Eg),c.material.toneMapped=xe.getTransfer(v.colorSpace)!==Te,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Dn(new wa(2,2),new Ki({name:"BackgroundMaterial",uniforms:vr(Qi.background.uniforms),vertexShader:Qi.background.vertexShader,fragmentShader:Qi.background.fragmentShader,side:Ks,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.toneMapped=xe.getTransfer(v.colorSpace)!==Te,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function m(x,b){x.getRGB(ru,Rd(n)),e.buffers.color.setClear(ru.r,ru.g,ru.b,b,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,b=1){o.set(x),a=b,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,m(o,a)},render:p,addToRenderList:_,dispose:g}}function KM(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(P,N,k,D,V){let X=!1,W=h(P,D,k,N);r!==W&&(r=W,c(r.object)),X=f(P,D,k,V),X&&p(P,D,k,V),V!==null&&t.update(V,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,v(P,N,k,D),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return n.createVertexArray()}function c(P){return n.bindVertexArray(P)}function u(P){return n.deleteVertexArray(P)}function h(P,N,k,D){let V=D.wireframe===!0,X=i[N.id];X===void 0&&(X={},i[N.id]=X);let W=P.isInstancedMesh===!0?P.id:0,ot=X[W];ot===void 0&&(ot={},X[W]=ot);let Z=ot[k.id];Z===void 0&&(Z={},ot[k.id]=Z);let Q=Z[V];return Q===void 0&&(Q=d(l()),Z[V]=Q),Q}function d(P){let N=[],k=[],D=[];for(let V=0;V<e;V++)N[V]=0,k[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:k,attributeDivisors:D,object:P,attributes:{},index:null}}function f(P,N,k,D){let V=r.attributes,X=N.attributes,W=0,ot=k.getAttributes();for(let Z in ot)if(ot[Z].location>=0){let it=V[Z],ft=X[Z];if(ft===void 0&&(Z==="instanceMatrix"&&P.instanceMatrix&&(ft=P.instanceMatrix),Z==="instanceColor"&&P.instanceColor&&(ft=P.instanceColor)),it===void 0||it.attribute!==ft||ft&&it.data!==ft.data)return!0;W++}return r.attributesNum!==W||r.index!==D}function p(P,N,k,D){let V={},X=N.attributes,W=0,ot=k.getAttributes();for(let Z in ot)if(ot[Z].location>=0){let it=X[Z];it===void 0&&(Z==="instanceMatrix"&&P.instanceMatrix&&(it=P.instanceMatrix),Z==="instanceColor"&&P.instanceColor&&(it=P.instanceColor));let ft={};ft.attribute=it,it&&it.data&&(ft.data=it.data),V[Z]=ft,W++}r.attributes=V,r.attributesNum=W,r.index=D}function _(){let P=r.newAttributes;for(let N=0,k=P.length;N<k;N++)P[N]=0}function m(P){g(P,0)}function g(P,N){let k=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;k[P]=1,D[P]===0&&(n.enableVertexAttribArray(P),D[P]=1),V[P]!==N&&(n.vertexAttribDivisor(P,N),V[P]=N)}function x(){let P=r.newAttributes,N=r.enabledAttributes;for(let k=0,D=N.length;k<D;k++)N[k]!==P[k]&&(n.disableVertexAttribArray(k),N[k]=0)}function b(P,N,k,D,V,X,W){W===!0?n.vertexAttribIPointer(P,N,k,V,X):n.vertexAttribPointer(P,N,k,D,V,X)}function v(P,N,k,D){_();let V=D.attributes,X=k.getAttributes(),W=N.defaultAttributeValues;for(let ot in X){let Z=X[ot];if(Z.location>=0){let Q=V[ot];if(Q===void 0&&(ot==="instanceMatrix"&&P.instanceMatrix&&(Q=P.instanceMatrix),ot==="instanceColor"&&P.instanceColor&&(Q=P.instanceColor)),Q!==void 0){let it=Q.normalized,ft=Q.itemSize,dt=t.get(Q);if(dt===void 0)continue;let tt=dt.buffer,ht=dt.type,gt=dt.bytesPerElement,St=ht===n.INT||ht===n.UNSIGNED_INT||Q.gpuType===bc;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<Z.locationSize;Vt++)g(Z.location+Vt,Mt.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<Z.locationSize;Vt++)m(Z.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<Z.locationSize;Vt++)b(Z.location+Vt,ft/Z.locationSize,ht,it,Ht*gt,(se+ft/Z.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<Z.locationSize;Mt++)g(Z.location+Mt,Q.meshPerAttribute);P.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<Z.locationSize;Mt++)m(Z.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<Z.locationSize;Mt++)b(Z.location+Mt,ft/Z.locationSize,ht,it,ft*gt,ft/Z.locationSize*Mt*gt,St)}}else if(W!==void 0){let it=W[ot];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(Z.location,it);break;case 3:n.vertexAttrib3fv(Z.location,it);break;case 4:n.vertexAttrib4fv(Z.location,it);break;default:n.vertexAttrib1fv(Z.location,it)}}}}x()}function A(){I();for(let P in i){let N=i[P];for(let k in N){let D=N[k];for(let V in D){let X=D[V];for(let W in X)u(X[W].object),delete X[W];delete D[V]}}delete i[P]}}function E(P){if(i[P.id]===void 0)return;let N=i[P.id];for(let k in N){let D=N[k];for(let V in D){let X=D[V];for(let W in X)u(X[W].object),delete X[W];delete D[V]}}delete i[P.id]}function y(P){for(let N in i){let k=i[N];for(let D in k){let V=k[D];if(V[P.id]===void 0)continue;let X=V[P.id];for(let W in X)u(X[W].object),delete X[W];delete V[P.id]}}}function w(P){for(let N in i){let k=i[N],D=P.isInstancedMesh===!0?P.id:0,V=k[D];if(V!==void 0){for(let X in V){let W=V[X];for(let ot in W)u(W[ot].object),delete W[ot];delete V[X]}delete k[D],Object.keys(k).length===0&&delete i[N]}}}function I(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:L,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:w,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:m,disableUnusedAttributes:x}}function JM(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),e.update(c,i,u))}function a(l,c,u){if(u===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function jM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Di&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let w=y===Ni&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Qn&&y!==bi&&!w&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",u=l(c);u!==c&&(qt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&h===!1;e.reversedDepthBuffer===!0&&h===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&h===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:x,maxVaryings:b,maxFragmentUniforms:v,maxSamples:A,samples:E}}function QM(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ci,a=new te,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||s;return s=d,i=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){e=u(h,d,0)},this.setState=function(h,d,f){let p=h.clippingPlanes,_=h.clipIntersection,m=h.clipShadows,g=n.get(h);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let x=r?0:i,b=x*4,v=g.clippingState||null;l.value=v,v=u(p,d,b,f);for(let A=0;A!==b;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,d,f,p){let _=h!==null?h.length:0,m=null;if(_!==0){if(m=l.value,p!==!0||m===null){let g=f+_*4,x=d.matrixWorldInverse;a.getNormalMatrix(x),(m===null||m.length<g)&&(m=new Float32Array(g));for(let b=0,v=f;b!==_;++b,v+=4)o.copy(h[b]).applyMatrix4(x,a),o.normal.toArray(m,v),m[v+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var Wa=class extends hi{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new va(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new uo(5,5,5),r=new Ki({name:"CubemapFromEquirect",uniforms:vr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Kn,blending:gr});r.uniforms.tEquirect.value=e;let o=new Dn(s,r),a=e.minFilter;return e.minFilter===bs&&(e.minFilter=Zn),new fo(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},sg=256,tw=3,ew=20,Tg=256,Cg=16,nw=3,iw=new G,sw=new Xt,au=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new fo(1,10,null),this._boxMesh=new Dn(new uo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=iw}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);e>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(sw));let m=new fo(i,s,u);return m.position.copy(a),m.update(l,t),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=p,t.background=_,e>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ag(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=og(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(sg,Ed(t))}_fromTexture(t,e){t.mapping===_r||t.mapping===xo?this._setSize(t.image.length===0?sg:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=rg(t,!1,!1),i=Math.log2(t)-tw;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=rg(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===_r||t.mapping===xo?(this._cubemapMaterial===null&&(this._cubemapMaterial=ag()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=og()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=rw(),this._integrationMaterial=ow());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Cg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-nw)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(Tg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=aw());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function rg(n,t,e){return new Wa(n,{minFilter:bs,generateMipmaps:t,type:Ni,colorSpace:ha,depthBuffer:e})}function $a(n,t,e){return new Ki({name:n,uniforms:t,vertexShader:ue.cube_vert,fragmentShader:e,side:Kn,blending:gr,depthTest:!1,depthWrite:!1})}function rw(){return $a("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Tg}u

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
	`)}function ow(){return $a("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Cg}},`

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
	`)}function aw(){return $a("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ew}
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
	`)}function og(){return $a("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function ag(){return $a("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function lw(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===_c||f===yc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let _=new Wa(p.height);return _.fromEquirectangularTexture(n,d),t.set(d,_),d.addEventListener("dispose",c),a(_.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===_c||f===yc,_=f===_r||f===xo;if(p||_){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new au(n)),m=p?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let x=d.image;return p&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new au(n)),m=p?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===_c?d.mapping=_r:f===yc&&(d.mapping=xo),d}function l(d){let f=0,p=6;for(let _=0;_<p;_++)d[_]!==void 0&&f++;return f===p}function c(d){let f=d.target;f.removeEventListener("dispose",c);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function h(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function cw(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&aa("WebGLRenderer: "+i+" extension not supported."),s}}}function uw(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(t.remove(_),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function u(p){let _=p.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function h(p){let _=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let x=_!==null?_.array.length:m.array.length/3-1,b=m.count>=65535?xa:ga,v=new b(Math.ceil(x/3)*6,1),A=v.array;if(_!==null){let y=_.array;g=_.version;for(let w=0,I=0;w<x;w+=3){let L=y[w+0],P=y[w+1],N=y[w+2];A[I++]=L,A[I++]=P,A[I++]=P,A[I++]=N,A[I++]=N,A[I++]=L}}else{g=m.version;for(let y=0,w=0;y<x;y+=3){let I=y+0,L=y+1,P=y+2;A[w++]=I,A[w++]=L,A[w++]=L,A[w++]=P,A[w++]=P,A[w++]=I}}v.version=g;let E=r.get(p);E&&t.remove(E),r.set(p,v)}function d(p){let _=r.get(p);if(_){let m=p.index;m!==null&&_.version<m.version&&h(p)}else h(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&l(_)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function hw(n,t,e){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,r,h*o),e.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,h*o,f),e.update(d,i,f))}function u(h,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,h,0,f);let _=0;for(let m=0;m<f;m++)_+=d[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function dw(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Qt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function fw(n,t,e){let i=new WeakMap,s=new ke;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],b=0;f===!0&&(b=1),p===!0&&(b=2),_===!0&&(b=3);let v=a.attributes.position.count*b,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let E=new Float32Array(v*A*4*h),y=new pa(E,v,A,h);y.type=bi,y.needsUpdate=!0;let w=b*4;for(let L=0;L<h;L++){let P=m[L],N=g[L],k=x[L],D=v*A*4*L;for(let V=0;V<P.count;V++){let X=V*w;f===!0&&(s.fromBufferAttribute(P,V),E[D+X+0]=s.x,E[D+X+1]=s.y,E[D+X+2]=s.z,E[D+X+3]=0),p===!0&&(s.fromBufferAttribute(N,V),E[D+X+4]=s.x,E[D+X+5]=s.y,E[D+X+6]=s.z,E[D+X+7]=0),_===!0&&(s.fromBufferAttribute(k,V),E[D+X+8]=s.x,E[D+X+9]=s.y,E[D+X+10]=s.z,E[D+X+11]=k.itemSize===4?s.w:1)}}d={count:h,texture:y,size:new Zt(v,A)},i.set(a,d),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let _=0;_<c.length;_++)f+=c[_];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function pw(n,t,e,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=t.get(c,h);if(r.get(d)!==u&&(t.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),e.remove(u.instanceMatrix),u.instanceColor!==null&&e.remove(u.instanceColor)}return{update:o,dispose:a}}var mw={[sd]:"LINEAR_TONE_MAPPING",[rd]:"REINHARD_TONE_MAPPING",[od]:"CINEON_TONE_MAPPING",[ad]:"ACES_FILMIC_TONE_MAPPING",[cd]:"AGX_TONE_MAPPING",[ud]:"NEUTRAL_TONE_MAPPING",[ld]:"CUSTOM_TONE_MAPPING"};function gw(n,t,e,i,s,r){let o=new hi(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new yn;u.setAttribute("position",new nn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new nn([0,2,0,0,2,0],2));let h=new nc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Dn(u,h),f=new Ra(-1,1,1,-1,0,1),p=null,_=null,m=!1,g,x=null,b=[],v=!1;this.setSize=function(A,E){o.setSize(A,E),a!==null&&a.setSize(A,E),l!==null&&l.setSize(A,E);for(let y=0;y<b.length;y++){let w=b[y];w.setSize&&w.setSize(A,E)}},this.setEffects=function(A){b=A,v=b.length>0&&b[0].isRenderPass===!0;let E=o.width,y=o.height;b.length>0&&a===null&&(a=new hi(E,y,{type:Ni,depthBuffer:!1,stencilBuffer:!1}),l=new hi(E,y,{type:Ni,depthBuffer:!1,stencilBuffer:!1}));let w=s===!0&&b.some(I=>I.needsDepthTexture===!0);w!==(o.depthTexture!==null)&&(w===!0&&c===null&&(c=new ys(E,y),r===!0&&(c.format=Ss,c.type=yr)),o.dispose(),o.depthTexture=w?c:null,o.resolveDepthBuffer=w,o.storeMultisampledDepthBuffer=w);for(let I=0;I<b.length;I++){let L=b[I];L.setSize&&L.setSize(E,y),w&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(A,E){if(m||A.toneMapping===Ji&&b.length===0)return!1;if(x=E,E!==null){let y=E.width,w=E.height;(o.width!==y||o.height!==w)&&this.setSize(y,w)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=Ji,!0},this.hasRenderPass=function(){return v},this.end=function(A,E){A.toneMapping=g,m=!0;let y=o,w=a;for(let I=0;I<b.length;I++){let L=b[I];L.enabled!==!1&&(L.render(A,w,y,E),L.needsSwap!==!1&&(y=w,w=w===a?l:a))}if(p!==A.outputColorSpace||_!==A.toneMapping){p=A.outputColorSpace,_=A.toneMapping,h.defines={},xe.getTransfer(p)===Te&&(h.defines.SRGB_TRANSFER="");let I=mw[_];I&&(h.defines[I]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,A.setRenderTarget(x),A.render(d,f),x=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Rg=new jn,Pg=new ys(1,1),Ig=new ba(1),Lg=new pa,Ng=new Jl,Dg=new va,lg=[],cg=[],ug=new Float32Array(16),hg=new Float32Array(9),dg=new Float32Array(4);function bo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=lg[s];if(r===void 0&&(r=new Float32Array(s),lg[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function vn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function bn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function cu(n,t){let e=cg[t];e===void 0&&(e=new Int32Array(t),cg[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function xw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function _w(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2fv(this.addr,t),bn(e,t)}}function yw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(vn(e,t))return;n.uniform3fv(this.addr,t),bn(e,t)}}function vw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4fv(this.addr,t),bn(e,t)}}function bw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,i))return;dg.set(i),n.uniformMatrix2fv(this.addr,!1,dg),bn(e,i)}}function Sw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,i))return;hg.set(i),n.uniformMatrix3fv(this.addr,!1,hg),bn(e,i)}}function Mw(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(vn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),bn(e,t)}else{if(vn(e,i))return;ug.set(i),n.uniformMatrix4fv(this.addr,!1,ug),bn(e,i)}}function ww(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Aw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2iv(this.addr,t),bn(e,t)}}function Ew(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3iv(this.addr,t),bn(e,t)}}function Tw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4iv(this.addr,t),bn(e,t)}}function Cw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Rw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(vn(e,t))return;n.uniform2uiv(this.addr,t),bn(e,t)}}function Pw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(vn(e,t))return;n.uniform3uiv(this.addr,t),bn(e,t)}}function Iw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(vn(e,t))return;n.uniform4uiv(this.addr,t),bn(e,t)}}function uu(n){return n.version===0&&(n.compareFunction=Sd,n.needsUpdate=!0),n}function Lw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=uu(Pg):r=Rg,e.setTexture2D(t||r,s)}function Nw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Ng,s)}function Dw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=uu(Ig):r=Dg,e.setTextureCube(t||r,s)}function Ow(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Lg,s)}function Uw(n){switch(n){case 5126:return xw;case 35664:return _w;case 35665:return yw;case 35666:return vw;case 35674:return bw;case 35675:return Sw;case 35676:return Mw;case 5124:case 35670:return ww;case 35667:case 35671:return Aw;case 35668:case 35672:return Ew;case 35669:case 35673:return Tw;case 5125:return Cw;case 36294:return Rw;case 36295:return Pw;case 36296:return Iw;case 35678:case 36198:case 36298:case 36306:case 35682:return Lw;case 35679:case 36299:case 36307:return Nw;case 35680:case 36300:case 36308:case 36293:return Dw;case 36289:case 36303:case 36311:case 36292:return Ow}}function Fw(n,t){n.uniform1fv(this.addr,t)}function kw(n,t){let e=bo(t,this.size,2);n.uniform2fv(this.addr,e)}function Bw(n,t){let e=bo(t,this.size,3);n.uniform3fv(this.addr,e)}function zw(n,t){let e=bo(t,this.size,4);n.uniform4fv(this.addr,e)}function Vw(n,t){let e=bo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function Gw(n,t){let e=bo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function Hw(n,t){let e=bo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function Ww(n,t){n.uniform1iv(this.addr,t)}function $w(n,t){n.uniform2iv(this.addr,t)}function Xw(n,t){n.uniform3iv(this.addr,t)}function qw(n,t){n.uniform4iv(this.addr,t)}function Yw(n,t){n.uniform1uiv(this.addr,t)}function Zw(n,t){n.uniform2uiv(this.addr,t)}function Kw(n,t){n.uniform3uiv(this.addr,t)}function Jw(n,t){n.uniform4uiv(this.addr,t)}function jw(n,t,e){let i=this.cache,s=t.length,r=cu(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=uu(Pg):o=Rg;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Qw(n,t,e){let i=this.cache,s=t.length,r=cu(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Ng,r[o])}function t1(n,t,e){let i=this.cache,s=t.length,r=cu(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=uu(Ig):o=Dg;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function e1(n,t,e){let i=this.cache,s=t.length,r=cu(e,s);vn(i,r)||(n.uniform1iv(this.addr,r),bn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Lg,r[o])}function n1(n){switch(n){case 5126:return Fw;case 35664:return kw;case 35665:return Bw;case 35666:return zw;case 35674:return Vw;case 35675:return Gw;case 35676:return Hw;case 5124:case 35670:return Ww;case 35667:case 35671:return $w;case 35668:case 35672:return Xw;case 35669:case 35673:return qw;case 5125:return Yw;case 36294:return Zw;case 36295:return Kw;case 36296:return Jw;case 35678:case 36198:case 36298:case 36306:case 35682:return jw;case 35679:case 36299:case 36307:return Qw;case 35680:case 36300:case 36308:case 36293:return t1;case 36289:case 36303:case 36311:case 36292:return e1}}var Od=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Uw(e.type)}},Ud=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=n1(e.type)}},Fd=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Nd=/(\w+)(\])?(\[|\.)?/g;function fg(n,t){n.seq.push(t),n.map[t.id]=t}function i1(n,t,e){let i=n.name,s=i.length;for(Nd.lastIndex=0;;){let r=Nd.exec(i),o=Nd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fg(e,c===void 0?new Od(a,n,t):new Ud(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new Fd(a),fg(e,h)),e=h}}}var vo=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);i1(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function pg(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var s1=37297,r1=0;function o1(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var mg=new te;function a1(n){xe._getMatrix(mg,xe.workingColorSpace,n);let t=`mat3( ${mg.elements.map(e=>e.toFixed(4))} )`;switch(xe.getTransfer(n)){case da:return[t,"LinearTransferOETF"];case Te:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function gg(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+o1(n.getShaderSource(t),a)}else return r}function l1(n,t){let e=a1(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var c1={[sd]:"Linear",[rd]:"Reinhard",[od]:"Cineon",[ad]:"ACESFilmic",[cd]:"AgX",[ud]:"Neutral",[ld]:"Custom"};function u1(n,t){let e=c1[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ou=new G;function h1(){xe.getLuminanceCoefficients(ou);let n=ou.x.toFixed(4),t=ou.y.toFixed(4),e=ou.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function d1(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ha).join(`
`)}function f1(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function p1(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ha(n){return n!==""}function xg(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function _g(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var m1=/^[ \t]*#include +<([\w\d./]+)>/gm;function kd(n){return n.replace(m1,g1)}function g1(n,t){let e=ue[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return kd(e)}var x1=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function yg(n){return n.replace(x1,_1)}function _1(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vg(n){let t=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var y1={[Na]:"SHADOWMAP_TYPE_PCF",[mo]:"SHADOWMAP_TYPE_VSM"};function v1(n){return y1[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var b1={[xo]:"ENVMAP_MODE_REFRACTION"};function S1(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":b1[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var M1={[xc]:"ENVMAP_BLENDING_MULTIPLY",[Um]:"ENVMAP_BLENDING_MIX",[Fm]:"ENVMAP_BLENDING_ADD"};function w1(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":M1[n.combine]||"ENVMAP_BLENDING_NONE"}function A1(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=v1(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=S1(e),h=w1(e),d=d1(e),f=f1(r),p=s.createProgram(),_,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ha).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Ha).join(`
`),m.length>0&&(m+=`
`)):(_=[vg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ha).join(`
`),m=[vg(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ji?"#define TONE_MAPPING":"",e.toneMapping!==Ji?ue.tonemapping_pars_fragment:"",e.toneMapping!==Ji?u1("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ue.colorspace_pars_fragment,l1("linearToOutputTexel",e.outputColorSpace),h1(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ha).join(`
`)),o=kd(o),o=xg(o,e),o=_g(o,e),a=kd(a),a=xg(a,e),a=_g(a,e),o=yg(o),a=yg(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===Md?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Md?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let x=g+_+o,b=g+m+a,v=pg(s,s.VERTEX_SHADER,x),A=pg(s,s.FRAGMENT_SHADER,b);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(L){if(n.debug.checkShaderErrors){let P=s.getProgramInfoLog(p)||"",N=s.getShaderInfoLog(v)||"",k=s.getShaderInfoLog(A)||"",D=P.trim(),V=N.trim(),X=k.trim(),W=!0,ot=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,v,A);else{let Z=gg(s,v,"vertex"),Q=gg(s,A,"fragment");Qt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+D+`
`+Z+`
`+Q)}else D!==""?qt("WebGLProgram: Program Info Log:",D):(V===""||X==="")&&(ot=!1);ot&&(L.diagnostics={runnable:W,programLog:D,vertexShader:{log:V,prefix:_},fragmentShader:{log:X,prefix:m}})}s.deleteShader(v),s.deleteShader(A),y=new vo(s,p),w=p1(s,p)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let w;this.getAttributes=function(){return w===void 0&&E(this),w};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,s1)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=r1++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var E1=0,Bd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new zd(t),e.set(t,i)),i}},zd=class{constructor(t){this.id=E1++,this.code=t,this.usedTimes=0}};function T1(n){return n===Js||n===Ba||n===za}function C1(n,t,e,i,s,r){let o=new lo,a=new Bd,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,w,I,L,P,N){let k=L.fog,D=P.geometry,V=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,W=t.get(y.envMap||V,X),ot=d[y.type],Z=i.precision;y.precision!==null&&(Z=i.getMaxPrecision(y.precision),Z!==y.precision&&qt("WebGLProgram.getParameters:",y.precision,"not supported, using",Z,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,it=Q!==void 0?Q.length:0,ft=0;D.morphAttributes.position!==void 0&&(ft=1),D.morphAttributes.normal!==void 0&&(ft=2),D.morphAttributes.color!==void 0&&(ft=3);let dt,tt,ht,gt;if(ot){let Ct=Qi[ot];dt=Ct.vertexShader,tt=Ct.fragmentShader}else{dt=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ht=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=P.isInstancedMesh===!0,se=P.isBatchedMesh===!0,Vt=!!y.map,he=!!y.matcap,le=!!W,ne=le&&W.isPMREMTexture===!0,Ye=!!y.aoMap,Ve=!!y.lightMap,cn=!!y.bumpMap&&y.wireframe===!1,Ne=!!y.normalMap,An=!!y.displacementMap,ye=!!y.emissiveMap,xn=!!y.metalnessMap,Je=!!y.roughnessMap,un=y.anisotropy>0,z=y.clearcoat>0,Rt=y.diffuseRoughness>0,Yt=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,Fe=y.sheen>0,zt=y.transmission>0,$t=un&&!!y.anisotropyMap,O=z&&!!y.clearcoatMap,T=z&&!!y.clearcoatNormalMap,q=z&&!!y.clearcoatRoughnessMap,ut=Rt&&!!y.diffuseRoughnessMap,at=wt&&!!y.iridescenceMap,_t=wt&&!!y.iridescenceThicknessMap,yt=Fe&&!!y.sheenColorMap,et=Fe&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,B=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,xt=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Jt=!!y.extensions,ct=Ji;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ft=ne?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,jt={shaderID:ot,shaderType:y.type,shaderName:y.name,vertexShader:dt,fragmentShader:tt,defines:y.defines,customVertexShaderID:ht,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:Z,batching:se,batchingColor:se&&P._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&P.instanceColor!==null,instancingMorph:Ht&&P.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:xe.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:he,envMap:le,envMapMode:le&&W.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:Ye,lightMap:Ve,bumpMap:cn,normalMap:Ne,displacementMap:An,emissiveMap:ye,normalMapObjectSpace:Ne&&y.normalMapType===zm,normalMapTangentSpace:Ne&&y.normalMapType===su,packedNormalMap:Ne&&y.normalMapType===su&&T1(y.normalMap.format),metalnessMap:xn,roughnessMap:Je,anisotropy:un,anisotropyMap:$t,clearcoat:z,clearcoatMap:O,clearcoatNormalMap:T,clearcoatRoughnessMap:q,diffuseRoughness:Rt,diffuseRoughnessMap:ut,dispersion:Yt,retroreflection:re,iridescence:wt,iridescenceMap:at,iridescenceThicknessMap:_t,sheen:Fe,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===go&&y.alphaToCoverage===!1,alphaMap:xt,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:Ye&&f(y.aoMap.channel),lightMapUv:Ve&&f(y.lightMap.channel),bumpMapUv:cn&&f(y.bumpMap.channel),normalMapUv:Ne&&f(y.normalMap.channel),displacementMapUv:An&&f(y.displacementMap.channel),emissiveMapUv:ye&&f(y.emissiveMap.channel),metalnessMapUv:xn&&f(y.metalnessMap.channel),roughnessMapUv:Je&&f(y.roughnessMap.channel),anisotropyMapUv:$t&&f(y.anisotropyMap.channel),clearcoatMapUv:O&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:T&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ut&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:at&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:_t&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&f(y.sheenRoughnessMap.channel),specularMapUv:st&&f(y.specularMap.channel),specularColorMapUv:mt&&f(y.specularColorMap.channel),specularIntensityMapUv:B&&f(y.specularIntensityMap.channel),transmissionMapUv:rt&&f(y.transmissionMap.channel),thicknessMapUv:nt&&f(y.thicknessMap.channel),alphaMapUv:xt&&f(y.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Ne||un),vertexNormals:!!D.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!D.attributes.uv&&(Vt||xt),fog:!!k,useFog:y.fog===!0,fogExp2:!!k&&k.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||D.attributes.normal===void 0&&Ne===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Mt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:ft,numSunLights:w.sun.length,numDirLights:w.directional.length,numPointLights:w.point.length,numSpotLights:w.spot.length,numSpotLightMaps:w.spotLightMap.length,numRectAreaLights:w.rectArea.length,numHemiLights:w.hemi.length,numSunLightShadows:w.sunShadowMap.length,numDirLightShadows:w.directionalShadowMap.length,numPointLightShadows:w.pointShadowMap.length,numSpotLightShadows:w.spotShadowMap.length,numSpotLightShadowsWithMaps:w.numSpotLightShadowsWithMaps,numLightProbes:w.numLightProbes,numLightProbeGrids:N.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&xe.getTransfer(y.map.colorSpace)===Te,decodeVideoTextureEmissive:ye&&y.emissiveMap.isVideoTexture===!0&&xe.getTransfer(y.emissiveMap.colorSpace)===Te,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Bn,flipSided:y.side===Kn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Jt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return jt.vertexUv1s=l.has(1),jt.vertexUv2s=l.has(2),jt.vertexUv3s=l.has(3),l.clear(),jt}function _(y){let w=[];if(y.shaderID?w.push(y.shaderID):(w.push(y.customVertexShaderID),w.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)w.push(I),w.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(m(w,y),g(w,y),w.push(n.outputColorSpace)),w.push(y.customProgramCacheKey),w.join()}function m(y,w){y.push(w.precision),y.push(w.outputColorSpace),y.push(w.envMapMode),y.push(w.envMapPMREM),y.push(w.envMapMaxLod),y.push(w.envMapSize),y.push(w.mapUv),y.push(w.alphaMapUv),y.push(w.lightMapUv),y.push(w.aoMapUv),y.push(w.bumpMapUv),y.push(w.normalMapUv),y.push(w.displacementMapUv),y.push(w.emissiveMapUv),y.push(w.metalnessMapUv),y.push(w.roughnessMapUv),y.push(w.anisotropyMapUv),y.push(w.clearcoatMapUv),y.push(w.clearcoatNormalMapUv),y.push(w.clearcoatRoughnessMapUv),y.push(w.diffuseRoughnessMapUv),y.push(w.iridescenceMapUv),y.push(w.iridescenceThicknessMapUv),y.push(w.sheenColorMapUv),y.push(w.sheenRoughnessMapUv),y.push(w.specularMapUv),y.push(w.specularColorMapUv),y.push(w.specularIntensityMapUv),y.push(w.transmissionMapUv),y.push(w.thicknessMapUv),y.push(w.combine),y.push(w.fogExp2),y.push(w.sizeAttenuation),y.push(w.morphTargetsCount),y.push(w.numSunLights),y.push(w.numDirLights),y.push(w.numPointLights),y.push(w.numSpotLights),y.push(w.numSpotLightMaps),y.push(w.numHemiLights),y.push(w.numRectAreaLights),y.push(w.numSunLightShadows),y.push(w.numDirLightShadows),y.push(w.numPointLightShadows),y.push(w.numSpotLightShadows),y.push(w.numSpotLightShadowsWithMaps),y.push(w.numLightProbes),y.push(w.numLightProbeGrids),y.push(w.shadowMapType),y.push(w.toneMapping),y.push(w.numClippingPlanes),y.push(w.numClipIntersection),y.push(w.depthPacking)}function g(y,w){o.disableAll(),w.instancing&&o.enable(0),w.instancingColor&&o.enable(1),w.instancingMorph&&o.enable(2),w.matcap&&o.enable(3),w.envMap&&o.enable(4),w.normalMapObjectSpace&&o.enable(5),w.normalMapTangentSpace&&o.enable(6),w.clearcoat&&o.enable(7),w.iridescence&&o.enable(8),w.alphaTest&&o.enable(9),w.vertexColors&&o.enable(10),w.vertexAlphas&&o.enable(11),w.vertexUv1s&&o.enable(12),w.vertexUv2s&&o.enable(13),w.vertexUv3s&&o.enable(14),w.vertexTangents&&o.enable(15),w.anisotropy&&o.enable(16),w.alphaHash&&o.enable(17),w.batching&&o.enable(18),w.dispersion&&o.enable(19),w.retroreflection&&o.enable(24),w.diffuseRoughness&&o.enable(25),w.batchingColor&&o.enable(20),w.gradientMap&&o.enable(21),w.packedNormalMap&&o.enable(22),w.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),w.fog&&o.enable(0),w.useFog&&o.enable(1),w.flatShading&&o.enable(2),w.logarithmicDepthBuffer&&o.enable(3),w.reversedDepthBuffer&&o.enable(4),w.skinning&&o.enable(5),w.morphTargets&&o.enable(6),w.morphNormals&&o.enable(7),w.morphColors&&o.enable(8),w.premultipliedAlpha&&o.enable(9),w.shadowMapEnabled&&o.enable(10),w.doubleSided&&o.enable(11),w.flipSided&&o.enable(12),w.useDepthPacking&&o.enable(13),w.dithering&&o.enable(14),w.transmission&&o.enable(15),w.sheen&&o.enable(16),w.opaque&&o.enable(17),w.pointsUvs&&o.enable(18),w.decodeVideoTexture&&o.enable(19),w.decodeVideoTextureEmissive&&o.enable(20),w.alphaToCoverage&&o.enable(21),w.numLightProbeGrids>0&&o.enable(22),w.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let w=d[y.type],I;if(w){let L=Qi[w];I=eg.clone(L.uniforms)}else I=y.uniforms;return I}function b(y,w){let I=u.get(w);return I!==void 0?++I.usedTimes:(I=new A1(n,w,y,s),c.push(I),u.set(w,I)),I}function v(y){if(--y.usedTimes===0){let w=c.indexOf(y);c[w]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function A(y){a.remove(y)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:x,acquireProgram:b,releaseProgram:v,releaseShaderCache:A,programs:c,dispose:E}}function R1(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function P1(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function bg(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Sg(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,_,m,g){let x=n[t];return x===void 0?(x={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:_,renderOrder:d.renderOrder,z:m,group:g},n[t]=x):(x.id=d.id,x.object=d,x.geometry=f,x.material=p,x.materialVariant=o(d),x.groupOrder=_,x.renderOrder=d.renderOrder,x.z=m,x.group=g),t++,x}function l(d,f,p,_,m,g,x){x.reversedDepth===!0&&(m=-m);let b=a(d,f,p,_,m,g);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):e.push(b)}function c(d,f,p,_,m,g){let x=a(d,f,p,_,m,g);p.transmission>0?i.unshift(x):p.transparent===!0?s.unshift(x):e.unshift(x)}function u(d,f){e.length>1&&e.sort(d||P1),i.length>1&&i.sort(f||bg),s.length>1&&s.sort(f||bg)}function h(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function I1(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Sg,n.set(i,[o])):s>=r.length?(o=new Sg,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function L1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new G,color:new Xt};break;case"SpotLight":e={position:new G,direction:new G,color:new Xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new G,color:new Xt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new G,skyColor:new Xt,groundColor:new Xt};break;case"RectAreaLight":e={color:new Xt,position:new G,halfWidth:new G,halfHeight:new G};break}return n[t.id]=e,e}}}function N1(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Zt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var D1=0;function O1(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function U1(n){let t=new L1,e=N1(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new G);let s=new G,r=new ae,o=new ae;function a(c){let u=0,h=0,d=0;for(let N=0;N<9;N++)i.probe[N].set(0,0,0);let f=0,p=0,_=0,m=0,g=0,x=0,b=0,v=0,A=0,E=0,y=0,w=0,I=0,L=0;c.sort(O1);for(let N=0,k=c.length;N<k;N++){let D=c[N],V=D.color,X=D.intensity,W=D.distance,ot=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Js?ot=D.shadow.map.texture:ot=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=V.r*X,h+=V.g*X,d+=V.b*X;else if(D.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(D.sh.coefficients[Z],X);L++}else if(D.isSunLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=it,i.sunShadowMap[p]=ot;let ft=Q.getViewportCount();for(let dt=0;dt<ft;dt++)i.sunShadowMatrix[_+dt]=Q.getMatrix(dt),i.sunShadowCascade[_+dt]=Q._cascadeData[dt];_+=ft,p++}i.sun[f]=Z,f++}else if(D.isDirectionalLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[m]=it,i.directionalShadowMap[m]=ot,i.directionalShadowMatrix[m]=D.shadow.matrix,A++}i.directional[m]=Z,m++}else if(D.isSpotLight){let Z=t.get(D);Z.position.setFromMatrixPosition(D.matrixWorld),Z.color.copy(V).multiplyScalar(X),Z.distance=W,Z.coneCos=Math.cos(D.angle),Z.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),Z.decay=D.decay,i.spot[x]=Z;let Q=D.shadow;if(D.map&&(i.spotLightMap[w]=D.map,w++,Q.updateMatrices(D),D.castShadow&&I++),i.spotLightMatrix[x]=Q.matrix,D.castShadow){let it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[x]=it,i.spotShadowMap[x]=ot,y++}x++}else if(D.isRectAreaLight){let Z=t.get(D);Z.color.copy(V).multiplyScalar(X),Z.halfWidth.set(D.width*.5,0,0),Z.halfHeight.set(0,D.height*.5,0),i.rectArea[b]=Z,b++}else if(D.isPointLight){let Z=t.get(D);if(Z.color.copy(D.color).multiplyScalar(D.intensity),Z.distance=D.distance,Z.decay=D.decay,D.castShadow){let Q=D.shadow,it=e.get(D);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[g]=it,i.pointShadowMap[g]=ot,i.pointShadowMatrix[g]=D.shadow.matrix,E++}i.point[g]=Z,g++}else if(D.isHemisphereLight){let Z=t.get(D);Z.skyColor.copy(D.color).multiplyScalar(X),Z.groundColor.copy(D.groundColor).multiplyScalar(X),i.hemi[v]=Z,v++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let P=i.hash;(P.sunLength!==f||P.directionalLength!==m||P.pointLength!==g||P.spotLength!==x||P.rectAreaLength!==b||P.hemiLength!==v||P.numSunShadows!==p||P.numDirectionalShadows!==A||P.numPointShadows!==E||P.numSpotShadows!==y||P.numSpotMaps!==w||P.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=m,i.spot.length=x,i.rectArea.length=b,i.point.length=g,i.hemi.length=v,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+w-I,i.spotLightMap.length=w,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=L,P.sunLength=f,P.directionalLength=m,P.pointLength=g,P.spotLength=x,P.rectAreaLength=b,P.hemiLength=v,P.numSunShadows=p,P.numDirectionalShadows=A,P.numPointShadows=E,P.numSpotShadows=y,P.numSpotMaps=w,P.numLightProbes=L,i.version=D1++)}function l(c,u){let h=0,d=0,f=0,p=0,_=0,m=0,g=u.matrixWorldInverse;for(let x=0,b=c.length;x<b;x++){let v=c[x];if(v.isSunLight){let A=i.sun[h];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),h++}else if(v.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=i.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=i.rectArea[_];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),_++}else if(v.isPointLight){let A=i.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Mg(n){let t=new U1(n),e=[],i=[],s=[];function r(h){u.camera=h,e.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):e.push(h)}function a(h){i.push(h)}function l(){t.setup(e),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){t.setupView(e,h)}let u={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function F1(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Mg(n),t.set(s,[a])):r>=o.length?(a=new Mg(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var k1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,B1=`uniform sampler2D shadow_pass;
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
}`,z1=[new G(1,0,0),new G(-1,0,0),new G(0,1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1)],V1=[new G(0,-1,0),new G(0,-1,0),new G(0,0,1),new G(0,0,-1),new G(0,-1,0),new G(0,-1,0)],wg=new ae,Ga=new G,Dd=new G;function G1(n,t,e){let i=new Hs,s=new Zt,r=new Zt,o=new ke,a=new ic,l=new sc,c={},u=e.maxTextureSize,h={[Ks]:Kn,[Kn]:Ks,[Bn]:Bn},d=new Ki({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Zt},radius:{value:4}},vertexShader:k1,fragmentShader:B1}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new yn;p.setAttribute("position",new an(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Dn(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Na;let g=this.type;this.render=function(E,y,w){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===xm&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Na);let I=n.getRenderTarget(),L=n.getActiveCubeFace(),P=n.getActiveMipmapLevel(),N=n.state;N.setBlending(gr),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let k=g!==this.type;k&&y.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=E.length;D<V;D++){let X=E[D],W=X.shadow;if(W===void 0){qt("WebGLShadowMap:",X,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let ot=W.getFrameExtents();s.multiply(ot),r.copy(W.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ot.x),s.x=r.x*ot.x,W.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ot.y),s.y=r.y*ot.y,W.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=Z,W.map===null||k===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===mo){if(X.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new hi(s.x,s.y,{format:Js,type:Ni,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),W.map.texture.name=X.name+".shadowMap",W.map.depthTexture=new ys(s.x,s.y,bi),W.map.depthTexture.name=X.name+".shadowMapDepth",W.map.depthTexture.format=ms,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In}else X.isPointLight?(W.map=new Wa(s.x),W.map.depthTexture=new ba(s.x,Li)):(W.map=new hi(s.x,s.y),W.map.depthTexture=new ys(s.x,s.y,Li)),W.map.depthTexture.name=X.name+".shadowMap",W.map.depthTexture.format=ms,this.type===Na?(W.map.depthTexture.compareFunction=Z?bd:vd,W.map.depthTexture.minFilter=Zn,W.map.depthTexture.magFilter=Zn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=In,W.map.depthTexture.magFilter=In);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();X.isPointLight!==!0&&W.updateMatrices(X,w);let it=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:w.layers;for(let ft=0;ft<Q;ft++){let dt=W.getCamera(ft);if(X.isPointLight){let tt=W.camera,ht=W.matrix,gt=X.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Ga.setFromMatrixPosition(X.matrixWorld),tt.position.copy(Ga),Dd.copy(tt.position),Dd.add(z1[ft]),tt.up.copy(V1[ft]),tt.lookAt(Dd),tt.updateMatrixWorld(),ht.makeTranslation(-Ga.x,-Ga.y,-Ga.z),wg.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),W._frustum.setFromProjectionMatrix(wg,tt.coordinateSystem,tt.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,ft),n.clear();else{ft===0&&(n.setRenderTarget(W.map),n.clear());let tt=W.getViewport(ft);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),N.viewport(o)}i=W.getFrustum(ft),v(y,w,dt,X,it,this.type)}W.isPointLightShadow!==!0&&this.type===mo&&x(W,w),W.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(I,L,P)};function x(E,y){let w=t.update(_);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new hi(s.x,s.y,{format:Js,type:Ni}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(y,null,w,d,_,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(y,null,w,f,_,null)}function b(E,y,w,I){let L=null,P=w.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(P!==void 0)L=P;else if(L=w.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let N=L.uuid,k=y.uuid,D=c[N];D===void 0&&(D={},c[N]=D);let V=D[k];V===void 0&&(V=L.clone(),D[k]=V,y.addEventListener("dispose",A)),L=V}if(L.visible=y.visible,L.wireframe=y.wireframe,I===mo?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,w.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let N=n.properties.get(L);N.light=w}return L}function v(E,y,w,I,L,P){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&P===mo)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(w.matrixWorldInverse,E.matrixWorld);let D=t.update(E),V=E.material;if(Array.isArray(V)){let X=D.groups;for(let W=0,ot=X.length;W<ot;W++){let Z=X[W],Q=V[Z.materialIndex];if(Q&&Q.visible){let it=b(E,Q,I,P);E.onBeforeShadow(n,E,y,w,D,it,Z),n.renderBufferDirect(w,null,D,it,E,Z),E.onAfterShadow(n,E,y,w,D,it,Z)}}}else if(V.visible){let X=b(E,V,I,P);E.onBeforeShadow(n,E,y,w,D,X,null),n.renderBufferDirect(w,null,D,X,E,null),E.onAfterShadow(n,E,y,w,D,X,null)}}let k=E.children;for(let D=0,V=k.length;D<V;D++)v(k[D],y,w,I,L,P)}function A(E){E.target.removeEventListener("dispose",A);for(let w in c){let I=c[w],L=E.target.uuid;L in I&&(I[L].dispose(),delete I[L])}}}function H1(n,t){function e(){let B=!1,rt=new ke,nt=null,At=new ke(0,0,0,0);return{setMask:function(xt){nt!==xt&&!B&&(n.colorMask(xt,xt,xt,xt),nt=xt)},setLocked:function(xt){B=xt},setClear:function(xt,bt,Gt,Jt,ct){ct===!0&&(xt*=Jt,bt*=Jt,Gt*=Jt),rt.set(xt,bt,Gt,Jt),At.equals(rt)===!1&&(n.clearColor(xt,bt,Gt,Jt),At.copy(rt))},reset:function(){B=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let B=!1,rt=!1,nt=null,At=null,xt=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Jt=xt;xt=null,this.setClear(Jt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!B&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=Jm[bt]),At!==bt){switch(bt){case Bl:n.depthFunc(n.NEVER);break;case zl:n.depthFunc(n.ALWAYS);break;case Vl:n.depthFunc(n.LESS);break;case io:n.depthFunc(n.LEQUAL);break;case Gl:n.depthFunc(n.EQUAL);break;case Hl:n.depthFunc(n.GEQUAL);break;case Wl:n.depthFunc(n.GREATER);break;case $l:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){B=bt},setClear:function(bt){xt!==bt&&(xt=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){B=!1,nt=null,At=null,xt=null,rt=!1}}}function s(){let B=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null;return{setTest:function(Ft){B||(Ft?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ft){rt!==Ft&&!B&&(n.stencilMask(Ft),rt=Ft)},setFunc:function(Ft,jt,Ct){(nt!==Ft||At!==jt||xt!==Ct)&&(n.stencilFunc(Ft,jt,Ct),nt=Ft,At=jt,xt=Ct)},setOp:function(Ft,jt,Ct){(bt!==Ft||Gt!==jt||Jt!==Ct)&&(n.stencilOp(Ft,jt,Ct),bt=Ft,Gt=jt,Jt=Ct)},setLocked:function(Ft){B=Ft},setClear:function(Ft){ct!==Ft&&(n.clearStencil(Ft),ct=Ft)},reset:function(){B=!1,rt=null,nt=null,At=null,xt=null,bt=null,Gt=null,Jt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,b=null,v=null,A=null,E=null,y=null,w=new Xt(0,0,0),I=0,L=!1,P=null,N=null,k=null,D=null,V=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,ot=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(ot=parseFloat(/^WebGL (\d)/.exec(Z)[1]),W=ot>=1):Z.indexOf("OpenGL ES")!==-1&&(ot=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),W=ot>=2);let Q=null,it={},ft=n.getParameter(n.SCISSOR_BOX),dt=n.getParameter(n.VIEWPORT),tt=new ke().fromArray(ft),ht=new ke().fromArray(dt);function gt(B,rt,nt,At){let xt=new Uint8Array(4),bt=n.createTexture();n.bindTexture(B,bt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,xt):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xt);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(io),cn(!1),Ne(jh),Mt(n.CULL_FACE),Ye(gr);function Mt(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function Ht(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function se(B,rt){return d[B]!==rt?(n.bindFramebuffer(B,rt),d[B]=rt,B===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=rt),B===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let nt=p,At=!1;if(B){nt=f.get(rt),nt===void 0&&(nt=[],f.set(rt,nt));let xt=B.textures;if(nt.length!==xt.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=xt.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=xt.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function he(B){return _!==B?(n.useProgram(B),_=B,!0):!1}let le={[xr]:n.FUNC_ADD,[ym]:n.FUNC_SUBTRACT,[vm]:n.FUNC_REVERSE_SUBTRACT};le[bm]=n.MIN,le[Sm]=n.MAX;let ne={[Mm]:n.ZERO,[wm]:n.ONE,[Am]:n.SRC_COLOR,[nd]:n.SRC_ALPHA,[Im]:n.SRC_ALPHA_SATURATE,[Rm]:n.DST_COLOR,[Tm]:n.DST_ALPHA,[Em]:n.ONE_MINUS_SRC_COLOR,[id]:n.ONE_MINUS_SRC_ALPHA,[Pm]:n.ONE_MINUS_DST_COLOR,[Cm]:n.ONE_MINUS_DST_ALPHA,[Lm]:n.CONSTANT_COLOR,[Nm]:n.ONE_MINUS_CONSTANT_COLOR,[Dm]:n.CONSTANT_ALPHA,[Om]:n.ONE_MINUS_CONSTANT_ALPHA};function Ye(B,rt,nt,At,xt,bt,Gt,Jt,ct,Ft){if(B===gr){m===!0&&(Ht(n.BLEND),m=!1);return}if(m===!1&&(Mt(n.BLEND),m=!0),B!==_m){if(B!==g||Ft!==L){if((x!==xr||A!==xr)&&(n.blendEquation(n.FUNC_ADD),x=xr,A=xr),Ft)switch(B){case go:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Qh:n.blendFunc(n.ONE,n.ONE);break;case td:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ed:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Qt("WebGLState: Invalid blending: ",B);break}else switch(B){case go:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Qh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case td:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ed:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",B);break}b=null,v=null,E=null,y=null,w.set(0,0,0),I=0,g=B,L=Ft}return}xt=xt||rt,bt=bt||nt,Gt=Gt||At,(rt!==x||xt!==A)&&(n.blendEquationSeparate(le[rt],le[xt]),x=rt,A=xt),(nt!==b||At!==v||bt!==E||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),b=nt,v=At,E=bt,y=Gt),(Jt.equals(w)===!1||ct!==I)&&(n.blendColor(Jt.r,Jt.g,Jt.b,ct),w.copy(Jt),I=ct),g=B,L=!1}function Ve(B,rt){B.side===Bn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=B.side===Kn;rt&&(nt=!nt),cn(nt),B.blending===go&&B.transparent===!1?Ye(gr):Ye(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ye(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function cn(B){P!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),P=B)}function Ne(B){B!==mm?(Mt(n.CULL_FACE),B!==N&&(B===jh?n.cullFace(n.BACK):B===gm?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),N=B}function An(B){B!==k&&(W&&n.lineWidth(B),k=B)}function ye(B,rt,nt){B?(Mt(n.POLYGON_OFFSET_FILL),(D!==rt||V!==nt)&&(D=rt,V=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function xn(B){B?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Je(B){B===void 0&&(B=n.TEXTURE0+X-1),Q!==B&&(n.activeTexture(B),Q=B)}function un(B,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+X-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==B||At.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(B,rt||St[B]),At.type=B,At.texture=rt)}function z(){let B=it[Q];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(B){Qt("WebGLState:",B)}}function Yt(){try{n.compressedTexImage3D(...arguments)}catch(B){Qt("WebGLState:",B)}}function re(){try{n.texSubImage2D(...arguments)}catch(B){Qt("WebGLState:",B)}}function wt(){try{n.texSubImage3D(...arguments)}catch(B){Qt("WebGLState:",B)}}function Fe(){try{n.compressedTexSubImage2D(...arguments)}catch(B){Qt("WebGLState:",B)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){Qt("WebGLState:",B)}}function $t(){try{n.texStorage2D(...arguments)}catch(B){Qt("WebGLState:",B)}}function O(){try{n.texStorage3D(...arguments)}catch(B){Qt("WebGLState:",B)}}function T(){try{n.texImage2D(...arguments)}catch(B){Qt("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){Qt("WebGLState:",B)}}function ut(B){return h[B]!==void 0?h[B]:n.getParameter(B)}function at(B,rt){h[B]!==rt&&(n.pixelStorei(B,rt),h[B]=rt)}function _t(B){tt.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),tt.copy(B))}function yt(B){ht.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),ht.copy(B))}function et(B,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let At=nt.get(B);At===void 0&&(At=n.getUniformBlockIndex(rt,B.name),n.uniformBlockBinding(rt,At,At),nt.set(B,At))}function st(B,rt,nt){let xt=c.get(rt).get(B);l[xt]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,xt,nt),l[xt]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,it={},d={},l={},f=new WeakMap,p=[],_=null,m=!1,g=null,x=null,b=null,v=null,A=null,E=null,y=null,w=new Xt(0,0,0),I=0,L=!1,P=null,N=null,k=null,D=null,V=null,tt.set(0,0,n.canvas.width,n.canvas.height),ht.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:he,setBlending:Ye,setMaterial:Ve,setFlipSided:cn,setCullFace:Ne,setLineWidth:An,setPolygonOffset:ye,setScissorTest:xn,activeTexture:Je,bindTexture:un,unbindTexture:z,compressedTexImage2D:Rt,compressedTexImage3D:Yt,texImage2D:T,texImage3D:q,pixelStorei:at,getParameter:ut,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:$t,texStorage3D:O,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:Fe,compressedTexSubImage3D:zt,scissor:_t,viewport:yt,reset:mt}}function W1(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Zt,u=new WeakMap,h=new Set,d,f=new WeakMap,p=new Set,_=new FinalizationRegistry(O=>p.delete(O)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(O,T){return m?new OffscreenCanvas(O,T):fa("canvas")}function x(O,T,q){let ut=1,at=$t(O);if((at.width>q||at.height>q)&&(ut=q/Math.max(at.width,at.height)),ut<1)if(typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&O instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&O instanceof ImageBitmap||typeof VideoFrame<"u"&&O instanceof VideoFrame){let _t=Math.floor(ut*at.width),yt=Math.floor(ut*at.height);d===void 0&&(d=g(_t,yt));let et=T?g(_t,yt):d;return et.width=_t,et.height=yt,et.getContext("2d").drawImage(O,0,0,_t,yt),qt("WebGLRenderer: Texture has been resized from ("+at.width+"x"+at.height+") to ("+_t+"x"+yt+")."),et}else return"data"in O&&qt("WebGLRenderer: Image in DataTexture is too big ("+at.width+"x"+at.height+")."),O;return O}function b(O){return O.generateMipmaps}function v(O){n.generateMipmap(O)}function A(O){return O.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:O.isWebGL3DRenderTarget?n.TEXTURE_3D:O.isWebGLArrayRenderTarget||O.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(O,T,q,ut,at,_t=!1){if(O!==null){if(n[O]!==void 0)return n[O];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+O+"'")}let yt;ut&&(yt=t.get("EXT_texture_norm16"),yt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=T;if(T===n.RED&&(q===n.FLOAT&&(et=n.R32F),q===n.HALF_FLOAT&&(et=n.R16F),q===n.UNSIGNED_BYTE&&(et=n.R8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),q===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),T===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.R8UI),q===n.UNSIGNED_SHORT&&(et=n.R16UI),q===n.UNSIGNED_INT&&(et=n.R32UI),q===n.BYTE&&(et=n.R8I),q===n.SHORT&&(et=n.R16I),q===n.INT&&(et=n.R32I)),T===n.RG&&(q===n.FLOAT&&(et=n.RG32F),q===n.HALF_FLOAT&&(et=n.RG16F),q===n.UNSIGNED_BYTE&&(et=n.RG8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),q===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),T===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RG8UI),q===n.UNSIGNED_SHORT&&(et=n.RG16UI),q===n.UNSIGNED_INT&&(et=n.RG32UI),q===n.BYTE&&(et=n.RG8I),q===n.SHORT&&(et=n.RG16I),q===n.INT&&(et=n.RG32I)),T===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGB8UI),q===n.UNSIGNED_SHORT&&(et=n.RGB16UI),q===n.UNSIGNED_INT&&(et=n.RGB32UI),q===n.BYTE&&(et=n.RGB8I),q===n.SHORT&&(et=n.RGB16I),q===n.INT&&(et=n.RGB32I)),T===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),q===n.UNSIGNED_INT&&(et=n.RGBA32UI),q===n.BYTE&&(et=n.RGBA8I),q===n.SHORT&&(et=n.RGBA16I),q===n.INT&&(et=n.RGBA32I)),T===n.RGB&&(q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),q===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),T===n.RGBA){let st=_t?da:xe.getTransfer(at);q===n.FLOAT&&(et=n.RGBA32F),q===n.HALF_FLOAT&&(et=n.RGBA16F),q===n.UNSIGNED_BYTE&&(et=st===Te?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),q===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(O,T){let q;return O?T===null||T===Li||T===yr?q=n.DEPTH24_STENCIL8:T===bi?q=n.DEPTH32F_STENCIL8:T===_o&&(q=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):T===null||T===Li||T===yr?q=n.DEPTH_COMPONENT24:T===bi?q=n.DEPTH_COMPONENT32F:T===_o&&(q=n.DEPTH_COMPONENT16),q}function w(O,T){return b(O)===!0||O.isFramebufferTexture&&O.minFilter!==In&&O.minFilter!==Zn?Math.log2(Math.max(T.width,T.height))+1:O.mipmaps.length>0?O.mipmaps.length:O.isCompressedTexture&&Array.isArray(O.image)?T.mipmaps.length:1}function I(O){let T=new WeakRef(O);i.get(O).__ref=T,p.add(T),_.register(O,T,T)}function L(O){let T=i.get(O).__ref;T!==void 0&&(p.delete(T),_.unregister(T))}function P(O){k(O.target)}function N(O){D(O.target)}function k(O){O.removeEventListener("dispose",P),L(O),X(O),O.isVideoTexture&&u.delete(O),O.isHTMLTexture&&h.delete(O)}function D(O){O.removeEventListener("dispose",N),L(O),ot(O)}function V(){for(let O of p){let T=O.deref();T!==void 0&&(T.isRenderTarget===!0?D(T):k(T))}p.clear(),h.clear()}function X(O){let T=i.get(O);if(T.__webglInit===void 0)return;let q=O.source,ut=f.get(q);if(ut){let at=ut[T.__cacheKey];at.usedTimes--,at.usedTimes===0&&W(O),Object.keys(ut).length===0&&f.delete(q)}i.remove(O)}function W(O){let T=i.get(O);n.deleteTexture(T.__webglTexture);let q=O.source,ut=f.get(q);delete ut[T.__cacheKey],o.memory.textures--}function ot(O){let T=i.get(O);T.__depthDisposeCallback&&T.__depthDisposeCallback();let q=O.depthTexture;if(q&&q.renderTarget===O&&k(q),O.isWebGLCubeRenderTarget)for(let at=0;at<6;at++){if(Array.isArray(T.__webglFramebuffer[at]))for(let _t=0;_t<T.__webglFramebuffer[at].length;_t++)n.deleteFramebuffer(T.__webglFramebuffer[at][_t]);else n.deleteFramebuffer(T.__webglFramebuffer[at]);T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer[at])}else{if(Array.isArray(T.__webglFramebuffer))for(let at=0;at<T.__webglFramebuffer.length;at++)n.deleteFramebuffer(T.__webglFramebuffer[at]);else n.deleteFramebuffer(T.__webglFramebuffer);if(T.__webglDepthbuffer&&n.deleteRenderbuffer(T.__webglDepthbuffer),T.__webglMultisampledFramebuffer&&n.deleteFramebuffer(T.__webglMultisampledFramebuffer),T.__webglColorRenderbuffer)for(let at=0;at<T.__webglColorRenderbuffer.length;at++)T.__webglColorRenderbuffer[at]&&n.deleteRenderbuffer(T.__webglColorRenderbuffer[at]);T.__webglDepthRenderbuffer&&n.deleteRenderbuffer(T.__webglDepthRenderbuffer)}let ut=O.textures;for(let at=0,_t=ut.length;at<_t;at++){let yt=i.get(ut[at]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ut[at])}i.remove(O)}let Z=0;function Q(){Z=0}function it(){return Z}function ft(O){Z=O}function dt(){let O=Z;return O>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(O+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,O}function tt(O){let T=[];return T.push(O.wrapS),T.push(O.wrapT),T.push(O.wrapR||0),T.push(O.magFilter),T.push(O.minFilter),T.push(O.anisotropy),T.push(O.internalFormat),T.push(O.format),T.push(O.type),T.push(O.generateMipmaps),T.push(O.mipmapsAutoUpdate),T.push(O.premultiplyAlpha),T.push(O.flipY),T.push(O.unpackAlignment),T.push(O.colorSpace),T.join()}function ht(O,T){let q=i.get(O);if(O.isVideoTexture&&Fe(O),O.isRenderTargetTexture===!1&&O.isExternalTexture!==!0&&O.version>0&&q.__version!==O.version){let ut=O.image;if(ut===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ut.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{Ve(q,O,T);return}}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+T)}function gt(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Ve(q,O,T);return}else O.isExternalTexture&&(q.__webglTexture=O.sourceTexture?O.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+T)}function St(O,T){let q=i.get(O);if(O.isRenderTargetTexture===!1&&O.version>0&&q.__version!==O.version){Ve(q,O,T);return}e.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+T)}function Mt(O,T){let q=i.get(O);if(O.version>0&&q.__version!==O.version){cn(q,O,T);return}e.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+T)}let Ht={[Xl]:n.REPEAT,[qi]:n.CLAMP_TO_EDGE,[ql]:n.MIRRORED_REPEAT},se={[In]:n.NEAREST,[km]:n.NEAREST_MIPMAP_NEAREST,[Da]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[vc]:n.LINEAR_MIPMAP_NEAREST,[bs]:n.LINEAR_MIPMAP_LINEAR},Vt={[Gm]:n.NEVER,[Sd]:n.ALWAYS,[Hm]:n.LESS,[vd]:n.LEQUAL,[Wm]:n.EQUAL,[bd]:n.GEQUAL,[$m]:n.GREATER,[Xm]:n.NOTEQUAL};function he(O,T){if(T.type===bi&&t.has("OES_texture_float_linear")===!1&&(T.magFilter===Zn||T.magFilter===vc||T.magFilter===Da||T.magFilter===bs||T.minFilter===Zn||T.minFilter===vc||T.minFilter===Da||T.minFilter===bs)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(O,n.TEXTURE_WRAP_S,Ht[T.wrapS]),n.texParameteri(O,n.TEXTURE_WRAP_T,Ht[T.wrapT]),(O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY)&&n.texParameteri(O,n.TEXTURE_WRAP_R,Ht[T.wrapR]),n.texParameteri(O,n.TEXTURE_MAG_FILTER,se[T.magFilter]),n.texParameteri(O,n.TEXTURE_MIN_FILTER,se[T.minFilter]),T.compareFunction&&(n.texParameteri(O,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(O,n.TEXTURE_COMPARE_FUNC,Vt[T.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(T.magFilter===In||T.minFilter!==Da&&T.minFilter!==bs||T.type===bi&&t.has("OES_texture_float_linear")===!1)return;if(T.anisotropy>1||i.get(T).__currentAnisotropy){let q=t.get("EXT_texture_filter_anisotropic");n.texParameterf(O,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(T.anisotropy,s.getMaxAnisotropy())),i.get(T).__currentAnisotropy=T.anisotropy}}}function le(O,T){let q=!1;O.__webglInit===void 0&&(O.__webglInit=!0,T.addEventListener("dispose",P),I(T));let ut=T.source,at=f.get(ut);at===void 0&&(at={},f.set(ut,at));let _t=tt(T);if(_t!==O.__cacheKey){at[_t]===void 0&&(at[_t]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),at[_t].usedTimes++;let yt=at[O.__cacheKey];yt!==void 0&&(at[O.__cacheKey].usedTimes--,yt.usedTimes===0&&W(T)),O.__cacheKey=_t,O.__webglTexture=at[_t].texture}return q}function ne(O,T,q){return Math.floor(Math.floor(O/q)/T)}function Ye(O,T,q,ut){let _t=O.updateRanges;if(_t.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,T.width,T.height,q,ut,T.data);else{_t.sort((B,rt)=>B.start-rt.start);let yt=0;for(let B=1;B<_t.length;B++){let rt=_t[yt],nt=_t[B],At=rt.start+rt.count,xt=ne(nt.start,T.width,4),bt=ne(rt.start,T.width,4);nt.start<=At+1&&xt===bt&&ne(nt.start+nt.count-1,T.width,4)===xt?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,_t[yt]=nt)}_t.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,T.width);for(let B=0,rt=_t.length;B<rt;B++){let nt=_t[B],At=Math.floor(nt.start/4),xt=Math.ceil(nt.count/4),bt=At%T.width,Gt=Math.floor(At/T.width),Jt=xt,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Jt,ct,q,ut,T.data)}O.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Ve(O,T,q){let ut=n.TEXTURE_2D;(T.isDataArrayTexture||T.isCompressedArrayTexture)&&(ut=n.TEXTURE_2D_ARRAY),T.isData3DTexture&&(ut=n.TEXTURE_3D);let at=le(O,T),_t=T.source;e.bindTexture(ut,O.__webglTexture,n.TEXTURE0+q);let yt=i.get(_t);if(_t.version!==yt.__version||at===!0){if(e.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&T.image instanceof ImageBitmap)===!1){let ct=xe.getPrimaries(xe.workingColorSpace),Ft=T.colorSpace===Ms?null:xe.getPrimaries(T.colorSpace),jt=T.colorSpace===Ms||ct===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,jt)}e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment);let st=x(T.image,!1,s.maxTextureSize);st=zt(T,st);let mt=r.convert(T.format,T.colorSpace),B=r.convert(T.type),rt=E(T.internalFormat,mt,B,T.normalized,T.colorSpace,T.isVideoTexture);he(ut,T);let nt,At=T.mipmaps,xt=T.isVideoTexture!==!0,bt=yt.__version===void 0||at===!0,Gt=_t.dataReady,Jt=w(T,st);if(T.isDepthTexture)rt=y(T.format===Ss,T.type),bt&&(xt?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,null));else if(T.isDataTexture)if(At.length>0){xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data);T.generateMipmaps=!1}else xt?(bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height),Gt&&Ye(T,st,mt,B)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,st.data);else if(T.isCompressedTexture)if(T.isCompressedArrayTexture){xt&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,At[0].width,At[0].height,st.depth);for(let ct=0,Ft=At.length;ct<Ft;ct++)if(nt=At[ct],T.format!==Di)if(mt!==null)if(xt){if(Gt)if(T.layerUpdates.size>0){let jt=Ld(nt.width,nt.height,T.format,T.type);for(let Ct of T.layerUpdates){let oe=nt.data.subarray(Ct*jt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*jt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xt?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,B,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,B,nt.data);T.layerUpdates.size>0&&T.clearLayerUpdates()}else{xt&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],T.format!==Di?mt!==null?xt?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data)}else if(T.isDataArrayTexture)if(xt){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,st.width,st.height,st.depth),Gt)if(T.layerUpdates.size>0){let ct=Ld(st.width,st.height,T.format,T.type);for(let Ft of T.layerUpdates){let jt=st.data.subarray(Ft*ct/st.data.BYTES_PER_ELEMENT,(Ft+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,st.width,st.height,1,mt,B,jt)}T.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isData3DTexture)xt?(bt&&e.texStorage3D(n.TEXTURE_3D,Jt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(T.isFramebufferTexture){if(bt)if(xt)e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height);else{let ct=st.width,Ft=st.height;for(let jt=0;jt<Jt;jt++)e.texImage2D(n.TEXTURE_2D,jt,rt,ct,Ft,0,mt,B,null),ct>>=1,Ft>>=1}}else if(T.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),h.add(T),ct.onpaint=Ft=>{let jt=Ft.changedElements;for(let Ct of h)jt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let jt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,jt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(xt&&bt){let ct=$t(At[0]);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],xt?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,B,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,B,nt);T.generateMipmaps=!1}else if(xt){if(bt){let ct=$t(st);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,B,st);b(T)&&T.mipmapsAutoUpdate===!0&&v(ut),yt.__version=_t.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function cn(O,T,q){if(T.image.length!==6)return;let ut=le(O,T),at=T.source;e.bindTexture(n.TEXTURE_CUBE_MAP,O.__webglTexture,n.TEXTURE0+q);let _t=i.get(at);if(at.version!==_t.__version||ut===!0){e.activeTexture(n.TEXTURE0+q);let yt=xe.getPrimaries(xe.workingColorSpace),et=T.colorSpace===Ms?null:xe.getPrimaries(T.colorSpace),st=T.colorSpace===Ms||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,T.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,T.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,T.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=T.isCompressedTexture||T.image[0].isCompressedTexture,B=T.image[0]&&T.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!B?rt[Ct]=x(T.image[Ct],!0,s.maxCubemapSize):rt[Ct]=B?T.image[Ct].image:T.image[Ct],rt[Ct]=zt(T,rt[Ct]);let nt=rt[0],At=r.convert(T.format,T.colorSpace),xt=r.convert(T.type),bt=E(T.internalFormat,At,xt,T.normalized,T.colorSpace),Gt=T.isVideoTexture!==!0,Jt=_t.__version===void 0||ut===!0,ct=at.dataReady,Ft=w(T,nt);he(n.TEXTURE_CUBE_MAP,T);let jt;if(T.isDepthTexture){if(bt=y(T.format===Ss,T.type),Jt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,xt,null)}else if(mt){Gt&&Jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){jt=rt[Ct].mipmaps;for(let oe=0;oe<jt.length;oe++){let Ge=jt[oe];T.format!==Di?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Ge.width,Ge.height,At,Ge.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Ge.width,Ge.height,0,Ge.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Ge.width,Ge.height,At,xt,Ge.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Ge.width,Ge.height,0,At,xt,Ge.data)}}}else{if(jt=T.mipmaps,Gt&&Jt){jt.length>0&&Ft++;let Ct=$t(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,At,xt,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,At,xt,rt[Ct].data);for(let oe=0;oe<jt.length;oe++){let Vn=jt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,Vn.width,Vn.height,At,xt,Vn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,Vn.width,Vn.height,0,At,xt,Vn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,xt,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,xt,rt[Ct]);for(let oe=0;oe<jt.length;oe++){let Ge=jt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,xt,Ge.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,xt,Ge.image[Ct])}}}b(T)&&T.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),_t.__version=at.version,T.onUpdate&&T.onUpdate(T)}O.__version=T.version}function Ne(O,T,q,ut,at,_t){let yt=r.convert(q.format,q.colorSpace),et=r.convert(q.type),st=E(q.internalFormat,yt,et,q.normalized,q.colorSpace),mt=i.get(T),B=i.get(q);if(B.__renderTarget=T,!mt.__hasExternalTextures){let rt=Math.max(1,T.width>>_t),nt=Math.max(1,T.height>>_t);at===n.TEXTURE_3D||at===n.TEXTURE_2D_ARRAY?e.texImage3D(at,_t,st,rt,nt,T.depth,0,yt,et,null):e.texImage2D(at,_t,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,O),wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,at,B.__webglTexture,0,re(T)):(at===n.TEXTURE_2D||at>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&at<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ut,at,B.__webglTexture,_t),e.bindFramebuffer(n.FRAMEBUFFER,null)}function An(O,T,q){if(n.bindRenderbuffer(n.RENDERBUFFER,O),T.depthBuffer){let ut=T.depthTexture,at=ut&&ut.isDepthTexture?ut.type:null,_t=y(T.stencilBuffer,at),yt=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),_t,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),_t,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,_t,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,O)}else{let ut=T.textures;for(let at=0;at<ut.length;at++){let _t=ut[at],yt=r.convert(_t.format,_t.colorSpace),et=r.convert(_t.type),st=E(_t.internalFormat,yt,et,_t.normalized,_t.colorSpace);wt(T)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(T),st,T.width,T.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(T),st,T.width,T.height):n.renderbufferStorage(n.RENDERBUFFER,st,T.width,T.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(O,T,q){let ut=T.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,O),!(T.depthTexture&&T.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let at=i.get(T.depthTexture);at.__renderTarget=T;let _t=ut?T.depthTexture.image[0]:T.depthTexture.image;(!at.__webglTexture||_t.width!==T.width||_t.height!==T.height)&&(_t.width=T.width,_t.height=T.height,T.depthTexture.needsUpdate=!0),ut?Mt(T.depthTexture,0):ht(T.depthTexture,0);let yt=at.__webglTexture,et=re(T),st=ut?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,mt=T.depthTexture.format===Ss?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(T.depthTexture.format===ms)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(T.depthTexture.format===Ss)wt(T)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(O){let T=i.get(O),q=O.isWebGLCubeRenderTarget===!0;if(T.__boundDepthTexture!==O.depthTexture){let ut=O.depthTexture;if(T.__depthDisposeCallback&&T.__depthDisposeCallback(),ut){let at=()=>{delete T.__boundDepthTexture,delete T.__depthDisposeCallback,ut.removeEventListener("dispose",at)};ut.addEventListener("dispose",at),T.__depthDisposeCallback=at}T.__boundDepthTexture=ut}if(O.depthTexture&&!T.__autoAllocateDepthBuffer)if(q)for(let ut=0;ut<6;ut++)ye(T.__webglFramebuffer[ut],O,ut);else O.texture.mipmaps.length>0?ye(T.__webglFramebuffer[0],O,0):ye(T.__webglFramebuffer,O,0);else if(q){T.__webglDepthbuffer=[];for(let ut=0;ut<6;ut++)if(e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[ut]),T.__webglDepthbuffer[ut]===void 0)T.__webglDepthbuffer[ut]=n.createRenderbuffer(),An(T.__webglDepthbuffer[ut],O,!1);else{let at=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer[ut];n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}}else if(O.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,T.__webglFramebuffer),T.__webglDepthbuffer===void 0)T.__webglDepthbuffer=n.createRenderbuffer(),An(T.__webglDepthbuffer,O,!1);else{let at=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=T.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_t),n.framebufferRenderbuffer(n.FRAMEBUFFER,at,n.RENDERBUFFER,_t)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Je(O,T,q){let ut=i.get(O);T!==void 0&&Ne(ut.__webglFramebuffer,O,O.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&xn(O)}function un(O){let T=O.texture,q=i.get(O),ut=i.get(T);O.addEventListener("dispose",N),I(O);let at=O.textures,_t=O.isWebGLCubeRenderTarget===!0,yt=at.length>1;if(yt||(ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture()),ut.__version=T.version,o.memory.textures++),_t){q.__webglFramebuffer=[];for(let et=0;et<6;et++)if(T.mipmaps.length>0){q.__webglFramebuffer[et]=[];for(let st=0;st<T.mipmaps.length;st++)q.__webglFramebuffer[et][st]=n.createFramebuffer()}else q.__webglFramebuffer[et]=n.createFramebuffer()}else{if(T.mipmaps.length>0){q.__webglFramebuffer=[];for(let et=0;et<T.mipmaps.length;et++)q.__webglFramebuffer[et]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=at.length;et<st;et++){let mt=i.get(at[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(O.samples>0&&wt(O)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let et=0;et<at.length;et++){let st=at[et];q.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),rt=E(st.internalFormat,mt,B,st.normalized,st.colorSpace,O.isXRRenderTarget===!0),nt=re(O);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,O.width,O.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,q.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),O.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),An(q.__webglDepthRenderbuffer,O,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_t){e.bindTexture(n.TEXTURE_CUBE_MAP,ut.__webglTexture),he(n.TEXTURE_CUBE_MAP,T);for(let et=0;et<6;et++)if(T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Ne(q.__webglFramebuffer[et][st],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Ne(q.__webglFramebuffer[et],O,T,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);b(T)?v(n.TEXTURE_CUBE_MAP):T.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=at.length;et<st;et++){let mt=at[et],B=i.get(mt),rt=n.TEXTURE_2D;(O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(rt=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),he(rt,mt),Ne(q.__webglFramebuffer,O,mt,n.COLOR_ATTACHMENT0+et,rt,0),b(mt)&&v(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((O.isWebGL3DRenderTarget||O.isWebGLArrayRenderTarget)&&(et=O.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ut.__webglTexture),he(et,T),T.mipmaps.length>0)for(let st=0;st<T.mipmaps.length;st++)Ne(q.__webglFramebuffer[st],O,T,n.COLOR_ATTACHMENT0,et,st);else Ne(q.__webglFramebuffer,O,T,n.COLOR_ATTACHMENT0,et,0);b(T)?v(et):T.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,T.mipmaps.length-1),e.unbindTexture()}O.depthBuffer&&xn(O)}function z(O){let T=O.textures;for(let q=0,ut=T.length;q<ut;q++){let at=T[q];if(b(at)&&at.mipmapsAutoUpdate===!0){let _t=A(O),yt=i.get(at).__webglTexture;e.bindTexture(_t,yt),v(_t),e.unbindTexture()}}}let Rt=[];function Yt(O){if(O.samples>0){if(wt(O)===!1){let T=O.textures,q=O.width,ut=O.height,at=n.COLOR_BUFFER_BIT,_t=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(O),et=T.length>1;if(et)for(let mt=0;mt<T.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),O.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<T.length;mt++){if(O.resolveDepthBuffer&&(O.depthBuffer&&(at|=n.DEPTH_BUFFER_BIT),O.stencilBuffer&&O.resolveStencilBuffer&&(at|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,ut,0,0,q,ut,at,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&Rt.push(_t),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<T.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(T[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(O.depthBuffer&&O.storeMultisampledDepthBuffer===!1&&l){let T=O.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[T])}}}function re(O){return Math.min(s.maxSamples,O.samples)}function wt(O){let T=i.get(O);return O.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&T.__useRenderToTexture!==!1}function Fe(O){let T=o.render.frame;u.get(O)!==T&&(u.set(O,T),O.update())}function zt(O,T){let q=O.colorSpace,ut=O.format,at=O.type;return O.isCompressedTexture===!0||O.isVideoTexture===!0||q!==ha&&q!==Ms&&(xe.getTransfer(q)===Te?(ut!==Di||at!==Qn)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",q)),T}function $t(O){return typeof HTMLImageElement<"u"&&O instanceof HTMLImageElement?(c.width=O.naturalWidth||O.width,c.height=O.naturalHeight||O.height):typeof VideoFrame<"u"&&O instanceof VideoFrame?(c.width=O.displayWidth,c.height=O.displayHeight):(c.width=O.width,c.height=O.height),c}this.allocateTextureUnit=dt,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=ft,this.setTexture2D=ht,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=Je,this.setupRenderTarget=un,this.updateRenderTargetMipmap=z,this.updateMultisampleRenderTarget=Yt,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ne,this.useMultisampledRTT=wt,this.dispose=V}function $1(n,t){function e(i,s=Ms){let r,o=xe.getTransfer(s);if(i===Qn)return n.UNSIGNED_BYTE;if(i===Sc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Mc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===pd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===md)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===dd)return n.BYTE;if(i===fd)return n.SHORT;if(i===_o)return n.UNSIGNED_SHORT;if(i===bc)return n.INT;if(i===Li)return n.UNSIGNED_INT;if(i===bi)return n.FLOAT;if(i===Ni)return n.HALF_FLOAT;if(i===gd)return n.ALPHA;if(i===xd)return n.RGB;if(i===Di)return n.RGBA;if(i===ms)return n.DEPTH_COMPONENT;if(i===Ss)return n.DEPTH_STENCIL;if(i===wc)return n.RED;if(i===Ac)return n.RED_INTEGER;if(i===Js)return n.RG;if(i===Ec)return n.RG_INTEGER;if(i===Tc)return n.RGBA_INTEGER;if(i===Oa||i===Ua||i===Fa||i===ka)if(o===Te)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Oa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Ua)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Oa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Ua)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Fa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ka)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Cc||i===Rc||i===Pc||i===Ic)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Cc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Rc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Pc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Ic)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Lc||i===Nc||i===Dc||i===Oc||i===Uc||i===Ba||i===Fc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Lc||i===Nc)return o===Te?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Dc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Oc)return r.COMPRESSED_R11_EAC;if(i===Uc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ba)return r.COMPRESSED_RG11_EAC;if(i===Fc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===kc||i===Bc||i===zc||i===Vc||i===Gc||i===Hc||i===Wc||i===$c||i===Xc||i===qc||i===Yc||i===Zc||i===Kc||i===Jc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===kc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Bc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===zc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Vc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Gc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Hc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Wc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===$c)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Xc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===qc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Yc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Zc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Kc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Jc)return o===Te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===jc||i===Qc||i===tu)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===jc)return o===Te?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Qc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===tu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===eu||i===nu||i===za||i===iu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===eu)return r.COMPRESSED_RED_RGTC1_EXT;if(i===nu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===za)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===iu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===yr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var X1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,q1=`
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

}`,Vd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Sa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ki({vertexShader:X1,fragmentShader:q1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Dn(new wa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Gd=class extends Ii{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,p=null,_=typeof XRWebGLBinding<"u",m=new Vd,g={},x=e.getContextAttributes(),b=null,v=null,A=[],E=[],y=new Zt,w=null,I=null,L=new Yn;L.viewport=new ke;let P=new Yn;P.viewport=new ke;let N=[L,P],k=new gc,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ht=A[tt];return ht===void 0&&(ht=new co,A[tt]=ht),ht.getTargetRaySpace()},this.getControllerGrip=function(tt){let ht=A[tt];return ht===void 0&&(ht=new co,A[tt]=ht),ht.getGripSpace()},this.getHand=function(tt){let ht=A[tt];return ht===void 0&&(ht=new co,A[tt]=ht),ht.getHandSpace()};function X(tt){let ht=E.indexOf(tt.inputSource);if(ht===-1)return;let gt=A[ht];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function W(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",ot);for(let tt=0;tt<A.length;tt++){let ht=E[tt];ht!==null&&(E[tt]=null,A[tt].disconnect(ht))}D=null,V=null,m.reset();for(let tt in g)delete g[tt];if(t.setRenderTarget(b),f=null,d=null,h=null,s=null,v=null,dt.stop(),i.isPresenting=!1,t.setPixelRatio(w),t.setSize(y.width,y.height,!1),I!==null){let tt=I.camera;tt.fov=I.fov,tt.zoom=I.zoom,tt.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&_&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",W),s.addEventListener("inputsourceschange",ot),x.xrCompatible!==!0&&await e.makeXRCompatible(),w=t.getPixelRatio(),t.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;x.depth&&(Mt=x.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=x.stencil?Ss:ms,St=x.stencil?yr:Li);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new hi(d.textureWidth,d.textureHeight,{format:Di,type:Qn,depthTexture:new ys(d.textureWidth,d.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:x.stencil,colorSpace:t.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let gt={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new hi(f.framebufferWidth,f.framebufferHeight,{format:Di,type:Qn,colorSpace:t.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),dt.setContext(s),dt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ot(tt){for(let ht=0;ht<tt.removed.length;ht++){let gt=tt.removed[ht],St=E.indexOf(gt);St>=0&&(E[St]=null,A[St].disconnect(gt))}for(let ht=0;ht<tt.added.length;ht++){let gt=tt.added[ht],St=E.indexOf(gt);if(St===-1){for(let Ht=0;Ht<A.length;Ht++)if(Ht>=E.length){E.push(gt),St=Ht;break}else if(E[Ht]===null){E[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=A[St];Mt&&Mt.connect(gt)}}function Z(tt,ht){ht===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ht.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ht=tt.near,gt=tt.far;m.texture!==null&&(m.depthNear>0&&(ht=m.depthNear),m.depthFar>0&&(gt=m.depthFar)),k.near=P.near=L.near=ht,k.far=P.far=L.far=gt,(D!==k.near||V!==k.far)&&(s.updateRenderState({depthNear:k.near,depthFar:k.far}),D=k.near,V=k.far),k.layers.mask=tt.layers.mask|6,L.layers.mask=k.layers.mask&-5,P.layers.mask=k.layers.mask&-3;let St=tt.parent,Mt=k.cameras;Z(k,St);for(let Ht=0;Ht<Mt.length;Ht++)Z(Mt[Ht],St);k.projectionMatrix.copy(L.projectionMatrix),k.projectionMatrixInverse.copy(L.projectionMatrixInverse),I===null&&tt.isPerspectiveCamera&&(I={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,k,St)};function Q(tt,ht,gt){gt===null?tt.matrix.copy(ht.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ht.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ht.projectionMatrix),tt.projectionMatrixInverse.copy(ht.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=oo*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return k},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(tt){l=tt,d!==null&&(d.fixedFoveation=tt),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=tt)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(k)},this.getCameraTexture=function(tt){return g[tt]};let it=null;function ft(tt,ht){if(u=ht.getViewerPose(c||o),p=ht,u!==null){let gt=u.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let St=!1;gt.length!==k.cameras.length&&(k.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt],le=null;if(f!==null)le=f.getViewport(he);else{let Ye=h.getViewSubImage(d,he);le=Ye.viewport,Vt===0&&(t.setRenderTargetTextures(v,Ye.colorTexture,Ye.depthStencilTexture),t.setRenderTarget(v))}let ne=N[Vt];ne===void 0&&(ne=new Yn,ne.layers.enable(Vt),ne.viewport=new ke,N[Vt]=ne),ne.matrix.fromArray(he.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(he.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(le.x,le.y,le.width,le.height),Vt===0&&(k.matrix.copy(ne.matrix),k.matrix.decompose(k.position,k.quaternion,k.scale)),St===!0&&k.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){h=i.getBinding();let Vt=h.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&m.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&_){t.state.unbindTexture(),h=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt].camera;if(he){let le=g[he];le||(le=new Sa,g[he]=le);let ne=h.getCameraImage(he);le.sourceTexture=ne}}}}for(let gt=0;gt<A.length;gt++){let St=E[gt],Mt=A[gt];St!==null&&Mt!==void 0&&Mt.update(St,ht,c||o)}it&&it(tt,ht),ht.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ht}),p=null}let dt=new Ag;dt.setAnimationLoop(ft),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},Y1=new ae,Og=new te;Og.set(-1,0,0,0,1,0,0,0,1);function Z1(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Rd(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,x,b,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),h(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),_(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,x,b):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===Kn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===Kn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let x=t.get(g),b=x.envMap,v=x.envMapRotation;b&&(m.envMap.value=b,m.envMapRotation.value.setFromMatrix4(Y1.makeRotationFromEuler(v)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Og),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,x,b){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*x,m.scale.value=b*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function h(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,x){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===Kn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=x.texture,m.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function _(m,g){let x=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(x.matrixWorld),m.nearDistance.value=x.shadow.camera.near,m.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function K1(n,t,e,i){let s={},r={};function o(x,b){let v=b.program;i.uniformBlockBinding(x,v,s[x.id])}function a(x,b){let v=s[x.id];v===void 0&&(p(x),v=l(x),s[x.id]=v,x.addEventListener("dispose",m));let A=b.program;i.updateUBOMapping(x,A);let E=t.render.frame;r[x.id]!==E&&(c(x),r[x.id]=E)}function l(x){let b=n.createBuffer(),v=x.__size,A=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,v,A),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function c(x){let b=s[x.id],v=x.uniforms,A=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let E=0,y=v.length;E<y;E++){let w=v[E];if(Array.isArray(w))for(let I=0,L=w.length;I<L;I++)u(w[I],E,I,A);else u(w,E,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(x,b,v,A){if(d(x,b,v,A)===!0){let E=x.__offset,y=x.value;if(Array.isArray(y)){let w=0;for(let I=0;I<y.length;I++){let L=y[I],P=_(L,!0);h(L,x.__data,w),w+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,x.__data)}}function h(x,b,v){typeof x=="number"||typeof x=="boolean"?b[v]=x:x.isMatrix3?(b[v]=x.elements[0],b[v+1]=x.elements[1],b[v+2]=x.elements[2],b[v+3]=0,b[v+4]=x.elements[3],b[v+5]=x.elements[4],b[v+6]=x.elements[5],b[v+7]=0,b[v+8]=x.elements[6],b[v+9]=x.elements[7],b[v+10]=x.elements[8],b[v+11]=0):ArrayBuffer.isView(x)?b.set(x.subarray(0,b.length-v),v):x.toArray(b,v)}function d(x,b,v,A){let E=x.value,y=b+"_"+v;if(Array.isArray(E)){A[y]===void 0&&(A[y]=[]);let w=A[y],I=!1;for(let L=0;L<E.length;L++)f(E[L],w,L)===!0&&(I=!0);return I}return f(E,A,y)}function f(x,b,v){if(b[v]===void 0)return typeof x=="number"||typeof x=="boolean"?b[v]=x:ArrayBuffer.isView(x)?b[v]=x.slice():b[v]=x.clone(),!0;{let A=b[v];if(typeof x=="number"||typeof x=="boolean"){if(A!==x)return b[v]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(A.equals(x)===!1)return A.copy(x),!0}}return!1}function p(x){let b=x.uniforms,v=0,A=16;for(let y=0,w=b.length;y<w;y++){let I=Array.isArray(b[y])?b[y]:[b[y]];for(let L=0,P=I.length;L<P;L++){let N=I[L],k=Array.isArray(N.value)?N.value:[N.value],D=Array.isArray(b[y])||Array.isArray(N.value),V=v;for(let W=0,ot=k.length;W<ot;W++){let Z=k[W],Q=_(Z,D),it=v%A,ft=it%Q.boundary,dt=it+ft;v+=ft,dt!==0&&A-dt<Q.storage&&(v+=A-dt),W===0&&(V=v),v+=Q.storage}let X=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new X((v-V)/Float32Array.BYTES_PER_ELEMENT),N.__offset=V}}let E=v%A;return E>0&&(v+=A-E),x.__size=v,x.__cache={},this}function _(x,b){let v={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(v.boundary=4,v.storage=4):x.isVector2?(v.boundary=8,v.storage=8):x.isVector3||x.isColor?(v.boundary=16,v.storage=12):x.isVector4?(v.boundary=16,v.storage=16):x.isMatrix3?(v.boundary=16,v.storage=48):x.isMatrix4?(v.boundary=16,v.storage=64):x.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(v.boundary=16,v.storage=x.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",x),b===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(x){let b=x.target;b.removeEventListener("dispose",m),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function g(){for(let x in s)n.deleteBuffer(s[x]);s={},r={}}return{bind:o,update:a,dispose:g}}var J1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ji=null;function j1(){return ji===null&&(ji=new _a(J1,16,16,Js,Ni),ji.name="DFG_LUT",ji.minFilter=Zn,ji.magFilter=Zn,ji.wrapS=qi,ji.wrapT=qi,ji.generateMipmaps=!1,ji.needsUpdate=!0),ji}var lu=class{constructor(t={}){let{canvas:e=Ym(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Qn}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let _=f,m=new Set([Tc,Ec,Ac]),g=new Set([Qn,Li,_o,yr,Sc,Mc]),x=new Uint32Array(4),b=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,E=null,y=[],w=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ji,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,P=!1,N=null,k=null,D=null,V=null;this._outputColorSpace=li;let X=0,W=0,ot=null,Z=-1,Q=null,it=new ke,ft=new ke,dt=null,tt=new Xt(0),ht=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new ke(0,0,gt,St),he=new ke(0,0,gt,St),le=!1,ne=new Hs,Ye=new jl,Ve=!1,cn=!1,Ne=new ae,An=new G,ye=new ke,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Je=!1;function un(){return ot===null?Mt:1}let z=i;function Rt(R,H){return e.getContext(R,H)}let Yt,re,wt,Fe,zt,$t,O,T,q,ut,at,_t,yt,et,st,mt,B,rt,nt,At,xt,bt,Gt;try{let R={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",jt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),z===null){let H="webgl2";if(z=Rt(H,R),z===null)throw Rt(H)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(R){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),Qt("WebGLRenderer: "+R.message),R}function Jt(){Yt=new cw(z),Yt.init(),xt=new $1(z,Yt),re=new jM(z,Yt,t,xt),wt=new H1(z,Yt),re.reversedDepthBuffer&&d&&wt.buffers.depth.setReversed(!0),k=z.createFramebuffer(),D=z.createFramebuffer(),V=z.createFramebuffer(),Fe=new dw(z),zt=new R1,$t=new W1(z,Yt,wt,zt,re,xt,Fe),O=new lw(L),T=new pb(z),bt=new KM(z,T),q=new uw(z,T,Fe,bt),ut=new pw(z,q,T,bt,Fe),rt=new fw(z,re,$t),st=new QM(zt),at=new C1(L,O,Yt,re,bt,st),_t=new Z1(L,zt),yt=new I1,et=new F1(Yt),B=new ZM(L,O,wt,ut,p,l),mt=new G1(L,ut,re),Gt=new K1(z,Fe,re,wt),nt=new JM(z,Yt,Fe),At=new hw(z,Yt,Fe),Fe.programs=at.programs,L.capabilities=re,L.extensions=Yt,L.properties=zt,L.renderLists=yt,L.shadowMap=mt,L.state=wt,L.info=Fe}_!==Qn&&(I=new gw(_,e.width,e.height,a,s,r));let ct=new Gd(L,z);this.xr=ct,this.getContext=function(){return z},this.getContextAttributes=function(){return z.getContextAttributes()},this.forceContextLoss=function(){let R=Yt.get("WEBGL_lose_context");R&&R.loseContext()},this.forceContextRestore=function(){let R=Yt.get("WEBGL_lose_context");R&&R.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(R){R!==void 0&&(Mt=R,this.setSize(gt,St,!1))},this.getSize=function(R){return R.set(gt,St)},this.setSize=function(R,H,j=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=R,St=H,e.width=Math.floor(R*Mt),e.height=Math.floor(H*Mt),j===!0&&(e.style.width=R+"px",e.style.height=H+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,R,H)},this.getDrawingBufferSize=function(R){return R.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(R,H,j){gt=R,St=H,Mt=j,e.width=Math.floor(R*j),e.height=Math.floor(H*j),this.setViewport(0,0,R,H)},this.setEffects=function(R){if(_===Qn){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(R){for(let H=0;H<R.length;H++)if(R[H].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(R||[])},this.getCurrentViewport=function(R){return R.copy(it)},this.getViewport=function(R){return R.copy(Vt)},this.setViewport=function(R,H,j,Y){R.isVector4?Vt.set(R.x,R.y,R.z,R.w):Vt.set(R,H,j,Y),wt.viewport(it.copy(Vt).multiplyScalar(un()).round())},this.getScissor=function(R){return R.copy(he)},this.setScissor=function(R,H,j,Y){R.isVector4?he.set(R.x,R.y,R.z,R.w):he.set(R,H,j,Y),wt.scissor(ft.copy(he).multiplyScalar(un()).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(R){wt.setScissorTest(le=R)},this.setOpaqueSort=function(R){Ht=R},this.setTransparentSort=function(R){se=R},this.getClearColor=function(R){return R.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(R=!0,H=!0,j=!0){let Y=0;if(R){let K=!1;if(ot!==null){let Et=ot.texture.format;K=m.has(Et)}if(K){let Et=ot.texture.type,Pt=g.has(Et),Tt=B.getClearColor(),It=B.getClearAlpha(),Bt=Tt.r,ee=Tt.g,de=Tt.b;Pt?(x[0]=Bt,x[1]=ee,x[2]=de,x[3]=It,z.clearBufferuiv(z.COLOR,0,x)):(b[0]=Bt,b[1]=ee,b[2]=de,b[3]=It,z.clearBufferiv(z.COLOR,0,b))}else Y|=z.COLOR_BUFFER_BIT}H&&(Y|=z.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=z.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&z.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(R){R.setRenderer(this),N=R},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",jt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),yt.dispose(),et.dispose(),$t.dispose(),zt.dispose(),O.dispose(),ut.dispose(),q.dispose(),bt.dispose(),Gt.dispose(),at.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",cl),ct.removeEventListener("sessionend",ki),is.stop()};function Ft(R){R.preventDefault(),wd("WebGLRenderer: Context Lost."),P=!0}function jt(){wd("WebGLRenderer: Context Restored."),P=!1;let R=Fe.autoReset,H=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,K=mt.type;Jt(),Fe.autoReset=R,mt.enabled=H,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=K}function Ct(R){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",R.statusMessage)}function oe(R){let H=R.target;H.removeEventListener("dispose",oe),Ge(H)}function Ge(R){Vn(R),zt.remove(R)}function Vn(R){let H=zt.get(R).programs;H!==void 0&&(H.forEach(function(j){at.releaseProgram(j)}),R.isShaderMaterial&&at.releaseShaderCache(R))}this.renderBufferDirect=function(R,H,j,Y,K,Et){H===null&&(H=xn);let Pt=K.isMesh&&K.matrixWorld.determinantAffine()<0,Tt=Yo(R,H,j,Y,K);wt.setMaterial(Y,Pt);let It=j.index,Bt=1;if(Y.wireframe===!0){if(It=q.getWireframeAttribute(j),It===void 0)return;Bt=2}let ee=j.drawRange,de=j.attributes.position,kt=ee.start*Bt,fe=(ee.start+ee.count)*Bt;Et!==null&&(kt=Math.max(kt,Et.start*Bt),fe=Math.min(fe,(Et.start+Et.count)*Bt)),It!==null?(kt=Math.max(kt,0),fe=Math.min(fe,It.count)):de!=null&&(kt=Math.max(kt,0),fe=Math.min(fe,de.count));let Ke=fe-kt;if(Ke<0||Ke===1/0)return;bt.setup(K,Y,Tt,j,It);let Re,Pe=nt;if(It!==null&&(Re=T.get(It),Pe=At,Pe.setIndex(Re)),K.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*un()),Pe.setMode(z.LINES)):Pe.setMode(z.TRIANGLES);else if(K.isLine){let _n=Y.linewidth;_n===void 0&&(_n=1),wt.setLineWidth(_n*un()),K.isLineSegments?Pe.setMode(z.LINES):K.isLineLoop?Pe.setMode(z.LINE_LOOP):Pe.setMode(z.LINE_STRIP)}else K.isPoints?Pe.setMode(z.POINTS):K.isSprite&&Pe.setMode(z.TRIANGLES);if(K.isBatchedMesh)if(Yt.get("WEBGL_multi_draw"))Pe.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let _n=K._multiDrawStarts,Ot=K._multiDrawCounts,hn=K._multiDrawCount,ge=It?T.get(It).bytesPerElement:1,rs=zt.get(Y).currentProgram.getUniforms();for(let dn=0;dn<hn;dn++)rs.setValue(z,"_gl_DrawID",dn),Pe.render(_n[dn]/ge,Ot[dn])}else if(K.isInstancedMesh)Pe.renderInstances(kt,Ke,K.count);else if(j.isInstancedBufferGeometry){let _n=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ot=Math.min(j.instanceCount,_n);Pe.renderInstances(kt,Ke,Ot)}else Pe.render(kt,Ke)};function $o(R,H,j,Y){N!==null&&R.isNodeMaterial&&N.setObject(Y,R),Ve===!0&&st.setState(R,j,!1),R.transparent===!0&&R.side===Bn&&R.forceSinglePass===!1?(R.side=Kn,R.needsUpdate=!0,Bi(R,H,Y),R.side=Ks,R.needsUpdate=!0,Bi(R,H,Y),R.side=Bn):Bi(R,H,Y)}this.compile=function(R,H,j=null){j===null&&(j=R),N!==null&&N.renderStart(R,H,j),E=et.get(j),E.init(H),w.push(E),j.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),R!==j&&R.traverseVisible(function(K){K.isLight&&K.layers.test(H.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),E.setupLights(),N!==null&&N.updateLights(E.state.lightsArray),cn=this.localClippingEnabled,Ve=st.init(this.clippingPlanes,cn),Ve===!0&&st.setGlobalState(this.clippingPlanes,H),N!==null&&mt.render(E.state.shadowsArray,j,H);let Y=new Set;return R.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Et=K.material;if(Et)if(Array.isArray(Et))for(let Pt=0;Pt<Et.length;Pt++){let Tt=Et[Pt];$o(Tt,j,H,K),Y.add(Tt)}else $o(Et,j,H,K),Y.add(Et)}),E=w.pop(),N!==null&&N.renderEnd(),Y},this.compileAsync=function(R,H,j=null){let Y=this.compile(R,H,j);return new Promise(K=>{function Et(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){K(R);return}setTimeout(Et,10)}Yt.get("KHR_parallel_shader_compile")!==null?Et():setTimeout(Et,10)})};let Ir=null;function hh(R){Ir&&Ir(R)}function cl(){is.stop()}function ki(){is.start()}let is=new Ag;is.setAnimationLoop(hh),typeof self<"u"&&is.setContext(self),this.setAnimationLoop=function(R){Ir=R,ct.setAnimationLoop(R),R===null?is.stop():is.start()},ct.addEventListener("sessionstart",cl),ct.addEventListener("sessionend",ki),this.render=function(R,H){if(H!==void 0&&H.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;N!==null&&N.renderStart(R,H);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=I!==null&&(ot===null||j)&&I.begin(L,ot);if(R.matrixWorldAutoUpdate===!0&&R.updateMatrixWorld(),H.parent===null&&H.matrixWorldAutoUpdate===!0&&H.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(H),H=ct.getCamera()),R.isScene===!0&&R.onBeforeRender(L,R,H,ot),E=et.get(R,w.length),E.init(H),E.state.textureUnits=$t.getTextureUnits(),w.push(E),Ne.multiplyMatrices(H.projectionMatrix,H.matrixWorldInverse),H.isArrayCamera?Ye.setFromArrayCamera(H):ne.setFromProjectionMatrix(Ne,vi,H.reversedDepth),cn=this.localClippingEnabled,Ve=st.init(this.clippingPlanes,cn),A=yt.get(R,y.length),A.init(),y.push(A),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=L.xr.getDepthSensingMesh();Pt!==null&&ss(Pt,H,-1/0,L.sortObjects)}ss(R,H,0,L.sortObjects),A.finish(),N!==null&&N.updateLights(E.state.lightsArray),L.sortObjects===!0&&A.sort(Ht,se),Je=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Je&&B.addToRenderList(A,R),this.info.autoReset===!0&&this.info.reset(),Ve===!0&&st.beginShadows();let K=E.state.shadowsArray;if(mt.render(K,R,H),Ve===!0&&st.endShadows(),(Y&&I.hasRenderPass())===!1){let Pt=A.opaque,Tt=A.transmissive;if(E.setupLights(),H.isArrayCamera){let It=H.cameras;if(Tt.length>0)for(let Bt=0,ee=It.length;Bt<ee;Bt++){let de=It[Bt];Ai(Pt,Tt,R,de)}Je&&B.render(R);for(let Bt=0,ee=It.length;Bt<ee;Bt++){let de=It[Bt];Xo(A,R,de,de.viewport)}}else Tt.length>0&&Ai(Pt,Tt,R,H),Je&&B.render(R),Xo(A,R,H)}ot!==null&&W===0&&($t.updateMultisampleRenderTarget(ot),$t.updateRenderTargetMipmap(ot)),Y&&I.end(L),R.isScene===!0&&R.onAfterRender(L,R,H),bt.resetDefaultState(),Z=-1,Q=null,w.pop(),w.length>0?(E=w[w.length-1],$t.setTextureUnits(E.state.textureUnits),Ve===!0&&st.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?A=y[y.length-1]:A=null,N!==null&&N.renderEnd()};function ss(R,H,j,Y){if(R.visible===!1)return;if(R.layers.test(H.layers)){if(R.isGroup)j=R.renderOrder;else if(R.isLOD)R.autoUpdate===!0&&R.update(H);else if(R.isLight)E.pushLight(R),R.castShadow&&E.pushShadow(R);else if(R.isSprite){let Pt=H.isArrayCamera?Ye:ne;if(!R.frustumCulled||R.intersectsFrustum(Pt)){Y&&ye.setFromMatrixPosition(R.matrixWorld).applyMatrix4(Ne);let Tt=ut.update(R),It=R.material;It.visible&&A.push(R,Tt,It,j,ye.z,null,H)}}else if(R.isMesh||R.isLine||R.isPoints){let Pt=H.isArrayCamera?Ye:ne;if(!R.frustumCulled||R.intersectsFrustum(Pt)){let Tt=ut.update(R),It=R.material;if(Y&&(R.boundingSphere!==void 0?(R.boundingSphere===null&&R.computeBoundingSphere(),ye.copy(R.boundingSphere.center)):(Tt.boundingSphere===null&&Tt.computeBoundingSphere(),ye.copy(Tt.boundingSphere.center)),ye.applyMatrix4(R.matrixWorld).applyMatrix4(Ne)),Array.isArray(It)){let Bt=Tt.groups;for(let ee=0,de=Bt.length;ee<de;ee++){let kt=Bt[ee],fe=It[kt.materialIndex];fe&&fe.visible&&A.push(R,Tt,fe,j,ye.z,kt,H)}}else It.visible&&A.push(R,Tt,It,j,ye.z,null,H)}}}let Et=R.children;for(let Pt=0,Tt=Et.length;Pt<Tt;Pt++)ss(Et[Pt],H,j,Y)}function Xo(R,H,j,Y){let{opaque:K,transmissive:Et,transparent:Pt}=R;E.setupLightsView(j),Ve===!0&&st.setGlobalState(L.clippingPlanes,j),Y&&wt.viewport(it.copy(Y)),K.length>0&&je(K,H,j),Et.length>0&&je(Et,H,j),Pt.length>0&&je(Pt,H,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function Ai(R,H,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let kt=Yt.has("EXT_color_buffer_half_float")||Yt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new hi(1,1,{generateMipmaps:!0,type:kt?Ni:Qn,minFilter:bs,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:xe.workingColorSpace})}let Et=E.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||it;Et.setSize(Pt.z*L.transmissionResolutionScale,Pt.w*L.transmissionResolutionScale);let Tt=L.getRenderTarget(),It=L.getActiveCubeFace(),Bt=L.getActiveMipmapLevel();L.setRenderTarget(Et),L.getClearColor(tt),ht=L.getClearAlpha(),ht<1&&L.setClearColor(16777215,.5),L.clear(),Je&&B.render(j);let ee=L.toneMapping;L.toneMapping=Ji;let de=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),Ve===!0&&st.setGlobalState(L.clippingPlanes,Y),je(R,j,Y),$t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et),Yt.has("WEBGL_multisampled_render_to_texture")===!1){let kt=!1;for(let fe=0,Ke=H.length;fe<Ke;fe++){let Re=H[fe],{object:Pe,geometry:_n,material:Ot,group:hn}=Re;if(Ot.side===Bn&&Pe.layers.test(Y.layers)){let ge=Ot.side;Ot.side=Kn,Ot.needsUpdate=!0,rn(Pe,j,Y,_n,Ot,hn),Ot.side=ge,Ot.needsUpdate=!0,kt=!0}}kt===!0&&($t.updateMultisampleRenderTarget(Et),$t.updateRenderTargetMipmap(Et))}L.setRenderTarget(Tt,It,Bt),L.setClearColor(tt,ht),de!==void 0&&(Y.viewport=de),L.toneMapping=ee}function je(R,H,j){let Y=H.isScene===!0?H.overrideMaterial:null;for(let K=0,Et=R.length;K<Et;K++){let Pt=R[K],{object:Tt,geometry:It,group:Bt}=Pt,ee=Pt.material;ee.allowOverride===!0&&Y!==null&&(ee=Y),Tt.layers.test(j.layers)&&rn(Tt,H,j,It,ee,Bt)}}function rn(R,H,j,Y,K,Et){N!==null&&K.isNodeMaterial&&N.setObject(R,K),R.onBeforeRender(L,H,j,Y,K,Et),R.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,R.matrixWorld),R.normalMatrix.getNormalMatrix(R.modelViewMatrix),K.onBeforeRender(L,H,j,Y,R,Et),K.transparent===!0&&K.side===Bn&&K.forceSinglePass===!1?(K.side=Kn,K.needsUpdate=!0,L.renderBufferDirect(j,H,Y,K,R,Et),K.side=Ks,K.needsUpdate=!0,L.renderBufferDirect(j,H,Y,K,R,Et),K.side=Bn):L.renderBufferDirect(j,H,Y,K,R,Et),R.onAfterRender(L,H,j,Y,K,Et)}function on(R){let H=0;for(let j of R)j.texture!==null&&H++;return H}function Bi(R,H,j){H.isScene!==!0&&(H=xn);let Y=zt.get(R),K=E.state.lights,Et=E.state.shadowsArray,Pt=K.state.version,Tt=at.getParameters(R,K.state,Et,H,j,E.state.lightProbeGridArray),It=at.getProgramCacheKey(Tt),Bt=Y.programs;Y.environment=R.isMeshStandardMaterial||R.isMeshLambertMaterial||R.isMeshPhongMaterial?H.environment:null,Y.fog=H.fog;let ee=R.isMeshStandardMaterial||R.isMeshLambertMaterial&&!R.envMap||R.isMeshPhongMaterial&&!R.envMap;Y.envMap=O.get(R.envMap||Y.environment,ee),Y.envMapRotation=Y.environment!==null&&R.envMap===null?H.environmentRotation:R.envMapRotation,Bt===void 0&&(R.addEventListener("dispose",oe),Bt=new Map,Y.programs=Bt,Y.programVariants=new Map);let de=Bt.get(It);if(de!==void 0){if(Y.currentProgram===de&&Y.lightsStateVersion===Pt)return qo(R,Tt),de}else Tt.uniforms=at.getUniforms(R),N!==null&&R.isNodeMaterial&&N.build(R,j,Tt),R.onBeforeCompile(Tt,L),de=at.acquireProgram(Tt,It),Bt.set(It,de),Y.uniforms=Tt.uniforms;let kt=Y.uniforms;return(!R.isShaderMaterial&&!R.isRawShaderMaterial||R.clipping===!0)&&(kt.clippingPlanes=st.uniform),qo(R,Tt),Y.needsLights=Ps(R),Y.lightsStateVersion=Pt,Y.needsLights&&(kt.ambientLightColor.value=K.state.ambient,kt.lightProbe.value=K.state.probe,kt.sunLights.value=K.state.sun,kt.sunLightShadows.value=K.state.sunShadow,kt.directionalLights.value=K.state.directional,kt.directionalLightShadows.value=K.state.directionalShadow,kt.spotLights.value=K.state.spot,kt.spotLightShadows.value=K.state.spotShadow,kt.rectAreaLights.value=K.state.rectArea,kt.ltc_1.value=K.state.rectAreaLTC1,kt.ltc_2.value=K.state.rectAreaLTC2,kt.pointLights.value=K.state.point,kt.pointLightShadows.value=K.state.pointShadow,kt.hemisphereLights.value=K.state.hemi,kt.sunShadowMatrix.value=K.state.sunShadowMatrix,kt.sunShadowCascade.value=K.state.sunShadowCascade,kt.directionalShadowMatrix.value=K.state.directionalShadowMatrix,kt.spotLightMatrix.value=K.state.spotLightMatrix,kt.spotLightMap.value=K.state.spotLightMap,kt.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=on(E.state.lightProbeGridArray),Y.currentProgram=de,Y.uniformsList=null,de}function ni(R,H,j,Y,K){let Et=zt.get(R),Pt=Et.currentProgram.id+","+Y+","+K,Tt=Et.programVariants.get(Pt);return Tt===void 0?(Tt=Bi(R,H,j),Et.programVariants.set(Pt,Tt)):(Et.currentProgram=Tt,Et.uniformsList=null,Et.outputColorSpace=Y,Et.toneMapping=K),Tt}function Rs(R){if(R.uniformsList===null){let H=R.currentProgram.getUniforms();R.uniformsList=vo.seqWithValue(H.seq,R.uniforms)}return R.uniformsList}function qo(R,H){let j=zt.get(R);j.outputColorSpace=H.outputColorSpace,j.batching=H.batching,j.batchingColor=H.batchingColor,j.instancing=H.instancing,j.instancingColor=H.instancingColor,j.instancingMorph=H.instancingMorph,j.skinning=H.skinning,j.morphTargets=H.morphTargets,j.morphNormals=H.morphNormals,j.morphColors=H.morphColors,j.morphTargetsCount=H.morphTargetsCount,j.numClippingPlanes=H.numClippingPlanes,j.numIntersection=H.numClipIntersection,j.vertexAlphas=H.vertexAlphas,j.vertexTangents=H.vertexTangents,j.toneMapping=H.toneMapping}function Yo(R,H,j,Y,K){H.isScene!==!0&&(H=xn),$t.resetTextureUnits();let Et=H.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?H.environment:null,Tt=ot===null?L.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:xe.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Bt=O.get(Y.envMap||Pt,It),ee=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,de=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),kt=!!j.morphAttributes.position,fe=!!j.morphAttributes.normal,Ke=!!j.morphAttributes.color,Re=Ji;Y.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Re=L.toneMapping);let Pe=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,_n=Pe!==void 0?Pe.length:0,Ot=zt.get(Y),hn=E.state.lights;if(Ve===!0&&(cn===!0||R!==Q)){let Ie=R===Q&&Y.id===Z;st.setState(Y,R,Ie)}let ge=!1,rs=!1;Y.version===Ot.__version?Ot.needsLights&&Ot.lightsStateVersion!==hn.state.version||K.isBatchedMesh&&Ot.batching===!1||!K.isBatchedMesh&&Ot.batching===!0||K.isBatchedMesh&&Ot.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ot.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ot.instancing===!1||!K.isInstancedMesh&&Ot.instancing===!0||K.isSkinnedMesh&&Ot.skinning===!1||!K.isSkinnedMesh&&Ot.skinning===!0||K.isInstancedMesh&&Ot.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ot.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ot.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ot.instancingMorph===!1&&K.morphTexture!==null||Ot.envMap!==Bt||Y.fog===!0&&Ot.fog!==Et||Ot.numClippingPlanes!==void 0&&(Ot.numClippingPlanes!==st.numPlanes||Ot.numIntersection!==st.numIntersection)||Ot.vertexAlphas!==ee||Ot.vertexTangents!==de||Ot.morphTargets!==kt||Ot.morphNormals!==fe||Ot.morphColors!==Ke||Ot.morphTargetsCount!==_n||Ot.numLightProbeGrids!==on(E.state.lightProbeGridArray)?ge=!0:(Ot.outputColorSpace!==Tt||Ot.toneMapping!==Re)&&(rs=!0):(ge=!0,Ot.__version=Y.version);let dn=Ot.currentProgram;(ge===!0||rs===!0)&&(dn=rs===!0?ni(Y,H,K,Tt,Re):Bi(Y,H,K),N&&Y.isNodeMaterial&&N.onUpdateProgram(Y,dn,Ot));let Dr=!1,zi=!1,os=!1,ce=dn.getUniforms(),Qe=Ot.uniforms;if(wt.useProgram(dn.program)&&(Dr=!0,zi=!0,os=!0),Y.id!==Z&&(Z=Y.id,zi=!0),Dr||Q!==R){wt.buffers.depth.getReversed()&&R.reversedDepth!==!0&&(R._reversedDepth=!0,R.updateProjectionMatrix()),ce.setValue(z,"projectionMatrix",R.projectionMatrix),ce.setValue(z,"viewMatrix",R.matrixWorldInverse);let fn=ce.map.cameraPosition;fn!==void 0&&fn.setValue(z,An.setFromMatrixPosition(R.matrixWorld)),re.logarithmicDepthBuffer&&ce.setValue(z,"logDepthBufFC",2/(Math.log(R.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ce.setValue(z,"isOrthographic",R.isOrthographicCamera===!0),Q!==R&&(Q=R,zi=!0,os=!0)}if(Ot.needsLights&&(hn.state.sunShadowMap.length>0&&ce.setValue(z,"sunShadowMap",hn.state.sunShadowMap,$t),hn.state.directionalShadowMap.length>0&&ce.setValue(z,"directionalShadowMap",hn.state.directionalShadowMap,$t),hn.state.spotShadowMap.length>0&&ce.setValue(z,"spotShadowMap",hn.state.spotShadowMap,$t),hn.state.pointShadowMap.length>0&&ce.setValue(z,"pointShadowMap",hn.state.pointShadowMap,$t)),K.isSkinnedMesh){ce.setOptional(z,K,"bindMatrix"),ce.setOptional(z,K,"bindMatrixInverse");let Ie=K.skeleton;Ie&&(Ie.boneTexture===null&&Ie.computeBoneTexture(),ce.setValue(z,"boneTexture",Ie.boneTexture,$t))}K.isBatchedMesh&&(ce.setOptional(z,K,"batchingTexture"),ce.setValue(z,"batchingTexture",K._matricesTexture,$t),ce.setOptional(z,K,"batchingIdTexture"),ce.setValue(z,"batchingIdTexture",K._indirectTexture,$t),ce.setOptional(z,K,"batchingColorTexture"),K._colorsTexture!==null&&ce.setValue(z,"batchingColorTexture",K._colorsTexture,$t));let Gn=j.morphAttributes;if((Gn.position!==void 0||Gn.normal!==void 0||Gn.color!==void 0)&&rt.update(K,j,dn),(zi||Ot.receiveShadow!==K.receiveShadow)&&(Ot.receiveShadow=K.receiveShadow,ce.setValue(z,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&H.environment!==null&&(Qe.envMapIntensity.value=H.environmentIntensity),Qe.dfgLUT!==void 0&&(Qe.dfgLUT.value=j1()),zi){if(ce.setValue(z,"toneMappingExposure",L.toneMappingExposure),Ot.needsLights&&Lr(Qe,os),Et&&Y.fog===!0&&_t.refreshFogUniforms(Qe,Et),_t.refreshMaterialUniforms(Qe,Y,Mt,St,E.state.transmissionRenderTarget[R.id]),Ot.needsLights&&Ot.numLightProbeGrids>0){let Ie=v,fn=0;for(let On of E.state.lightProbeGridArray)On.texture!==null&&(Ie.textures[fn]=On.texture,Ie.min[fn]=On.boundingBox.min,Ie.max[fn]=On.boundingBox.max,Ie.resolution[fn]=On.resolution,fn++);for(let On in Ie)Ie[On].length=fn;Qe.probesSH.value=Ie.textures,Qe.probesMin.value=Ie.min,Qe.probesMax.value=Ie.max,Qe.probesResolution.value=Ie.resolution}vo.upload(z,Rs(Ot),Qe,$t)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(vo.upload(z,Rs(Ot),Qe,$t),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ce.setValue(z,"center",K.center),ce.setValue(z,"modelViewMatrix",K.modelViewMatrix),ce.setValue(z,"normalMatrix",K.normalMatrix),ce.setValue(z,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Ie=Y.uniformsGroups;for(let fn=0,On=Ie.length;fn<On;fn++){let ul=Ie[fn];Gt.update(ul,dn),Gt.bind(ul,dn)}}return dn}function Lr(R,H){R.ambientLightColor.needsUpdate=H,R.lightProbe.needsUpdate=H,R.sunLights.needsUpdate=H,R.sunLightShadows.needsUpdate=H,R.directionalLights.needsUpdate=H,R.directionalLightShadows.needsUpdate=H,R.pointLights.needsUpdate=H,R.pointLightShadows.needsUpdate=H,R.spotLights.needsUpdate=H,R.spotLightShadows.needsUpdate=H,R.rectAreaLights.needsUpdate=H,R.hemisphereLights.needsUpdate=H}function Ps(R){return R.isMeshLambertMaterial||R.isMeshToonMaterial||R.isMeshPhongMaterial||R.isMeshStandardMaterial||R.isShadowMaterial||R.isShaderMaterial&&R.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return ot},this.setRenderTargetTextures=function(R,H,j){let Y=zt.get(R);Y.__autoAllocateDepthBuffer=R.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(R.texture).__webglTexture=H,zt.get(R.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(R,H){let j=zt.get(R);j.__webglFramebuffer=H,j.__useDefaultFramebuffer=H===void 0},this.setRenderTarget=function(R,H=0,j=0){ot=R,X=H,W=j;let Y=null,K=!1,Et=!1;if(R){let Tt=zt.get(R);if(Tt.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(z.FRAMEBUFFER,Tt.__webglFramebuffer),it.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest,wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),Z=-1;return}else if(Tt.__webglFramebuffer===void 0)$t.setupRenderTarget(R);else if(Tt.__hasExternalTextures)$t.rebindTextures(R,zt.get(R.texture).__webglTexture,zt.get(R.depthTexture).__webglTexture);else if(R.depthBuffer){let ee=R.depthTexture;if(Tt.__boundDepthTexture!==ee){if(ee!==null&&zt.has(ee)&&(R.width!==ee.image.width||R.height!==ee.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$t.setupDepthRenderbuffer(R)}}let It=R.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Et=!0);let Bt=zt.get(R).__webglFramebuffer;R.isWebGLCubeRenderTarget?(Array.isArray(Bt[H])?Y=Bt[H][j]:Y=Bt[H],K=!0):R.samples>0&&$t.useMultisampledRTT(R)===!1?Y=zt.get(R).__webglMultisampledFramebuffer:Array.isArray(Bt)?Y=Bt[j]:Y=Bt,it.copy(R.viewport),ft.copy(R.scissor),dt=R.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),ft.copy(he).multiplyScalar(Mt).floor(),dt=le;if(j!==0&&(Y=k),wt.bindFramebuffer(z.FRAMEBUFFER,Y)&&wt.drawBuffers(R,Y),wt.viewport(it),wt.scissor(ft),wt.setScissorTest(dt),K){let Tt=zt.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_CUBE_MAP_POSITIVE_X+H,Tt.__webglTexture,j)}else if(Et){let Tt=H;for(let It=0;It<R.textures.length;It++){let Bt=zt.get(R.textures[It]);z.framebufferTextureLayer(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0+It,Bt.__webglTexture,j,Tt)}}else if(R!==null&&j!==0){let Tt=zt.get(R.texture);z.framebufferTexture2D(z.FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Tt.__webglTexture,j)}Z=-1};function Nr(R){let H=zt.get(R);return(H.__readFormat!==R.format||H.__readType!==R.type)&&(H.__readFormat=R.format,H.__readType=R.type,H.__formatReadable=re.textureFormatReadable(R.format),H.__typeReadable=re.textureTypeReadable(R.type)),H}this.readRenderTargetPixels=function(R,H,j,Y,K,Et,Pt,Tt=0){if(!(R&&R.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(z.FRAMEBUFFER,It);try{let Bt=R.textures[Tt],ee=Bt.format,de=Bt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Tt);let kt=Nr(Bt);if(kt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(kt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}H>=0&&H<=R.width-Y&&j>=0&&j<=R.height-K&&z.readPixels(H,j,Y,K,xt.convert(ee),xt.convert(de),Et)}finally{let Bt=ot!==null?zt.get(ot).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,Bt)}}},this.readRenderTargetPixelsAsync=async function(R,H,j,Y,K,Et,Pt,Tt=0){if(!(R&&R.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(R).__webglFramebuffer;if(R.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(H>=0&&H<=R.width-Y&&j>=0&&j<=R.height-K){wt.bindFramebuffer(z.FRAMEBUFFER,It);let Bt=R.textures[Tt],ee=Bt.format,de=Bt.type;R.textures.length>1&&z.readBuffer(z.COLOR_ATTACHMENT0+Tt);let kt=Nr(Bt);if(kt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(kt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=z.createBuffer();z.bindBuffer(z.PIXEL_PACK_BUFFER,fe),z.bufferData(z.PIXEL_PACK_BUFFER,Et.byteLength,z.STREAM_READ),z.readPixels(H,j,Y,K,xt.convert(ee),xt.convert(de),0),z.bindBuffer(z.PIXEL_PACK_BUFFER,null);let Ke=ot!==null?zt.get(ot).__webglFramebuffer:null;wt.bindFramebuffer(z.FRAMEBUFFER,Ke);let Re=z.fenceSync(z.SYNC_GPU_COMMANDS_COMPLETE,0);return z.flush(),await Km(z,Re,4),z.bindBuffer(z.PIXEL_PACK_BUFFER,fe),z.getBufferSubData(z.PIXEL_PACK_BUFFER,0,Et),z.bindBuffer(z.PIXEL_PACK_BUFFER,null),z.deleteBuffer(fe),z.deleteSync(Re),Et}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(R,H=null,j=0){let Y=Math.pow(2,-j),K=Math.floor(R.image.width*Y),Et=Math.floor(R.image.height*Y),Pt=H!==null?H.x:0,Tt=H!==null?H.y:0;$t.setTexture2D(R,0),z.copyTexSubImage2D(z.TEXTURE_2D,j,0,0,Pt,Tt,K,Et),wt.unbindTexture()},this.copyTextureToTexture=function(R,H,j=null,Y=null,K=0,Et=0){let Pt,Tt,It,Bt,ee,de,kt,fe,Ke,Re=R.isCompressedTexture?R.mipmaps[Et]:R.image;if(j!==null)Pt=j.max.x-j.min.x,Tt=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,Bt=j.min.x,ee=j.min.y,de=j.isBox3?j.min.z:0;else{let ce=Math.pow(2,-K);Pt=Math.floor(Re.width*ce),Tt=Math.floor(Re.height*ce),R.isDataArrayTexture?It=Re.depth:R.isData3DTexture?It=Math.floor(Re.depth*ce):It=1,Bt=0,ee=0,de=0}Y!==null?(kt=Y.x,fe=Y.y,Ke=Y.z):(kt=0,fe=0,Ke=0);let Pe=xt.convert(H.format),_n=xt.convert(H.type),Ot;H.isData3DTexture?($t.setTexture3D(H,0),Ot=z.TEXTURE_3D):H.isDataArrayTexture||H.isCompressedArrayTexture?($t.setTexture2DArray(H,0),Ot=z.TEXTURE_2D_ARRAY):($t.setTexture2D(H,0),Ot=z.TEXTURE_2D),wt.activeTexture(z.TEXTURE0),wt.pixelStorei(z.UNPACK_FLIP_Y_WEBGL,H.flipY),wt.pixelStorei(z.UNPACK_PREMULTIPLY_ALPHA_WEBGL,H.premultiplyAlpha),wt.pixelStorei(z.UNPACK_ALIGNMENT,H.unpackAlignment);let hn=wt.getParameter(z.UNPACK_ROW_LENGTH),ge=wt.getParameter(z.UNPACK_IMAGE_HEIGHT),rs=wt.getParameter(z.UNPACK_SKIP_PIXELS),dn=wt.getParameter(z.UNPACK_SKIP_ROWS),Dr=wt.getParameter(z.UNPACK_SKIP_IMAGES);wt.pixelStorei(z.UNPACK_ROW_LENGTH,Re.width),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,Re.height),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,Bt),wt.pixelStorei(z.UNPACK_SKIP_ROWS,ee),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,de);let zi=R.isDataArrayTexture||R.isData3DTexture,os=H.isDataArrayTexture||H.isData3DTexture;if(R.isDepthTexture){let ce=zt.get(R),Qe=zt.get(H),Gn=zt.get(ce.__renderTarget),Ie=zt.get(Qe.__renderTarget);wt.bindFramebuffer(z.READ_FRAMEBUFFER,Gn.__webglFramebuffer),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,Ie.__webglFramebuffer);for(let fn=0;fn<It;fn++)zi&&(z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(R).__webglTexture,K,de+fn),z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,zt.get(H).__webglTexture,Et,Ke+fn)),z.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,kt,fe,kt+Pt,fe+Tt,z.DEPTH_BUFFER_BIT,z.NEAREST);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else if(K!==0||R.isRenderTargetTexture||zt.has(R)){let ce=zt.get(R),Qe=zt.get(H);wt.bindFramebuffer(z.READ_FRAMEBUFFER,D),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,V);for(let Gn=0;Gn<It;Gn++)zi?z.framebufferTextureLayer(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,ce.__webglTexture,K,de+Gn):z.framebufferTexture2D(z.READ_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,ce.__webglTexture,K),os?z.framebufferTextureLayer(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,Qe.__webglTexture,Et,Ke+Gn):z.framebufferTexture2D(z.DRAW_FRAMEBUFFER,z.COLOR_ATTACHMENT0,z.TEXTURE_2D,Qe.__webglTexture,Et),K!==0?z.blitFramebuffer(Bt,ee,Bt+Pt,ee+Tt,kt,fe,kt+Pt,fe+Tt,z.COLOR_BUFFER_BIT,z.NEAREST):os?z.copyTexSubImage3D(Ot,Et,kt,fe,Ke+Gn,Bt,ee,Pt,Tt):z.copyTexSubImage2D(Ot,Et,kt,fe,Bt,ee,Pt,Tt);wt.bindFramebuffer(z.READ_FRAMEBUFFER,null),wt.bindFramebuffer(z.DRAW_FRAMEBUFFER,null)}else os?R.isDataTexture||R.isData3DTexture?z.texSubImage3D(Ot,Et,kt,fe,Ke,Pt,Tt,It,Pe,_n,Re.data):H.isCompressedArrayTexture?z.compressedTexSubImage3D(Ot,Et,kt,fe,Ke,Pt,Tt,It,Pe,Re.data):z.texSubImage3D(Ot,Et,kt,fe,Ke,Pt,Tt,It,Pe,_n,Re):R.isDataTexture?z.texSubImage2D(z.TEXTURE_2D,Et,kt,fe,Pt,Tt,Pe,_n,Re.data):R.isCompressedTexture?z.compressedTexSubImage2D(z.TEXTURE_2D,Et,kt,fe,Re.width,Re.height,Pe,Re.data):z.texSubImage2D(z.TEXTURE_2D,Et,kt,fe,Pt,Tt,Pe,_n,Re);wt.pixelStorei(z.UNPACK_ROW_LENGTH,hn),wt.pixelStorei(z.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(z.UNPACK_SKIP_PIXELS,rs),wt.pixelStorei(z.UNPACK_SKIP_ROWS,dn),wt.pixelStorei(z.UNPACK_SKIP_IMAGES,Dr),Et===0&&H.generateMipmaps===!0&&H.mipmapsAutoUpdate===!0&&z.generateMipmap(Ot),wt.unbindTexture()},this.initRenderTarget=function(R){zt.get(R).__webglFramebuffer===void 0&&$t.setupRenderTarget(R)},this.initTexture=function(R){R.isCubeTexture?$t.setTextureCube(R,0):R.isData3DTexture?$t.setTexture3D(R,0):R.isDataArrayTexture||R.isCompressedArrayTexture?$t.setTexture2DArray(R,0):$t.setTexture2D(R,0),wt.unbindTexture()},this.resetState=function(){X=0,W=0,ot=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return vi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=xe._getDrawingBufferColorSpace(t),e.unpackColorSpace=xe._getUnpackColorSpace()}};function br(n){let t=new vs;return t.userData.nearer=n,n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 nearPosition = projectionMatrix * pulled;
      gl_Position.z = nearPosition.z / nearPosition.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function So(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let u=Math.abs(l)<.9,[h,d,f]=u?[a,-o,0]:[0,l,-a],p=Math.hypot(h,d,f);h/=p,d/=p,f/=p,s[r]=i*h,s[r+1]=i*d,s[r+2]=i*f,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(d*l-f*a),s[r+9]=i*(f*o-h*l),s[r+10]=i*(h*a-d*o);for(let _=0;_<3;_++)s[r+12+_]=(n[t+_]+n[e+_])/2;s[r+15]=1}var hu="#d55e00",du="#0072b2",Ug=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Xa(n){return Ug[n%Ug.length]}var Q1=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],tA=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],eA=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function Wd(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var Mo=Wd(Q1),kg=Wd(tA),fu=Wd(eA),Hd=null;function be(n){return getComputedStyle(Hd??document.documentElement).getPropertyValue(n).trim()}function $d(){let n=document.createElement("div");return n.className="paper",document.body.append(n),Hd=n,()=>{Hd=null,n.remove()}}function Bg(n){let t=$d();try{return n()}finally{t()}}function js(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var Fg=[[],[8,4],[8,3,2,3],[2,3]],nA=7;function Si(n){return{colour:be(`--line-${n%nA}`),dash:Fg[n%Fg.length]}}var iA=32767,Qs=24,sA=5/3*Math.PI,rA=.22,Xd=.11,zg=.7,Vg=3,Gg=1e-6;function Hg(n){let t=n.turns.map(l=>({...l,pivot:sn(l.pivot,Float32Array),axis:Float32Array.from(sn(l.axis,Int16Array),c=>c/iA),left:l.left&&sn(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&sn(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:u,end:h})=>l>u&&l<=h);return i.map(({strength:u,rise:h},d)=>c?.drives.includes(d)?u*(h>0?Math.min(1,(l-c.start)/h):1):0)}let o=(l,c)=>l.reduce((u,h,d)=>u+h*c[d],0),a=l=>l.reduce((c,{shares:u})=>{let h=s.map(d=>Math.abs(o(u,i.map(({strength:f},p)=>d.drives.includes(p)?f:0))));return Math.max(c,...h)},0);return{...n,time:sn(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function Wg({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function $g(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(I=>I.radius)),c=.05*n.mesh.span_m,u=br(Math.max(l,c)),h=new di(new Zi(1,1,1,10),u,e.length*Qs+i.length),d=new di(new Ma(1,1,16),u,e.length+i.length),f=new kn;for(let I of[h,d])I.frustumCulled=!1,f.add(I);let p=new Float32Array(3*(Qs+2)),[_,m]=[0,0],g=(I,L,P,N,k)=>So(p,3*L,3*P,N,I.instanceMatrix.array,16*k);function x(I,L){for(let P=0;P<3;P++)p[3*I+P]=L[P]}function b(I,L,P,N){let[k,D]=ts(t,P),X=(I.left?qd(I.left,1,k,D)[0]:1)*r(I.shares,N)/o;if(!(Math.abs(X)>Gg))return;let[W,ot]=I.ends?oA(L,I.ends):[I.pivot,I.axis].map(ht=>qd(ht,3,k,D)),Z=lA(ot,I),Q=aA(ot,Z),it=sA*Math.min(1.2,Math.abs(X))*Math.sign(X),ft=ht=>W.map((gt,St)=>gt+I.radius*(Math.cos(ht)*Z[St]+Math.sin(ht)*Q[St]));for(let ht=0;ht<=Qs;ht++)x(ht,ft(it*(ht/Qs-.5)));let dt=it/2;x(Qs+1,ft(dt+Math.sign(X)*zg));let tt=Xd*I.radius;for(let ht=0;ht<Qs;ht++)g(h,ht,ht+1,tt,_++);g(d,Qs,Qs+1,Vg*tt,m++)}function v(I,L,P,N){let[k,D]=ts(t,P),V=I.force?qd(I.force,1,k,D)[0]:r(I.shares,N)/a;if(!(Math.abs(V)>Gg))return;let X=rA*n.mesh.span_m*V,W=L.subarray(3*I.point,3*I.point+3),ot=Z=>I.direction.map((Q,it)=>W[it]+Z*Q);x(0,W),x(1,ot(X)),x(2,ot(X+Math.sign(V)*zg*c)),g(h,0,1,Xd*c,_++),g(d,1,2,Vg*Xd*c,m++)}function A(I){[_,m]=[0,0];let L=s(I),P=n.pointsAt(I);for(let N of e)b(N,P,I,L);for(let N of i)v(N,P,I,L);[h.count,d.count]=[_,m];for(let N of[h,d])N.instanceMatrix.needsUpdate=!0}let E=()=>u.color.set(new Xt(be("--effort")));function y(){for(let I of[h,d])I.dispose(),I.geometry.dispose();u.dispose()}return{group:f,pose:A,paint:E,count:()=>m,dispose:y}}function qd(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function oA(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function aA(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function lA(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var ws="tendon energy";function sn(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function ti(n){let t=sn(n.time,Float64Array),e=sn(n.points,Float32Array),i=3*n.pointCount,s={[ws]:{width:n.tendonParts.length,values:sn(n.tendonEnergy_J,Float32Array)}};for(let m of n.readings)s[m.name]={width:m.parts.length,values:sn(m.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(m,g=a){return Yd(t,e,i,m,g),g}function c(m,g=new Float32Array(3*o.length)){return u(l(m),g)}function u(m,g){for(let x=0;x<o.length;x++){let b=3*r[2*x],v=3*r[2*x+1];for(let A=0;A<3;A++){let E=m[b+A];g[3*x+A]=E+o[x]*(m[v+A]-E)}}return g}function h(m,g,x=new Float32Array(s[m].width)){return Yd(t,s[m].values,s[m].width,g,x),x}function d(m,g){let{width:x,values:b}=s[m];return Float32Array.from(t,(v,A)=>b[A*x+g])}let f=sn(n.restLength_m,Float32Array);function p(m,g){f.length===g.length?g.set(f):Yd(t,f,g.length,m,g)}let _=n.efforts&&Hg(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,_?.pushes.length?.12*n.span_m:0,...(_?.turns??[]).map(m=>.4*m.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:_,strained:n.built!==null,stressed:!!n.membraneLaw,builtVertices:()=>u(sn(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:p,pointsAt:l,verticesAt:c,verticesOf:u,valuesAt:h,line:d,stageAt:m=>n.stages.findLast(g=>g.start<=m)??n.stages[0],markAt:m=>n.marks.find(g=>Math.abs(g.time-m)<1e-9)}}function Yd(n,t,e,i,s){let[r,o]=ts(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let u=t[a+c];s[c]=o===0?u:u+o*(t[l+c]-u)}}function ts(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}function pu(){return document.getElementById("engine-program")!==null}async function wo(n,t){let e=new Blob([sn(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:u})=>{let h=o.get(u.to);h?(o.delete(u.to),u.said==="refused"?h.refuse(new Error(u.why)):h.take(u)):t(u)},r.onerror=u=>{u.preventDefault();let h=new Error(u.message||"the engine stopped");for(let{refuse:d}of o.values())d(h);o.clear(),t({said:"refused",why:h.message})};function l(u){let h=++a;return new Promise((d,f)=>{o.set(h,{take:d,refuse:f}),r.postMessage({...u,number:h})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let u=document.getElementById("engine-program").textContent,{frame:h,version:d}=await l({act:"load",program:u,text:n}),f={first:h,version:d,ask:l,send:_=>r.postMessage(_),take:p,end:c};return f;async function p(_,m){let{frame:g}=await l({act:"load",text:_});return t=m,{...f,first:g}}}catch(u){throw c(),u}}var Xg={type:"change"},Kd={type:"start"},Yg={type:"end"},mu=new Gs,qg=new ci,cA=Math.cos(70*Cd.DEG2RAD),Sn=new G,ei=2*Math.PI,we={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Zd=1e-6,gu=class extends La{constructor(t,e=null){super(t,e),this.state=we.NONE,this.target=new G,this.cursor=new G,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ys.ROTATE,MIDDLE:Ys.DOLLY,RIGHT:Ys.PAN},this.touches={ONE:Zs.ROTATE,TWO:Zs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new G,this._lastQuaternion=new ui,this._lastTargetPosition=new G,this._quat=new ui().setFromUnitVectors(t.up,new G(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new po,this._sphericalDelta=new po,this._scale=1,this._panOffset=new G,this._rotateStart=new Zt,this._rotateEnd=new Zt,this._rotateDelta=new Zt,this._panStart=new Zt,this._panEnd=new Zt,this._panDelta=new Zt,this._dollyStart=new Zt,this._dollyEnd=new Zt,this._dollyDelta=new Zt,this._dollyDirection=new G,this._mouse=new Zt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=hA.bind(this),this._onPointerDown=uA.bind(this),this._onPointerUp=dA.bind(this),this._onContextMenu=yA.bind(this),this._onMouseWheel=mA.bind(this),this._onKeyDown=gA.bind(this),this._onTouchStart=xA.bind(this),this._onTouchMove=_A.bind(this),this._onMouseDown=fA.bind(this),this._onMouseMove=pA.bind(this),this._interceptControlDown=vA.bind(this),this._interceptControlUp=bA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=we.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Xg),this.update(),this.state=we.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Sn.copy(e).sub(this.target),Sn.applyQuaternion(this._quat),this._spherical.setFromVector3(Sn),this.autoRotate&&this.state===we.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ei:i>Math.PI&&(i-=ei),s<-Math.PI?s+=ei:s>Math.PI&&(s-=ei),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Sn.setFromSpherical(this._spherical),Sn.applyQuaternion(this._quatInverse),e.copy(this.target).add(Sn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Sn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new G(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new G(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Sn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(mu.origin.copy(this.object.position),mu.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(mu.direction))<cA?this.object.lookAt(this.target):(qg.setFromNormalAndCoplanarPoint(this.object.up,this.target),mu.intersectPlane(qg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Zd||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Zd||this._lastTargetPosition.distanceToSquared(this.target)>Zd?(this.dispatchEvent(Xg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?ei/60*this.autoRotateSpeed*t:ei/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Sn.setFromMatrixColumn(e,0),Sn.multiplyScalar(-t),this._panOffset.add(Sn)}_panUp(t,e){this.screenSpacePanning===!0?Sn.setFromMatrixColumn(e,1):(Sn.setFromMatrixColumn(e,0),Sn.crossVectors(this.object.up,Sn)),Sn.multiplyScalar(t),this._panOffset.add(Sn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Sn.copy(s).sub(this.target);let r=Sn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-ei*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(ei*this._rotateDelta.x/e.clientHeight),this._rotateUp(ei*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Zt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function uA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function hA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function dA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Yg),this.state=we.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function fA(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ys.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=we.DOLLY;break;case Ys.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=we.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=we.ROTATE}break;case Ys.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=we.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=we.PAN}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(Kd)}function pA(n){switch(this.state){case we.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case we.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case we.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function mA(n){this.enabled===!1||this.enableZoom===!1||this.state!==we.NONE||(n.preventDefault(),this.dispatchEvent(Kd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Yg))}function gA(n){this.enabled!==!1&&this._handleKeyDown(n)}function xA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Zs.ROTATE:if(this.enableRotate===!1){this.state=we.NONE;break}this._handleTouchStartRotate(n),this.state=we.TOUCH_ROTATE;break;case Zs.PAN:if(this.enablePan===!1){this.state=we.NONE;break}this._handleTouchStartPan(n),this.state=we.TOUCH_PAN;break;default:this.state=we.NONE}break;case 2:switch(this.touches.TWO){case Zs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=we.TOUCH_DOLLY_PAN;break;case Zs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=we.TOUCH_DOLLY_ROTATE;break;default:this.state=we.NONE}break;default:this.state=we.NONE}this.state!==we.NONE&&this.dispatchEvent(Kd)}function _A(n){switch(this._trackPointer(n),this.state){case we.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case we.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case we.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case we.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=we.NONE}}function yA(n){this.enabled!==!1&&n.preventDefault()}function vA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function bA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Jd=120,Zg=2,Kg=6;function jd(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((u,h)=>Math.max(u,h.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:Jd+1},(u,h)=>e.timeAt(h/Jd));i.set(l,c.map(u=>t.map(h=>n[h].pointsAt(e.clipTime(h,u)).slice())))}return i.get(l)}function a(l,c){let u=[...l.flatMap(d=>d.toArray()),...c].join();if(r?.key===u&&r.span===e.span)return r;let h=o().map(d=>SA(d,l,c,s));return r={key:u,span:e.span,rows:MA(h),whole:Jg(h)},r}return function(c,u,h,d){let f=new G().crossVectors(u,c).normalize(),p=[f,new G().crossVectors(c,f),c],{rows:_,whole:m}=a(p,h),g=d?wA(_,e.wayAt(e.time)*Jd):m,[x,b,v,A,E,y]=g,w=[(x-b)/2,(v-A)/2,(E-y)/2],I=Math.max((x+b)/(2*h[0]),(v+A)/(2*h[1])),L=new G;for(let[P,N]of p.entries())L.addScaledVector(N,w[P]);return{target:L,distance:I-w[2]||1}}}function SA(n,t,e,i){let s=new Float64Array(Kg).fill(-1/0),r=e.map(h=>i*Math.hypot(1,h)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(h=>h.toArray()),u=(h,d,f)=>h[0]*d[f]+h[1]*d[f+1]+h[2]*d[f+2];for(let h of n)for(let d=0;d<h.length;d+=3){let[f,p,_]=[u(a,h,d),u(l,h,d),u(c,h,d)],[m,g]=[e[0]*_,e[1]*_],x=[f+m,m-f,p+g,g-p,_,-_];for(let b=0;b<Kg;b++)x[b]>s[b]&&(s[b]=x[b])}return s.map((h,d)=>h+o[d])}function Jg(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function MA(n){let t=(i,s)=>i.slice(Math.max(0,s-Zg),s+Zg+1),e=n.map((i,s)=>Jg(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function wA(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var jg=28,AA=1.05,Qg=Math.PI/24,EA=1.15,Sr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, along the flat plane",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the centre line",towards:[1,0,1e-4]}];function t0(n,t,e,i,s=Mr()){let{size:r,target:o}=TA(t),a=t.map((A,E)=>E),l=jd(t,a,e),c=a.map(A=>jd(t,[A],e)),u=new Yn(jg,1,.02*r,60*r);u.up.set(0,0,1);let h=new gu(u,n);h.minDistance=.1*r,h.maxDistance=20*r;let d=null;function f(A=0){let E=s.oneScale?l:c[A],y=Math.tan(jg*Math.PI/360)/AA;d=E(s.towards,u.up,[y*u.aspect,y],s.following),s.oneScale&&(d.distance*=s.scale),h.target.copy(d.target).addScaledVector(s.aside,d.distance),u.position.copy(h.target).addScaledVector(s.towards,s.closer*d.distance),u.lookAt(h.target),u.updateMatrixWorld()}function p(){f(),i()}h.addEventListener("change",()=>{let A=u.position.clone().sub(h.target);s.closer=A.length()/d.distance,s.towards.copy(A).normalize(),s.aside.copy(h.target).sub(d.target).divideScalar(d.distance),p()});let _=A=>{document.activeElement!==n&&!A.ctrlKey&&A.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",_,{capture:!0});function m({towards:A}){s.towards.set(...A).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function g(A,E){let y=s.towards.clone().applyAxisAngle(u.up,A*Qg),w=new G().crossVectors(u.up,y).normalize(),I=y.clone().applyAxisAngle(w,-E*Qg);s.towards.copy(Math.abs(I.z)<.9999?I:y),p()}function x(A){let E=s.closer*d.distance*EA**-A;s.closer=Math.min(h.maxDistance,Math.max(h.minDistance,E))/d.distance,p()}function b(A){Object.assign(s,A),p()}function v(A,E){u.aspect=A,u.updateProjectionMatrix(),h.rotateSpeed=E,h.panSpeed=E,p()}return{camera:u,controls:h,look:s,size:r,target:o,aim:f,show:m,turn:g,zoom:x,choose:b,resize:v,dispose:()=>h.dispose()}}function Mr(){return{towards:new G(...Sr[0].towards).normalize(),closer:1,aside:new G,following:!0,oneScale:!0,scale:1}}function TA(n){let t=new G(1/0,1/0,1/0),e=new G(-1/0,-1/0,-1/0),i=new G;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}var qa=1/0,Qd=1e-4;function e0(n,t,e){let i=new Set,s=n.readings.map(({unit:p})=>(p==="deg"?1:t.units.length)*Up(p)),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=e,a=e,l=0;function c(){l||=requestAnimationFrame(()=>{l=0;for(let p of i)p()})}let u=(p,_)=>p!==qa?n.pointsAt(p,_):_?(_.set(o.points),_):o.points,h={...n,marks:[],efforts:null,stressed:!1,reach:n.mesh.base.radius,pointsAt:u,verticesAt:(p,_)=>p===qa?n.verticesOf(o.points,_):n.verticesAt(p,_),valuesAt(p,_,m){if(_!==qa)return n.valuesAt(p,_,m);let g=n.readings.findIndex(b=>b.name===p),x=p===ws?o.energies_J:o.readings[g].map(b=>s[g]*b);return m?(m.set(x),m):Float32Array.from(x)},restLengthsAt(p,_){p===qa?_.set(o.restLengths_m):n.restLengthsAt(p,_)},markAt:()=>{}},d={get time(){return o.time_s},span:r,clipTime:(p,_=qa)=>_,timeAt:p=>r.start+p*(r.end-r.start),wayAt:()=>0,onChange(p){return i.add(p),c(),()=>i.delete(p)}};function f(p){o=p,!(p!==a&&!CA(p,a,Qd*h.reach))&&(a=p,c())}return{clip:h,clock:d,show:f,get frame(){return o}}}function CA(n,t,e){let i=(s,r,o)=>s.some((a,l)=>Math.abs(a-r[l])>o);return i(n.points,t.points,e)||n.readings.some((s,r)=>i(s,t.readings[r],Qd*Math.max(1,...s.map(Math.abs))))||i(n.energies_J,t.energies_J,Qd*Math.max(...t.energies_J))||i(n.restLengths_m,t.restLengths_m,0)}var RA=[["space","play or pause"],["← →","short step back or forward"],["page down, page up","long step back or forward"],["home, end","start, end"]],PA="shift with ← → ↑ ↓",IA=[["+ −","nearer, further"],["0","reset the view"]];function xu(n,t){let i=(n.length===1?n[0].marks:[]).map((r,o)=>[String(o+1),r.name]),s=[...RA,...i,[PA,`turn the ${t}`],...IA].map(([r,o])=>S("tr",{},S("th",{scope:"row"},r),S("td",{},o)));return S("details",{className:"keys"},S("summary",{},"Keys"),S("table",{},S("tbody",{},...s)),S("p",{},"Space and arrow keys work unless another control has the focus. All other keys work only in the player."))}var n0={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function i0({key:n,shiftKey:t},e,i,s){if(t&&n in n0)e.turn(...n0[n]);else if(s)if(n==="+"||n==="=")e.zoom(1);else if(n==="-"||n==="−")e.zoom(-1);else if(n==="0")e.show(i);else return!1;else return!1;return!0}function s0(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&i0(i,t,e,!0)&&i.preventDefault()})}function _u(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,u){let{key:h}=c;if(i0(c,i,s,u))return!0;if(h in r)o(()=>e.step(r[h]));else if(h===" ")e.playing?e.pause():e.play();else if(h==="Home")o(()=>e.seek(e.span.start));else if(h==="End")o(()=>e.seek(e.span.end));else if(u)if(t.length===1&&t[0].marks[Number(h)-1])o(()=>e.seekClip(0,t[0].marks[Number(h)-1].time));else return!1;else return!1;return!0}function l(c){let u=document.activeElement,h=n.contains(u);!(h||u===document.body||u===null)||c.ctrlKey||c.metaKey||c.altKey||u instanceof HTMLSelectElement||u?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(u?.tagName??"")||u===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,h)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var r0=2.4;function Ya(n){let t=10**Math.floor(Math.log10(n/r0));return t*[5,2,1].find(e=>e*t<=n/r0)}function o0(n,t){let e=Ya(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new yn().setAttribute("position",new nn(s,3)),l=new mr(a,new Ws({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function tf(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return S("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?NA(o,t):LA(r,o)),...n.some(({sample:r})=>r==="tendon")?[S("li",{},"slack tendons sag, drawn with their rest length")]:[],S("li",{},`squares of the grid: ${Os(Ya(e),"m")}`),...s.map(r=>S("li",{},r)))}function LA(n,t){let[e,i]=n.split(" "),s={mountain:{color:hu},valley:{color:du},region:{background:Xa(i)}};return S("li",{className:e==="region"?"of-region":""},l0(e==="region"?"panel":e,s[e]??{}),t)}function NA(n,t){return ef(n,"0",Mo,`${Ee(t.factor*t.largest_J)} ${t.unit}${t.orMore?" or more":""}`)}function ef(n,t,e,i){let s=l0("bar",{background:e.gradient});return S("li",{className:"energy"},`${n}: `,S("span",{className:"whole"},t,s,i))}function a0(n){let t=S("span"),e=document.createElement("canvas").getContext("2d");e.font="14px system-ui, sans-serif";let i=new Map([...new Set(n)].map(o=>[o,e.measureText(o).width])),s=[...i.keys()].reduce((o,a)=>i.get(a)>i.get(o)?a:o),r=S("span",{className:"room","aria-hidden":"true"},s);return{element:S("span",{className:"roomy"},r,t),say:o=>{t.textContent=o}}}function l0(n,t){let e=S("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function c0(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;DA(n,r)<t?e=r:i=r}return(e+i)/2}function DA(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function h0(n){let{triangles:t,faces:e,membraneLaw:i}=n.mesh,s=n.builtVertices(),r=Array.from({length:e.length},(h,d)=>u0(s,t,d)),o=new Float32Array(e.reduce((h,d)=>Math.max(h,d),0)+1),a=new Float32Array(e.length);function l(h,d){let{youngs_modulus_Pa:f,poisson_ratio:p}=i;return f/(1-p*p)*((1-p)*h+p*(h+d))}function c(h,d="strain"){o.fill(-1/0);for(let f=0;f<e.length;f++){let[p,_,m]=r[f],g=p*m-_*_;if(g<=1e-9*(p+m)**2)continue;let[x,b,v]=u0(h,t,f),A=(m*x-2*_*b+p*v)/(2*g),E=(x*v-b*b)/g,y=Math.sqrt(Math.max(A*A-E,0)),[w,I]=[(A+y-1)/2,(A-y-1)/2],L=d==="stress"?l(w,I):w;o[e[f]]=Math.max(o[e[f]],L)}for(let f=0;f<e.length;f++)a[f]=Math.max(0,o[e[f]]);return a}function u(h){let d=new Float32Array(s.length),f=0;for(let p of n.time)f=c(n.verticesAt(p,d),h).reduce((_,m)=>Math.max(_,m),f);return f}return{at:c,largest:u}}function u0(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let u=n[s+c]-n[i+c],h=n[r+c]-n[i+c];o+=u*u,a+=u*h,l+=h*h}return[o,a,l]}var OA=.9,d0=.4,UA=.02,FA=["crease","rim","edge"],tr=12;function nf(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(I=>I.radius)),[o,a]=[!1,!0].map(I=>BA(e,I)),l=f0(e.tubes.filter(I=>I.kind==="bar"),20,0),c=f0(e.tubes.filter(I=>FA.includes(I.kind)),8,.4*r),u=zA(n,2.4*r),h=GA(e.base),d=n.efforts?$g(n):null,f=n.strained?h0(n):null,p=null,_=HA(e),m=new kn;m.add(h.object,a.object,l.object,_.object,c.object,u.object,o.object),d&&m.add(d.group);let g=kA(o.object,a.object,l.object),x=[0,0,0],b=new Xt;function v(I){n.verticesAt(I,i),o.pose(i),a.pose(i);for(let P of[l,c,_])P.pose(i);n.valuesAt(ws,I,s);let L=s.map(P=>t>0?P/t:0);u.pose(i,I,P=>d0+(1-d0)*Math.min(1,Math.max(0,L[P])/UA));for(let P=0;P<n.tendons;P++)Mo.at(L[P],x),u.colour(P,b.setRGB(...x,"srgb"));n.tendons&&(u.object.instanceColor.needsUpdate=!0),d?.pose(I),p&&A()}function A(){let I=f.at(i,p.quantity),L=[0,0,0];for(let P of[o,a])P.colour(N=>b.setRGB(...fu.at(I[N]/p.largest,L),"srgb"))}function E(I,L){p=f&&I?{quantity:I,largest:L}:null;for(let P of[o,a])P.flat(p!==null),p||P.colour(N=>b.set(Xa(e.regions[N])));p&&A()}function y(){for(let I of[l,c,_,h])I.paint();d?.paint(),g.children[0].material.color.set(be("--shadow"))}function w(){for(let I of[l,c,u,_])I.object.dispose();for(let I of[o,a])I.dispose();d?.dispose(),h.dispose();for(let I of[l,c,u,_])I.object.geometry.dispose(),I.object.material.dispose();g.children[0].material.dispose()}return{group:m,shadow:g,pose:v,paint:y,sort:o.sort,vertices:i,tendons:u.object,efforts:d,strains:f,colourSheets:E,dispose:w}}function kA(...n){let t=new pr({side:Bn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:yd,stencilZPass:_d}),e=new kn;for(let i of n){let s=i.isInstancedMesh?new di(i.geometry,t,i.count):new Dn(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function BA(n,t){let e=n.regions.flatMap((v,A)=>n.solid[v]===t?[A]:[]),i=e.flatMap(v=>n.triangles.slice(3*v,3*v+3)),s=e.length,r=new an(new Float32Array(3*i.length),3).setUsage(Va),o=new an(new Float32Array(3*i.length),3).setUsage(Va),a=new an(new Uint32Array(i.length),1).setUsage(Va);for(let v=0;v<i.length;v++)a.array[v]=v;let l=new yn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new vs({vertexColors:!0,side:Bn,flatShading:!0,transparent:!t,opacity:t?1:OA,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=v=>{v.fragmentShader=v.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let u=new pr({vertexColors:!0,side:Bn}),h=new Dn(l,c);h.frustumCulled=!1,h.renderOrder=t?0:1;let d=new Xt;f(v=>d.set(Xa(n.regions[v])));function f(v){for(let[A,E]of e.entries()){let y=v(E);for(let w=0;w<3;w++)y.toArray(o.array,9*A+3*w)}o.needsUpdate=!0}let p=v=>{h.material=v?u:c};function _(){l.dispose(),c.dispose(),u.dispose()}function m(v){for(let A=0;A<i.length;A++)for(let E=0;E<3;E++)r.array[3*A+E]=v[3*i[A]+E];r.needsUpdate=!0}let g=new Float32Array(s),x=Array.from({length:s},(v,A)=>A);function b(v){let A=r.array;for(let E=0;E<s;E++){let y=0;for(let w=0;w<3;w++){let I=9*E+w;y+=((A[I]+A[I+3]+A[I+6])/3-v.getComponent(w))**2}g[E]=y}x.sort((E,y)=>g[y]-g[E]);for(let E=0;E<s;E++)for(let y=0;y<3;y++)a.array[3*E+y]=3*x[E]+y;a.needsUpdate=!0}return{object:h,pose:m,sort:b,colour:f,flat:p,dispose:_}}function f0(n,t,e){let i=new di(new Zi(1,1,1,t),br(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[u,[h,d,f]]of s.entries())So(a,h,d,l(u)*f,c,16*u);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Xt(hu),V:new Xt(du),B:new Xt(be("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function zA(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new di(new Zi(1,1,1,12),br(t),e.length*tr);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*(tr+1));function o(l,c,u){n.restLengthsAt(c,s);let h=i.instanceMatrix.array;for(let[d,{ends:f,radius:p}]of e.entries()){VA(l,3*f[0],3*f[1],s[d],r);for(let _=0;_<tr;_++)So(r,3*_,3*_+3,u(d)*p,h,16*(d*tr+_))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let u=0;u<tr;u++)i.setColorAt(l*tr+u,c)}return{object:i,pose:o,colour:a}}function VA(n,t,e,i,s){let r=[0,1,2].map(d=>n[e+d]-n[t+d]),o=Math.hypot(...r),a=c0(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((d,f,p)=>d+f*r[p],0)/(o*o||1),u=l.map((d,f)=>d-c*r[f]),h=Math.hypot(...u)||1;for(let d=0;d<=tr;d++){let f=d/tr,p=4*a*f*(1-f)/h;for(let _=0;_<3;_++)s[3*d+_]=n[t+_]+f*r[_]+p*u[_]}}function GA({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=br(0),s=new di(new Zi(1,1,1,16),i,n.length),r=new di(new ho(1,16,12),i,2*n.length),o=new kn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)So(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let u=0;u<3;u++)[c[16*l+5*u],c[16*l+12+u]]=[t,e[3*l+u]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(be("--base")),dispose:a}}function HA(n){let t=new di(new ho(1,16,12),br(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(be("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var p0="system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif";function Za(n,t,e=1,[i,s]=[0,0]){n.save(),n.scale(e,e),n.translate(i,s);for(let r of t)m0(n,r);n.restore()}function m0(n,t){if(t.shapes){n.save(),t.kind==="moved"?n.translate(t.x,t.y):(n.beginPath(),n.rect(t.x,t.y,t.width,t.height),n.clip());for(let e of t.shapes)m0(n,e);n.restore();return}if(n.globalAlpha=t.opacity??1,n.setLineDash(t.dash??[]),n.lineWidth=t.lineWidth??1,t.kind==="text"){n.font=`${t.bold?"bold ":""}${t.size??12}px ${p0}`,n.textAlign={start:"left",middle:"center",end:"right"}[t.anchor??"start"],n.fillStyle=t.fill,n.fillText(t.text,t.x,t.y);return}if(n.beginPath(),t.kind==="rect"&&n.rect(t.x,t.y,t.width,t.height),t.kind==="circle"&&n.arc(t.x,t.y,t.r,0,2*Math.PI),t.kind==="path")for(let e of g0(t.points))for(let[i,s]of e.entries())n[i?"lineTo":"moveTo"](...s);(t.fill||t.scale)&&(n.fillStyle=t.scale?WA(n,t):t.fill,n.fill()),t.stroke&&(n.strokeStyle=t.stroke,n.stroke())}function WA(n,{x:t,width:e,scale:i}){let s=n.createLinearGradient(t,0,t+e,0);for(let[r,o]of i.entries())s.addColorStop(r/(i.length-1),o);return s}function g0(n){let t=[[]];for(let e of n)e?t.at(-1).push(e):t.at(-1).length&&t.push([]);return t.filter(e=>e.length)}function vu(n,t,e,i){let s={count:0},r=[{kind:"rect",x:0,y:0,width:t,height:e,fill:"#ffffff"},...n].map(o=>yu(o,s));return[`<svg xmlns="http://www.w3.org/2000/svg" width="${Ue(t)}" height="${Ue(e)}" viewBox="0 0 ${Ue(t)} ${Ue(e)}" font-family="${p0}">`,`<title>${x0(i)}</title>`,...r,`</svg>
`].join(`
`)}function yu(n,t){if(n.kind==="svg")return`<svg ${`x="${Ue(n.x)}" y="${Ue(n.y)}" width="${Ue(n.width)}" height="${Ue(n.height)}"`} viewBox="${n.viewBox}"${n.stretched?' preserveAspectRatio="none"':""}>${n.content}</svg>`;if(n.scale){let h=`scale${++t.count}`,d=n.scale.map((f,p)=>`<stop offset="${Ue(p/(n.scale.length-1))}" stop-color="${f}"/>`);return`<linearGradient id="${h}">${d.join("")}</linearGradient>${yu({...n,scale:null,fill:`url(#${h})`},t)}`}if(n.kind==="moved")return`<g transform="translate(${Ue(n.x)} ${Ue(n.y)})">${n.shapes.map(h=>yu(h,t)).join(`
`)}</g>`;if(n.kind==="clip"){let h=`clip${++t.count}`;return`${`<clipPath id="${h}"><rect x="${Ue(n.x)}" y="${Ue(n.y)}" width="${Ue(n.width)}" height="${Ue(n.height)}"/></clipPath>`}<g clip-path="url(#${h})">${n.shapes.map(f=>yu(f,t)).join(`
`)}</g>`}let{fill:e="none",stroke:i,lineWidth:s=1,dash:r,opacity:o}=n,a=[`fill="${e}"`];i&&a.push(`stroke="${i}" stroke-width="${Ue(s)}" stroke-linejoin="round"`),r?.length&&a.push(`stroke-dasharray="${r.join(" ")}"`),o!==void 0&&o!==1&&a.push(`opacity="${o}"`);let{x:l,y:c}=n;return n.kind==="rect"?`<rect x="${Ue(l)}" y="${Ue(c)}" width="${Ue(n.width)}" height="${Ue(n.height)}" ${a.join(" ")}/>`:n.kind==="circle"?`<circle cx="${Ue(l)}" cy="${Ue(c)}" r="${Ue(n.r)}" ${a.join(" ")}/>`:n.kind==="path"?`<path d="${g0(n.points).map(d=>`M${d.map(f=>f.map(Ue).join(" ")).join("L")}`).join("")}" ${a.join(" ")}/>`:`<text ${n.turned?`transform="translate(${Ue(l)} ${Ue(c)}) rotate(-90)"`:`x="${Ue(l)}" y="${Ue(c)}"`} font-size="${n.size??12}"${n.bold?' font-weight="bold"':""} text-anchor="${n.anchor??"start"}" ${a.join(" ")}>${x0(n.text)}</text>`}var Ue=n=>String(Number(n.toFixed(2))),x0=n=>n.replace(/[&<>"]/g,t=>`&#${t.charCodeAt(0)};`);var bu=8,$A=["fill","stroke","stroke-width","stroke-dasharray","stroke-linejoin","stroke-linecap","opacity","font-size","font-weight","paint-order","text-anchor"],XA=new Set(["fill","stroke"]);function er(n,t,e=null){for(let i of n)i.classList.add("paper");try{let i=n.map(c=>c.getBoundingClientRect()),[s,r]=[Math.min(...i.map(c=>c.left))-bu,Math.min(...i.map(c=>c.top))-bu],[o,a]=[Math.max(...i.map(c=>c.right))-s+bu,Math.max(...i.map(c=>c.bottom))-r+bu],l=n.flatMap(c=>rf(c,s,r,e));return{svg:vu(l,o,a,t),width:o,height:a}}finally{for(let i of n)i.classList.remove("paper")}}function sf(n){n.classList.add("paper");try{let{left:t,top:e,width:i,height:s}=n.getBoundingClientRect();return{shapes:rf(n,t,e,null),width:i,height:s}}finally{n.classList.remove("paper")}}function rf(n,t,e,i){let s=getComputedStyle(n);if(s.display==="none"||s.visibility==="hidden"||i&&n.matches(i))return[];let r=n.getBoundingClientRect(),o={x:r.left-t,y:r.top-e,width:r.width,height:r.height};if(n.localName==="svg")return[{kind:"svg",...o,viewBox:n.getAttribute("viewBox"),stretched:n.getAttribute("preserveAspectRatio")==="none",content:KA(n)}];let a=[];r.width&&r.height&&a.push(...qA(s,o)),a.push(...YA(s,o));for(let l of n.childNodes)l.nodeType===Node.TEXT_NODE?a.push(...ZA(l,s,t,e)):l.nodeType===Node.ELEMENT_NODE&&a.push(...rf(l,t,e,i));return a}function qA(n,t){let e=Ka(n.backgroundColor),i=n.borderTopLeftRadius==="50%"&&t.width===t.height,s=[];e.opacity>0&&!i&&s.push({kind:"rect",...t,fill:e.text,opacity:e.opacity});let r=/^linear-gradient\(to right, (.*)\)$/.exec(n.backgroundImage);return r&&s.push({kind:"rect",...t,scale:r[1].match(/rgb\([^)]*\)/g)}),i&&s.push({kind:"circle",x:t.x+t.width/2,y:t.y+t.height/2,r:t.width/2-1,stroke:Ka(n.borderTopColor).text,lineWidth:parseFloat(n.borderTopWidth),...e.opacity?{fill:e.text}:{}}),s}function YA(n,{x:t,y:e,width:i,height:s}){if(n.borderTopLeftRadius==="50%")return[];let r={Top:[[t,e],[t+i,e]],Right:[[t+i,e],[t+i,e+s]],Bottom:[[t,e+s],[t+i,e+s]],Left:[[t,e],[t,e+s]]};return Object.entries(r).flatMap(([o,a])=>{let[l,c]=[n[`border${o}Style`],parseFloat(n[`border${o}Width`])];if(l==="none"||!c)return[];let u=Ka(n[`border${o}Color`]);return u.opacity?[{kind:"path",points:a,stroke:u.text,lineWidth:c,opacity:u.opacity,...l==="dashed"?{dash:[2*c,c]}:{}}]:[]})}function ZA(n,t,e,i){let s=parseFloat(t.fontSize),r={size:s,bold:Number(t.fontWeight)>=600,fill:Ka(t.color).text},o=document.createRange(),a=[];for(let{index:l,0:c}of n.data.matchAll(/\S+/g)){o.setStart(n,l),o.setEnd(n,l+c.length);let[u]=o.getClientRects();if(!u)continue;let h=a.at(-1),d=t.writingMode==="horizontal-tb";h&&Math.abs(d?h.box.top-u.top:h.box.left-u.left)<2?(h.words.push(c),h.last=u):a.push({words:[c],box:u,last:u})}return t.writingMode==="horizontal-tb"?a.map(({words:l,box:c})=>({kind:"text",x:c.left-e,y:c.top-i+c.height/2+.35*s,text:l.join(" "),...r})):a.map(({words:l,box:c,last:u})=>({kind:"text",x:(c.left+c.right)/2-e+.35*s,y:(Math.min(c.top,u.top)+Math.max(c.bottom,u.bottom))/2-i,text:l.join(" "),anchor:"middle",turned:!0,...r}))}function KA(n){let t=n.cloneNode(!0),[e,i]=[n,t].map(s=>[...s.querySelectorAll("*")]);for(let[s,r]of e.entries()){let o=getComputedStyle(r),a=i[s];for(let{name:l}of[...a.attributes])/^(aria-|data-|class$|role$|tabindex$|style$)/.test(l)&&a.removeAttribute(l);if(!(r.localName==="g"||r.localName==="title"))for(let l of $A){let c=o.getPropertyValue(l);if(!XA.has(l))a.setAttribute(l,c);else{let{text:u,opacity:h}=c==="none"?{text:"none",opacity:1}:Ka(c);a.setAttribute(l,h?u:"none"),h&&h<1&&a.setAttribute(`${l}-opacity`,h)}}}return new XMLSerializer().serializeToString(t).replace(/^<svg[^>]*>|<\/svg>$/g,"")}function Ka(n){let t=(n.match(/[\d.]+(?:e-?\d+)?%?/g)??[]).map(Number);return{text:`rgb(${(n.startsWith("color(")?t.slice(0,3).map(i=>255*i):t.slice(0,3)).map(Math.round).join(",")})`,opacity:t[3]??1}}function _0(n,t,e){let i=[];return{add:s=>i.push(JA(s)),bytes:()=>jA(i,n,t,Math.round(100*e))}}function JA(n){let t=new Uint16Array(n.length/4);for(let e=0;e<t.length;e++)t[e]=n[4*e]>>3<<10|n[4*e+1]>>3<<5|n[4*e+2]>>3;return t}function jA(n,t,e,i){let{palette:s,indexOf:r}=tE(n),o=[],a=c=>o.push(c&255,c>>8);o.push(...new TextEncoder().encode("GIF89a")),a(t),a(e),o.push(247,0,0,...s),o.push(33,255,11,...new TextEncoder().encode("NETSCAPE2.0"),3,1,0,0,0);let l=null;for(let c of n){let u=Uint8Array.from(c,(d,f)=>l&&l[f]===d?255:r[d]);o.push(33,249,4,5),a(i),o.push(255,0,44);for(let d of[0,0,t,e])a(d);o.push(0,8);let h=QA(u);for(let d=0;d<h.length;d+=255){let f=Math.min(d+255,h.length);o.push(f-d);for(let p=d;p<f;p++)o.push(h[p])}o.push(0),l=c}return o.push(59),Uint8Array.from(o)}function QA(n){let t=[],[e,i]=[0,0],s=9,r=258,o=new Int32Array(1048576).fill(-1),a=c=>{for(e|=c<<i,i+=s;i>=8;)t.push(e&255),e>>>=8,i-=8};a(256);let l=n[0];for(let c=1;c<n.length;c++){let u=l<<8|n[c];if(o[u]>=0){l=o[u];continue}a(l),r<4096?(o[u]=r,r===1<<s&&s<12&&s++,r++):(a(256),o.fill(-1),[s,r]=[9,258]),l=n[c]}return a(l),a(257),i&&t.push(e&255),t}function tE(n){let t=new Uint32Array(32768);for(let o of n)for(let a=0;a<o.length;a++)t[o[a]]++;let e=[...t.keys()].filter(o=>t[o]),i=[of(e,t)];for(;i.length<255;){let o=i.reduce((c,u)=>u.spread>c.spread?u:c);if(!o.spread)break;let a=o.colours.sort((c,u)=>Su(c)[o.channel]-Su(u)[o.channel]),l=a.length>>1;i.splice(i.indexOf(o),1,of(a.slice(0,l),t),of(a.slice(l),t))}let s=new Uint8Array(3*256),r=new Uint8Array(32**3);for(let[o,{colours:a,weight:l}]of i.entries()){for(let c=0;c<3;c++){let u=a.reduce((h,d)=>h+t[d]*Su(d)[c],0)/l;s[3*o+c]=Math.round(u*255/31)}for(let c of a)r[c]=o}return{palette:s,indexOf:r}}var Su=n=>[n>>10,n>>5&31,n&31];function of(n,t){let e=n.reduce((r,o)=>r+t[o],0),i=[0,1,2].map(r=>{let o=n.map(a=>Su(a)[r]);return o.reduce((a,l)=>Math.max(a,l))-o.reduce((a,l)=>Math.min(a,l))}),s=Math.max(...i);return{colours:n,weight:e,channel:i.indexOf(s),spread:s*s*Math.sqrt(e)}}var lf=8,y0=12.5,eE=25,nE=.6,[iE,v0,sE]=[640,1280,2400],af=30,[Ao,rE,b0]=[10,210,24],oE=8,aE=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm","video/mp4"];function wu(n,t,e,i){let r=[M0("PNG","download PNG of the picture",async()=>{let o=S("canvas");await w0(n,()=>n.drawSharp(sE,()=>Mu(o,n,e(),i(),n.canvas.width)));let a=await new Promise(l=>o.toBlob(l,"image/png"));cr(a,`${Xn("picture")}.png`)})];if(t.seek&&t.timeAt){r.push(S0("GIF","gif",l=>cE(n,t,e,i,l)));let o=aE.find(l=>globalThis.MediaRecorder?.isTypeSupported(l)),a=o?.startsWith("video/mp4")?"MP4":"WebM";o&&HTMLCanvasElement.prototype.captureStream&&r.push(S0(a,a.toLowerCase(),l=>uE(n,t,e,i,l,o)))}return S("span",{className:"films",role:"group","aria-label":"save"},...r)}function M0(n,t,e){let i=S("button",{type:"button","aria-label":t,title:t},n);return i.addEventListener("click",e),i}function S0(n,t,e){let i=null,s=M0(n,`download a film as ${n}`,async()=>{if(i){i.stopped=!0;return}i={stopped:!1,progress:r=>{s.textContent=`${Math.round(100*r)} %`}};try{let r=await e(i);i.stopped||cr(r,`${Xn("motion")}.${t}`)}finally{i=null,s.textContent=n}});return s}async function w0(n,t){let e=$d();n.paint();try{return await t()}finally{e(),n.paint()}}async function A0(n,t,e,i){let s=t.time;t.pause?.(),await w0(n,async()=>{for(let r=e();r!==null;r=e())t.seek(t.timeAt(Math.min(1,r))),await lE(),i(r)}),t.seek(s)}var lE=()=>new Promise(n=>requestAnimationFrame(n));async function cE(n,t,e,i,s){let r=S("canvas"),o=Math.round(lf*y0),[a,l]=[0,null];return await A0(n,t,()=>s.stopped||a>o?null:a/o,c=>{Mu(r,n,e(),i(),iE),l??=_0(r.width,r.height,1/y0),l.add(r.getContext("2d",{willReadFrequently:!0}).getImageData(0,0,r.width,r.height).data),s.progress(c),a++}),s.stopped?null:new Blob([l.bytes()],{type:"image/gif"})}async function uE(n,t,e,i,s,r){let o=S("canvas");Mu(o,n,e(),i(),v0);let a=new MediaRecorder(o.captureStream(eE),{mimeType:r,videoBitsPerSecond:8e6}),l=[];a.ondataavailable=({data:d})=>l.push(d);let c=new Promise(d=>{a.onstop=d});a.start();let u=performance.now(),h=()=>(performance.now()-u)/1e3;return await A0(n,t,()=>s.stopped||h()>lf+nE?null:h()/lf,d=>{Mu(o,n,e(),i(),v0),s.progress(Math.min(1,d))}),a.stop(),await c,new Blob(l,{type:r.split(";")[0]})}function Mu(n,t,e,i,s){let{canvas:r,cells:o}=t,a=s/r.clientWidth,l=Math.round(a*r.clientHeight),c=Math.max(1,a),u=hE(e,i,s/c),h=Math.round(c*u.height),d=[2*Math.round(s/2),2*Math.round((l+h)/2)];(n.width!==d[0]||n.height!==d[1])&&([n.width,n.height]=d);let f=n.getContext("2d",{willReadFrequently:!0});if(f.fillStyle="#ffffff",f.fillRect(0,0,...d),f.drawImage(r,0,0,s,l),o.length>1)for(let p of o)Za(f,sf(p).shapes,a,[p.offsetLeft,p.offsetTop]);Za(f,u.shapes,c,[0,l/c])}function hE(n,t,e){let i=[{kind:"text",x:Ao,y:20,text:n,bold:!0,size:14,fill:"#16191d"}],[s,r]=[n?Math.max(rE,Ao+oE*n.length+b0):Ao,0];for(let{shapes:o,width:a,height:l}of t.map(sf))s>Ao&&s+a>e-Ao&&([s,r]=[Ao,r+af]),i.push({kind:"moved",x:s,y:r+(af-l)/2,shapes:o}),s+=a+b0;return{shapes:i,height:r+af}}var dE=[{quantity:null,name:"panels"},{quantity:"strain",name:"strain",text:"largest Green strain of the membrane",value:n=>`${Ee(100*n)} %`},{quantity:"stress",name:"stress",text:"largest stress of the membrane (second Piola-Kirchhoff)",value:(n,t)=>Os(n,t)}];function cf(n,t,e){let i=S("li",{className:"energy",hidden:!0});t.append(i);let s=e.find(a=>a.stressed)?.mesh.membraneLaw.unit,o=dE.filter(({quantity:a})=>a!=="stress"||e.every(l=>l.stressed||!l.strained)).map(({quantity:a,name:l,text:c,value:u},h)=>{let d=S("button",{type:"button","aria-pressed":String(h===0)},l);return d.addEventListener("click",()=>{let f=n.colourSheets(a);a&&i.replaceChildren(...ef(c,"0",fu,u(f,s)).childNodes),i.hidden=!a;for(let p of t.querySelectorAll(".of-region"))p.hidden=!!a;for(let p of o)p.setAttribute("aria-pressed",String(p===d))}),d});return S("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",S("span",{},...o))}var E0=2,fE=.84,Au=1024,pE=Uint8Array.from({length:Au+1},(n,t)=>{let e=t/Au;return Math.round(255*(e<=.0031308?12.92*e:1.055*e**(1/2.4)-.055))}),uf=n=>pE[Math.min(Au,Math.max(0,Math.round(Au*n)))];function T0(n){let t=n.getContext("2d"),e=document.createElement("canvas"),i={frame:0,calls:0,triangles:0},s=1,r=[0,0,1,1];return{info:{render:i},setPixelRatio(o){s=o},setSize(o,a){[n.width,n.height]=[Math.floor(o*s),Math.floor(a*s)]},setScissorTest(){},setScissor(){},setViewport(...o){r=o.map(a=>a*s)},clear(){i.frame+=1,t.clearRect(0,0,n.width,n.height)},render(o,a){let[l,c]=[Math.round(r[2]*E0),Math.round(r[3]*E0)];if(l<1||c<1)return;let u=mE(o,a,l,c);[e.width,e.height]=[l,c],e.getContext("2d").putImageData(u,0,0),t.drawImage(e,r[0],n.height-r[1]-r[3],r[2],r[3])},dispose(){},forceContextLoss(){}}}function mE(n,t,e,i){let s=new ImageData(e,i),r={width:e,height:i,colours:new Uint32Array(s.data.buffer),depths:new Float32Array(e*i).fill(1/0)};n.updateMatrixWorld(),t.updateMatrixWorld();let o=gE(n),a=new ae().multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),l=[];n.traverseVisible(u=>{u.geometry&&!hf(u)[0].stencilWrite&&l.push(u)});for(let u of l.filter(h=>h.isLineSegments))bE(u,a,r);let c={projection:a,view:t.matrixWorldInverse,perspective:t.projectionMatrix,position:t.position};for(let u of l.filter(h=>h.isMesh))_E(u,c,o,r);return s}var hf=({material:n})=>Array.isArray(n)?n:[n];function gE(n){let t={towards:new G(0,0,1),sun:new Xt(0),sky:new Xt(0),ground:new Xt(0)};return n.traverse(e=>{e.isDirectionalLight&&(t.towards.copy(e.position).normalize(),t.sun.copy(e.color).multiplyScalar(e.intensity/Math.PI)),e.isHemisphereLight&&(t.sky.copy(e.color).multiplyScalar(e.intensity/Math.PI),t.ground.copy(e.groundColor).multiplyScalar(e.intensity/Math.PI))}),t}function xE(n,t,e,i,s){if(e.isMeshBasicMaterial){for(let h=0;h<3;h++)s[h]=uf(t[h]);return}let r=Math.max(0,n.dot(i.towards)),o=.5*n.y+.5,a=e.emissive&&e.emissiveIntensity?e.emissive.toArray().map(h=>h*e.emissiveIntensity):null,[l,c,u]=[i.sun,i.sky,i.ground].map(h=>[h.r,h.g,h.b]);for(let h=0;h<3;h++)s[h]=uf(t[h]*(r*l[h]+o*c[h]+(1-o)*u[h])+(a?.[h]??0))}function _E(n,t,e,i){let{geometry:s}=n,r=hf(n),o={start:0,count:s.index?.count??s.attributes.position.count,materialIndex:0},a=Array.isArray(n.material)?s.groups:[o],l=n.isInstancedMesh?n.count:1,[c,u,h]=[new ae,new ae,new Xt];for(let d=0;d<l;d++){c.copy(n.matrixWorld),h.set(1,1,1),n.isInstancedMesh&&(n.getMatrixAt(d,u),c.multiply(u),n.instanceColor&&n.getColorAt(d,h));for(let f of a)yE(s,f,c,r[f.materialIndex],h,t,e,i)}}function yE(n,{start:t,count:e},i,s,r,o,a,l){let{position:c,normal:u,color:h}=n.attributes,d=u&&!s.flatShading,f=[s.color.r*r.r,s.color.g*r.g,s.color.b*r.b],p=new te().getNormalMatrix(i),_=s.userData.nearer??0,m=new Map,g=new ke,x=new G;function b(L){if(m.has(L))return m.get(L);x.fromBufferAttribute(c,L).applyMatrix4(i);let P=x.clone();g.set(x.x,x.y,x.z,1).applyMatrix4(o.projection);let N={place:P,x:(g.x/g.w+1)/2*l.width,y:(1-g.y/g.w)/2*l.height,depth:g.z/g.w,behind:g.w<=0,normal:d?new G().fromBufferAttribute(u,L).applyMatrix3(p).normalize():null};return _&&(x.applyMatrix4(o.view),x.addScaledVector(x.clone().normalize(),-_),g.set(x.x,x.y,x.z,1).applyMatrix4(o.perspective),N.depth=g.z/g.w),m.set(L,N),N}let[v,A,E,y]=[new G,new G,new G,new G],w=[0,0,0],I=[[0,0,0],[0,0,0],[0,0,0]];for(let L=t;L+2<t+e;L+=3){let P=[0,1,2].map(D=>n.index?n.index.getX(L+D):L+D),N=P.map(b);if(N.some(D=>D.behind))continue;v.subVectors(N[1].place,N[0].place),A.subVectors(N[2].place,N[0].place),E.crossVectors(v,A).normalize(),y.subVectors(o.position,N[0].place);let k=E.dot(y)<0;k&&E.negate();for(let D=0;D<3;D++){let V=P[D];for(let X=0;X<3;X++)w[X]=f[X]*(h?h.getComponent(V,X):1)*(k&&h&&!s.isMeshBasicMaterial?fE:1);xE(d?N[D].normal:E,w,s,a,I[D])}vE(N,I,l)}}function vE([n,t,e],i,{width:s,height:r,colours:o,depths:a}){let l=(t.x-n.x)*(e.y-n.y)-(t.y-n.y)*(e.x-n.x);if(Math.abs(l)<1e-9)return;let[c,u]=[Math.max(0,Math.floor(Math.min(n.x,t.x,e.x))),Math.min(s-1,Math.ceil(Math.max(n.x,t.x,e.x)))],[h,d]=[Math.max(0,Math.floor(Math.min(n.y,t.y,e.y))),Math.min(r-1,Math.ceil(Math.max(n.y,t.y,e.y)))],[f,p,_]=i,m=f.every((v,A)=>v===p[A]&&v===_[A]),g=4278190080|f[2]<<16|f[1]<<8|f[0],[x,b]=[(e.y-n.y)/l,(n.y-t.y)/l];for(let v=h;v<=d;v++){let[A,E]=[c+.5-n.x,v+.5-n.y],y=(A*(e.y-n.y)-E*(e.x-n.x))/l,w=(E*(t.x-n.x)-A*(t.y-n.y))/l,I=v*s+c;for(let L=c;L<=u;L++,I++,y+=x,w+=b){let P=1-y-w;if(P<0||y<0||w<0)continue;let N=P*n.depth+y*t.depth+w*e.depth;N>=a[I]||(a[I]=N,o[I]=m?g:4278190080|P*f[2]+y*p[2]+w*_[2]<<16|P*f[1]+y*p[1]+w*_[1]<<8|P*f[0]+y*p[0]+w*_[0])}}}function bE(n,t,{width:e,height:i,colours:s}){let{position:r}=n.geometry.attributes,[o]=hf(n),[a,l,c]=[o.color.r,o.color.g,o.color.b].map(uf),u=Math.round(255*o.opacity)<<24|c<<16|l<<8|a,h=[0,1].map(()=>new ke);for(let d=0;d+1<r.count;d+=2){for(let[m,g]of h.entries())g.set(r.getX(d+m),r.getY(d+m),r.getZ(d+m),1).applyMatrix4(n.matrixWorld).applyMatrix4(t);if(h.some(m=>m.w<=0))continue;let[f,p]=h.map(m=>[(m.x/m.w+1)/2*e,(1-m.y/m.w)/2*i]),_=Math.min(2e4,Math.ceil(Math.max(Math.abs(p[0]-f[0]),Math.abs(p[1]-f[1]))));for(let m=0;m<=_;m++){let[g,x]=[0,1].map(b=>Math.floor(f[b]+m/(_||1)*(p[b]-f[b])));g>=0&&g<e&&x>=0&&x<i&&(s[x*e+g]=u)}}}var C0=4096,SE=3.2,ME=new G(-.45,.75,1),wE=.42*Math.PI,AE=.64*Math.PI,EE=.5,TE=.14;function Ja(n,t,e,i,s){let r=S("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${RE}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0}),a=n.map(()=>S("div",{className:"cell"})),l=n.length>1,c=S("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let u=()=>l?Math.ceil(SE*parseFloat(getComputedStyle(a[0]).fontSize)):0,h=o?new lu({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0}):T0(r);h.setScissorTest(!0);let d=t0(r,n,t,m,s),f=n.map(N=>PE(N,e(N),d)),p=0,_=!1;function m(){p||(p=requestAnimationFrame(x))}function g(){for(let[N,k]of f.entries())k.shape.pose(t.clipTime(N));_=!0}function x(){cancelAnimationFrame(p),p=0,_||g();let N=r.clientHeight,k=u();h.setScissor(0,0,r.clientWidth,N),h.setViewport(0,0,r.clientWidth,N),h.clear();for(let[D,V]of f.entries()){d.aim(D);let X=a[D],W=[X.offsetLeft,N-X.offsetTop-X.offsetHeight,X.offsetWidth,X.offsetHeight-k];h.setViewport(...W),h.setScissor(...W),V.light.position.copy(ME).applyQuaternion(d.camera.quaternion);let ot=d.camera.position.z>V.floor.position.z;V.floor.material.opacity=ot?EE:TE,V.shape.shadow.visible=ot,V.shape.sort(d.camera.position),h.render(V.scene,d.camera)}d.aim()}function b(){for(let N of f)N.floor.material.color.set(be("--floor")),N.shape.paint();m()}function v(){let[N,k]=[c.clientWidth,c.clientHeight];if(!N||!k)return;h.setPixelRatio(Math.min(devicePixelRatio,2,C0/Math.max(N,k))),h.setSize(N,k,!1);let D=a[0].offsetHeight-u();d.resize(a[0].offsetWidth/D,k/D),x()}function A(N,k){let D=Math.min(N/c.clientWidth,C0/Math.max(c.clientWidth,c.clientHeight));h.setPixelRatio(D),h.setSize(c.clientWidth,c.clientHeight,!1),x();let V=k();return v(),V}let E=new ResizeObserver(v);E.observe(c);let y=t.onChange(()=>{_=!1,x()}),w=js(b);r.addEventListener("webglcontextrestored",m),b();function I(){cancelAnimationFrame(p),y(),w(),E.disconnect(),d.dispose();for(let{shape:N,floor:k}of f)N.dispose(),k.geometry.dispose(),k.material.dispose();h.dispose(),h.forceContextLoss(),c.remove()}function L(N){let k=N?f.reduce((D,{shape:V})=>Math.max(D,V.strains?.largest(N)??0),0):0;for(let{shape:D}of f)D.colourSheets?.(N,k||Number.MIN_VALUE);return m(),k}let P=o?null:S("p",{className:"note"},CE);return{element:c,note:P,canvas:r,cells:a,eye:d,pose:g,draw:x,drawSharp:A,paint:b,views:f,colourSheets:L,statistics:()=>h.info.render,dispose:I}}var CE="This browser has no WebGL: the processor draws the picture, without shadows and more slowly.",RE="Drag to turn, pinch to zoom; keys are listed below.";function PE(n,t,e){let i=o0(e.size,e.target);i.position.z=IE(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new Pa("#ffffff",wE),r=new ma;return r.add(t.group,t.shadow,i,s,new Ta("#ffffff","#dde2e8",AE)),{shape:t,floor:i,light:s,scene:r}}function IE(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var LE=.3,NE=4,DE=4,P0=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function I0(n,t){let e=OE(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())UE(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?LE:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:NE+DE*a,wayAt:l=>R0(e,i,l),timeAt:l=>R0(i,e,l)}}function OE(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function UE(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function R0(n,t,e){let[i,s]=ts(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var FE="M7 4.5v15l12-7.5z",kE="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",df=1e4;function Eu(n,t){let e=S("button",{type:"button",className:"play"}),i=S("input",{type:"range",min:0,max:df,step:1,"aria-label":"time"}),s=S("div",{className:"bands","aria-hidden":"true"}),r=S("div",{className:"ticks","aria-hidden":"true"}),o=S("p",{className:"time"}),a=S("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(f=>BE(f,t)):[],c=S("div",{className:"transport"},S("div",{className:"line"},e,S("div",{className:"track"},s,i,r)),S("div",{className:"choices"},o,...l.length?[S("div",{className:"states"},...l)]:[],zE(t),...VE(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/df))});let u=null,h=null,d=0;return t.onChange(()=>{let f=`${t.spans.indexOf(t.span)} ${t.stretched}`;f!==u&&GE(n,t,s,r),u=f,i.value=Math.round(df*t.shareAt(t.time)),i.setAttribute("aria-valuetext",L0(n,t));let p=n.length===1?` · ${ja(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),_=t.playing?`, ${HE(t.slowness)}`:"";o.textContent=`${ls(t.time,t.span)}${p}${_}`;for(let[m,g]of(n.length===1?n[0].marks:[]).entries())l[m].setAttribute("aria-pressed",String(Math.abs(g.time-t.clipTime(0))<1e-9));t.playing!==h&&(e.replaceChildren(fl(t.playing?kE:FE)),e.setAttribute("aria-label",t.playing?"pause":"play"),h=t.playing),clearTimeout(d),t.playing||(d=setTimeout(()=>{a.textContent=L0(n,t)},600))}),c}function BE(n,t){let e=S("button",{type:"button",className:"state"},S("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function zE(n){let t=P0.map(({name:i,value:s})=>S("option",{value:String(s)},i)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),S("label",{},"speed ",e)}function VE(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>S("option",{value:String(s)},i.name)),e=S("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[S("label",{},"show ",e)]}function GE(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(u=>u.driven&&n.length===1)){let[u,h]=[r(c.start-l),r(c.end-l)],d=S("span",{className:"band"});d.style.left=`${100*u}%`,d.style.width=`${100*(h-u)}%`,h>u&&e.append(d)}for(let c of a.marks){let u=c.time-l;if(u<s.start-1e-9||u>s.end+1e-9)continue;let h=S("span",{className:"tick"},n.length===1?c.letter:"");h.style.left=`${100*r(u)}%`,n.length>1&&h.style.setProperty("--tick",`var(--line-${o%7})`),i.append(h)}}}function HE(n){return n<1.05?"real time":`${n<10?qn(n,1):Math.round(n)} times slower`}function ja(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function L0(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${ja(i,r)}${WE(i,r)}`});return`${ls(t.time,t.span)}: ${e.join("; ")}`}function WE(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>qn(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function Eo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ja(t,e,f=>nf(f,i.largest_J),r,a),c=S("div",{className:"picture"},l.element,...l.note?[l.note]:[],Tu(l.eye,t.length>1||a?o:null));t.length===1&&XE(l.cells[0],t[0],e);let u=[tf(s,i,l.eye.size,t.length>1?o:null)];t.some(f=>f.strained)&&u.unshift(cf(l,u[0],t)),t.length===1&&t[0].efforts?.drives.length&&qE(u.at(-1),t[0],e),t.length>1&&t.some(f=>f.efforts?.drives.some(p=>p.arrow))&&u.at(-1).append(S("li",{className:"effort"},D0(),"torque or force of a drive, while it acts")),n.replaceChildren(c,Eu(t,e),...u,xu(t,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the moving ${o}`),N0(n,l,e,()=>$E(t,e));let h=_u(n,t,e,l.eye,Sr[0]);function d(){e.pause(),h(),l.dispose(),n.replaceChildren()}return{stage:l,dispose:d}}function To(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ja(t,e,h=>nf(h,i.largest_J),r,a),c=S("div",{className:"picture"},l.element,...l.note?[l.note]:[],Tu(l.eye,null,!a)),u=[tf(s,{...i,orMore:!0},l.eye.size,null)];return t.some(h=>h.strained)&&u.unshift(cf(l,u[0],t)),n.replaceChildren(c,...u),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} as set by the sliders`),N0(n,l,e,()=>""),s0(n,l.eye,Sr[0]),{stage:l}}function N0(n,t,e,i){let s=()=>[...n.querySelectorAll(".legend .energy:not([hidden])")];n.querySelector(".views").prepend(wu(t,e,i,s))}function $E(n,t){return`${n.length===1?`${ja(n[0],t.clipTime(0))}, `:""}${ls(t.time,t.span)}`}function XE(n,t,e){let i=S("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=ja(t,e.clipTime(0))})}function D0(){return S("span",{className:"swatch arrow","aria-hidden":"true"})}function qE(n,t,e){let i=t.efforts.drives.some(o=>o.arrow),s=o=>Wg(t.efforts,o,Ee).join("; ")||"no drive acts now",r=a0(Array.from(t.time,s));n.append(S("li",{className:"effort"},...i?[D0()]:[],r.element)),e.onChange(()=>r.say(s(e.clipTime(0))))}function Tu(n,t,e=!0){let i=(c,u,h)=>{let d=S("button",{type:"button",title:u,"aria-label":u},c);return d.addEventListener("click",h),d},s=Sr.map(c=>i(c.name,`${c.name}: view ${c.text}`,()=>n.show(c))),r=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([c,u,h])=>i(c,u,()=>n.turn(...h))),o=(c,u,h)=>{let d=i(c,u,()=>{n.choose({[h]:!n.look[h]}),d.setAttribute("aria-pressed",String(n.look[h]))});return d.setAttribute("aria-pressed",String(n.look[h])),d},a=[...e?[o("follow","follow: keep the picture filled as the structure moves","following")]:[],...t?[o("one scale",`one scale: draw all ${t}s at the same scale`,"oneScale")]:[]],l=[i("+","nearer",()=>n.zoom(1)),i("−","further",()=>n.zoom(-1))];return S("div",{className:"views",role:"group","aria-label":"view"},...a.length?[S("span",{},...a)]:[],S("span",{},...s),S("span",{className:"turns"},...r),S("span",{},...l))}var YE=4,ZE={deg:.05};function Co(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(b=>({name:b.name,title:b.row,parts:b.parts,text:v=>ff(v,b.unit),ofState:v=>v.readings[b.name]&&KE(v.readings[b.name],b.unit)})),c=b=>Ee(i.factor*b);t.tendons&&l.push({name:ws,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:b=>b.tendonEnergy_J.map(c)});let u=l.map(()=>a.map(()=>S("td"))),h=S("caption"),d=l.map(b=>b.title),f=a.length>YE,[p,_]=f?[d,a]:[a,d],m=S("tr",{},o?S("th",{scope:"col"},o):S("td"),...p.map(b=>S("th",{scope:"col"},b))),g=_.map((b,v)=>S("tr",{},S("th",{scope:"row"},b),...f?u.map(A=>A[v]):u[v])),x=S("table",{className:"numbers"},h,S("thead",{},m),S("tbody",{},...g));return n.replaceChildren(S("div",{className:"table"},x)),n.classList.add("readout"),e.onChange(()=>{let b=e.clipTime(s),v=t.markAt(b),A=v?`, ${v.name} (means)`:"",E=r?`${t.name}: `:"",y=o?`every ${o}`:"all values";h.textContent=`${Oe(`${E}${y}`)} at ${ls(e.time,e.span)}${A}`;for(let[w,I]of l.entries()){let L=v&&I.ofState(v)||Array.from(t.valuesAt(I.name,b),I.text);for(let[P,N]of I.parts.entries())u[w][N].textContent=L[P]}})}function ff(n,t){return t==="deg"?qn(n,1):Ee(n)}function KE({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(ZE[e]??.005*Math.abs(i));return`${ff(i,e)}${r?` ± ${ff(t[s],e)}`:""}`})}var JE=0;function Ro(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(O0(i),i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)jE(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e),e.addEventListener("scroll",()=>O0(e),{passive:!0})}function O0(n){let t=Math.abs(n.scrollLeft);n.classList.toggle("more-left",t>1),n.classList.toggle("more-right",t+n.clientWidth<n.scrollWidth-1)}function jE(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++JE}`,n.setAttribute("aria-labelledby",t.id)}function QE(n,t){let e=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in t&&(e[o.number]=`${o.before}${F0(t[i],s,r)}${o.after}`);return e.join(`
`)}function U0({knobs:n},t,e){let{unit:i,factor:s}=n.find(r=>r.key===t);return F0(e,i,s)}function F0(n,t,e){return`${Number((e*n).toPrecision(12))} ${t}`}function k0(n){let t=S("a",{className:"button",download:"design.toml"},"This setting as a design file"),e=S("code"),i=S("p",{className:"note"},"This page does not check the energy balance; a run of the file does."),s=S("div",{className:"setting"},t,S("pre",{},e),i);function r(o){let a=new TextEncoder().encode(QE(n,o));t.href=`data:application/toml;base64,${btoa(String.fromCharCode(...a))}`,e.textContent="forficula run design.toml"}return r({}),{element:s,refresh:r}}var tT=500,B0=[["a little",.1],["half",.5],["as strong as its drives",1]],z0=[["←","left","ArrowLeft",[-1,0]],["↑","up","ArrowUp",[0,1]],["↓","down","ArrowDown",[0,-1]],["→","right","ArrowRight",[1,0]]];function V0(n,t,e,i,s){let r=e.map((x,b)=>[x,b]).filter(([,x])=>t.movable[x]),o=S("select",{},...r.map(([x,b])=>S("option",{value:b},x))),a=S("select",{},...B0.map(([x,b])=>S("option",{value:b,selected:b===B0[0][1]},x))),l=S("span",{className:"note",role:"status"}),c=z0.map(([x,b,v])=>S("button",{type:"button",title:`push ${b}`,"aria-label":`push ${b}`,"data-way":v},x)),u=S("span",{className:"pad",role:"group","aria-label":"push in the plane of the picture"},...c),h=S("p",{className:"note"},"On these buttons, arrow keys push while they are held. Pressing a button pushes for half a second."),d=S("details",{className:"push-keys"},S("summary",{},"Push without a pointer"),S("div",{className:"choices"},S("label",{},"point ",o),S("label",{},"force ",a),u,l),h),f=eT(n,t,()=>Number(o.value),d),p=new Set,_=0;function m(){clearTimeout(_);let[x,b]=[0,1].map(E=>z0.reduce((y,[,,w,I])=>y+(p.has(w)?I[E]:0),0));if(!x&&!b){l.textContent="",s(0,null);return}let{camera:v}=n.eye,A=new G().setFromMatrixColumn(v.matrixWorld,0).multiplyScalar(x);A.addScaledVector(new G().setFromMatrixColumn(v.matrixWorld,1),b).setLength(Number(a.value)*i),l.textContent=`${o.selectedOptions[0].text} pushed with ${Ee(A.length())} N`,s(Number(o.value),A.toArray())}function g(){p.size&&(p.clear(),m())}u.addEventListener("keydown",x=>{!x.key.startsWith("Arrow")||x.shiftKey||x.ctrlKey||x.metaKey||x.altKey||(x.preventDefault(),x.stopPropagation(),!p.has(x.key)&&(p.add(x.key),m()))}),u.addEventListener("keyup",({key:x})=>{p.delete(x)&&m()}),u.addEventListener("focusout",g);for(let x of c)x.addEventListener("click",()=>{p.clear(),p.add(x.dataset.way),m(),_=setTimeout(g,tT)});return o.addEventListener("change",()=>{g(),f()}),d.addEventListener("toggle",f),d}function eT(n,t,e,i){let s="http://www.w3.org/2000/svg",r=document.createElementNS(s,"svg"),o=document.createElementNS(s,"circle");o.setAttribute("r","9"),r.classList.add("push"),r.setAttribute("aria-hidden","true"),r.append(o),n.element.append(r);let a=new G;function l(){if(r.style.display=i.open?"":"none",!i.open)return;let{x:c,y:u}=a.fromArray(t.frame.points,3*e()).project(n.eye.camera);o.setAttribute("cx",(c+1)/2*n.canvas.clientWidth),o.setAttribute("cy",(1-u)/2*n.canvas.clientHeight)}return t.clock.onChange(l),n.eye.controls.addEventListener("change",l),l(),l}var nT=22,iT=.25;function G0(n,t,e,i,s){let{canvas:r,eye:o}=n,a=document.createElementNS("http://www.w3.org/2000/svg","line"),l=document.createElementNS("http://www.w3.org/2000/svg","svg");l.classList.add("push"),l.setAttribute("aria-hidden","true"),l.append(a);let c=S("p",{className:"pushed","aria-hidden":"true"});n.element.append(l,c),l.style.display="none";let u=new G,h=null;function d(x){let b=u.fromArray(t.frame.points,3*x).project(o.camera);return[(b.x+1)/2*r.clientWidth,(1-b.y)/2*r.clientHeight]}function f(x){let b=r.getBoundingClientRect();return[x.clientX-b.left,x.clientY-b.top]}function p([x,b]){let v={point:-1,away:nT};for(let A=0;A<t.movable.length;A++){if(!t.movable[A])continue;let[E,y]=d(A),w=Math.hypot(E-x,y-b);w<v.away&&(v={point:A,away:w})}return v.point}function _(x){let[b,v]=f(x),A=new G().fromArray(t.frame.points,3*h),E=A.clone().project(o.camera).z;return new G(2*b/r.clientWidth-1,1-2*v/r.clientHeight,E).unproject(o.camera).sub(A).multiplyScalar(i/(iT*e)).clampLength(0,i).toArray()}function m(x,b){let[v,A]=[d(h),f(x)];for(let[E,y]of[["x1",v[0]],["y1",v[1]],["x2",A[0]],["y2",A[1]]])a.setAttribute(E,y);l.style.display="",c.textContent=`pushed with ${Ee(b)} N`}r.addEventListener("pointerdown",x=>{let b=x.button===0?p(f(x)):-1;b<0||(h=b,o.controls.enabled=!1,r.setPointerCapture(x.pointerId),x.stopImmediatePropagation())},{capture:!0}),r.addEventListener("pointermove",x=>{if(h===null){r.classList.toggle("grip",p(f(x))>=0);return}let b=_(x);s(h,b),m(x,Math.hypot(...b))});let g=()=>{h!==null&&(h=null,o.controls.enabled=!0,l.style.display="none",c.textContent="",s(0,null))};r.addEventListener("pointerup",g),r.addEventListener("pointercancel",g)}var Qa=200,sT=20,rT=3;function H0(n,t,e){let i=n.map(o=>oT(o,t,e)),s=S("button",{type:"button",disabled:!0},`Reset all to ${t}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=S("div",{className:"sliders",role:"group","aria-label":"values to change"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function oT(n,t,e){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=sT,u=A=>c?a*(l/a)**A:a+A*(l-a),h=A=>c?Math.log(A/a)/Math.log(l/a):(A-a)/(l-a),d=Math.round(Qa*h(n.value)),f=Oe(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=S("input",{type:"range",min:0,max:Qa,step:1,"aria-label":f,"aria-description":s}),_=S("output"),m=S("span",{className:"home",title:`in ${t}`,"aria-hidden":"true"});m.style.left=`${100*d/Qa}%`,p.dataset.keys="own";let g=n.value;function x(){let A=`${Ee(o*g)} ${r.replaceAll("^2","²").replaceAll("^3","³")}`;_.textContent=A,p.setAttribute("aria-valuetext",g===n.value?`${A}, as in ${t}`:A),v.classList.toggle("changed",g!==n.value)}function b(A){g=A,p.value=Math.round(Qa*h(g)),x(),e(i,g)}p.addEventListener("input",()=>{let A=Number(p.value);g=A===d?n.value:Number((o*u(A/Qa)).toPrecision(rT))/o,x(),e(i,g)});let v=S("label",{className:"slider",title:`${i}: ${s}`},S("span",{className:"name"},f),_,S("span",{className:"rail"},p,m));return p.value=d,x(),{element:v,knob:n,get value(){return g},put:b,reset:()=>b(n.value)}}var aT=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],lT=.2,cT=1.4,uT="Values were changed, or it was pushed, during the motion, which no run of a design file repeats. “Whole protocol” runs these settings from the start.",hT=1e-15;async function Po(n,t,e,i,{look:s,pace:r=lT,set:o}={}){let a=JSON.parse(e),l={frame:null,engine:null,pace:r},c=await i(e,w=>E(w)),u=e0(n,a,c.first),h=S("p",{className:"verdict",role:"status"}),d=S("p",{className:"note"}),f=S("p",{className:"time"}),p=S("p",{className:"account"}),_=S("div"),m=S("div"),g=k0(a),x=H0(a.knobs,t.kind==="bench"?"the design":"this run",(w,I)=>{c.send({act:"set",values:{[w]:I}}),x.refresh(),g.refresh(x.changes),o?.(w,U0(a,w,I))}),b=fT(a,c,l,()=>{h.textContent="",d.textContent=""}),v=a.motors.every(w=>w.kind==="torque")?"torques":"drives",A=null;function E(w){if(w.said==="refused"){h.textContent=`The simulator stopped: ${w.why}.`;return}w.said==="frame"&&y(w.frame)}function y(w){l.frame=w,u.show(w),f.textContent=`${ls(w.time_s,{start:0,end:Math.max(1,w.time_s)})}${pT(w,a.protocol)}`;let I=w.energies_J.reduce((D,V)=>D+V,0),L=w.works_J.reduce((D,V)=>D+V,0),P=[...n.tendons?[`tendon energy ${pf(I)}`]:[],`work of the ${v} ${pf(L)}`];p.textContent=P.join(" · ");let N=w.stageNumber===null?w.ended:null,k=N&&JSON.stringify([N.verdict,...N.stages.map(D=>D.end_s)]);k!==A&&(h.textContent=N?mT(N,t.whole,a.texts.outcome):"",d.textContent=[N?.advice,N&&w.meddled&&uT].filter(Boolean).join(" ")),A=k}return l.element=S("div",{className:"trial"},S("div",{className:"seen"},S("div",{className:"choices"},...b),S("div",{className:"live-facts"},f,p),h,d,_,m),S("div",{className:"hands"},x.element,...o?[]:[g.element])),l.begin=()=>{let w=s??{...Mr(),following:!1,closer:t.kind==="bench"?cT:1},{stage:I}=To(_,[u.clip],u.clock,{...t,text:`${t.shape}, live.`},w);if(l.stage=I,Co(m,u.clip,u.clock,t.energy),Ro(l.element),I){u.movable=a.anchors.bodies.map(N=>N>0);let L=dT(a,n.mesh.span_m),P=(N,k)=>c.send({act:"push",point:N,force:k});G0(I,u,n.mesh.span_m,L,P),_.querySelector(".picture").after(V0(I,u,a.anchors.names,L,P))}y(c.first),c.send({act:"pace",value:l.pace}),c.send({act:"restart",through:!1}),t.kind!=="bench"&&b[0].focus()},l.leave=()=>l.stage?.dispose(),Object.assign(l,{engine:c,live:u,sliders:x,design:g,own:a})}function dT({protocol:n,motors:t},e){let i=n.drives.map(({strength:s,torques:r})=>{let o=t[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/e:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function fT({protocol:n},t,e,i){let s=(a,l,c)=>{let u=S("button",{type:"button",title:c});return u.append(a),u.addEventListener("click",()=>{i(),t.send(l)}),u},r=n.stages.flatMap(({name:a,drives:l},c)=>{if(!l.length)return[];let u=n.stages.findIndex((d,f)=>f>c&&d.drives.length>0),h=(u<0?n.stages.length:u)-1;return[s(Oe(a),{act:"stages",from:c,to:h},`the stage "${a}" of the protocol, and what follows without a drive`)]}),o=S("select",{},...aT.map(([a,l])=>S("option",{value:l,selected:l===e.pace},a)));return o.addEventListener("change",()=>{e.pace=Number(o.value),t.send({act:"pace",value:e.pace})}),[s("Start again",{act:"restart",through:!1},"from the start of the run"),...r,s("Release",{act:"release"},"without any drive"),s("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),S("label",{},"speed ",o)]}function pT({stage:n,stageNumber:t,running:e,ended:i},{stages:s}){let r=n&&!s[t].drives.length&&i?.stages.at(-1),a=r&&r.goal_s!==null&&s.find(({name:l})=>l===r.name).drives.length?`, ${r.name} reached its goal in ${Os(r.goal_s-r.start_s,"s")}`:"";return n?` · ${n}${a}`:e?" · no drive acts":" · at rest"}function mT({status:n,verdict:t,transitions:e},i,s){let r=e.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>bh(s.transition,{did:o.did||o.done,time:Os(a.time_s,"s"),work:pf(a.work_J)}));return r.length?bh(s[t==="reached"?"reached":"missed"],{whole:i,transitions:r.join(s.then),status:n}):`${Oe(n)}.`}var pf=n=>Os(Math.abs(n)<hT?0:n,"J");function Cu(n,t,e,i){if(!n)return null;let s={panel:null,failed:"",start:null},r=document.getElementById("live").textContent,o=S("button",{type:"button",className:"try"},"Try it"),a=S("p",{className:"note"});a.textContent=`Move this ${e.whole} yourself: change values, switch drives, release it, push it. The simulator runs in this page.`,n.append(S("div",{className:"offer"},o,a));function l(u){s.failed=u,o.disabled=!0,a.textContent=`This ${e.whole} cannot be simulated in a page: ${u}. Use the command line: forficula run.`}let c=JSON.parse(r.startsWith('{"refused"')?r:"null");return c!==null?l(c.refused):pu()||l("this page was written without the engine"),s.start=async()=>{if(!o.disabled){o.disabled=!0,a.setAttribute("role","status"),a.textContent="Starting the simulator …",i();try{s.panel=await Po(t,e,r,wo),n.replaceChildren(S("h2",{},"Try it"),s.panel.element),s.panel.begin()}catch(u){l(u.message)}}},o.addEventListener("click",s.start),s}function W0(n){let t=ti(n.clips[0]),e=Cu(document.getElementById("try"),t,n,()=>{});return e.start(),{clips:[t],trial:e}}var gT=200;function As(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function u(){return c.has(s)||c.set(s,I0(n,s)),c.get(s)}let h=()=>r==="even"&&s.whole;function d(x){return h()?u().wayAt(x):(x-s.start)/(s.end-s.start||1)}function f(x){return h()?u().timeAt(x):s.start+x*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(_))}function _(x){if(l=0,o){let b=Math.min((x-a)/1e3,.1);a=x,m(b),l=requestAnimationFrame(_)}for(let b of e)b()}function m(x){r==="even"?i=u().timeAt(Math.min(1,u().wayAt(i)+x/u().seconds)):i=Math.min(s.end,i+r*x),i>=s.end&&(o=!1)}function g(x){i=Math.min(s.end,Math.max(s.start,x)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(x,b=i)=>Math.min(n[x].end,Math.max(n[x].start,b+s.origins[x])),get stretched(){return h()},shareAt:d,momentAt:f,wayAt:x=>u().wayAt(x),timeAt:x=>u().timeAt(x),get slowness(){if(r!=="even")return 1/r;let x=u().wayAt(i),[b,v]=[Math.max(0,x-5e-4),Math.min(1,x+5e-4)];return(v-b)*u().seconds/(u().timeAt(v)-u().timeAt(b)||1e-12)},onChange(x){return e.add(x),p(),()=>e.delete(x)},seek:g,seekClip(x,b){(b<s.start+s.origins[x]||b>s.end+s.origins[x])&&(s=t.find(v=>b>=v.start+v.origins[x]&&b<=v.end+v.origins[x])??t[0]),g(b-s.origins[x])},step:x=>g(f(d(i)+x/gT)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(x){r=x,p()},setSpan(x){s=x,g(i<s.start||i>s.end?s.start:i)},redraw:p}}var xT="uplot",_T="u-hz",yT="u-vt",vT="u-title",bT="u-wrap",ST="u-under",MT="u-over",wT="u-axis",Er="u-off",AT="u-select",ET="u-cursor-x",TT="u-cursor-y",CT="u-cursor-pt",RT="u-legend",PT="u-live",IT="u-inline",LT="u-series",NT="u-marker",$0="u-label",DT="u-value",el="width",nl="height";var X0="bottom",Io="left",mf="right",Lf="#000",q0=Lf+"0",gf="mousemove",Y0="mousedown",xf="mouseup",Z0="mouseenter",K0="mouseleave",J0="dblclick",OT="resize",UT="scroll",j0="change",Nu="dppxchange",Nf="--",ko=typeof window<"u",Sf=ko?document:null,No=ko?window:null,FT=ko?navigator:null,Ae,Ru;function Mf(){let n=devicePixelRatio;Ae!=n&&(Ae=n,Ru&&Af(j0,Ru,Mf),Ru=matchMedia(`(min-resolution: ${Ae-.001}dppx) and (max-resolution: ${Ae+.001}dppx)`),Tr(j0,Ru,Mf),No.dispatchEvent(new CustomEvent(Nu)))}function pi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function wf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function qe(n,t,e){n.style[t]=e+"px"}function Oi(n,t,e,i){let s=Sf.createElement(n);return t!=null&&pi(s,t),e?.insertBefore(s,i),s}function Mi(n,t){return Oi("div",n,t)}var Q0=new WeakMap;function es(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=Q0.get(n);r!=o&&(n.style.transform=r,Q0.set(n,r),t<0||e<0||t>i||e>s?pi(n,Er):wf(n,Er))}var tx=new WeakMap;function ex(n,t,e){let i=t+e,s=tx.get(n);i!=s&&(tx.set(n,i),n.style.background=t,n.style.borderColor=e)}var nx=new WeakMap;function ix(n,t,e,i){let s=t+""+e,r=nx.get(n);s!=r&&(nx.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Df={passive:!0},kT={...Df,capture:!0};function Tr(n,t,e,i){t.addEventListener(n,e,i?kT:Df)}function Af(n,t,e,i){t.removeEventListener(n,e,Df)}ko&&Mf();function Ui(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:mi((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Ix(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var Lx=n=>n!=null,Nx=n=>n!=null&&n>0,Uu=Ix(Lx),BT=Ix(Nx);function zT(n,t,e,i=0,s=!1){let r=s?BT:Uu,o=s?Nx:Lx;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Be,l??-Be]}function Fu(n,t,e,i){let s=ox(n),r=ox(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Es:Dx,a=s==1?mi:wi,l=r==1?wi:mi,c=a(o(wn(n))),u=l(o(wn(t))),h=Do(e,c),d=Do(e,u);return e==10&&(c<0&&(h=ze(h,-c)),u<0&&(d=ze(d,-u))),i||e==2?(n=h*s,t=d*r):(n=kx(n,h),t=ku(t,d)),[n,t]}function Of(n,t,e,i){let s=Fu(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Uf=.1,sx={mode:3,pad:Uf},sl={pad:0,soft:null,mode:0},VT={min:sl,max:sl};function Du(n,t,e,i){return Bu(e)?rx(n,t,e):(sl.pad=e,sl.soft=i?0:null,sl.mode=i?3:0,rx(n,t,VT))}function Se(n,t){return n??t}function GT(n,t,e){for(t=Se(t,0),e=Se(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function rx(n,t,e){let i=e.min,s=e.max,r=Se(i.pad,0),o=Se(s.pad,0),a=Se(i.hard,-Be),l=Se(s.hard,Be),c=Se(i.soft,Be),u=Se(s.soft,-Be),h=Se(i.mode,0),d=Se(s.mode,0),f=t-n,p=Es(f),_=Jn(wn(n),wn(t)),m=Es(_),g=wn(m-p);(f<1e-24||g>10)&&(f=0,(n==0||t==0)&&(f=1e-24,h==2&&c!=Be&&(r=0),d==2&&u!=-Be&&(o=0)));let x=f||_||1e3,b=Es(x),v=Do(10,mi(b)),A=x*(f==0?n==0?.1:1:r),E=ze(kx(n-A,v/10),24),y=n>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Be,w=Jn(a,E<y&&n>=y?y:Fi(y,E)),I=x*(f==0?t==0?.1:1:o),L=ze(ku(t+I,v/10),24),P=t<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Be,N=Fi(l,L>P&&t<=P?P:Jn(P,L));return w==N&&w==0&&(N=100),[w,N]}var HT=new Intl.NumberFormat(ko?FT.language:"en-US"),Ff=n=>HT.format(n),gi=Math,Lu=gi.PI,wn=gi.abs,mi=gi.floor,Mn=gi.round,wi=gi.ceil,Fi=gi.min,Jn=gi.max,Do=gi.pow,ox=gi.sign,Es=gi.log10,Dx=gi.log2,WT=(n,t=1)=>gi.sinh(n)*t,_f=(n,t=1)=>gi.asinh(n/t),Be=1/0;function ax(n){return(Es((n^n>>31)-(n>>31))|0)+1}function Ef(n,t,e){return Fi(Jn(n,t),e)}function Ox(n){return typeof n=="function"}function _e(n){return Ox(n)?n:()=>n}var $T=()=>{},Ux=n=>n,Fx=(n,t)=>t,XT=n=>null,lx=n=>!0,cx=(n,t)=>n==t,qT=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=n=>{if(zx(n)||ir.has(n))return n;let t=`${n}`,e=t.match(qT);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Cr(s)}e${r}`}return ze(n,i)};function wr(n,t){return Cr(ze(Cr(n/t))*t)}function ku(n,t){return Cr(wi(Cr(n/t))*t)}function kx(n,t){return Cr(mi(Cr(n/t))*t)}function ze(n,t=0){if(zx(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Mn(i)/e}var ir=new Map;function Bx(n){return((""+n).split(".")[1]||"").length}function ol(n,t,e,i){let s=[],r=i.map(Bx);for(let o=t;o<e;o++){let a=wn(o),l=ze(Do(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=n==10?u:ze(u,h);s.push(d),ir.set(d,h)}}return s}var rl={},kf=[],Oo=[null,null],nr=Array.isArray,zx=Number.isInteger,YT=n=>n===void 0;function ux(n){return typeof n=="string"}function Bu(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function ZT(n){return n!=null&&typeof n=="object"}var KT=Object.getPrototypeOf(Uint8Array),Vx="__proto__";function Uo(n,t=Bu){let e;if(nr(n)){let i=n.find(s=>s!=null);if(nr(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Uo(n[s],t)}else e=n.slice()}else if(n instanceof KT)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Vx&&(e[i]=Uo(n[i],t))}else e=n;return e}function gn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Vx&&(Bu(n[s])?gn(n[s],Uo(i[s])):n[s]=Uo(i[s]))}return n}var JT=0,jT=1,QT=2;function tC(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function eC(n,t){if(sC(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return rC(o[0])||(o=iC(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=t?t[o][c]:jT,f=[];for(let p=0;p<u.length;p++){let _=u[p],m=r.get(l[p]);_===null?d!=JT&&(h[m]=_,d==QT&&f.push(m)):h[m]=_}tC(h,f,s),i.push(h)}}return i}var nC=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function iC(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function sC(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function rC(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Jn(1,mi((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Gx=["January","February","March","April","May","June","July","August","September","October","November","December"],Hx=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Wx(n){return n.slice(0,3)}var oC=Hx.map(Wx),aC=Gx.map(Wx),lC={MMMM:Gx,MMM:aC,WWWW:Hx,WWW:oC};function tl(n){return(n<10?"0":"")+n}function cC(n){return(n<10?"00":n<100?"0":"")+n}var uC={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>tl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>tl(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>tl(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>tl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>tl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>cC(n.getMilliseconds())};function Bf(n,t){t=t||lC;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?uC[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var hC=new Intl.DateTimeFormat().resolvedOptions().timeZone;function dC(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==hC?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var $x=n=>n%1==0,Ou=[1,2,2.5,5],fC=ol(10,-32,0,Ou),Xx=ol(10,0,32,Ou),pC=Xx.filter($x),Ar=fC.concat(Xx),zf=`
`,qx="{YYYY}",hx=zf+qx,Yx="{M}/{D}",il=zf+Yx,Pu=il+"/{YY}",Zx="{aa}",mC="{h}:{mm}",Lo=mC+Zx,dx=zf+Lo,fx=":{ss}",Ce=null;function Kx(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?ol(10,0,3,Ou).filter($x):ol(10,-3,0,Ou)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,qx,Ce,Ce,Ce,Ce,Ce,Ce,1],[s*28,"{MMM}",hx,Ce,Ce,Ce,Ce,Ce,1],[s,Yx,hx,Ce,Ce,Ce,Ce,Ce,1],[i,"{h}"+Zx,Pu,Ce,il,Ce,Ce,Ce,1],[e,Lo,Pu,Ce,il,Ce,Ce,Ce,1],[t,fx,Pu+" "+Lo,Ce,il+" "+Lo,Ce,dx,Ce,1],[n,fx+".{fff}",Pu+" "+Lo,Ce,il+" "+Lo,Ce,dx,Ce,1]];function u(h){return(d,f,p,_,m,g)=>{let x=[],b=m>=o,v=m>=r&&m<o,A=h(p),E=ze(A*n,3),y=yf(A.getFullYear(),b?0:A.getMonth(),v||b?1:A.getDate()),w=ze(y*n,3);if(v||b){let I=v?m/r:0,L=b?m/o:0,P=E==w?E:ze(yf(y.getFullYear()+L,y.getMonth()+I,1)*n,3),N=new Date(Mn(P/n)),k=N.getFullYear(),D=N.getMonth();for(let V=0;P<=_;V++){let X=yf(k+L*V,D+I*V,1),W=X-h(ze(X*n,3));P=ze((+X+W)*n,3),P<=_&&x.push(P)}}else{let I=m>=s?s:m,L=mi(p)-mi(E),P=w+L+ku(E-w,I);x.push(P);let N=h(P),k=N.getHours()+N.getMinutes()/e+N.getSeconds()/i,D=m/i,V=d.axes[f]._space,X=g/V;for(;P=ze(P+m,n==1?0:3),!(P>_);)if(D>1){let W=mi(ze(k+D,6))%24,Q=h(P).getHours()-W;Q>1&&(Q=-1),P-=Q*i,k=(k+D)%24;let it=x[x.length-1];ze((P-it)/m,3)*X>=.7&&x.push(P)}else x.push(P)}return x}}return[l,c,u]}var[gC,xC,_C]=Kx(1),[yC,vC,bC]=Kx(.001);ol(2,-53,53,[1]);function px(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function mx(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,u,h,d,f;return i.map(p=>{let _=n(p),m=_.getFullYear(),g=_.getMonth(),x=_.getDate(),b=_.getHours(),v=_.getMinutes(),A=_.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||x!=u&&a[4]||b!=h&&a[5]||v!=d&&a[6]||A!=f&&a[7]||a[1];return l=m,c=g,u=x,h=b,d=v,f=A,E(_)})}}function SC(n,t){let e=Bf(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function yf(n,t,e){return new Date(n,t,e)}function gx(n,t){return t(n)}var MC="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function xx(n,t){return(e,i,s,r)=>r==null?Nf:t(n(i))}function wC(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function AC(n,t){return n.series[t].fill(n,t)}var EC={show:!0,live:!0,isolate:!1,mount:$T,markers:{show:!0,width:2,stroke:wC,fill:AC,dash:"solid"},idx:null,idxs:null,values:[]};function TC(n,t){let e=n.cursor.points,i=Mi(),s=e.size(n,t);qe(i,el,s),qe(i,nl,s);let r=s/-2;qe(i,"marginLeft",r),qe(i,"marginTop",r);let o=e.width(n,t,s);return o&&qe(i,"borderWidth",o),i}function CC(n,t){let e=n.series[t].points;return e._fill||e._stroke}function RC(n,t){let e=n.series[t].points;return e._stroke||e._fill}function PC(n,t){return n.series[t].points.size}var vf=[0,0];function IC(n,t,e){return vf[0]=t,vf[1]=e,vf}function Iu(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function bf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var LC={show:!0,x:!0,y:!0,lock:!1,move:IC,points:{one:!1,show:TC,size:PC,width:0,stroke:RC,fill:CC},bind:{mousedown:Iu,mouseup:Iu,click:Iu,dblclick:Iu,mousemove:bf,mouseleave:bf,mouseenter:bf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Jx={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Vf=gn({},Jx,{filter:Fx}),jx=gn({},Vf,{size:10}),Qx=gn({},Jx,{show:!1}),Gf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',t_="bold "+Gf,e_=1.5,_x={show:!0,scale:"x",stroke:Lf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:t_,side:2,grid:Vf,ticks:jx,border:Qx,font:Gf,lineGap:e_,rotate:0},NC="Value",DC="Time",yx={show:!0,scale:"x",auto:!1,sorted:1,min:Be,max:-Be,idxs:[]};function OC(n,t,e,i,s){return t.map(r=>r==null?"":Ff(r))}function UC(n,t,e,i,s,r,o){let a=[],l=ir.get(s)||0;e=o?e:ze(ku(e,s),l);for(let c=e;c<=i;c=ze(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Tf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Es:Dx,u=mi(c(e));s=Do(l,u),l==10&&(s=Ar[Ui(s,Ar)]);let h=e,d=s*l;l==10&&(d=Ar[Ui(d,Ar)]);do a.push(h),h=h+s,l==10&&!ir.has(h)&&(h=ze(h,ir.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=Ar[Ui(d,Ar)]));while(h<=i);return a}function FC(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Tf(n,t,Jn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?Tf(n,t,Jn(l,-i),-e,s):[l]).reverse().map(d=>-d).concat(u,c)}var n_=/./,kC=/[12357]/,BC=/[125]/,vx=/1/,Cf=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function zC(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?n_:l(7,o)-u>=c?kC:l(5,o)-u>=c?BC:vx;if(h==vx){let d=wn(l(1,o)-u);if(d<c)return Cf(t.slice().reverse(),a.distr,h,wi(c/d)).reverse()}return Cf(t,a.distr,h,1)}function VC(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?Cf(t.slice().reverse(),3,n_,wi(a/c)).reverse():t}function GC(n,t,e,i){return i==null?Nf:t==null?"":Ff(t)}var bx={show:!0,scale:"y",stroke:Lf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:t_,side:3,grid:Vf,ticks:jx,border:Qx,font:Gf,lineGap:e_,rotate:0};function HC(n,t){let e=3+(n||1)*2;return ze(e*t,3)}function WC(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=wn(o-r),l=n.series[t],c=a/(l.points.space*Ae);return i[1]-i[0]<=c}var Sx={scale:null,auto:!0,sorted:0,min:Be,max:-Be},i_=(n,t,e,i,s)=>s,Mx={show:!0,auto:!0,sorted:0,gaps:i_,alpha:1,facets:[gn({},Sx,{scale:"x"}),gn({},Sx,{scale:"y"})]},wx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:i_,alpha:1,points:{show:WC,filter:null},values:null,min:Be,max:-Be,idxs:[],path:null,clip:null};function $C(n,t,e,i,s){return e/10}var s_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},XC=gn({},s_,{time:!1,ori:1}),Ax={};function r_(n,t){let e=Ax[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Ax[n]=e)),e}var Fo=1,Rf=2;function Rr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,p=a.width,_=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,g,d,f,p,_,Vu,Bo,Hu,a_,c_):e(s,l,c,u,h,g,m,f,d,_,p,Gu,zo,$f,l_,u_)}function Hf(n,t){let e=0,i=0,s=Se(n.bands,kf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function qC(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ts(n,t,e,i,s,r){return Rr(n,t,(o,a,l,c,u,h,d,f,p,_,m)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),b=c.ori==0?Bo:zo,v,A;x==1?(v=e,A=i):(v=i,A=e);let E=g(h(a[v],c,_,f)),y=g(d(l[v],u,m,p)),w=g(h(a[A],c,_,f)),I=g(d(r==1?u.max:u.min,u,m,p)),L=new Path2D(s);return b(L,w,I),b(L,E,I),b(L,E,y),L})}function zu(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Hu:$f,l=e;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+r),l=d[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function YC(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function Wf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,d=c;if(s==1)for(;++c<=i&&t[c]===null;)d=c;else for(;--c>=e&&t[c]===null;)d=c;let f=r(n[h]),p=d==h?f:r(n[d]),_=h-s;f=o<=0&&_>=0&&_<l?r(n[_]):f;let g=d+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=f&&a.push([f,p])}return a}function Ex(n){return n==0?Ux:n==1?Mn:t=>wr(t,n)}function o_(n){let t=n==0?Vu:Gu,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Fi(c,a/2,l/2),u=Fi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}var Vu=(n,t,e)=>{n.moveTo(t,e)},Gu=(n,t,e)=>{n.moveTo(e,t)},Bo=(n,t,e)=>{n.lineTo(t,e)},zo=(n,t,e)=>{n.lineTo(e,t)},Hu=o_(0),$f=o_(1),a_=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},l_=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},c_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},u_=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function h_(n){return(t,e,i,s,r)=>Rr(t,e,(o,a,l,c,u,h,d,f,p,_,m)=>{let{pxRound:g,points:x}=o,b,v;c.ori==0?(b=Vu,v=a_):(b=Gu,v=l_);let A=ze(x.width*Ae,3),E=(x.size-x.width)/2*Ae,y=ze(E*2,3),w=new Path2D,I=new Path2D,{left:L,top:P,width:N,height:k}=t.bbox;Hu(I,L-y,P-y,N+y*2,k+y*2);let D=V=>{if(l[V]!=null){let X=g(h(a[V],c,_,f)),W=g(d(l[V],u,m,p));b(w,X+E,W),v(w,X,W,E,0,Lu*2)}};if(r)r.forEach(D);else for(let V=i;V<=s;V++)D(V);return{stroke:A>0?w:null,fill:w,clip:I,flags:Fo|Rf}})}function d_(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var ZC=d_(Bo),KC=d_(zo);function f_(n){let t=Se(n?.alignGaps,0);return(e,i,s,r)=>Rr(e,i,(o,a,l,c,u,h,d,f,p,_,m)=>{[s,r]=Uu(l,s,r);let g=o.pxRound,x=k=>g(h(k,c,_,f)),b=k=>g(d(k,u,m,p)),v,A;c.ori==0?(v=Bo,A=ZC):(v=zo,A=KC);let E=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},w=y.stroke,I=!1;if(r-s>=_*4){let k=dt=>e.posToVal(dt,c.key,!0),D=null,V=null,X,W,ot,Z=x(a[E==1?s:r]),Q=x(a[s]),it=x(a[r]),ft=k(E==1?Q+1:it-1);for(let dt=E==1?s:r;dt>=s&&dt<=r;dt+=E){let tt=a[dt],gt=(E==1?tt<ft:tt>ft)?Z:x(tt),St=l[dt];gt==Z?St!=null?(W=St,D==null?(v(w,gt,b(W)),X=D=V=W):W<D?D=W:W>V&&(V=W)):St===null&&(I=!0):(D!=null&&A(w,Z,b(D),b(V),b(X),b(W)),St!=null?(W=St,v(w,gt,b(W)),D=V=X=W):(D=V=null,St===null&&(I=!0)),Z=gt,ft=k(Z+E))}D!=null&&D!=V&&ot!=Z&&A(w,Z,b(D),b(V),b(X),b(W))}else for(let k=E==1?s:r;k>=s&&k<=r;k+=E){let D=l[k];D===null?I=!0:D!=null&&v(w,x(a[k]),b(D))}let[P,N]=Hf(e,i);if(o.fill!=null||P!=0){let k=y.fill=new Path2D(w),D=o.fillTo(e,i,o.min,o.max,P),V=b(D),X=x(a[s]),W=x(a[r]);E==-1&&([W,X]=[X,W]),v(k,W,V),v(k,X,V)}if(!o.spanGaps){let k=[];I&&k.push(...Wf(a,l,s,r,E,x,t)),y.gaps=k=o.gaps(e,i,s,r,k),y.clip=zu(k,c.ori,f,p,_,m)}return N!=0&&(y.band=N==2?[Ts(e,i,s,r,w,-1),Ts(e,i,s,r,w,1)]:Ts(e,i,s,r,w,N)),y})}function JC(n){let t=Se(n.align,1),e=Se(n.ascDesc,!1),i=Se(n.alignGaps,0),s=Se(n.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,u,h,d,f,p,_,m,g,x,b)=>{[a,l]=Uu(h,a,l);let v=c.pxRound,{left:A,width:E}=r.bbox,y=Q=>v(p(Q,d,x,m)),w=Q=>v(_(Q,f,b,g)),I=d.ori==0?Bo:zo,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fo},P=L.stroke,N=d.dir*(d.ori==0?1:-1),k=w(h[N==1?a:l]),D=y(u[N==1?a:l]),V=D,X=D;s&&t==-1&&(X=A,I(P,X,k)),I(P,D,k);for(let Q=N==1?a:l;Q>=a&&Q<=l;Q+=N){let it=h[Q];if(it==null)continue;let ft=y(u[Q]),dt=w(it);t==1?I(P,ft,k):I(P,V,dt),I(P,ft,dt),k=dt,V=ft}let W=V;s&&t==1&&(W=A+E,I(P,W,k));let[ot,Z]=Hf(r,o);if(c.fill!=null||ot!=0){let Q=L.fill=new Path2D(P),it=c.fillTo(r,o,c.min,c.max,ot),ft=w(it);I(Q,W,ft),I(Q,X,ft)}if(!c.spanGaps){let Q=[];Q.push(...Wf(u,h,a,l,N,y,i));let it=c.width*Ae/2,ft=e||t==1?it:-it,dt=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=ft,tt[1]+=dt}),L.gaps=Q=c.gaps(r,o,a,l,Q),L.clip=zu(Q,d.ori,m,g,x,b)}return Z!=0&&(L.band=Z==2?[Ts(r,o,a,l,P,-1),Ts(r,o,a,l,P,1)]:Ts(r,o,a,l,P,Z)),L})}function Tx(n,t,e,i,s,r,o=Be){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=wn(n[l]-n[a]);u<c&&(c=u,o=wn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function jC(n){n=n||rl;let t=Se(n.size,[.6,Be,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=_e(s),o=1-t[0],a=Se(t[1],Be),l=Se(t[2],1),c=Se(n.disp,rl),u=Se(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,p,_,m)=>Rr(f,p,(g,x,b,v,A,E,y,w,I,L,P)=>{let N=g.pxRound,k=e,D=i*Ae,V=a*Ae,X=l*Ae,W,ot;v.ori==0?[W,ot]=r(f,p):[ot,W]=r(f,p);let Z=v.dir*(v.ori==0?1:-1),Q=v.ori==0?Hu:$f,it=v.ori==0?u:(Rt,Yt,re,wt,Fe,zt,$t)=>{u(Rt,Yt,re,Fe,wt,$t,zt)},ft=Se(f.bands,kf).find(Rt=>Rt.series[0]==p),dt=ft!=null?ft.dir:0,tt=g.fillTo(f,p,g.min,g.max,dt),ht=N(y(tt,A,P,I)),gt,St,Mt,Ht=L,se=N(g.width*Ae),Vt=!1,he=null,le=null,ne=null,Ye=null;h!=null&&(se==0||d!=null)&&(Vt=!0,he=h.values(f,p,_,m),le=new Map,new Set(he).forEach(Rt=>{Rt!=null&&le.set(Rt,new Path2D)}),se>0&&(ne=d.values(f,p,_,m),Ye=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&Ye.set(Rt,new Path2D)})));let{x0:Ve,size:cn}=c;if(Ve!=null&&cn!=null){k=1,x=Ve.values(f,p,_,m),Ve.unit==2&&(x=x.map(re=>f.posToVal(w+re*L,v.key,!0)));let Rt=cn.values(f,p,_,m);cn.unit==2?St=Rt[0]*L:St=E(Rt[0],v,L,w)-E(0,v,L,w),Ht=Tx(x,b,E,v,L,w,Ht),Mt=Ht-St+D}else Ht=Tx(x,b,E,v,L,w,Ht),Mt=Ht*o+D,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(N=Ux);let Ne=Mt>0,An=Ht-Mt-(Ne?se:0);St=N(Ef(An,X,V)),gt=(k==0?St/2:k==Z?0:St)-k*Z*((k==0?D/2:0)+(Ne?se/2:0));let ye={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Vt?null:new Path2D,Je=null;if(ft!=null)Je=f.data[ft.series[1]];else{let{y0:Rt,y1:Yt}=c;Rt!=null&&Yt!=null&&(b=Yt.values(f,p,_,m),Je=Rt.values(f,p,_,m))}let un=W*St,z=ot*St;for(let Rt=Z==1?_:m;Rt>=_&&Rt<=m;Rt+=Z){let Yt=b[Rt];if(Yt==null)continue;if(Je!=null){let q=Je[Rt]??0;if(Yt-q==0)continue;ht=y(q,A,P,I)}let re=v.distr!=2||c!=null?x[Rt]:Rt,wt=E(re,v,L,w),Fe=y(Se(Yt,tt),A,P,I),zt=N(wt-gt),$t=N(Jn(Fe,ht)),O=N(Fi(Fe,ht)),T=$t-O;if(Yt!=null){let q=Yt<0?z:un,ut=Yt<0?un:z;Vt?(se>0&&ne[Rt]!=null&&Q(Ye.get(ne[Rt]),zt,O+mi(se/2),St,Jn(0,T-se),q,ut),he[Rt]!=null&&Q(le.get(he[Rt]),zt,O+mi(se/2),St,Jn(0,T-se),q,ut)):Q(xn,zt,O+mi(se/2),St,Jn(0,T-se),q,ut),it(f,p,Rt,zt-se/2,O,St+se,T)}}return se>0?ye.stroke=Vt?Ye:xn:Vt||(ye._fill=g.width==0?g._fill:g._stroke??g._fill,ye.width=0),ye.fill=Vt?le:xn,ye})}function QC(n,t){let e=Se(t?.alignGaps,0);return(i,s,r,o)=>Rr(i,s,(a,l,c,u,h,d,f,p,_,m,g)=>{[r,o]=Uu(c,r,o);let x=a.pxRound,b=W=>x(d(W,u,m,p)),v=W=>x(f(W,h,g,_)),A,E,y;u.ori==0?(A=Vu,y=Bo,E=c_):(A=Gu,y=zo,E=u_);let w=u.dir*(u.ori==0?1:-1),I=b(l[w==1?r:o]),L=I,P=[],N=[];for(let W=w==1?r:o;W>=r&&W<=o;W+=w)if(c[W]!=null){let Z=l[W],Q=b(Z);P.push(L=Q),N.push(v(c[W]))}let k={stroke:n(P,N,A,y,E,x),fill:null,clip:null,band:null,gaps:null,flags:Fo},D=k.stroke,[V,X]=Hf(i,s);if(a.fill!=null||V!=0){let W=k.fill=new Path2D(D),ot=a.fillTo(i,s,a.min,a.max,V),Z=v(ot);y(W,L,Z),y(W,I,Z)}if(!a.spanGaps){let W=[];W.push(...Wf(l,c,r,o,w,b,e)),k.gaps=W=a.gaps(i,s,r,o,W),k.clip=zu(W,u.ori,p,_,m,g)}return X!=0&&(k.band=X==2?[Ts(i,s,r,o,D,-1),Ts(i,s,r,o,D,1)]:Ts(i,s,r,o,D,X)),k})}function tR(n){return QC(eR,n)}function eR(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=t[d+1]-t[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,n[d]+h[d]/3,t[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,t[d+1]-l[d+1]*h[d]/3,n[d+1],t[d+1])}return a}var Pf=new Set;function Cx(){for(let n of Pf)n.syncRect(!0)}ko&&(Tr(OT,No,Cx),Tr(UT,No,Cx,!0),Tr(Nu,No,()=>{ln.pxRatio=Ae}));var nR=f_(),iR=h_();function Rx(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>If(r,o,t,e))}function sR(n,t){return n.map((e,i)=>i==0?{}:gn({},t,e))}function If(n,t,e,i){return gn({},t==0?e:i,n)}function p_(n,t,e){return t==null?Oo:[t,e]}var rR=p_;function oR(n,t,e){return t==null?Oo:Du(t,e,Uf,!0)}function m_(n,t,e,i){return t==null?Oo:Fu(t,e,n.scales[i].log,!1)}var aR=m_;function g_(n,t,e,i){return t==null?Oo:Of(t,e,n.scales[i].log,!1)}var lR=g_;function cR(n,t,e,i,s){let r=Jn(ax(n),ax(t)),o=t-n,a=Ui(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?ir.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Px(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Mn((e=+s)*Ae))+"px"),[n,t,e]}function uR(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=ze(t[2]*Ae,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function ln(n,t,e){let i={mode:Se(n.mode,1)},s=i.mode;function r(M,C,U,F){let $=C.valToPct(M);return F+U*(C.dir==-1?1-$:$)}function o(M,C,U,F){let $=C.valToPct(M);return F+U*(C.dir==-1?$:1-$)}function a(M,C,U,F){return C.ori==0?r(M,C,U,F):o(M,C,U,F)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Mi(xT);if(n.id!=null&&(c.id=n.id),pi(c,n.class),n.title){let M=Mi(vT,c);M.textContent=n.title}let u=Oi("canvas"),h=i.ctx=u.getContext("2d"),d=Mi(bT,c);Tr("click",d,M=>{M.target===p&&(He!=Fr||Ze!=kr)&&Ln.click(i,M)},!0);let f=i.under=Mi(ST,d);d.appendChild(u);let p=i.over=Mi(MT,d);n=Uo(n);let _=+Se(n.pxAlign,1),m=Ex(_);(n.plugins||[]).forEach(M=>{M.opts&&(n=M.opts(i,n)||n)});let g=n.ms||.001,x=i.series=s==1?Rx(n.series||[],yx,wx,!1):sR(n.series||[null],Mx),b=i.axes=Rx(n.axes||[],_x,bx,!0),v=i.scales={},A=i.bands=n.bands||[];A.forEach(M=>{M.fill=_e(M.fill||null),M.dir=Se(M.dir,-1)});let E=s==2?x[1].facets[0].scale:x[0].scale,y={axes:os,series:fe},w=(n.drawOrder||["axes","series"]).map(M=>y[M]);function I(M){let C=M.distr==3?U=>Es(U>0?U:M.clamp(i,U,M.min,M.max,M.key)):M.distr==4?U=>_f(U,M.asinh):M.distr==100?U=>M.fwd(U):U=>U;return U=>{let F=C(U),{_min:$,_max:J}=M,lt=J-$;return(F-$)/lt}}function L(M){let C=v[M];if(C==null){let U=(n.scales||rl)[M]||rl;if(U.from!=null){L(U.from);let F=gn({},v[U.from],U,{key:M});F.valToPct=I(F),v[M]=F}else{C=v[M]=gn({},M==E?s_:XC,U),C.key=M;let F=C.time,$=C.range,J=nr($);if((M!=E||s==2&&!F)&&(J&&($[0]==null||$[1]==null)&&($={min:$[0]==null?sx:{mode:1,hard:$[0],soft:$[0]},max:$[1]==null?sx:{mode:1,hard:$[1],soft:$[1]}},J=!1),!J&&Bu($))){let lt=$;$=(pt,vt,Nt)=>vt==null?Oo:Du(vt,Nt,lt)}C.range=_e($||(F?rR:M==E?C.distr==3?aR:C.distr==4?lR:p_:C.distr==3?m_:C.distr==4?g_:oR)),C.auto=_e(J?!1:C.auto),C.clamp=_e(C.clamp||$C),C._min=C._max=null,C.valToPct=I(C)}}}L("x"),L("y"),s==1&&x.forEach(M=>{L(M.scale)}),b.forEach(M=>{L(M.scale)});for(let M in n.scales)L(M);let P=v[E],N=P.distr,k,D;P.ori==0?(pi(c,_T),k=r,D=o):(pi(c,yT),k=o,D=r);let V={};for(let M in v){let C=v[M];(C.min!=null||C.max!=null)&&(V[M]={min:C.min,max:C.max},C.min=C.max=null)}let X=n.tzDate||(M=>new Date(Mn(M/g))),W=n.fmtDate||Bf,ot=g==1?_C(X):bC(X),Z=mx(X,px(g==1?xC:vC,W)),Q=xx(X,gx(MC,W)),it=[],ft=i.legend=gn({},EC,n.legend),dt=i.cursor=gn({},LC,{drag:{y:s==2}},n.cursor),tt=ft.show,ht=dt.show,gt=ft.markers;ft.idxs=it,gt.width=_e(gt.width),gt.dash=_e(gt.dash),gt.stroke=_e(gt.stroke),gt.fill=_e(gt.fill);let St,Mt,Ht,se=[],Vt=[],he,le=!1,ne={};if(ft.live){let M=x[1]?x[1].values:null;le=M!=null,he=le?M(i,1,0):{_:0};for(let C in he)ne[C]=Nf}if(tt)if(St=Oi("table",RT,c),Ht=Oi("tbody",null,St),ft.mount(i,St),le){Mt=Oi("thead",null,St,Ht);let M=Oi("tr",null,Mt);Oi("th",null,M);for(var Ye in he)Oi("th",$0,M).textContent=Ye}else pi(St,IT),ft.live&&pi(St,PT);let Ve={show:!0},cn={show:!1};function Ne(M,C){if(C==0&&(le||!ft.live||s==2))return Oo;let U=[],F=Oi("tr",LT,Ht,Ht.childNodes[C]);pi(F,M.class),M.show||pi(F,Er);let $=Oi("th",null,F);if(gt.show){let pt=Mi(NT,$);if(C>0){let vt=gt.width(i,C);vt&&(pt.style.border=vt+"px "+gt.dash(i,C)+" "+gt.stroke(i,C)),pt.style.background=gt.fill(i,C)}}let J=Mi($0,$);M.label instanceof HTMLElement?J.appendChild(M.label):J.textContent=M.label,C>0&&(gt.show||(J.style.color=M.width>0?gt.stroke(i,C):gt.fill(i,C)),ye("click",$,pt=>{if(dt._lock)return;Jt(pt);let vt=x.indexOf(M);if((pt.ctrlKey||pt.metaKey)!=ft.isolate){let Nt=x.some((Dt,Ut)=>Ut>0&&Ut!=vt&&Dt.show);x.forEach((Dt,Ut)=>{Ut>0&&Vi(Ut,Nt?Ut==vt?Ve:cn:Ve,!0,pn.setSeries)})}else Vi(vt,{show:!M.show},!0,pn.setSeries)},!1),jt&&ye(Z0,$,pt=>{dt._lock||(Jt(pt),Vi(x.indexOf(M),zr,!0,pn.setSeries))},!1));for(var lt in he){let pt=Oi("td",DT,F);pt.textContent="--",U.push(pt)}return[F,U]}let An=new Map;function ye(M,C,U,F=!0){let $=An.get(C)||{},J=dt.bind[M](i,C,U,F);J&&(Tr(M,C,$[M]=J),An.set(C,$))}function xn(M,C,U){let F=An.get(C)||{};for(let $ in F)(M==null||$==M)&&(Af($,C,F[$]),delete F[$]);M==null&&An.delete(C)}let Je=0,un=0,z=0,Rt=0,Yt=0,re=0,wt=Yt,Fe=re,zt=z,$t=Rt,O=0,T=0,q=0,ut=0;i.bbox={};let at=!1,_t=!1,yt=!1,et=!1,st=!1,mt=!1;function B(M,C,U){(U||M!=i.width||C!=i.height)&&rt(M,C),ce(!1),yt=!0,_t=!0,On()}function rt(M,C){i.width=Je=z=M,i.height=un=Rt=C,Yt=re=0,bt(),Gt();let U=i.bbox;O=U.left=wr(Yt*Ae,.5),T=U.top=wr(re*Ae,.5),q=U.width=wr(z*Ae,.5),ut=U.height=wr(Rt*Ae,.5)}let nt=3;function At(){let M=!1,C=0;for(;!M;){C++;let U=Dr(C),F=zi(C);M=C==nt||U&&F,M||(rt(i.width,i.height),_t=!0)}}function xt({width:M,height:C}){B(M,C)}i.setSize=xt;function bt(){let M=!1,C=!1,U=!1,F=!1;b.forEach(($,J)=>{if($.show&&$._show){let{side:lt,_size:pt}=$,vt=lt%2,Nt=$.label!=null?$.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(z-=Dt,lt==3?(Yt+=Dt,F=!0):U=!0):(Rt-=Dt,lt==0?(re+=Dt,M=!0):C=!0))}}),ki[0]=M,ki[1]=U,ki[2]=C,ki[3]=F,z-=Ai[1]+Ai[3],Yt+=Ai[3],Rt-=Ai[2]+Ai[0],re+=Ai[0]}function Gt(){let M=Yt+z,C=re+Rt,U=Yt,F=re;function $(J,lt){switch(J){case 1:return M+=lt,M-lt;case 2:return C+=lt,C-lt;case 3:return U-=lt,U+lt;case 0:return F-=lt,F+lt}}b.forEach((J,lt)=>{if(J.show&&J._show){let pt=J.side;J._pos=$(pt,J._size),J.label!=null&&(J._lpos=$(pt,J.labelSize))}})}if(dt.dataIdx==null){let M=dt.hover,C=M.skip=new Set(M.skip??[]);C.add(void 0);let U=M.prox=_e(M.prox),F=M.bias??=0;dt.dataIdx=($,J,lt,pt)=>{if(J==0)return lt;let vt=lt,Nt=U($,J,lt,pt)??Be,Dt=Nt>=0&&Nt<Be,Ut=P.ori==0?z:Rt,ie=dt.left,Me=t[0],ve=t[J];if(C.has(ve[lt])){vt=null;let me=null,Kt=null,Wt;if(F==0||F==-1)for(Wt=lt;me==null&&Wt-- >0;)C.has(ve[Wt])||(me=Wt);if(F==0||F==1)for(Wt=lt;Kt==null&&Wt++<ve.length;)C.has(ve[Wt])||(Kt=Wt);if(me!=null||Kt!=null)if(Dt){let $e=me==null?-1/0:k(Me[me],P,Ut,0),tn=Kt==null?1/0:k(Me[Kt],P,Ut,0),Rn=ie-$e,De=tn-ie;Rn<=De?Rn<=Nt&&(vt=me):De<=Nt&&(vt=Kt)}else vt=Kt==null?me:me==null?Kt:lt-me<=Kt-lt?me:Kt}else Dt&&wn(ie-k(Me[lt],P,Ut,0))>Nt&&(vt=null);return vt}}let Jt=M=>{dt.event=M};dt.idxs=it,dt._lock=!1;let ct=dt.points;ct.show=_e(ct.show),ct.size=_e(ct.size),ct.stroke=_e(ct.stroke),ct.width=_e(ct.width),ct.fill=_e(ct.fill);let Ft=i.focus=gn({},n.focus||{alpha:.3},dt.focus),jt=Ft.prox>=0,Ct=jt&&ct.one,oe=[],Ge=[],Vn=[];function $o(M,C){let U=ct.show(i,C);if(U instanceof HTMLElement)return pi(U,CT),pi(U,M.class),es(U,-10,-10,z,Rt),p.insertBefore(U,oe[C]),U}function Ir(M,C){if(s==1||C>0){let U=s==1&&v[M.scale].time,F=M.value;M.value=U?ux(F)?xx(X,gx(F,W)):F||Q:F||GC,M.label=M.label||(U?DC:NC)}if(Ct||C>0){M.width=M.width==null?1:M.width,M.paths=M.paths||nR||XT,M.fillTo=_e(M.fillTo||qC),M.pxAlign=+Se(M.pxAlign,_),M.pxRound=Ex(M.pxAlign),M.stroke=_e(M.stroke||null),M.fill=_e(M.fill||null),M._stroke=M._fill=M._paths=M._focus=null;let U=HC(Jn(1,M.width),1),F=M.points=gn({},{size:U,width:Jn(1,U*.2),stroke:M.stroke,space:U*2,paths:iR,_stroke:null,_fill:null},M.points);F.show=_e(F.show),F.filter=_e(F.filter),F.fill=_e(F.fill),F.stroke=_e(F.stroke),F.paths=_e(F.paths),F.pxAlign=M.pxAlign}if(tt){let U=Ne(M,C);se.splice(C,0,U[0]),Vt.splice(C,0,U[1]),ft.values.push(null)}if(ht){it.splice(C,0,null);let U=null;Ct?C==0&&(U=$o(M,C)):C>0&&(U=$o(M,C)),oe.splice(C,0,U),Ge.splice(C,0,0),Vn.splice(C,0,0)}Cn("addSeries",C)}function hh(M,C){C=C??x.length,M=s==1?If(M,C,yx,wx):If(M,C,{},Mx),x.splice(C,0,M),Ir(x[C],C)}i.addSeries=hh;function cl(M){if(x.splice(M,1),tt){ft.values.splice(M,1),Vt.splice(M,1);let C=se.splice(M,1)[0];xn(null,C.firstChild),C.remove()}ht&&(it.splice(M,1),oe.splice(M,1)[0].remove(),Ge.splice(M,1),Vn.splice(M,1)),Cn("delSeries",M)}i.delSeries=cl;let ki=[!1,!1,!1,!1];function is(M,C){if(M._show=M.show,M.show){let U=M.side%2,F=v[M.scale];F==null&&(M.scale=U?x[1].scale:E,F=v[M.scale]);let $=F.time;M.size=_e(M.size),M.space=_e(M.space),M.rotate=_e(M.rotate),nr(M.incrs)&&M.incrs.forEach(lt=>{!ir.has(lt)&&ir.set(lt,Bx(lt))}),M.incrs=_e(M.incrs||(F.distr==2?pC:$?g==1?gC:yC:Ar)),M.splits=_e(M.splits||($&&F.distr==1?ot:F.distr==3?Tf:F.distr==4?FC:UC)),M.stroke=_e(M.stroke),M.grid.stroke=_e(M.grid.stroke),M.ticks.stroke=_e(M.ticks.stroke),M.border.stroke=_e(M.border.stroke);let J=M.values;M.values=nr(J)&&!nr(J[0])?_e(J):$?nr(J)?mx(X,px(J,W)):ux(J)?SC(X,J):J||Z:J||OC,M.filter=_e(M.filter||(F.distr>=3&&F.log==10?zC:F.distr==3&&F.log==2?VC:Fx)),M.font=Px(M.font),M.labelFont=Px(M.labelFont),M._size=M.size(i,null,C,0),M._space=M._rotate=M._incrs=M._found=M._splits=M._values=null,M._size>0&&(ki[C]=!0,M._el=Mi(wT,d))}}function ss(M,C,U,F){let[$,J,lt,pt]=U,vt=C%2,Nt=0;return vt==0&&(pt||J)&&(Nt=C==0&&!$||C==2&&!lt?Mn(_x.size/3):0),vt==1&&($||lt)&&(Nt=C==1&&!J||C==3&&!pt?Mn(bx.size/2):0),Nt}let Xo=i.padding=(n.padding||[ss,ss,ss,ss]).map(M=>_e(Se(M,ss))),Ai=i._padding=Xo.map((M,C)=>M(i,C,ki,0)),je,rn=null,on=null,Bi=s==1?x[0].idxs:null,ni=null,Rs=!1;function qo(M,C){if(t=M??[],i.data=i._data=t,s==2){je=0;for(let U=1;U<x.length;U++)je+=t[U][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ni=t[0],je=ni.length;let U=t;if(N==2){U=t.slice();let F=U[0]=Array(je);for(let $=0;$<je;$++)F[$]=$}i._data=t=U}if(ce(!0),Cn("setData"),N==2&&(yt=!0),C!==!1){let U=P;U.auto(i,Rs)?Yo():Ls(E,U.min,U.max),et=et||dt.left>=0,mt=!0,On()}}i.setData=qo;function Yo(){Rs=!0;let M,C;s==1&&(je>0?(rn=Bi[0]=0,on=Bi[1]=je-1,M=t[0][rn],C=t[0][on],N==2?(M=rn,C=on):M==C&&(N==3?[M,C]=Fu(M,M,P.log,!1):N==4?[M,C]=Of(M,M,P.log,!1):P.time?C=M+Mn(86400/g):[M,C]=Du(M,C,Uf,!0))):(rn=Bi[0]=M=null,on=Bi[1]=C=null)),Ls(E,M,C)}let Lr,Ps,Nr,R,H,j,Y,K,Et,Pt;function Tt(M,C,U,F,$,J){M??=q0,U??=kf,F??="butt",$??=q0,J??="round",M!=Lr&&(h.strokeStyle=Lr=M),$!=Ps&&(h.fillStyle=Ps=$),C!=Nr&&(h.lineWidth=Nr=C),J!=H&&(h.lineJoin=H=J),F!=j&&(h.lineCap=j=F),U!=R&&h.setLineDash(R=U)}function It(M,C,U,F){C!=Ps&&(h.fillStyle=Ps=C),M!=Y&&(h.font=Y=M),U!=K&&(h.textAlign=K=U),F!=Et&&(h.textBaseline=Et=F)}function Bt(M,C,U,F,$=0){if(F.length>0&&M.auto(i,Rs)&&(C==null||C.min==null)){let J=Se(rn,0),lt=Se(on,F.length-1),pt=U.min==null?zT(F,J,lt,$,M.distr==3):[U.min,U.max];M.min=Fi(M.min,U.min=pt[0]),M.max=Jn(M.max,U.max=pt[1])}}let ee={min:null,max:null};function de(){for(let F in v){let $=v[F];V[F]==null&&($.min==null||V[E]!=null&&$.auto(i,Rs))&&(V[F]=ee)}for(let F in v){let $=v[F];V[F]==null&&$.from!=null&&V[$.from]!=null&&(V[F]=ee)}V[E]!=null&&ce(!0);let M={};for(let F in V){let $=V[F];if($!=null){let J=M[F]=Uo(v[F],ZT);if($.min!=null)gn(J,$);else if(F!=E||s==2)if(je==0&&J.from==null){let lt=J.range(i,null,null,F);J.min=lt[0],J.max=lt[1]}else J.min=Be,J.max=-Be}}if(je>0){x.forEach((F,$)=>{if(s==1){let J=F.scale,lt=V[J];if(lt==null)return;let pt=M[J];if($==0){let vt=pt.range(i,pt.min,pt.max,J);pt.min=vt[0],pt.max=vt[1],rn=Ui(pt.min,t[0]),on=Ui(pt.max,t[0]),on-rn>1&&(t[0][rn]<pt.min&&rn++,t[0][on]>pt.max&&on--),F.min=ni[rn],F.max=ni[on]}else F.show&&F.auto&&Bt(pt,lt,F,t[$],F.sorted);F.idxs[0]=rn,F.idxs[1]=on}else if($>0&&F.show&&F.auto){let[J,lt]=F.facets,pt=J.scale,vt=lt.scale,[Nt,Dt]=t[$],Ut=M[pt],ie=M[vt];Ut!=null&&Bt(Ut,V[pt],J,Nt,J.sorted),ie!=null&&Bt(ie,V[vt],lt,Dt,lt.sorted),F.min=lt.min,F.max=lt.max}});for(let F in M){let $=M[F],J=V[F];if($.from==null&&(J==null||J.min==null)){let lt=$.range(i,$.min==Be?null:$.min,$.max==-Be?null:$.max,F);$.min=lt[0],$.max=lt[1]}}}for(let F in M){let $=M[F];if($.from!=null){let J=M[$.from];if(J.min==null)$.min=$.max=null;else{let lt=$.range(i,J.min,J.max,F);$.min=lt[0],$.max=lt[1]}}}let C={},U=!1;for(let F in M){let $=M[F],J=v[F];if(J.min!=$.min||J.max!=$.max){J.min=$.min,J.max=$.max;let lt=J.distr;J._min=lt==3?Es(J.min):lt==4?_f(J.min,J.asinh):lt==100?J.fwd(J.min):J.min,J._max=lt==3?Es(J.max):lt==4?_f(J.max,J.asinh):lt==100?J.fwd(J.max):J.max,C[F]=U=!0}}if(U){x.forEach((F,$)=>{s==2?$>0&&C.y&&(F._paths=null):C[F.scale]&&(F._paths=null)});for(let F in C)yt=!0,Cn("setScale",F);ht&&dt.left>=0&&(et=mt=!0)}for(let F in V)V[F]=null}function kt(M){let C=Ef(rn-1,0,je-1),U=Ef(on+1,0,je-1);for(;M[C]==null&&C>0;)C--;for(;M[U]==null&&U<je-1;)U++;return[C,U]}function fe(){if(je>0){let M=x.some(C=>C._focus)&&Pt!=Ft.alpha;M&&(h.globalAlpha=Pt=Ft.alpha),x.forEach((C,U)=>{if(U>0&&C.show&&(Ke(U,!1),Ke(U,!0),C._paths==null)){let F=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha);let $=s==2?[0,t[U][0].length-1]:kt(t[U]);C._paths=C.paths(i,U,$[0],$[1]),Pt!=F&&(h.globalAlpha=Pt=F)}}),x.forEach((C,U)=>{if(U>0&&C.show){let F=Pt;Pt!=C.alpha&&(h.globalAlpha=Pt=C.alpha),C._paths!=null&&Re(U,!1);{let $=C._paths!=null?C._paths.gaps:null,J=C.points.show(i,U,rn,on,$),lt=C.points.filter(i,U,J,$);(J||lt)&&(C.points._paths=C.points.paths(i,U,rn,on,lt),Re(U,!0))}Pt!=F&&(h.globalAlpha=Pt=F),Cn("drawSeries",U)}}),M&&(h.globalAlpha=Pt=1)}}function Ke(M,C){let U=C?x[M].points:x[M];U._stroke=U.stroke(i,M),U._fill=U.fill(i,M)}function Re(M,C){let U=C?x[M].points:x[M],{stroke:F,fill:$,clip:J,flags:lt,_stroke:pt=U._stroke,_fill:vt=U._fill,_width:Nt=U.width}=U._paths;Nt=ze(Nt*Ae,3);let Dt=null,Ut=Nt%2/2;C&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=U.pxAlign==1&&Ut>0;if(ie&&h.translate(Ut,Ut),!C){let Me=O-Nt/2,ve=T-Nt/2,me=q+Nt,Kt=ut+Nt;Dt=new Path2D,Dt.rect(Me,ve,me,Kt)}C?Ot(pt,Nt,U.dash,U.cap,vt,F,$,lt,J):Pe(M,pt,Nt,U.dash,U.cap,vt,F,$,lt,Dt,J),ie&&h.translate(-Ut,-Ut)}function Pe(M,C,U,F,$,J,lt,pt,vt,Nt,Dt){let Ut=!1;vt!=0&&A.forEach((ie,Me)=>{if(ie.series[0]==M){let ve=x[ie.series[1]],me=t[ie.series[1]],Kt=(ve._paths||rl).band;nr(Kt)&&(Kt=ie.dir==1?Kt[0]:Kt[1]);let Wt,$e=null;ve.show&&Kt&&GT(me,rn,on)?($e=ie.fill(i,Me)||J,Wt=ve._paths.clip):Kt=null,Ot(C,U,F,$,$e,lt,pt,vt,Nt,Dt,Wt,Kt),Ut=!0}}),Ut||Ot(C,U,F,$,J,lt,pt,vt,Nt,Dt)}let _n=Fo|Rf;function Ot(M,C,U,F,$,J,lt,pt,vt,Nt,Dt,Ut){Tt(M,C,U,F,$),(vt||Nt||Ut)&&(h.save(),vt&&h.clip(vt),Nt&&h.clip(Nt)),Ut?(pt&_n)==_n?(h.clip(Ut),Dt&&h.clip(Dt),ge($,lt),hn(M,J,C)):pt&Rf?(ge($,lt),h.clip(Ut),hn(M,J,C)):pt&Fo&&(h.save(),h.clip(Ut),Dt&&h.clip(Dt),ge($,lt),h.restore(),hn(M,J,C)):(ge($,lt),hn(M,J,C)),(vt||Nt||Ut)&&h.restore()}function hn(M,C,U){U>0&&(C instanceof Map?C.forEach((F,$)=>{h.strokeStyle=Lr=$,h.stroke(F)}):C!=null&&M&&h.stroke(C))}function ge(M,C){C instanceof Map?C.forEach((U,F)=>{h.fillStyle=Ps=F,h.fill(U)}):C!=null&&M&&h.fill(C)}function rs(M,C,U,F){let $=b[M],J;if(F<=0)J=[0,0];else{let lt=$._space=$.space(i,M,C,U,F),pt=$._incrs=$.incrs(i,M,C,U,F,lt);J=cR(C,U,pt,F,lt)}return $._found=J}function dn(M,C,U,F,$,J,lt,pt,vt,Nt){let Dt=lt%2/2;_==1&&h.translate(Dt,Dt),Tt(pt,lt,vt,Nt,pt),h.beginPath();let Ut,ie,Me,ve,me=$+(F==0||F==3?-J:J);U==0?(ie=$,ve=me):(Ut=$,Me=me);for(let Kt=0;Kt<M.length;Kt++)C[Kt]!=null&&(U==0?Ut=Me=M[Kt]:ie=ve=M[Kt],h.moveTo(Ut,ie),h.lineTo(Me,ve));h.stroke(),_==1&&h.translate(-Dt,-Dt)}function Dr(M){let C=!0;return b.forEach((U,F)=>{if(!U.show)return;let $=v[U.scale];if($.min==null){U._show&&(C=!1,U._show=!1,ce(!1));return}else U._show||(C=!1,U._show=!0,ce(!1));let J=U.side,lt=J%2,{min:pt,max:vt}=$,[Nt,Dt]=rs(F,pt,vt,lt==0?z:Rt);if(Dt==0)return;let Ut=$.distr==2,ie=U._splits=U.splits(i,F,pt,vt,Nt,Dt,Ut),Me=$.distr==2?ie.map(Wt=>ni[Wt]):ie,ve=$.distr==2?ni[ie[1]]-ni[ie[0]]:Nt,me=U._values=U.values(i,U.filter(i,Me,F,Dt,ve),F,Dt,ve);U._rotate=J==2?U.rotate(i,me,F,Dt):0;let Kt=U._size;U._size=wi(U.size(i,me,F,M)),Kt!=null&&U._size!=Kt&&(C=!1)}),C}function zi(M){let C=!0;return Xo.forEach((U,F)=>{let $=U(i,F,ki,M);$!=Ai[F]&&(C=!1),Ai[F]=$}),C}function os(){for(let M=0;M<b.length;M++){let C=b[M];if(!C.show||!C._show)continue;let U=C.side,F=U%2,$,J,lt=C.stroke(i,M),pt=U==0||U==3?-1:1,[vt,Nt]=C._found;if(C.label!=null){let Wn=C.labelGap*pt,ri=Mn((C._lpos+Wn)*Ae);It(C.labelFont[0],lt,"center",U==2?"top":X0),h.save(),F==1?($=J=0,h.translate(ri,Mn(T+ut/2)),h.rotate((U==3?-Lu:Lu)/2)):($=Mn(O+q/2),J=ri);let ar=Ox(C.label)?C.label(i,M,vt,Nt):C.label;h.fillText(ar,$,J),h.restore()}if(Nt==0)continue;let Dt=v[C.scale],Ut=F==0?q:ut,ie=F==0?O:T,Me=C._splits,ve=Dt.distr==2?Me.map(Wn=>ni[Wn]):Me,me=Dt.distr==2?ni[Me[1]]-ni[Me[0]]:vt,Kt=C.ticks,Wt=C.border,$e=Kt.show?Kt.size:0,tn=Mn($e*Ae),Rn=Mn((C.alignTo==2?C._size-$e-C.gap:C.gap)*Ae),De=C._rotate*-Lu/180,en=m(C._pos*Ae),ii=(tn+Rn)*pt,Hn=en+ii;J=F==0?Hn:0,$=F==1?Hn:0;let xi=C.font[0],Ei=C.align==1?Io:C.align==2?mf:De>0?Io:De<0?mf:F==0?"center":U==3?mf:Io,Hi=De||F==1?"middle":U==2?"top":X0;It(xi,lt,Ei,Hi);let si=C.font[1]*C.lineGap,_i=Me.map(Wn=>m(a(Wn,Dt,Ut,ie))),Ti=C._values;for(let Wn=0;Wn<Ti.length;Wn++){let ri=Ti[Wn];if(ri!=null){F==0?$=_i[Wn]:J=_i[Wn],ri=""+ri;let ar=ri.indexOf(`
`)==-1?[ri]:ri.split(/\n/gm);for(let $n=0;$n<ar.length;$n++){let Ip=ar[$n];De?(h.save(),h.translate($,J+$n*si),h.rotate(De),h.fillText(Ip,0,0),h.restore()):h.fillText(Ip,$,J+$n*si)}}}Kt.show&&dn(_i,Kt.filter(i,ve,M,Nt,me),F,U,en,tn,ze(Kt.width*Ae,3),Kt.stroke(i,M),Kt.dash,Kt.cap);let Wi=C.grid;Wi.show&&dn(_i,Wi.filter(i,ve,M,Nt,me),F,F==0?2:1,F==0?T:O,F==0?ut:q,ze(Wi.width*Ae,3),Wi.stroke(i,M),Wi.dash,Wi.cap),Wt.show&&dn([en],[1],F==0?1:0,F==0?1:2,F==1?T:O,F==1?ut:q,ze(Wt.width*Ae,3),Wt.stroke(i,M),Wt.dash,Wt.cap)}Cn("drawAxes")}function ce(M){x.forEach((C,U)=>{U>0&&(C._paths=null,M&&(s==1?(C.min=null,C.max=null):C.facets.forEach(F=>{F.min=null,F.max=null})))})}let Qe=!1,Gn=!1,Ie=[];function fn(){Gn=!1;for(let M=0;M<Ie.length;M++)Cn(...Ie[M]);Ie.length=0}function On(){Qe||(nC(fp),Qe=!0)}function ul(M,C=!1){Qe=!0,Gn=C,M(i),fp(),C&&Ie.length>0&&queueMicrotask(fn)}i.batch=ul;function fp(){if(at&&(de(),at=!1),yt&&(At(),yt=!1),_t){if(qe(f,Io,Yt),qe(f,"top",re),qe(f,el,z),qe(f,nl,Rt),qe(p,Io,Yt),qe(p,"top",re),qe(p,el,z),qe(p,nl,Rt),qe(d,el,Je),qe(d,nl,un),u.width=Mn(Je*Ae),u.height=Mn(un*Ae),b.forEach(({_el:M,_show:C,_size:U,_pos:F,side:$})=>{if(M!=null)if(C){let J=$===3||$===0?U:0,lt=$%2==1;qe(M,lt?"left":"top",F-J),qe(M,lt?"width":"height",U),qe(M,lt?"top":"left",lt?re:Yt),qe(M,lt?"height":"width",lt?Rt:z),wf(M,Er)}else pi(M,Er)}),Lr=Ps=Nr=H=j=Y=K=Et=R=null,Pt=1,Jo(!0),Yt!=wt||re!=Fe||z!=zt||Rt!=$t){ce(!1);let M=z/zt,C=Rt/$t;if(ht&&!et&&dt.left>=0){dt.left*=M,dt.top*=C,Or&&es(Or,Mn(dt.left),0,z,Rt),Ur&&es(Ur,0,Mn(dt.top),z,Rt);for(let U=0;U<oe.length;U++){let F=oe[U];F!=null&&(Ge[U]*=M,Vn[U]*=C,es(F,wi(Ge[U]),wi(Vn[U]),z,Rt))}}if(We.show&&!st&&We.left>=0&&We.width>0){We.left*=M,We.width*=M,We.top*=C,We.height*=C;for(let U in xh)qe(Br,U,We[U])}wt=Yt,Fe=re,zt=z,$t=Rt}Cn("setSize"),_t=!1}Je>0&&un>0&&(h.clearRect(0,0,u.width,u.height),Cn("drawClear"),w.forEach(M=>M()),Cn("draw")),We.show&&st&&(hl(We),st=!1),ht&&et&&(or(null,!0,!1),et=!1),ft.show&&ft.live&&mt&&(mh(),mt=!1),l||(l=!0,i.status=1,Cn("ready")),Rs=!1,Qe=!1}i.redraw=(M,C)=>{yt=C||!1,M!==!1?Ls(E,P.min,P.max):On()};function dh(M,C){let U=v[M];if(U.from==null){if(je==0){let F=U.range(i,C.min,C.max,M);C.min=F[0],C.max=F[1]}if(C.min>C.max){let F=C.min;C.min=C.max,C.max=F}if(je>1&&C.min!=null&&C.max!=null&&C.max-C.min<1e-16)return;M==E&&U.distr==2&&je>0&&(C.min=Ui(C.min,t[0]),C.max=Ui(C.max,t[0]),C.min==C.max&&C.max++),V[M]=C,at=!0,On()}}i.setScale=dh;let fh,ph,Or,Ur,pp,mp,Fr,kr,gp,xp,He,Ze,Is=!1,Ln=dt.drag,En=Ln.x,Tn=Ln.y;ht&&(dt.x&&(fh=Mi(ET,p)),dt.y&&(ph=Mi(TT,p)),P.ori==0?(Or=fh,Ur=ph):(Or=ph,Ur=fh),He=dt.left,Ze=dt.top);let We=i.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Br=We.show?Mi(AT,We.over?p:f):null;function hl(M,C){if(We.show){for(let U in M)We[U]=M[U],U in xh&&qe(Br,U,M[U]);C!==!1&&Cn("setSelect")}}i.setSelect=hl;function nv(M){if(x[M].show)tt&&wf(se[M],Er);else if(tt&&pi(se[M],Er),ht){let U=Ct?oe[0]:oe[M];U!=null&&es(U,-10,-10,z,Rt)}}function Ls(M,C,U){dh(M,{min:C,max:U})}function Vi(M,C,U,F){C.focus!=null&&av(M),C.show!=null&&x.forEach(($,J)=>{J>0&&(M==J||M==null)&&($.show=C.show,nv(J),s==2?(Ls($.facets[0].scale,null,null),Ls($.facets[1].scale,null,null)):Ls($.scale,null,null),On())}),U!==!1&&Cn("setSeries",M,C),F&&jo("setSeries",i,M,C)}i.setSeries=Vi;function iv(M,C){gn(A[M],C)}function sv(M,C){M.fill=_e(M.fill||null),M.dir=Se(M.dir,-1),C=C??A.length,A.splice(C,0,M)}function rv(M){M==null?A.length=0:A.splice(M,1)}i.addBand=sv,i.setBand=iv,i.delBand=rv;function ov(M,C){x[M].alpha=C,ht&&oe[M]!=null&&(oe[M].style.opacity=C),tt&&se[M]&&(se[M].style.opacity=C)}let as,Ns,rr,zr={focus:!0};function av(M){if(M!=rr){let C=M==null,U=Ft.alpha!=1;x.forEach((F,$)=>{if(s==1||$>0){let J=C||$==0||$==M;F._focus=C?null:J,U&&ov($,J?1:Ft.alpha)}}),rr=M,U&&On()}}tt&&jt&&ye(K0,St,M=>{dt._lock||(Jt(M),rr!=null&&Vi(null,zr,!0,pn.setSeries))});function Gi(M,C,U){let F=v[C];U&&(M=M/Ae-(F.ori==1?re:Yt));let $=z;F.ori==1&&($=Rt,M=$-M),F.dir==-1&&(M=$-M);let J=F._min,lt=F._max,pt=M/$,vt=J+(lt-J)*pt,Nt=F.distr;return Nt==3?Do(10,vt):Nt==4?WT(vt,F.asinh):Nt==100?F.bwd(vt):vt}function lv(M,C){let U=Gi(M,E,C);return Ui(U,t[0],rn,on)}i.valToIdx=M=>Ui(M,t[0]),i.posToIdx=lv,i.posToVal=Gi,i.valToPos=(M,C,U)=>v[C].ori==0?r(M,v[C],U?q:z,U?O:0):o(M,v[C],U?ut:Rt,U?T:0),i.setCursor=(M,C,U)=>{He=M.left,Ze=M.top,or(null,C,U)};function _p(M,C){qe(Br,Io,We.left=M),qe(Br,el,We.width=C)}function yp(M,C){qe(Br,"top",We.top=M),qe(Br,nl,We.height=C)}let Zo=P.ori==0?_p:yp,Ko=P.ori==1?_p:yp;function cv(){if(tt&&ft.live)for(let M=s==2?1:0;M<x.length;M++){if(M==0&&le)continue;let C=ft.values[M],U=0;for(let F in C)Vt[M][U++].firstChild.nodeValue=C[F]}}function mh(M,C){if(M!=null&&(M.idxs?M.idxs.forEach((U,F)=>{it[F]=U}):YT(M.idx)||it.fill(M.idx),ft.idx=it[0]),tt&&ft.live){for(let U=0;U<x.length;U++)(U>0||s==1&&!le)&&uv(U,it[U]);cv()}mt=!1,C!==!1&&Cn("setLegend")}i.setLegend=mh;function uv(M,C){let U=x[M],F=M==0&&N==2?ni:t[M],$;le?$=U.values(i,M,C)??ne:($=U.value(i,C==null?null:F[C],M,C),$=$==null?ne:{_:$}),ft.values[M]=$}function or(M,C,U){gp=He,xp=Ze,[He,Ze]=dt.move(i,He,Ze),dt.left=He,dt.top=Ze,ht&&(Or&&es(Or,Mn(He),0,z,Rt),Ur&&es(Ur,0,Mn(Ze),z,Rt));let F,$=rn>on;as=Be,Ns=null;let J=P.ori==0?z:Rt,lt=P.ori==1?z:Rt;if(He<0||je==0||$){F=dt.idx=null;for(let pt=0;pt<x.length;pt++){let vt=oe[pt];vt!=null&&es(vt,-10,-10,z,Rt)}jt&&Vi(null,zr,!0,M==null&&pn.setSeries),ft.live&&(it.fill(F),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=P.ori==0?He:Ze,vt=Gi(pt,E),F=dt.idx=Ui(vt,t[0],rn,on),Nt=k(t[0][F],P,J,0));let Dt=-10,Ut=-10,ie=0,Me=0,ve=!0,me="",Kt="";for(let Wt=s==2?1:0;Wt<x.length;Wt++){let $e=x[Wt],tn=it[Wt],Rn=tn==null?null:s==1?t[Wt][tn]:t[Wt][1][tn],De=dt.dataIdx(i,Wt,F,vt),en=De==null?null:s==1?t[Wt][De]:t[Wt][1][De];if(mt=mt||en!=Rn||De!=tn,it[Wt]=De,Wt>0&&$e.show){let ii=De==null?-10:De==F?Nt:k(s==1?t[0][De]:t[Wt][0][De],P,J,0),Hn=en==null?-10:D(en,s==1?v[$e.scale]:v[$e.facets[1].scale],lt,0);if(jt&&en!=null){let xi=P.ori==1?He:Ze,Ei=wn(Ft.dist(i,Wt,De,Hn,xi));if(Ei<as){let Hi=Ft.bias;if(Hi!=0){let si=Gi(xi,$e.scale),_i=en>=0?1:-1,Ti=si>=0?1:-1;Ti==_i&&(Ti==1?Hi==1?en>=si:en<=si:Hi==1?en<=si:en>=si)&&(as=Ei,Ns=Wt)}else as=Ei,Ns=Wt}}if(mt||Ct){let xi,Ei;P.ori==0?(xi=ii,Ei=Hn):(xi=Hn,Ei=ii);let Hi,si,_i,Ti,Wi,Wn,ri=!0,ar=ct.bbox;if(ar!=null){ri=!1;let $n=ar(i,Wt);_i=$n.left,Ti=$n.top,Hi=$n.width,si=$n.height}else _i=xi,Ti=Ei,Hi=si=ct.size(i,Wt);if(Wn=ct.fill(i,Wt),Wi=ct.stroke(i,Wt),Ct)Wt==Ns&&as<=Ft.prox&&(Dt=_i,Ut=Ti,ie=Hi,Me=si,ve=ri,me=Wn,Kt=Wi);else{let $n=oe[Wt];$n!=null&&(Ge[Wt]=_i,Vn[Wt]=Ti,ix($n,Hi,si,ri),ex($n,Wn,Wi),es($n,wi(_i),wi(Ti),z,Rt))}}}}if(Ct){let Wt=Ft.prox,$e=rr==null?as<=Wt:as>Wt||Ns!=rr;if(mt||$e){let tn=oe[0];tn!=null&&(Ge[0]=Dt,Vn[0]=Ut,ix(tn,ie,Me,ve),ex(tn,me,Kt),es(tn,wi(Dt),wi(Ut),z,Rt))}}}if(We.show&&Is)if(M!=null){let[pt,vt]=pn.scales,[Nt,Dt]=pn.match,[Ut,ie]=M.cursor.sync.scales,Me=M.cursor.drag;if(En=Me._x,Tn=Me._y,En||Tn){let{left:ve,top:me,width:Kt,height:Wt}=M.select,$e=M.scales[Ut].ori,tn=M.posToVal,Rn,De,en,ii,Hn,xi=pt!=null&&Nt(pt,Ut),Ei=vt!=null&&Dt(vt,ie);xi&&En?($e==0?(Rn=ve,De=Kt):(Rn=me,De=Wt),en=v[pt],ii=k(tn(Rn,Ut),en,J,0),Hn=k(tn(Rn+De,Ut),en,J,0),Zo(Fi(ii,Hn),wn(Hn-ii))):Zo(0,J),Ei&&Tn?($e==1?(Rn=ve,De=Kt):(Rn=me,De=Wt),en=v[vt],ii=D(tn(Rn,ie),en,lt,0),Hn=D(tn(Rn+De,ie),en,lt,0),Ko(Fi(ii,Hn),wn(Hn-ii))):Ko(0,lt)}else _h()}else{let pt=wn(gp-pp),vt=wn(xp-mp);if(P.ori==1){let ie=pt;pt=vt,vt=ie}En=Ln.x&&pt>=Ln.dist,Tn=Ln.y&&vt>=Ln.dist;let Nt=Ln.uni;Nt!=null?En&&Tn&&(En=pt>=Nt,Tn=vt>=Nt,!En&&!Tn&&(vt>pt?Tn=!0:En=!0)):Ln.x&&Ln.y&&(En||Tn)&&(En=Tn=!0);let Dt,Ut;En&&(P.ori==0?(Dt=Fr,Ut=He):(Dt=kr,Ut=Ze),Zo(Fi(Dt,Ut),wn(Ut-Dt)),Tn||Ko(0,lt)),Tn&&(P.ori==1?(Dt=Fr,Ut=He):(Dt=kr,Ut=Ze),Ko(Fi(Dt,Ut),wn(Ut-Dt)),En||Zo(0,J)),!En&&!Tn&&(Zo(0,0),Ko(0,0))}if(Ln._x=En,Ln._y=Tn,M==null){if(U){if(Pp!=null){let[pt,vt]=pn.scales;pn.values[0]=pt!=null?Gi(P.ori==0?He:Ze,pt):null,pn.values[1]=vt!=null?Gi(P.ori==1?He:Ze,vt):null}jo(gf,i,He,Ze,z,Rt,F)}if(jt){let pt=U&&pn.setSeries,vt=Ft.prox;rr==null?as<=vt&&Vi(Ns,zr,!0,pt):as>vt?Vi(null,zr,!0,pt):Ns!=rr&&Vi(Ns,zr,!0,pt)}}mt&&(ft.idx=F,mh()),C!==!1&&Cn("setCursor")}let Ds=null;Object.defineProperty(i,"rect",{get(){return Ds==null&&Jo(!1),Ds}});function Jo(M=!1){M?Ds=null:(Ds=p.getBoundingClientRect(),Cn("syncRect",Ds))}function vp(M,C,U,F,$,J,lt){dt._lock||Is&&M!=null&&M.movementX==0&&M.movementY==0||(gh(M,C,U,F,$,J,lt,!1,M!=null),M!=null?or(null,!0,!0):or(C,!0,!1))}function gh(M,C,U,F,$,J,lt,pt,vt){if(Ds==null&&Jo(!1),Jt(M),M!=null)U=M.clientX-Ds.left,F=M.clientY-Ds.top;else{if(U<0||F<0){He=-10,Ze=-10;return}let[Nt,Dt]=pn.scales,Ut=C.cursor.sync,[ie,Me]=Ut.values,[ve,me]=Ut.scales,[Kt,Wt]=pn.match,$e=C.axes[0].side%2==1,tn=P.ori==0?z:Rt,Rn=P.ori==1?z:Rt,De=$e?J:$,en=$e?$:J,ii=$e?F:U,Hn=$e?U:F;if(ve!=null?U=Kt(Nt,ve)?a(ie,v[Nt],tn,0):-10:U=tn*(ii/De),me!=null?F=Wt(Dt,me)?a(Me,v[Dt],Rn,0):-10:F=Rn*(Hn/en),P.ori==1){let xi=U;U=F,F=xi}}vt&&(C==null||C.cursor.event.type==gf)&&((U<=1||U>=z-1)&&(U=wr(U,z)),(F<=1||F>=Rt-1)&&(F=wr(F,Rt))),pt?(pp=U,mp=F,[Fr,kr]=dt.move(i,U,F)):(He=U,Ze=F)}let xh={width:0,height:0,left:0,top:0};function _h(){hl(xh,!1)}let bp,Sp,Mp,wp;function Ap(M,C,U,F,$,J,lt){Is=!0,En=Tn=Ln._x=Ln._y=!1,gh(M,C,U,F,$,J,lt,!0,!1),M!=null&&(ye(xf,Sf,Ep,!1),jo(Y0,i,Fr,kr,z,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=We;bp=pt,Sp=vt,Mp=Nt,wp=Dt}function Ep(M,C,U,F,$,J,lt){Is=Ln._x=Ln._y=!1,gh(M,C,U,F,$,J,lt,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=We,Ut=Nt>0||Dt>0,ie=bp!=pt||Sp!=vt||Mp!=Nt||wp!=Dt;if(Ut&&ie&&hl(We),Ln.setScale&&Ut&&ie){let Me=pt,ve=Nt,me=vt,Kt=Dt;if(P.ori==1&&(Me=vt,ve=Dt,me=pt,Kt=Nt),En&&Ls(E,Gi(Me,E),Gi(Me+ve,E)),Tn)for(let Wt in v){let $e=v[Wt];Wt!=E&&$e.from==null&&$e.min!=Be&&Ls(Wt,Gi(me+Kt,Wt),Gi(me,Wt))}_h()}else dt.lock&&(dt._lock=!dt._lock,or(C,!0,M!=null));M!=null&&(xn(xf,Sf),jo(xf,i,He,Ze,z,Rt,null))}function hv(M,C,U,F,$,J,lt){if(dt._lock)return;Jt(M);let pt=Is;if(Is){let vt=!0,Nt=!0,Dt=10,Ut,ie;P.ori==0?(Ut=En,ie=Tn):(Ut=Tn,ie=En),Ut&&ie&&(vt=He<=Dt||He>=z-Dt,Nt=Ze<=Dt||Ze>=Rt-Dt),Ut&&vt&&(He=He<Fr?0:z),ie&&Nt&&(Ze=Ze<kr?0:Rt),or(null,!0,!0),Is=!1}He=-10,Ze=-10,it.fill(null),or(null,!0,!0),pt&&(Is=pt)}function Tp(M,C,U,F,$,J,lt){dt._lock||(Jt(M),Yo(),_h(),M!=null&&jo(J0,i,He,Ze,z,Rt,null))}function Cp(){b.forEach(uR),B(i.width,i.height,!0)}Tr(Nu,No,Cp);let Vr={};Vr.mousedown=Ap,Vr.mousemove=vp,Vr.mouseup=Ep,Vr.dblclick=Tp,Vr.setSeries=(M,C,U,F)=>{let $=pn.match[2];U=$(i,C,U),U!=-1&&Vi(U,F,!0,!1)},ht&&(ye(Y0,p,Ap),ye(gf,p,vp),ye(Z0,p,M=>{Jt(M),Jo(!1)}),ye(K0,p,hv),ye(J0,p,Tp),Pf.add(i),i.syncRect=Jo);let dl=i.hooks=n.hooks||{};function Cn(M,C,U){Gn?Ie.push([M,C,U]):M in dl&&dl[M].forEach(F=>{F.call(null,i,C,U)})}(n.plugins||[]).forEach(M=>{for(let C in M.hooks)dl[C]=(dl[C]||[]).concat(M.hooks[C])});let Rp=(M,C,U)=>U,pn=gn({key:null,setSeries:!1,filters:{pub:lx,sub:lx},scales:[E,x[1]?x[1].scale:null],match:[cx,cx,Rp],values:[null,null]},dt.sync);pn.match.length==2&&pn.match.push(Rp),dt.sync=pn;let Pp=pn.key,yh=r_(Pp);function jo(M,C,U,F,$,J,lt){pn.filters.pub(M,C,U,F,$,J,lt)&&yh.pub(M,C,U,F,$,J,lt)}yh.sub(i);function dv(M,C,U,F,$,J,lt){pn.filters.sub(M,C,U,F,$,J,lt)&&Vr[M](null,C,U,F,$,J,lt)}i.pub=dv;function fv(){yh.unsub(i),Pf.delete(i),An.clear(),Af(Nu,No,Cp),c.remove(),St?.remove(),Cn("destroy")}i.destroy=fv;function vh(){Cn("init",n,t),qo(t||n.data,!1),V[E]?dh(E,V[E]):Yo(),st=We.show&&(We.width>0||We.height>0),et=mt=!0,B(n.width,n.height)}return x.forEach(Ir),b.forEach(is),e?e instanceof HTMLElement?(e.appendChild(c),vh()):e(i,vh):vh(),i}ln.assign=gn;ln.fmtNum=Ff;ln.rangeNum=Du;ln.rangeLog=Fu;ln.rangeAsinh=Of;ln.orient=Rr;ln.pxRatio=Ae;ln.join=eC;ln.fmtDate=Bf,ln.tzDate=dC;ln.sync=r_;{ln.addGap=YC,ln.clipGaps=zu;let n=ln.paths={points:h_};n.linear=f_,n.stepped=JC,n.bars=jC,n.spline=tR}var hR=20,[dR,x_,Wu]=[46,14,4],__=18,Xf=26,fR=16,$u=12;function y_(n,{name:t,lines:e,word:i="",under:s=()=>[],over:r=()=>[]}){return Bg(()=>{let[o,a]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],l=hR+n.axes[1]._size,c=l+o+x_,u=pR(i,e,l,c-x_),h=u.height+8,d=[...s(),...mR(n,o,a),{kind:"clip",x:0,y:0,width:o,height:a,shapes:gR(n)},{kind:"path",points:[[0,0],[0,a],[o,a]],stroke:be("--ink")},...r(),...xR(n,t,o,a,l)],f=h+a+dR;return{svg:vu([...u.shapes,{kind:"moved",x:l,y:h,shapes:d}],c,f,t),width:c,height:f}})}function pR(n,t,e,i){let s=document.createElement("canvas").getContext("2d");s.font=`${$u}px system-ui, sans-serif`;let r=[],[o,a]=[e,__-4],l=be("--ink"),c=(u,h)=>{let d=h+s.measureText(u).width;o>e&&o+d>i&&([o,a]=[e,a+__]);let f=o;return o+=d+fR,f};n&&r.push({kind:"text",x:c(n,0),y:a,text:n,size:$u,fill:l});for(let[u,h]of t.entries()){let d=c(h,Xf),{colour:f,dash:p}=Si(u);r.push({kind:"path",points:[[d,a-4],[d+Xf-6,a-4]],stroke:f,lineWidth:1.6,dash:p}),r.push({kind:"text",x:d+Xf,y:a,text:h,size:$u,fill:l})}return{shapes:r,height:r.length?a+4:0}}function Xu(n,t,e){let{_splits:i,_values:s}=n.axes[t];return i.flatMap((r,o)=>s[o]?[[n.valToPos(r,e),s[o]]]:[])}function mR(n,t,e){let i=(...s)=>({kind:"path",points:s,stroke:be("--grid")});return[...Xu(n,0,"x").map(([s])=>i([s,0],[s,e])),...Xu(n,1,"y").map(([s])=>i([0,s],[t,s]))]}function gR(n){let[t,...e]=n.data;return e.map((i,s)=>{let{colour:r,dash:o}=Si(s),a=[];for(let l=0;l<t.length;l++)i[l]===null||i[l]===void 0||Number.isNaN(i[l])||a.push([n.valToPos(t[l],"x"),n.valToPos(i[l],"y")]);return{kind:"path",points:a,stroke:r,lineWidth:1.6,dash:o}})}function xR(n,t,e,i,s){let[r,o]=[be("--ink"),be("--ink")],a=(c,u,h,d)=>({kind:"text",x:c,y:u,text:h,size:$u,fill:r,...d}),{label:l}=n.axes[0];return[...Xu(n,0,"x").flatMap(([c,u])=>[{kind:"path",points:[[c,i],[c,i+Wu]],stroke:o},a(c,i+Wu+13,u,{anchor:"middle"})]),...Xu(n,1,"y").flatMap(([c,u])=>[{kind:"path",points:[[0,c],[-Wu,c]],stroke:o},a(-Wu-4,c+4,u,{anchor:"end"})]),a(e/2,i+38,typeof l=="function"?l():l,{anchor:"middle"}),a(12-s,i/2,Oe(t),{anchor:"middle",turned:!0})]}var Zu=210,_R=64,yR=.02,vR=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...PR(3,20)];function Vo(n,t,e,i){let s=t.map(o=>bR(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,u)=>t[u].sharing===o.sharing).flat():null;return MR(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function bR(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):sn(e.values,Float32Array)}))}function SR(n,t,e){let i=[1/0,-1/0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function qu(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function MR(n,t,e,i,s){let{element:r,head:o,key:a,place:l}=qf(n,n.owner),c=S("div",{className:"cursor"}),u=null,h=null,d=!1,f=[],p=new ResizeObserver(()=>u?.setSize({width:l.clientWidth,height:Zu}));function _(){let{word:b}=n,v=b_(n).map((A,E)=>S("li",{},lr(Si(E)),A));a.replaceChildren(...b?[S("li",{},b)]:[],...v)}function m(){(s.span!==h||s.stretched!==d)&&(h=s.span,d=s.stretched,u.setData(v_(n,t,i,h),!1),u.setScale("x",{min:h.start,max:h.end})),c.style.transform=`translateX(${u.valToPos(s.time,"x").toFixed(2)}px)`}function g(){h=s.span,d=s.stretched,u=new ln(wR(n,e,i,s,l.clientWidth),v_(n,t,i,h),l),u.setScale("x",{min:h.start,max:h.end}),u.over.append(c),RR(u,s),p.observe(l),u.hooks.setSize=[m];let b=()=>{_(),u.redraw(!1)};f=[s.onChange(m),js(b)],_();let v=qu(n);o.append(Yf(n,()=>u,{under:()=>M_(u,i,v,s.span),over:()=>w_(u,i,v,s.span)}))}function x(){for(let b of f)b();p.disconnect(),u.destroy()}return{element:r,start:g,dispose:x,get chart(){return u}}}function qf(n,t=null){let e=t?`${Oe(t)}. ${n.text}`:n.text,i=S("div",{className:"chart",role:"img","aria-label":e}),s=S("ul",{className:"key"}),r=S("h2",{},`${Oe(n.title)} (${n.unit})`);t&&r.append(S("small",{},t));let o=S("div",{className:"head"},r);return{element:S("figure",{},o,s,i,S("figcaption",{},n.text)),head:o,key:s,place:i}}function b_({lines:n,word:t}){return n.map(({name:e})=>t?e.slice(t.length+1):e)}function Yf(n,t,{under:e,over:i}){let s=n.owner?`${n.title}, ${n.owner}`:n.title;return $i(s,()=>Xn(s),()=>y_(t(),{name:`${n.title} (${n.unit})`,lines:b_(n),word:n.word,under:e,over:i}))}function v_(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return qu(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:ln.join(s)}function wR(n,t,e,i,s){let r=Ku(),o=(a,l,c)=>TR(n,...t?SR(t,e,i.span):[l,c]);return{width:s,height:Zu,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...Zf(n.lines)],axes:[{...r,...Kf,labelFont:r.font,label:()=>`${i.span.label} (${Qo(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,u,h)=>i.stretched?AR(a,i):ER(c,u,h),values:(a,l)=>l.map(c=>c===null?"":S_(c*Qo(i.span).factor)),space:56},Jf(n)],hooks:{drawClear:[a=>Yu(a,M_(a,e,qu(n),i.span))],draw:[a=>Yu(a,w_(a,e,qu(n),i.span))]}}}function AR(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/_R)),{factor:i}=Qo(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function ER(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function Zf(n){return n.map((t,e)=>({stroke:()=>Si(e).colour,dash:Si(e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var Kf={size:24,gap:3,labelSize:18,labelGap:0};function Ku(){return{stroke:()=>be("--muted"),grid:{stroke:()=>be("--grid"),width:1},ticks:{stroke:()=>be("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function Jf(n){return{...Ku(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":S_(i)),...n.unit==="deg"?{incrs:vR,space:26}:{space:30}}}function TR(n,t,e){let[i,s]=CR(t,e)?[t,e]:[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i!==0?i-r:i,s+2*r]}function CR(n,t){let e=Math.max(Math.abs(n),Math.abs(t));return n*t>0&&Math.min(Math.abs(n),Math.abs(t))>e/2&&t-n>yR*e}function S_(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?Ee(n):t.replace("-","−")}function Yu(n,t){let{ctx:e,bbox:i}=n;Za(e,t,devicePixelRatio,[i.left/devicePixelRatio,i.top/devicePixelRatio])}function M_(n,t,e,i){if(e===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t[e].stages.filter(o=>o.driven).map(o=>{let[a,l]=[o.start,o.end].map(c=>Math.min(s,Math.max(0,n.valToPos(c-i.origins[e],"x"))));return{kind:"rect",x:a,y:0,width:l-a,height:r,fill:be("--band")}})}function w_(n,t,e,i){if(e===null)return[];let[s,r]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t[e].marks.flatMap(o=>{let a=n.valToPos(o.time-i.origins[e],"x");if(a<-1||a>s+1)return[];let l=a>s-16?-1:1;return[{kind:"path",points:[[a,0],[a,r]],stroke:be("--muted"),dash:[2,3]},{kind:"rect",x:a+(l>0?2:-14),y:1,width:12,height:15,fill:be("--page")},{kind:"text",x:a+l*8,y:13,text:o.letter,anchor:"middle",bold:!0,fill:be("--ink")}]})}function RR(n,t){jf(n,e=>{t.pause(),t.seek(n.posToVal(e.clientX-n.over.getBoundingClientRect().left,"x"))})}function jf(n,t){n.over.addEventListener("pointerdown",e=>{e.button===0&&(n.over.setPointerCapture(e.pointerId),t(e))}),n.over.addEventListener("pointermove",e=>{n.over.hasPointerCapture(e.pointerId)&&t(e)})}function PR(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function Ju(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function A_(n){let t=n.clips.map(ti),e=As(t,n.spans),i=Eo(document.getElementById("player"),t,e,n);Qf(i.stage.cells,t,e,n.energy);let s=Vo(document.getElementById("plots"),n.plots,t,e);return Ju(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function Qf(n,t,e,i){let s=t.map((r,o)=>{let a=S("span",{className:"state-now"}),l=S("b",{},lr(Si(o)),r.name);return js(()=>l.replaceChild(lr(Si(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[u]=o.readings;u&&c.push(IR(o.valuesAt(u.name,a),u.unit));let h=o.valuesAt(ws,a).reduce((d,f)=>d+f,0);o.tendons&&c.push(`${Ee(i.factor*h)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function IR(n,t){let e=s=>t==="deg"?`${qn(s,0)}°`:`${Ee(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var LR=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],NR=1.35;function al(n,t,e=[],i=null,s=null){let r=t.map(o=>DR(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function DR(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(y=>y.map(OR)),{element:a,head:l,key:c,place:u}=qf(n),h=(r.length?r:[s[0]]).map(y=>S("span",{className:"ball"},r.length&&y.name.length<3?y.name:"")),d=r.map(y=>[y.places[0],y.values[0]]),f=Math.round(NR*Zu),p=UR(s),_=p,m=null;function g(){let y=s.map((I,L)=>S("li",{},lr(Si(L)),I.name)),w=r.length?"the run now":"moved by the slider";c.replaceChildren(...y,S("li",{},S("span",{className:"ball still"}),w))}function x(){for(let[y,[w,I]]of d.entries()){let[L,P]=[m.valToPos(w,"x"),m.valToPos(I,"y")];h[y].style.transform=`translate(${L.toFixed(2)}px, ${P.toFixed(2)}px)`}}function b(){let[y,w]=ts(t.time,e.clipTime(0));for(let[I,{places:L,values:P}]of r.entries())d[I]=[tp(L,y,w),tp(P,y,w)];x()}function v(y){_=y,m.setScale("x",{min:y[0],max:y[1]})}function A(y,w,I){if(_!==p){let{places:N,values:k}=s[0],D=k.filter((W,ot)=>N[ot]>=_[0]&&N[ot]<=_[1]),[V,X]=[Math.min(...D),Math.max(...D)];return[V-.25*(X-V),X+.25*(X-V)]}let L=r.reduce((N,k)=>Math.max(N,k.most),I),P=Math.min(0,w);return[P-.06*(L-P||1),L+.1*(L-P||1)]}function E(){let y=ln.join(s.map(w=>[w.sorted.places,w.sorted.values]));m=new ln(FR({data:n,lines:s,balls:r,marks:o,energyRange:A},u.clientWidth,f),y,u),m.over.append(...h),new ResizeObserver(()=>m.setSize({width:u.clientWidth,height:f})).observe(u),m.hooks.setSize=[x],m.hooks.setScale=[x],g(),js(()=>{g(),m.redraw(!1)}),l.append(Yf(n,()=>m,{under:()=>[],over:()=>[...E_(m,r),...T_(m,o)]})),n.top&&u.after(kR(p,n.top,v)),r.length?(e.onChange(b),BR(m,r,t,e)):zR(n,s[0],u,(w,I)=>{d[0]=[w,I],x()},i),v(p)}return{element:a,start:E,now:d,get chart(){return m}}}function OR({name:n,places:t,values:e}){let i={name:n,places:sn(t,Float32Array),values:sn(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function tp(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function UR(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function FR({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=Ku(),l=Jf(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...Zf(t)],axes:[{...a,...Kf,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:LR,space:44},l],hooks:{draw:[c=>Yu(c,[...E_(c,e),...T_(c,i)])]}}}function E_(n,t){let[e,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio];return t.flatMap(({places:r,values:o})=>Array.from(r,(a,l)=>[n.valToPos(a,"x"),n.valToPos(o[l],"y")])).filter(([r,o])=>r>0&&r<e&&o>0&&o<i).map(([r,o])=>({kind:"rect",x:r-.8,y:o-.8,width:1.6,height:1.6,fill:be("--accent"),opacity:.55}))}function T_(n,t){let[e,i]=[n.bbox.width/devicePixelRatio,n.bbox.height/devicePixelRatio],s=t.flatMap(({name:r,places:o,values:a})=>{let l=Array.from(o,(f,p)=>[n.valToPos(f,"x"),n.valToPos(a[p],"y")]),[c,u]=l[l.length>>1],h=l.length===1?{kind:"circle",x:c,y:u,r:4.5,fill:be("--page"),stroke:be("--ink"),lineWidth:1.4}:{kind:"path",points:l,stroke:be("--line-2"),lineWidth:7,opacity:.35},d=l.length>1?0:c>e/2?-1:1;return[h,{kind:"text",x:c+12*d,y:u-9,text:r,anchor:["end","middle","start"][d+1],fill:be("--ink")}]});return[{kind:"clip",x:-6,y:0,width:e+12,height:i+6,shapes:s}]}function kR(n,t,e){let i=[["whole curve",n],["barrier enlarged",t]].map(([s,r],o)=>{let a=S("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return S("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function BR(n,t,e,i){jf(n,r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,u]=[0,1/0];for(let{places:h,values:d}of t)for(let f=0;f<h.length;f++){let p=Math.hypot(n.valToPos(h[f],"x")-a,n.valToPos(d[f],"y")-l);p<u&&([c,u]=[f,p])}i.pause(),i.seekClip(0,e.time[c])})}function zR(n,t,e,i,s){let r=t.places.length-1,o=S("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=S("output",{"aria-live":"off"}),l=()=>{let d=Number(o.value);i(t.places[d],t.values[d]);let[f,p]=[Ee(t.places[d]),`${Ee(t.values[d])} ${n.unit}`];a.textContent=`${f}°, ${p}`,o.setAttribute("aria-valuetext",`${n.axis} ${f} degrees, energy ${p}`)},c=n.poses&&s?sn(n.poses,Float32Array):null,u=!1;o.addEventListener("input",()=>{l(),u=!0,c&&s.seek(VR(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{u||(o.value=String(GR(t.places,tp(c,Math.floor(s.time),s.time%1))),l()),u=!1});let h=n.drawn?[S("p",{className:"note"},n.drawn)]:[];e.after(S("div",{className:"slide"},o,a),...h),l()}function VR(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function GR(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function ju(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function C_(n){let t=document.getElementById("curves");if(!n.clips)return{curves:al(t,n.curves)};let e=n.clips.map(ti),i=ju(e[0]),s=To(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:al(t,n.curves,[],null,i)}}function ep(n){return n.energy?Mo:kg}function R_(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}function Go({sign:n,pattern:t}){return S("span",{className:`what ${t}`,"aria-hidden":"true"},S("span",{},n))}function Qu(n,t){let e=n.scaleOf(t);if(!e)return[];let i=S("span",{className:"bar","aria-hidden":"true"});return i.style.background=ep(t).gradient,[S("p",{className:"scale"},`${t.title} (${t.unit})`,S("span",{className:"whole"},e.text(e.low),i,e.text(e.high)))]}function th(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(h=>h.values.length),o=new Map;for(let h of t)o.set(h.point,[...o.get(h.point)??[],h]);function a(h){if(n.sampled)return e.map(()=>h);let d=[];for(let f=r.length-1;f>=0;f--)d[f]=h%r[f],h=Math.floor(h/r[f]);return d}let l=h=>h.reduce((d,f,p)=>d*r[p]+f,0);function c(h){let f=(h.shares?i.filter(x=>x.group===h.group):[h]).flatMap(x=>x.values??[]).filter(x=>x!==null);if(!f.length)return null;let[p,_]=[f.reduce((x,b)=>Math.min(x,b)),f.reduce((x,b)=>Math.max(x,b))],m=x=>_>p?(x-p)/(_-p):.5,g=HR((h.values??[]).filter(x=>x!==null));return{low:p,high:_,colour:x=>R_(ep(h),m(x)),text:x=>ns(Number(x.toFixed(g)))}}let u=(h,d)=>`${h.name} ${h.texts[d]}${h.unit?` ${h.unit}`:""}`;return{study:n,sizes:r,numbers:i.filter(h=>h.values&&!h.tried),columns:e,shown:()=>!0,nameOf:()=>"",placesOf:a,pointAt:l,scaleOf:c,factorText:u,largestSpan:t.reduce((h,d)=>Math.max(h,d.play.clips[0].span_m),0),runsOf:h=>o.get(h)??[],word:h=>s[h],pointText:h=>a(h).map((d,f)=>u(e[f],d)).join(", "),valueText(h,d){let f=h.values?.[d]??null;return f===null?s[h.reasons[d]].word:`${ns(f)} ${h.unit}`}}}function HR(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function ns(n){let t=Number(n.toPrecision(3));return(t!==0&&Math.abs(t)<.001?t.toExponential():String(t)).replaceAll("-","−")}var WR="http://www.w3.org/2000/svg";function Le(n,t,...e){let i=document.createElementNS(WR,n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function Ho({values:n,log:t},e=[]){let i=[...new Set(n.filter(d=>typeof d=="string"))];if(i.length)return{words:i,share:f=>(i.indexOf(f)+.5)/i.length,ticks:i,value:f=>i[Math.min(i.length-1,Math.max(0,Math.floor(f*i.length)))]};let s=[...n,...e].filter(d=>typeof d=="number"),r=t&&s.every(d=>d>0),[o,a]=r?[Math.log,Math.exp]:[d=>d,d=>d],l=s.reduce((d,f)=>Math.min(d,o(f)),1/0),c=s.reduce((d,f)=>Math.max(d,o(f)),-1/0),u=d=>c>l?(o(d)-l)/(c-l):.5,h=s.length?(r?$R:P_)(a(l),a(c)):[];return{words:i,share:u,ticks:h,value:d=>a(l+d*(c-l))}}function np(n,t,e,i,s=[]){let r=t.unit?`${t.name} (${t.unit})`:t.name,o=Ho({values:n,log:t.log},s),a=.04*(i-e),l=u=>e+a+o.share(u)*(i-e-2*a),c=o.ticks.map(u=>[l(u),typeof u=="number"?ns(u):u]);return{label:r,from:e,to:i,ticks:c,at:l,place:u=>n[u]===null?e+.75*a:l(n[u])}}function P_(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function $R(n,t){if(!(t>n))return[n];let e=t/n>200?[1]:[1,2,5],i=[];for(let s=Math.floor(Math.log10(n));s<=Math.ceil(Math.log10(t));s++)for(let r of e){let o=Number((r*10**s).toPrecision(12));o>=n*(1-1e-9)&&o<=t*(1+1e-9)&&i.push(o)}return i.length>1?i:P_(n,t)}function I_(n,t,e){let i=[Le("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],s=(r,o)=>i.push(Le("text",{class:"label",...o},r));for(let[r,o]of n.ticks)s(o,{x:r,y:t.from+18,"text-anchor":"middle"});for(let[r,o]of t.ticks)s(o,{x:n.from-8,y:r,dy:"0.35em","text-anchor":"end"});return s(n.label,{x:(n.from+n.to)/2,y:e-8,"text-anchor":"middle"}),s(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),i}var eh=300,L_=30,XR=92,O_=16,qR=5;function U_(n,t,{best:e,best_word:i,front:s},r){let a={axes:[...new Set(t.map(n.indexOf).filter(y=>y>=0))],opened:null,hovered:null,best:e,bestWord:i,front:s},l=S("div",{className:"titles"}),c=S("div",{className:"drawn"}),u=S("div",{className:"board"},l,c),h=S("div",{className:"scroll"},u),d=S("p",{className:"note",role:"status"}),f=S("p",{className:"note under"}," "),p=S("button",{type:"button"},`show all ${n.study.noun}s`);p.addEventListener("click",()=>{n.forget(),c.querySelector("[role=slider]")?.focus()});let _=()=>{KR(n,a,{board:u,titles:l,place:c,width:h.clientWidth}),nh(n,a,c)},m="Press a line to open its run. Move the two handles of an axis to select a range of values.",g=ZR(n,a),x=`All ${n.study.noun}s as lines`,b=$i(x,()=>Xn(x),()=>er([u,g],x,".handle")),v=S("div",{className:"head"},S("h2",{},x),b),A=S("section",{className:"lines"},v,S("p",{className:"note"},m),YR(n,a,_),h,g,S("div",{className:"choices"},p,d),f);eP(n,a,c,f,r),n.whenAsked(()=>{nh(n,a,c),F_(n,a,c),N_(n,d,p)}),N_(n,d,p);let E=0;return new ResizeObserver(()=>{h.clientWidth!==E&&(E=h.clientWidth,_())}).observe(h),{element:A,show(y){a.opened=y,nh(n,a,c)}}}function N_(n,t,e){let{points:i,noun:s}=n.study,r=Array.from({length:i},(l,c)=>c).filter(n.shown),o=r.filter(n.good).length,a=n.study.words.find(l=>l.good)?.word;t.textContent=`${r.length} of ${i} ${s}s lie within the selected ranges${a?`; ${a}: ${o}`:""}.`,e.hidden=n.asked.size===0}function YR(n,t,e){let i=n.columns.map((s,r)=>{let o=S("input",{type:"checkbox",checked:t.axes.includes(r)});return o.addEventListener("change",()=>{t.axes=n.columns.map((a,l)=>l).filter(a=>a===r?o.checked:t.axes.includes(a)),o.checked||n.ask(r,0,1),e()}),S("label",{},o,s.name)});return S("details",{},S("summary",{},"Axes"),S("fieldset",{className:"filter"},S("legend",{},"Show an axis of"),...i))}function ZR(n,t){let e=(r,o)=>S("li",{},S("span",{className:`line ${r}`,"aria-hidden":"true"}),o),i=n.study.words.find(r=>r.good),s=[];return i&&s.push(e("good",i.word)),n.study.words.some(r=>!r.good)&&s.push(e("behind",i?`other ${n.study.noun}s`:`all ${n.study.noun}s`)),t.front.length&&s.push(e("front","Pareto front")),t.best!==null&&s.push(e("best",t.bestWord)),s.push(e("opened","open")),n.columns.some(r=>r.limits.length)&&s.push(S("li",{},S("span",{className:"bound","aria-hidden":"true"}),"range allowed by a limit")),S("ul",{className:"keys-of-lines"},...s)}function KR(n,t,{board:e,titles:i,place:s,width:r}){let o=t.axes.length,a=Math.max(r,o*XR);e.style.width=`${a}px`,i.replaceChildren(...t.axes.map(c=>JR(n.columns[c]))),i.style.gridTemplateColumns=`repeat(${o}, 1fr)`,t.x=c=>(c+.5)*a/o,t.y=c=>eh-L_-c*(eh-2*L_);let l=Le("svg",{width:a,height:eh,viewBox:`0 0 ${a} ${eh}`,role:"img","aria-label":`${n.study.points} ${n.study.noun}s as lines over ${o} axes; the table below has them all`});l.append(Le("g",{class:"layers"}));for(let[c,u]of t.axes.entries())l.append(...jR(n.columns[u],t.x(c),t.y));s.replaceChildren(l),F_(n,t,s)}function JR(n){let t=n.unit?` (${n.unit})`:"",e=n.aim?S("small",{},`${n.aim} is best`):"";return S("div",{},`${n.name}${t}`,e)}function jR({scale:n,limits:t},e,i){let s=[Le("path",{class:"axis",d:`M${e} ${i(0)}V${i(1)}`})];for(let{kind:r,bound:o}of t){let a=Math.min(1,Math.max(0,n.share(o)));s.push(Le("path",{class:"bound",d:`M${e} ${i(a)}V${i(r===">="?1:0)}`}))}for(let r of n.ticks){let o=i(n.share(r));s.push(Le("path",{class:"axis",d:`M${e} ${o}h5`}),Le("text",{class:"label",x:e+8,y:o,dy:"0.35em"},typeof r=="number"?ns(r):r))}return s}function F_(n,t,e){let i=e.contains(document.activeElement)?document.activeElement.dataset.handle:null;for(let s of e.querySelectorAll("[role=slider]"))s.remove();for(let[s,r]of t.axes.entries())for(let o of["least","most"]){let a=QR(n,t,e,r,o);a.style.left=`${t.x(s)}px`,e.append(a),a.dataset.handle===i&&a.focus()}}function QR(n,t,e,i,s){let r=n.columns[i],[o,a]=n.asked.get(i)??[0,1],l=s==="least"?o:a,c=r.scale.value(l),u=typeof c=="number"?`${ns(c)} ${r.unit}`.trim():String(c??""),h=S("div",{role:"slider",className:`handle ${s}`,tabIndex:0,"aria-orientation":"vertical","aria-label":`${s} ${r.name}`,"aria-valuemin":"0","aria-valuemax":"100","aria-valuenow":String(Math.round(100*l)),"aria-valuetext":u,title:`${s} ${r.name}: ${u}`});h.dataset.handle=`${i} ${s}`,h.dataset.keys="own",h.style.top=`${t.y(l)}px`;let d=_=>{let[m,g]=n.asked.get(i)??[0,1];s==="least"?n.ask(i,Math.min(Math.max(_,0),g),g):n.ask(i,m,Math.max(Math.min(_,1),m))},f=r.scale.words.length?1/r.scale.words.length:.02,p={ArrowUp:f,ArrowRight:f,ArrowDown:-f,ArrowLeft:-f,PageUp:5*f,PageDown:-5*f};return h.addEventListener("keydown",_=>{if(!(_.ctrlKey||_.metaKey||_.altKey)){if(_.key in p)d(l+p[_.key]);else if(_.key==="Home")d(0);else if(_.key==="End")d(1);else return;_.preventDefault()}}),h.addEventListener("pointerdown",_=>{_.preventDefault(),h.focus(),k_(_,m=>d(ip(t,e,m)))}),h}function k_(n,t,e=()=>{}){let i=o=>a=>a.pointerId===n.pointerId&&o(a),s=i(t),r=i(o=>{removeEventListener("pointermove",s),removeEventListener("pointerup",r),removeEventListener("pointercancel",r),e(o)});addEventListener("pointermove",s),addEventListener("pointerup",r),addEventListener("pointercancel",r)}function ip(n,t,e){let i=e.clientY-t.getBoundingClientRect().top;return Math.min(1,Math.max(0,(n.y(0)-i)/(n.y(0)-n.y(1))))}function tP(n,t,e){let i="",s=!1;for(let[r,o]of t.axes.entries()){let a=n.columns[o].values[e];a!==null&&(i+=`${s?"L":"M"}${t.x(r).toFixed(1)} ${t.y(n.columns[o].scale.share(a)).toFixed(1)}`),s=a!==null}return i}function nh(n,t,e){let i=e.querySelector(".layers");if(!i)return;let s=Array.from({length:n.study.points},(u,h)=>h),[r,o]=[s.filter(n.shown),s.filter(u=>!n.shown(u))],a=u=>u===null?[]:[u],l={out:o,behind:r.filter(u=>!n.good(u)),good:r.filter(n.good),front:t.front.filter(n.shown),best:a(t.best),opened:a(t.opened),hovered:a(t.hovered)},c=Object.entries(l).filter(([,u])=>u.length);i.replaceChildren(...c.map(([u,h])=>Le("path",{class:`line ${u}`,d:h.map(d=>tP(n,t,d)).join("")})))}function eP(n,t,e,i,s){let r=o=>{o!==t.hovered&&(t.hovered=o,e.classList.toggle("pressable",o!==null),i.textContent=o===null?" ":`${n.nameOf(o)}${n.pointText(o)}: ${n.study.statuses[o]}`,nh(n,t,e))};e.addEventListener("pointermove",o=>{o.pointerType==="mouse"&&o.buttons===0&&r(D_(n,t,e,o))}),e.addEventListener("pointerleave",()=>r(null)),e.addEventListener("pointerdown",o=>{if(o.button!==0||o.target.closest("[role=slider]"))return;let a=o.pointerType==="touch"?null:nP(t,e,o),l=ip(t,e,o),c=!1;k_(o,h=>{c||=Math.hypot(h.clientX-o.clientX,h.clientY-o.clientY)>qR;let d=ip(t,e,h);c&&a!==null&&n.ask(a,Math.min(l,d),Math.max(l,d))},h=>{let d=c||h.type==="pointercancel"?null:D_(n,t,e,h);d!==null&&s(d)})})}function nP(n,t,e){let i=e.clientX-t.getBoundingClientRect().left,s=n.axes.findIndex((r,o)=>Math.abs(n.x(o)-i)<O_);return s<0?null:n.axes[s]}function D_(n,t,e,i){let s=e.getBoundingClientRect(),[r,o]=[i.clientX-s.left,i.clientY-s.top],a=t.axes.findLastIndex((p,_)=>t.x(_)<=r),[l,c]=[Math.max(0,a),Math.min(t.axes.length-1,a+1)],u=c>l?(r-t.x(l))/(t.x(c)-t.x(l)):0,h=(p,_)=>{let m=n.columns[t.axes[p]],g=m.values[_];return g===null?NaN:t.y(m.scale.share(g))},[d,f]=[null,O_];for(let p=0;p<n.study.points;p++){if(!n.shown(p))continue;let[_,m]=[h(l,p),h(c,p)],g=_+u*(m-_),x=c>l?(m-_)/(t.x(c)-t.x(l)):0,b=Math.abs(o-g)/Math.hypot(1,x)-(n.good(p)?1:0);b<f&&([d,f]=[p,b])}return d}function B_(n,t){let e=th(n,t),i=n.factors.map(c=>({...c,limits:[],aim:""})),s=e.numbers.map(c=>({...c,key:c.name,name:c.title,log:!1,own:null})),r=[...i,...s].map(c=>({...c,scale:Ho(c,iP(c))})),o=new Map,a=[],l=([c,[u,h]],d)=>{let f=r[c].values[d];if(f===null)return!1;let p=r[c].scale.share(f);return p>=u-1e-9&&p<=h+1e-9};return{...e,columns:r,asked:o,indexOf:c=>r.findIndex(u=>u.key===c),shown:c=>[...o].every(u=>l(u,c)),good:c=>e.word(n.verdicts[c]).good,nameOf:c=>`${n.noun} ${c+1}: `,whenAsked:c=>a.push(c),ask(c,u,h){u<=0&&h>=1?o.delete(c):o.set(c,[u,h]);for(let d of a)d()},forget(){o.clear();for(let c of a)c()}}}function iP({limits:n,values:t}){let e=t.filter(r=>typeof r=="number"),[i,s]=[Math.min(...e),Math.max(...e)];return n.map(r=>r.bound).filter(r=>r>=i-(s-i)&&r<=s+(s-i))}var sP=12,[sp,Cs]=[200,76],ll=130;function G_(n,{marginals:t,pairs:e},i){let s=S("div",{className:"marginals"}),r=S("div",{className:"pairs"}),[o,a]=[t,e].map(h=>h.map(n.indexOf).filter(d=>d>=0)),l=()=>{s.replaceChildren(...o.map(h=>aP(n,h))),r.replaceChildren(...lP(n,a,i))};r.style.setProperty("--columns",Math.max(1,a.length-1)),n.whenAsked(l),l();let u=[z_("Single unknowns",s),S("p",{className:"note"},"Blue: samples that agree. Grey: all drawn samples. Each colour is scaled by its number of samples. Unknowns that the facts narrow most come first."),s];return a.length>1&&u.push(z_("Pairs of unknowns",r),S("p",{className:"note"},"Press a pair to enlarge it."),r),{element:S("section",{className:"agreeing"},...u)}}function z_(n,t){let e=$i(n,()=>Xn(n),()=>er([t],n));return S("div",{className:"head"},S("h2",{},n),e)}var rP=n=>Array.from({length:n.study.points},(t,e)=>e),H_=n=>rP(n).filter(t=>!["placed","unbuilt"].includes(n.word(n.study.verdicts[t]).pattern));function oP(n,t,e){let i=t.words.length||sP,s=new Array(i).fill(0);for(let r of e)s[Math.min(i-1,Math.floor(t.share(n.values[r])*i))]+=1/e.length;return s}function aP(n,t){let e=n.columns[t],i=Ho(e),s=H_(n),r=s.filter(m=>n.good(m)&&n.shown(m)),[o,a]=[s,r].map(m=>oP(e,i,m)),l=Math.max(...o,...r.length?a:[0]),c=sp/o.length,u=(m,g)=>Le("path",{class:g,d:m.map((x,b)=>`M${b*c+1} ${Cs}v${-x/l*(Cs-4)}h${c-2}V${Cs}z`).join("")}),h=m=>Le("path",{class:"agree",d:`M0 ${Cs}${m.map((g,x)=>`V${Cs-g/l*(Cs-4)}H${(x+1)*c}`).join("")}V${Cs}`}),d=`${e.name}: ${V_(e,i,r)}`,f=Le("svg",{viewBox:`0 0 ${sp} ${Cs}`,role:"img","aria-label":d,preserveAspectRatio:"none"},u(o,"all"),...r.length?[h(a)]:[],Le("path",{class:"axis",d:`M0 ${Cs}H${sp}`})),p=i.words.length?i.words:[0,1].map(m=>ns(i.value(m))),_=e.unit?` (${e.unit})`:"";return S("figure",{},S("figcaption",{},`${e.name}${_}`),f,S("div",{className:"ends"},...p.map(m=>S("span",{},m))),S("small",{},V_(e,i,r)))}function V_(n,t,e){if(!e.length)return"no sample agrees";if(t.words.length)return t.words.map(r=>`${Math.round(100*e.filter(o=>n.values[o]===r).length/e.length)} % ${r}`).join(", ");let i=e.map(r=>n.values[r]).sort((r,o)=>r-o),s=r=>ns(i[Math.round(r*(i.length-1))]);return`middle half: ${s(.25)} to ${s(.75)}`}function lP(n,t,e){return t.slice(1).flatMap((i,s)=>t.slice(0,-1).map((r,o)=>o>s?S("span",{}):cP(n,r,i,e)))}function cP(n,t,e,i){let[s,r]=[t,e].map(f=>n.columns[f]),[o,a]=[s,r].map(f=>Ho(f)),l=(f,p)=>Le("path",{class:p,d:f.map(_=>`M${(4+o.share(s.values[_])*(ll-8)).toFixed(1)} ${(ll-4-a.share(r.values[_])*(ll-8)).toFixed(1)}h0`).join("")}),c=H_(n),u=c.filter(f=>n.good(f)&&n.shown(f)),h=Le("svg",{viewBox:`0 0 ${ll} ${ll}`,"aria-hidden":"true"},l(c.filter(f=>!u.includes(f)),"all"),l(u,"agree")),d=S("button",{type:"button","aria-label":`${r.name} over ${s.name}, large`},h,S("small",{},`${r.name} ↑, ${s.name} →`));return d.addEventListener("click",()=>i(t,e)),d}var[W_,rp]=[600,420],ih={left:76,right:14,top:12,bottom:52},$_=60,X_={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};function sh(n,t,e){let{columns:i,study:s}=n,{quantity:r}=t,o=Array.from({length:s.points},(g,x)=>x),a=n.scaleOf(r),l=np(i[t.x].values,i[t.x],ih.left,W_-ih.right,t.cells?.across),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,u=t.y===null?{name:r.title,unit:r.unit}:i[t.y],h=np(c,u,rp-ih.bottom,ih.top,t.cells?.upwards),d=`${r.title} of ${s.points} ${s.noun}s; arrows move between them, enter opens one`,f=Le("svg",{viewBox:`0 0 ${W_} ${rp}`,class:["scatter",o.length>$_&&"many",t.ordered&&"judged"].filter(Boolean).join(" "),role:"listbox","aria-label":d});t.cells&&f.append(...dP(t.cells,l,h)),f.append(...I_(l,h,rp),...Y_(i[t.x],l,h,!0),...t.y===null?[]:Y_(i[t.y],h,l,!1));let p=o.map(g=>[l.place(g),h.place(g)]);t.joined&&f.append(fP(t.front,p,i[t.x].aim));let _=o.length>$_?6:8,m=o.map(g=>hP(n,t,a,g,p[g],_));return f.append(...(t.ordered?uP(n,t,o):o).map(g=>m[g])),(m[t.current??0]??m[0])?.setAttribute("tabindex","0"),pP(f,m,t.ordered?[...o].sort((g,x)=>p[g][0]-p[x][0]):o,e),{element:S("div",{className:"scroll"},f),points:o}}function uP(n,t,e){let i=s=>(n.shown(s)?0:1e6)+(t.best===s?-1:n.study.verdicts[s]);return[...e].sort((s,r)=>i(r)-i(s))}function hP(n,t,e,i,[s,r],o){let{quantity:a}=t,l=a.values?.[i]??null,c=`${n.nameOf(i)}${n.pointText(i)}: ${n.valueText(a,i)}`,u=Le("g",{role:"option",tabindex:"-1","aria-label":c,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`},Le("title",{},c)),{sign:h,pattern:d}=l===null?n.word(a.reasons[i]):{};return h&&u.setAttribute("class",`what ${d}`),n.shown(i)||u.classList.add("out"),t.front?.includes(i)&&u.append(Le("circle",{r:o+3,class:"front"})),u.append(Le("circle",{r:o,class:l===null?"missing":"found",fill:l===null?"transparent":e.colour(l).face})),h&&u.append(Le("text",{"text-anchor":"middle",dy:"0.36em"},h)),t.best===i&&u.append(Le("text",{class:"best","text-anchor":"middle",dy:-o-6},t.bestWord)),u}function dP(n,t,e){let[i,s]=[q_(n.across.map(t.at)),q_(n.upwards.map(e.at))];return n.works.flatMap((r,o)=>r.map((a,l)=>Le("rect",{class:a?"map-works":"map-fails",x:i[o],width:i[o+1]-i[o],y:s[l+1],height:s[l]-s[l+1]})))}function q_(n){let t=n.slice(1).map((s,r)=>(s+n[r])/2),[e,i]=[n[0],n.at(-1)];return[e,...t,i]}function Y_(n,t,e,i){let s=(a,l)=>Le("path",{class:l,d:i?`M${a} ${e.from}V${e.to}`:`M${e.from} ${a}H${e.to}`}),r=a=>a>=Math.min(t.from,t.to)&&a<=Math.max(t.from,t.to),o=[];typeof n.own=="number"&&r(t.at(n.own))&&o.push(s(t.at(n.own),"own"));for(let{kind:a,bound:l}of n.limits??[]){let c=t.at(l);if(!r(c))continue;let u=a===">="?t.from:t.to,[h,d]=[Math.min(c,u),Math.abs(c-u)],f=i?{x:h,width:d,y:e.to,height:e.from-e.to}:{y:h,height:d,x:e.from,width:e.to-e.from};o.push(Le("rect",{class:"beyond",...f}),s(c,"limit"))}return o}function fP(n,t,e){let i=n.map(r=>t[r]).sort((r,o)=>r[0]-o[0]),s=([r,o])=>e==="least"?`H${r.toFixed(1)}V${o.toFixed(1)}`:`V${o.toFixed(1)}H${r.toFixed(1)}`;return Le("path",{class:"front",d:i.map((r,o)=>o?s(r):`M${r.join(" ")}`).join("")})}function pP(n,t,e,i){let s=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{s(r)&&i(Number(s(r).dataset.point))}),n.addEventListener("focusin",r=>{for(let o of t)o.setAttribute("tabindex",o===r.target?"0":"-1")}),n.addEventListener("keydown",r=>{let o=s(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")i(a);else if(r.key in X_)t[e[e.indexOf(a)+X_[r.key]]]?.focus();else return;r.preventDefault()})}function Z_(n,{plane:t,front:e,best:i,best_word:s,joined:r},o){let{quantities:a}=n.study,[l,c]=[t.x,t.y].map(n.indexOf),[u,h]=[l,c],d={quantity:a[0],x:l,y:c,current:i??0,opened:null,front:e,best:i,bestWord:s,ordered:!0},f=S("div",{className:"map-place"}),p=S("div",{className:"map-legend"}),_=()=>{let P=d.x===u&&d.y===h;d.cells=P?t.cells:void 0,d.joined=r&&new Set([d.x,d.y,u,h]).size===2;let N=sh(n,d,m);f.replaceChildren(N.element),p.replaceChildren(...mP(n,d))},m=P=>{g(P),o(P)};function g(P){d.current=d.opened=P;let N=f.contains(document.activeElement);_(),N&&f.querySelector(`[data-point="${P}"]`)?.focus()}let x=n.columns.map((P,N)=>[N,P.name]),b={across:v("across",x,()=>d.x,P=>E("x","y",P)),upwards:v("upwards",x,()=>d.y,P=>E("y","x",P)),show:v("show",a.map((P,N)=>[N,P.title]),()=>a.indexOf(d.quantity),P=>{d.quantity=a[P]})};function v(P,N,k,D){let V=S("select",{},...N.map(([W,ot])=>S("option",{value:String(W)},ot)));V.value=String(k()),V.addEventListener("change",()=>{D(Number(V.value)),A(),_()});let X=S("label",{},`${P} `,V);return X.dataset.name=P,{element:X,fill:()=>{V.value=String(k())}}}let A=()=>Object.values(b).forEach(P=>P.fill());function E(P,N,k){d[N]===k&&(d[N]=d[P]),d[P]=k}let y=()=>[d.y,d.x].map(P=>n.columns[P].name).join(" over "),w=$i(t.title,()=>Xn(y()),()=>er([f,p],y())),I=S("div",{className:"head"},S("h2",{},t.title),w),L=S("section",{className:"map"},I,S("div",{className:"choices"},...Object.values(b).map(P=>P.element)),f,p);return n.whenAsked(_),_(),{element:L,show:g,over(P,N){[d.x,d.y]=[P,N],A(),_()}}}function mP(n,{quantity:t,front:e,cells:i,x:s,y:r}){let o=Qu(n,t),a=t.values?t.reasons:n.study.verdicts,l=n.study.words.flatMap((u,h)=>{let d=a.filter((f,p)=>f===h&&n.shown(p)).length;return d?[S("li",{},Go(u),`${u.word} (${d})`)]:[]});e.length&&l.push(S("li",{},S("span",{className:"ring","aria-hidden":"true"}),"Pareto front"));let c=[s,r].map(u=>n.columns[u]);if(c.some(u=>typeof u.own=="number")&&l.push(S("li",{},S("span",{className:"dashes","aria-hidden":"true"}),"as designed")),c.some(u=>u.limits.length)&&l.push(S("li",{},S("span",{className:"shade","aria-hidden":"true"}),"beyond a limit")),i)for(let u of["works","fails"])l.push(S("li",{},S("span",{className:`map-${u}`,"aria-hidden":"true"}),`${u} if only these two deviate`));return l.length&&o.push(S("ul",{},...l)),o}var gP=2e4,xP=16,_P=16,K_={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Q_(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(x=>n.sizes[x]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=S("div",{className:"map-place"}),c=S("div",{className:"map-legend"}),u=S("p",{className:"note"}),h=()=>{let x=a.y===null&&a.quantity.values&&n.sizes.every((v,A)=>v===1||A===a.x),b=i||x?sh(n,a,d):bP(n,a,d);l.replaceChildren(b.element),c.replaceChildren(...wP(n,a.quantity,b.points)),u.textContent=AP(n,a.quantity,b.points)},d=x=>{a.current=a.opened=x,yP(l,x),t(x,a.quantity)},f=vP(n,a,s,h),_=$i("the map",()=>Xn(a.quantity.title),()=>er([l,c],ey(n,a).split(";")[0])),m=S("div",{className:"head"},S("h2",{},"Map"),_),g=S("section",{className:"map"},m,f.element,l,c,u);return h(),{element:g,show(x){a.current=a.opened=x,i||(a.fixed=n.placesOf(x)),f.fill(),h()}}}function yP(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function vP(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=S("div",{className:"choices"}),l=(h,d,f,p)=>{let _=S("select",{},...d.map(([m,g])=>S("option",{value:String(m)},g)));return _.value=String(f),_.addEventListener("change",()=>{p(Number(_.value)),u(),i(),[...a.querySelectorAll("label")].find(m=>m.dataset.name===h)?.querySelector("select").focus()}),S("label",{},`${h} `,_)},c=(h,d)=>f=>{t[d]===f&&(t[d]=t[h]),t[h]=f};function u(){let h=[l("show",r.map((d,f)=>[f,d.title]),r.indexOf(t.quantity),d=>{t.quantity=r[d]})];if(e.length>2){let d=e.map(f=>[f,s[f].name]);h.push(l("across",d,t.x,c("x","y")),l("upwards",d,t.y,c("y","x")))}for(let d of e.filter(f=>!o&&f!==t.x&&f!==t.y)){let f=s[d].texts.map((p,_)=>[_,s[d].unit?`${p} ${s[d].unit}`:p]);h.push(l(s[d].name,f,t.fixed[d],p=>{t.fixed[d]=p}))}for(let d of h)d.dataset.name=d.firstChild.textContent.trim();a.replaceChildren(...h)}return u(),{element:a,fill:u}}function bP(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>gP)return{element:S("p",{className:"note"},"This map has too many cells for a page; see the figures of the study."),points:[]};let o=n.scaleOf(t.quantity),a=s<=xP,l=(g,x)=>n.pointAt(t.fixed.map((b,v)=>v===t.x?g:v===t.y?x:b)),c=new Map,u=[],h=[];for(let g=r-1;g>=0;g--){let x=S("tr",{},S("th",{scope:"row"},t.y===null?"":j_(i[t.y],g)));for(let b=0;b<s;b++){let v=l(b,g),A=S("td",{tabIndex:-1,role:"gridcell"});SP(A,n,t,o,v,a),c.set(`${b} ${g}`,A),h.push(v),x.append(A)}u.push(x)}let d=i[t.x].texts.map((g,x)=>S("th",{scope:"col"},j_(i[t.x],x)));u.push(S("tr",{className:"feet"},S("td"),...d));let f=S("table",{role:"grid",className:a?"grid":"grid small","aria-label":ey(n,t)},S("tbody",{},...u));f.style.setProperty("--columns",s),f.style.setProperty("--rows",r);let p=[...c.values()].find(g=>Number(g.dataset.point)===t.current)??c.get("0 0");p.tabIndex=0,MP(f,c,e);let _=S("div",{className:"upwards"},t.y===null?"":J_(i[t.y])),m=S("div",{className:"across"},J_(i[t.x]));return{element:S("div",{className:r<6?"axes low":"axes"},_,S("div",{},S("div",{className:"scroll"},f),m)),points:h}}function SP(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:h,pattern:d}=t.word(o.reasons[s]);n.className=`what ${d}`,n.append(S("span",{},r?h:""));return}let{face:c,ink:u}=i.colour(a);n.style.background=c,n.style.color=u,n.textContent=r?i.text(a):""}function MP(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=K_[s.key]??[0,0],u=Math.max(...[...i.values()].map(([d])=>d)),h={Home:`0 ${a}`,End:`${u} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in K_)&&s.key!=="Home"&&s.key!=="End")return;t.has(h)&&(r.tabIndex=-1,t.get(h).tabIndex=0,t.get(h).focus())}s.preventDefault()})}function wP(n,t,e){let i=Qu(n,t),s=[...ty(t,e)].map(([r,o])=>{let a=n.word(r);return S("li",{},Go(a),`${a.word} (${o})`)});return s.length&&i.push(S("ul",{},...s)),i}function ty(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function AP(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...ty(t,e)].map(([c,u])=>`${u} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` Other points: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>EP(n,t,i,c));return`${r}, known for ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function EP(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function ey(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function J_(n){return n.unit?`${n.name} (${n.unit})`:n.name}function j_(n,t){let e=Math.ceil(n.texts.length/_P);return t%e?"":n.texts[t]}var ny=2,TP=20;function ry(n){let t=document.getElementById("live")?.textContent??null,e=t&&JSON.parse(t),i=S("div",{className:"answer"}),s=S("p",{className:"outcome",role:"status"}),r=S("div"),o=S("div"),a=null,l=!1,c=0,u=Promise.resolve(),h=0;function d(x,b){if(h+=1,c=x,!e)return[];if(!pu())return b?[]:[S("p",{className:"note"},`It cannot be simulated here either: ${e.refused}.`)];if(a)_(x);else if(!l){let v=S("button",{type:"button",className:"try"},b?"Try it and refine here":"Simulate it here"),A=S("p",{className:"note"});v.addEventListener("click",()=>f(v,A)),o.replaceChildren(S("div",{className:"offer"},v,A))}return[o]}async function f(x,b){l=x.disabled=!0,b.textContent="Starting the simulator …";try{a=await Po(ti(e.bench.clips[0]),e.bench,t,wo),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),_(c)}catch(v){b.textContent=`It cannot be simulated here: ${v.message}.`}}async function p(x,b){if(await u.catch(()=>null),b!==h)return null;u=a.engine.ask({act:"answer",values:x,search:e.search});let{answer:v}=await u;return b===h?v:null}async function _(x){let b=++h,v=S("button",{type:"button"},"Refine here");v.addEventListener("click",()=>g(x)),r.replaceChildren(),i.replaceChildren(s,...oy(n,e).length?[v]:[],r,a.element),s.textContent="Simulating …",a.sliders.set(e.points[x]);let A=await p(e.points[x],b);A&&(s.textContent=`${Oe(n.pointText(x))}: ${sy(e,A)}.`,m(x))}function m(x){a.sliders.set(e.points[x]),a.engine.send({act:"restart",through:!1})}async function g(x){let b=++h,v=RP(n,e,x),A=new Map,E=S("p",{className:"note",role:"status"}),y=v[1].values.map(N=>v[0].values.map(k=>CP(v,k,N))).reverse(),w=y.map((N,k)=>S("tr",{},S("th",{scope:"row"},iy(v[1],v[1].values.length-1-k)),...N.map(({cell:D})=>D))),I=S("tr",{className:"feet"},S("td"),...v[0].values.map((N,k)=>S("th",{scope:"col"},iy(v[0],k)))),L=S("table",{className:"grid"},S("caption",{},IP(v,n.study.sampled)),S("tbody",{},...w,I));r.replaceChildren(S("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},L),E);let P=y.flat();for(let[N,{cell:k,values:D,where:V}]of P.entries()){E.textContent=`${N} of ${P.length} points simulated`;let X=await p({...e.points[x],...D},b);if(!X)return;let{sign:W,pattern:ot}=n.study.words.find(({word:Z})=>Z===X.word)??n.study.other;k.className=`what ${ot}`,k.replaceChildren(S("span",{},W)),k.title=`${V}: ${sy(e,X)}`,k.setAttribute("aria-label",k.title),A.set(X.word,W)}E.textContent=[...A].map(([N,k])=>`${k} ${N}`).join(" · "),m(x)}return{offer:d,get panel(){return a}}}function CP(n,t,e){let i={[n[0].key]:t};n[1].key&&(i[n[1].key]=e);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Ee(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:S("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function oy(n,t){let e=i=>t.knobs.some(({key:s})=>s===n.study.factors[i].key);return n.study.axes.filter(i=>n.sizes[i]>1&&e(i))}function RP(n,t,e){let i=oy(n,t),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],u=t.knobs.find(m=>m.key===l);if(n.study.sampled)return{key:l,name:c,unit:u.unit,factor:u.factor,values:PP(t.points.map(m=>m[l]),e)};let h=n.placesOf(e),d=m=>t.points[n.pointAt(h.map((g,x)=>x===a?m:g))][l],[f,p]=[Math.max(0,h[a]-1),Math.min(n.sizes[a]-1,h[a]+1)],_=[];for(let m=f;m<p;m++)for(let g=0;g<ny;g++)_.push(d(m)+g/ny*(d(m+1)-d(m)));return{key:l,name:c,unit:u.unit,factor:u.factor,values:[..._,d(p)]}};return[o(r),o(s)]}function PP(n,t){let[e,i]=[Math.min(...n),Math.max(...n)],s=[-2,-1,0,1,2].map(r=>n[t]+r*(i-e)/TP);return[...new Set(s.map(r=>Math.min(i,Math.max(e,r))))].sort((r,o)=>r-o)}var iy=({key:n,factor:t,unit:e,values:i},s)=>n?`${Ee(t*i[s])} ${e}`:"";function IP([n,t],e){return`${t.key?`${Oe(n.name)} across, ${t.name} upwards`:Oe(n.name)}, ${e?"around it":"at half the steps"}`}function sy(n,{status:t,least:e}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>e[r]!==null&&e[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(u=>u.key===r);return`${a} ${Ee(l*e[o])} ${c}`});return[t,...s].join("; ")}function rh(n){let t=S("h2"),e=S("p",{className:"outcome",role:"status"}),i=S("table",{className:"numbers"}),s=S("section",{className:"facts",id:"point"},t,e,S("div",{className:"table"},i)),r=S("div",{className:"parts",role:"group","aria-label":`runs of this ${n.study.noun}`}),o=S("div"),a=S("div",{className:"more"}),l=S("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=S("section",{className:"run below","aria-label":"plots and numbers of the run that is open"}),u=ry(n),h={facts:s,element:l,below:c,point:null,playing:null,answers:u,open:p,show:g},d=null,f=Mr();function p(b,{play:v=!1,transition:A=null}={}){h.point=b;let E=n.runsOf(b);t.textContent=Oe(`${n.study.noun} ${b+1}`),e.textContent=`${Oe(n.pointText(b))}: ${n.study.statuses[b]}.`,i.replaceChildren(S("caption",{},"Values in the table"),S("tbody",{},...UP(n,b))),r.replaceChildren(...E.length>1?E.map(_):E.map(I=>S("b",{},Oe(I.title))));let y=A===null?null:E.find(I=>I.transition===A),w=v?E.find(I=>I.failed):null;E.length?g(y??w??E[0],{play:v}):(m(),o.replaceChildren(S("p",{className:"note"},FP(n,b))),c.replaceChildren()),a.replaceChildren(...n.study.built[b]?u.offer(b,E.length>0):[])}function _(b){let v=S("button",{type:"button"},b.title);return v.dataset.part=b.part,v.addEventListener("click",()=>g(b,{play:!0})),v}function m(){h.playing?.dispose(),h.playing=null}function g(b,{play:v=!1}={}){m();for(let P of r.querySelectorAll("button"))P.setAttribute("aria-pressed",String(P.dataset.part===b.part));let A=d&&d!==b?d:null,E=A?[A,b]:[b],y={player:S("div"),plots:S("div"),readouts:E.map(()=>S("div"))},[w,I]=[kP,BP].map(P=>E.map((N,k)=>P(N,ay(E,n)[k]))),L=b.advice?[S("p",{className:"note"},b.advice)]:[];o.replaceChildren(S("p",{},b.text),x(b),...L,y.player),c.replaceChildren(y.plots,...y.readouts,...w,...I),f.scale=n.largestSpan/b.play.clips[0].span_m,h.playing={run:b,beside:A,...LP(y,b,A,n,f)},Ro(c),v&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&h.playing.clock.play()}function x(b){let A=S("button",{type:"button",className:"pin"},d?`unpin ${n.study.noun} ${d.point+1}`:"pin to compare with another");return A.addEventListener("click",()=>{d=d?null:b,g(b),o.querySelector(".pin").focus()}),A}return h}function LP(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((f,p)=>DP(f,ay(r,i)[p],i)),a=r.map((f,p)=>({...ti(f.play.clips[0]),...e?{name:o[p]}:{}})),l=As(a,e?[OP(a)]:t.play.spans),c=r.map(f=>f.play.energy).reduce((f,p)=>p.largest_J>f.largest_J?p:f),u=e?`${Oe(a[0].name)} and ${a[1].name}, side by side with a common clock.`:t.play.text,h=Eo(n.player,a,l,{...t.play,energy:c,text:u},s);e&&Qf(h.stage.cells,a,l,c);let d=Vo(n.plots,e?NP(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[f,p]of a.entries())Co(n.readouts[f],p,l,c,f,e!==null);return{clips:a,clock:l,player:h,plots:d,dispose(){h.dispose(),d.dispose()}}}function NP(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function ay(n,{study:t}){if(n.length===1)return[""];let e=new Set(n.map(i=>i.point)).size<n.length;return n.map(i=>`${t.noun} ${i.point+1}${e?`, ${i.title}`:""}`)}function DP(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function OP(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function UP(n,t){return n.numbers.map(e=>S("tr",{},S("th",{scope:"row"},e.title),S("td",{},n.valueText(e,t))))}function FP(n,t){return n.study.built[t]?`This run was not kept, so it cannot be played here. ${n.study.keeps}`:n.study.unbuilt}function kP(n,t){let e=S("div");return e.innerHTML=n.numbers,S("details",{},S("summary",{},`States of ${t||"this run"}`),e)}function BP(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return S("details",{},S("summary",{},t?`Commands for ${t}`:"Commands"),S("p",{className:"note"},"In the folder of this page, these commands repeat the run and make a film of it:"),S("pre",{},S("code",{},e.join(`
`))))}function oh(n,t,e,i){let s=n?.querySelector("table");if(!s)return()=>{};let r=[...s.tBodies[0].rows],o=S("p",{className:"note",role:"status"}),a=zP(t,()=>{let u=a.shown(),h=0;for(let[d,f]of r.entries())f.hidden=!u.has(t.study.verdicts[d])||!t.shown(d),h+=f.hidden?0:1;o.textContent=`${h} of ${r.length} ${t.study.noun}s shown.`});for(let[u,h]of r.entries()){let d=S("button",{type:"button","aria-label":`open ${t.study.noun} ${u+1}`},h.cells[0].textContent);d.addEventListener("click",()=>i(u)),h.cells[0].replaceChildren(d)}let l=t.study.factors.length+1;for(let u of[s.tHead.rows[0],...r])u.cells[l].classList.add("words");GP(s,r,VP(t));let c=S("div",{className:"choices"},a.element,...e?[WP(e,t.study.file)]:[]);return s.closest(".table").before(c,o),a.changed(),a.changed}function zP(n,t){let e=new Map,i=n.study.words.flatMap((r,o)=>{if(!r.count)return[];let a=S("input",{type:"checkbox",checked:!0});return a.addEventListener("change",t),e.set(o,a),[S("label",{},a,Go(r),`${r.word} (${r.count})`)]});return{element:S("fieldset",{className:"filter"},S("legend",{},`Show ${n.study.noun}s that`),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function VP(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=n.numbers.map(r=>r.values);return[e,...i,t.statuses,...s]}function GP(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=S("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,u)=>u).sort((c,u)=>HP(e[s][c],e[s][u],a?-1:1)||c-u);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function HP(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function WP(n,t){let e=S("button",{type:"button",className:"button"},`Download ${t}`);return e.addEventListener("click",()=>{let i=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));S("a",{href:i,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(i),1e4)}),e}function ly(n){let t=th(n.study,n.runs),e=rh(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),op(e)},s=Q_(t,(a,l)=>i(a,l.transition)),r=n.runs.length?[[s.element,e.facts],[e.element]]:[[s.element],[e.facts,e.element]];document.getElementById("explorer").replaceChildren(S("div",{className:"explorer"},...r.map(a=>S("div",{},...a)),e.below)),oh(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=$P(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function $P(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,u)=>c!==a[u]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function op({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}function cy(n){let{views:t}=n,e=B_(n.study,n.runs),i=rh(e),s=[],r=(m,g)=>{i.open(m,{play:g});for(let x of s)x.show?.(m)},o=m=>{r(m,!0),op(i)},a=U_(e,t.lines,t,o),l=e.columns.filter(m=>m.aim).length===2,c=Z_(e,{...t,joined:l},o),u=t.pairs?.length?G_(e,t,h):null;s.push(a,c);function h(m,g){c.over(m,g),c.element.scrollIntoView({block:"start"})}let d=n.runs.length?[[c.element,i.facts],[i.element]]:[[c.element],[i.facts]],f=S("div",{className:"explorer"},...d.map(m=>S("div",{},...m)),i.below),p={lines:a.element,pairs:u?.element,plane:f};document.getElementById("explorer").replaceChildren(...t.order.map(m=>p[m]));let _=oh(document.getElementById("points"),e,n.csv,o);return e.whenAsked(_),n.study.points&&r(XP(e,n),!1),{model:e,panel:i,lines:a,plane:c,open:o}}function XP(n,{runs:t,views:e,study:i}){let{best:s}=e,r=t.map(o=>o.point);return s!==null&&r.includes(s)?s:r.find(o=>n.good(o))??r[0]??s??i.verdicts.findIndex((o,a)=>n.good(a)||a===i.points-1)}async function uy(n){let t=new Blob([sn(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((d,f)=>d*f,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let u=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),h=qP(u,...o);return a?Float32Array.from(h,(d,f)=>a[f%o[1]]+l[f%o[1]]*d):h}return i}function qP(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var YP="M7 4.5v15l12-7.5z",ZP="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",sr=180/Math.PI,ah=1,hy=10,dy=720;function my(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(p=>p*sr),o=QP(n),a=jP(n,s,r,o),l=S("button",{type:"button",className:"play"}),c=S("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let u=S("p",{className:"time"}),h=p=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,p))/sr))},d=()=>t.playing?t.pause():t.play(),f=a.map(({angle:p,name:_})=>{let m=S("button",{type:"button"},S("b",{},fy(p)),` ${_}`);return m.addEventListener("click",()=>h(p)),m});return c.addEventListener("input",()=>h(Number(c.value))),JP(c,()=>e(t.time)*sr,h,d),l.addEventListener("click",d),t.onChange(()=>{let p=e(t.time)*sr;c.value=p,u.textContent=`${fy(p,1)}${py(n,p)}`,c.setAttribute("aria-valuetext",`${qn(p,1)} degrees${py(n,p)}`);for(let[m,g]of a.entries())f[m].setAttribute("aria-pressed",String(Math.abs(g.angle-p)<.005));let _=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==_&&l.replaceChildren(fl(t.playing?ZP:YP)),l.setAttribute("aria-label",_)}),S("div",{className:"transport"},S("div",{className:"line"},l,KP(c,s,r,o,a)),S("div",{className:"choices"},u,S("div",{className:"states"},...f)))}function KP(n,t,e,i,s){let r=S("div",{className:"bands","aria-hidden":"true"}),o=S("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let u=S("span",{className:"band"});Object.assign(u.style,{left:a(l-t),width:a(c-l)}),r.append(u)}for(let{angle:l,stop:c}of s){let u=S("span",{className:c?"tick stop":"tick"});u.style.left=a(l-t),o.append(u)}return S("div",{className:"track"},r,n,o)}function JP(n,t,e,i){let s={ArrowLeft:-ah,ArrowDown:-ah,ArrowRight:ah,ArrowUp:ah},r={PageDown:-hy,PageUp:hy,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var fy=(n,t=null)=>`${t===null?qn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):qn(n,t)}°`;function jP(n,t,e,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*sr).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"folding stop",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"overbend stop":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function QP(n){let t=a=>gy(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*sr,n.highest*sr],s=(a,l)=>{let c=t(a);for(let u=0;u<40;u++){let h=(a+l)/2;t(h)===c?a=h:l=h}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=dy;a++){let[l,c]=[a-1,a].map(u=>e+(i-e)*u/dy);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function gy(n,t){let e=n.turn(n.anglesTogether(t/sr));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function py(n,t){let e=gy(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${qn(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${qn(1e3*s,1)} mm (${qn(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function xy(n){let t=S("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),S("label",{className:"slide"},"take apart ",t)}function _y(n,t,e){let i=n.map((s,r)=>{let o=S("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=S("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,S("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return S("fieldset",{className:"kinds"},S("legend",{},"show"),...i)}function ap(n,t,e){let i=S("select",{},...t.map((s,r)=>S("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),S("label",{},`${n} `,i)}var lh=28,yy=24;function vy(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new G(...r).applyMatrix4(Wo(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var t2=new ae,Wo=(n,t)=>t<0?t2:n[t];function lp(n,t,e,i,s){let r=new G(...n.axis).transformDirection(Wo(t,n.bodies[0])),o=new G(...n.up).transformDirection(Wo(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((x,b)=>new G(...x).applyMatrix4(Wo(t,n.bodies[b])).add(i)),c=l[1].clone().sub(l[0]),u=c.dot(r);c.addScaledVector(r,-u);let h=c.length(),d=h>1e-9?c.divideScalar(h):new G().crossVectors(r,o),f=new G().crossVectors(r,d).multiplyScalar(e),_=n.rest>Math.hypot(h,u)?Math.sqrt(n.rest**2-u**2):h,m=e2(s,_>1e-9?h/_:1);return{points:m.map(([x,b],v)=>l[0].clone().addScaledVector(d,x*_).addScaledVector(f,b*_).addScaledVector(r,u*v/(m.length-1))),wide:r,ends:l}})}function e2({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(d,f,p)=>n[(d*s+f)*2+p],c=(d,f)=>l(o,d,f)+a*(l(o+1,d,f)-l(o,d,f)),u=c(s-1,0),h=u>1e-6?e/u:1;return Array.from({length:s},(d,f)=>[h*c(f,0),c(f,1)])}function by(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,u)=>{let d=s[Math.min(u+1,s.length-1)].clone().sub(s[Math.max(u-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([f,p])=>c.clone().addScaledVector(a,f).addScaledVector(d,p))});My(i,l,[0,1,2,3]);for(let[c,u]of o.entries()){let h=new G(...n.across[c]).transformDirection(Wo(e,n.bodies[c]));i2(i,u,h,n.width,n.eye/2,n.peg/2)}}return i}function cp(n,t,e){let i=n.places.map(_=>new G(..._).add(e)),[s,r,o,a]=i,l=Wo(t,n.body),[c,u]=[o,a].map(_=>_.clone().sub(e).applyMatrix4(l).add(e)),h=r.clone().sub(s).normalize(),d=u.clone().sub(c).normalize(),f=r.distanceTo(o),p=[s];for(let _=0;_<=yy;_++)p.push(n2(r,h,c,d,f,_/yy));return[...p,u]}function n2(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function Sy(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new G().crossVectors(l,s);return Array.from({length:lh},(u,h)=>{let d=2*Math.PI*h/lh;return o.clone().addScaledVector(s,Math.cos(d)*t/2).addScaledVector(c,Math.sin(d)*t/2)})});return My(e,r,[]),e}function My({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function i2({triangles:n,edges:t},e,i,s,r,o){let a=new G(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new G().crossVectors(i,a),c=(u,h,d)=>e.clone().addScaledVector(i,d*s/2).addScaledVector(a,h*Math.cos(u)).addScaledVector(l,h*Math.sin(u));for(let u=0;u<lh;u++){let[h,d]=[u,u+1].map(p=>2*Math.PI*p/lh),f=(p,_,m,g)=>n.push(p,_,m,p,m,g);f(c(h,r,-1),c(d,r,-1),c(d,r,1),c(h,r,1));for(let p of[-1,1])f(c(h,o,p),c(d,o,p),c(d,r,p),c(h,r,p)),t.push(c(h,r,p),c(d,r,p))}}function wy(n,t){let e=t.map(({origin:a,axis:l})=>[new G(...a),new G(...l)]),i=n.map((a,l)=>t.flatMap((c,u)=>c.body===l?[u]:[])),s=n.map(()=>new ae),r=new ae,o=new G;return function(l){for(let[c,u]of n.entries()){let h=s[c];u<0?h.identity():h.copy(s[u]);for(let d of i[c]){let[f,p]=e[d];r.makeRotationAxis(p,l[d]-t[d].built),o.copy(f).applyMatrix4(r),r.setPosition(f.x-o.x,f.y-o.y,f.z-o.z),h.multiply(r)}}return s}}var s2=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),r2=new ae;function Ay(n,t){let e=n.parts.map(f=>({...f,...f.mesh?o2(f.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=wy(n.bodies,n.turns),r=Math.min(...n.joints.map(f=>f.lower)),o=Math.max(...n.joints.map(f=>f.upper)),a=new Float64Array(n.turns.length);function l(f){for(let[p,_]of n.turns.entries())a[p]=_.built;for(let p of n.joints)a[p.turn]=Math.min(p.upper,Math.max(p.lower,f));return a}let c=(f,p)=>new G(...f.apart).multiplyScalar(p);function u(f,p,_,m=new ae){let g=c(f,_);return m.copy(f.body===null||f.body<0?r2:p[f.body]).multiply(new ae().makeTranslation(g.x,g.y,g.z))}function h(f,p,{apart:_,side:m}){let g=c(f,_);return f.root?Sy(cp(f.root,p,g),f.root.diameter):by(f.strap,lp(f.strap,p,m,g,i),p)}function d(f,p,{apart:_,side:m}){let g=[];for(let x of f){if(x.outer){let A=u(x,p,_);for(let E of x.outer)g.push(...E.clone().applyMatrix4(A).toArray());continue}let b=c(x,_),v=x.root?[cp(x.root,p,b)]:lp(x.strap,p,m,b,i).map(A=>A.points);for(let A of v)for(let E=0;E<A.length;E+=4)g.push(...A[E].toArray())}return Float64Array.from(g)}return{parts:e,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:u,bentMesh:h,outline:d,straps:e.filter(f=>f.strap).map(f=>f.strap),strapStretches:vy}}function o2({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:a2(r)}}function a2(n){let t=new Set;for(let[e,i,s]of s2){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new G().fromArray(n,e))}function Ey(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=ts(e,a),u=Math.min(l+1,e.length-1);for(let h=0;h<s;h++){let d=i[l*s+h];r[h]=d+c*(i[u*s+h]-d)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var l2="#14171a",c2=.55,u2=Math.cos(Math.PI/9),h2=.42;function Ty(n,t,e,i){let s=n.parts.map(f=>d2(f,n.looks[f.look].colour,i)),r=new kn;for(let f of s)r.add(f.mesh,f.lines);let o=new kn,a=n.turn(n.anglesTogether(0));function l(f){a=n.turn(e(f));for(let[p,_]of n.parts.entries()){let{mesh:m,lines:g}=s[p],x=!t.hidden.has(_.look);for(let b of[m,g])b.visible=x;x&&(_.places?n.matrixOf(_,a,t.apart,m.matrix):m2(s[p],n.bentMesh(_,a,t)))}}function c(){let f=new Xt(be("--accent"));for(let[p,{mesh:_}]of s.entries())for(let m of[_.material].flat())m.emissive.copy(f),m.emissiveIntensity=t.chosen===p?h2:0}function u(f,p){let _=new Ia;_.setFromCamera(f,p),r.updateMatrixWorld(!0);for(let{mesh:g}of s)g.geometry.boundingSphere===null&&g.geometry.computeBoundingSphere();let[m]=_.intersectObjects(s.map(g=>g.mesh).filter(g=>g.visible),!1);return m?s.findIndex(g=>g.mesh===m.object):null}function h(f){let p=n.parts.findIndex(x=>x.name===f),{mesh:_}=s[p],m=_.geometry.getAttribute("position"),g=new an(m.array.slice(),3);return Array.from(g.applyMatrix4(_.matrix).array)}function d(){for(let{mesh:f,lines:p}of s){f.geometry.dispose(),p.geometry.dispose();for(let _ of[f.material,p.material].flat())_.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:u,verticesOf:h,dispose:d,current:()=>a}}function d2(n,t,e){let i=(u,h)=>new vs({color:u,side:Bn,flatShading:h,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?f2(n):new yn,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new Dn(s,r),a=new yn;n.places&&a.setAttribute("position",new an(Cy(n.places,n.edges),3));let l=new Ws({color:l2,transparent:!0,opacity:c2}),c=new mr(a,l);for(let u of[o,c])Object.assign(u,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function f2({places:n,corners:t,stops:e}){let i=new yn;return i.setAttribute("position",new an(Cy(n,t),3)),i.setAttribute("normal",new an(p2(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function Cy(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function p2(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,u,h]=[0,1,2].map(f=>3*t[3*l+f]),d=(f,p,_)=>n[p+_%3]-n[f+_%3];for(let f=0;f<3;f++)i[3*l+f]=d(c,u,f+1)*d(c,h,f+2)-d(c,u,f+2)*d(c,h,f+1);for(let f=0;f<3;f++)s[t[3*l+f]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),u=[0,0,0];for(let d of s[t[l]])if(d===c||a(c,d)>=u2*r[c]*r[d])for(let f=0;f<3;f++)u[f]+=i[3*d+f];let h=Math.hypot(...u)||1;for(let d=0;d<3;d++)o[3*l+d]=u[d]/h}return o}function m2({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new an(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var g2=.25,Ry=60,x2=4;async function Py(n){let t=await uy(n.arrays),e=Ay(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[_2(e,i),...n.motion?[y2(e,i,Ey(n.motion,t))]:[]],r=v2(s),o=document.getElementById("player"),a=S2(o,n,e,i,r),l=C2(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function _2(n,t){let e=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:Ry+1},(c,u)=>u/Ry),r=c=>n.anglesTogether(e(c)),o=Iy(n,t,{time:s,anglesAt:r,marks:[],stages:[]}),a=As([Ly(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(g2);let l=my(n,a,e,i);return{name:"all joints together",clip:o,clock:a,anglesAt:r,control:l}}function y2(n,t,e){let i=Iy(n,t,e),s=As([Ly(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:Eu([i],s)}}function Iy(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function Ly(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function v2(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var Ny="Press a part, or its name in the table, for details.",b2="parts";function S2(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,u=Ja([r],o,()=>l=Ty(e,i,s.anglesAt,t.stopColour),t.text),h=Tu(u.eye,null);h.prepend(wu(u,o,()=>"",()=>[]));let d=S("div",{className:"picture"},u.element,...u.note?[u.note]:[],h),f=S("p",{className:"chosen",role:"status"},Ny),p=S("div",{},a[0].control);return n.replaceChildren(d,f,p,M2(e,i,s,p),w2(e,i,s),A2(t,e,u),xu([r],b2)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the moving parts"),_u(n,[r],o,u.eye,Sr[0]),{stage:u,shape:l,info:f,repaint:()=>{l.paint(),o.seek(o.time)},onPress:_=>T2(u.canvas,m=>_(l.at(m,u.eye.camera)))}}function M2(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=ap("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=ap("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return S("div",{className:"choices"},...r.length>1?[o]:[],xy(l=>s({apart:l})),...n.straps.length?[a]:[])}function w2(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return _y(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function A2(n,t,e){let i=S("span",{className:"swatch taut","aria-hidden":"true"});return S("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[E2(n.stopColour,"face of a stop")]:[],...t.straps.length?[S("li",{},i,"on the slider: range of taut straps")]:[],S("li",{},`squares of the grid: ${Ee(1e3*Ya(e.eye.size))} mm`))}function E2(n,t){let e=S("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,S("li",{},e,t)}function T2(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>x2)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Zt(2*r-1,1-2*o))})}function C2(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[u]=l.querySelector("th").childNodes,h=S("button",{type:"button",className:"name","aria-pressed":"false"},u.textContent);return u.replaceWith(h),h.addEventListener("click",()=>o(e.chosen===c?null:c)),h});function o(l){e.chosen=l;for(let[c,u]of r.entries())u.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?Ny:a(l),i.repaint()}function a(l){let c=n.parts[l],[u,h,d]=c.facts,f=c.count>1?`${c.count} identical ones, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${u}, ${f}${h}, ${d}`}return{choose:o}}function Dy(n){let t=n.clips.map(ti),e=As(t,n.spans),i=Eo(document.getElementById("player"),t,e,n),s=n.curves?al(document.getElementById("curves"),n.curves,t,e):[],r=Vo(document.getElementById("plots"),n.plots,t,e);Co(document.getElementById("readout"),t[0],e,n.energy),Ju(document.getElementById("player"),e);let o=Cu(document.getElementById("try"),t[0],n,()=>e.pause());return{clips:t,clock:e,player:i,curves:s,plots:r,trial:o}}var Uy={"Content-Type":"application/json"},Oy=19e6;async function Pr(n,t,e){let i=JSON.stringify(t);if(i.length>Oy)return{refused:`need files of at most ${Oy/1e6} MB in all`};try{return await(await fetch(n,{method:"POST",headers:Uy,body:i,signal:e})).json()}catch(s){if(s.name==="AbortError")throw s;return{refused:ch}}}async function Fy(n,t,e,i){let s="",r={refused:ch};try{let a=(await fetch(n,{method:"POST",headers:Uy,body:JSON.stringify(t),signal:e})).body.pipeThrough(new TextDecoderStream).getReader();for(let l=await a.read();!l.done;l=await a.read()){let c=`${s}${l.value}`.split(`
`);s=c.pop();for(let u of c)r=JSON.parse(u),r.doing&&i(r.doing)}s&&(r=JSON.parse(s))}catch(o){if(o.name==="AbortError")throw o;return{refused:ch}}return r.doing?{refused:ch}:r}var ch="the workbench does not answer; is forficula open still running?";var up=`forficula ${location.pathname}`;function By(n){let t={asked:null,base:null,reply:null,rejected:new Map};t.open=async(r,o)=>{let a=r.files[0]?.name||r.design||"the design";n.says.wait(`Opening ${a}`);let l=await Pr("design",{...r,settings:{}}),c=l.refused??await e({...r,settings:o},l);return c?n.says.refuse(`${a} is not opened: ${c}`):t.rejected.clear(),t.reply&&s(t.reply),c};async function e(r,o){let a=performance.now(),l=new AbortController;n.says.wait("Building",()=>l.abort());try{let c=await Pr("design",r,l.signal);if(c.refused)return c.refused;let u=await Pr("model",r,l.signal);if(u.refused)return u.refused;Object.assign(t,{asked:r,base:o}),s(c),await n.model(u),n.says.done(`Built in ${((performance.now()-a)/1e3).toFixed(1)} s.`)}catch(c){if(c.name!=="AbortError")throw c;return"building was stopped"}return""}t.change=async(r,o)=>{let{asked:a,rejected:l}=t,c=[...l].filter(([f])=>f!==r).map(([f,p])=>[f,p.text]),u=i(a.settings,[[r,o]]),h=c.length?[i(a.settings,[...c,[r,o]]),u]:[u],d="";for(let f of h)if(d=ky(f,a.settings)?"":await e({...a,settings:f},t.base),!d){f===h[0]?l.clear():l.delete(r);break}d?(l.set(r,{text:o,why:d}),n.says.refuse(`${d} – the last working model is kept`)):ky(u,a.settings)&&n.says.done(""),s(t.reply)},t.slide=async r=>{let o=i(t.asked.settings,Object.entries(r)),a=await Pr("design",{...t.asked,settings:o});return a.refused?n.says.refuse(a.refused):(t.asked={...t.asked,settings:o},s(a))};function i(r,o){let a={...r};for(let[l,c]of o)c===""||c===t.base.keys.find(u=>u.key===l)?.value?delete a[l]:a[l]=c;return a}function s(r){t.reply=r,R2(t.asked),n.reply(t)}return t}var ky=(n,t)=>JSON.stringify(Object.entries(n).sort())===JSON.stringify(Object.entries(t).sort());function zy(){return JSON.parse(sessionStorage.getItem(up)??"null")}function R2(n){try{sessionStorage.setItem(up,JSON.stringify(n))}catch{sessionStorage.removeItem(up)}}function Vy(n){let t=S("textarea",{id:"file-text",className:"file",rows:24,spellcheck:!1,"aria-describedby":"file-note"}),e=S("button",{type:"button"},"Build this text"),s=S("div",{},S("label",{htmlFor:"file-text"},"The design file"),S("p",{className:"note",id:"file-note"},"Add or remove stages, tendons and whole sections here. The result counts as a new design file."),t,S("p",{className:"choices"},e));e.addEventListener("click",()=>n(t.value));let r="";return{element:s,show(o){o.text!==r&&(t.value=r=o.text)}}}function uh(n,t){let e="";for(let i of new TextEncoder().encode(n))e+=String.fromCharCode(i);return`data:${t};base64,${btoa(e)}`}var hp=40,P2=0;function Gy(n,t){let e=`key-${++P2}`,i=n.key.split(".").at(-1).replaceAll("_"," "),s=I2(n,e),r=S("button",{type:"button",className:"home",hidden:!0},"undo"),o=S("p",{className:"wrong",id:`${e}-wrong`}),a="",l=S("p",{className:"note",id:`${e}-notes`}),c=S("div",{className:"field"},S("label",{htmlFor:e,title:n.key},i),S("span",{className:"entry"},s,...L2(n,e),r),o,l);s.setAttribute("aria-describedby",`${e}-wrong ${e}-notes`),s.addEventListener("change",()=>{a=s.value.trim(),t(a)}),r.addEventListener("click",()=>{t(""),s.focus()}),r.setAttribute("aria-label",`undo the change of ${i}`);function u(d,f,p){(document.activeElement!==s||s.value.trim()===a)&&(s.value=f??d.value),a=s.value.trim(),h("");let _=f===void 0?null:p?.value||"left out";c.classList.toggle("changed",_!==null),r.hidden=_===null;let m=d.default&&d.default!=="needed"?`if left out ${d.default}`:"",x=[d.allowed,_===null?m:`was ${_}`,d.chosen&&`chosen: ${d.chosen}`].filter(Boolean).join(" · ").replaceAll(">=","≥").replaceAll("<=","≤");l.replaceChildren(Oe(d.meaning),S("span",{className:"may"},x))}function h(d,f){f!==void 0&&(s.value=a=f),o.textContent=d,c.classList.toggle("rejected",d!==""),d?(s.setAttribute("aria-invalid","true"),r.hidden=!1):s.removeAttribute("aria-invalid")}return{element:c,input:s,fact:n,show:u,reject:h}}function I2({key:n,value:t,words:e,onlyWords:i,default:s},r){if(i){let l=t?[]:[S("option",{value:""},s&&s!=="needed"?`left out: ${s}`:"left out")];return S("select",{id:r,"data-key":n},...l,...e.map(c=>S("option",{value:c},c)))}let o={id:r,spellcheck:!1,autocomplete:"off",autocapitalize:"off","data-key":n};if(t.length>hp)return S("textarea",{...o,rows:Math.min(6,Math.ceil(t.length/hp))});let a=S("input",{...o,type:"text"});return e.length&&a.setAttribute("list",`${r}-words`),a}function L2({words:n,onlyWords:t,value:e},i){return t||!n.length||e.length>hp?[]:[S("datalist",{id:`${i}-words`},...n.map(s=>S("option",{value:s})))]}var N2=["pattern","tendon"];function Hy(n){let t=S("input",{type:"search",id:"find-key",spellcheck:!1,placeholder:"stiffness, length, torque …"}),e=S("p",{className:"note",role:"status"}),i=S("div",{className:"sections"}),s=S("section",{className:"keys-of-design","aria-label":"keys of the design"},S("h2",{},"Keys"),S("label",{className:"find",htmlFor:"find-key"},"Find a key",t),e,i),r=new Map,o=[];t.addEventListener("input",a);function a(){let h=t.value.toLowerCase().split(/\s+/).filter(Boolean),d=0;for(let{fact:f,element:p}of r.values()){let _=`${f.key.replaceAll("_"," ")} ${f.key} ${f.meaning}`.toLowerCase();p.hidden=!h.every(m=>_.includes(m)),d+=p.hidden?0:1}for(let f of o){f.element.hidden=f.fields.every(p=>p.element.hidden);for(let{heading:p,fields:_}of f.parts)p.hidden=_.every(m=>m.element.hidden);h.length&&!f.element.hidden&&(f.element.open=!0)}e.textContent=h.length?`${d} of ${r.size} keys`:`${r.size} keys; enter values with units, as in a design file`}function l(h,d,f){let p=new Map(f.keys.map(_=>[_.key,_]));D2(h.keys,r)||c(h);for(let _ of h.keys)r.get(_.key).show(_,d[_.key],p.get(_.key));for(let _ of o)_.count(d);a()}function c(h){let d=new Set(o.length?o.filter(({element:_})=>_.open).map(({name:_})=>_):N2),f=document.activeElement?.dataset?.key;r=new Map(h.keys.map(_=>[_.key,Gy(_,m=>n(_.key,m))])),o=[...new Set(h.keys.map(({key:_})=>_.includes(".")?_.split(".")[0]:""))].sort((_,m)=>(m===""?-1:0)-(_===""?-1:0)).map(_=>O2(_,h,r));for(let _ of o)_.element.open=d.has(_.name);i.replaceChildren(...o.map(_=>_.element)),f&&r.get(f)?.input.focus()}function u(h,d,f){let p=r.get(h);if(p){p.reject(f,d);for(let _ of o)_.fields.includes(p)&&(_.element.open=!0)}}return{element:s,show:l,reject:u,field:h=>r.get(h)}}function D2(n,t){let e=[...t.keys()],i=(s,r)=>s.key===r&&s.onlyWords===t.get(r).fact.onlyWords;return n.length===e.length&&n.every((s,r)=>i(s,e[r]))}function O2(n,t,e){let i=t.keys.filter(({key:d})=>(d.includes(".")?d.split(".")[0]:"")===n),s=i.map(({key:d})=>e.get(d)),r=S("summary"),o=t.sections[n],a=[],l=[];for(let{key:d}of i){let f=d.split(".").slice(1,-1).join(".");if(f!==(a.at(-1)?.within??"")){let p=t.keys.find(m=>m.key===`${n}.${f}.name`)?.value,_=S("h3",{},`${n}.${f}${p?` · ${p}`:""}`);a.push({within:f,heading:_,fields:[]}),l.push(_)}a.at(-1)?.fields.push(e.get(d)),l.push(e.get(d).element)}let c=o?[S("p",{className:"note"},`${Oe(o).replace(/\.$/,"")}.`)]:[],u=S("details",{},r,...c,...l);function h(d){let f=i.filter(({key:p})=>p in d).length;r.replaceChildren(n?Oe(n):"Name",...f?[S("small",{},` ${f} changed`)]:[])}return{name:n,element:u,fields:s,parts:a.filter(({heading:d})=>d),count:h}}function Wy(n,t,e){let i=S("option",{value:""},t),s=n.filter(({name:f})=>f!==t).map(({name:f,shows:p})=>S("option",{value:f,title:p},f)),r=S("select",{id:"which-design"},i,...s),o=S("input",{type:"file",id:"which-files",multiple:!0,accept:".toml,.fold,.svg,.dxf",className:"spoken"}),a=S("input",{type:"text",id:"which-unit",placeholder:"1 cm",size:6,spellcheck:!1}),l="A design (.toml, with the files that it names), a FOLD file or a drawing (.svg, .dxf) can be dropped anywhere on the page.",c=S("label",{className:"button",htmlFor:"which-files"},"Open files …"),u=S("div",{className:"opening choices"},S("label",{htmlFor:"which-design"},"design ",r),S("span",{className:"choosing"},o,c),S("label",{htmlFor:"which-unit",title:"for a FOLD file or a drawing without a unit"},"unit of a drawing ",a),S("p",{className:"note"},l));r.addEventListener("change",()=>e({design:r.value,files:[],unit:""})),o.addEventListener("change",async()=>{o.files.length&&await d([...o.files]),o.value=""}),a.addEventListener("change",()=>{h&&e({design:"",files:h,unit:a.value.trim()})});let h=null;async function d(f){let p=await Promise.all(f.map(async _=>({name:_.name,text:await _.text()})));h=U2(p),await e({design:"",files:h,unit:a.value.trim()})}return F2(d),{element:u,show({design:f,files:p}){r.querySelector(".sent")?.remove(),p.length&&r.append(S("option",{value:p[0].name,className:"sent"},p[0].name)),r.value=p.length?p[0].name:f,h=p.length?p:null}}}function U2(n){let t=n.filter(({name:i})=>/\.toml$/i.test(i)),e=t.find(({name:i})=>!t.some(s=>s.name!==i&&s.text.includes(i)))??n[0];return[e,...n.filter(i=>i!==e)]}function F2(n){let{body:t}=document,e=i=>{i.dataTransfer?.types.includes("Files")&&(i.preventDefault(),t.classList.add("dropping"))};t.addEventListener("dragenter",e),t.addEventListener("dragover",e),t.addEventListener("dragleave",i=>{i.relatedTarget||t.classList.remove("dropping")}),t.addEventListener("drop",i=>{t.classList.remove("dropping"),i.dataTransfer?.files.length&&(i.preventDefault(),n([...i.dataTransfer.files]))})}function $y(n,{button:t,text:e,title:i},s){let r=S("button",{type:"button",className:"try"},t),o=S("button",{type:"button",hidden:!0},"Stop"),a=S("p",{className:"note",role:"status"},e),l=S("div"),c=S("div",{className:"results"},S("div",{className:"offer"},r,o,a),l),u=null,h=null;async function d(){if(h)return;let _=s(),m=performance.now();h=new AbortController,r.disabled=!0,o.hidden=!1,a.textContent="Starting …";let g=!1;try{let x=await Fy(n,_,h.signal,b=>a.textContent=`${b} …`);x.refused?a.textContent=`No result: ${x.refused}.`:f(x.done,_,(performance.now()-m)/1e3),g=!x.refused}catch{a.textContent="Stopped."}h=null,r.disabled=!1,o.hidden=!0,g&&p()}function f(_,m,g){u=JSON.stringify(m),a.textContent=`Done in ${g.toFixed(g<10?1:0)} s.`;let x=S("a",{href:_,target:"_blank",rel:"noopener"},"Open in a new window"),b=S("iframe",{src:_,title:i,sandbox:"allow-scripts allow-downloads"});l.replaceChildren(S("p",{},x),b)}function p(){u!==null&&!h&&u!==JSON.stringify(s())&&(a.textContent="This result belongs to the design before its last change.")}return r.addEventListener("click",d),o.addEventListener("click",()=>h?.abort()),{element:c,find:d,seen:p}}var k2=1500;function Xy(){let n=S("p",{role:"status"}),t=S("p",{className:"wrong",role:"alert"}),e=S("button",{type:"button",hidden:!0},"Stop building"),i=0,s=null;e.addEventListener("click",()=>s?.());function r(o,a=""){clearTimeout(i),e.hidden=!0,n.textContent=o,t.textContent=a}return{element:S("div",{className:"says"},n,e,t),wait(o,a){r(`${o} …`),s=a,a&&(i=setTimeout(()=>e.hidden=!1,k2))},done:o=>r(o),refuse:o=>r("",o.endsWith(".")?o:`${o}.`)}}function qy(){let n=S("a",{className:"button"},"Download the design"),t=S("code"),e=S("pre",{tabIndex:0,role:"group","aria-label":"the command that runs it"},t);return{element:S("div",{className:"taking"},n,e),show(i){n.href=uh(i.text,"application/toml"),n.download=`${i.name}.toml`,t.textContent=i.command}}}function Yy(n){let t=S("div"),e=null;async function i(){let s=n();if(!s)return;let r=JSON.stringify(s);if(r===e)return;e=r,t.querySelector("img")||t.replaceChildren(S("p",{className:"note",role:"status"},"Drawing …"));let o=await Pr("pattern",s);if(e!==r)return;if(o.refused){t.replaceChildren(S("p",{className:"note",role:"status"},`No pattern is drawn: ${o.refused}.`));return}let a=S("img",{src:`data:image/svg+xml;base64,${o.drawing}`,alt:o.said}),l=(u,h,d)=>S("a",{className:"button",download:h,href:d},u),c=uh(o.fold,"application/json");t.replaceChildren(S("figure",{className:"drawn"},a),S("p",{className:"choices"},l("Drawing as SVG","pattern.svg",a.src),l("Pattern as FOLD","pattern.fold",c)))}return{element:t,seen:i}}function Zy(n){let t={},e=0;function i(){if(clearTimeout(e),!Object.keys(t).length)return;let s=t;return t={},n(s)}return{put(s,r){t[s]=r,clearTimeout(e),e=setTimeout(i,250)},hand:i}}function Ky(n,t){let e=n.map(({name:o,title:a,element:l},c)=>{l.id=`view-${o}`,l.setAttribute("role","tabpanel"),l.setAttribute("aria-labelledby",`tab-${o}`);let u=S("button",{type:"button",id:`tab-${o}`,role:"tab","aria-controls":l.id},a);return u.addEventListener("click",()=>r(c)),u}),i=S("div",{className:"tabs",role:"tablist","aria-label":t},...e),s=0;function r(o){s=o;for(let[a,l]of e.entries())l.setAttribute("aria-selected",String(a===o)),l.tabIndex=a===o?0:-1,n[a].element.hidden=a!==o;n[o].seen?.()}return i.addEventListener("keydown",({key:o})=>{let a={ArrowRight:s+1,ArrowLeft:s-1,Home:0,End:e.length-1};o in a&&(r((a[o]+e.length)%e.length),e[s].focus())}),{element:S("div",{className:"views-of-bench"},i,...n.map(({element:o})=>o)),choose:o=>r(n.findIndex(a=>a.name===o)),name:(o,a)=>e[n.findIndex(l=>l.name===o)].textContent=a,seen:()=>n[s].seen?.()}}function jy(n,t){let e=S("div"),i={element:e,panel:null,refused:"",engine:null},s=null,r,o;function a(){i.panel?.leave(),s?.dispose(),i.panel=s=null}i.show=async({bench:u,live:h,warnings:d})=>{let f=ti(u.clips[0]);if(i.refused=h.refused??"",o=i.panel?.pace??o,!i.refused)try{let p=await Po(f,u,JSON.stringify(h),l,{look:r,pace:o,set:n});a(),e.replaceChildren(p.element,...Jy(d)),p.begin(),i.panel=p,r=p.stage?.eye.look;return}catch(p){i.engine?.end(),i.engine=null,i.refused=p.message}a(),c(f,u,d)};async function l(u,h){return i.engine?i.engine.take(u,h):(i.engine=await wo(u,h),i.engine)}function c(u,h,d){let f=S("p",{className:"note"},`The picture shows the start. A page cannot simulate this ${h.whole}: ${i.refused}. The package can:`),p=S("button",{type:"button"},"Run it");p.addEventListener("click",t);let _=S("div");e.replaceChildren(S("div",{className:"offer"},f,p),_,...Jy(d));let m=r??{...Mr(),following:!1},{stage:g}=To(_,[u],ju(u),{...h,text:`${h.shape}, at its start.`},m);_.setAttribute("aria-label",`the ${h.whole} at its start`),s=g,r=g?.eye.look??r}return i}function Jy(n){if(!n.length)return[];let t=e=>`${e.replace(/^[a-z](?=\S* )/,i=>i.toUpperCase()).replace(/\.$/,"")}.`;return[S("h2",{},"What to know"),S("ul",{className:"warnings"},...n.map(e=>S("li",{},t(e))))]}var B2={landscape:{button:"Compute it",text:"Statics computes the equilibria, the barriers between them, and the motion under the drives.",title:"landscape"},run:{button:"Run it",text:"The package simulates the protocol, checks the energy balance and reports the outcome.",title:"run"}};async function Qy(n){let t=Xy(),e=Promise.resolve(),i=p=>e=e.then(p).catch(_=>t.refuse(_.message)),s=By({says:t,reply:h,model:d}),r=Zy(p=>i(()=>s.slide(p))),o=p=>i(()=>s.open(p,{})),a=Wy(n.designs,n.opened,o),l=Hy((p,_)=>{r.hand(),i(()=>s.change(p,_))}),c=V2(s,r,o),u=qy();function h({asked:p,base:_,reply:m,rejected:g}){document.title=`${m.title}: workbench`,document.querySelector("h1").textContent=m.title,a.show(p),l.show(m,p.settings,_);for(let[x,{text:b,why:v}]of g)l.reject(x,b,v);c.file.show(m),u.show(m),c.tabs.seen()}async function d(p){await c.wing.show(p),c.tabs.name("wing",Oe(p.bench.whole))}let f=S("div",{className:"masthead"},a.element,u.element,t.element);return document.getElementById("workbench").append(f,l.element,c.tabs.element),c.tabs.choose("wing"),await i(()=>z2(s,n)),Object.assign(s,{wing:c.wing,idle:()=>e})}async function z2(n,t){let e=zy();e&&!await n.open({design:e.design,files:e.files,unit:e.unit},e.settings)||await n.open({design:"",files:[],unit:""},t.settings)}function V2(n,t,e){let i=()=>n.asked,s=Object.fromEntries(Object.entries(B2).map(([c,u])=>[c,$y(c,u,i)])),r=jy(t.put,()=>{l.choose("run"),s.run.find()}),o=Yy(i),a=Vy(c=>e({design:"",files:[{name:`${n.reply?.name??"design"}.toml`,text:c}],unit:""})),l=Ky([{name:"wing",title:"Structure",element:r.element},{name:"sheet",title:"Pattern",...o},{name:"landscape",title:"Landscape",...s.landscape},{name:"run",title:"Run",...s.run},{name:"file",title:"File",element:a.element}],"views of the design");return{tabs:l,wing:r,file:a}}var G2={run:Dy,compare:A_,curves:C_,study:ly,goals:cy,parts:Py,bench:W0,workbench:Qy},dp=JSON.parse(document.getElementById("data").textContent);Dp(dp.reading_units);function tv(n){let t=`Moving pictures cannot be shown in this browser (${n.message}); all numbers are below.`;throw document.querySelector("main").prepend(S("p",{className:"note",role:"alert"},t)),n}function ev(n){window.forficula=n}try{let n=G2[dp.kind](dp);n instanceof Promise?n.then(ev,tv):ev(n)}catch(n){tv(n)}Np();Ro();})();
